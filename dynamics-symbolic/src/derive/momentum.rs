//! The momentum of bodies that move, as far as Coriolis forces need it.
//!
//! A velocity that is added to the bodies as a rigid motion with the angular
//! velocity a accelerates a particle at r with velocity u by 2 a x u besides:
//! the force is 2 a x p, the moment about the frame's origin 2 N a, with
//!
//!   p = sum m u,   N = tr(K) 1 - K,   K = sum m u r^T.
//!
//! It is twice the operator B of Singh, Russell and Wensing (2022).

use crate::linear::{Matrix3, Ring, Vector3};
use crate::spatial::{Axis, AxisMotion, Body, Force, Joint, Motion, Turn};

/// 2 p and 2 N about the origin of a frame.
#[derive(Clone, Copy)]
pub(super) struct Momentum<R> {
    /// 2 p
    pub(super) p: Vector3<R>,
    /// 2 N
    pub(super) n: Matrix3<R>,
}

impl<R: Ring> Momentum<R> {
    /// The momentum of nothing.
    pub(super) fn none(zero: R) -> Self {
        Momentum {
            p: Vector3::splat(zero),
            n: Matrix3([[zero; 3]; 3]),
        }
    }

    /// The momentum of a body: p = m v + w x h, K = v h^T + [w]x E, with E = tr(J)/2 1 - J the second moments
    /// of its mass. The trace of [w]x E is zero.
    pub(super) fn of(body: &Body<R>, w: Vector3<R>, v: Vector3<R>) -> Self {
        let j = body.inertia.full();
        let trace = j.0[0][0] + j.0[1][1] + j.0[2][2];
        let column = |k: usize| {
            let mut twice_e = -(j.column(k) + j.column(k));
            twice_e.0[k] = twice_e[k] + trace;
            -w.cross(twice_e)
        };
        let spin = Matrix3([0, 1, 2].map(|k| column(k).0)).transpose();
        let twice_h = body.moment + body.moment;
        Momentum {
            p: v * (body.mass + body.mass) + w.cross(twice_h),
            n: sum(trace_less(v, twice_h), spin),
        }
    }

    /// The force of an angular velocity that is added to the bodies.
    pub(super) fn apply(&self, angular: Vector3<R>) -> Force<R> {
        Force {
            n: self.n.apply(angular),
            f: angular.cross(self.p),
        }
    }

    /// a B, the row of a motion a: a . (B w) = row . w.
    pub(super) fn row(&self, a: Motion<R>) -> Vector3<R> {
        self.n.transpose().apply(a.w) + self.p.cross(a.v)
    }

    /// Its derivative where the bodies are displaced along z, of a joint or of the axis of one.
    pub(super) fn displaced(&self, axis_motion: AxisMotion, zero: R, one: R) -> Self {
        let z = Vector3::new(zero, zero, one);
        match axis_motion {
            // z x p, and [z]x N - N [z]x
            AxisMotion::Turns => {
                let [[xx, xy, xz], [yx, yy, yz], [zx, zy, _]] = self.n.0;
                let (sum, difference) = (xy + yx, xx - yy);
                Momentum {
                    p: z.cross(self.p),
                    n: Matrix3([
                        [-sum, difference, -yz],
                        [difference, sum, xz],
                        [-zy, zx, zero],
                    ]),
                }
            }
            // K' = K + p z^T
            AxisMotion::Slides => Momentum {
                p: Vector3::splat(zero),
                n: trace_less(self.p, z),
            },
        }
    }

    /// The momentum of both.
    pub(super) fn joined(self, other: Self) -> Self {
        Momentum {
            p: self.p + other.p,
            n: sum(self.n, other.n),
        }
    }

    /// In the previous frame and about its origin: K' = K + p s^T with the origin at s there.
    pub(super) fn leave(self, joint: &Joint<R>) -> Self {
        let p = joint.leave(self.p);
        let own = turned(joint.turn, self.n, Axis::Z);
        let n = joint.twist.fold(own, |n, axis, turn| turned(turn, n, axis));
        let n = turned(joint.before, n, Axis::Z);
        Momentum {
            p,
            n: sum(n, trace_less(p, joint.position())),
        }
    }
}

/// tr(a b^T) 1 - a b^T
fn trace_less<R: Ring>(a: Vector3<R>, b: Vector3<R>) -> Matrix3<R> {
    let ([a, b, c], [x, y, z]) = (a.0, b.0);
    let (ax, by, cz) = (a * x, b * y, c * z);
    Matrix3([
        [by + cz, -(a * y), -(a * z)],
        [-(b * x), ax + cz, -(b * z)],
        [-(c * x), -(c * y), ax + by],
    ])
}

fn sum<R: Ring>(a: Matrix3<R>, b: Matrix3<R>) -> Matrix3<R> {
    Matrix3([0, 1, 2].map(|i| [0, 1, 2].map(|j| a.0[i][j] + b.0[i][j])))
}

/// R N R^T for a turn about a coordinate axis, out of the turned frame. As
/// [`Turn::leave_block`]; the antisymmetric part of the block does not change.
fn turned<R: Ring>(turn: Turn<R>, n: Matrix3<R>, axis: Axis) -> Matrix3<R> {
    let [z, x, y] = axis.indices();
    let mut n = n.0;
    let k = turn.s * (n[x][x] - n[y][y]) + turn.c * (n[x][y] + n[y][x]);
    let (sk, ck) = (turn.s * k, turn.c * k);
    (n[x][x], n[y][y]) = (n[x][x] - sk, n[y][y] + sk);
    (n[x][y], n[y][x]) = (ck - n[y][x], ck - n[x][y]);
    (n[x][z], n[y][z]) = turn.leave(n[x][z], n[y][z]);
    (n[z][x], n[z][y]) = turn.leave(n[z][x], n[z][y]);
    Matrix3(n)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::{Expr, Graph, Level};
    use crate::linear::Symmetric3;
    use crate::spatial::{Central, enter_about, leave_about};

    fn symbols(graph: &Graph) -> Vector3<Expr<'_>> {
        Vector3([(); 3].map(|()| graph.symbol(Level::Variable)))
    }

    /// Mass m at r as a body.
    fn particle<R: Ring>(m: R, r: Vector3<R>, zero: R) -> Body<R> {
        Body::new(Central {
            mass: m,
            com: r,
            inertia: Symmetric3::splat(zero),
        })
    }

    /// Force and moment of the acceleration 2 a x u of a particle.
    #[test]
    fn of_a_particle() {
        let graph = Graph::new();
        let [r, w, v, a] = [(); 4].map(|()| symbols(&graph));
        let m = graph.symbol(Level::Parameter);
        let momentum = Momentum::of(&particle(m, r, graph.zero()), w, v);
        let u = v + w.cross(r);
        let force = (a + a).cross(u) * m;
        assert_eq!(a.cross(momentum.p), force);
        assert_eq!(momentum.n.apply(a), r.cross(force));
    }

    /// N (R a) = R (N a) in turned axes.
    #[test]
    fn a_turned_tensor_acts_in_the_turned_axes() {
        let graph = Graph::new();
        let n = Matrix3([(); 3].map(|()| symbols(&graph).0));
        let (s, c) = graph.circle(Level::Variable);
        let turn = Turn { s, c };
        let a = symbols(&graph);
        for axis in [Axis::X, Axis::Y, Axis::Z] {
            let outer = leave_about(axis, turn, n.apply(enter_about(axis, turn, a)));
            assert_eq!(turned(turn, n, axis).apply(a), outer);
        }
    }
}
