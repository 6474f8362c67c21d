//! Robots whose cells are fields, so that no constant of theirs is rounded: the programs in
//! extended precision have the values of the references.

use robot_dynamics::robot_dynamics;

use crate::{GenericChain3, Puma560, Stanford};

/// The robot of fields with the doubles of a table: of each row, which cell each field has.
macro_rules! of_table {
    ($robot:ident of $table:ident: $($row:literal { $($field:ident: $cell:ident $([$entry:literal])?),* })* $($other:ident: $value:expr),*) => {
        impl $robot {
            /// With the doubles of the table.
            pub fn of_table() -> Self {
                let rows = $table.table().rows;
                $robot { $($($field: rows[$row].$cell $([$entry])?,)*)* $($other: $value),* }
            }
        }
    };
}

robot_dynamics! {
    /// The PUMA 560, every number a field.
    pub struct Puma560Fields {
        d1: f64, iyy1: f64, rotor1: f64, gear1: f64, viscous1: f64, coulomb1: f64, a2: f64, m2: f64, x2: f64, y2: f64, z2: f64, ixx2: f64, iyy2: f64, izz2: f64, rotor2: f64, gear2: f64, viscous2: f64, coulomb2: f64, a3: f64, d3: f64, m3: f64, x3: f64, y3: f64, z3: f64, ixx3: f64, iyy3: f64, izz3: f64, rotor3: f64, gear3: f64, viscous3: f64, coulomb3: f64, d4: f64, m4: f64, y4: f64, ixx4: f64, iyy4: f64, izz4: f64, rotor4: f64, gear4: f64, viscous4: f64, coulomb4: f64, m5: f64, ixx5: f64, iyy5: f64, izz5: f64, rotor5: f64, gear5: f64, viscous5: f64, coulomb5: f64, m6: f64, z6: f64, ixx6: f64, iyy6: f64, izz6: f64, rotor6: f64, gear6: f64, viscous6: f64, coulomb6: f64, g: f64,
    }

    convention: standard,
    gravity: [0, 0, -g],
    joints: [
        joint1: revolute { alpha: PI/2, d: d1, inertia: { yy: iyy1 }, motor: { inertia: rotor1, gear_ratio: gear1 }, friction: { viscous: viscous1, coulomb: coulomb1 } },
        joint2: revolute { a: a2, mass: m2, com: [x2, y2, z2], inertia: { xx: ixx2, yy: iyy2, zz: izz2 }, motor: { inertia: rotor2, gear_ratio: gear2 }, friction: { viscous: viscous2, coulomb: coulomb2 } },
        joint3: revolute { a: a3, alpha: -PI/2, d: d3, mass: m3, com: [x3, y3, z3], inertia: { xx: ixx3, yy: iyy3, zz: izz3 }, motor: { inertia: rotor3, gear_ratio: gear3 }, friction: { viscous: viscous3, coulomb: coulomb3 } },
        joint4: revolute { alpha: PI/2, d: d4, mass: m4, com: [0, y4, 0], inertia: { xx: ixx4, yy: iyy4, zz: izz4 }, motor: { inertia: rotor4, gear_ratio: gear4 }, friction: { viscous: viscous4, coulomb: coulomb4 } },
        joint5: revolute { alpha: -PI/2, mass: m5, inertia: { xx: ixx5, yy: iyy5, zz: izz5 }, motor: { inertia: rotor5, gear_ratio: gear5 }, friction: { viscous: viscous5, coulomb: coulomb5 } },
        joint6: revolute { mass: m6, com: [0, 0, z6], inertia: { xx: ixx6, yy: iyy6, zz: izz6 }, motor: { inertia: rotor6, gear_ratio: gear6 }, friction: { viscous: viscous6, coulomb: coulomb6 } },
    ],
}

