//! The joints as inverse kinematics sees them: how far they move, and whether whole turns matter.

use core::f64::consts::PI;

use dynamics_runtime::Size;
use dynamics_runtime::internal::{Moving, SplitMix64, nearest_turn};
use dynamics_runtime::table::{Arm, AsArm as _, JointType};
use nalgebra::Vector3;

/// The joints of a robot.
#[derive(Clone, Debug)]
pub(super) struct Joints<D: Size> {
    pub(super) size: D,
    pub(super) limits: D::Each<Option<[f64; 2]>>,
    /// Whether the joint slides.
    pub(super) slides: D::Each<bool>,
    /// Whether a whole turn of the joint leaves the robot as it was: not where others follow it.
    pub(super) turns: D::Each<bool>,
    /// The origin of the base in the world, m.
    pub(super) base: Vector3<f64>,
    /// No frame is farther away from it, m: infinite where that is not known.
    pub(super) reach: f64,
    /// A length to compare positions with, m: the reach, where it is finite.
    pub(super) length: f64,
}

impl<D: Size> Joints<D> {
    pub(super) fn new(table: &D::Table) -> Self {
        let arm = table.arm();
        let size = D::from_usize(arm.rows.len());
        let slides = |joint: usize| arm.rows[joint].joint_type == JointType::Prismatic;
        let leads = |joint| {
            let mut rows = arm.chain();
            rows.any(|moving| moving.is_follower && moving.joint == joint)
        };
        let reach = reach::<D>(arm);
        let is_length = reach > 0.0 && reach.is_finite();
        Joints {
            size,
            limits: size.each(|joint| arm.rows[joint].limits),
            slides: size.each(slides),
            turns: size.each(|joint| !slides(joint) && !leads(joint)),
            base: Vector3::from(arm.base.xyz),
            reach,
            length: if is_length { reach } else { 1.0 },
        }
    }

    /// The same, where frames may be anywhere on the links.
    pub(super) fn of_any_reach(self) -> Self {
        Joints {
            reach: f64::INFINITY,
            ..self
        }
    }

    /// The first joint whose limits are no range.
    pub(super) fn without_range(&self) -> Option<usize> {
        let is_range = |limits: &Option<[f64; 2]>| limits.is_none_or(|[low, high]| low <= high);
        self.limits
            .as_ref()
            .iter()
            .position(|limits| !is_range(limits))
    }

    /// The same without limits, if there are any.
    pub(super) fn without_limits(&self) -> Option<Self> {
        let mut free = self.clone();
        free.limits = self.size.each(|_| None);
        let limits = self.limits.as_ref();
        limits.iter().any(Option::is_some).then_some(free)
    }

    /// The joint that is farthest beyond its limits, and by how much.
    pub(super) fn farthest_beyond(&self, q: &D::Vector) -> Option<(usize, f64)> {
        let excess = |joint: usize| {
            let [low, high] = self.range(joint);
            (joint, (low - q[joint]).max(q[joint] - high))
        };
        let beyond = self.size.joints().map(excess);
        let beyond = beyond.filter(|(_, excess)| *excess > 0.0);
        beyond.max_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// The range of a joint, without ends where it has no limits.
    #[inline(always)]
    pub(super) fn range(&self, joint: usize) -> [f64; 2] {
        self.limits[joint].unwrap_or([f64::NEG_INFINITY, f64::INFINITY])
    }

    /// The nearest positions within the limits.
    pub(super) fn within(&self, q: &D::Vector) -> D::Vector {
        self.size.vector_of(|joint| {
            let [low, high] = self.range(joint);
            q[joint].max(low).min(high)
        })
    }

    /// Where another search begins: anywhere within the limits. Joints without limits turn by at most half a turn, and slide by
    /// at most the arm's length from where they began.
    pub(super) fn anywhere(&self, random: &mut SplitMix64, start: &D::Vector) -> D::Vector {
        self.size.vector_of(|joint| {
            let beside = match self.slides[joint] {
                true => [start[joint] - self.length, start[joint] + self.length],
                false => [-PI, PI],
            };
            let range = self.range(joint);
            let [low, high] = if range[1] - range[0] < f64::INFINITY {
                range
            } else {
                [beside[0].max(range[0]), beside[1].min(range[1])]
            };
            random.within(&(low..=high)).min(high)
        })
    }

    /// The greatest difference of a joint between two positions, whole turns left out where they do not matter.
    #[cfg(feature = "std")]
    pub(super) fn distance(&self, a: &D::Vector, b: &D::Vector) -> f64 {
        let difference = |joint: usize| match self.turns[joint] {
            true => (nearest_turn(a[joint], b[joint], None) - b[joint]).abs(),
            false => (a[joint] - b[joint]).abs(),
        };
        self.size.joints().map(difference).fold(0.0, f64::max)
    }

    /// The same place of the robot, with each joint as near to `start` as whole turns within the limits bring it.
    pub(super) fn nearest(&self, q: &D::Vector, start: &D::Vector) -> D::Vector {
        self.size.vector_of(|joint| {
            let turned = nearest_turn(q[joint], start[joint], self.limits[joint]);
            let [low, high] = self.range(joint);
            let is_within = turned >= low && turned <= high;
            if self.turns[joint] && is_within {
                turned
            } else {
                q[joint]
            }
        })
    }
}

/// The greatest distance of a frame from the origin of the base, m: the lengths of all rows on the way to it. It is infinite
/// where a joint slides without limits.
fn reach<D: Size>(arm: Arm<'_>) -> f64 {
    let count = arm.chain().count();
    let mut reaches = D::from_usize(arm.rows.len()).links(count, 0.0);
    let mut farthest: f64 = 0.0;
    for (k, moving) in arm.chain().enumerate() {
        let before = moving.row.on.of(k).map_or(0.0, |carrier| reaches[carrier]);
        reaches[k] = before + row_length(&moving);
        farthest = farthest.max(reaches[k]);
    }
    let frames = arm.frames.iter().map(|frame| norm(frame.place.position));
    farthest + norm(arm.tool.frame.xyz) + frames.fold(0.0, f64::max)
}

/// The length of a row, its joint as far out as it slides.
fn row_length(moving: &Moving<'_>) -> f64 {
    let row = moving.row;
    let slides = match (row.joint_type, row.limits) {
        (JointType::Revolute, _) => row.d.abs(),
        (JointType::Prismatic, Some([low, high])) if !moving.is_follower => {
            (row.d + low).abs().max((row.d + high).abs())
        }
        (JointType::Prismatic, _) => f64::INFINITY,
    };
    let tip = row.tip.map_or(0.0, |tip| norm(tip.position));
    let frames = norm(row.mount.position) + norm(row.link_frame.position);
    libm::hypot(row.a, slides) + frames + tip
}

fn norm(xyz: [f64; 3]) -> f64 {
    Vector3::from(xyz).norm()
}
