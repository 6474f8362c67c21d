//! The results of a run, and how it ends.

use core::cell::Cell;
use core::f64::consts::FRAC_PI_2;

use approx::{assert_abs_diff_eq, assert_relative_eq};
use dynamics_numeric::NumericArm;
use dynamics_runtime::table::{Convention, JointType, Row, RuntimeTable};
use dynamics_runtime::{ForwardDynamics, Place, Scalar, SingularMassMatrix};
use nalgebra::{DVector, Dyn, SVector, Vector1, Vector2};
use tables::CRAIG_ARM;

use crate::simulation::{Cause, Dop853, DormandPrince, InvalidSetting, Radau5};
use crate::{Method, Simulation, Trajectory};

/// A unit mass on a rail.
pub(super) struct Cart;

impl ForwardDynamics<1> for Cart {
    fn forward_dynamics<T: Scalar>(
        &self,
        _: &SVector<T, 1>,
        _: &SVector<T, 1>,
        tau: &SVector<T, 1>,
    ) -> Result<SVector<T, 1>, SingularMassMatrix> {
        Ok(*tau)
    }
}

/// A unit mass that vanishes where q reaches 1.
struct Vanishing;

impl ForwardDynamics<1> for Vanishing {
    fn forward_dynamics<T: Scalar>(
        &self,
        q: &SVector<T, 1>,
        _: &SVector<T, 1>,
        tau: &SVector<T, 1>,
    ) -> Result<SVector<T, 1>, SingularMassMatrix> {
        let mass = T::from_f64(1.0) - q[0];
        if mass.is_positive() {
            Ok(Vector1::new(tau[0] / mass))
        } else {
            Err(SingularMassMatrix::new(0, 0.0))
        }
    }
}

fn fixed_methods(step: f64) -> [Method; 4] {
    [
        Method::ExplicitEuler { step },
        Method::CraigEuler { step },
        Method::SemiImplicitEuler { step },
        Method::RungeKutta4 { step },
    ]
}

fn adaptive_methods(tolerance: f64, max_step: Option<f64>) -> [Method; 3] {
    let mut dormand_prince = DormandPrince::with_tolerance(tolerance);
    let mut dop853 = Dop853::with_tolerance(tolerance);
    let mut radau = Radau5::with_tolerance(tolerance);
    dormand_prince.max_step = max_step;
    dop853.max_step = max_step;
    radau.max_step = max_step;
    [dormand_prince.into(), dop853.into(), radau.into()]
}

fn methods(step: f64) -> Vec<Method> {
    let adaptive = adaptive_methods(1e-9, None);
    fixed_methods(step).into_iter().chain(adaptive).collect()
}

fn unit(x: f64) -> SVector<f64, 1> {
    Vector1::new(x)
}

#[test]
fn samples_are_at_equal_intervals_and_end_at_the_duration() {
    for method in methods(0.03) {
        let cart = Simulation::new(&Cart).initial(unit(1.0), unit(2.0));
        let run = cart.method(method).duration(0.7).samples(8).run().unwrap();
        assert_eq!(run.len(), 8);
        assert_eq!((run.t[0], run.t[7]), (0.0, 0.7));
        for (k, t) in run.t.iter().enumerate() {
            assert_eq!(*t, 0.7 * k as f64 / 7.0);
            assert_abs_diff_eq!(run.q[k][0], 1.0 + 2.0 * t, epsilon = 1e-14);
            assert_eq!(run.qd[k][0], 2.0);
        }
    }
}

#[test]
fn the_law_is_given_time_position_and_velocity() {
    // A spring, a damper and a ramp: q'' = 5 t + 2 - 5 q - 2 q', q = exp(-t) sin(2 t) + t.
    let law = |t: f64, q: &SVector<f64, 1>, qd: &SVector<f64, 1>| {
        unit(5.0 * t + 2.0 - 5.0 * q[0] - 2.0 * qd[0])
    };
    let cart = Simulation::new(&Cart).initial(unit(0.0), unit(3.0));
    let run = cart.torque(law).duration(2.0).samples(21).run().unwrap();
    for (t, q) in run.t.iter().zip(&run.q) {
        let expected = (-t).exp() * (2.0 * t).sin() + t;
        assert_abs_diff_eq!(q[0], expected, epsilon = 1e-8);
    }
}

