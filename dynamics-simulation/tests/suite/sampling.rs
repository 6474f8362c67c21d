//! Laws that are sampled and held: when they are asked, and that every method follows them.

use std::cell::Cell;

use robot_dynamics::nalgebra::{Matrix4, SVector, Vector1, Vector2, Vector6};
use robot_dynamics::{
    Friction, Method, Simulation, TaylorSimulation, robot_dynamics,
    simulation::{Cause, Dop853, DormandPrince, InvalidSetting, Radau5, Taylor},
};

robot_dynamics! {
    /// A cart of 2 kg on a rail along z.
    struct Cart;

    convention: modified,
    gravity: [0, 0, 0],
    joints: [rail: prismatic { mass: 2 }],
    functions: [
        mass_matrix, inverse_dynamics, forward_dynamics, taylor_series, forward_kinematics, jacobian,
    ],
}

robot_dynamics! {
    /// The same on a dry rail.
    struct DryCart;

    convention: modified,
    gravity: [0, 0, 0],
    joints: [rail: prismatic { mass: 2, friction: { coulomb: 1 } }],
    functions: [mass_matrix, inverse_dynamics, forward_dynamics],
}

robot_dynamics! {
    /// Two slender rods in a vertical plane.
    struct Rods;

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { a: 2, mass: 3, com: [-1, 0, 0], inertia: rod(2) },
        elbow: revolute { a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1) },
    ],
    functions: [mass_matrix, inverse_dynamics, forward_dynamics, taylor_series],
}

/// The methods that are exact under constant forces. The steps fit into the period in no way.
fn methods() -> [Method; 8] {
    let step = 0.7e-2;
    [
        Method::CraigEuler { step },
        Method::RungeKutta4 { step },
        Method::ImplicitMidpoint { step },
        Method::GaussLegendre4 { step },
        Method::GaussLegendre6 { step: 0.31 },
        DormandPrince::default().into(),
        Dop853::default().into(),
        Radau5::default().into(),
    ]
}

const PERIOD: f64 = 0.01;

/// A controller with a memory, and the log of its calls.
#[derive(Default)]
struct Controller {
    integral: f64,
    calls: Vec<[f64; 3]>,
}

impl Controller {
    fn force(&mut self, t: f64, x: f64, v: f64) -> f64 {
        self.calls.push([t, x, v]);
        let error = 0.3 - x;
        self.integral += PERIOD * error;
        20.0 * error + 10.0 * self.integral - 12.0 * v
    }
}

/// `x+ = x + v p + f p^2 / (2 m)`, `v+ = v + f p / m`: what the cart does under forces that are held.
fn exact(periods: usize) -> (Vec<[f64; 3]>, Vec<f64>) {
    let mut controller = Controller::default();
    let ([mut x, mut v], mut forces) = ([0.0, 0.1], vec![]);
    for k in 0..periods {
        let force = controller.force(k as f64 * PERIOD, x, v);
        x += v * PERIOD + 0.25 * force * PERIOD * PERIOD;
        v += 0.5 * force * PERIOD;
        forces.push(force);
    }
    (controller.calls, forces)
}

fn assert_calls(found: &[[f64; 3]], what: &dyn std::fmt::Debug) {
    let (expected, _) = exact(found.len());
    assert_eq!(found.len(), 100, "{what:?}");
    for (k, (found, expected)) in found.iter().zip(&expected).enumerate() {
        assert_eq!(found[0], k as f64 * PERIOD, "{what:?}");
        for i in [1, 2] {
            let error = (found[i] - expected[i]).abs();
            assert!(error < 1e-13, "{what:?}, call {k}: {error:e}");
        }
    }
}

/// Once a period, at its very multiples, with the state there, and never between.
#[test]
fn every_method_asks_at_multiples_of_the_period_and_holds_the_torque() {
    for method in methods() {
        for samples in [2, 8, 101] {
            let mut controller = Controller::default();
            let run = Simulation::new(&Cart)
                .control_period(PERIOD)
                .torque(|t, q, qd| Vector1::new(controller.force(t, q[0], qd[0])))
                .initial(Vector1::zeros(), Vector1::new(0.1))
                .method(method)
                .samples(samples)
                .run()
                .unwrap();
            assert_calls(&controller.calls, &(method, samples));
            let (_, forces) = exact(100);
            for (k, (t, tau)) in run.t.iter().zip(&run.tau).enumerate() {
                // At the end the last one is held.
                let period = ((t / PERIOD + 1e-9) as usize).min(99);
                let error = (tau[0] - forces[period]).abs();
                assert!(error < 1e-11, "{method:?}, sample {k}: {error:e}");
                assert!((run.qdd[k][0] - 0.5 * tau[0]).abs() < 1e-15);
            }
        }
    }
}

#[test]
fn taylor_series_begin_at_the_samples_of_a_law() {
    let mut controller = Controller::default();
    TaylorSimulation::new(&Cart)
        .control_period(PERIOD)
        .torque(|t, q, qd| Vector1::new(controller.force(t, q[0], qd[0])))
        .initial(Vector1::zeros(), Vector1::new(0.1))
        .samples(8)
        .run()
        .unwrap();
    assert_calls(&controller.calls, &"taylor");
}

