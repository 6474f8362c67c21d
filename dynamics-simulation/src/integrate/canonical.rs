//! Equations of motion in positions and momenta.

use dynamics_runtime::{JointVector as _, Size};

#[cfg(test)]
use super::Equations;
use super::{Phase, first_non_finite};

/// Hamilton's equations, with the forces that have no potential: q' and p' as functions of t, q, p.
pub(crate) trait Canonical<D: Size> {
    /// Why there is no rate.
    type Refusal;

    /// The momenta p of a phase.
    fn momentum(&self, phase: &Phase<D>) -> Result<D::Vector, Self::Refusal>;

    /// The phase of positions and momenta.
    fn phase(&self, at: &Point<D>) -> Result<Phase<D>, Self::Refusal>;

    /// q' and p'.
    fn rate(&self, t: f64, at: &Point<D>) -> Result<Point<D>, Self::Refusal>;
}

/// Positions and momenta; or a rate of change of both.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Point<D: Size> {
    pub(crate) q: D::Vector,
    pub(crate) p: D::Vector,
}

impl<D: Size> Point<D> {
    #[inline(always)]
    pub(super) fn zeros(size: D) -> Self {
        Point {
            q: size.vector(),
            p: size.vector(),
        }
    }

    /// The joint of the first entry that is not finite.
    pub(crate) fn first_non_finite(&self) -> Option<usize> {
        let [q, p] = [&self.q, &self.p].map(|vector| first_non_finite(vector.entries()));
        q.or(p)
    }

    /// `self + factor * other`.
    #[inline(always)]
    pub(super) fn plus(&self, factor: f64, other: &Self) -> Self {
        Point {
            q: self.q.plus(factor, &other.q),
            p: self.p.plus(factor, &other.p),
        }
    }
}

/// Equations of motion with their velocities in the place of momenta.
///
/// They are Hamilton's only where the mass matrix does not depend on q: a symplectic method
/// preserves nothing of an arm's structure in these coordinates.
#[cfg(test)]
pub(crate) struct InVelocities<'a, S>(pub(crate) &'a S);

#[cfg(test)]
impl<S: Equations<D>, D: Size> Canonical<D> for InVelocities<'_, S> {
    type Refusal = S::Refusal;

    fn momentum(&self, phase: &Phase<D>) -> Result<D::Vector, S::Refusal> {
        Ok(phase.qd.clone())
    }

    fn phase(&self, at: &Point<D>) -> Result<Phase<D>, S::Refusal> {
        Ok(Phase {
            q: at.q.clone(),
            qd: at.p.clone(),
        })
    }

    fn rate(&self, t: f64, at: &Point<D>) -> Result<Point<D>, S::Refusal> {
        let phase = self.phase(at)?;
        Ok(Point {
            p: self.0.acceleration(t, &phase)?,
            q: phase.qd,
        })
    }
}
