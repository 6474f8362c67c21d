//! The transform of a row: where it begins, both conventions, and a mount.

use super::super::assignment::{Assignment, Number};
use super::pose::{Lift, Pose, Position};
use crate::robot::{self, Carrier, Convention, JointType};

/// The link frame of a row in the frame of the row that carries it: a constant transform, the joint
/// Rz(turn + q) Tz(d) or Rz(turn) Tz(d + q), and another constant transform. `None` is the identity.
pub(super) struct Place {
    before: Option<Pose<Number>>,
    /// Sine and cosine.
    turn: (Number, Number),
    d: Number,
    behind: Option<Pose<Number>>,
}

/// The frames of a row in the world.
pub(super) struct Frames<R> {
    pub(super) link: Pose<R>,
    /// The frame to which the parameters of the link refer: on the joint's own axis, after its motion.
    pub(super) parameters: Pose<R>,
}

/// The row that carries the row of this index; `None` for the base.
pub(super) fn parent(row: &robot::Row, index: usize) -> Option<usize> {
    match row.on {
        Carrier::Base => None,
        Carrier::Above => index.checked_sub(1),
        Carrier::Row(parent) => Some(parent),
    }
}

/// T(xyz) Rz(yaw) Ry(pitch) Rx(roll)
pub(super) fn placement(point: &mut Assignment, placement: &robot::Placement) -> Pose<Number> {
    let xyz = placement.xyz.each_ref().map(|x| point.cell(x));
    let rpy = placement.rpy.each_ref().map(|angle| point.angle(angle));
    Pose::placed(xyz, rpy)
}

/// The last of some frames, each placed in the one before it.
pub(super) fn product(point: &mut Assignment, places: &[robot::Placement]) -> Pose<Number> {
    let places = places.iter().map(|place| placement(point, place));
    places.fold(Pose::identity(), |pose, place| pose.then(&place))
}

/// A frame that is placed in another one, if there is one.
fn from(start: Option<Pose<Number>>, place: &Pose<Number>) -> Pose<Number> {
    start.map_or(*place, |start| start.then(place))
}

impl Place {
    pub(super) fn new(point: &mut Assignment, convention: Convention, row: &robot::Row) -> Self {
        let is_turned = row.joint_type == JointType::Revolute;
        let follows = row.follows.as_ref().filter(|_| is_turned);
        let offset = follows.map_or(robot::Value::zero(), |coupling| coupling.offset.clone());
        let start = (!row.at.is_empty()).then(|| product(point, &row.at));
        if let Some(mount) = &row.mount {
            return Place::mounted(point, start, mount, &offset);
        }
        // Rx(alpha) Tx(a)
        let screw = Pose::screw_x(point.angle(&row.alpha), point.cell(&row.a));
        let (before, behind) = match convention {
            Convention::Standard => (start, Some(screw)),
            Convention::Modified => (Some(from(start, &screw)), None),
        };
        Place {
            before,
            turn: point.angle(&(row.theta.clone() + offset)),
            d: point.cell(&row.d),
            behind,
        }
    }

    /// With S = Rz(azimuth) Ry(polar): where the row begins and S, the turn of the joint, and S^-1.
    fn mounted(
        point: &mut Assignment,
        start: Option<Pose<Number>>,
        mount: &robot::Mount,
        offset: &robot::Value,
    ) -> Self {
        let [azimuth, polar] = mount.axis.each_ref().map(|angle| point.angle(angle));
        let none = (Number::ZERO, Number::ONE);
        let axis = Pose::placed([Number::ZERO; 3], [none, polar, azimuth]);
        Place {
            before: Some(from(start, &axis)),
            turn: point.angle(offset),
            d: Number::ZERO,
            behind: Some(axis.inverse()),
        }
    }

    /// The frames of the row, if the frame in which it is written is at `base`.
    pub(super) fn frames<R: Lift>(
        &self,
        base: &Pose<R>,
        is_revolute: bool,
        q: &Position<R>,
    ) -> Frames<R> {
        let (d, [s, c]) = (R::lift(self.d), [self.turn.0, self.turn.1].map(R::lift));
        let motion = match is_revolute {
            // sin(turn + q), cos(turn + q)
            true => Pose::screw_z((s * q.c + c * q.s, c * q.c - s * q.s), d),
            false => Pose::screw_z((s, c), d + q.q),
        };
        let parameters = base.then_fixed(&self.before).then(&motion);
        Frames {
            link: parameters.then_fixed(&self.behind),
            parameters,
        }
    }

    /// The link frame in the frame to which its parameters refer.
    pub(super) fn link_in_parameters(&self) -> Pose<Number> {
        Pose::identity().then_fixed(&self.behind)
    }
}
