//! Motions by Taylor series: accuracy, starts from rest, long runs, refusals.

use std::f64::consts::FRAC_PI_2;

use robot_dynamics::nalgebra::{SVector, Vector1, Vector2, Vector6};
use robot_dynamics::{
    Method, Simulation, TaylorSimulation, Trajectory, robot_dynamics,
    simulation::{Cause, DormandPrince, InvalidSetting, Taylor, TaylorDynamics},
};
use testkit::references::{MotionFile, read};

use crate::largest;

robot_dynamics! {
    /// A slender rod that hangs at q = 0, 1 kg and 1 m.
    struct OneLink;

    convention: standard,
    gravity: [9.81, 0, 0],
    joints: [
        joint: revolute { a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1) },
    ],
    functions: [taylor_series, kinetic_energy, potential_energy],
}

robot_dynamics! {
    /// The two rods of the slides; horizontal at q = 0.
    struct TwoLink;

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { a: 2, mass: 3, com: [-1, 0, 0], inertia: rod(2) },
        elbow: revolute { a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1) },
    ],
    functions: [taylor_series, kinetic_energy, potential_energy],
}

robot_dynamics! {
    /// A rod that turns and a mass that slides along it, in oil; symbolic.
    struct Slider { m: f64, damping: f64 }

    convention: modified,
    gravity: [0, -9.81, 0],
    joints: [
        turn: revolute { mass: 2, com: [0.3, 0.1, 0], inertia: rod(1), friction: { viscous: damping } },
        slide: prismatic { alpha: -PI/2, mass: m, com: [0, 0, 0.1], friction: { viscous: 0.5 } },
    ],
    functions: [taylor_series, forward_dynamics],
}

robot_dynamics! {
    /// PUMA 560 with its motors, without friction.
    struct Puma560;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute {
            d: 0.67183, alpha: PI/2, inertia: { yy: 0.35 }, allow: [unphysical_inertia],
            motor: { inertia: 0.0002, gear_ratio: -62.6111 },
        },
        shoulder: revolute {
            a: 0.4318, mass: 17.4, com: [-0.3638, 0.006, 0.2275],
            inertia: { xx: 0.13, yy: 0.524, zz: 0.539 },
            motor: { inertia: 0.0002, gear_ratio: 107.815 },
        },
        elbow: revolute {
            d: 0.15005, a: 0.0203, alpha: -PI/2,
            mass: 4.8, com: [-0.0203, -0.0141, 0.07],
            inertia: { xx: 0.066, yy: 0.086, zz: 0.0125 }, allow: [unphysical_inertia],
            motor: { inertia: 0.0002, gear_ratio: -53.7063 },
        },
        forearm: revolute {
            d: 0.4318, alpha: PI/2, mass: 0.82, com: [0, 0.019, 0],
            inertia: { xx: 0.0018, yy: 0.0013, zz: 0.0018 },
            motor: { inertia: 3.3e-5, gear_ratio: 76.0364 },
        },
        wrist: revolute {
            alpha: -PI/2, mass: 0.34, inertia: { xx: 0.0003, yy: 0.0004, zz: 0.0003 },
            motor: { inertia: 3.3e-5, gear_ratio: 71.923 },
        },
        flange: revolute {
            mass: 0.09, com: [0, 0, 0.032], inertia: { xx: 0.00015, yy: 0.00015, zz: 4e-5 },
            motor: { inertia: 3.3e-5, gear_ratio: 76.686 },
        },
    ],
    functions: [taylor_series],
}

fn free_motion<R: TaylorDynamics<N>, const N: usize>(
    robot: &R,
    file: &MotionFile,
    settings: Taylor,
) -> Trajectory<N> {
    let (q, qd) = file.initial();
    let simulation = TaylorSimulation::new(robot)
        .initial(q, qd)
        .settings(settings);
    simulation
        .duration(10.0)
        .samples(51)
        .run()
        .expect("a motion")
}

/// The exact motion is an elliptic function, of which the file has 30 digits.
#[test]
fn one_link_at_every_tolerance() {
    let file: MotionFile = read("trajectories", "one_link_free");
    for digits in 6..=15 {
        let tolerance = 10_f64.powi(-digits);
        let motion = free_motion(&OneLink, &file, Taylor::with_tolerance(tolerance));
        let error = largest(&file.errors(&motion));
        // At most some 200 steps, and the motion makes 21 times as much of what they add; the file's
        // samples are taken between steps.
        let bound = 200.0 * 21.0 * (tolerance + f64::EPSILON);
        assert!(error < bound, "{tolerance:e}: {error:e}");
    }
}

