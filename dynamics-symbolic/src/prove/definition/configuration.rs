//! Where a robot is: its base and the positions of its joints.
//!
//! A base that moves has six velocities: v of the origin of its frame, then w, both in its own axes. Its pose has the rates
//!
//!   p' = R v,   R' = R [w]x.
//!
//! A displacement of it is p + R d and R exp([phi]x).

use super::super::assignment::{Assignment, HALF, Number};
use super::super::dual::Dual;
use super::pose::{Lift, Pose, Position};
use crate::exact::{SplitMix64, rotation_point};
use crate::function::Argument;
use crate::linear::{Matrix3, Vector3};

/// Dual numbers over dual numbers: x + x_j e_1 + x_k e_2 + x_jk e_1 e_2.
pub(super) type Twice = Dual<Dual<Number>>;

/// The pose of the base, and the position of each row's joint.
#[derive(Clone)]
pub(super) struct Configuration<R> {
    pub(super) base: Pose<R>,
    pub(super) joints: Vec<Position<R>>,
}

/// The linear and the angular velocity of a base in its own axes.
pub(super) type BaseVelocity<R> = [Vector3<R>; 2];

/// The pose of a base that moves, as it is among the arguments.
pub(super) fn pose_of_base(point: &Assignment) -> Pose<Number> {
    let entry = |k| point.entry(Argument::Base, k);
    Pose {
        rotation: Matrix3([0, 3, 6].map(|k| [k, k + 1, k + 2].map(entry))),
        origin: Vector3([9, 10, 11].map(entry)),
    }
}

/// Any pose.
pub(super) fn random_pose(random: &mut SplitMix64) -> Pose<Number> {
    Pose {
        rotation: Matrix3(rotation_point(random)),
        origin: Vector3([(); 3].map(|()| Number::random(random))),
    }
}

impl<R: Lift> Pose<R> {
    /// The pose with its derivative, if the frame has these velocities in its own axes.
    pub(super) fn moving(&self, [v, w]: BaseVelocity<R>) -> Pose<Dual<R>> {
        let rate = self.rotation.product(&cross(w));
        let entry = |i: usize, j: usize| Dual::new(self.rotation.0[i][j], rate.0[i][j]);
        let (origin, rate) = (self.origin, self.rotation.apply(v));
        Pose {
            rotation: Matrix3([0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j)))),
            origin: Vector3([0, 1, 2].map(|i| Dual::new(origin[i], rate[i]))),
        }
    }
}

impl Pose<Number> {
    /// The pose displaced by R (d_1 e_1 + d_2 e_2) and turned by exp([phi_1]x e_1 + [phi_2]x e_2). With e_1^2 = e_2^2 = 0 the
    /// exponential is 1 + [phi_1]x e_1 + [phi_2]x e_2 + 1/2 ([phi_1]x [phi_2]x + [phi_2]x [phi_1]x) e_1 e_2.
    pub(super) fn displaced(
        &self,
        [[d1, phi1], [d2, phi2]]: [BaseVelocity<Number>; 2],
    ) -> Pose<Twice> {
        let [first, second] = [phi1, phi2].map(cross);
        let (both, other) = (first.product(&second), second.product(&first));
        let mixed =
            Matrix3([0, 1, 2].map(|i| [0, 1, 2].map(|j| HALF * (both.0[i][j] + other.0[i][j]))));
        let [first, second, mixed] = [first, second, mixed].map(|x| self.rotation.product(&x).0);
        let [d1, d2] = [d1, d2].map(|d| self.rotation.apply(d));
        let twice = |x, x1, x2, x12| Dual::new(Dual::new(x, x1), Dual::new(x2, x12));
        let entry = |i: usize, j: usize| {
            let x = self.rotation.0[i][j];
            twice(x, first[i][j], second[i][j], mixed[i][j])
        };
        Pose {
            rotation: Matrix3([0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j)))),
            origin: Vector3([0, 1, 2].map(|i| twice(self.origin[i], d1[i], d2[i], Number::ZERO))),
        }
    }
}

/// [w]x
fn cross<R: Lift>(w: Vector3<R>) -> Matrix3<R> {
    Matrix3::cross(w, R::lift(Number::ZERO))
}

#[cfg(test)]
mod tests {
    use super::*;

    const ZERO: Number = Number::ZERO;

    fn axes() -> [BaseVelocity<Number>; 2] {
        let vector = |first: u64| Vector3([first, first + 1, first * first].map(Number::new));
        [[vector(3), vector(5)], [vector(7), vector(11)]]
    }

    /// To second order: exp(phi) is a rotation for every phi, the displacements are exchangeable, and in one direction
    /// alone they are a motion.
    #[test]
    fn displacements_are_rotations_to_second_order() {
        let pose = random_pose(&mut SplitMix64::new(5));
        let [first, second] = axes();
        let both = pose.displaced([first, second]);
        let unit = both.rotation.transpose().product(&both.rotation);
        for (i, j) in (0..9).map(|k| (k / 3, k % 3)) {
            let expected = Twice::lift(Number::new(u64::from(i == j)));
            assert_eq!(unit.0[i][j], expected, "{i} {j}");
            let exchanged = pose.displaced([second, first]).rotation.0[i][j];
            let entry = both.rotation.0[i][j];
            assert_eq!(entry.derivative.derivative, exchanged.derivative.derivative);
            assert_eq!(entry.value, pose.moving(first).rotation.0[i][j]);
            assert_eq!(
                entry.derivative.value,
                pose.moving(second).rotation.0[i][j].derivative
            );
        }
        for i in 0..3 {
            assert_eq!(both.origin[i].value, pose.moving(first).origin[i]);
            assert_eq!(both.origin[i].derivative.derivative, ZERO);
        }
    }

    /// A turn that goes on: the second derivative is R [w]x [w]x, for a displacement as for a motion.
    #[test]
    fn one_axis_twice_is_a_steady_turn() {
        let pose = random_pose(&mut SplitMix64::new(6));
        let [_, w] = axes()[0];
        let still = Vector3::splat(ZERO);
        let displaced = pose.displaced([[still, w]; 2]);
        let steady = [still, w].map(|x| Vector3(x.0.map(Dual::<Number>::lift)));
        let moved = pose.moving([still, w]).moving(steady);
        assert_eq!(displaced.rotation.0, moved.rotation.0);
    }
}
