//! Joints that stick, and joints that cannot: every method, to the last bit.

use std::cell::Cell;

use robot_dynamics::nalgebra::{Vector1, Vector2, Vector3};
use robot_dynamics::{
    Friction, Method, Simulation, robot_dynamics,
    simulation::{Cause, Dop853, DormandPrince, Radau5},
};

use crate::every_method::{controlled, fixed};

robot_dynamics! {
    /// Two slender rods in a vertical plane, with dry joints.
    struct DryRods { c1: f64, c2: f64 }

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { a: 2, mass: 3, com: [-1, 0, 0], inertia: rod(2), friction: { coulomb: c1 } },
        elbow: revolute { a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1), friction: { coulomb: c2 } },
    ],
    functions: [mass_matrix, inverse_dynamics, forward_dynamics, kinetic_energy, potential_energy],
}

robot_dynamics! {
    /// A cart of 2 kg on a dry rail.
    struct DryCart { coulomb: f64 }

    convention: standard,
    gravity: [0, 0, 0],
    joints: [slide: prismatic { mass: 2, friction: { coulomb: coulomb } }],
    functions: [mass_matrix, inverse_dynamics, forward_dynamics],
}

fn methods(step: f64) -> impl Iterator<Item = Method> {
    fixed(step).into_iter().chain(controlled(1e-7))
}

/// Friction of 500 N m holds a joint whatever the other does.
#[test]
fn a_joint_that_sticks_does_not_move_at_all() {
    let start = Vector2::new(0.3, -0.2);
    for (stuck, arm) in [
        DryRods { c1: 500.0, c2: 0.0 },
        DryRods { c1: 0.0, c2: 500.0 },
    ]
    .iter()
    .enumerate()
    {
        for method in [1e-2, 7e-3, 5e-3].into_iter().flat_map(methods) {
            let mut qd = Vector2::repeat(2.0);
            qd[stuck] = 0.0;
            let fall = Simulation::new(arm).initial(start, qd).duration(2.0);
            let fall = fall.samples(41).friction(Friction::Sticking);
            let run = fall.method(method).run().unwrap();
            for (q, qd) in run.q.iter().zip(&run.qd) {
                assert_eq!((q[stuck], qd[stuck]), (start[stuck], 0.0), "{method:?}");
            }
            assert!((run.q[40] - start).amax() > 0.1, "{method:?}");
        }
    }
}

/// Nor does a torque law see it move, at any stage of any step. Radau's Jacobian alone asks for the
/// torques at other velocities.
#[test]
fn a_joint_that_sticks_stands_still_at_every_stage() {
    let arm = DryRods { c1: 500.0, c2: 0.0 };
    for method in methods(1e-2).take(9) {
        let still = |_: f64, q: &Vector2<f64>, qd: &Vector2<f64>| {
            assert_eq!((q[0], qd[0]), (0.3, 0.0), "{method:?}");
            Vector2::zeros()
        };
        let fall = Simulation::new(&arm).torque(still).method(method);
        let fall = fall.initial(Vector2::new(0.3, 0.0), Vector2::new(0.0, 2.0));
        fall.friction(Friction::Sticking).run().unwrap();
    }
}

/// With its shoulder stuck the arm is a pendulum, which keeps its energy: methods in momenta see the
/// momenta of the joint that moves alone.
#[test]
fn a_stuck_joint_leaves_a_pendulum_that_keeps_its_energy() {
    let arm = DryRods { c1: 500.0, c2: 0.0 };
    let step = 1e-2;
    for (method, bound) in [
        (Method::ImplicitMidpoint { step }, 1e-3),
        (Method::GaussLegendre4 { step }, 1e-6),
        (Method::GaussLegendre6 { step }, 1e-9),
    ] {
        let fall = Simulation::new(&arm).initial(Vector2::new(0.3, 0.0), Vector2::new(0.0, 2.0));
        let fall = fall.friction(Friction::Sticking).method(method);
        let run = fall.duration(20.0).run().unwrap();
        let drift = run.energy_drift(&arm);
        assert!(drift < bound, "{method:?}: {drift:e} J");
    }
}

/// Joints that stick and slip by turns: whatever momentum a joint had when it began to stick, it starts from rest. All
/// methods agree on this.
#[test]
fn joints_that_let_go_start_from_rest() {
    let arm = DryRods { c1: 40.0, c2: 2.0 };
    let run = |method: Method| {
        let push = |t: f64, _: &Vector2<f64>, _: &Vector2<f64>| {
            Vector2::new(60.0 * (3.0 * t).sin(), 8.0 * (5.0 * t).sin())
        };
        let fall = Simulation::new(&arm).torque(push).method(method);
        let fall = fall.initial(Vector2::new(-1.5, 0.4), Vector2::zeros());
        let run = fall.friction(Friction::Sticking).duration(4.0).run();
        run.unwrap()
    };
    let exact = run(Dop853::with_tolerance(1e-12).into());
    let stuck = |i: usize| exact.qd.iter().filter(|qd| qd[i] == 0.0).count();
    assert!(stuck(0) > 2 && stuck(1) > 2, "{} {}", stuck(0), stuck(1));
    assert!(stuck(0) < 95 && stuck(1) < 95, "{} {}", stuck(0), stuck(1));
    for (method, bound) in [
        (Method::RungeKutta4 { step: 5e-3 }, 1e-7),
        (Method::ImplicitMidpoint { step: 1e-3 }, 1e-4),
        (Method::GaussLegendre4 { step: 5e-3 }, 1e-7),
        (Method::GaussLegendre6 { step: 5e-3 }, 1e-9),
        (Radau5::with_tolerance(1e-10).into(), 1e-7),
    ] {
        let error = (run(method).q[100] - exact.q[100]).amax();
        assert!(error < bound, "{method:?}: {error:e}");
    }
}

