//! The motions that methods of integration follow.

use nalgebra::SVector;

use super::Phase;

/// Equations of motion q'' = a(t, q, q').
pub(crate) trait Equations<const N: usize> {
    /// Why there is no acceleration.
    type Refusal;

    /// The acceleration at a time in a phase.
    fn acceleration(&self, t: f64, phase: &Phase<N>) -> Result<SVector<f64, N>, Self::Refusal>;

    /// The rate of change of the phase.
    #[inline]
    fn rate(&self, t: f64, phase: &Phase<N>) -> Result<Phase<N>, Self::Refusal> {
        Ok(phase.rate(self.acceleration(t, phase)?))
    }
}

impl<F: Fn(f64, &Phase<N>) -> Result<SVector<f64, N>, E>, E, const N: usize> Equations<N> for F {
    type Refusal = E;

    #[inline]
    fn acceleration(&self, t: f64, phase: &Phase<N>) -> Result<SVector<f64, N>, E> {
        self(t, phase)
    }
}