#[test]
fn free_motion_conserves_energy() {
    let arm = Simulation::new(&CRAIG_ARM).initial(Vector2::new(0.3, -1.0), Vector2::zeros());
    // The polynomial of Radau's samples is of third degree.
    for (accurate, bound) in adaptive_methods(1e-12, None)
        .into_iter()
        .zip([1e-10, 1e-10, 1e-8])
    {
        let run = arm.clone().method(accurate).duration(3.0).run().unwrap();
        let energies = run.energies(&CRAIG_ARM);
        assert_eq!(energies.len(), 101);
        assert!(run.qd.last().unwrap().amax() > 0.1);
        assert!(
            run.energy_drift(&CRAIG_ARM) < bound * energies[0].abs(),
            "{accurate:?}"
        );
    }
}

#[test]
fn energy_drift_is_the_largest_and_keeps_what_is_not_a_number() {
    let arm = Simulation::new(&CRAIG_ARM).initial(Vector2::new(0.3, -1.0), Vector2::zeros());
    let mut run = arm.samples(3).run().unwrap();
    run.q[1][0] = f64::NAN;
    assert!(run.energy_drift(&CRAIG_ARM).is_nan());
    run.q[1] = run.q[0];
    run.qd[1] = Vector2::new(1.0, 0.0);
    let expected = 0.5 * CRAIG_ARM.mass_matrix(&run.q[0])[(0, 0)];
    assert_abs_diff_eq!(run.energy_drift(&CRAIG_ARM), expected, epsilon = 1e-9);
    run.t.clear();
    run.q.clear();
    run.qd.clear();
    assert_eq!(run.energy_drift(&CRAIG_ARM), 0.0);
}

#[test]
fn a_torque_that_is_not_a_number_ends_the_run_and_loses_nothing() {
    for method in methods(0.01) {
        let law = |t: f64, _: &SVector<f64, 1>, _: &SVector<f64, 1>| {
            unit(if t < 0.55 { 1.0 } else { f64::NAN })
        };
        let cart = Simulation::new(&Cart).torque(law).method(method);
        let error = cart.samples(11).run().unwrap_err();
        assert_eq!(error.cause, Cause::NonFiniteTorque { joint: 0 });
        // The longest step before it.
        assert!((error.time - 0.55).abs() < 0.0101, "{method:?}: {error}");
        assert_relative_eq!(error.qd[0], error.time, max_relative = 1e-12);
        assert_eq!(error.trajectory.len(), 6);
        assert_eq!(error.trajectory.t[5], 0.5);
    }
}

#[test]
fn a_singular_mass_matrix_ends_the_run() {
    for method in methods(1e-3) {
        let start = Simulation::new(&Vanishing).initial(unit(0.0), unit(1.0));
        let error = start
            .method(method)
            .duration(2.0)
            .samples(21)
            .run()
            .unwrap_err();
        let singular = Cause::SingularMassMatrix(SingularMassMatrix::new(0, 0.0));
        assert_eq!(error.cause, singular);
        assert!((error.time - 1.0).abs() < 2e-3, "{method:?}: {error}");
        assert_relative_eq!(error.q[0], error.time, max_relative = 1e-12);
        assert!(error.trajectory.len() >= 10);
        assert!(std::error::Error::source(&error).is_some());
    }
}