/// The way that a law ended, and how often it was called.
fn chatter(
    cart: &DryCart,
    method: Method,
    v: f64,
    law: impl Fn(f64) -> f64,
) -> (Option<Cause>, f64, u64) {
    let calls = Cell::new(0);
    let counted = |_: f64, _: &Vector1<f64>, qd: &Vector1<f64>| {
        calls.set(calls.get() + 1);
        assert!(calls.get() < 10_000_000, "{method:?} does not end");
        Vector1::new(law(qd[0]))
    };
    let start = Simulation::new(cart).torque(counted).method(method);
    let start = start.initial(Vector1::zeros(), Vector1::new(v));
    let run = start.friction(Friction::Sticking).duration(2.0).samples(5);
    match run.run() {
        Ok(_) => (None, 2.0, calls.get()),
        Err(error) => (Some(error.cause), error.time, calls.get()),
    }
}

/// A brake that has a sign at zero velocity pushes a cart that it has stopped, harder than friction
/// holds it, and pushes it back as soon as it moves: there is no motion.
#[test]
fn a_law_that_drives_a_joint_back_from_both_sides_is_an_error_of_that_joint() {
    let cart = DryCart { coulomb: 3.0 };
    for step in [1e-2, 1e-3, 2e-2] {
        for v in [1.0, 0.7, 3.0, -1.0] {
            for gain in [6.0, 4.0, 50.0] {
                let stop = f64::abs(v) * 2.0 / (gain + 3.0);
                for method in methods(step) {
                    let (cause, time, calls) = chatter(&cart, method, v, |v| -gain * v.signum());
                    let place = format!("{method:?}, v = {v}, gain {gain}: t = {time}");
                    assert_eq!(cause, Some(Cause::Chatter { joint: 0 }), "{place}");
                    // RK4 goes on for some steps that have stages on both sides of the jump.
                    let late = (time - stop) / step;
                    assert!((-2.1..10.0).contains(&late), "{place}, not {stop}");
                    assert!(calls < 20_000, "{place}: {calls} calls");
                }
            }
        }
    }
}

/// A jump that is not at zero velocity, but where no double tells it from zero beside the cart's: the
/// events come as close as the rounding of the time. Where steps are equal nothing else would end it.
#[test]
fn events_without_end_are_an_error_of_their_joint() {
    let cart = DryCart { coulomb: 3.0 };
    let law = |v: f64| if v >= -1e-30 { -6.0 } else { 6.0 };
    for method in [1e-2, 3e-3].map(|step| Method::RungeKutta4 { step }) {
        let (cause, time, calls) = chatter(&cart, method, 1.0, law);
        assert_eq!(cause, Some(Cause::Chatter { joint: 0 }), "{method:?}");
        assert!((time - 2.0 / 9.0).abs() < 0.02, "{time}");
        assert!(calls < 300_000, "{calls} calls");
    }
    let bounded = DormandPrince::with_tolerance(1e-7).max_steps(500);
    let (cause, ..) = chatter(&cart, bounded.into(), 1.0, law);
    assert_eq!(cause, Some(Cause::Chatter { joint: 0 }));
}

robot_dynamics! {
    /// A lift on a spring, and two rods with dry joints, all of which have stops.
    struct DryLift;

    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        a: prismatic {
            mass: 3, com: [0, 0.1, 0.1], inertia: cuboid(0.1, 0.2, 0.3), limits: [-0.1, 0.3],
            spring: { stiffness: 200, rest: 0.1 },
        },
        b: revolute {
            a: 0.1, alpha: PI/2, mass: 2, com: [0.25, 0, 0.02], inertia: rod(0.5), limits: [-1, 1.2],
            friction: {
                viscous: 0.1, coulomb: { positive: 0.9, negative: 0.4 }, stribeck: { static: 1.4, velocity: 0.1 },
            },
        },
        c: revolute {
            a: 0.5, mass: 1, com: [0.2, 0, 0], inertia: rod(0.4), limits: [-0.8, 0.9], friction: { coulomb: 0.3 },
        },
    ],
    functions: [mass_matrix, inverse_dynamics, forward_dynamics],
}

/// Where joints lean, stick and slide at once, letting go of one after the other turned back and forth: constant torques
/// ended in an error.
#[test]
fn constant_torques_give_no_chatter() {
    let starts = [
        [
            [-0.1, 0.9040583364042221, 0.638871722354639],
            [2.6215350890507025, 2.45011107092599, -1.4925095445171088],
            [-17.06668397435851, 0.0, 0.0],
        ],
        [
            [-0.1, 1.2, 0.5248216266320473],
            [
                -1.7155424696205446,
                -0.3735257199023865,
                -1.6647796552768757,
            ],
            [-15.823715719065351, 0.0, 0.8446116908409174],
        ],
    ];
    for [q, qd, tau] in starts.map(|start| start.map(Vector3::from)) {
        let run = Simulation::new(&DryLift)
            .initial(q, qd)
            .torque(|_, _, _| tau);
        let run = run.friction(Friction::Sticking).stops(0.0).duration(0.5);
        let run = run.method(Method::ImplicitMidpoint { step: 5e-4 }).run();
        assert!(run.unwrap().work.evaluations < 20_000);
    }
}
