//! How runs end that cannot go on, by every method, and what they say then.

use robot_dynamics::nalgebra::{Vector1, Vector2};
use robot_dynamics::{
    Friction, Method, Simulation, SimulationError, TaylorSimulation, Trajectory, robot_dynamics,
    simulation::{Cause, Dop853, DormandPrince, InvalidSetting},
};

use crate::every_method::{self, fixed};

robot_dynamics! {
    /// A mass at the end of a rod of 1 m.
    struct Pendulum;

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [pivot: revolute { a: 1, mass: 1 }],
    functions: [mass_matrix, inverse_dynamics, forward_dynamics, taylor_series],
}

robot_dynamics! {
    /// A mass at the end of two rods: where the arm is stretched nothing resists the shoulder with the
    /// elbow free.
    struct Whip;

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [shoulder: revolute { a: 1 }, elbow: revolute { a: 1, mass: 1 }],
    functions: [mass_matrix, inverse_dynamics, forward_dynamics, taylor_series],
}

robot_dynamics! {
    /// A cart of 2 kg on a dry rail.
    struct DryCart { coulomb: f64 }

    convention: standard,
    gravity: [0, 0, 0],
    joints: [slide: prismatic { mass: 2, friction: { coulomb: coulomb } }],
    functions: [mass_matrix, inverse_dynamics, forward_dynamics],
}

type Run<const N: usize> = Result<Trajectory<N>, Box<SimulationError<N>>>;

fn controlled() -> [Method; 3] {
    every_method::controlled(1e-9)
}

/// The pendulum over a time, by every method in a tenth of it.
fn swings(duration: f64, samples: usize) -> Vec<(String, Run<1>)> {
    let (q, qd) = (Vector1::new(0.3), Vector1::new(0.1));
    let methods = fixed(duration / 10.0).into_iter().chain(controlled());
    let run = |method: Method| {
        let swing = Simulation::new(&Pendulum).initial(q, qd).method(method);
        let run = swing.duration(duration).samples(samples).run();
        (format!("{method:?}, {duration:e} s"), run)
    };
    let mut runs: Vec<_> = methods.map(run).collect();
    let swing = TaylorSimulation::new(&Pendulum).initial(q, qd);
    let run = swing.duration(duration).samples(samples).run();
    runs.push((format!("Taylor, {duration:e} s"), run));
    runs
}

/// The text that `?` in `main` and `unwrap` print.
#[test]
fn an_error_with_many_samples_prints_one_sentence() {
    let law = |t: f64, _: &Vector1<f64>, _: &Vector1<f64>| {
        Vector1::new(if t > 0.9 { f64::NAN } else { 0.0 })
    };
    let swing = Simulation::new(&Pendulum).torque(law);
    let error = swing.samples(1001).run().unwrap_err();
    let samples = error.trajectory.len();
    assert!(samples > 800);
    let text = format!("{error:?}");
    assert_eq!(
        text,
        format!("{error}; `trajectory` has {samples} samples up to there")
    );
    assert!(
        text.len() < 300 && !format!("{error:#?}").contains('\n'),
        "{text}"
    );
}

#[test]
fn a_time_shorter_than_its_rounding_can_be_is_refused() {
    for duration in [5e-324, 1e-310, 1e-300] {
        for (method, run) in [2, 3, 101].into_iter().flat_map(|n| swings(duration, n)) {
            let cause = run.unwrap_err().cause;
            let refused = Cause::InvalidSetting(InvalidSetting::Duration(duration));
            assert_eq!(cause, refused, "{method}");
        }
    }
}

#[test]
fn the_shortest_and_the_longest_times_are_simulated() {
    for (method, run) in [1e-291, 1e-200, 1e-20]
        .into_iter()
        .flat_map(|duration| swings(duration, 11))
    {
        let run = run.unwrap();
        assert_eq!(run.len(), 11, "{method}");
        assert!(run.t.windows(2).all(|t| t[0] < t[1]), "{method}");
        assert_eq!((run.q[10][0], run.qd[10][0]), (0.3, 0.1), "{method}");
    }
}