#[test]
fn a_singular_start_ends_the_run_at_once() {
    for method in methods(1e-3) {
        let start = Simulation::new(&Vanishing).initial(unit(1.0), unit(0.0));
        let error = start.method(method).run().unwrap_err();
        assert!(matches!(error.cause, Cause::SingularMassMatrix(_)));
        assert_eq!((error.time, error.q[0]), (0.0, 1.0));
        let Trajectory { t, q, qd, .. } = error.trajectory;
        assert_eq!((t, q, qd), (vec![0.0], vec![unit(1.0)], vec![unit(0.0)]));
    }
}

#[test]
fn an_infinite_torque_at_the_start_leaves_the_first_sample() {
    for method in methods(1e-3) {
        let cart = Simulation::new(&Cart).torque(|_, _, _| unit(f64::INFINITY));
        let error = cart.method(method).run().unwrap_err();
        assert_eq!(error.cause, Cause::NonFiniteTorque { joint: 0 });
        assert_eq!(error.trajectory.t, [0.0], "{method:?}");
    }
}

/// q'' = q'^3 from q' = 1: q' = 1 / sqrt(1 - 2 t), which is infinite at t = 1/2.
#[test]
fn a_blow_up_ends_the_run() {
    for method in methods(1e-3) {
        let law = |_: f64, _: &SVector<f64, 1>, qd: &SVector<f64, 1>| unit(qd[0].powi(3));
        let start = Simulation::new(&Cart)
            .torque(law)
            .initial(unit(0.0), unit(1.0));
        let error = start.method(method).samples(11).run().unwrap_err();
        assert!((error.time - 0.5).abs() < 0.05, "{method:?}: {error}");
        assert!(error.q[0].is_finite() && error.qd[0].is_finite());
        assert!(error.trajectory.len() >= 5);
        assert!(error.trajectory.qd.iter().all(|qd| qd[0].is_finite()));
    }
}

/// An arm at rest in equilibrium has no error to estimate; a short push must still be seen.
#[test]
fn a_push_at_rest_is_not_stepped_over() {
    let law = |t: f64, _: &SVector<f64, 1>, _: &SVector<f64, 1>| {
        unit(if (60.0..61.0).contains(&t) { 1.0 } else { 0.0 })
    };
    for capped in adaptive_methods(1e-9, Some(0.5)) {
        let cart = Simulation::new(&Cart).torque(law).duration(100.0);
        let run = cart.method(capped).samples(2).run().unwrap();
        assert!((run.qd[1][0] - 1.0).abs() < 1e-6, "{}", run.qd[1][0]);
    }
}

/// Every call of the torque law is an evaluation of the forward dynamics, except for one at each sample, for
/// the record.
#[test]
fn work_is_counted() {
    let calls = Cell::new(0);
    let law = |_: f64, q: &SVector<f64, 1>, _: &SVector<f64, 1>| {
        calls.set(calls.get() + 1);
        -q * 100.0
    };
    // A Newton iteration of Radau's takes three evaluations, its Jacobian two for each joint.
    let per_step = [1, 1, 1, 4, 6, 12].map(|n| (n, n));
    let per_step = per_step.into_iter().chain([(4, 15)]);
    for (method, (least, most)) in methods(0.01).into_iter().zip(per_step) {
        let cart = Simulation::new(&Cart)
            .torque(law)
            .initial(unit(1.0), unit(0.0));
        let work = cart.method(method).samples(11).run().unwrap().work;
        assert_eq!(work.evaluations, calls.replace(0) - 11, "{method:?}");
        // Two at the start, three for each sample of DOP853.
        let bounds = least * work.steps..=2 + 3 * 10 + most * (work.steps + work.rejected);
        assert!(bounds.contains(&work.evaluations), "{method:?}: {work:?}");
        assert!(work.steps >= 50, "{method:?}: {work:?}");
    }
}

#[test]
fn steps_are_no_longer_than_the_longest() {
    for method in adaptive_methods(1e-9, None) {
        let work = Simulation::new(&Cart)
            .method(method)
            .samples(2)
            .run()
            .unwrap()
            .work;
        // 50 steps, and the few shorter ones at the start.
        assert!((50..=60).contains(&work.steps), "{work:?}");
        assert_eq!(work.rejected, 0);
    }
}

