//! Motions of the tip and of the other links, and what a wrench at the tip does: derivatives of poses.

use super::super::assignment::Number;
use super::super::dual::Dual;
use super::derivatives::transpose;
use super::elimination::{pivots, solve};
use super::equations::product;
use super::kinematics::velocity;
use super::pose::{Lift, Position};
use super::{Definition, Matrix, Vector};

impl Definition {
    /// J' w
    pub(super) fn wrench_torques(&self) -> Vector {
        product(&transpose(&self.jacobian()), &self.wrench)
    }

    /// The rate of the tip's pose along the motion.
    pub(super) fn tool_velocity(&self) -> Vector {
        let moving = self.moving(&self.q, &self.qd);
        self.velocity_of_tip(&moving).to_vec()
    }

    /// The rate of that velocity, where the velocities of the joints change at the rate qdd.
    pub(super) fn tool_acceleration(&self) -> Vector {
        let velocity = self.velocity_of_tip(&self.accelerating());
        velocity.map(|x| x.derivative).to_vec()
    }

    /// By rows: the rate of each column of the Jacobian along the motion.
    pub(super) fn jacobian_rate(&self) -> Vector {
        let column = |j: usize| -> Vector {
            let along_motion = self.moving(&self.q, &self.qd);
            let velocity = self.velocity_of_tip(&self.moving(&along_motion, &self.unit(j)));
            velocity.iter().map(|x| x.derivative).collect()
        };
        let columns: Matrix = (0..self.dof()).map(column).collect();
        transpose(&columns).concat()
    }

    /// By rows, link by link: the velocities of the frames of all links whose joints move.
    pub(super) fn link_jacobians(&self) -> Vector {
        let columns: Vec<_> = (0..self.dof())
            .map(|j| self.poses(&self.along(j)))
            .collect();
        let of_link = |(i, _): (usize, &super::Row)| {
            let velocities = columns.iter().map(|poses| velocity(&poses[i]).to_vec());
            transpose(&velocities.collect()).concat()
        };
        self.joints().flat_map(of_link).collect()
    }

    /// J M^-1 J' by rows, the pivots, and the diagonal of M. Where M is identically singular there are
    /// no values: anything that the program computes there is right.
    pub(super) fn operational_inertia_inverse(&self, computed: &[Option<Number>]) -> Vector {
        let matrix = self.mass_matrix(&self.q);
        let jacobian = self.jacobian();
        let values: Vec<Option<Number>> = match solve(matrix.clone(), transpose(&jacobian)) {
            Some(x) => {
                let columns = transpose(&x);
                let rows = jacobian.iter().map(|row| product(&columns, row));
                rows.flatten().map(Some).collect()
            }
            None => vec![None; 36],
        };
        let diagonal = (0..self.dof()).map(|i| Some(matrix[i][i]));
        let known = values
            .into_iter()
            .chain(pivots(matrix.clone()))
            .chain(diagonal);
        let expected = known.enumerate().map(|(k, known)| {
            let computed = computed.get(k).copied().flatten();
            known.or(computed).unwrap_or(Number::ZERO)
        });
        expected.collect()
    }

    /// vx vy vz wx wy wz of the tip in the world.
    fn velocity_of_tip<R: Lift>(&self, moving: &[Position<Dual<R>>]) -> [R; 6] {
        velocity(&self.tip(&self.poses(moving)))
    }
}
