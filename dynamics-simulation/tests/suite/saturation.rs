//! Torques that motors cut: the same motions as under a law that is cut by hand.

use robot_dynamics::nalgebra::{Vector1, Vector2};
use robot_dynamics::{
    NewtonEuler, Simulation, TaylorSimulation, robot_dynamics,
    simulation::{Cause, InvalidSetting},
    table::{Convention, JointType, Row, Table},
};

use crate::every_method::{controlled, fixed};

robot_dynamics! {
    /// Two carts on rails of their own, 2 kg each. The first one has a motor of 4 N.
    struct Carts;

    convention: modified,
    gravity: [0, 0, 0],
    joints: [
        rail: prismatic { mass: 0, torque_limit: 4, velocity_limit: 3 / 2 },
        cross: prismatic { alpha: PI/2, mass: 2 },
    ],
    functions: [mass_matrix, inverse_dynamics, forward_dynamics, taylor_series],
}

#[test]
fn limits_are_constants_of_the_arm() {
    assert_eq!(Carts::TORQUE_LIMITS, [Some(4.0), None]);
    assert_eq!(Carts::VELOCITY_LIMITS, [Some(1.5), None]);
    assert_eq!(Carts.table().torque_limits(), Carts::TORQUE_LIMITS);
    assert_eq!(Carts.table().velocity_limits(), Carts::VELOCITY_LIMITS);
}

type Law = fn(f64, &Vector2<f64>, &Vector2<f64>) -> Vector2<f64>;

/// From 8 to -8 N in 4 s on the first rail, 40 N on the second one.
const LAW: Law = |t, _, _| Vector2::new(8.0 - 4.0 * t, 40.0);

const CUT: Law = |t, _, _| Vector2::new((8.0 - 4.0 * t).clamp(-4.0, 4.0), 40.0);

/// The exact end on the first rail: 2 m/s after 1 s and 3 s, 0 after 4 s.
const END: f64 = 22.0 / 3.0;

#[test]
fn every_method_has_the_motion_of_the_law_that_is_cut() {
    for method in fixed(0.01).into_iter().chain(controlled(1e-9)) {
        let arm = Simulation::new(&Carts).duration(4.0).method(method);
        let saturated = arm.clone().torque(LAW).saturate().run().unwrap();
        let cut = arm.torque(CUT).run().unwrap();
        assert_eq!(
            (&saturated.q, &saturated.tau),
            (&cut.q, &cut.tau),
            "{method:?}"
        );
        assert!((saturated.q[100][0] - END).abs() < 0.05, "{method:?}");
    }
    let exact = Simulation::new(&Carts)
        .duration(4.0)
        .torque(LAW)
        .saturate()
        .run()
        .unwrap();
    assert!((exact.q[100] - Vector2::new(END, 160.0)).amax() < 1e-6);
}

#[test]
fn held_torques_and_those_of_series_are_cut() {
    let held = |law: Law| {
        Simulation::new(&Carts)
            .control_period(0.25)
            .torque(law)
            .duration(4.0)
    };
    let cut = held(CUT).run().unwrap();
    let saturated = held(LAW).saturate().run().unwrap();
    assert_eq!((&saturated.q, &saturated.tau), (&cut.q, &cut.tau));
    let series = |law: Law| {
        TaylorSimulation::new(&Carts)
            .control_period(0.25)
            .torque(law)
    };
    let cut = series(CUT).run().unwrap();
    assert_eq!(series(LAW).saturate().run().unwrap().tau, cut.tau);
    let constant = TaylorSimulation::new(&Carts).torque(Vector2::new(-9.0, 9.0));
    let motion = constant.saturate().run().unwrap();
    assert!((motion.q[100] - Vector2::new(-1.0, 2.25)).amax() < 1e-14);
}

/// An infinite torque is beyond any limit; what is no number is told.
#[test]
fn numbers_that_are_none_are_told() {
    let run = |first: f64, second: f64| {
        let law = move |_: f64, _: &Vector2<f64>, _: &Vector2<f64>| Vector2::new(first, second);
        Simulation::new(&Carts).torque(law).saturate().run()
    };
    assert_eq!(run(f64::NEG_INFINITY, 0.0).unwrap().tau[0][0], -4.0);
    for (first, second, joint) in [(f64::NAN, 0.0, 0), (0.0, f64::INFINITY, 1)] {
        let cause = run(first, second).unwrap_err().cause;
        assert_eq!(cause, Cause::NonFiniteTorque { joint });
    }
}

/// A cart of 1 kg with a motor of that force.
fn cart(limit: f64) -> NewtonEuler<1> {
    let row = Row {
        mass: 1.0,
        torque_limit: Some(limit),
        ..Row::new(JointType::Prismatic)
    };
    NewtonEuler::new(&Table::new(Convention::Standard, [0.0; 3], [row]))
}

#[test]
fn limits_that_make_no_sense_are_refused() {
    for limit in [0.0, -1.0, f64::NAN] {
        let arm = cart(limit);
        assert!(Simulation::new(&arm).run().is_ok());
        let cause = Simulation::new(&arm).saturate().run().unwrap_err().cause;
        let refused = InvalidSetting::TorqueLimit { joint: 0 };
        assert_eq!(cause, Cause::InvalidSetting(refused), "{limit}");
    }
    let endless = cart(f64::INFINITY);
    let law = |_: f64, _: &Vector1<f64>, _: &Vector1<f64>| Vector1::new(1e6);
    assert!(
        Simulation::new(&endless)
            .torque(law)
            .saturate()
            .run()
            .is_ok()
    );
}
