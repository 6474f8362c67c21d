//! The crate dynibo, on a URDF of the same arm.
//!
//! It does a little less than the generated functions: it knows neither reflected inertias nor
//! friction, and its gravity is fixed at 9.80665 m/s^2. [`Candidate::values`] makes that good, so
//! that values and errors are those of the same arm; what is timed is dynibo alone.

use std::fmt::Write;

use dynibo::{Frame, Robot};
use nalgebra_of_dynibo as other;
use robot_dynamics::nalgebra::{Matrix3, Rotation3, SMatrix, SVector, Vector3};
use robot_dynamics::{
    NewtonEuler, State,
    table::{Convention, JointType, Table},
};

use super::{Candidate, Values};

/// The strength of gravity in dynibo, m/s^2.
const GRAVITY: f64 = 9.80665;

pub(crate) struct Dynibo<const N: usize> {
    robot: Robot,
    numeric: NewtonEuler<N>,
    reflected_inertias: SVector<f64, N>,
    /// The table's gravity over dynibo's.
    gravity: f64,
    vector: SVector<f64, N>,
    matrix: SMatrix<f64, N, N>,
}

impl<const N: usize> Dynibo<N> {
    pub(crate) fn new(name: &str, table: &Table<N>) -> Self {
        let file = std::env::temp_dir().join(format!("{name}-{}.urdf", std::process::id()));
        std::fs::write(&file, urdf(table)).unwrap();
        let mut robot = Robot::from_urdf(&file).unwrap();
        std::fs::remove_file(&file).unwrap();
        let gravity = Vector3::from(table.gravity);
        robot.set_base_frame(base_frame(&gravity)).unwrap();
        Dynibo {
            robot,
            numeric: NewtonEuler::new(table),
            reflected_inertias: SVector::from_fn(|i, _| table.rows[i].reflected_inertia()),
            gravity: gravity.norm() / GRAVITY,
            vector: SVector::zeros(),
            matrix: SMatrix::zeros(),
        }
    }
}

/// The base so turned that gravity points down.
fn base_frame(gravity: &Vector3<f64>) -> Frame {
    let gravity = other::Vector3::new(gravity.x, gravity.y, gravity.z);
    let turn = other::UnitQuaternion::rotation_between(&gravity, &-other::Vector3::z()).unwrap();
    Frame::from_parts(other::Translation3::identity(), turn)
}

/// The arm with a frame on each joint's own axis, which is what a URDF wants.
fn urdf<const N: usize>(table: &Table<N>) -> String {
    let mut text = String::from("<robot name='arm'>\n<link name='link0'/>\n");
    for (i, row) in table.rows.iter().enumerate() {
        // Rx(alpha) Tx(a): in front of the joint, or behind it and so in front of the next.
        let along_x = |row: &robot_dynamics::table::Row| {
            let turn = Rotation3::from_axis_angle(&Vector3::x_axis(), row.alpha);
            (turn, Vector3::new(row.a, 0.0, 0.0))
        };
        let none = (Rotation3::identity(), Vector3::zeros());
        let ((before, place), (after, shift)) = match table.convention {
            Convention::Modified => (along_x(row), none),
            Convention::Standard if i == 0 => (none, along_x(row)),
            Convention::Standard => (along_x(&table.rows[i - 1]), along_x(row)),
        };
        let origin = place + before * Vector3::new(0.0, 0.0, row.d);
        let turn = before * Rotation3::from_axis_angle(&Vector3::z_axis(), row.theta);
        let (roll, pitch, yaw) = turn.euler_angles();
        let kind = match row.joint_type {
            JointType::Revolute => "revolute",
            JointType::Prismatic => "prismatic",
        };
        let com = shift + after * Vector3::from(row.com);
        let [xx, yy, zz, xy, yz, xz] = row.inertia;
        let tensor = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        let tensor = after.matrix() * tensor * after.matrix().transpose();
        let (x, y, z) = (origin.x, origin.y, origin.z);
        writeln!(
            text,
            "<joint name='joint{i}' type='{kind}'><parent link='link{i}'/><child link='link{}'/>
             <origin xyz='{x} {y} {z}' rpy='{roll} {pitch} {yaw}'/><axis xyz='0 0 1'/>
             <limit lower='-1e9' upper='1e9' effort='1e9' velocity='1e9'/></joint>
             <link name='link{}'><inertial><mass value='{}'/><origin xyz='{} {} {}'/>
             <inertia ixx='{}' iyy='{}' izz='{}' ixy='{}' iyz='{}' ixz='{}'/></inertial></link>",
            i + 1,
            i + 1,
            row.mass,
            com.x,
            com.y,
            com.z,
            tensor.m11,
            tensor.m22,
            tensor.m33,
            tensor.m12,
            tensor.m23,
            tensor.m13,
        )
        .unwrap();
    }
    text + "</robot>\n"
}