/// A controlled arm: four kinds of method agree.
#[test]
fn methods_agree_on_a_controlled_arm() {
    let start = Vector2::new(0.4, -0.3);
    let law = |integral: &mut Vector2<f64>, t: f64, q: &Vector2<f64>, qd: &Vector2<f64>| {
        let error = Vector2::new(0.4 + 0.3 * t, -0.3) - q;
        *integral += error * 0.02;
        error * 30.0 + *integral * 10.0 - qd * 6.0
    };
    let mut integral = Vector2::zeros();
    let reference = TaylorSimulation::new(&Rods)
        .control_period(0.02)
        .torque(|t, q, qd| law(&mut integral, t, q, qd))
        .settings(Taylor::with_tolerance(1e-15))
        .initial(start, Vector2::zeros())
        .samples(14)
        .run()
        .unwrap();
    for (method, bound) in [
        (Method::GaussLegendre6 { step: 2e-3 }, 1e-12),
        (Method::RungeKutta4 { step: 1e-3 }, 1e-9),
        (Dop853::with_tolerance(1e-12).into(), 1e-11),
        (Radau5::with_tolerance(1e-10).into(), 1e-8),
    ] {
        let mut integral = Vector2::zeros();
        let run = Simulation::new(&Rods)
            .control_period(0.02)
            .torque(|t, q, qd| law(&mut integral, t, q, qd))
            .method(method)
            .initial(start, Vector2::zeros())
            .samples(14)
            .run()
            .unwrap();
        let error = (run.q[13] - reference.q[13]).amax();
        assert!(error < bound, "{method:?}: {error:e}");
        let error = (run.qdd[13] - reference.qdd[13]).amax();
        assert!(error < 1e3 * bound, "{method:?}: {error:e}");
    }
}

/// A force of 3 N and of none by turns against friction of 1 N: the cart of 2 kg gains 1 m/s in a second
/// under the one, and loses half of it under the other.
#[test]
fn a_jump_of_a_held_force_lets_go_and_stops() {
    for method in methods() {
        let mut on = false;
        let run = Simulation::new(&DryCart)
            .control_period(1.0)
            .torque(|_, _, _| {
                on = !on;
                Vector1::new(if on { 3.0 } else { 0.5 })
            })
            .method(method)
            .friction(Friction::Sticking)
            .duration(12.0)
            .samples(13)
            .run()
            .unwrap();
        // On for 1 s: 1 m/s. Off: 0.5 - 1 N over 2 kg is -1/4 m/s^2.
        let mut v = 0.0;
        for (k, qd) in run.qd.iter().enumerate() {
            assert!((qd[0] - v).abs() < 1e-12, "{method:?}, {k}: {} {v}", qd[0]);
            v += if k % 2 == 0 { 1.0 } else { -0.25 };
        }
    }
}

/// A wrench that is held acts as a torque that is held; one that is a function beside it stays one.
#[test]
fn forces_at_the_tool_are_held_where_they_are_asked_to_be() {
    let mut calls = 0;
    let held = Simulation::new(&Cart)
        .control_period(0.1)
        .held_tool_wrench(|t, pose, twist| {
            calls += 1;
            assert!(t < 0.95 && pose[(2, 3)].is_finite());
            Vector6::new(7.0, 0.0, 1.0 - twist[2], 0.0, 0.0, 5.0)
        })
        .run()
        .unwrap();
    assert_eq!(calls, 10);
    // v+ = v + (1 - v) p / m.
    let v = 1.0 - 0.95_f64.powi(10);
    assert!((held.qd[100][0] - v).abs() < 1e-14);
    assert!(held.tau.iter().all(|tau| tau[0] == 0.0));

    let wall = Simulation::new(&Cart)
        .tool_wrench(|_, _, twist| Vector6::new(0.0, 0.0, -2.0 * twist[2], 0.0, 0.0, 0.0))
        .control_period(0.25)
        .torque(|_, _, _| Vector1::new(2.0))
        .method(Dop853::with_tolerance(1e-13))
        .run()
        .unwrap();
    assert!((wall.qd[100][0] - (1.0 - (-1.0_f64).exp())).abs() < 1e-12);

    let error = Simulation::new(&Cart)
        .control_period(0.1)
        .held_tool_wrench(|t, _, _| Vector6::repeat(if t > 0.45 { f64::NAN } else { 0.0 }))
        .run()
        .unwrap_err();
    assert_eq!(error.cause, Cause::NonFiniteToolWrench { component: 0 });
    assert_eq!(error.time, 0.5);
}

/// Runs the cart with its settings in each order, one after the other.
macro_rules! in_order {
    ($($setting:ident($value:expr)),*) => {
        Simulation::new(&Cart)$(.$setting($value))*.run().unwrap()
    };
}

