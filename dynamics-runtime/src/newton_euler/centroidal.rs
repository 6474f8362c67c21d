//! The momentum of all links about their centre of mass.

use nalgebra::{Vector3, Vector6};

use super::NumericArm;
use super::inertia::Wrench;
use super::kinematics::{center, column, joined};
use crate::size::Size;

impl<D: Size> NumericArm<D> {
    /// Centroidal momentum matrix: `A qd` is the linear momentum of all links, of the tool and of the bodies of frames, then
    /// their angular momentum about the centre of mass, in the world.
    ///
    /// Column i is the sum over the links beyond joint i, of `m v` and `I w + (c - r) x m v`. With r at the centre of mass, v
    /// and w are those of unit speed of the joint.
    pub fn centroidal_momentum_matrix(&self, q: &D::Vector) -> D::Columns<6> {
        let (poses, center_of_mass) = (self.poses_in_world(q), self.center_of_mass(q));
        let mut matrix = self.size.columns();
        self.walk_outward(|body| {
            let (link, pose) = (body.link, &poses[body.k]);
            let center = center(link, pose);
            self.walk_to_base(body.k, |place| {
                let motion = column(place.link, &poses[place.k], &center);
                let [velocity, turning] =
                    [0, 3].map(|first| motion.fixed_rows::<3>(first).into_owned());
                let linear = velocity * link.mass;
                let own = pose.rotation * (link.tensor * pose.rotation.tr_mul(&turning));
                let momentum = joined(&linear, &(own + (center - center_of_mass).cross(&linear)));
                place.add_column(&mut matrix, 6, |row| momentum[row]);
            });
        });
        matrix
    }

    /// Rate of `A qd` at constant qd: the forces on all links without gravity, then their moment about the centre of mass.
    pub fn centroidal_momentum_bias(&self, q: &D::Vector, qd: &D::Vector) -> Vector6<f64> {
        let mut wrenches = self.per_link(Wrench::ZERO);
        let (still, weightless) = (self.size.vector(), Vector3::zeros());
        self.at(q, |joints| {
            self.move_frames(joints, [qd, &still], &weightless, |place, motion| {
                let inertia = &place.link.inertia;
                wrenches[place.k] = inertia.wrench(&motion.linear_acceleration, &motion.spread);
            });
        });
        let (poses, center_of_mass) = (self.poses_in_world(q), self.center_of_mass(q));
        let mut bias = Vector6::zeros();
        self.walk_outward(|place| {
            let (pose, Wrench { force, moment }) = (&poses[place.k], &wrenches[place.k]);
            let force = pose.rotation * force;
            let lever = pose.position - center_of_mass;
            bias += joined(&force, &(pose.rotation * moment + lever.cross(&force)));
        });
        bias
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;
    use nalgebra::SMatrix;

    use super::super::NewtonEuler;
    use crate::test_arms::{general_table, random_state};
    use crate::{Convention, JointType, Row, State, Table};

    /// The upper half of A is m J of the centre of mass, and at constant qd `A qd` changes at the rate of the bias.
    #[test]
    fn momentum_is_that_of_the_center_of_mass_and_changes_by_the_bias() {
        for (convention, seed) in [Convention::Standard, Convention::Modified]
            .into_iter()
            .flat_map(|convention| (1..=20).map(move |seed| (convention, seed)))
        {
            let table = general_table(convention, seed);
            let arm = NewtonEuler::new(&table);
            let State { q, qd, .. } = random_state::<6>(seed);
            let matrix = arm.centroidal_momentum_matrix(&q);
            let linear: SMatrix<f64, 3, 6> = matrix.fixed_rows::<3>(0).into_owned();
            let by_center = arm.center_of_mass_jacobian(&q) * table.total_mass();
            assert_abs_diff_eq!(linear, by_center, epsilon = 1e-12 * matrix.amax());

            // An error of h^4 beside one of rounding over h.
            let at = |h: f64| arm.centroidal_momentum_matrix(&(q + qd * h)) * qd;
            let slope = |h: f64| (at(h) - at(-h)) / (2.0 * h);
            let h = 1e-3;
            let rate = (slope(h) * 4.0 - slope(2.0 * h)) / 3.0;
            let bias = arm.centroidal_momentum_bias(&q, &qd);
            assert_abs_diff_eq!(bias, rate, epsilon = 1e-8 * bias.amax());
        }
    }

    /// A rod that turns about its end has its own inertia about the centre of mass.
    #[test]
    fn a_rod_about_its_center_of_mass() {
        let (m, a) = (1.7, 0.9);
        let rod = Row {
            a,
            mass: m,
            com: [-a / 2.0, 0.0, 0.0],
            inertia: [0.0, m * a * a / 12.0, m * a * a / 12.0, 0.0, 0.0, 0.0],
            ..Row::new(JointType::Revolute)
        };
        let arm = NewtonEuler::new(&Table::new(Convention::Standard, [0.0; 3], [rod]));
        let State { q, qd, .. } = random_state::<1>(3);
        let (s, c) = q[0].sin_cos();
        let lever = m * a / 2.0;
        let column = [-lever * s, lever * c, 0.0, 0.0, 0.0, m * a * a / 12.0];
        let matrix = arm.centroidal_momentum_matrix(&q);
        assert_abs_diff_eq!(matrix, SMatrix::from(column), epsilon = 1e-15);
        let square = qd[0] * qd[0];
        let bias = [-lever * c * square, -lever * s * square, 0.0, 0.0, 0.0, 0.0];
        let found = arm.centroidal_momentum_bias(&q, &qd);
        assert_abs_diff_eq!(found, SMatrix::from(bias), epsilon = 1e-14);
    }
}
