//! The functions at many states at once beside the functions at one state.

mod arms;
mod edges;
mod equality;
#[cfg(feature = "rayon")]
mod parallel;
mod references;
mod values;
