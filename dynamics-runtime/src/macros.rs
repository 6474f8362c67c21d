//! The way of the macro's tokens to the procedural macro.

/// Generates a struct with the equations of motion of a robot arm as its methods, from the arm's
/// Denavit-Hartenberg table. The crate `robot-dynamics` documents the table and the methods.
///
/// `file: "robots/puma560.toml"` stands in place of `convention` and `joints`: a path from the folder of the
/// crate's Cargo.toml on, to TOML in the macro's own words, to JSON, or to URDF, of which
/// `chain: ["base_link", "tool0"]` names the first and the last link, `ignore: [joint]` what is left out, and
/// `round_angles: 1e-4` how near an angle is to a quarter turn that is taken as one. Everything else may follow it,
/// or stand in a file of TOML. The feature `files` has the readers.
// `$crate` is this crate under whatever name and through whatever re-export the caller sees it, so
// that the generated code finds the runtime without a dependency of its own.
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
