//! How a search for joint positions ends.

use core::fmt;

use dynamics_runtime::internal::JointName;
use dynamics_runtime::{JointVector as _, Size};

/// How far frames are from their targets: the largest of all.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Residual {
    /// Between positions, m. Zero where no position was requested.
    pub position: f64,
    /// The angle between rotations or directions, rad. Zero where none was requested.
    pub rotation: f64,
}

impl fmt::Display for Residual {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:.3e} m and {:.3e} rad", self.position, self.rotation)
    }
}

/// Joint positions at which all targets are reached.
#[derive(Clone, Debug, PartialEq)]
pub struct Reached<D: Size> {
    /// Joint positions within the limits, rad or m.
    pub q: D::Vector,
    /// The error that is left there, by forward kinematics at this `q`: within the tolerance.
    pub residual: Residual,
    /// How many descents were made: one from the start, others from elsewhere.
    pub attempts: usize,
    /// The iterations of all of them.
    pub iterations: usize,
}

/// Why no joint positions were found, and the nearest ones that were.
#[derive(Clone, PartialEq)]
pub struct NotReached<D: Size> {
    /// Why.
    pub reason: Reason,
    /// The positions with the least weighted error, within the limits, rad or m.
    pub q: D::Vector,
    /// The error there.
    pub residual: Residual,
    /// How many descents were made.
    pub attempts: usize,
    /// The iterations of all of them.
    pub iterations: usize,
    /// The names of the joints, if the sentence has them ([`naming`](NotReached::naming)).
    #[cfg(feature = "std")]
    pub(super) joint_names: Vec<String>,
}

impl<D: Size> NotReached<D> {
    /// The error with the names of the robot's joints in its sentence: `joint 2 (elbow)` in place of `joint 2`.
    #[cfg(feature = "std")]
    #[must_use]
    pub fn naming(mut self, joints: impl IntoIterator<Item = impl Into<String>>) -> Self {
        self.joint_names = joints.into_iter().map(Into::into).collect();
        self
    }

    #[cfg(feature = "std")]
    fn joint_name(&self, joint: usize) -> Option<&str> {
        self.joint_names.get(joint).map(String::as_str)
    }

    #[cfg(not(feature = "std"))]
    fn joint_name(&self, _joint: usize) -> Option<&str> {
        None
    }
}

/// Why targets are not reached.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Reason {
    /// No position of the joints reaches so far: all lengths of the table together are shorter than the way from the base.
    OutOfReach {
        /// The target, counted from 0.
        target: usize,
        /// From the origin of the base frame to the target, m.
        distance: f64,
        /// How far the arm reaches at most, m.
        reach: f64,
    },
    /// Every descent ended where no motion of the joints comes nearer. That is no proof that there are no joint positions, but
    /// the more attempts were made the less likely they are.
    Minimum,
    /// The same within the limits; beyond them the targets are reached.
    Limits {
        /// The joint that is farthest beyond its limit there, counted from 0.
        joint: usize,
    },
    /// The nearest descent had used up its iterations while it still came nearer.
    Iterations,
    /// A target is not finite, its rotation is none, its matrix has another last row than 0, 0, 0, 1, or a weight is not a
    /// positive number.
    Target {
        /// The target, counted from 0.
        target: usize,
    },
    /// There are more or fewer targets than frames.
    Count {
        /// How many targets were given.
        targets: usize,
        /// How many frames there are.
        frames: usize,
    },
    /// A position of the start, or of the preferred posture, is not finite.
    Start {
        /// The joint, counted from 0.
        joint: usize,
    },
    /// The vector of the start, of the preferred posture or of the limits has another length than there are joints.
    Length,
    /// The limits of a joint are no range: not numbers, or not in order.
    Range {
        /// The joint, counted from 0.
        joint: usize,
    },
    /// A tolerance is not a positive finite number.
    Tolerance,
    /// The pose or the Jacobian of a frame is not finite, as that of the tip of a tree that has none.
    NonFinite,
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write(f, |_| None)
    }
}

impl Reason {
    fn write<'n>(
        &self,
        f: &mut fmt::Formatter<'_>,
        name: impl Fn(usize) -> Option<&'n str>,
    ) -> fmt::Result {
        let named = |joint: usize| JointName(joint, name(joint));
        match self {
            Reason::OutOfReach {
                target,
                distance,
                reach,
            } => write!(
                f,
                "target {} is {} m from the base, and the arm reaches {} m at most",
                target + 1,
                Metres(*distance),
                Metres(*reach)
            ),
            Reason::Minimum => f.write_str("no motion of the joints comes nearer"),
            Reason::Limits { joint } => {
                let joint = named(*joint);
                write!(
                    f,
                    "no positions within the limits were found, and some beyond that of {joint}"
                )
            }
            Reason::Iterations => f.write_str("the iterations of an attempt are used up"),
            Reason::Target { target } => write!(
                f,
                "target {} is none: expected finite numbers, a rotation of orthogonal unit vectors, 0, 0, 0, 1 as the last row of a matrix, and weights above zero",
                target + 1
            ),
            Reason::Count { targets, frames } => {
                write!(f, "{targets} targets were given for {frames} frames")
            }
            Reason::Start { joint } => write!(
                f,
                "the start or the posture of {} is not finite",
                named(*joint)
            ),
            Reason::Length => f.write_str("a vector has another length than there are joints"),
            Reason::Range { joint } => write!(
                f,
                "the limits of {} are no range: the lower one first, both numbers",
                named(*joint)
            ),
            Reason::Tolerance => f.write_str("a tolerance is not a positive finite number"),
            Reason::NonFinite => f.write_str("the pose of a frame is not finite"),
        }
    }
}

/// A length with the digits that are read: micrometres, unless it is astronomic.
struct Metres(f64);

impl fmt::Display for Metres {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            length if length < 1e9 => write!(f, "{length:.6}"),
            length => write!(f, "{length:.3e}"),
        }
    }
}

impl<D: Size> fmt::Display for NotReached<D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("not reached: ")?;
        self.reason.write(f, |joint| self.joint_name(joint))?;
        if self.attempts > 0 {
            let (attempts, residual) = (self.attempts, self.residual);
            let plural = if attempts == 1 { "" } else { "s" };
            write!(
                f,
                "; {residual} are missing at the nearest of {attempts} attempt{plural}"
            )?;
        }
        Ok(())
    }
}

impl<D: Size> fmt::Debug for NotReached<D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self} (q = {:?})", self.q.entries())
    }
}

impl<D: Size> core::error::Error for NotReached<D> {}
