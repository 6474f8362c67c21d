//! A point of the phase space.

use nalgebra::SVector;

use crate::float::first_non_finite;

/// Positions and velocities; or a rate of change of both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Phase<const N: usize> {
    pub(crate) q: SVector<f64, N>,
    pub(crate) qd: SVector<f64, N>,
}

impl<const N: usize> Phase<N> {
    pub(crate) fn zeros() -> Self {
        Phase {
            q: SVector::zeros(),
            qd: SVector::zeros(),
        }
    }

    /// The rate of change of this point under an acceleration.
    pub(super) fn rate(&self, qdd: SVector<f64, N>) -> Self {
        Phase {
            q: self.qd,
            qd: qdd,
        }
    }

    /// `self + factor * other`.
    pub(super) fn plus(&self, factor: f64, other: &Self) -> Self {
        Phase {
            q: self.q + other.q * factor,
            qd: self.qd + other.qd * factor,
        }
    }

    /// `factor * self`.
    pub(super) fn scaled(&self, factor: f64) -> Self {
        Phase::zeros().plus(factor, self)
    }

    /// `self - other`.
    pub(crate) fn minus(&self, other: &Self) -> Self {
        self.plus(-1.0, other)
    }

    /// The joint of the first entry that is not finite.
    pub(crate) fn first_non_finite(&self) -> Option<usize> {
        first_non_finite(&self.q).or_else(|| first_non_finite(&self.qd))
    }

    pub(crate) fn entries(&self) -> impl Iterator<Item = f64> {
        self.q.iter().chain(self.qd.iter()).copied()
    }
}

/// Where a step starts, and its length.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Start<const N: usize> {
    pub(super) t: f64,
    pub(super) phase: Phase<N>,
    pub(super) h: f64,
}
