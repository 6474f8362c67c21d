//! Linear momentum, and angular momentum about the centre of mass.
//!
//! Source: D. E. Orin, A. Goswami, S.-H. Lee, *Centroidal dynamics of a humanoid robot*, Autonomous Robots 35 (2013), 161-176.

use dynamics_runtime::Size;
use nalgebra::{Vector3, Vector6};

use super::Placed;
use super::kinematics::joined;

impl<D: Size, V: Size> Placed<'_, '_, D, V> {
    /// A body with its centre at c_k has `m v_k` and `(c_k - c) x m v_k + I w_k`.
    pub(crate) fn centroidal_momentum_matrix(&self, q: &D::Vector) -> V::Columns<6> {
        let (poses, whole) = (self.poses(q), self.center_of_mass(q));
        let mut matrix = self.arm.freedoms.columns();
        self.bodies(&poses, |body| {
            let tensor = body.tensor();
            self.columns(body.link, &body.center, &poses, |j, velocity| {
                let [linear, angular] = [0, 3].map(|k| velocity.fixed_rows::<3>(k).into_owned());
                let momentum = linear * body.mass;
                let about = (body.center - whole).cross(&momentum) + tensor * angular;
                let momenta = joined(&momentum, &about);
                (0..6).for_each(|row| matrix[(row, j)] += momenta[row]);
            });
        });
        matrix
    }

    /// By Newton and Euler for each body.
    pub(crate) fn centroidal_momentum_bias(&self, q: &D::Vector, qd: &V::Vector) -> Vector6<f64> {
        let still = self.arm.freedoms.vector();
        let rates = [qd, &still, &still, &still];
        let (_, wrench) = self.arm.force_rates(q, rates, &Vector3::zeros());
        let place = &self.base.place;
        let [force, moment] = wrench.map(|[value, ..]| place.rotation * value);
        let arm = self.center_of_mass(q) - place.position;
        joined(&force, &(moment - arm.cross(&force)))
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;
    use dynamics_runtime::{Convention, FloatingBase, Pose, State, Table};
    use nalgebra::SVector;
    use tables::{general_table, mounted_table, random_state};

    use crate::{FloatingNewtonEuler, NewtonEuler};

    #[test]
    fn the_rate_of_momentum_is_its_slope() {
        for seed in 1..=10 {
            let arm = NewtonEuler::new(&mounted_table::<5>(Convention::Standard, seed));
            let State { q, qd, .. } = random_state::<5>(seed);
            let h = 1e-5;
            let [after, before] =
                [h, -h].map(|h| arm.centroidal_momentum_matrix(&(q + qd * h)) * qd);
            let slope = (after - before) / (2.0 * h);
            let scale = 1.0 + slope.amax();
            let bias = arm.centroidal_momentum_bias(&q, &qd);
            assert_abs_diff_eq!(bias, slope, epsilon = 1e-7 * scale);
        }
    }

    /// The same on a base that moves, has no mass and is held.
    #[test]
    fn a_base_without_mass_has_no_momentum() {
        for seed in 1..=10 {
            let table = general_table::<5>(Convention::Modified, seed);
            let floating = Some(FloatingBase {
                mass: 0.0,
                com: [0.0; 3],
                inertia: [0.0; 6],
            });
            let arm = NewtonEuler::new(&table);
            let robot = FloatingNewtonEuler::<5, 11>::new(&Table { floating, ..table });
            let State { q, qd, .. } = random_state::<5>(seed);
            let (base, mut v) = (Pose::identity(), SVector::<f64, 11>::zeros());
            v.fixed_rows_mut::<5>(6).copy_from(&qd);
            let matrix = robot.centroidal_momentum_matrix(&base, &q);
            let of_joints = matrix.fixed_columns::<5>(6).into_owned();
            let expected = arm.centroidal_momentum_matrix(&q);
            assert_abs_diff_eq!(
                of_joints,
                expected,
                epsilon = 1e-12 * (1.0 + expected.amax())
            );
            let bias = robot.centroidal_momentum_bias(&base, &q, &v);
            let expected = arm.centroidal_momentum_bias(&q, &qd);
            assert_abs_diff_eq!(bias, expected, epsilon = 1e-12 * (1.0 + expected.amax()));
        }
    }
}
