//! The order of every method of fixed step on an arm.

use robot_dynamics::nalgebra::Vector2;
use robot_dynamics::{ForwardDynamics, Method, Simulation, simulation::Dop853};

use crate::arms::TwoLink;

/// Where the two links are after a fall of half a second.
fn fall(method: Method) -> [f64; 4] {
    let start = Simulation::new(&TwoLink).initial(Vector2::new(0.3, -0.8), Vector2::new(1.0, 2.0));
    let run = start.duration(0.5).samples(2).method(method).run().unwrap();
    [run.q[1][0], run.q[1][1], run.qd[1][0], run.qd[1][1]]
}

/// The slope of the line through the logarithms of step and error, by least squares.
fn slope(points: &[(f64, f64)]) -> f64 {
    let n = points.len() as f64;
    let logs = points.iter().map(|(h, error)| (h.ln(), error.ln()));
    let (x, y) = logs
        .clone()
        .fold((0.0, 0.0), |(x, y), log| (x + log.0, y + log.1));
    let (x, y) = (x / n, y / n);
    let moments = logs.map(|log| ((log.0 - x) * (log.1 - y), (log.0 - x).powi(2)));
    let (xy, xx) = moments.fold((0.0, 0.0), |sum, m| (sum.0 + m.0, sum.1 + m.1));
    xy / xx
}

#[track_caller]
fn check_order(method: fn(f64) -> Method, steps: [u32; 4], order: f64) {
    let exact = fall(Dop853::with_tolerance(1e-14).into());
    let points = steps.map(|steps| {
        let h = 0.5 / f64::from(steps);
        let errors = fall(method(h))
            .into_iter()
            .zip(exact)
            .map(|(a, b)| (a - b).abs());
        (h, errors.fold(0.0, f64::max))
    });
    let slope = slope(&points);
    assert!(
        (slope - order).abs() < 0.1 * order.sqrt(),
        "{slope}: {points:?}"
    );
}

#[test]
fn orders_are_those_of_the_methods() {
    let many = [100, 200, 400, 800];
    check_order(|step| Method::ExplicitEuler { step }, many, 1.0);
    check_order(|step| Method::CraigEuler { step }, many, 1.0);
    check_order(|step| Method::SemiImplicitEuler { step }, many, 1.0);
    check_order(|step| Method::RungeKutta4 { step }, [25, 50, 100, 200], 4.0);
    check_order(
        |step| Method::ImplicitMidpoint { step },
        [25, 50, 100, 200],
        2.0,
    );
    check_order(
        |step| Method::GaussLegendre4 { step },
        [25, 50, 100, 200],
        4.0,
    );
    check_order(
        |step| Method::GaussLegendre6 { step },
        [20, 30, 40, 60],
        6.0,
    );
}

/// An arm that is not known in momenta is refused by the methods that work in them.
#[test]
fn momenta_are_asked_for() {
    use robot_dynamics::nalgebra::{SVector, Vector1};
    use robot_dynamics::{
        Scalar, SingularMassMatrix,
        simulation::{Cause, InvalidSetting},
    };
    struct Cart;
    impl ForwardDynamics<1> for Cart {
        fn forward_dynamics<T: Scalar>(
            &self,
            _: &SVector<T, 1>,
            _: &SVector<T, 1>,
            tau: &SVector<T, 1>,
        ) -> Result<SVector<T, 1>, SingularMassMatrix> {
            Ok(Vector1::new(tau[0]))
        }
    }
    let method = Method::GaussLegendre4 { step: 0.1 };
    let error = Simulation::new(&Cart).method(method).run().unwrap_err();
    assert_eq!(
        error.cause,
        Cause::InvalidSetting(InvalidSetting::NoMomenta)
    );
}
