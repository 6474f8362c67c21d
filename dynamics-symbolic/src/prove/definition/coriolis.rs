//! C(q, qd) v, linear in the inertial parameters: Christoffel's on a base that stands, and on one that moves
//!
//!   C = sum J' (I dJ/dt + B J),   B = 1/2 (V x* I - I V x + (I V) x*),   V = J u
//!
//! over all bodies, where f x* X = X x* f (Echeandia and Wensing 2021). J is in the axes of the body, and dJ/dt is the rate in
//! space in these axes: the rate J' of the entries, and V x J. Motors add nothing. C u = V(q, u), and dM/dt - 2 C is skew.
//!
//! Because X.(Y x* f) = -(Y x X).f, and I is symmetric, with the columns X_i = J e_i and X = J v
//!
//!   X_i.(I (V x X) + B X) = -1/2 ((V x X_i).I X - X_i.I (V x X) + (X x X_i).I V).

use super::super::assignment::{HALF, Number};
use super::super::dual::Dual;
use super::configuration::Configuration;
use super::derivatives::transpose;
use super::equations::{constant, product};
use super::parameters::{Twist, polar};
use super::{Definition, Matrix, Vector};
use crate::linear::Vector3;

impl Twist<Number> {
    /// (w, v) x (w', v') = (w x w', w x v' + v x w')
    fn cross(&self, other: &Self) -> Self {
        Twist {
            w: self.w.cross(other.w),
            v: self.w.cross(other.v) + self.v.cross(other.w),
            speed: Number::ZERO,
        }
    }
}

impl Twist<Dual<Number>> {
    fn derivative(&self) -> Twist<Number> {
        let vector = |x: Vector3<Dual<Number>>| Vector3(x.0.map(|x| x.derivative));
        Twist {
            w: vector(self.w),
            v: vector(self.v),
            speed: self.speed.derivative,
        }
    }
}

impl Definition {
    /// C(q, qd) v of a unit of each parameter, for each degree of freedom.
    pub(super) fn unit_coriolis_forces(
        &self,
        q: &Configuration<Number>,
        qd: &[Number],
        v: &[Number],
    ) -> Matrix {
        match self.floating {
            Some(_) => self.unit_forces_of_bodies(q, qd, v),
            None => self.unit_christoffel_forces(q, qd, v),
        }
    }

    /// C v = sum_jk c_ijk v_j qd_k is, by the derivatives M' of M in the direction of its subscript,
    /// 1/2 (e_i' M'_qd v + e_i' M'_v qd - v' M'_i qd).
    fn unit_christoffel_forces(
        &self,
        q: &Configuration<Number>,
        qd: &[Number],
        v: &[Number],
    ) -> Matrix {
        // The twists of these speeds, with their derivatives in a direction.
        let twists = |direction: &[Number]| {
            let moving = self.moving(q, direction);
            move |speeds: &[Number]| self.twists(&moving, &constant(speeds))
        };
        let (motion, reference) = (twists(qd), twists(v));
        let (motion_v, reference_qd) = (motion(v), reference(qd));
        let row = |i: usize| -> Vector {
            let unit = self.unit(i);
            let joint = twists(&unit);
            let along_motion = self.inertia_forms(&motion(&unit), &motion_v);
            let along_reference = self.inertia_forms(&reference(&unit), &reference_qd);
            let along_joint = self.inertia_forms(&joint(v), &joint(qd));
            let force = |k: usize| {
                let coriolis = along_motion[k] + along_reference[k] - along_joint[k];
                HALF * coriolis.derivative
            };
            (0..along_joint.len()).map(force).collect()
        };
        (0..self.dof()).map(row).collect()
    }

    /// J_i.(I dJ/dt v + B J v) of a unit of each parameter.
    fn unit_forces_of_bodies(
        &self,
        q: &Configuration<Number>,
        qd: &[Number],
        v: &[Number],
    ) -> Matrix {
        let along_motion = self.moving(q, qd);
        let (motions, references) = (self.twists(q, qd), self.twists(q, v));
        let rates = self.twists(&along_motion, &constant(v));
        let row = |i: usize| {
            let columns = self.twists(q, &self.unit(i));
            self.columns(|link| {
                let (own, motion, reference) = (&columns[link], &motions[link], &references[link]);
                let inertial = polar(own, &rates[link].derivative());
                let terms = [
                    polar(&motion.cross(own), reference),
                    polar(own, &motion.cross(reference)),
                    polar(&reference.cross(own), motion),
                ];
                let twice = |k: usize| terms[0][k] - terms[1][k] + terms[2][k];
                core::array::from_fn(|k| inertial[k] - HALF * twice(k))
            })
        };
        (0..self.dof()).map(row).collect()
    }

    /// C on a base that moves.
    pub(super) fn coriolis_matrix_of_bodies(&self) -> Matrix {
        let parameters = self.standard_parameters();
        let column = |j: usize| -> Vector {
            let forces = self.unit_coriolis_forces(&self.q, &self.qd, &self.unit(j));
            product(&forces, &parameters)
        };
        transpose(&(0..self.dof()).map(column).collect())
    }
}
