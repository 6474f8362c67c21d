//! A state at which functions are compared.

use nalgebra::{DMatrix, DVector, Dyn, Matrix4, Matrix6xX};

use super::scale::Scale;
use crate::table::{AsArm as _, Moving};
use crate::{JointType, NumericArm, RuntimeTable, SizedState};

/// A state at which functions are compared, and the magnitudes of their values there.
pub(super) struct At<'a> {
    pub(super) numeric: &'a NumericArm<Dyn>,
    pub(super) table: &'a RuntimeTable,
    pub(super) state: &'a SizedState<Dyn>,
    pub(super) q: &'a DVector<f64>,
    pub(super) qd: &'a DVector<f64>,
    pub(super) qdd: &'a DVector<f64>,
    pub(super) tau: &'a DVector<f64>,
    /// The frame that functions of the tip are about; `None` for the tip.
    pub(super) frame: Option<usize>,
    /// M(q) of the numeric algorithm.
    pub(super) mass_matrix: DMatrix<f64>,
    pub(super) scale: Scale,
    /// The constant that the regressor of the potential energy leaves open.
    pub(super) datum: f64,
}

/// The natural magnitude of an entry, and the joint that it belongs to.
pub(super) type Unit = (f64, Option<usize>);

/// The units of entries.
impl At<'_> {
    /// The number of joints.
    pub(super) fn joints(&self) -> usize {
        self.q.len()
    }

    /// Row i of a matrix of N rows belongs to joint i.
    pub(super) fn joint(&self, k: usize, scale: f64) -> Unit {
        (scale, Some(k % self.joints()))
    }

    /// Directions in a transform are of size 1.
    pub(super) fn pose(&self, k: usize) -> f64 {
        if (12..15).contains(&(k % 16)) {
            self.scale.position
        } else {
            1.0
        }
    }

    /// Axes in a Jacobian are of size 1, velocities of revolute joints as large as the distance from their axis. A column
    /// is the sum of that of a joint and of those that follow it, each times its factor.
    pub(super) fn jacobian(&self, k: usize) -> Unit {
        let joint = k / 6 % self.joints();
        let of_joint = self
            .table
            .arm()
            .chain()
            .filter(|moving| moving.joint == joint);
        let sizes = of_joint.map(|moving| {
            let is_lever = k % 6 < 3 && moving.row.joint_type == JointType::Revolute;
            moving.factor.abs() * if is_lever { self.scale.position } else { 1.0 }
        });
        (sizes.sum(), Some(joint))
    }

    /// A motion of the tip for joints that move by `size`. Its linear part is as large as the distance from the base
    /// besides, and as the motion of a prismatic joint itself.
    pub(super) fn tip(&self, k: usize, size: f64) -> Unit {
        let is_linear = k % 6 < 3;
        let lever = self.scale.position.max(1.0);
        (if is_linear { size * lever } else { size }, None)
    }

    /// A column of the momentum matrix belongs to a joint.
    pub(super) fn momentum(&self, k: usize) -> Unit {
        let sizes = self.scale.momentum(self.scale.fastest);
        (sizes[k % 6 / 3], Some(k / 6 % self.joints()))
    }

    /// The rate of a momentum at constant velocities.
    pub(super) fn momentum_rate(&self, k: usize) -> Unit {
        let speed = self.scale.fastest * self.qd.amax();
        (self.scale.momentum(speed * speed)[k / 3], None)
    }
}

/// Numeric values that are put together.
impl<'a> At<'a> {
    pub(super) fn new(
        numeric: &'a NumericArm<Dyn>,
        table: &'a RuntimeTable,
        state: &'a SizedState<Dyn>,
        tau: &'a DVector<f64>,
    ) -> Self {
        let SizedState { q, qd, qdd } = state;
        let mass_matrix = numeric.mass_matrix(q);
        At {
            scale: Scale::new(table.arm(), &mass_matrix, state),
            datum: 0.0,
            numeric,
            table,
            state,
            q,
            qd,
            qdd,
            tau,
            frame: None,
            mass_matrix,
        }
    }

    /// Whether the table has room for the frame: it has room for 16 frames where it is an array.
    pub(super) fn has_frame(&self) -> bool {
        self.frame
            .is_none_or(|frame| frame < self.table.frames.len())
    }

    /// The transform of the tip, or of the frame.
    pub(super) fn tip_pose(&self) -> Matrix4<f64> {
        match self.frame {
            None => self.numeric.forward_kinematics(self.q),
            Some(frame) => self.numeric.frame_pose(frame, self.q),
        }
    }

    /// The Jacobian of the tip, or of the frame.
    pub(super) fn tip_jacobian(&self) -> Matrix6xX<f64> {
        match self.frame {
            None => self.numeric.jacobian(self.q),
            Some(frame) => self.numeric.frame_jacobian(frame, self.q),
        }
    }

    /// The rate of that Jacobian.
    pub(super) fn tip_jacobian_rate(&self) -> Matrix6xX<f64> {
        match self.frame {
            None => self.numeric.jacobian_rate(self.q, self.qd),
            Some(frame) => self.numeric.frame_jacobian_rate(frame, self.q, self.qd),
        }
    }

    /// d tau/dq and d tau/dqd.
    pub(super) fn force_derivatives(&self) -> (DMatrix<f64>, DMatrix<f64>) {
        self.numeric
            .inverse_dynamics_derivatives(self.q, self.qd, self.qdd)
    }

    /// B(q) by columns: V is quadratic in qd, so that its polarisation `V(e_j + e_k) - V(e_j) - V(e_k)` is the column
    /// of the pair (j, k).
    pub(super) fn coriolis_coefficients(&self) -> Vec<DVector<f64>> {
        let squares = self.centrifugal_coefficients();
        let pairs = (0..self.joints()).flat_map(|j| (j + 1..self.joints()).map(move |k| (j, k)));
        let column = |(j, k)| {
            let both = self
                .numeric
                .coriolis_vector(self.q, &(self.unit(j) + self.unit(k)));
            both - squares.column(j) - squares.column(k)
        };
        pairs.map(column).collect()
    }

    /// C(q): column j is V at the unit velocity of joint j.
    pub(super) fn centrifugal_coefficients(&self) -> DMatrix<f64> {
        let mut coefficients = DMatrix::zeros(self.joints(), self.joints());
        for j in 0..self.joints() {
            let column = self.numeric.coriolis_vector(self.q, &self.unit(j));
            coefficients.set_column(j, &column);
        }
        coefficients
    }

    /// U without the energy in the springs.
    pub(super) fn gravity_energy(&self) -> f64 {
        let energy = |moving: Moving<'_>| {
            let position = moving.factor * self.q[moving.joint] + moving.offset;
            moving.row.spring.energy(position)
        };
        let springs: f64 = self.table.arm().chain().map(energy).sum();
        self.numeric.potential_energy(self.q) - springs
    }

    /// K + F.
    pub(super) fn joint_forces(&self) -> DVector<f64> {
        self.numeric.spring_vector(self.q) + self.numeric.friction_vector(self.qd)
    }

    /// M qdd_r + C qd_r + G for the reference motion of the state.
    pub(super) fn passivity(&self) -> DVector<f64> {
        let coriolis = self.numeric.coriolis_matrix(self.q, self.qd);
        &self.mass_matrix * self.state.reference_acceleration()
            + coriolis * self.state.reference_velocity()
            + self.numeric.gravity_vector(self.q)
    }

    fn unit(&self, joint: usize) -> DVector<f64> {
        DVector::from_fn(self.joints(), |i, _| if i == joint { 1.0 } else { 0.0 })
    }
}