of_table! {
    Puma560Fields of Puma560:
    0 { d1: d, iyy1: inertia [1], rotor1: motor_inertia, gear1: gear_ratio, viscous1: viscous, coulomb1: coulomb [0] }
    1 { a2: a, m2: mass, x2: com [0], y2: com [1], z2: com [2], ixx2: inertia [0], iyy2: inertia [1], izz2: inertia [2], rotor2: motor_inertia, gear2: gear_ratio, viscous2: viscous, coulomb2: coulomb [0] }
    2 { a3: a, d3: d, m3: mass, x3: com [0], y3: com [1], z3: com [2], ixx3: inertia [0], iyy3: inertia [1], izz3: inertia [2], rotor3: motor_inertia, gear3: gear_ratio, viscous3: viscous, coulomb3: coulomb [0] }
    3 { d4: d, m4: mass, y4: com [1], ixx4: inertia [0], iyy4: inertia [1], izz4: inertia [2], rotor4: motor_inertia, gear4: gear_ratio, viscous4: viscous, coulomb4: coulomb [0] }
    4 { m5: mass, ixx5: inertia [0], iyy5: inertia [1], izz5: inertia [2], rotor5: motor_inertia, gear5: gear_ratio, viscous5: viscous, coulomb5: coulomb [0] }
    5 { m6: mass, z6: com [2], ixx6: inertia [0], iyy6: inertia [1], izz6: inertia [2], rotor6: motor_inertia, gear6: gear_ratio, viscous6: viscous, coulomb6: coulomb [0] }
    g: 9.81
}

robot_dynamics! {
    /// The Stanford arm, every number a field.
    pub struct StanfordFields {
        d1: f64, m1: f64, y1: f64, z1: f64, ixx1: f64, iyy1: f64, izz1: f64, rotor1: f64, gear1: f64, d2: f64, m2: f64, y2: f64, ixx2: f64, iyy2: f64, izz2: f64, rotor2: f64, gear2: f64, a3: f64, m3: f64, z3: f64, ixx3: f64, iyy3: f64, izz3: f64, rotor3: f64, gear3: f64, m4: f64, y4: f64, z4: f64, ixx4: f64, iyy4: f64, izz4: f64, rotor4: f64, gear4: f64, m5: f64, y5: f64, z5: f64, ixx5: f64, iyy5: f64, rotor5: f64, gear5: f64, m6: f64, z6: f64, ixx6: f64, iyy6: f64, izz6: f64, rotor6: f64, gear6: f64, g: f64,
    }

    convention: standard,
    gravity: [0, 0, -g],
    joints: [
        joint1: revolute { alpha: -PI/2, d: d1, mass: m1, com: [0, y1, z1], inertia: { xx: ixx1, yy: iyy1, zz: izz1 }, motor: { inertia: rotor1, gear_ratio: gear1 } },
        joint2: revolute { alpha: PI/2, d: d2, mass: m2, com: [0, y2, 0], inertia: { xx: ixx2, yy: iyy2, zz: izz2 }, motor: { inertia: rotor2, gear_ratio: gear2 } },
        joint3: prismatic { a: a3, theta: -PI/2, mass: m3, com: [0, 0, z3], inertia: { xx: ixx3, yy: iyy3, zz: izz3 }, motor: { inertia: rotor3, gear_ratio: gear3 } },
        joint4: revolute { alpha: -PI/2, mass: m4, com: [0, y4, z4], inertia: { xx: ixx4, yy: iyy4, zz: izz4 }, motor: { inertia: rotor4, gear_ratio: gear4 } },
        joint5: revolute { alpha: PI/2, mass: m5, com: [0, y5, z5], inertia: { xx: ixx5, yy: iyy5 }, motor: { inertia: rotor5, gear_ratio: gear5 } },
        joint6: revolute { mass: m6, com: [0, 0, z6], inertia: { xx: ixx6, yy: iyy6, zz: izz6 }, motor: { inertia: rotor6, gear_ratio: gear6 } },
    ],
}

