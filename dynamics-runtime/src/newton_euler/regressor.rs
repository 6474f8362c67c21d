//! Torques as a linear function of the links' mass properties.
//!
//! Source: C. G. Atkeson, C. H. An, J. M. Hollerbach, *Estimation of inertial parameters of manipulator
//! loads and links*, Int. J. Robotics Research 5 (1986), 101-119: Newton-Euler is linear in a link's mass,
//! its first moments and its inertia about the origin of its frame.

use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

use super::NewtonEuler;
use super::inertia::Inertia;
use super::pose::Pose;
use crate::{Row, Table};

/// The standard parameters of a link, in its frame of the table and about that frame's origin: mass m in kg,
/// first moments m c_x, m c_y, m c_z in kg m, and the inertia tensor's J_xx, J_yy, J_zz, J_xy, J_yz, J_xz in
/// kg m^2.
pub type StandardParameters = SVector<f64, 10>;

impl<const N: usize> Table<N> {
    /// The ten standard inertial parameters of the link of each joint, the tool among those of the last link.
    ///
    /// They do not include motors, springs and friction. The links of joints that follow others are in
    /// [`standard_parameters_of_followers`](Table::standard_parameters_of_followers).
    pub fn standard_parameters(&self) -> [StandardParameters; N] {
        let mut rows = self.rows;
        let is_last = self.followers.iter().all(|follower| follower.place < N);
        if let Some(last) = rows.last_mut().filter(|_| is_last) {
            *last = self.tool.joined(last);
        }
        rows.each_ref().map(parameters)
    }

    /// The same of the links of the joints that follow others, in the order of [`Table::followers`].
    pub fn standard_parameters_of_followers(&self) -> impl Iterator<Item = StandardParameters> {
        let count = self.followers.iter().count();
        let followers = self.followers.iter().enumerate();
        followers.map(move |(k, follower)| {
            let is_last = k + 1 == count && follower.place == N;
            match is_last {
                true => parameters(&self.tool.joined(&follower.row)),
                false => parameters(&follower.row),
            }
        })
    }
}

/// The standard parameters of a row's link.
fn parameters(row: &Row) -> StandardParameters {
    let (m, c) = (row.mass, Vector3::from(row.com));
    let [xx, yy, zz, xy, yz, xz] = row.inertia;
    SVector::from([
        m,
        m * c.x,
        m * c.y,
        m * c.z,
        xx + m * (c.y * c.y + c.z * c.z),
        yy + m * (c.z * c.z + c.x * c.x),
        zz + m * (c.x * c.x + c.y * c.y),
        xy - m * c.x * c.y,
        yz - m * c.y * c.z,
        xz - m * c.z * c.x,
    ])
}

impl Inertia {
    /// Of a body with one of the standard parameters, which is 1: `S = tr(J)/2 1 - J`.
    fn unit(parameter: usize) -> Self {
        let mut inertia = Inertia::ZERO;
        let s = &mut inertia.second_moment;
        match parameter {
            0 => inertia.mass = 1.0,
            1..=3 => inertia.first_moment[parameter - 1] = 1.0,
            4..=6 => {
                s.fill_diagonal(0.5);
                s[(parameter - 4, parameter - 4)] = -0.5;
            }
            _ => {
                let (i, j) = [(0, 1), (1, 2), (0, 2)][parameter - 7];
                (s[(i, j)], s[(j, i)]) = (-1.0, -1.0);
            }
        }
        inertia
    }

    /// In the frame where its own is placed, about that frame's origin p: `h' = R h + m p`,
    /// `S' = R S R^T + p (R h)^T + (R h) p^T + m p p^T`.
    fn placed(&self, Pose { rotation, position }: &Pose) -> Self {
        let (r, p) = (rotation, position);
        let turned = r * self.first_moment;
        let crossed: Matrix3<f64> = p * turned.transpose();
        Inertia {
            mass: self.mass,
            first_moment: turned + p * self.mass,
            second_moment: r * self.second_moment * r.transpose()
                + crossed
                + crossed.transpose()
                + p * p.transpose() * self.mass,
        }
    }
}

impl<const N: usize> NewtonEuler<N> {
    /// The standard regressor, a block of ten columns for each link: with the
    /// [standard parameters](Table::standard_parameters) x_k of the links,
    ///
    /// `sum_k Y_k x_k = M qdd + V + G - J qdd`,
    ///
    /// the torques without friction, springs and the reflected inertias J of the motors.
    ///
    /// `q` in rad or m, `qd` per second, `qdd` per second squared. None of the columns depends on the
    /// masses of the table. They are not independent: [`base_parameter_map`](crate::base_parameter_map) says
    /// which combinations a motion shows. Input that is not finite propagates; never panics, never allocates.
    ///
    /// Where joints follow others, the terms of their links belong to the sum too
    /// ([`standard_regressor_of_followers`](NewtonEuler::standard_regressor_of_followers)), and the motor of a follower
    /// adds factor^2 times its reflected inertia to J of the joint that leads.
    pub fn standard_regressor(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        qdd: &SVector<f64, N>,
    ) -> [SMatrix<f64, N, 10>; N] {
        if let Some(coupled) = &self.coupled {
            return coupled.standard_regressor(q, qd, qdd).0;
        }
        let joints = self.joints(q);
        let motions = self.motions(&joints, qd, qdd, &self.gravity);
        let mut blocks = [SMatrix::zeros(); N];
        for (k, link) in self.links().iter().enumerate() {
            for parameter in 0..10 {
                let inertia = Inertia::unit(parameter).placed(&link.table_frame);
                let (acceleration, spread) = &motions[k];
                let mut wrench = inertia.wrench(acceleration, spread);
                for i in (0..=k).rev() {
                    blocks[k][(i, parameter)] = wrench.along_joint(self.links[i].joint_type);
                    wrench = wrench.inward(&joints[i]);
                }
            }
        }
        blocks
    }

    /// The blocks of the [standard regressor](Self::standard_regressor) for the links of joints that follow others, in
    /// the order of [their parameters](Table::standard_parameters_of_followers). Empty where nothing is coupled.
    pub fn standard_regressor_of_followers(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        qdd: &SVector<f64, N>,
    ) -> impl Iterator<Item = SMatrix<f64, N, 10>> + use<N> {
        let coupled = self.coupled.as_ref();
        let blocks = coupled.map(|coupled| coupled.standard_regressor(q, qd, qdd).1);
        blocks.into_iter().flatten().flatten()
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;

    use crate::test_arms::{mounted_table, random_state};
    use crate::{Convention, NewtonEuler, State};

    /// On arms with joints of both kinds, no zero cell and a tool, in both conventions.
    #[test]
    fn the_regressor_times_the_parameters_is_the_torque() {
        for seed in 0..20 {
            let convention = [Convention::Standard, Convention::Modified][seed as usize % 2];
            let table = mounted_table::<4>(convention, seed);
            let arm = NewtonEuler::new(&table);
            let State { q, qd, qdd } = random_state(seed);
            let blocks = arm.standard_regressor(&q, &qd, &qdd);
            let terms = blocks.iter().zip(table.standard_parameters());
            let links = terms.fold(SVector::zeros(), |sum, (y, x)| sum + y * x);
            let motors = SVector::from_fn(|i, _| table.rows[i].reflected_inertia() * qdd[i]);
            let tau = links + motors + arm.friction_vector(&qd) + arm.spring_vector(&q);
            let expected = arm.inverse_dynamics(&q, &qd, &qdd);
            let error = (tau - expected).amax() / expected.amax();
            assert!(error < 1e-13, "{seed}: {error:e}");
        }
    }
}
