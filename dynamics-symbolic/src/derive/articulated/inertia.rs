//! Articulated inertia: what a link with free joints beyond it opposes to acceleration.

use crate::linear::{Matrix3, Ring, Symmetric3, Vector3};
use crate::spatial::{Body, Force, Motion, Turn, leave_z, tensor_leave_z};

/// The wrench that a link needs: n = J wd + H a and f = H^T wd + M a, with wd its angular
/// acceleration and a the acceleration of its frame's origin, about which n is (Featherstone
/// 2008, 7.1). The M of a rigid body is its mass times 1 and its H is [h]x; here they are full.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Articulated<R> {
    /// J
    pub(super) angular: Symmetric3<R>,
    /// H
    pub(super) coupling: Matrix3<R>,
    /// M
    pub(super) linear: Symmetric3<R>,
}

impl<R: Ring> Articulated<R> {
    /// A rigid body.
    pub(super) fn rigid(body: &Body<R>, zero: R) -> Self {
        let mut linear = Symmetric3::splat(zero);
        (linear.xx, linear.yy, linear.zz) = (body.mass, body.mass, body.mass);
        Articulated {
            angular: body.inertia,
            coupling: Matrix3::cross(body.moment, zero),
            linear,
        }
    }

    /// n = J wd + H a, f = H^T wd + M a
    pub(super) fn force(&self, acceleration: Motion<R>) -> Force<R> {
        let Motion { w, v } = acceleration;
        Force {
            n: self.angular.apply(w) + self.coupling.apply(v),
            f: self.coupling.transpose().apply(w) + self.linear.apply(v),
        }
    }

    /// Both, fixed to one another.
    pub(super) fn joined(&self, other: &Self) -> Self {
        let (a, b) = (&self.coupling.0, &other.coupling.0);
        Articulated {
            angular: self.angular + other.angular,
            coupling: Matrix3([0, 1, 2].map(|i| (Vector3(a[i]) + Vector3(b[i])).0)),
            linear: self.linear + other.linear,
        }
    }

    /// In the frame before a turn about z.
    pub(super) fn left_z(&self, turn: Turn<R>) -> Self {
        Articulated {
            angular: tensor_leave_z(turn, self.angular),
            coupling: matrix_left_z(turn, &self.coupling, block_left_z),
            linear: tensor_leave_z(turn, self.linear),
        }
    }

    /// The inertia after a turn about x, where `turn` has it after the same turn about z.
    pub(super) fn about_x(&self, turn: impl Fn(&Self) -> Self) -> Self {
        turn(&self.renamed()).renamed().renamed()
    }

    /// As [`Articulated::left_z`]: no component across the axis is a difference of larger ones. A
    /// payload that a joint gives way to in one direction weighs nothing in that direction: what a
    /// turn makes of that is not what a large number less another leaves.
    pub(super) fn turned_z(&self, turn: Turn<R>) -> Self {
        let matrix = |m: &Matrix3<R>| matrix_left_z(turn, m, block_turned_z);
        let tensor = |t: &Symmetric3<R>| Symmetric3::from_upper(&matrix(&t.full()));
        Articulated {
            angular: tensor(&self.angular),
            coupling: matrix(&self.coupling),
            linear: tensor(&self.linear),
        }
    }

    /// About a point from which the old origin is at r.
    pub(super) fn moved(&self, r: Vector3<R>) -> Self {
        // Along one axis after the other: a product for each component of r less than at once.
        let [x, y, z] = r.0;
        let along_z = self.moved_z(z).renamed();
        along_z.moved_z(x).renamed().moved_z(y).renamed()
    }

    /// About a point from which the old origin is at (0, 0, d). With r the vector to it,
    /// H' = H + [r]x M and J' = J - H [r]x + [r]x H'^T.
    pub(super) fn moved_z(&self, d: R) -> Self {
        let (m, [[xx, xy, xz], [yx, yy, yz], z]) = (&self.linear, self.coupling.0);
        let (d_xy, old) = (d * m.xy, (xx, xy, yx));
        let (xx, xy, xz) = (xx - d_xy, xy - d * m.yy, xz - d * m.yz);
        let (yx, yy, yz) = (yx + d * m.xx, yy + d_xy, yz + d * m.xz);
        let j = &self.angular;
        Articulated {
            angular: Symmetric3 {
                xx: j.xx - d * (old.1 + xy),
                yy: j.yy + d * (old.2 + yx),
                zz: j.zz,
                xy: j.xy + d * (old.0 - yy),
                yz: j.yz + d * z[0],
                xz: j.xz - d * z[1],
            },
            coupling: Matrix3([[xx, xy, xz], [yx, yy, yz], z]),
            linear: self.linear,
        }
    }

    /// With other names for the axes: what was x is z, what was y is x, what was z is y.
    fn renamed(&self) -> Self {
        let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = self.coupling.0;
        Articulated {
            angular: renamed(&self.angular),
            coupling: Matrix3([[yy, yz, yx], [zy, zz, zx], [xy, xz, xx]]),
            linear: renamed(&self.linear),
        }
    }
}

fn renamed<R: Ring>(t: &Symmetric3<R>) -> Symmetric3<R> {
    Symmetric3::from_entries([t.yy, t.zz, t.xx, t.yz, t.xz, t.xy])
}

/// The components of a matrix across the axis of a turn.
type Block<R> = [[R; 2]; 2];

