//! Why an arm has no closed form.

use super::view::{Points, View};
use crate::robot::JointType;
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
    /// Four joints whose axes are not all parallel, or of which not three turn.
    NotScara,
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

/// The condition that fails.
pub(super) fn why_not(view: &View<'_>) -> Unsolved {
    let count = view.joints.len();
    let meet = |joints: Range<usize>| matches!(view.points(joints), Points::One(_));
    match count {
        3 if is_moved_by_last(view) => Unsolved::NoTwoAxes,
        0..=3 => Unsolved::Undetermined,
        4 => Unsolved::NotScara,
        6 => match [0..3, 3..6].into_iter().find(|joints| meet(joints.clone())) {
            Some(joints) => Unsolved::Quartic(joints),
            None => Unsolved::NoThreeAxes,
        },
        7 => match [0..3, 4..7]
            .into_iter()
            .find(|joints| !meet(joints.clone()))
        {
            Some(joints) => Unsolved::NotSpherical(joints),
            None => Unsolved::NotSpherical(3..4),
        },
        _ => Unsolved::Joints(count),
    }
}

/// Whether the last joint moves the origin of the frame.
fn is_moved_by_last(view: &View<'_>) -> bool {
    let [x, y, _] = view.tip.0;
    let last = view.joints.last();
    let slides = last.is_some_and(|joint| joint.joint_type == JointType::Prismatic);
    slides || !(x.is_zero() && y.is_zero())
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
                "it has {count} joints that move: closed forms are known of up to three, of four with parallel axes, of six and of seven"
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
                "four joints need axes that are all parallel, three of joints that turn and one of a joint that slides"
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
