//! Mass, first moment and inertia of a body about the origin of a frame.

use super::turn::{Axis, Turn, leave_about, tensor_leave_about};
use super::{Force, Motion};
use crate::linear::{Ring, Symmetric3, Vector3};

/// A rigid body: T = 1/2 w.J w + v.(w x h) + 1/2 m v.v, linear in its ten parameters.
#[derive(Clone, Copy, Debug)]
pub struct Body<R> {
    /// Mass m.
    pub mass: R,
    /// First moment h = m c about the frame's origin.
    pub moment: Vector3<R>,
    /// Inertia tensor J about the frame's origin.
    pub inertia: Symmetric3<R>,
}

/// A body by what tables say of it.
#[derive(Clone, Copy, Debug)]
pub struct Central<R> {
    /// Mass.
    pub mass: R,
    /// Centre of mass in a frame.
    pub com: Vector3<R>,
    /// Inertia tensor about the centre of mass, in the frame's axes.
    pub inertia: Symmetric3<R>,
}

impl<R: Ring> Body<R> {
    /// The same parameter ten times (for zero).
    pub fn splat(x: R) -> Self {
        Body {
            mass: x,
            moment: Vector3::splat(x),
            inertia: Symmetric3::splat(x),
        }
    }

    /// A body about the origin of its frame: J = I + m (c.c 1 - c c^T), the parallel-axis theorem.
    pub fn new(Central { mass, com, inertia }: Central<R>) -> Self {
        let moment = com * mass;
        Body {
            mass,
            moment,
            inertia: inertia + Symmetric3::of_point(moment, com),
        }
    }

    /// Both bodies as one.
    pub fn joined(self, other: Self) -> Self {
        Body {
            mass: self.mass + other.mass,
            moment: self.moment + other.moment,
            inertia: self.inertia + other.inertia,
        }
    }

    /// The body without the other.
    pub fn less(self, other: Self) -> Self {
        Body {
            mass: self.mass - other.mass,
            moment: self.moment - other.moment,
            inertia: self.inertia - other.inertia,
        }
    }

    /// I S: the momentum of the body in a motion.
    pub fn momentum(&self, motion: Motion<R>) -> Force<R> {
        Force {
            n: self.inertia.apply(motion.w) + self.moment.cross(motion.v),
            f: motion.v * self.mass + motion.w.cross(self.moment),
        }
    }

    /// 1/2 w.J w + h.(v x w) + 1/2 m v.v
    pub fn kinetic_energy(&self, motion: Motion<R>, half: R) -> R {
        let Motion { w, v } = motion;
        let squares = w.dot(self.inertia.apply(w)) + self.mass * v.dot(v);
        half * squares + self.moment.dot(v.cross(w))
    }

    /// In the frame before a turn about a coordinate axis.
    pub fn left(self, axis: Axis, turn: Turn<R>) -> Self {
        Body {
            mass: self.mass,
            moment: leave_about(axis, turn, self.moment),
            inertia: tensor_leave_about(axis, turn, self.inertia),
        }
    }

    /// About a point from which the old origin is at `r`:
    /// J' = J + 2 (h.r) 1 - h r^T - r h^T + m (r.r 1 - r r^T), h' = h + m r.
    pub fn moved(self, r: Vector3<R>) -> Self {
        let mr = r * self.mass;
        let point = Symmetric3::of_point(mr, r);
        Body {
            mass: self.mass,
            moment: self.moment + mr,
            inertia: self.inertia + Symmetric3::shift(self.moment, r) + point,
        }
    }

    /// About a point from which the old origin is at (0, 0, d):
    /// J_xx' = J_xx + d (h_z + h_z') and J_yy' alike, with h_z' = h_z + m d.
    pub fn moved_z(self, d: R) -> Self {
        let [x, y, z] = self.moment.0;
        let z_moved = z + self.mass * d;
        let p = d * (z + z_moved);
        let mut moved = self;
        moved.moment.0[2] = z_moved;
        moved.inertia.xx = self.inertia.xx + p;
        moved.inertia.yy = self.inertia.yy + p;
        moved.inertia.yz = self.inertia.yz - d * y;
        moved.inertia.xz = self.inertia.xz - d * x;
        moved
    }

    /// The part that is invariant under rotation about z, and the rest without
    /// mass and h_z, and without J_yy or J_xx (Gautier and Khalil 1990), or as a lamina.
    pub fn split_revolute(self, [zero, half]: [R; 2], keep: Keep) -> (Self, Self) {
        let moving = match keep {
            Keep::Xx => self.inertia.yy,
            Keep::Yy => self.inertia.xx,
            Keep::Lamina => half * (self.inertia.xx + self.inertia.yy - self.inertia.zz),
        };
        let mut invariant = Body::splat(zero);
        invariant.mass = self.mass;
        invariant.moment.0[2] = self.moment[2];
        invariant.inertia.xx = moving;
        invariant.inertia.yy = moving;
        let mut rest = self;
        rest.mass = zero;
        rest.moment.0[2] = zero;
        rest.inertia.xx = self.inertia.xx - moving;
        rest.inertia.yy = self.inertia.yy - moving;
        (invariant, rest)
    }
}

/// The part of J_xx and J_yy that remains on a link behind a revolute joint; only their difference matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Keep {
    /// J_xx - J_yy, as J_xx.
    Xx,
    /// J_yy - J_xx, as J_yy.
    Yy,
    /// Both, with J_zz as their sum: the link is a lamina.
    Lamina,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn along_z_a_body_moves_as_along_any_vector() {
        let body = Body {
            mass: 3,
            moment: Vector3([5, -7, 11]),
            inertia: Symmetric3 {
                xx: 2,
                yy: -3,
                zz: 13,
                xy: 17,
                yz: 19,
                xz: 23,
            },
        };
        let (along_z, by_vector) = (body.moved_z(4), body.moved(Vector3([0, 0, 4])));
        assert_eq!(along_z.mass, by_vector.mass);
        assert_eq!(along_z.moment, by_vector.moment);
        assert_eq!(along_z.inertia, by_vector.inertia);
    }
}