#[test]
fn steps_may_be_longer_than_the_duration() {
    let start = || Simulation::new(&Cart).initial(unit(0.0), unit(1.0));
    for method in &fixed_methods(1e3) {
        let run = start().method(*method).samples(3).run().unwrap();
        assert_eq!(run.q, [unit(0.0), unit(0.5), unit(1.0)], "{method:?}");
    }
    for max_step in [1e3, f64::MAX, f64::INFINITY] {
        for method in adaptive_methods(1e-9, Some(max_step)) {
            let run = start().method(method).samples(3).run().unwrap();
            assert_abs_diff_eq!(run.q[2][0], 1.0, epsilon = 1e-14);
        }
    }
}

/// Viscous friction of b/J = 10^6: explicit methods are unstable at steps beyond 3.3 microseconds.
#[test]
fn stiff_friction_is_for_radau() {
    let law =
        |_: f64, q: &SVector<f64, 1>, qd: &SVector<f64, 1>| unit(-1e6 * qd[0] - 1e3 * q[0].sin());
    let cart = || {
        Simulation::new(&Cart)
            .torque(law)
            .initial(unit(1.0), unit(0.0))
    };
    let run = cart().method(Radau5::with_tolerance(1e-8)).run().unwrap();
    let exact = 2.0 * (0.5_f64.tan() * (-1e-3_f64).exp()).atan();
    assert_abs_diff_eq!(run.q[100][0], exact, epsilon = 1e-8);
    assert!(run.work.evaluations < 1_000, "{:?}", run.work);

    for explicit in [
        Dop853::with_tolerance(1e-3).max_steps(300).into(),
        Method::RungeKutta4 { step: 1e-4 },
    ] {
        let cause = cart().method(explicit).run().unwrap_err().cause;
        let known = [
            Cause::TooManySteps,
            Cause::NonFiniteState { joint: 0 },
            Cause::NonFiniteTorque { joint: 0 },
        ];
        assert!(known.contains(&cause), "{cause}");
    }
}

#[test]
fn a_law_that_drives_a_joint_back_to_rest_ends_in_chatter() {
    let law = |_: f64, _: &SVector<f64, 1>, qd: &SVector<f64, 1>| unit(0.5 - Scalar::sign(qd[0]));
    let settings = DormandPrince::default().max_steps(1000);
    let start = Simulation::new(&Cart)
        .torque(law)
        .initial(unit(0.0), unit(0.1));
    let method = Method::DormandPrince(settings);
    let error = start.method(method).samples(11).run().unwrap_err();
    assert_eq!(error.cause, Cause::Chatter { joint: 0 });
    assert!((error.time - 0.2).abs() < 1e-3, "{error}");
    assert_eq!(error.trajectory.len(), 3);
}

#[test]
fn settings_that_make_no_sense_are_refused() {
    for duration in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = Simulation::new(&CRAIG_ARM)
            .duration(duration)
            .run()
            .unwrap_err();
        assert!(matches!(
            error.cause,
            Cause::InvalidSetting(InvalidSetting::Duration(_))
        ));
        assert!(error.trajectory.is_empty() && error.time == 0.0);
    }
    for samples in [0, 1, usize::MAX] {
        let error = Simulation::new(&CRAIG_ARM)
            .samples(samples)
            .run()
            .unwrap_err();
        assert_eq!(error.cause, InvalidSetting::Samples(samples).into());
    }
    for method in &fixed_methods(f64::INFINITY) {
        let error = Simulation::new(&CRAIG_ARM)
            .method(*method)
            .run()
            .unwrap_err();
        assert_eq!(error.cause, InvalidSetting::Step(f64::INFINITY).into());
    }
    for step in [0.0, -1.0, f64::NAN, f64::NEG_INFINITY, 1e-17] {
        let adaptive = adaptive_methods(1e-9, Some(step));
        for method in fixed_methods(step).into_iter().chain(adaptive) {
            let error = Simulation::new(&CRAIG_ARM)
                .method(method)
                .run()
                .unwrap_err();
            assert!(matches!(
                error.cause,
                Cause::InvalidSetting(InvalidSetting::Step(_))
            ));
        }
    }
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        for method in adaptive_methods(tolerance, None) {
            let error = Simulation::new(&CRAIG_ARM)
                .method(method)
                .run()
                .unwrap_err();
            assert!(matches!(
                error.cause,
                Cause::InvalidSetting(InvalidSetting::Tolerance(_))
            ));
        }
    }
    let nowhere = Vector2::new(0.0, f64::NAN);
    let error = Simulation::new(&CRAIG_ARM)
        .initial(Vector2::zeros(), nowhere)
        .run()
        .unwrap_err();
    assert_eq!(
        error.cause,
        InvalidSetting::InitialState { joint: 1 }.into()
    );
}