/// Beside such times all steps that the motion asks for are lost in the rounding of the time, and what is met at longer
/// ones says nothing about the motion.
#[test]
fn times_beside_which_every_step_is_lost_end_in_a_step_that_is_too_small() {
    for duration in [1e20, 1e300] {
        for method in controlled() {
            let swing = Simulation::new(&Pendulum).initial(Vector1::new(0.3), Vector1::new(0.1));
            let error = swing.method(method).duration(duration).run().unwrap_err();
            assert_eq!(error.cause, Cause::StepTooSmall, "{method:?} {duration:e}");
            assert_eq!(error.time, 0.0);
        }
    }
}

/// A force beyond all measure asks for steps that are lost in the rounding of the time; the state is
/// finite all the same.
#[test]
fn forces_that_no_step_follows_end_in_a_step_that_is_too_small() {
    for force in [1e200, -1e200, 1e300] {
        let turning = |_: f64, q: &Vector1<f64>, _: &Vector1<f64>| Vector1::new(force * q[0].cos());
        for method in controlled() {
            let swing = Simulation::new(&Pendulum).method(method);
            let error = swing.torque(turning).run().unwrap_err();
            assert_eq!(error.cause, Cause::StepTooSmall, "{method:?} {force:e}");
            assert!(error.trajectory.work.evaluations < 100, "{method:?}");
            assert!(error.to_string().contains("no step is short enough"));
        }
        let swing = TaylorSimulation::new(&Pendulum).torque(Vector1::new(force));
        let error = swing.run().unwrap_err();
        assert_eq!(error.cause, Cause::StepTooSmall, "Taylor {force:e}");
    }
    let cart = DryCart { coulomb: 1e300 };
    for method in controlled() {
        let slide = Simulation::new(&cart).initial(Vector1::zeros(), Vector1::new(3.0));
        let error = slide.method(method).run().unwrap_err();
        assert_eq!(error.cause, Cause::StepTooSmall, "{method:?}");
        assert!(error.trajectory.work.evaluations < 100, "{method:?}");
    }
}

/// Where stopping is an event, methods whose steps need no iteration find it within 1e-299 s, and the
/// cart stands where it was.
#[test]
fn a_stop_in_no_time_is_found() {
    let cart = DryCart { coulomb: 1e300 };
    let step = 1e-2;
    for method in [
        Method::RungeKutta4 { step },
        DormandPrince::default().into(),
        Dop853::default().into(),
    ] {
        let slide = Simulation::new(&cart).initial(Vector1::zeros(), Vector1::new(3.0));
        let slide = slide.friction(Friction::Sticking).method(method);
        let run = slide.run().unwrap();
        for (q, qd) in run.q.iter().zip(&run.qd).skip(1) {
            assert_eq!(qd[0], 0.0, "{method:?}");
            assert!(q[0].abs() < 1e-290, "{method:?}: {q}");
        }
    }
}

#[test]
fn singular_mass_matrices_name_the_joint_by_every_method() {
    let stretched = Vector2::new(0.3, 0.0);
    let still = Vector2::zeros();
    let mut errors: Vec<Cause> = Vec::new();
    for method in fixed(1e-2).into_iter().chain(controlled()) {
        let start = Simulation::new(&Whip).initial(stretched, still);
        errors.push(start.method(method).run().unwrap_err().cause);
    }
    let start = TaylorSimulation::new(&Whip).initial(stretched, still);
    errors.push(start.run().unwrap_err().cause);
    let series = Whip.taylor_series(&stretched, &still, &still, 10);
    errors.push(Cause::SingularMassMatrix(series.unwrap_err()));
    for cause in errors {
        let Cause::SingularMassMatrix(singular) = cause else {
            panic!("{cause}");
        };
        assert_eq!(singular.joint_name, Some("shoulder"), "{cause}");
        assert!(cause.to_string().contains("joint 1 `shoulder`"), "{cause}");
    }
}

/// The series goes across the place where the mass matrix is singular, and its end is refused: steps
/// are halved, and those thrown away are counted.
#[test]
fn halved_steps_of_taylor_runs_are_counted() {
    let whip = TaylorSimulation::new(&Whip);
    let start = whip.initial(Vector2::new(0.3, 0.01), Vector2::new(0.0, -10.0));
    let error = start.run().unwrap_err();
    assert!(matches!(error.cause, Cause::SingularMassMatrix(_)));
    let work = error.trajectory.work;
    assert!(work.rejected > 0, "{work:?}");
}