impl<const N: usize> Candidate<N> for Dynibo<N> {
    const NAME: &'static str = "dynibo";

    fn inverse_dynamics(
        &mut self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        qdd: &SVector<f64, N>,
    ) -> SVector<f64, N> {
        let (q, qd, qdd) = (q.as_slice(), qd.as_slice(), qdd.as_slice());
        let output = self.vector.as_mut_slice();
        self.robot
            .inverse_dynamics(q, qd, qdd, &[], output)
            .unwrap();
        self.vector
    }

    fn mass_matrix(&mut self, q: &SVector<f64, N>) -> SMatrix<f64, N, N> {
        let output = self.matrix.as_mut_slice();
        self.robot.mass_matrix(q.as_slice(), output).unwrap();
        self.matrix
    }

    fn coriolis_vector(&mut self, q: &SVector<f64, N>, qd: &SVector<f64, N>) -> SVector<f64, N> {
        let (q, qd) = (q.as_slice(), qd.as_slice());
        let output = self.vector.as_mut_slice();
        self.robot.velocity_product_forces(q, qd, output).unwrap();
        self.vector
    }

    fn gravity_vector(&mut self, q: &SVector<f64, N>) -> SVector<f64, N> {
        let output = self.vector.as_mut_slice();
        self.robot.gravity(q.as_slice(), &[], output).unwrap();
        self.vector
    }

    fn forward_dynamics(
        &mut self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
    ) -> Option<SVector<f64, N>> {
        let (q, qd, tau) = (q.as_slice(), qd.as_slice(), tau.as_slice());
        let output = self.vector.as_mut_slice();
        self.robot.forward_dynamics(q, qd, tau, &[], output).ok()?;
        Some(self.vector)
    }

    fn values(&mut self, state: &State<N>, tau: &SVector<f64, N>) -> Values<N> {
        let State { q, qd, qdd } = state;
        let own_gravity = self.gravity_vector(q);
        let friction = self.numeric.friction_vector(qd);
        // The torques that the table's arm needs in addition to dynibo's at accelerations x.
        let reflected = self.reflected_inertias;
        let ratio = self.gravity;
        let beyond = |x: &SVector<f64, N>| {
            reflected.component_mul(x) + friction + own_gravity * (ratio - 1.0)
        };
        // dynibo's arm is the table's where its torques are less by that, at the accelerations
        // that the table's arm has.
        let accelerations = self.numeric.forward_dynamics(q, qd, tau).unwrap();
        let own_torque = tau - beyond(&accelerations);
        Values {
            inverse_dynamics: self.inverse_dynamics(q, qd, qdd) + beyond(qdd),
            mass_matrix: self.mass_matrix(q) + SMatrix::from_diagonal(&reflected),
            coriolis_vector: self.coriolis_vector(q, qd),
            gravity_vector: own_gravity * ratio,
            forward_dynamics: self.forward_dynamics(q, qd, &own_torque).unwrap(),
        }
    }
}
