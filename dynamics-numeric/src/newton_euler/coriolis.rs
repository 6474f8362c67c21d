//! The Coriolis matrix.
//!
//! Source for a base that moves: S. Echeandia, P. M. Wensing, *Numerical methods to compute the Coriolis matrix and Christoffel
//! symbols for rigid-body systems*, J. Computational and Nonlinear Dynamics 16 (2021), 091004: `C = sum of J' (I Jdot + B J)`
//! over the bodies with `B = 1/2 (v x* I - I v x + (I v) xbar*)`. J has the components of a body's velocity in the axes of the
//! body, and Jdot those of the columns' rates against a frame at rest: a column `S_j` that is fixed in body j changes as
//! `v_j x S_j`.
//!
//! No number of that C depends on where the vectors of a body are written down, so all are here in the axes of the base and
//! about its origin.

use dynamics_runtime::internal::geometry::{Joint, Pose};
use dynamics_runtime::{JointVector as _, Size};
use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};

use super::base::{Body, twist};
use super::inertia::Inertia;
use super::kinematics::{column, joined};
use super::{NumericArm, Placed};

impl<D: Size, V: Size> Placed<'_, '_, D, V> {
    /// With the Christoffel symbols of an arm, C = 1/2 dV/dqd.
    pub(crate) fn coriolis_matrix(&self, q: &D::Vector, qd: &V::Vector) -> V::Matrix {
        match self.arm.body() {
            None => self
                .arm
                .at(q, |joints| self.arm.by_velocity(joints, qd) * 0.5),
            Some(body) => self.arm.coriolis_matrix_on(body, q, qd),
        }
    }
}

impl<D: Size, V: Size> NumericArm<D, V> {
    /// dV/dqd where the joints are so. V is quadratic in qd, so its central difference over any distance h is the derivative
    /// itself: `dV/dqd e_j = (V(qd + h e_j) - V(qd - h e_j)) / (2 h)`. The greatest speed is taken for h, which keeps rounding
    /// at the scale of the result.
    pub(super) fn by_velocity(&self, joints: &D::Links<Joint>, qd: &V::Vector) -> V::Matrix {
        let (mut slopes, h) = (self.freedoms.matrix(), qd.largest());
        if h == 0.0 {
            return slopes;
        }
        for j in self.freedoms.joints() {
            let moved = |distance: f64| {
                let mut qd = qd.clone();
                qd[j] += distance;
                self.velocity_forces(joints, &qd)
            };
            let difference = moved(h) - moved(-h);
            for i in self.freedoms.joints() {
                slopes[(i, j)] = difference[i] / (2.0 * h);
            }
        }
        slopes
    }

    /// C on a base that moves.
    fn coriolis_matrix_on(&self, body: &Body, q: &D::Vector, v: &V::Vector) -> V::Matrix {
        let (mut coriolis, size) = (self.freedoms.matrix(), self.freedoms);
        let [linear, angular] = twist(v);
        let of_base = joined(&linear, &angular);
        // The frames, axes and velocities of the links.
        let poses = self.poses_on(&Pose::IDENTITY, q);
        let axis = |k: usize| column(&self.links[k], &poses[k], &Vector3::zeros());
        let mut velocities = self.per_link(of_base);
        self.outward(of_base, |place, carrier| {
            velocities[place.k] = carrier + axis(place.k) * place.of(v);
            velocities[place.k]
        });
        let mut add = |link: Option<usize>, inertia: &Inertia| {
            let velocity = link.map_or(of_base, |k| velocities[k]);
            let (mut jacobian, mut rate) = (size.columns::<6>(), size.columns::<6>());
            for j in 0..6 {
                jacobian[(j, j)] = 1.0;
                let change = motion(&of_base).column(j).into_owned();
                (0..6).for_each(|row| rate[(row, j)] = change[row]);
            }
            self.walk_from(link, |place| {
                let own = axis(place.k);
                let change = motion(&velocities[place.k]) * own;
                place.add_column(&mut jacobian, 6, |row| own[row]);
                place.add_column(&mut rate, 6, |row| change[row]);
            });
            let (inertia, b) = (inertia.matrix(), factor(&inertia.matrix(), &velocity));
            for j in size.joints() {
                let of = |columns: &V::Columns<6>| Vector6::from_fn(|row, _| columns[(row, j)]);
                let force = inertia * of(&rate) + b * of(&jacobian);
                for i in size.joints() {
                    let power = (0..6).map(|row| jacobian[(row, i)] * force[row]);
                    coriolis[(i, j)] += power.sum::<f64>();
                }
            }
        };
        add(None, &body.solid.inertia);
        self.walk_outward(|place| {
            add(
                Some(place.k),
                &place.link.solid.inertia.placed(&poses[place.k]),
            );
        });
        coriolis
    }
}

/// The matrix of `m x`, of motions with their linear parts first: `[[w]x, [v]x; 0, [w]x]`.
fn motion(m: &Vector6<f64>) -> Matrix6<f64> {
    let [v, w] = parts(m);
    blocks([&w, &v, &Matrix3::zeros(), &w])
}

/// B of a body that moves so.
fn factor(inertia: &Matrix6<f64>, velocity: &Vector6<f64>) -> Matrix6<f64> {
    let crossed = motion(velocity);
    // On forces, m x* = -(m x)'.
    let gyroscopic = crossed.transpose() * inertia * -1.0 - inertia * crossed;
    // f xbar* m = m x* f.
    let [f, n] = parts(&(inertia * velocity));
    let of_momentum = blocks([&Matrix3::zeros(), &-f, &-f, &-n]);
    (gyroscopic + of_momentum) * 0.5
}

/// `[a]x` of the linear and of the angular part.
fn parts(a: &Vector6<f64>) -> [Matrix3<f64>; 2] {
    [0, 3].map(|k| Vector3::new(a[k], a[k + 1], a[k + 2]).cross_matrix())
}

/// A matrix of four, by rows.
fn blocks(parts: [&Matrix3<f64>; 4]) -> Matrix6<f64> {
    Matrix6::from_fn(|i, j| parts[2 * (i / 3) + j / 3][(i % 3, j % 3)])
}