/// R H R^T, where `block` has the components across the axis.
fn matrix_left_z<R: Ring>(
    turn: Turn<R>,
    h: &Matrix3<R>,
    block: impl Fn(Turn<R>, Block<R>) -> Block<R>,
) -> Matrix3<R> {
    let [[xx, xy, xz], [yx, yy, yz], z] = h.0;
    let [[xx, xy], [yx, yy]] = block(turn, [[xx, xy], [yx, yy]]);
    let (xz, yz) = turn.leave(xz, yz);
    Matrix3([[xx, xy, xz], [yx, yy, yz], leave_z(turn, Vector3(z)).0])
}

/// As for tensors, with k = s (xx - yy) + c (xy + yx):
/// xx' = xx - s k, yy' = yy + s k, xy' = c k - yx, yx' = c k - xy.
fn block_left_z<R: Ring>(turn: Turn<R>, [[xx, xy], [yx, yy]]: Block<R>) -> Block<R> {
    let k = turn.s * (xx - yy) + turn.c * (xy + yx);
    let (sk, ck) = (turn.s * k, turn.c * k);
    [[xx - sk, ck - yx], [ck - xy, yy + sk]]
}

/// The same with every product in its own right:
/// xx' = c^2 xx + s^2 yy - c s (xy + yx), yy' = s^2 xx + c^2 yy + c s (xy + yx),
/// xy' = c s (xx - yy) + c^2 xy - s^2 yx, yx' = c s (xx - yy) + c^2 yx - s^2 xy.
fn block_turned_z<R: Ring>(turn: Turn<R>, [[xx, xy], [yx, yy]]: Block<R>) -> Block<R> {
    let (cc, ss, cs) = (turn.c * turn.c, turn.s * turn.s, turn.c * turn.s);
    let (mixed, across) = (cs * (xy + yx), cs * (xx - yy));
    [
        [cc * xx + ss * yy - mixed, across + cc * xy - ss * yx],
        [across + cc * yx - ss * xy, ss * xx + cc * yy + mixed],
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{Residue, SplitMix64, circle_point};
    use crate::linear::Vector3;

    type Number = Residue<{ (1 << 61) - 1 }>;
    type Vector = Vector3<Number>;

    fn vector(random: &mut SplitMix64) -> Vector {
        Vector3([(); 3].map(|()| Number::random(random)))
    }

    fn symmetric(random: &mut SplitMix64) -> Symmetric3<Number> {
        Symmetric3::from_upper(&Matrix3([(); 3].map(|()| vector(random).0)))
    }

    fn turn(random: &mut SplitMix64) -> Turn<Number> {
        let (s, c) = circle_point(random);
        Turn { s, c }
    }

    /// An inertia that is not that of a rigid body.
    fn articulated(random: &mut SplitMix64) -> Articulated<Number> {
        Articulated {
            angular: symmetric(random),
            coupling: Matrix3([(); 3].map(|()| vector(random).0)),
            linear: symmetric(random),
        }
    }

    /// Moment and force.
    fn wrench(inertia: &Articulated<Number>, wd: Vector, a: Vector) -> [Vector; 2] {
        let Force { n, f } = inertia.force(Motion { w: wd, v: a });
        [n, f]
    }

    #[test]
    fn a_turned_inertia_gives_turned_wrenches() {
        let random = &mut SplitMix64::new(1);
        let (inertia, turn) = (articulated(random), turn(random));
        let [wd, a] = [(); 2].map(|()| vector(random));
        let inner = wrench(&inertia, wd, a);
        let leave = |v| leave_z(turn, v);
        let outer = wrench(&inertia.left_z(turn), leave(wd), leave(a));
        assert_eq!(outer, inner.map(leave));
        let leave = |v| crate::spatial::leave_x(turn, v);
        let outer = wrench(&inertia.about_x(|x| x.left_z(turn)), leave(wd), leave(a));
        assert_eq!(outer, inner.map(leave));
    }

    #[test]
    fn both_ways_of_turning_agree() {
        let random = &mut SplitMix64::new(4);
        let (inertia, turn) = (articulated(random), turn(random));
        assert_eq!(inertia.turned_z(turn), inertia.left_z(turn));
    }

    /// At the old origin, which is at r, the acceleration is a + wd x r; the moment of f there
    /// comes to r x f.
    #[test]
    fn a_moved_inertia_gives_moments_about_the_new_origin() {
        let random = &mut SplitMix64::new(2);
        let inertia = articulated(random);
        let [wd, a, r] = [(); 3].map(|()| vector(random));
        let [n, f] = wrench(&inertia, wd, a + wd.cross(r));
        assert_eq!(wrench(&inertia.moved(r), wd, a), [n + r.cross(f), f]);
    }

    #[test]
    fn a_rigid_body_stays_one() {
        let random = &mut SplitMix64::new(3);
        let body = Body {
            mass: Number::random(random),
            moment: vector(random),
            inertia: symmetric(random),
        };
        let (turn, r) = (turn(random), vector(random));
        let rigid = |body: &Body<Number>| Articulated::rigid(body, Number::ZERO);
        assert_eq!(
            rigid(&body).about_x(|x| x.left_z(turn)),
            rigid(&body.left_x(turn))
        );
        assert_eq!(rigid(&body).left_z(turn), rigid(&body.left_z(turn)));
        assert_eq!(rigid(&body).moved(r), rigid(&body.moved(r)));
        let both = rigid(&body).joined(&rigid(&body));
        assert_eq!(both, rigid(&body.joined(body)));
    }
}
