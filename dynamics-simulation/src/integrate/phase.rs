//! A point of the phase space.

use dynamics_runtime::internal::first_non_finite;
use dynamics_runtime::{JointVector as _, Size};

/// Positions and velocities; or a rate of change of both.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Phase<D: Size> {
    pub(crate) q: D::Vector,
    pub(crate) qd: D::Vector,
}

impl<D: Size> Phase<D> {
    #[inline(always)]
    pub(crate) fn zeros(size: D) -> Self {
        Phase {
            q: size.vector(),
            qd: size.vector(),
        }
    }

    /// The number of joints.
    #[inline(always)]
    pub(crate) fn size(&self) -> D {
        D::of(&self.q)
    }

    /// `self + factor * other`.
    #[inline(always)]
    pub(super) fn plus(&self, factor: f64, other: &Self) -> Self {
        Phase {
            q: self.q.plus(factor, &other.q),
            qd: self.qd.plus(factor, &other.qd),
        }
    }

    /// `factor * self`.
    #[inline(always)]
    pub(super) fn scaled(&self, factor: f64) -> Self {
        Phase::zeros(self.size()).plus(factor, self)
    }

    /// `self - other`.
    #[inline(always)]
    pub(crate) fn minus(&self, other: &Self) -> Self {
        self.plus(-1.0, other)
    }

    /// The joint of the first entry that is not finite.
    pub(crate) fn first_non_finite(&self) -> Option<usize> {
        let [q, qd] = [&self.q, &self.qd].map(|vector| first_non_finite(vector.entries()));
        q.or(qd)
    }

    pub(crate) fn entries(&self) -> impl Iterator<Item = f64> {
        let entries = self.q.entries().iter().chain(self.qd.entries());
        entries.copied()
    }
}

/// The start of a step, and its length.
#[derive(Clone, Debug)]
pub(crate) struct Start<D: Size> {
    pub(super) t: f64,
    pub(super) phase: Phase<D>,
    pub(super) h: f64,
}
