//! The part of the pose that an arm reaches, and why it has no closed form.

use super::plan::Target;
use super::view::{Points, Unknown, View, are_parallel};
use crate::spatial::AxisMotion;
use core::fmt;
use core::ops::Range;

/// Why there is no plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unsolved {
    /// The base moves.
    MovingBase,
    /// A joint that moves does not carry the frame.
    OtherJoint(String),
    /// A joint follows another one.
    Follower(String),
    /// Seven joints without a spherical shoulder and a spherical wrist: these axes do not meet in a point, or the
    /// axis between them passes through the shoulder.
    NotSpherical(Range<usize>),
    /// So many joints, for which no class is known.
    Joints(usize),
    /// Four joints that are no SCARA, and no waist in front of three parallel axes.
    NotScara,
    /// Five joints that are no waist, three parallel axes and a roll.
    NotWaist,
    /// Six joints of which no three axes meet in a point at either end, and no three are parallel.
    NoThreeAxes,
    /// Three axes meet, and the position of that point leads to an equation of the fourth degree.
    Quartic(Range<usize>),
    /// Three joints of which no two neighbouring axes meet or are parallel.
    NoTwoAxes,
    /// The position of the frame does not determine the joints.
    Undetermined,
    /// A constant of the closed form is too large for a double.
    Overflow,
}

/// The part of the pose that an arm with so many joints reaches, and the condition that fails if it has no plan.
///
/// # Errors
///
/// The condition that fails of every such arm.
pub(super) fn class(view: &View<'_>) -> Result<(Target, Unsolved), Unsolved> {
    let count = view.joints.len();
    let turns = |joint: &&Unknown| joint.axis_motion == AxisMotion::Turns;
    let turning = view.joints.iter().filter(turns).count();
    let z = view.z();
    let is_parallel = |i: usize| are_parallel(view.way(0, i).direction(z), z);
    let three_parallel = turning == 3 && (0..count).all(is_parallel);
    let meet = |joints: &Range<usize>| matches!(view.points(joints.clone()), Points::One(_));
    Ok(match count {
        3 if three_parallel => (Target::PositionAndAngle, why_not_three(view)),
        3 => (Target::Position, why_not_three(view)),
        1 | 2 => (Target::Position, Unsolved::Undetermined),
        4 if three_parallel => (Target::Pose, Unsolved::NotScara),
        4 | 5 if is_waist(view) => (Target::Pose, Unsolved::Undetermined),
        4 => return Err(Unsolved::NotScara),
        5 => return Err(Unsolved::NotWaist),
        6 => {
            let meeting = [0..3, 3..6].into_iter().find(meet);
            let why = meeting.map_or(Unsolved::NoThreeAxes, Unsolved::Quartic);
            (Target::Pose, why)
        }
        7 => {
            let apart = [0..3, 4..7].into_iter().find(|joints| !meet(joints));
            let why = Unsolved::NotSpherical(apart.unwrap_or(3..4));
            (Target::PoseAndElbow, why)
        }
        _ => return Err(Unsolved::Joints(count)),
    })
}

/// Whether the joints are a waist, three parallel axes behind it, and a roll about an axis at right angles to these or none.
pub(super) fn is_waist(view: &View<'_>) -> bool {
    let (count, z) = (view.joints.len(), view.z());
    let turns = |joint: &Unknown| joint.axis_motion == AxisMotion::Turns;
    if !(4..=5).contains(&count) || !view.joints.iter().all(turns) {
        return false;
    }
    let axis = |from: usize, to: usize| view.way(from, to).direction(z);
    let are_three = (2..4).all(|i| are_parallel(axis(1, i), z));
    let is_roll = count == 4 || axis(3, 4)[2].is_zero();
    are_three && is_roll && !are_parallel(axis(0, 1), z)
}

/// Three joints of which the last moves the origin of the frame need two axes that meet or are parallel.
fn why_not_three(view: &View<'_>) -> Unsolved {
    let [x, y, _] = view.tip.0;
    let last = view.joints[2].axis_motion;
    match last == AxisMotion::Slides || !(x.is_zero() && y.is_zero()) {
        true => Unsolved::NoTwoAxes,
        false => Unsolved::Undetermined,
    }
}

impl fmt::Display for Unsolved {
    /// The reason, as the end of a sentence behind "because".
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Unsolved::MovingBase => write!(f, "its base moves"),
            Unsolved::OtherJoint(name) => {
                write!(f, "joint `{name}` moves and does not carry the frame")
            }
            Unsolved::Follower(name) => write!(f, "joint `{name}` follows another one"),
            Unsolved::Joints(count) => write!(
                f,
                "it has {count} joints that move: closed forms are known of up to seven"
            ),
            Unsolved::NotSpherical(joints) if joints.len() == 1 => write!(
                f,
                "of its seven joints the fourth is no elbow: it turns about an axis beside the shoulder, in which the first three \
                 axes meet"
            ),
            Unsolved::NotSpherical(joints) => write!(
                f,
                "seven joints need a spherical shoulder and a spherical wrist, and axes {} to {} do not meet in a point",
                joints.start + 1,
                joints.end
            ),
            Unsolved::NotScara => write!(
                f,
                "four joints need axes that are all parallel, three of joints that turn and one of a joint that slides, or a waist \
                 and three parallel axes behind it"
            ),
            Unsolved::NotWaist => write!(
                f,
                "five joints need a waist, three parallel axes behind it, and a roll about an axis at right angles to these"
            ),
            Unsolved::NoThreeAxes => write!(
                f,
                "neither the first three nor the last three of its axes meet in a point, and no three in a row are parallel"
            ),
            Unsolved::Quartic(joints) => write!(
                f,
                "axes {} to {} meet in a point, and its position leads to an equation of the fourth degree: of the other \
                 three joints two neighbouring axes must meet or be parallel, or two of the joints must slide",
                joints.start + 1,
                joints.end
            ),
            Unsolved::NoTwoAxes => write!(
                f,
                "of its three axes no two neighbouring ones meet or are parallel, so that the position leads to an equation of the \
                 fourth degree"
            ),
            Unsolved::Undetermined => write!(
                f,
                "the position of the frame's origin does not determine the positions of its joints"
            ),
            Unsolved::Overflow => write!(
                f,
                "numbers of the table combine to a constant above 1.8e308, too large for a double-precision number (are the \
                 units right?)"
            ),
        }
    }
}
