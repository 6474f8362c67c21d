//! The other side of the mistakes: calls in unusual surroundings, which compile without a warning.

#![deny(warnings, clippy::derive_partial_eq_without_eq)]
#![allow(unreachable_pub)]

mod fragments;

use robot_dynamics::robot_dynamics;

/// Hands its attributes on, as the macros of many crates do.
macro_rules! pendulum {
    (
        $(#[$of_struct:meta])* $name:ident {
            $(#[$of_field:meta])* $length:ident
        }
        $(#[$of_joint:meta])* $joint:ident
    ) => {
        robot_dynamics! {
            $(#[$of_struct])*
            pub struct $name {
                $(#[$of_field])*
                pub $length: f64,
            }
            convention: standard,
            gravity: [0, -9.81, 0],
            joints: [
                $(#[$of_joint])*
                $joint: revolute { mass: 1, com: [$length, 0, 0] },
            ],
            functions: [mass_matrix],
        }
    };
}

pendulum! {
    /// A derive of its own.
    #[derive(Clone, Debug)]
    #[must_use]
    Forwarded {
        /// Its length, m.
        length
    }
    /// The only joint.
    pivot
}

pendulum! {
    #[cfg(any())]
    SwitchedOff { length } pivot
}

#[test]
fn attributes_that_a_macro_hands_on_are_read() {
    let pendulum = Forwarded { length: 2.0 }.clone();
    let mass = pendulum.mass_matrix(&robot_dynamics::nalgebra::SVector::<f64, 1>::zeros());
    assert_eq!(mass[(0, 0)], 4.0);
    assert_eq!(format!("{pendulum:?}"), "Forwarded { length: 2.0 }");
}

/// Structs whose names differ in case alone, each with a generated test.
mod tested {
    use robot_dynamics::robot_dynamics;

    robot_dynamics! {
        pub struct TwoLink;
        convention: standard,
        gravity: [0, -9.81, 0],
        joints: [pivot: revolute { mass: 1, com: [1, 0, 0] }],
        tests: true,
    }

    robot_dynamics! {
        #[allow(non_camel_case_types)]
        pub struct two_link { length: f64 }
        convention: standard,
        gravity: [0, -9.81, 0],
        joints: [pivot: revolute { mass: 1, com: [length, 0, 0] }],
        tests: true,
    }
}

#[test]
fn tests_may_be_asked_for_in_a_function_body() {
    robot_dynamics! {
        struct TwoLink { length: f64 }
        convention: standard,
        gravity: [0, -9.81, 0],
        joints: [pivot: revolute { mass: 1, com: [length, 0, 0] }],
        tests: true,
    }
    let pendulum = TwoLink { length: 2.0 };
    robot_dynamics::check_against_rnea(&pendulum).assert_ok();
}

robot_dynamics! {
    #[deprecated]
    pub struct Deprecated {
        #[deprecated]
        length: f64,
    }
    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [pivot: revolute { mass: 1, com: [length, 0, 0] }],
    tests: true,
}

robot_dynamics! {
    #[cfg_attr(all(), derive(Clone, Debug))]
    #[cfg_attr(all(), cfg(all()), doc = "Derives and `cfg` under a condition.")]
    pub struct Conditional;
    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [pivot: revolute { mass: 1, com: [1, 0, 0] }],
    functions: [mass_matrix],
}

robot_dynamics! {
    #[cfg_attr(all(), cfg(any()))]
    pub struct ConditionallyOff;
    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [pivot: revolute { mass: 1, com: [1, 0, 0] }],
    functions: [mass_matrix],
}
