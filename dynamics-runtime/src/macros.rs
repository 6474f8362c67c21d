//! Macros that generated code and its call need.

/// Generates a struct with the equations of motion of a robot arm as its methods, from the arm's Denavit-Hartenberg table.
///
/// It is the macro of the crate `robot-dynamics`, which documents it, for who depends on this crate alone.
#[cfg(feature = "macro")]
#[macro_export]
macro_rules! robot_dynamics {
    ($($tokens:tt)*) => {
        $crate::__private::expand! { @[$crate] $($tokens)* }
    };
}

/// Hands on the items of generated code that need the standard library.
#[cfg(feature = "std")]
#[doc(hidden)]
#[macro_export]
macro_rules! __with_std {
    ($($items:tt)*) => { $($items)* };
}

/// Leaves out the items of generated code that need the standard library.
#[cfg(not(feature = "std"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __with_std {
    ($($items:tt)*) => {};
}

/// Hands on the items of generated code that need all cores.
#[cfg(feature = "rayon")]
#[doc(hidden)]
#[macro_export]
macro_rules! __with_rayon {
    ($($items:tt)*) => { $($items)* };
}

/// Leaves out the items of generated code that need all cores.
#[cfg(not(feature = "rayon"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __with_rayon {
    ($($items:tt)*) => {};
}
