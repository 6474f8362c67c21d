//! The way of the macro's tokens to the procedural macro.

#[doc = include_str!("robot_dynamics.md")]
// `$crate` is this crate under whatever name and through whatever re-export the caller sees it, so
// that the generated code finds the runtime without a dependency of its own.
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
