//! Robots with every function.

/// `robot_dynamics!` for the given table, every function asked for by name.
#[macro_export]
macro_rules! every_function {
    ($($table:tt)*) => {
        $crate::each_function! { $crate::__robot_with { $($table)* } }
    };
}

/// As [`every_function!`], for a long arm: without the functions that have as many values as the cube of the number of
/// joints, which would be most of what is compiled.
#[macro_export]
macro_rules! every_function_of_a_long_arm {
    ($($table:tt)*) => {
        $crate::each_function_of_long_arms! { $crate::__robot_with { $($table)* } }
    };
}

/// As [`every_function!`], and some of them together, each tuple as one program.
#[macro_export]
macro_rules! every_function_and_tuples {
    ($($table:tt)*) => {
        $crate::each_function! { $crate::__robot_with_tuples { $($table)* } }
    };
}

/// The robot of a table with the functions of a list, and tuples of them.
#[doc(hidden)]
#[macro_export]
macro_rules! __robot_with_tuples {
    ({ $($table:tt)* } $($name:ident $arguments:tt)*) => {
        ::robot_dynamics::robot_dynamics! {
            $($table)*
            functions: [
                $($name,)*
                control_terms = (mass_matrix, coriolis_vector, gravity_vector),
                linearised = (inverse_dynamics, inverse_dynamics_derivatives),
                motion = (forward_dynamics, kinetic_energy, forward_kinematics),
            ],
        }
    };
}

/// The robot of a table with the functions of a list.
#[doc(hidden)]
#[macro_export]
macro_rules! __robot_with {
    ({ $($table:tt)* } $($name:ident $arguments:tt)*) => {
        ::robot_dynamics::robot_dynamics! { $($table)* functions: [$($name),*], }
    };
}