#[test]
fn the_laws_and_the_period_are_given_in_any_order() {
    let pull = |t: f64, q: &Vector1<f64>, _: &Vector1<f64>| Vector1::new(t.cos() - q[0]);
    let wall = |_: f64, pose: &Matrix4<f64>, twist: &Vector6<f64>| {
        Vector6::new(
            0.0,
            0.0,
            -800.0 * pose[(2, 3)].max(0.0) - 5.0 * twist[2],
            0.0,
            0.0,
            0.0,
        )
    };
    let p = 0.07;
    let runs = [
        in_order!(control_period(p), torque(pull), tool_wrench(wall)),
        in_order!(control_period(p), tool_wrench(wall), torque(pull)),
        in_order!(torque(pull), control_period(p), tool_wrench(wall)),
        in_order!(torque(pull), tool_wrench(wall), control_period(p)),
        in_order!(tool_wrench(wall), control_period(p), torque(pull)),
        in_order!(tool_wrench(wall), torque(pull), control_period(p)),
        in_order!(
            control_period(1.0),
            tool_wrench(wall),
            control_period(p),
            torque(pull)
        ),
    ];
    assert!(runs[0].qd.iter().any(|qd| qd[0] < 0.0) && runs[0].q[100][0] != 0.0);
    for run in &runs[1..] {
        assert_eq!(*run, runs[0]);
    }
    let held = [
        in_order!(control_period(p), torque(pull), held_tool_wrench(wall)),
        in_order!(control_period(p), held_tool_wrench(wall), torque(pull)),
        in_order!(torque(pull), control_period(p), held_tool_wrench(wall)),
        in_order!(torque(pull), held_tool_wrench(wall), control_period(p)),
        in_order!(held_tool_wrench(wall), control_period(p), torque(pull)),
        in_order!(held_tool_wrench(wall), torque(pull), control_period(p)),
    ];
    assert_ne!(held[0].q, runs[0].q);
    for run in &held[1..] {
        assert_eq!(*run, held[0]);
    }
}

#[test]
fn periods_that_make_no_sense_are_refused() {
    for period in [
        0.0,
        -0.0,
        -1e-3,
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        1e-17,
        1e-320,
    ] {
        let cause = Simulation::new(&Cart)
            .control_period(period)
            .run()
            .unwrap_err()
            .cause;
        let taylor = TaylorSimulation::new(&Cart)
            .control_period(period)
            .run()
            .unwrap_err()
            .cause;
        for cause in [cause, taylor] {
            let Cause::InvalidSetting(InvalidSetting::Period(found)) = cause else {
                panic!("{cause:?} of {period}");
            };
            assert!(found == period || found.is_nan() && period.is_nan());
        }
    }
}

#[test]
fn a_period_longer_than_the_run_asks_once() {
    for period in [1.0, 1.0 + 1e-15, 5.0, 1e300] {
        let calls = Cell::new(0);
        let run = Simulation::new(&Cart)
            .control_period(period)
            .torque(|t, _, _| {
                calls.set(calls.get() + 1);
                Vector1::new(4.0 + t)
            })
            .run()
            .unwrap();
        assert_eq!(calls.get(), 1);
        assert!((run.q[100][0] - 1.0).abs() < 1e-14);
    }
}

/// A law that returns no number ends the run at the time of its call, with all samples before.
#[test]
fn a_law_that_returns_no_number_ends_the_run() {
    for method in methods() {
        for (bad, time) in [(0, 0.0), (30, 0.3)] {
            let mut calls = 0;
            let error = Simulation::new(&Cart)
                .control_period(PERIOD)
                .torque(|_, _, _| {
                    calls += 1;
                    SVector::from([if calls > bad { f64::NAN } else { 2.0 }])
                })
                .method(method)
                .samples(11)
                .run()
                .unwrap_err();
            assert_eq!(
                error.cause,
                Cause::NonFiniteTorque { joint: 0 },
                "{method:?}"
            );
            assert_eq!((error.time, calls), (time, bad + 1), "{method:?}");
            assert!((error.q[0] - 0.5 * time * time).abs() < 1e-14);
            assert!(error.trajectory.len() >= 1 + bad / 10 - usize::from(bad > 0));
        }
    }
}

/// Damping of 5,000 N m s/rad turns the velocity of a rod around at each sample, and makes it tens of times as fast.
#[test]
fn a_sampled_law_that_diverges_is_told_as_one() {
    let controlled = [
        DormandPrince::default().into(),
        Dop853::default().into(),
        Method::from(Radau5::default()),
    ];
    for method in controlled {
        let mut run = Simulation::new(&Rods)
            .control_period(0.01)
            .torque(|_, _, qd| -5000.0 * qd)
            .method(method)
            .initial(Vector2::new(0.1, 0.0), Vector2::new(0.0, 0.0));
        let error = run.run().unwrap_err();
        let Cause::RunsAway { joint: 1, speed } = error.cause else {
            panic!("{error}");
        };
        assert!(speed > 1e5 && error.qd[1].abs() == speed);
        let named = error.naming(&Rods).to_string();
        let expected = [
            "joint 2 (elbow) runs away, at ",
            "gains are too high for its period",
        ];
        assert!(expected.iter().all(|part| named.contains(part)), "{named}");
    }
}
