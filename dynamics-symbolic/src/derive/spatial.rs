//! Spatial vectors (Featherstone 2008, chapter 2) in the frames of the links.

use super::chain::Link;
use super::inertia::Body;
use crate::expr::Expr;
use crate::linear::Vector3;
use crate::robot::JointType;

type Vector<'g> = Vector3<Expr<'g>>;

/// A spatial motion vector: angular, and linear at the frame's origin.
#[derive(Clone, Copy)]
pub(super) struct Motion<'g> {
    pub(super) w: Vector<'g>,
    pub(super) v: Vector<'g>,
}

/// A spatial force vector: moment about the frame's origin, and force.
#[derive(Clone, Copy)]
pub(super) struct Force<'g> {
    pub(super) n: Vector<'g>,
    pub(super) f: Vector<'g>,
}

impl<'g> Motion<'g> {
    /// Along z, for the joint itself.
    pub(super) fn axis(joint_type: JointType, zero: Expr<'g>, one: Expr<'g>) -> Self {
        let (z, none) = (Vector3::new(zero, zero, one), Vector3::splat(zero));
        match joint_type {
            JointType::Revolute => Motion { w: z, v: none },
            JointType::Prismatic => Motion { w: none, v: z },
        }
    }

    /// In the next frame.
    pub(super) fn enter(self, link: &Link<'g>, zero: Expr<'g>) -> Self {
        Motion {
            w: link.enter(self.w),
            v: link.enter(self.v + self.w.cross(link.position(zero))),
        }
    }

    /// Twice as fast.
    pub(super) fn twice(self) -> Self {
        Motion {
            w: self.w + self.w,
            v: self.v + self.v,
        }
    }

    /// Motion cross motion.
    pub(super) fn cross(self, other: Self) -> Self {
        Motion {
            w: self.w.cross(other.w),
            v: self.w.cross(other.v) + self.v.cross(other.w),
        }
    }

    /// Motion cross force.
    pub(super) fn cross_force(self, force: Force<'g>) -> Force<'g> {
        Force {
            n: self.w.cross(force.n) + self.v.cross(force.f),
            f: self.w.cross(force.f),
        }
    }

    /// Power.
    pub(super) fn dot(self, force: Force<'g>) -> Expr<'g> {
        self.w.dot(force.n) + self.v.dot(force.f)
    }
}

impl<'g> Force<'g> {
    /// The sum.
    pub(super) fn plus(self, other: Self) -> Self {
        Force {
            n: self.n + other.n,
            f: self.f + other.f,
        }
    }

    /// In the previous frame and about its origin.
    pub(super) fn leave(self, link: &Link<'g>, zero: Expr<'g>) -> Self {
        let f = link.leave(self.f);
        Force {
            n: link.leave(self.n) + link.position(zero).cross(f),
            f,
        }
    }

    /// The component along z: what the joint itself feels.
    pub(super) fn along(self, joint_type: JointType) -> Expr<'g> {
        match joint_type {
            JointType::Revolute => self.n[2],
            JointType::Prismatic => self.f[2],
        }
    }
}

/// I S: momentum of a body that moves.
pub(super) fn momentum<'g>(body: &Body<Expr<'g>>, motion: Motion<'g>) -> Force<'g> {
    Force {
        n: body.inertia.apply(motion.w) + body.moment.cross(motion.v),
        f: motion.v * body.mass + motion.w.cross(body.moment),
    }
}
