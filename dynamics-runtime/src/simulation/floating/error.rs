//! How a simulation on a base that moves ends early.

use core::fmt;

use super::SizedFloatingTrajectory;
use crate::Pose;
use crate::simulation::Cause;
use crate::size::{JointVector as _, Size};

/// A simulation on a base that moves that could not reach its end, with everything that it computed before.
///
/// `{:?}`, which `unwrap` and an error of `main` print, is the sentence of `{}` and the number of samples.
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub struct SizedFloatingError<D: Size, V: Size> {
    /// The time reached, s.
    pub time: f64,
    /// Where the base stands then.
    pub base: Pose<f64>,
    /// The joint positions reached, rad or m.
    pub q: D::Vector,
    /// The velocities reached.
    pub v: V::Vector,
    /// Why the motion does not go on from there. Its joints count the six numbers of the base first.
    pub cause: Cause,
    /// The samples up to there.
    pub trajectory: SizedFloatingTrajectory<D, V>,
}

impl<D: Size, V: Size> fmt::Display for SizedFloatingError<D, V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the simulation ended at t = {:?} s: {} (base = {:?}, q = {:?}, v = {:?})",
            self.time,
            self.cause.on_base(),
            self.base.entries().as_slice(),
            self.q.entries(),
            self.v.entries()
        )
    }
}

impl<D: Size, V: Size> fmt::Debug for SizedFloatingError<D, V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let samples = self.trajectory.len();
        write!(f, "{self}; `trajectory` has {samples} samples up to there")
    }
}

impl<D: Size, V: Size> core::error::Error for SizedFloatingError<D, V> {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        self.cause.source_of()
    }
}
