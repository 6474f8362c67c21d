//! Robots with every function.

/// `robot_dynamics!` for the given table, every function asked for by name.
#[macro_export]
macro_rules! every_function {
    ($($table:tt)*) => {
        $crate::each_function! { $crate::__robot_with { $($table)* } }
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
