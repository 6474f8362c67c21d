//! The functions at many states at once beside the functions at one state.

#[path = "../support/data.rs"]
mod data;
#[path = "../support/decimal.rs"]
mod decimal;
#[path = "../support/random.rs"]
mod random;

/// Tables as users write them, with the functions that come without asking.
macro_rules! every_function {
    ($($table:tt)*) => { robot_dynamics! { $($table)* } };
}

#[path = "../robots/industrial.rs"]
#[allow(dead_code, reason = "one of its robots is not needed here")]
mod industrial;

mod arms;
mod edges;
mod equality;
#[cfg(feature = "rayon")]
mod parallel;
mod references;
mod values;
