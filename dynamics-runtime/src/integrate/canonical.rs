//! Equations of motion in positions and momenta.

use nalgebra::SVector;

#[cfg(test)]
use super::Equations;
use super::{Phase, first_non_finite};

/// Hamilton's equations, with the forces that have no potential: q' and p' as functions of t, q, p.
pub(crate) trait Canonical<const N: usize> {
    /// Why there is no rate.
    type Refusal;

    /// The momenta p of a phase.
    fn momentum(&self, phase: &Phase<N>) -> Result<SVector<f64, N>, Self::Refusal>;

    /// The phase of positions and momenta.
    fn phase(&self, at: &Point<N>) -> Result<Phase<N>, Self::Refusal>;

    /// q' and p'.
    fn rate(&self, t: f64, at: &Point<N>) -> Result<Point<N>, Self::Refusal>;
}

/// Positions and momenta; or a rate of change of both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Point<const N: usize> {
    pub(crate) q: SVector<f64, N>,
    pub(crate) p: SVector<f64, N>,
}

impl<const N: usize> Point<N> {
    pub(super) fn zeros() -> Self {
        Point {
            q: SVector::zeros(),
            p: SVector::zeros(),
        }
    }

    /// The joint of the first entry that is not finite.
    pub(crate) fn first_non_finite(&self) -> Option<usize> {
        first_non_finite(&self.q).or_else(|| first_non_finite(&self.p))
    }

    /// `self + factor * other`.
    #[inline(always)]
    pub(super) fn plus(&self, factor: f64, other: &Self) -> Self {
        Point {
            q: self.q + other.q * factor,
            p: self.p + other.p * factor,
        }
    }
}

/// Equations of motion with velocities for momenta: Hamilton's only where the mass matrix does not depend on q.
#[cfg(test)]
pub(crate) struct InVelocities<'a, S>(pub(crate) &'a S);

#[cfg(test)]
impl<S: Equations<N>, const N: usize> Canonical<N> for InVelocities<'_, S> {
    type Refusal = S::Refusal;

    fn momentum(&self, phase: &Phase<N>) -> Result<SVector<f64, N>, S::Refusal> {
        Ok(phase.qd)
    }

    fn phase(&self, at: &Point<N>) -> Result<Phase<N>, S::Refusal> {
        Ok(Phase { q: at.q, qd: at.p })
    }

    fn rate(&self, t: f64, at: &Point<N>) -> Result<Point<N>, S::Refusal> {
        let phase = Phase { q: at.q, qd: at.p };
        Ok(Point {
            q: at.p,
            p: self.0.acceleration(t, &phase)?,
        })
    }
}
