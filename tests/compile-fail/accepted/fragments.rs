//! A value that another macro hands on is one operand wherever it stands, whatever kind of fragment it
//! is: the parentheses around it need not be written.

use robot_dynamics::robot_dynamics;

/// Defines a macro for each kind of fragment, whose argument stands wherever a value may, and one that
/// hands its argument on to that one.
macro_rules! arms {
    ($d:tt $($kind:ident $macro:ident $handing_on:ident,)*) => {$(
        macro_rules! $macro {
            ($d visibility:vis $d name:ident $d abbreviated:ident, $d x:$kind) => {
                robot_dynamics! {
                    $d visibility struct $d name { $d visibility length: f64 }
                    convention: standard,
                    let size = 3;
                    let twice = $d x * 2;
                    gravity: [$d x * 2, 1 - $d x, -4.905 * $d x],
                    joints: [
                        first: revolute {
                            a: $d x * 2,
                            alpha: deg($d x * 2),
                            d: 12 - $d x,
                            theta: 2 * -$d x,
                            mass: 12 * $d x,
                            com: [2 * $d x, $d x * 2, ($d x * 2)],
                            inertia: rod($d x * 2),
                            motor: { inertia: $d x * 2, gear_ratio: 12 / $d x },
                            friction: { viscous: $d x * 2, coulomb: 2 * $d x },
                            limits: [-2 * $d x, $d x * 2],
                        },
                        second: prismatic {
                            a: twice,
                            d: length * $d x,
                            mass: $d x / 2,
                            inertia: {
                                xx: 50 * $d x, yy: $d x * 50, zz: 50 * $d x,
                                xy: 2 * $d x, yz: $d x * 2, xz: 2 - $d x,
                            },
                        },
                        third: revolute { mass: 1, inertia: cuboid(2 * $d x, $d x * 2, 7 - $d x) },
                        fourth: revolute { mass: 1, inertia: cylinder(2 * $d x, $d x * 2) },
                        fifth: revolute { mass: 1, inertia: sphere(2 * $d x) },
                    ],
                    lock: [fifth = $d x * 2],
                    functions: [potential_energy],
                }

                robot_dynamics! {
                    $d visibility struct $d abbreviated;
                    convention: standard,
                    gravity: [0, -9.81, 0],
                    let size = 3;
                    joints: [
                        one: revolute { a: 1, mass: 1, com: [0, 0, 0.01] },
                        two: revolute { a: $d x, mass: size, com: [-1, 0.01, 0] },
                    ],
                    neglect: $d x / 100,
                    functions: [mass_matrix, gravity_vector],
                }
            };
        }

        macro_rules! $handing_on {
            ($d visibility:vis $d name:ident $d abbreviated:ident, $d x:$kind) => {
                $macro!($d visibility $d name $d abbreviated, $d x);
            };
        }
    )*};
}

arms! {
    $
    expr by_expr expr_handed_on,
    literal by_literal literal_handed_on,
    ident by_ident ident_handed_on,
    tt by_tt tt_handed_on,
    path by_path path_handed_on,
    ty by_ty ty_handed_on,
}

by_tt!(WrittenOut WrittenOutToo, (1 + 2));
by_expr!(pub Expr ExprToo, 1 + 2);
expr_handed_on!(pub(crate) ExprAgain ExprAgainToo, 1 + 2);
by_literal!(Literal LiteralToo, 3);
literal_handed_on!(LiteralAgain LiteralAgainToo, 3);
by_ident!(pub Ident IdentToo, size);
ident_handed_on!(IdentAgain IdentAgainToo, size);
tt_handed_on!(TtAgain TtAgainToo, (1 + 2));
by_path!(pub(super) Path PathToo, size);
path_handed_on!(PathAgain PathAgainToo, size);
by_ty!(Ty TyToo, size);
ty_handed_on!(TyAgain TyAgainToo, size);

#[test]
fn every_kind_of_fragment_is_one_operand() {
    let length = 0.7;
    let expected = WrittenOut { length }.table();
    macro_rules! compare {
        ($($name:ident $abbreviated:ident,)*) => {$(
            assert_eq!($name { length }.table(), expected, stringify!($name));
            assert_eq!($name::OPERATIONS, WrittenOut::OPERATIONS);
            assert_eq!($abbreviated.table(), WrittenOutToo.table());
            assert_eq!($abbreviated::OPERATIONS, WrittenOutToo::OPERATIONS);
        )*};
    }
    compare! {
        Expr ExprToo,
        ExprAgain ExprAgainToo,
        Literal LiteralToo,
        LiteralAgain LiteralAgainToo,
        Ident IdentToo,
        IdentAgain IdentAgainToo,
        TtAgain TtAgainToo,
        Path PathToo,
        PathAgain PathAgainToo,
        Ty TyToo,
        TyAgain TyAgainToo,
    }
    assert_eq!(expected.rows[0].mass, 36.0);
    assert_eq!(expected.rows[0].com, [6.0; 3]);
}