of_table! {
    StanfordFields of Stanford:
    0 { d1: d, m1: mass, y1: com [1], z1: com [2], ixx1: inertia [0], iyy1: inertia [1], izz1: inertia [2], rotor1: motor_inertia, gear1: gear_ratio }
    1 { d2: d, m2: mass, y2: com [1], ixx2: inertia [0], iyy2: inertia [1], izz2: inertia [2], rotor2: motor_inertia, gear2: gear_ratio }
    2 { a3: a, m3: mass, z3: com [2], ixx3: inertia [0], iyy3: inertia [1], izz3: inertia [2], rotor3: motor_inertia, gear3: gear_ratio }
    3 { m4: mass, y4: com [1], z4: com [2], ixx4: inertia [0], iyy4: inertia [1], izz4: inertia [2], rotor4: motor_inertia, gear4: gear_ratio }
    4 { m5: mass, y5: com [1], z5: com [2], ixx5: inertia [0], iyy5: inertia [1], rotor5: motor_inertia, gear5: gear_ratio }
    5 { m6: mass, z6: com [2], ixx6: inertia [0], iyy6: inertia [1], izz6: inertia [2], rotor6: motor_inertia, gear6: gear_ratio }
    g: 9.81
}

robot_dynamics! {
    /// Three revolute joints at any angles, every number a field.
    pub struct GenericChain3Fields {
        a1: f64, alpha1: f64, d1: f64, theta1: f64, m1: f64, x1: f64, y1: f64, z1: f64, ixx1: f64, iyy1: f64, izz1: f64, ixy1: f64, iyz1: f64, ixz1: f64, a2: f64, alpha2: f64, d2: f64, theta2: f64, m2: f64, x2: f64, y2: f64, z2: f64, ixx2: f64, iyy2: f64, izz2: f64, ixy2: f64, iyz2: f64, ixz2: f64, a3: f64, alpha3: f64, d3: f64, theta3: f64, m3: f64, x3: f64, y3: f64, z3: f64, ixx3: f64, iyy3: f64, izz3: f64, ixy3: f64, iyz3: f64, ixz3: f64, g: f64,
    }

    convention: standard,
    gravity: [0, 0, -g],
    joints: [
        joint1: revolute { a: a1, alpha: alpha1, d: d1, theta: theta1, mass: m1, com: [x1, y1, z1], inertia: { xx: ixx1, yy: iyy1, zz: izz1, xy: ixy1, yz: iyz1, xz: ixz1 } },
        joint2: revolute { a: a2, alpha: alpha2, d: d2, theta: theta2, mass: m2, com: [x2, y2, z2], inertia: { xx: ixx2, yy: iyy2, zz: izz2, xy: ixy2, yz: iyz2, xz: ixz2 } },
        joint3: revolute { a: a3, alpha: alpha3, d: d3, theta: theta3, mass: m3, com: [x3, y3, z3], inertia: { xx: ixx3, yy: iyy3, zz: izz3, xy: ixy3, yz: iyz3, xz: ixz3 } },
    ],
}

of_table! {
    GenericChain3Fields of GenericChain3:
    0 { a1: a, alpha1: alpha, d1: d, theta1: theta, m1: mass, x1: com [0], y1: com [1], z1: com [2], ixx1: inertia [0], iyy1: inertia [1], izz1: inertia [2], ixy1: inertia [3], iyz1: inertia [4], ixz1: inertia [5] }
    1 { a2: a, alpha2: alpha, d2: d, theta2: theta, m2: mass, x2: com [0], y2: com [1], z2: com [2], ixx2: inertia [0], iyy2: inertia [1], izz2: inertia [2], ixy2: inertia [3], iyz2: inertia [4], ixz2: inertia [5] }
    2 { a3: a, alpha3: alpha, d3: d, theta3: theta, m3: mass, x3: com [0], y3: com [1], z3: com [2], ixx3: inertia [0], iyy3: inertia [1], izz3: inertia [2], ixy3: inertia [3], iyz3: inertia [4], ixz3: inertia [5] }
    g: 9.81
}
