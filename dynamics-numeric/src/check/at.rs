//! A state at which functions are compared.

use dynamics_runtime::internal::Moving;
use dynamics_runtime::table::AsArm as _;
use dynamics_runtime::{JointType, Pose, RuntimeTable, SizedState};
use nalgebra::{DMatrix, DVector, Dyn, Matrix4, Matrix6xX};

use super::scale::Scale;
use crate::newton_euler::Placed;

/// A state at which functions are compared, and the magnitudes of their values there.
pub(super) struct At<'a> {
    /// The numeric algorithms.
    pub(super) robot: Placed<'a, 'a, Dyn, Dyn>,
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
    /// The number of velocities: of joints, and six more where the base moves.
    pub(super) fn freedoms(&self) -> usize {
        self.qd.len()
    }

    /// How many velocities there are before those of the joints.
    pub(super) fn first(&self) -> usize {
        self.qd.len() - self.q.len()
    }

    /// Row i of a matrix belongs to velocity i.
    pub(super) fn joint(&self, k: usize, scale: f64) -> Unit {
        (scale, Some(k % self.freedoms()))
    }

    /// A list with so many numbers for each joint belongs to the joints.
    pub(super) fn each_joint(&self, k: usize, numbers: usize, scale: f64) -> Unit {
        (scale, Some(self.first() + k / numbers % self.q.len()))
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
    /// is the sum of that of a joint and of those that follow it, each times its factor. The base turns and is pushed along
    /// its three axes.
    pub(super) fn column(&self, k: usize) -> Unit {
        let velocity = k / 6 % self.freedoms();
        let Some(joint) = velocity.checked_sub(self.first()) else {
            let is_lever = k % 6 < 3 && velocity >= 3;
            return (
                if is_lever { self.scale.position } else { 1.0 },
                Some(velocity),
            );
        };
        let of_joint = self
            .table
            .arm()
            .chain()
            .filter(|moving| moving.joint == joint);
        let sizes = of_joint.map(|moving| {
            let is_lever = k % 6 < 3 && moving.row.joint_type == JointType::Revolute;
            moving.factor.abs() * if is_lever { self.scale.position } else { 1.0 }
        });
        (sizes.sum(), Some(velocity))
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
        (sizes[k % 6 / 3], Some(k / 6 % self.freedoms()))
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
        robot: Placed<'a, 'a, Dyn, Dyn>,
        table: &'a RuntimeTable,
        (base, state): (&'a Pose<f64>, &'a SizedState<Dyn>),
        tau: &'a DVector<f64>,
    ) -> Self {
        let SizedState { q, qd, qdd } = state;
        let mass_matrix = robot.mass_matrix(q);
        At {
            scale: Scale::new(table.arm(), &mass_matrix, base, state),
            datum: 0.0,
            robot,
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

    /// Whether the table has the frame: a hand-written robot may name others.
    pub(super) fn has_frame(&self) -> bool {
        self.frame
            .is_none_or(|frame| frame < self.table.frames.len())
    }

    /// The transform of the tip, or of the frame.
    pub(super) fn tip_pose(&self) -> Matrix4<f64> {
        self.robot.pose_at(self.frame, self.q)
    }

    /// The Jacobian of the tip, or of the frame.
    pub(super) fn tip_jacobian(&self) -> Matrix6xX<f64> {
        self.robot.jacobian_at(self.frame, self.q)
    }

    /// The rate of that Jacobian.
    pub(super) fn tip_jacobian_rate(&self) -> Matrix6xX<f64> {
        self.robot.jacobian_rate_at(self.frame, self.q, self.qd)
    }

    /// B(q) by columns: V is quadratic in qd, so that its polarisation `V(e_j + e_k) - V(e_j) - V(e_k)` is the column
    /// of the pair (j, k).
    pub(super) fn coriolis_coefficients(&self) -> Vec<DVector<f64>> {
        let squares = self.centrifugal_coefficients();
        let size = self.freedoms();
        let pairs = (0..size).flat_map(|j| (j + 1..size).map(move |k| (j, k)));
        let column = |(j, k)| {
            let both = self
                .robot
                .coriolis_vector(self.q, &(self.unit(j) + self.unit(k)));
            both - squares.column(j) - squares.column(k)
        };
        pairs.map(column).collect()
    }

    /// C(q): column j is V at the unit velocity of joint j.
    pub(super) fn centrifugal_coefficients(&self) -> DMatrix<f64> {
        let mut coefficients = DMatrix::zeros(self.freedoms(), self.freedoms());
        for j in 0..self.freedoms() {
            let column = self.robot.coriolis_vector(self.q, &self.unit(j));
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
        self.robot.potential_energy(self.q) - springs
    }

    /// K + F.
    pub(super) fn joint_forces(&self) -> DVector<f64> {
        self.robot.spring_vector(self.q) + self.robot.friction_vector(self.qd)
    }

    /// M qdd_r + C qd_r + G for the reference motion of the state.
    pub(super) fn passivity(&self) -> DVector<f64> {
        let coriolis = self.robot.coriolis_matrix(self.q, self.qd);
        &self.mass_matrix * self.state.reference_acceleration()
            + coriolis * self.state.reference_velocity()
            + self.robot.gravity_vector(self.q)
    }

    /// First and second derivative of the forces along the motion.
    pub(super) fn rates(&self) -> (DVector<f64>, DVector<f64>) {
        let (jerk, snap) = (self.state.jerk(), self.state.snap());
        (self.robot).inverse_dynamics_rates(self.q, self.qd, self.qdd, &jerk, &snap)
    }

    fn unit(&self, joint: usize) -> DVector<f64> {
        DVector::from_fn(self.freedoms(), |i, _| if i == joint { 1.0 } else { 0.0 })
    }
}
