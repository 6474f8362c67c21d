//! Simulations and the cycloidal law against trajectories of 30 digits.

use std::f64::consts::PI;

use robot_dynamics::nalgebra::{SVector, Vector1};
use robot_dynamics::{
    Cycloidal, Energy, ForwardDynamics, Method, Simulation, Trajectory,
    simulation::{Dop853, DormandPrince, Radau5},
};
use serde_json::Value;

use crate::arms::{OneLink, TwoLink};
use tables::data::{load, number, numbers};

fn trajectory(name: &str) -> Value {
    load(&format!("trajectories/{name}"))
}

/// Runs the arm from the first sample of the reference over its 51 samples.
fn run<R: ForwardDynamics<N>, const N: usize>(
    robot: &R,
    reference: &Value,
    method: Method,
) -> Trajectory<N> {
    let (q, qd) = sample(&reference["y0"]);
    let simulation = Simulation::new(robot).initial(q, qd).method(method);
    simulation.duration(10.0).samples(51).run().unwrap()
}

/// Positions, then velocities.
fn sample<const N: usize>(y: &Value) -> (SVector<f64, N>, SVector<f64, N>) {
    let entry = |i: usize| number(&y[i]);
    (
        SVector::from_fn(|i, _| entry(i)),
        SVector::from_fn(|i, _| entry(N + i)),
    )
}

/// The largest error of each sample.
fn errors<const N: usize>(computed: &Trajectory<N>, reference: &Value) -> Vec<f64> {
    assert_eq!(computed.len(), 51);
    let error = |k: usize| {
        assert!((computed.t[k] - number(&reference["t"][k])).abs() < 1e-14);
        let (q, qd) = sample::<N>(&reference["y"][k]);
        let entries = (computed.q[k] - q).abs().max();
        entries.max((computed.qd[k] - qd).abs().max())
    };
    (0..51).map(error).collect()
}

fn largest(errors: &[f64]) -> f64 {
    errors.iter().copied().fold(0.0, f64::max)
}

const CRAIG_EULER: Method = Method::CraigEuler { step: 1e-3 };

/// Each of the 10 000 steps rounds a few times, and the motion amplifies what it rounds: 21 times
/// over ten seconds for one link, 2400 times for two.
#[test]
fn one_link_euler_scheme_value_for_value() {
    let reference = trajectory("one_link_craig_euler_dt1e-3");
    let computed = run::<_, 1>(&OneLink, &reference, CRAIG_EULER);
    let error = largest(&errors(&computed, &reference));
    assert!(error < 2e-12, "{error:e}");
}

#[test]
fn two_link_euler_scheme_value_for_value() {
    let reference = trajectory("two_link_craig_euler_dt1e-3");
    let computed = run::<_, 2>(&TwoLink, &reference, CRAIG_EULER);
    let error = largest(&errors(&computed, &reference));
    assert!(error < 2e-10, "{error:e}");
}

/// The scheme is of first order: it is far from the solution that it approximates.
#[test]
fn euler_scheme_is_not_the_solution() {
    let reference = trajectory("one_link_free");
    let computed = run::<_, 1>(&OneLink, &reference, CRAIG_EULER);
    assert!(largest(&errors(&computed, &reference)) > 0.1);
}

/// Free motion at a tolerance: every sample within what the file's sensitivity makes of the
/// tolerance, and the energy constant beside what is exchanged between its two forms.
fn check_free<R: ForwardDynamics<N> + Energy<N>, const N: usize>(
    robot: &R,
    name: &str,
    method: Method,
    bound: f64,
) {
    let reference = trajectory(name);
    let computed = run::<_, N>(robot, &reference, method);
    for (k, error) in errors(&computed, &reference).into_iter().enumerate() {
        let sensitivity = number(&reference["sensitivity_per_sample"][k]);
        assert!(
            error <= bound * sensitivity,
            "sample {k}: {error:e}, {sensitivity}"
        );
    }
    let states = computed.q.iter().zip(&computed.qd);
    let kinetic = states.map(|(q, qd)| robot.kinetic_energy::<f64>(q, qd));
    let exchanged = kinetic.fold(0.0, f64::max);
    let drift = computed.energy_drift(robot);
    assert!(drift < bound * exchanged, "{drift:e} of {exchanged}");
}

fn accurate() -> [Method; 3] {
    [
        DormandPrince::with_tolerance(1e-12).into(),
        Dop853::with_tolerance(1e-12).into(),
        Method::GaussLegendre6 { step: 4e-3 },
    ]
}

#[test]
fn one_link_swings_freely() {
    for method in accurate() {
        check_free::<_, 1>(&OneLink, "one_link_free", method, 1e-10);
    }
}

#[test]
fn two_links_fall_freely() {
    for method in accurate() {
        check_free::<_, 2>(&TwoLink, "two_link_free", method, 1e-10);
    }
}

#[test]
fn radau_agrees() {
    let method = Radau5::with_tolerance(1e-9).into();
    check_free::<_, 1>(&OneLink, "one_link_free", method, 1e-7);
    check_free::<_, 2>(&TwoLink, "two_link_free", method, 1e-7);
}

#[test]
fn runge_kutta_agrees() {
    let reference = trajectory("one_link_free");
    let computed = run::<_, 1>(&OneLink, &reference, Method::RungeKutta4 { step: 1e-3 });
    let error = largest(&errors(&computed, &reference));
    assert!(error < 1e-9, "{error:e}");
}

/// The two links start at rest, where all derivatives of odd order vanish: an error estimate that
/// sees none of the others would permit a step of any length, and nothing here bounds it.
#[test]
fn a_start_from_rest_is_not_stepped_over() {
    let reference = trajectory("two_link_free");
    for tolerance in [1e-3, 1e-6, 1e-9] {
        let methods: [Method; 3] = [
            DormandPrince::with_tolerance(tolerance)
                .max_step(f64::INFINITY)
                .into(),
            Dop853::with_tolerance(tolerance)
                .max_step(f64::INFINITY)
                .into(),
            Radau5::with_tolerance(tolerance)
                .max_step(f64::INFINITY)
                .into(),
        ];
        for method in methods {
            let computed = run::<_, 2>(&TwoLink, &reference, method);
            assert!(computed.work.steps > 50, "{method:?}: {:?}", computed.work);
            // One second, before chaos makes the error that of its own.
            let error = largest(&errors(&computed, &reference)[..6]);
            assert!(error < 300.0 * tolerance, "{method:?}: {error:e}");
        }
    }
}

/// From 0 to pi in ten seconds.
#[test]
fn cycloidal_law() {
    let reference = trajectory("one_link_invdyn");
    let law = Cycloidal::new(Vector1::new(0.0), Vector1::new(PI), 10.0).unwrap();
    for k in 0..51 {
        let t = number(&reference["t"][k]);
        let [q, qd, qdd, _] = numbers::<4>(&reference["rows"][k]);
        let state = law.at(t);
        let near = |computed: f64, expected: f64| {
            let error = (computed - expected).abs();
            // The second part is the rounding of the reference where the value is zero.
            assert!(error <= 1e-15 * expected.abs() + 1e-60, "{error:e} at {t}");
        };
        near(state.q[0], q);
        near(state.qd[0], qd);
        near(state.qdd[0], qdd);
    }
}
