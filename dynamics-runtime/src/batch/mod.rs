//! Generated functions at many states at once, in the lanes of vector registers.
//!
//! The program of a function is generic over its numbers; here it runs on `wide::Wide`, as many numbers as the
//! processor's vectors hold. The loop over the states is compiled once for each instruction set, with the program in it.

mod abreast;
mod arguments;
mod arms;
mod error;
mod layout;
#[cfg(feature = "rayon")]
mod parallel;
mod run;
#[cfg(test)]
mod tests;
mod wide;

use fearless_simd::Level;

use crate::function::{Function, functions};
use arms::Arms;
pub use arms::Fields;
pub use error::{BatchError, LengthMismatch};
use layout::{Sink, Source};
pub use layout::{States, StatesMut};
#[cfg(feature = "rayon")]
pub use parallel::on_all_cores;
use run::{Failure, Task};
pub use wide::Precision;

dynamics_items::batch_methods! {
/// The generated functions at many states at once, each under its name with `_batch` behind it.
///
/// Every robot whose table generates a function has its batch: `use robot_dynamics::Batch`. Methods that are not called
/// are not compiled.
///
/// The states of a batch are evaluated in the lanes of vector registers, as wide as the processor at hand has them
/// (AVX-512, AVX2 with FMA, SSE2; NEON; WebAssembly's). On one core this takes half to a fifth of the time of single
/// calls: vectors of eight doubles take a quarter for inverse and forward dynamics (`cargo bench -p benches --bench
/// batch`). Numbers are `f64`, or `f32` in twice as many lanes. Taylor series and base parameters are evaluated state by
/// state. With the feature `rayon` each method has a twin, with `par_` before its name, that uses all cores.
///
/// The values are those of the single function to the last few units in the last place of the largest terms: sums of
/// products are fused where the processor can. They do not depend on other states, nor on their number. Values beside a
/// state that has none, or beside an angle beyond 1e5 rad (1e4 rad in `f32`), differ by as little.
///
/// Arguments come as a vector for each state or as a column for each joint, which takes less time: see [`States`] and
/// [`StatesMut`]. Any number of states will do, none included; arguments of different lengths are an error, and nothing
/// is written. No method panics, and none allocates but those of all cores, a few bytes for each core.
///
/// ```
/// use robot_dynamics::nalgebra::{SVector, Vector1};
/// use robot_dynamics::{Batch, GravityVector, Scalar};
///
/// struct Pendulum;
///
/// impl GravityVector<1> for Pendulum {
///     fn gravity_vector<T: Scalar>(&self, q: &SVector<T, 1>) -> SVector<T, 1> {
///         let (sine, _) = q[0].sin_cos();
///         Vector1::new(sine * q[0].constant(9.81))
///     }
/// }
///
/// let q = [0.0, 0.5, 1.0].map(Vector1::new);
/// let mut torques = [Vector1::zeros(); 3];
/// Pendulum.gravity_vector_batch(&q, &mut torques)?;
/// assert!((torques[1][0] - 9.81 * 0.5_f64.sin()).abs() < 1e-15);
///
/// // The same by columns.
/// let mut column = [0.0; 3];
/// Pendulum.gravity_vector_batch([&[0.0, 0.5, 1.0][..]], [&mut column[..]])?;
/// assert_eq!(column[1], torques[1][0]);
/// # Ok::<(), robot_dynamics::batch::LengthMismatch>(())
/// ```
pub trait Batch {
    /// A batch in which every state has an arm of its own: `arms` has a struct for each state, which differ in
    /// their fields. Masses that are estimated, tools that are tried out, gravity on a slope.
    ///
    /// It has the methods of this trait, and the batches that stand beside the methods of the struct: functions at frames,
    /// several functions as one, all functions of a robot whose base moves. An instance is
    /// `Batch::with_parameters(&arms).gravity_vector_batch(&q, &mut tau)`. They take the time of one arm's and that of
    /// reading the fields.
    fn with_parameters(arms: &[Self]) -> Self::OfEach<'_>
    where
        Self: Fields,
    {
        arms.into()
    }
}
}

impl<R> Batch for R {}

/// A batch in which every state has an arm of its own, with fields of its own: see
/// [`Batch::with_parameters`], and [`Batch`] for the methods. Another number of arms than of states is an error
/// about the argument `parameters`.
#[derive(Debug)]
pub struct WithParameters<'a, R>(&'a [R]);

impl<R> Clone for WithParameters<'_, R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<R> Copy for WithParameters<'_, R> {}

impl<'a, R> From<&'a [R]> for WithParameters<'a, R> {
    fn from(arms: &'a [R]) -> Self {
        WithParameters(arms)
    }
}

dynamics_items::batch_methods! {
impl<R> WithParameters<'_, R> {}
}

/// A function at every state, on this core.
///
/// # Errors
///
/// Where lengths differ.
#[doc(hidden)]
#[inline(always)]
pub fn on_one_core<F, R, E, B, A, O, const N: usize>(
    function: F,
    arms: B,
    arguments: A,
    mut results: O,
) -> Result<Failure, LengthMismatch>
where
    F: Copy,
    R: Function<F, N>,
    E: Precision,
    B: Arms<R>,
    A: Source<R::Arguments, E>,
    O: Sink<R::Values, E>,
{
    let mut task = Task::<R, E, _, _, _, _, N>::new(function, arms, &arguments, &mut results)?;
    Ok(task.run(Level::new()))
}

/// The first state without a value as an error.
///
/// # Errors
///
/// Where there is one, or lengths differ.
#[doc(hidden)]
pub fn failing(done: Result<Failure, LengthMismatch>) -> Result<(), BatchError> {
    match done? {
        None => Ok(()),
        Some((state, error)) => Err(BatchError::Singular { state, error }),
    }
}
