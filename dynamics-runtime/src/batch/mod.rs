//! Generated functions at many states at once, in the lanes of vector registers.
//!
//! The program of a function is generic over its numbers; here it runs on [`wide::Wide`], as many
//! doubles as the processor's vectors hold. Which those are is asked at run time: the loop over the
//! states is compiled once for each instruction set, with the program inlined into it.

mod abreast;
mod error;
mod function;
mod layout;
#[cfg(feature = "rayon")]
mod parallel;
mod run;
#[cfg(test)]
mod tests;
mod unrolled;
mod wide;

use fearless_simd::Level;

use crate::{CoriolisVector, ForwardDynamics, GravityVector, InverseDynamics, MassMatrix};
pub use error::{BatchError, LengthMismatch};
use function::{Function, G, M, Qdd, Tau, V};
use layout::Sink;
pub use layout::{States, StatesMut};
use run::{Arguments, Failure, run, states};

/// The generated functions at many states at once.
///
/// Every robot whose table generates a function has its batch: `use robot_dynamics::Batch`.
///
/// The states of a batch are evaluated in the lanes of vector registers, as wide as the processor
/// at hand has them (AVX-512, AVX2 with FMA, SSE2; NEON; WebAssembly's), which is asked at run time.
/// On one core this takes half to a fifth of the time of single calls: vectors of eight doubles
/// take a quarter for inverse and forward dynamics (`cargo bench -p benches --bench batch`). With the feature `rayon` each method has a twin, with `par_`
/// before its name, that uses all cores.
///
/// The values are those of the single function to the last few units in the last place of the
/// largest terms: sums of products are fused where the processor can, whatever the build allows. A
/// state's values do not depend on the other states, nor on their number, but for accelerations
/// beside a state that has none, which differ by as little.
///
/// Arguments come as a vector for each state or as a column for each joint: see [`States`] and
/// [`StatesMut`]. Any number of states will do, none included; arguments of different lengths are
/// an error, and nothing is written. No method panics, and none allocates.
///
/// ```
/// use dynamics_runtime::nalgebra::{SVector, Vector1};
/// use dynamics_runtime::{Batch, GravityVector, Scalar};
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
/// # Ok::<(), dynamics_runtime::LengthMismatch>(())
/// ```
pub trait Batch {
    /// Mass matrix M(q) at every state, kg m^2, kg m or kg.
    ///
    /// `q` in rad or m.
    ///
    /// # Errors
    ///
    /// [`LengthMismatch`] where an argument is not as long as `q`.
    fn mass_matrix_batch<const N: usize>(
        &self,
        q: impl States<N>,
        mass_matrix: impl StatesMut<N, N>,
    ) -> Result<(), LengthMismatch>
    where
        Self: MassMatrix<N> + Sized,
    {
        each::<M, _, _, _, N, 1, N>(self, (q.source(),), mass_matrix.sink())?;
        Ok(())
    }

    /// Coriolis and centrifugal vector V(q, qd) at every state, N m or N.
    ///
    /// `q` in rad or m, `qd` per second.
    ///
    /// # Errors
    ///
    /// [`LengthMismatch`] where an argument is not as long as `q`.
    fn coriolis_vector_batch<const N: usize>(
        &self,
        q: impl States<N>,
        qd: impl States<N>,
        coriolis_vector: impl StatesMut<N>,
    ) -> Result<(), LengthMismatch>
    where
        Self: CoriolisVector<N> + Sized,
    {
        each::<V, _, _, _, N, 2, 1>(self, (q.source(), qd.source()), coriolis_vector.sink())?;
        Ok(())
    }

    /// Gravity vector G(q) = dU/dq at every state, N m or N.
    ///
    /// `q` in rad or m.
    ///
    /// # Errors
    ///
    /// [`LengthMismatch`] where an argument is not as long as `q`.
    fn gravity_vector_batch<const N: usize>(
        &self,
        q: impl States<N>,
        gravity_vector: impl StatesMut<N>,
    ) -> Result<(), LengthMismatch>
    where
        Self: GravityVector<N> + Sized,
    {
        each::<G, _, _, _, N, 1, 1>(self, (q.source(),), gravity_vector.sink())?;
        Ok(())
    }

    /// Inverse dynamics tau = M qdd + V + G + K + F at every state, N m or N.
    ///
    /// `q` in rad or m, `qd` per second, `qdd` per second squared.
    ///
    /// # Errors
    ///
    /// [`LengthMismatch`] where an argument is not as long as `q`.
    fn inverse_dynamics_batch<const N: usize>(
        &self,
        q: impl States<N>,
        qd: impl States<N>,
        qdd: impl States<N>,
        tau: impl StatesMut<N>,
    ) -> Result<(), LengthMismatch>
    where
        Self: InverseDynamics<N> + Sized,
    {
        each::<Tau, _, _, _, N, 3, 1>(self, (q.source(), qd.source(), qdd.source()), tau.sink())?;
        Ok(())
    }

