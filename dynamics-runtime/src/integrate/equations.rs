//! The equations of the motion that a method of integration follows.

use super::Phase;
use crate::size::Size;

/// Equations of motion q'' = a(t, q, q').
pub(crate) trait Equations<D: Size> {
    /// Why there is no acceleration.
    type Refusal;

    /// The acceleration at a time in a phase.
    fn acceleration(&self, t: f64, phase: &Phase<D>) -> Result<D::Vector, Self::Refusal>;

    /// How the phase moves.
    #[inline]
    fn rate(&self, t: f64, phase: &Phase<D>) -> Result<Phase<D>, Self::Refusal> {
        Ok(phase.rate(self.acceleration(t, phase)?))
    }
}

impl<F: Fn(f64, &Phase<D>) -> Result<D::Vector, E>, E, D: Size> Equations<D> for F {
    type Refusal = E;

    #[inline]
    fn acceleration(&self, t: f64, phase: &Phase<D>) -> Result<D::Vector, E> {
        self(t, phase)
    }
}
