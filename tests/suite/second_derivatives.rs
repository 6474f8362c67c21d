//! Second derivatives of the torques on dual numbers and in single precision.

use num_dual::{DualSVec64, jacobian};
use robot_dynamics::SecondDerivatives;
use robot_dynamics::nalgebra::{SMatrix, SVector};
use robots::*;
use testkit::random::Random;

fn four<T: Copy, const N: usize>(d: &SecondDerivatives<T, N>) -> [[SMatrix<T, N, N>; N]; 4] {
    [d.0, d.1, d.2, d.3]
}

/// The derivatives of the first derivatives and of M on vectors of dual numbers.
macro_rules! by_dual_numbers {
    ($robot:ident, $n:literal) => {
        let mut random = Random::seeded(37);
        let q: SVector<f64, $n> = random.vector(3.0);
        let qd: SVector<f64, $n> = random.vector(2.0);
        let qdd: SVector<f64, $n> = random.vector(5.0);
        let [at_q, at_qd, at_qdd] = [q, qd, qdd].map(|x| x.map(DualSVec64::from));
        let found = four(&$robot.inverse_dynamics_second_derivatives(&q, &qd, &qdd));
        let near = |found: &SMatrix<f64, $n, $n>, expected: SMatrix<f64, $n, $n>| {
            let bound = 1e-12 * expected.amax().max(1.0);
            assert!(
                (found - expected).amax() <= bound,
                "{found} is not {expected}"
            );
        };
        for i in 0..$n {
            let row = |m: SMatrix<DualSVec64<$n>, $n, $n>| m.row(i).transpose();
            let (_, by_position) = jacobian(
                |q| row($robot.inverse_dynamics_derivatives(&q, &at_qd, &at_qdd).0),
                &q,
            );
            near(&found[0][i], by_position);
            let (_, by_velocity) = jacobian(
                |qd| row($robot.inverse_dynamics_derivatives(&at_q, &qd, &at_qdd).1),
                &qd,
            );
            near(&found[1][i], by_velocity);
            let (_, by_both) = jacobian(
                |qd| row($robot.inverse_dynamics_derivatives(&at_q, &qd, &at_qdd).0),
                &qd,
            );
            near(&found[2][i], by_both);
            let (_, of_inertia) = jacobian(|q| row($robot.mass_matrix(&q)), &q);
            near(&found[3][i], of_inertia);
        }
        // Single precision, relative to the largest entry of each of the four.
        let single = $robot.inverse_dynamics_second_derivatives(
            &q.map(|x| x as f32),
            &qd.map(|x| x as f32),
            &qdd.map(|x| x as f32),
        );
        for (single, double) in four(&single).iter().zip(&found) {
            let size = double.iter().map(SMatrix::amax).fold(0.0, f64::max);
            for (single, double) in single.iter().zip(double) {
                let error = (single.map(f64::from) - double).amax();
                assert!(error <= 1e-5 * size, "{error:e} of {size:e}");
            }
        }
    };
}

#[test]
fn second_derivatives_are_those_of_dual_numbers() {
    by_dual_numbers!(TwoLinkSaha, 2);
    by_dual_numbers!(CylindricalRpp, 3);
    by_dual_numbers!(Scara, 4);
    by_dual_numbers!(SprungArm, 3);
}