    /// Forward dynamics qdd with M qdd + V + G + K + F = tau at every state, rad/s^2 or m/s^2.
    ///
    /// `q` in rad or m, `qd` per second, `tau` in N m or N.
    ///
    /// # Errors
    ///
    /// [`BatchError::Length`] where an argument is not as long as `q`;
    /// [`BatchError::Singular`] where a mass matrix is not positive definite: the first such state
    /// with what `forward_dynamics` says of it. All states' accelerations are written then too; they
    /// are NaN where there are none.
    fn forward_dynamics_batch<const N: usize>(
        &self,
        q: impl States<N>,
        qd: impl States<N>,
        tau: impl States<N>,
        qdd: impl StatesMut<N>,
    ) -> Result<(), BatchError>
    where
        Self: ForwardDynamics<N> + Sized,
    {
        let failure = each::<Qdd, _, _, _, N, 3, 1>(
            self,
            (q.source(), qd.source(), tau.source()),
            qdd.sink(),
        )?;
        accelerations(failure)
    }

    /// [`mass_matrix_batch`](Batch::mass_matrix_batch) on all cores, by rayon's global thread pool.
    ///
    /// Worth it from some thousand states on; a batch below 1,024 states stays on this core.
    ///
    /// # Errors
    ///
    /// As there.
    #[cfg(feature = "rayon")]
    fn par_mass_matrix_batch<const N: usize>(
        &self,
        q: impl States<N>,
        mass_matrix: impl StatesMut<N, N>,
    ) -> Result<(), LengthMismatch>
    where
        Self: MassMatrix<N> + Sync + Sized,
    {
        parallel::each::<M, _, _, _, N, 1, N>(self, (q.source(),), mass_matrix.sink())?;
        Ok(())
    }

    /// [`coriolis_vector_batch`](Batch::coriolis_vector_batch) on all cores, by rayon's global thread pool.
    ///
    /// Worth it from some thousand states on; a batch below 1,024 states stays on this core.
    ///
    /// # Errors
    ///
    /// As there.
    #[cfg(feature = "rayon")]
    fn par_coriolis_vector_batch<const N: usize>(
        &self,
        q: impl States<N>,
        qd: impl States<N>,
        coriolis_vector: impl StatesMut<N>,
    ) -> Result<(), LengthMismatch>
    where
        Self: CoriolisVector<N> + Sync + Sized,
    {
        parallel::each::<V, _, _, _, N, 2, 1>(
            self,
            (q.source(), qd.source()),
            coriolis_vector.sink(),
        )?;
        Ok(())
    }

    /// [`gravity_vector_batch`](Batch::gravity_vector_batch) on all cores, by rayon's global thread pool.
    ///
    /// Worth it from some thousand states on; a batch below 1,024 states stays on this core.
    ///
    /// # Errors
    ///
    /// As there.
    #[cfg(feature = "rayon")]
    fn par_gravity_vector_batch<const N: usize>(
        &self,
        q: impl States<N>,
        gravity_vector: impl StatesMut<N>,
    ) -> Result<(), LengthMismatch>
    where
        Self: GravityVector<N> + Sync + Sized,
    {
        parallel::each::<G, _, _, _, N, 1, 1>(self, (q.source(),), gravity_vector.sink())?;
        Ok(())
    }

    /// [`inverse_dynamics_batch`](Batch::inverse_dynamics_batch) on all cores, by rayon's global thread pool.
    ///
    /// Worth it from some thousand states on; a batch below 1,024 states stays on this core.
    ///
    /// # Errors
    ///
    /// As there.
    #[cfg(feature = "rayon")]
    fn par_inverse_dynamics_batch<const N: usize>(
        &self,
        q: impl States<N>,
        qd: impl States<N>,
        qdd: impl States<N>,
        tau: impl StatesMut<N>,
    ) -> Result<(), LengthMismatch>
    where
        Self: InverseDynamics<N> + Sync + Sized,
    {
        parallel::each::<Tau, _, _, _, N, 3, 1>(
            self,
            (q.source(), qd.source(), qdd.source()),
            tau.sink(),
        )?;
        Ok(())
    }

    /// [`forward_dynamics_batch`](Batch::forward_dynamics_batch) on all cores, by rayon's global thread pool.
    ///
    /// Worth it from some thousand states on; a batch below 1,024 states stays on this core.
    ///
    /// # Errors
    ///
    /// As there.
    #[cfg(feature = "rayon")]
    fn par_forward_dynamics_batch<const N: usize>(
        &self,
        q: impl States<N>,
        qd: impl States<N>,
        tau: impl States<N>,
        qdd: impl StatesMut<N>,
    ) -> Result<(), BatchError>
    where
        Self: ForwardDynamics<N> + Sync + Sized,
    {
        let failure = parallel::each::<Qdd, _, _, _, N, 3, 1>(
            self,
            (q.source(), qd.source(), tau.source()),
            qdd.sink(),
        )?;
        accelerations(failure)
    }
}

impl<R> Batch for R {}

/// A function at every state, on this core.
fn each<F, R, A, O, const N: usize, const K: usize, const C: usize>(
    robot: &R,
    arguments: A,
    results: O,
) -> Result<Failure, LengthMismatch>
where
    F: Function<R, N, K, C>,
    A: Arguments<N, K>,
    O: Sink<N, C>,
{
    let states = states::<F, R, N, K, C>(&arguments, &results)?;
    Ok(run::<F, R, A, O, N, K, C>(
        Level::new(),
        robot,
        arguments,
        results,
        states,
    ))
}

fn accelerations(failure: Failure) -> Result<(), BatchError> {
    match failure {
        None => Ok(()),
        Some((state, error)) => Err(BatchError::Singular { state, error }),
    }
}