/// The sensitivity of this motion is 2,400.
#[test]
fn two_links_at_every_tolerance() {
    let file: MotionFile = read("trajectories", "two_link_free");
    for (tolerance, bound) in [
        (1e-6, 1e-2),
        (1e-8, 1e-4),
        (1e-10, 1e-6),
        (1e-12, 1e-8),
        (1e-14, 1e-10),
        (1e-16, 2e-12),
    ] {
        let motion = free_motion(&TwoLink, &file, Taylor::with_tolerance(tolerance));
        let error = largest(&file.errors(&motion));
        assert!(error < bound, "{tolerance:e}: {error:e}");
    }
}

/// 3 s of free fall; reference of 113-bit arithmetic.
#[test]
fn puma_falls() {
    let exact = Vector6::new(
        8.901642321119427e-2,
        -1.0241413013954546,
        -14.819530413216631,
        2.763716244208434e-3,
        -1.1900645161856656e-1,
        3.629121396033928e-5,
    );
    for (tolerance, bound) in [(1e-8, 1e-6), (1e-12, 1e-10), (1e-15, 1e-13)] {
        let simulation = TaylorSimulation::new(&Puma560).duration(3.0).samples(2);
        let settings = Taylor::with_tolerance(tolerance);
        let motion = simulation.settings(settings).run().expect("a fall");
        let error = (motion.q[1] - exact).amax();
        assert!(error < bound, "{tolerance:e}: {error:e}");
    }
}

/// From rest every other coefficient vanishes, and three of four for a link that starts
/// horizontally: no order makes a giant step of it, even where steps have no bound.
#[test]
fn a_start_from_rest_is_no_blind_step() {
    let file: MotionFile = read("trajectories", "two_link_free");
    for order in 8..=30 {
        let tight = Taylor::with_tolerance(1e-14);
        let settings = tight.order(order).max_step(f64::INFINITY);
        let motion = free_motion(&TwoLink, &file, settings);
        let error = largest(&file.errors(&motion));
        assert!(error < 1e-9, "order {order}: {error:e}");

        let horizontal = Vector1::new(FRAC_PI_2);
        let swing = TaylorSimulation::new(&OneLink).initial(horizontal, Vector1::zeros());
        let swing = swing.duration(10.0).samples(101).settings(settings);
        let drift = swing.run().expect("a swing").energy_drift(&OneLink);
        assert!(drift < 1e-12, "order {order}: {drift:e}");
    }
}

/// The purpose of compensated sums: a drift of a few roundings in 1,000 s.
#[test]
fn a_long_run_keeps_its_energy() {
    let settings = Taylor::with_tolerance(1e-16);
    let start = Vector1::new(2.0);
    let swing = TaylorSimulation::new(&OneLink).initial(start, Vector1::zeros());
    let swing = swing.duration(1000.0).samples(201).settings(settings);
    let drift = swing.run().expect("a swing").energy_drift(&OneLink);
    assert!(drift < 1e-13, "{drift:e} J");

    let arm = TaylorSimulation::new(&TwoLink).duration(100.0).samples(101);
    let drift = arm.settings(settings).run().expect("a motion");
    let drift = drift.energy_drift(&TwoLink);
    assert!(drift < 1e-11, "{drift:e} J");
}

/// Samples between the steps are as accurate as their ends.
#[test]
fn samples_do_not_change_the_motion() {
    let simulation = TaylorSimulation::new(&TwoLink).duration(2.0);
    let few = simulation.clone().samples(3).run().expect("a motion");
    let many = simulation.samples(2001).run().expect("a motion");
    let difference = (few.q[1] - many.q[1000]).amax();
    assert!(difference == 0.0 && few.q[2] == many.q[2000]);
    let drift = many.energy_drift(&TwoLink);
    assert!(drift < 1e-10, "{drift:e} J");
}

/// Constant torques, viscous friction and symbolic cells, beside Dormand and Prince's method.
#[test]
fn torques_and_viscous_friction() {
    let (arm, tau) = (
        Slider {
            m: 0.7,
            damping: 0.3,
        },
        Vector2::new(2.0, -1.5),
    );
    let (q, qd) = (Vector2::new(0.4, 0.2), Vector2::new(-1.0, 0.5));
    let series = TaylorSimulation::new(&arm).torque(tau).initial(q, qd).run();
    let steps = Simulation::new(&arm)
        .torque(|_, _, _| tau)
        .initial(q, qd)
        .method(Method::DormandPrince(DormandPrince::with_tolerance(1e-13)))
        .run();
    let (series, steps) = (series.expect("a motion"), steps.expect("a motion"));
    for (a, b) in series.q.iter().zip(&steps.q) {
        let difference = (a - b).amax();
        assert!(difference < 1e-10, "{difference:e}");
    }
    assert!((series.q[100] - q).amax() > 0.1);
}

