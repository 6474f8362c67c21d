//! Rigid motions one after the other, applied to points and to directions.

use crate::expr::{Expr, Graph};
use crate::linear::{Matrix3, Vector3};

/// One motion: to a frame that is placed in the one before.
#[derive(Clone, Copy)]
pub(super) struct Move<'g> {
    pub(super) rotation: Matrix3<Expr<'g>>,
    pub(super) origin: Vector3<Expr<'g>>,
}

impl<'g> Move<'g> {
    /// By sine and cosine, about z.
    pub(super) fn turn(graph: &'g Graph, (s, c): (Expr<'g>, Expr<'g>)) -> Self {
        let (zero, one) = (graph.zero(), graph.one());
        Move {
            rotation: Matrix3([[c, -s, zero], [s, c, zero], [zero, zero, one]]),
            origin: Vector3::splat(zero),
        }
    }

    /// Along z.
    pub(super) fn slide(graph: &'g Graph, d: Expr<'g>) -> Self {
        let none = Move::turn(graph, (graph.zero(), graph.one()));
        Move {
            origin: none.origin.plus_z(d),
            ..none
        }
    }

    fn inverse(&self) -> Self {
        let rotation = self.rotation.transpose();
        Move {
            rotation,
            origin: -rotation.apply(self.origin),
        }
    }
}

/// Some motions, each in the frame to which the one before it leads.
#[derive(Clone, Default)]
pub(super) struct Path<'g>(pub(super) Vec<Move<'g>>);

impl<'g> Path<'g> {
    /// A point of the last frame, in the first.
    pub(super) fn point(&self, p: Vector3<Expr<'g>>) -> Vector3<Expr<'g>> {
        self.0
            .iter()
            .rev()
            .fold(p, |p, step| step.rotation.apply(p) + step.origin)
    }

    /// A direction of the last frame, in the first.
    pub(super) fn direction(&self, v: Vector3<Expr<'g>>) -> Vector3<Expr<'g>> {
        self.0
            .iter()
            .rev()
            .fold(v, |v, step| step.rotation.apply(v))
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