#[test]
fn errors_say_where_and_why() {
    let simulation = Simulation::new(&Vanishing).initial(unit(FRAC_PI_2), unit(0.0));
    let text = simulation.run().unwrap_err().to_string();
    let start = "the simulation ended at t = 0.0 s: the mass matrix is not positive definite at joint 1 \
                 (relative pivot 0e0): ";
    assert!(text.starts_with(start), "{text}");
    assert!(
        text.ends_with(" (q = [1.5707963267948966], qd = [0.0])"),
        "{text}"
    );
}

#[test]
fn samples_have_what_the_lists_have() {
    let mut run = Simulation::new(&CRAIG_ARM).samples(4).run().unwrap();
    assert_eq!(run.samples().len(), 4);
    for (k, sample) in run.samples().enumerate() {
        assert_eq!((sample.t, sample.q), (run.t[k], run.q[k]));
        let rest = (sample.qd, sample.qdd, sample.tau);
        assert_eq!(rest, (run.qd[k], run.qdd[k], run.tau[k]));
    }
    assert_eq!(run.last().unwrap().q, run.q[3]);
    run.tau.clear();
    run.q.pop();
    let last = run.last().unwrap();
    assert!((last.t, last.qdd) == (run.t[2], run.qdd[2]) && last.tau[0].is_nan());
    assert_eq!(Trajectory::<2>::default().last(), None);
}

/// No index beyond the end, in a run and in the sentence.
#[test]
fn a_start_of_another_length_is_an_error() {
    let row = Row {
        mass: 1.0,
        com: [1.0, 0.0, 0.0],
        ..Row::new(JointType::Revolute)
    };
    let table = RuntimeTable::new(Convention::Modified, [0.0; 3], vec![row; 2]);
    let arm = NumericArm::new(&table);
    let start = |positions, velocities| {
        let q = DVector::<f64>::zeros(positions);
        let place = Place { base: None, q };
        let simulation = Simulation::<_, _, Dyn>::new(&arm);
        let simulation = simulation.initial(place, DVector::zeros(velocities));
        let error = simulation.run().unwrap_err();
        let sampled = simulation.control_period(0.1);
        let mut sampled = sampled.torque(|_, _: &_, _: &_| DVector::zeros(2));
        assert_eq!(sampled.run().unwrap_err(), error);
        assert_eq!(error.trajectory.len(), 0);
        (error.cause, error.to_string())
    };
    for found in [0, 1, 3, 9] {
        let (cause, text) = start(found, 2);
        assert_eq!(
            cause,
            InvalidSetting::Positions { expected: 2, found }.into()
        );
        let expected = format!("the start has {found} positions: expected 2 (q = ");
        assert!(text.contains(&expected), "{text}");
        let (cause, text) = start(2, found);
        assert_eq!(
            cause,
            InvalidSetting::Velocities { expected: 2, found }.into()
        );
        let expected = format!("the start has {found} velocities: expected 2 (q = ");
        assert!(text.contains(&expected), "{text}");
    }
}
