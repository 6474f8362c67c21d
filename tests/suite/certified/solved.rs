//! Solutions with M, bounded by residuals, beside 31 digits at the decimals of the tables.

use super::{Decimals, DoubleDouble, Ratios, State, exactly, largest, values};
use robot_dynamics::nalgebra::{SMatrix, SVector};
use robot_dynamics::{
    ForwardDynamics, InverseDynamics, MassMatrix, Scalar, SingularMassMatrix, certified,
};
use robots::*;
use testkit::random::Random;

/// The number of states; every eighth is far from zero.
const STATES: usize = 8;

/// Every function that solves with M, at some states of a robot.
macro_rules! solved {
    ($($test:ident: $robot:ident, $n:literal, $least:expr;)*) => {$(
        #[test]
        fn $test() {
            const NAMES: [&str; 5] = ["forward_dynamics_aba", "d qdd/dq", "d qdd/dqd", "M^-1", "J M^-1 J'"];
            let decimals = Decimals::of($robot.table());
            let mut random = Random::seeded(17);
            let mut ratios = [Ratios::default(); NAMES.len()];
            for number in 0..STATES {
                let State { q, qd, qdd } = State::<$n>::random(&mut random, number);
                let tau = $robot.inverse_dynamics(&q, &qd, &qdd);
                let [x, xd, force] = [&q, &qd, &tau].map(|x| x.map(DoubleDouble::from));
                let [cq, cqd, ctau] = [&q, &qd, &tau].map(exactly::<f64, $n>);

                let found = certified::forward_dynamics_aba(&$robot, &cq, &cqd, &ctau);
                let found = found.expect("regular");
                let plain = $robot.forward_dynamics_aba(&q, &qd, &tau).expect("regular");
                assert_eq!(values(&found), plain);
                let exact = decimals.exact(|exact| exact.forward_dynamics(&x, &xd, &force));
                ratios[0].add(&found, &exact, largest(&exact));

                let found = certified::forward_dynamics_derivatives(&$robot, &cq, &cqd, &ctau);
                let found = found.expect("regular");
                let plain = $robot.forward_dynamics_derivatives(&q, &qd, &tau).expect("regular");
                for (k, (found, plain)) in [(found.0, plain.0), (found.1, plain.1), (found.2, plain.2)].into_iter().enumerate() {
                    assert_eq!(values(&found), plain);
                    let exact = decimals.exact(|exact| exact.forward_dynamics_derivatives(&x, &xd, &force)[k]);
                    ratios[k + 1].add(&found, &exact, 1e3 * largest(&exact));
                }

                let found = certified::operational_inertia_inverse(&$robot, &cq).expect("regular");
                let plain = $robot.operational_inertia_inverse(&q).expect("regular");
                assert_eq!(values(&found), plain);
                let exact = decimals.exact(|exact| exact.operational_inertia_inverse(&x));
                ratios[4].add(&found, &exact, largest(&exact));
            }
            for (name, ratios) in NAMES.iter().zip(&ratios) {
                println!("{name:22} {:.4} in the mean, {:.3} at most", ratios.mean(), ratios.largest);
            }
            for (name, ratios) in NAMES.iter().zip(&ratios) {
                assert!(ratios.mean() >= $least, "{name}: {}", ratios.mean());
            }
        }
    )*};
}

solved! {
    puma560: Puma560, 6, super::LEAST_MEAN;
    panda: Panda, 7, 1.0 / 100.0;
    generic_chain_n7: GenericChain7, 7, 1.0 / 50_000.0;
}

/// A Panda whose accelerations and torques are wrong by a part of themselves.
struct Damaged {
    accelerations: f64,
    torques: f64,
}

impl ForwardDynamics<7> for Damaged {
    /// With a bound of its own that says nothing: the root of what may be less than zero.
    fn forward_dynamics<T: Scalar>(
        &self,
        q: &SVector<T, 7>,
        qd: &SVector<T, 7>,
        tau: &SVector<T, 7>,
    ) -> Result<SVector<T, 7>, SingularMassMatrix> {
        let tau = tau.map(|x| x / x.exact(1.0 + self.torques));
        let qdd = Panda.forward_dynamics(q, qd, &tau)?;
        Ok(qdd.map(|x| x.exact(1.0 + self.accelerations) * x + (x + -x).sqrt()))
    }
}

impl InverseDynamics<7> for Damaged {
    fn inverse_dynamics<T: Scalar>(
        &self,
        q: &SVector<T, 7>,
        qd: &SVector<T, 7>,
        qdd: &SVector<T, 7>,
    ) -> SVector<T, 7> {
        let tau = Panda.inverse_dynamics(q, qd, qdd);
        tau.map(|x| x.exact(1.0 + self.torques) * x)
    }
}

impl MassMatrix<7> for Damaged {
    fn mass_matrix<T: Scalar>(&self, q: &SVector<T, 7>) -> SMatrix<T, 7, 7> {
        Panda.mass_matrix(q)
    }
}

/// The largest error of accelerations over the bound, in the mean of some states.
fn errors_over_bounds(arm: &Damaged) -> f64 {
    let mut random = Random::seeded(19);
    let decimals = Decimals::of(Panda.table());
    let ratio = |number| {
        let State { q, qd, qdd } = State::<7>::random(&mut random, number);
        let tau = Panda.inverse_dynamics(&q, &qd, &qdd);
        let [x, xd, force] = [&q, &qd, &tau].map(|x| x.map(DoubleDouble::from));
        let [q, qd, tau] = [&q, &qd, &tau].map(exactly::<f64, 7>);
        let found = certified::forward_dynamics(arm, &q, &qd, &tau).expect("regular");
        let exact = decimals.exact(|exact| exact.forward_dynamics(&x, &xd, &force));
        let ratios = found.zip_map(&exact, |found, exact| {
            (DoubleDouble::from(found.value()) - exact).abs().high() / found.bound()
        });
        ratios.max()
    };
    let ratios: Vec<f64> = (0..STATES).map(ratio).collect();
    println!("{ratios:.3?}");
    ratios.iter().sum::<f64>() / STATES as f64
}

/// The residual knows how wrong accelerations are, whatever they come from. Equations that are wrong themselves, forward
/// and inverse dynamics alike, are found by the comparison with 31 digits.
#[test]
fn wrong_accelerations_are_bounded_and_wrong_torques_found() {
    let sound = Damaged {
        accelerations: 0.0,
        torques: 0.0,
    };
    assert!(errors_over_bounds(&sound) < 1.0);
    for accelerations in [1e-11, 1e-6, 1.0] {
        let ratio = errors_over_bounds(&Damaged {
            accelerations,
            ..sound
        });
        assert!((0.5..1.0).contains(&ratio), "{accelerations:e}: {ratio}");
    }
    let ratio = errors_over_bounds(&Damaged {
        torques: 1e-13,
        ..sound
    });
    assert!(ratio > 1.0, "{ratio}");
}
