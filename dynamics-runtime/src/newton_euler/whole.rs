//! The functions of an arm with as many rows as an arm with followers may have.
//!
//! They are compiled here once, and not with every robot that is checked.

use nalgebra::{Matrix4, SMatrix, SVector, Vector3};

use super::NewtonEuler;
use crate::Table;

/// The most rows of an arm with followers, joints included.
pub(super) const MOST_ROWS: usize = 32;

/// The arm in which every row is a joint of its own.
pub(super) type Whole = NewtonEuler<MOST_ROWS>;

/// What belongs to the rows.
pub(super) type Rows = SVector<f64, MOST_ROWS>;

/// What belongs to pairs of rows.
pub(super) type Square = SMatrix<f64, MOST_ROWS, MOST_ROWS>;

/// Reads a table.
pub(super) fn read(table: &Table<MOST_ROWS>) -> Whole {
    NewtonEuler::new(table)
}

impl Whole {
    pub(super) fn whole_mass_matrix(&self, q: &Rows) -> Square {
        self.mass_matrix(q)
    }

    pub(super) fn whole_coriolis_vector(&self, q: &Rows, qd: &Rows) -> Rows {
        self.coriolis_vector(q, qd)
    }

    pub(super) fn whole_gravity_vector(&self, q: &Rows) -> Rows {
        self.gravity_vector(q)
    }

    pub(super) fn whole_friction_vector(&self, qd: &Rows) -> Rows {
        self.friction_vector(qd)
    }

    pub(super) fn whole_spring_vector(&self, q: &Rows) -> Rows {
        self.spring_vector(q)
    }

    pub(super) fn whole_inverse_dynamics(&self, q: &Rows, qd: &Rows, qdd: &Rows) -> Rows {
        self.inverse_dynamics(q, qd, qdd)
    }

    pub(super) fn whole_kinetic_energy(&self, q: &Rows, qd: &Rows) -> f64 {
        self.kinetic_energy(q, qd)
    }

    pub(super) fn whole_potential_energy(&self, q: &Rows) -> f64 {
        self.potential_energy(q)
    }

    pub(super) fn whole_derivatives(&self, q: &Rows, qd: &Rows, qdd: &Rows) -> (Square, Square) {
        self.inverse_dynamics_derivatives(q, qd, qdd)
    }

    /// What row k does, and the curvature of its friction.
    pub(super) fn whole_slopes_by(
        &self,
        k: usize,
        q: &Rows,
        rates: [&Rows; 2],
    ) -> ([Square; 4], f64) {
        let slopes = self.slopes_by(k, &self.joints(q), rates);
        (slopes, self.curvature_of_friction(k, rates[0][k]))
    }

    pub(super) fn whole_rates(
        &self,
        [q, qd, qdd]: [&Rows; 3],
        [jerk, snap]: [&Rows; 2],
    ) -> (Rows, Rows) {
        self.inverse_dynamics_rates(q, qd, qdd, jerk, snap)
    }

    pub(super) fn whole_forward_kinematics(&self, q: &Rows) -> Matrix4<f64> {
        self.forward_kinematics(q)
    }

    pub(super) fn whole_link_poses(&self, q: &Rows) -> [Matrix4<f64>; MOST_ROWS] {
        self.link_poses(q)
    }

    pub(super) fn whole_jacobian(&self, q: &Rows) -> SMatrix<f64, 6, MOST_ROWS> {
        self.jacobian(q)
    }

    pub(super) fn whole_jacobian_rate(&self, q: &Rows, qd: &Rows) -> SMatrix<f64, 6, MOST_ROWS> {
        self.jacobian_rate(q, qd)
    }

    pub(super) fn whole_link_jacobians(&self, q: &Rows) -> [SMatrix<f64, 6, MOST_ROWS>; MOST_ROWS] {
        self.link_jacobians(q)
    }

    pub(super) fn whole_center_of_mass(&self, q: &Rows) -> Vector3<f64> {
        self.center_of_mass(q)
    }

    pub(super) fn whole_center_of_mass_jacobian(&self, q: &Rows) -> SMatrix<f64, 3, MOST_ROWS> {
        self.center_of_mass_jacobian(q)
    }
}