robot_dynamics! {
    /// Dry friction, which no series goes across.
    struct Dry;

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        joint: revolute { a: 1, mass: 1, friction: { coulomb: 0.1 } },
    ],
    functions: [taylor_series],
}

robot_dynamics! {
    /// A mass that slides to the axis, where nothing resists a turn.
    struct ToTheAxis;

    convention: modified,
    gravity: [0, 0, 0],
    joints: [
        turn: revolute {},
        slide: prismatic { alpha: -PI/2, mass: 1 },
    ],
    functions: [taylor_series],
}

#[test]
fn what_makes_no_sense_is_refused() {
    let cause = |simulation: TaylorSimulation<'_, OneLink, 1>| simulation.run().unwrap_err().cause;
    let free = || TaylorSimulation::new(&OneLink);
    let with = |settings: Taylor| cause(free().settings(settings));
    let order = |order| Taylor::default().order(order);
    assert_eq!(with(order(7)), InvalidSetting::Order(7).into());
    assert_eq!(with(order(31)), InvalidSetting::Order(31).into());
    let tolerance = InvalidSetting::Tolerance(0.0).into();
    assert_eq!(with(Taylor::with_tolerance(0.0)), tolerance);
    assert_eq!(cause(free().samples(1)), InvalidSetting::Samples(1).into());
    let duration = InvalidSetting::Duration(-1.0).into();
    assert_eq!(cause(free().duration(-1.0)), duration);
    let torque = cause(free().torque(Vector1::new(f64::NAN)));
    assert_eq!(torque, Cause::NonFiniteTorque { joint: 0 });
    let dry = TaylorSimulation::new(&Dry).run().unwrap_err().cause;
    assert_eq!(dry, InvalidSetting::CoulombFriction { joint: 0 }.into());
}

/// The mass is on the axis at t = 1 s, the end: the run ends just before, with what it has done.
#[test]
fn a_singular_mass_matrix_ends_the_run_where_it_is() {
    let (q, qd) = (Vector2::new(0.0, 1.0), Vector2::new(0.0, -1.0));
    let settings = Taylor::default().max_step(0.125);
    let simulation = TaylorSimulation::new(&ToTheAxis).initial(q, qd);
    let error = simulation.settings(settings).samples(9).run().unwrap_err();
    assert!(
        matches!(error.cause, Cause::SingularMassMatrix(_)),
        "{error}"
    );
    assert!((1.0 - 1e-12..1.0).contains(&error.time), "{error}");
    assert!(error.q[1] > 0.0 && error.q[1] < 1e-12, "{error}");
    assert_eq!(error.trajectory.len(), 8);
}

/// At the start itself.
#[test]
fn a_singular_start_is_an_error() {
    let still = SVector::zeros();
    let error = ToTheAxis.taylor_series::<f64>(&still, &still, &still, 10);
    assert_eq!(error.unwrap_err().joint, 0);
    let error = TaylorSimulation::new(&ToTheAxis).run().unwrap_err();
    assert_eq!(error.time, 0.0);
    assert_eq!(error.trajectory.len(), 1);
}

/// The first coefficients are those of the table's equations: q, qd, qdd / 2.
#[test]
fn the_series_begins_with_the_state() {
    let (q, qd) = (Vector1::new(0.5), Vector1::new(-0.25));
    let series = OneLink.taylor_series(&q, &qd, &Vector1::new(1.0), 4);
    let series = series.expect("a series");
    // qdd = 3 (tau - 1/2 m g a sin q) / (m a^2)
    let qdd = 3.0 * (1.0 - 0.5 * 9.81 * 0.5_f64.sin());
    // Its derivative is -3/2 g cos(q) qd.
    let jerk = -1.5 * 9.81 * 0.5_f64.cos() * -0.25;
    for (found, expected) in series.iter().zip([0.5, -0.25, qdd / 2.0, jerk / 6.0]) {
        assert!((found[0] - expected).abs() < 1e-15, "{found} {expected}");
    }
}
