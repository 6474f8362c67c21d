//! Joints: how a link's frame lies in that of the link before.

use super::turn::{Axis, Turn, enter_about, leave_about};
use super::{AxisMotion, Body, Force, Motion, Turns};
use crate::linear::{Ring, Vector3};

/// A joint at some position, with the constant geometry before it.
#[derive(Clone, Debug)]
pub struct Joint<R> {
    /// The number zero.
    pub zero: R,
    /// Which way it moves.
    pub axis_motion: AxisMotion,
    /// Turn about z of the previous frame, where that frame does not turn with its own link.
    pub before: Turn<R>,
    /// The constant rotation that follows, to the joint's axis.
    pub twist: Turns<R>,
    /// Turn about z: variable for a revolute joint.
    pub turn: Turn<R>,
    /// Where the origin is in the previous frame (at q = 0 for a prismatic joint).
    pub offset: Vector3<R>,
    /// Displacement along the joint's axis: q for a prismatic joint, else zero.
    pub slide: R,
}

impl<R: Ring> Joint<R> {
    /// A vector of the previous frame, in this frame.
    pub fn enter(&self, v: Vector3<R>) -> Vector3<R> {
        let v = self.twist.enter(enter_about(Axis::Z, self.before, v));
        enter_about(Axis::Z, self.turn, v)
    }

    /// A vector of this frame, in the previous frame.
    pub fn leave(&self, v: Vector3<R>) -> Vector3<R> {
        let v = self.twist.leave(leave_about(Axis::Z, self.turn, v));
        leave_about(Axis::Z, self.before, v)
    }

    /// A body of this frame, in the previous frame and about its origin.
    pub fn leave_body(&self, body: Body<R>) -> Body<R> {
        // A joint slides along its own axis: fewer products than in the previous frame.
        let slid = body.left(Axis::Z, self.turn).moved_z(self.slide);
        let turned = self.twist.leave_body(slid).left(Axis::Z, self.before);
        turned.moved(self.offset)
    }

    /// Where the origin is in the previous frame: no turn about z moves what has slid along z.
    pub fn position(&self) -> Vector3<R> {
        let slide = Vector3::new(self.zero, self.zero, self.slide);
        self.offset + leave_about(Axis::Z, self.before, self.twist.leave(slide))
    }
}

impl<R: Ring> Motion<R> {
    /// In the frame of the link that the joint carries.
    pub fn enter(self, joint: &Joint<R>) -> Self {
        let w = joint.enter(self.w);
        let v = joint.enter(self.at(joint.position()).v);
        Motion { w, v }
    }
}

impl<R: Ring> Force<R> {
    /// In the frame of the link before, about its origin.
    pub fn leave(self, joint: &Joint<R>) -> Self {
        let f = joint.leave(self.f);
        Force {
            n: joint.leave(self.n) + joint.position().cross(f),
            f,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{Residue, SplitMix64, circle_point};

    type Number = Residue<{ (1 << 61) - 1 }>;

    fn vector(random: &mut SplitMix64) -> Vector3<Number> {
        Vector3([(); 3].map(|()| Number::random(random)))
    }

    fn turn(random: &mut SplitMix64) -> Turn<Number> {
        let (s, c) = circle_point(random);
        Turn { s, c }
    }

    fn joint(axis_motion: AxisMotion, random: &mut SplitMix64) -> Joint<Number> {
        Joint {
            zero: Number::ZERO,
            axis_motion,
            before: turn(random),
            twist: Turns([Axis::Y, Axis::X].map(|axis| (axis, turn(random))).to_vec()),
            turn: turn(random),
            offset: vector(random),
            slide: Number::random(random),
        }
    }

    fn force(random: &mut SplitMix64) -> Force<Number> {
        Force {
            n: vector(random),
            f: vector(random),
        }
    }

    #[test]
    fn a_force_has_the_same_power_in_both_frames() {
        let random = &mut SplitMix64::new(1);
        let (joint, force) = (joint(AxisMotion::Turns, random), force(random));
        let motion = Motion {
            w: vector(random),
            v: vector(random),
        };
        let outside = motion.enter(&joint).dot(force);
        assert_eq!(outside, motion.dot(force.leave(&joint)));
    }

    /// With the body's momentum as the force: twice its kinetic energy.
    #[test]
    fn a_body_has_the_same_energy_in_both_frames() {
        let random = &mut SplitMix64::new(2);
        let joint = joint(AxisMotion::Slides, random);
        let mut entries = || Number::random(random);
        let inertia = crate::linear::Symmetric3 {
            xx: entries(),
            yy: entries(),
            zz: entries(),
            xy: entries(),
            yz: entries(),
            xz: entries(),
        };
        let body = Body {
            mass: entries(),
            moment: vector(random),
            inertia,
        };
        let motion = Motion {
            w: vector(random),
            v: vector(random),
        };
        let outside = motion.enter(&joint);
        let energy = outside.dot(body.momentum(outside));
        assert_eq!(energy, motion.dot(joint.leave_body(body).momentum(motion)));
    }
}
