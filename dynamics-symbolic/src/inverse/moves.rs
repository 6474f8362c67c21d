//! Rigid motions one after the other, applied to points and to directions.

use crate::expr::Expr;
use crate::linear::{Matrix3, Vector3};

/// One motion.
#[derive(Clone, Copy)]
pub(super) enum Move<'g> {
    /// To a frame that is placed in the one before.
    Fixed(Matrix3<Expr<'g>>, Vector3<Expr<'g>>),
    /// By sine and cosine, about z.
    Turn(Expr<'g>, Expr<'g>),
    /// Along z.
    Slide(Expr<'g>),
}

impl<'g> Move<'g> {
    /// A point of the last frame, in the first.
    fn point(&self, p: Vector3<Expr<'g>>) -> Vector3<Expr<'g>> {
        match self {
            Move::Fixed(_, origin) => self.direction(p) + *origin,
            Move::Turn(..) => self.direction(p),
            Move::Slide(d) => p.plus_z(*d),
        }
    }

    /// A direction of the last frame, in the first.
    fn direction(&self, v: Vector3<Expr<'g>>) -> Vector3<Expr<'g>> {
        match self {
            Move::Fixed(rotation, _) => rotation.apply(v),
            Move::Turn(s, c) => {
                let [x, y, z] = v.0;
                Vector3([*c * x - *s * y, *s * x + *c * y, z])
            }
            Move::Slide(_) => v,
        }
    }

    fn inverse(&self) -> Self {
        match self {
            Move::Fixed(rotation, origin) => {
                let back = rotation.transpose();
                Move::Fixed(back, -back.apply(*origin))
            }
            Move::Turn(s, c) => Move::Turn(-*s, *c),
            Move::Slide(d) => Move::Slide(-*d),
        }
    }
}

/// Some motions, each in the frame to which the one before it leads.
#[derive(Clone, Default)]
pub(super) struct Path<'g>(pub(super) Vec<Move<'g>>);

impl<'g> Path<'g> {
    /// A point of the last frame, in the first.
    pub(super) fn point(&self, p: Vector3<Expr<'g>>) -> Vector3<Expr<'g>> {
        self.0.iter().rev().fold(p, |p, step| step.point(p))
    }

    /// A direction of the last frame, in the first.
    pub(super) fn direction(&self, v: Vector3<Expr<'g>>) -> Vector3<Expr<'g>> {
        self.0.iter().rev().fold(v, |v, step| step.direction(v))
    }

    /// The way back.
    pub(super) fn inverse(&self) -> Self {
        Path(self.0.iter().rev().map(Move::inverse).collect())
    }

    /// This way and then another one.
    pub(super) fn then(&self, other: &Self) -> Self {
        Path([&self.0[..], &other.0[..]].concat())
    }
}
