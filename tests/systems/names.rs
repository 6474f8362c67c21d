//! Robots among names and preludes that are not the usual ones.

/// All functions where nothing is in scope that is not written.
#[no_implicit_prelude]
mod without_a_prelude {
    ::robots::every_function! {
        struct Arm { l: f64 }

        convention: standard,
        gravity: [0, -9.81, 0],
        joints: [
            a: revolute { a: l, mass: 1, com: [-0.1, 0, 0.2], inertia: rod(1) },
            b: prismatic { a: 1, alpha: 0.3, mass: 1, com: [0, 0.1, 0], friction: { coulomb: 1 } },
        ],
        tests: true,
    }

    #[test]
    fn all_functions_are_compared() {
        let report = ::robot_dynamics::check_against_rnea(&Arm { l: 0.7 });
        report.assert_ok();
        // The regressor and the base parameters as a product, B and C as one besides.
        let functions = ::dynamics_symbolic::Function::ALL.len();
        ::core::assert_eq!(report.functions.len(), functions - 2 + 1 + 1);
        ::core::assert!(report.not_compared.is_empty());
    }
}

/// Types, traits, modules and macros with the names of primitive types, and of what preludes have.
#[allow(
    non_camel_case_types,
    dead_code,
    unused_macros,
    reason = "the names are those of others, and nothing reads them"
)]
mod among_namesakes {
    macro_rules! namesakes {
        ($($kind:ident: $($name:ident)*;)*) => { $($(namesakes!(@$kind $name);)*)* };
        (@structs $name:ident) => { struct $name; };
        (@traits $name:ident) => {
            trait $name {
                fn none() {}
            }
        };
        (@modules $name:ident) => { mod $name {} };
        (@macros $name:ident) => {
            macro_rules! $name { ($d:tt) => { a macro of another kind }; }
        };
    }
    type f64 = ::core::primitive::f32;
    namesakes! {
        structs: f32 i8 i16 i32 i64 i128 isize u8 u16 u32 u64 u128 usize bool str char Option Some None
            Result Ok Err Vec Box String Scalar Table Row Evaluation;
        traits: Clone Copy Debug PartialEq Default From Into Iterator IntoIterator Fn FnMut FnOnce Send Sync
            Sized ToOwned ToString Drop AsRef Function Model MassMatrix Inputs;
        modules: core std alloc nalgebra functions robot_dynamics dynamics_runtime;
        macros: vec format assert assert_eq panic unimplemented unreachable include_bytes matches;
    }

    /// Methods that every type has, of names that generated code calls.
    trait Methods: ::core::marker::Sized {
        fn mul_add(self) {}
        fn rounded_once(self) {}
        fn sin_cos(self) {}
        fn at(self) {}
        fn field(self) {}
        fn map(self) {}
        fn set(self) {}
        fn table(self) {}
    }
    impl<T> Methods for T {}

    ::robots::every_function! {
        pub(super) struct Arm { pub(super) l: f64 }

        convention: modified,
        gravity: [0, -9.81, 0],
        joints: [
            a: revolute {
                a: l, mass: 1, com: [-0.1, 0, 0.2], inertia: rod(1),
                friction: { viscous: 0.1, coulomb: 0.2 },
            },
            b: prismatic { a: 1, alpha: 0.3, mass: 1, com: [0, 0.1, 0], spring: { stiffness: l, rest: 0 } },
        ],
        tests: true,
    }
}

#[test]
fn all_functions_are_compared_among_namesakes() {
    let report = robot_dynamics::check_against_rnea(&among_namesakes::Arm { l: 0.7 });
    report.assert_ok();
    assert!(report.not_compared.is_empty());
}

/// Constants and statics with the names of generated arguments and variables.
#[allow(
    non_upper_case_globals,
    dead_code,
    reason = "the names are those of variables, and nothing reads them"
)]
mod among_constants {
    const q: f64 = 1.0;
    const qd: f64 = 1.0;
    static qdd: f64 = 1.0;
    static tau: f64 = 1.0;
    const order: f64 = 1.0;
    const state: f64 = 1.0;
    const sines: f64 = 1.0;
    static real: f64 = 1.0;
    const x: f64 = 1.0;
    const term: f64 = 1.0;
    static forces: f64 = 1.0;
    static pair: u8 = 1;
    static products: u8 = 1;
    const squares: u8 = 1;
    const column: u8 = 1;
    const columns: u8 = 1;
    const robot: u8 = 1;
    const i: usize = 1;
    const j: usize = 1;
    const value: u8 = 1;
    const pi: f64 = 3.0;
    const pose: u8 = 1;
    static elbow: u8 = 1;
    const solutions: u8 = 1;
    const index: u8 = 1;
    const l: f64 = 1.0;
    const off: f64 = 1.0;
    const t_1: f64 = 1.0;
    const s_1: f64 = 1.0;
    static c_1: f64 = 1.0;
    const q_1: f64 = 1.0;
    const sa_1: f64 = 1.0;
    static sign_2: f64 = 1.0;
    const p_l: f64 = 1.0;
    const joint_1: u8 = 1;
    static is_singular: bool = true;
    const qd_r: u8 = 1;

    robots::every_function! {
        struct Arm { l: f64, off: f64 }

        convention: modified,
        gravity: [0, -9.81, 0],
        joints: [
            a: revolute { a: l, alpha: off + PI/2, mass: 1, com: [-0.1, 0, 0.2], inertia: rod(1) },
            b: revolute { a: 1, alpha: off, mass: 1, com: [0, 0.1, 0], friction: { coulomb: 1 } },
        ],
        tests: true,
    }

    robot_dynamics::robot_dynamics! {
        struct Seven;
        convention: standard,
        gravity: [0, 0, -9.81],
        joints: [
            a: revolute { alpha: -PI/2 },
            b: revolute { alpha: PI/2 },
            c: revolute { d: 0.4, alpha: PI/2 },
            d: revolute { alpha: -PI/2 },
            e: revolute { d: 0.4, alpha: -PI/2 },
            f: revolute { alpha: PI/2 },
            g: revolute {},
        ],
        functions: [forward_kinematics, inverse_kinematics],
    }

    #[test]
    fn closed_forms_pass_too() {
        let positions = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7].into();
        let there = Seven.forward_kinematics(&positions);
        assert_eq!(Seven.inverse_kinematics(&there, 0.1).len(), 8);
    }

    #[test]
    fn a_robot_in_a_function_passes_too() {
        const qd: f64 = 1.0;
        robot_dynamics::robot_dynamics! {
            struct Local { l: f64 }
            convention: modified,
            gravity: [0, -9.81, 0],
            joints: [a: revolute { a: 1, mass: 1, com: [l, 0, 0] }],
        }
        robot_dynamics::check_against_rnea(&Local { l: 0.5 }).assert_ok();
        assert_eq!(qd, q);
    }
}
