//! Joints at the ends of their ranges: stops against exact solutions, and limits that are errors.

use std::cell::Cell;

use robot_dynamics::nalgebra::{Const, SMatrix, SVector, Vector1, Vector2, Vector3};
use robot_dynamics::{
    Friction, Method, Model, NewtonEuler, Simulation, TaylorSimulation, Trajectory, robot_dynamics,
    simulation::{Cause, Dop853, DormandPrince, EquationsOfMotion, InvalidSetting, Radau5, Taylor},
    table::{Convention, JointType, Row, Table},
};

robot_dynamics! {
    /// A ball of 2 kg that falls along z onto the ground.
    struct Ball;

    convention: modified,
    gravity: [0, 0, -10],
    joints: [height: prismatic { mass: 2, limits: [0, 20] }],
    functions: [
        mass_matrix, inverse_dynamics, forward_dynamics, kinetic_energy, potential_energy, taylor_series,
    ],
}

robot_dynamics! {
    /// Two slender rods in a vertical plane whose joints have stops.
    struct Rods;

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { a: 2, mass: 3, com: [-1, 0, 0], inertia: rod(2), limits: [-2.5, 0.6] },
        elbow: revolute { a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1), limits: [-1, 0.6] },
    ],
    functions: [
        mass_matrix, inverse_dynamics, forward_dynamics, kinetic_energy, potential_energy, taylor_series,
    ],
}

/// The methods that are exact under constant forces.
fn methods() -> [Method; 8] {
    let step = 0.03;
    [
        Method::CraigEuler { step },
        Method::RungeKutta4 { step },
        Method::ImplicitMidpoint { step },
        Method::GaussLegendre4 { step },
        Method::GaussLegendre6 { step: 0.3 },
        DormandPrince::default().into(),
        Dop853::default().into(),
        Radau5::default().into(),
    ]
}

/// A ball that falls from `height` at t = 0 under 10 m/s^2, at time `t`: its height and velocity, and how
/// often it hit the ground.
fn bouncing(height: f64, restitution: f64, t: f64) -> (f64, f64, u32) {
    let mut start = (height / 5.0).sqrt();
    if t < start {
        return (height - 5.0 * t * t, -10.0 * t, 0);
    }
    let mut speed = 10.0 * start;
    for bounces in 1..10_000 {
        speed *= restitution;
        let s = t - start;
        let flight = speed / 5.0;
        if s < flight {
            return (speed * s - 5.0 * s * s, speed - 10.0 * s, bounces);
        }
        start += flight;
    }
    (0.0, 0.0, u32::MAX)
}

fn dropped(method: Method, restitution: f64, duration: f64, samples: usize) -> Trajectory<1> {
    Simulation::new(&Ball)
        .initial(Vector1::new(1.25), Vector1::zeros())
        .stops(restitution)
        .method(method)
        .duration(duration)
        .samples(samples)
        .run()
        .unwrap()
}

/// After n bounces the energy is e^(2 n) of what it was.
#[test]
fn a_ball_bounces_as_it_must() {
    for method in methods() {
        for restitution in [0.6, 0.9, 1.0] {
            let run = dropped(method, restitution, 3.3, 24);
            let energies = run.energies(&Ball);
            for (k, &t) in run.t.iter().enumerate() {
                let (height, speed, bounces) = bouncing(1.25, restitution, t);
                let errors = [run.q[k][0] - height, run.qd[k][0] - speed];
                let what = format!("{method:?}, e = {restitution}, t = {t}: {errors:?}");
                assert!(errors.iter().all(|error| error.abs() < 1e-12), "{what}");
                let left = 25.0 * restitution.powf(2.0 * f64::from(bounces));
                assert!((energies[k] - left).abs() < 1e-12, "{what}");
            }
        }
    }
}

/// Infinitely many bounces that take 1/2 s + 2 (1/2 s) e / (1 - e) = 3/2 s.
#[test]
fn bounces_that_die_out_end_in_rest() {
    for method in methods() {
        let run = dropped(method, 0.5, 3.9, 41);
        for (k, &t) in run.t.iter().enumerate() {
            let (height, speed, _) = bouncing(1.25, 0.5, t);
            assert!((run.q[k][0] - height).abs() < 1e-12, "{method:?} {t}");
            if t > 1.51 {
                let at_rest = [run.q[k][0], run.qd[k][0], run.qdd[k][0]];
                assert_eq!(at_rest, [0.0; 3], "{method:?} {t}");
            } else if t < 1.45 {
                assert!((run.qd[k][0] - speed).abs() < 1e-11, "{method:?} {t}");
            }
        }
        assert!(run.work.evaluations < 20_000, "{method:?}: {:?}", run.work);
    }
}

/// Pressed down with 1 - t at most 20 N beyond its weight, the ball lifts off at 1 s, by a third power.
#[test]
fn what_rests_on_a_stop_lifts_off_where_the_force_changes_sign() {
    for method in methods().into_iter().skip(1) {
        let run = Simulation::new(&Ball)
            .torque(|t, _, _| Vector1::new(20.0 - 12.0 * (1.0 - t)))
            .stops(0.0)
            .method(method)
            .duration(1.7)
            .samples(18)
            .run()
            .unwrap();
        for (k, &t) in run.t.iter().enumerate() {
            let free = f64::max(t - 1.0, 0.0);
            // The midpoint rule has an error of h^2 t / 24 there.
            let bound = match method {
                Method::ImplicitMidpoint { .. } => 1e-3,
                _ => 1e-10,
            };
            assert!((run.q[k][0] - free.powi(3)).abs() < bound, "{method:?} {t}");
            if t < 0.99 {
                assert_eq!((run.q[k][0], run.qd[k][0]), (0.0, 0.0), "{method:?} {t}");
            }
        }
    }
}

fn mass_matrix(q: &Vector2<f64>) -> SMatrix<f64, 2, 2> {
    Rods.mass_matrix(q)
}

/// qd+ = qd- - (1 + e) M^-1 e_i qd_i- / (M^-1)_ii, at the instant of the impact.
#[test]
fn an_impact_goes_through_the_arm() {
    let start = (Vector2::new(-0.3, 0.2), Vector2::new(1.0, -2.0));
    let accurate = Dop853::with_tolerance(1e-13);
    let hit = Simulation::new(&Rods)
        .initial(start.0, start.1)
        .limits_are_errors()
        .method(accurate)
        .run()
        .unwrap_err();
    let Cause::JointLimit { joint, limit } = hit.cause else {
        panic!("{hit}");
    };
    assert_eq!((joint, limit), (1, 0.6));
    assert!((hit.q[1] - 0.6).abs() < 1e-12 && hit.qd[1] > 0.5, "{hit}");
    assert!(
        hit.to_string().contains("joint 2 passes its limit 0.6"),
        "{hit}"
    );
    assert_eq!(hit.trajectory.len(), (hit.time * 100.0) as usize + 1);

    for restitution in [0.0, 0.3, 1.0] {
        let after = Simulation::new(&Rods)
            .initial(start.0, start.1)
            .stops(restitution)
            .method(accurate)
            .duration(hit.time + 1e-9)
            .samples(2)
            .run()
            .unwrap();
        let inverse = mass_matrix(&hit.q).try_inverse().unwrap();
        let column: Vector2<f64> = inverse.column(1).into();
        let expected = hit.qd - column * ((1.0 + restitution) * hit.qd[1] / inverse[(1, 1)]);
        let error = (after.qd[1] - expected).amax();
        assert!(error < 1e-6, "e = {restitution}: {error:e}");
        assert!(after.q[1][1] <= 0.6);
    }
}

fn energy_drift(method: Method) -> (f64, Trajectory<2>) {
    let run = Simulation::new(&Rods)
        .initial(Vector2::new(-0.3, 0.2), Vector2::new(1.0, -2.0))
        .stops(1.0)
        .method(method)
        .duration(5.0)
        .run()
        .unwrap();
    (run.energy_drift(&Rods), run)
}

/// Elastic stops lose nothing, whatever the method but what it loses itself, and no joint passes one.
#[test]
fn elastic_stops_keep_the_energy_of_an_arm() {
    for (method, bound) in [
        (Method::GaussLegendre6 { step: 2e-3 }, 1e-10),
        (Method::RungeKutta4 { step: 2e-3 }, 1e-6),
        (Dop853::with_tolerance(1e-12).into(), 1e-9),
        (DormandPrince::with_tolerance(1e-10).into(), 1e-7),
        (Radau5::with_tolerance(1e-10).into(), 1e-6),
    ] {
        let (drift, run) = energy_drift(method);
        assert!(drift < bound, "{method:?}: {drift:e} J");
        for q in &run.q {
            let inside = (-2.5..=0.6).contains(&q[0]) && (-1.0..=0.6).contains(&q[1]);
            assert!(inside, "{method:?}: {q}");
        }
        let turns = run
            .qd
            .windows(2)
            .filter(|v| v[0][1] * v[1][1] < 0.0)
            .count();
        assert!(turns > 10, "{turns}");
    }
}

/// Stops that lose energy lose it all, and never feed any: the arm ends on a stop, or hanging.
#[test]
fn inelastic_stops_only_take_energy() {
    for restitution in [0.0, 0.5, 0.8] {
        let run = Simulation::new(&Rods)
            .initial(Vector2::new(-0.3, 0.2), Vector2::new(1.0, -2.0))
            .stops(restitution)
            .method(Dop853::with_tolerance(1e-10))
            .duration(4.0)
            .run()
            .unwrap();
        let energies = run.energies(&Rods);
        assert!(energies.windows(2).all(|pair| pair[1] < pair[0] + 1e-8));
        assert!(energies[100] < energies[0] - 0.5, "{restitution}");
    }
}

fn slide(mass: f64, limits: Option<[f64; 2]>) -> Row {
    Row {
        mass,
        limits,
        ..Row::new(JointType::Prismatic)
    }
}

/// Slides along x, y and z, one on the other, without gravity.
fn gantry(limits: [Option<[f64; 2]>; 3]) -> NewtonEuler<3> {
    use core::f64::consts::FRAC_PI_2;
    let mut rows = limits.map(|limits| slide(1.0, limits));
    (rows[1].alpha, rows[1].theta) = (FRAC_PI_2, FRAC_PI_2);
    rows[2].alpha = FRAC_PI_2;
    NewtonEuler::new(&Table::new(Convention::Modified, [0.0; 3], rows))
}

/// Three joints that hit at once come back at once, each with its speed; bounces of one are no business
/// of the others.
#[test]
fn several_joints_hit_at_once() {
    let unit = Some([-1.0, 1.0]);
    let arm = gantry([unit, Some([-3.0, 1.0]), None]);
    for method in methods() {
        let run = Simulation::new(&arm)
            .initial(Vector3::zeros(), Vector3::new(-2.0, 2.0, 5.0))
            .stops(0.5)
            .method(method)
            .duration(1.5)
            .samples(4)
            .run()
            .unwrap();
        // At 1/2 s two joints hit; at 1 s and 1.5 s they are on the way back.
        let expected = [Vector3::new(-0.5, 0.5, 5.0), Vector3::new(0.0, 0.0, 7.5)];
        for (k, expected) in [(2, expected[0]), (3, expected[1])] {
            assert!(
                (run.q[k] - expected).amax() < 1e-12,
                "{method:?}: {}",
                run.q[k]
            );
        }
        assert_eq!(run.qd[3], Vector3::new(1.0, -1.0, 5.0), "{method:?}");
    }
}

/// A cart of 1 kg on a cart of 1 kg, along one axis. The lower one is held at its stop as the upper one
/// hits its own and drags it away: 1 m/s of one becomes that of two together where nothing bounces.
#[test]
fn a_joint_that_leans_on_its_stop_is_dragged_away_by_another() {
    let rows = [slide(1.0, Some([0.0, 9.0])), slide(1.0, Some([-9.0, 1.0]))];
    let carts = NewtonEuler::new(&Table::new(Convention::Modified, [0.0; 3], rows));
    for method in methods() {
        let run = Simulation::new(&carts)
            .initial(Vector2::zeros(), Vector2::new(0.0, 1.0))
            .stops(0.0)
            .method(method)
            .duration(3.0)
            .samples(4)
            .run()
            .unwrap();
        let q = run.q[3];
        assert!(
            (q - Vector2::new(1.0, 1.0)).amax() < 1e-12,
            "{method:?}: {q}"
        );
    }
}

/// A block of 1 kg with friction of 1 N: from 2 m/s over 1.5 m it arrives with 1 m/s, leaves with 1/2 m/s
/// and stops after 1/8 m. Held against the stop by 1.5 N and pulled with 0.9 N, it stays.
#[test]
fn stops_and_friction_meet() {
    let row = Row {
        coulomb: [1.0; 2],
        ..slide(1.0, Some([0.0, 1.5]))
    };
    let block = NewtonEuler::new(&Table::new(Convention::Modified, [0.0; 3], [row]));
    for method in methods() {
        let run = Simulation::new(&block)
            .friction(Friction::Sticking)
            .stops(0.5)
            .initial(Vector1::zeros(), Vector1::new(2.0))
            .method(method)
            .duration(2.0)
            .samples(5)
            .run()
            .unwrap();
        assert!(
            (run.q[4][0] - 1.375).abs() < 1e-12,
            "{method:?}: {}",
            run.q[4]
        );
        assert_eq!((run.qd[4][0], run.qdd[4][0]), (0.0, 0.0), "{method:?}");
        if matches!(method, Method::CraigEuler { .. }) {
            // This method does not see a force that is zero at the start of a step.
            continue;
        }
        for kind in [Friction::Sign, Friction::Sticking] {
            // From 1.5 N on the stop to a pull of 1.5 N: it moves from 5/6 of the time on.
            let run = Simulation::new(&block)
                .torque(|t, _, _| Vector1::new(1.5 - 3.0 * t))
                .friction(kind)
                .stops(0.5)
                .initial(Vector1::new(1.5), Vector1::zeros())
                .method(method)
                .duration(0.84)
                .samples(85)
                .run()
                .unwrap();
            for (t, q) in run.t.iter().zip(&run.q) {
                assert_eq!(q[0] < 1.5, *t > 5.0 / 6.0, "{method:?} {kind:?} {t}: {q}");
            }
        }
    }
}

/// With its law sampled, the ball is caught: the force is held over the impact.
#[test]
fn stops_and_sampled_laws_meet() {
    for method in methods() {
        let mut calls = 0;
        let run = Simulation::new(&Ball)
            .initial(Vector1::new(1.25), Vector1::zeros())
            .control_period(0.3)
            .torque(|_, _, _| {
                calls += 1;
                // The weight, from 0.6 s on: it goes on as it is.
                Vector1::new(if calls > 2 { 20.0 } else { 0.0 })
            })
            .stops(0.8)
            .method(method)
            .samples(11)
            .run()
            .unwrap();
        let (height, speed, _) = bouncing(1.25, 0.8, 0.6);
        let expected = height + speed * 0.4;
        assert!((run.q[10][0] - expected).abs() < 1e-12, "{method:?}");
        assert_eq!(calls, 4);
    }
}

#[test]
fn limits_that_are_errors_are_found_where_they_are_passed() {
    let limits = Some([-1.0, 0.5]);
    let arm = gantry([None, limits, None]);
    for method in methods() {
        let run = |speed: f64| {
            Simulation::new(&arm)
                .initial(Vector3::zeros(), Vector3::new(9.0, speed, 9.0))
                .limits_are_errors()
                .method(method)
                .samples(11)
                .run()
        };
        for (speed, time, limit) in [(1.0, 0.5, 0.5), (-4.0, 0.25, -1.0)] {
            let error = run(speed).unwrap_err();
            let cause = Cause::JointLimit { joint: 1, limit };
            assert_eq!(error.cause, cause, "{method:?}");
            assert!(
                (error.time - time).abs() < 1e-12,
                "{method:?}: {}",
                error.time
            );
            assert!(
                (error.q[1] - limit).abs() < 1e-12,
                "{method:?}: {}",
                error.q
            );
        }
        // A joint that reaches its limit at the end, or rests there, does not pass it.
        assert!(run(0.4999).is_ok(), "{method:?}");
        let rests = Simulation::new(&arm)
            .initial(Vector3::new(0.0, 0.5, 0.0), Vector3::zeros())
            .limits_are_errors()
            .method(method);
        assert!(rests.run().is_ok(), "{method:?}");
    }
}

/// A limit that is passed within a step, and come back from.
#[test]
fn a_visit_beyond_a_limit_within_one_step_is_seen() {
    // x = t (1 - t) passes 0.2 and is back at 0 after the only step.
    let row = slide(1.0, Some([-1.0, 0.2]));
    let cart = NewtonEuler::new(&Table::new(Convention::Modified, [0.0; 3], [row]));
    let run = Simulation::new(&cart)
        .torque(|_, _, _| Vector1::new(-2.0))
        .initial(Vector1::zeros(), Vector1::new(1.0))
        .method(Method::RungeKutta4 { step: 1.0 })
        .limits_are_errors()
        .samples(2)
        .run();
    let time = 0.5 - 0.05_f64.sqrt();
    assert!((run.unwrap_err().time - time).abs() < 1e-11);
}

fn setting(
    result: Result<Trajectory<3>, Box<robot_dynamics::SimulationError<3>>>,
) -> InvalidSetting {
    match result.unwrap_err().cause {
        Cause::InvalidSetting(setting) => setting,
        cause => panic!("{cause}"),
    }
}

#[test]
fn ranges_restitutions_and_starts_that_make_no_sense_are_refused() {
    let (nan, inf) = (f64::NAN, f64::INFINITY);
    for range in [
        [1.0, -1.0],
        [0.0, 0.0],
        [nan, 1.0],
        [-1.0, nan],
        [nan, nan],
        [inf, inf],
    ] {
        let arm = gantry([None, None, Some(range)]);
        let refused = InvalidSetting::Limits { joint: 2 };
        assert_eq!(setting(Simulation::new(&arm).stops(0.5).run()), refused);
        assert_eq!(
            setting(Simulation::new(&arm).limits_are_errors().run()),
            refused
        );
        // As long as nobody asks for limits they are passed.
        assert!(Simulation::new(&arm).run().is_ok());
    }
    let arm = gantry([None, Some([-inf, 0.5]), None]);
    for restitution in [nan, inf, -0.1, 1.0 + 1e-15, -inf] {
        let InvalidSetting::Restitution(found) =
            setting(Simulation::new(&arm).stops(restitution).run())
        else {
            panic!("{restitution}");
        };
        assert!(found == restitution || found.is_nan() && restitution.is_nan());
    }
    let start = Vector3::new(7.0, 0.75, -7.0);
    let outside = Simulation::new(&arm).initial(start, SVector::zeros());
    for outside in [outside.clone().stops(1.0), outside.limits_are_errors()] {
        let error = outside.run().unwrap_err();
        let (joint, q, limits) = (1, 0.75, [-inf, 0.5]);
        let refused = InvalidSetting::OutsideLimits { joint, q, limits };
        assert_eq!(error.cause, Cause::InvalidSetting(refused));
        let said = error.to_string();
        assert!(
            said.contains("joint 2 begins at 0.75, outside of its limits -inf to 0.5"),
            "{said}"
        );
    }
}

/// Begun on a stop and against it: thrown back at once, as it leans on it: held.
#[test]
fn a_run_may_begin_on_a_stop() {
    for method in methods() {
        // Thrown back with 2.5 m/s it is down again after 1/2 s; lifted with 15.2 N it falls by 2.4 m/s^2.
        for (speed, force, expected) in [(-5.0, 0.0, 0.0), (0.0, 0.0, 0.0), (5.0, 15.2, 2.2)] {
            let run = Simulation::new(&Ball)
                .initial(Vector1::zeros(), Vector1::new(speed))
                .torque(|_, _, _| Vector1::new(force))
                .stops(0.5)
                .method(method)
                .duration(0.5)
                .samples(3)
                .run()
                .unwrap();
            let found = run.q[2][0];
            assert!(
                (found - expected).abs() < 1e-12,
                "{method:?}, {speed}: {found}"
            );
            assert_eq!(run.qd[0][0], speed);
            assert_eq!(run.q[1][0] > 0.3, speed != 0.0);
        }
    }
}

/// Newton-Euler, which nothing was generated from, moves as the generated arm does.
#[test]
fn newton_euler_moves_as_the_generated_arm() {
    let numeric = NewtonEuler::new(&Rods.table());
    assert_eq!(NewtonEuler::<2>::JOINT_NAMES, ["joint_1", "joint_2"]);
    assert_eq!(numeric.table(), Rods.table());
    fn run(arm: &(impl EquationsOfMotion<Const<2>> + Model<2>), method: Method) -> Trajectory<2> {
        Simulation::new(arm)
            .initial(Vector2::new(-0.3, 0.2), Vector2::new(1.0, -2.0))
            .stops(0.7)
            .method(method)
            .duration(2.0)
            .samples(6)
            .run()
            .unwrap()
    }
    for method in [
        Dop853::with_tolerance(1e-12).into(),
        Radau5::with_tolerance(1e-9).into(),
        Method::GaussLegendre4 { step: 5e-3 },
    ] {
        let (generated, numeric) = (run(&Rods, method), run(&numeric, method));
        for k in 0..6 {
            let error = (generated.q[k] - numeric.q[k]).amax();
            assert!(error < 1e-8, "{method:?}, {k}: {error:e}");
        }
    }
}

/// The ball by its series, with steps as long as a flight.
fn dropped_by_series(restitution: f64, duration: f64, samples: usize) -> Trajectory<1> {
    TaylorSimulation::new(&Ball)
        .initial(Vector1::new(1.25), Vector1::zeros())
        .stops(restitution)
        .settings(Taylor::default().max_step(f64::INFINITY))
        .duration(duration)
        .samples(samples)
        .run()
        .unwrap()
}

/// The times of impacts are zeros of polynomials of order 2: nothing is lost but rounding.
#[test]
fn series_bounce_as_they_must() {
    for restitution in [0.5, 0.6, 0.9, 1.0] {
        let run = dropped_by_series(restitution, 3.3, 24);
        for (k, &t) in run.t.iter().enumerate() {
            let (height, speed, bounces) = bouncing(1.25, restitution, t);
            let errors = [run.q[k][0] - height, run.qd[k][0] - speed];
            let what = format!("e = {restitution}, t = {t}: {errors:?}");
            assert!(errors[0].abs() < 1e-13, "{what}");
            // Where infinitely many bounces have ended, or are about to.
            assert!(errors[1].abs() < 1e-11, "{what}");
            assert!(
                restitution > 0.5 || t < 1.6 || bounces == u32::MAX,
                "{what}"
            );
        }
        if restitution == 1.0 {
            // A step for each flight.
            assert_eq!(run.work.steps, 4, "{:?}", run.work);
        }
    }
    let rest = dropped_by_series(0.5, 3.9, 41);
    for k in 17..41 {
        let at_rest = [rest.q[k][0], rest.qd[k][0], rest.qdd[k][0]];
        assert_eq!(at_rest, [0.0; 3], "{}", rest.t[k]);
    }
}

/// Thrown up at 6 m/s from 18.75 m it would be back below its limit of 20 m at the end of the step.
#[test]
fn series_see_a_limit_that_is_passed_and_left_within_a_step() {
    let thrown = TaylorSimulation::new(&Ball)
        .initial(Vector1::new(18.75), Vector1::new(6.0))
        .settings(Taylor::default().max_step(f64::INFINITY))
        .samples(2);
    let speed = 11.0_f64.sqrt();
    let hit = 0.6 - 0.1 * speed;
    let error = thrown.clone().limits_are_errors().run().unwrap_err();
    let limit = 20.0;
    assert_eq!(error.cause, Cause::JointLimit { joint: 0, limit });
    assert!((error.time - hit).abs() < 1e-12, "{}", error.time);
    let run = thrown.stops(1.0).run().unwrap();
    let left = 1.0 - hit;
    let expected = 20.0 - speed * left - 5.0 * left * left;
    assert!((run.q[1][0] - expected).abs() < 1e-13, "{}", run.q[1]);
    assert_eq!(run.work.steps, 2, "{:?}", run.work);
}

fn rods_by_series() -> TaylorSimulation<'static, Rods, 2> {
    TaylorSimulation::new(&Rods).initial(Vector2::new(-0.3, 0.2), Vector2::new(1.0, -2.0))
}

/// Joints hit, bounce, lean and are let go at the same times by series and by DOP853.
#[test]
fn series_meet_stops_where_other_methods_do() {
    let accurate = Dop853::with_tolerance(1e-13);
    let by_steps = Simulation::new(&Rods)
        .initial(Vector2::new(-0.3, 0.2), Vector2::new(1.0, -2.0))
        .method(accurate);
    let [first, second] = [
        by_steps.clone().limits_are_errors().run().unwrap_err(),
        rods_by_series().limits_are_errors().run().unwrap_err(),
    ];
    assert_eq!(first.cause, second.cause);
    assert!((first.time - second.time).abs() < 1e-12);
    assert!((first.qd - second.qd).amax() < 1e-11);

    // A torque that presses the elbow against its stop, until the shoulder swings back.
    let tau = Vector2::new(0.0, 4.0);
    let by_steps = by_steps.torque(|_, _, _| tau);
    for restitution in [0.0, 0.3, 0.7] {
        let [by_steps, by_series] = [
            by_steps.clone().stops(restitution).duration(2.0).run(),
            rods_by_series()
                .torque(tau)
                .stops(restitution)
                .duration(2.0)
                .run(),
        ]
        .map(Result::unwrap);
        let mut leans = 0;
        for k in 0..by_steps.len() {
            let difference = (by_steps.q[k] - by_series.q[k]).amax();
            let t = by_steps.t[k];
            assert!(
                difference < 1e-9,
                "e = {restitution}, t = {t}: {difference:e}"
            );
            let at_rest = |run: &Trajectory<2>| (0..2).filter(|i| run.qd[k][*i] == 0.0).count();
            leans += at_rest(&by_series);
            assert_eq!(
                at_rest(&by_steps),
                at_rest(&by_series),
                "e = {restitution}, t = {t}"
            );
        }
        let some = 10..by_steps.len() - 10;
        assert!(restitution > 0.0 || some.contains(&leans), "{leans}");
    }
    let elastic = rods_by_series()
        .settings(Taylor::with_tolerance(1e-16))
        .stops(1.0)
        .duration(5.0)
        .run()
        .unwrap();
    let drift = elastic.energy_drift(&Rods);
    assert!(drift < 1e-12, "{drift:e} J");
    for q in &elastic.q {
        let inside = (-2.5..=0.6).contains(&q[0]) && (-1.0..=0.6).contains(&q[1]);
        assert!(inside, "{q}");
    }
}

/// As by the other methods: the ball is caught by a law that is sampled, and settings are refused.
#[test]
fn series_with_stops_take_sampled_laws_and_refuse_what_is_no_setting() {
    let mut calls = 0;
    let run = TaylorSimulation::new(&Ball)
        .initial(Vector1::new(1.25), Vector1::zeros())
        .stops(0.8)
        .control_period(0.3)
        .torque(|_, _, _| {
            calls += 1;
            Vector1::new(if calls > 2 { 20.0 } else { 0.0 })
        })
        .samples(11)
        .run()
        .unwrap();
    let (height, speed, _) = bouncing(1.25, 0.8, 0.6);
    assert!((run.q[10][0] - height - speed * 0.4).abs() < 1e-13);
    assert_eq!(calls, 4);
    let ball = TaylorSimulation::new(&Ball);
    let refused = |run: TaylorSimulation<'_, Ball, 1>| run.run().unwrap_err().cause;
    let restitution = InvalidSetting::Restitution(1.5);
    assert_eq!(
        refused(ball.clone().stops(1.5)),
        Cause::InvalidSetting(restitution)
    );
    let outside = ball.initial(Vector1::new(-1.0), Vector1::zeros());
    let setting = InvalidSetting::OutsideLimits {
        joint: 0,
        q: -1.0,
        limits: [0.0, 20.0],
    };
    assert_eq!(
        refused(outside.limits_are_errors()),
        Cause::InvalidSetting(setting)
    );
}

robot_dynamics! {
    /// Two slender rods that torques press against their stops.
    struct Pressed;

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        a: revolute { a: 0.5, mass: 2, com: [-0.25, 0, 0], inertia: rod(0.5), limits: [-1, 1.2] },
        b: revolute { a: 0.4, mass: 1, com: [-0.2, 0, 0], inertia: rod(0.4), limits: [-0.8, 0.9] },
    ],
    functions: [
        mass_matrix, inverse_dynamics, forward_dynamics, kinetic_energy, potential_energy, taylor_series,
    ],
}

/// A run from rest under constant torques, and how often they were asked for.
fn pressed(tau: Vector2<f64>, restitution: f64, method: Method) -> (Trajectory<2>, u64) {
    let calls = Cell::new(0);
    let torque = |_: f64, _: &Vector2<f64>, _: &Vector2<f64>| {
        calls.set(calls.get() + 1);
        assert!(calls.get() < 1_000_000, "{method:?} does not end");
        tau
    };
    let run = Simulation::new(&Pressed).torque(torque).stops(restitution);
    let run = run.method(method).duration(2.0).run().unwrap();
    (run, calls.get())
}

/// Some 1,600 bounces in one step, each a two-hundredth slower than the last, are no chatter: they last 0.2 s.
#[test]
fn a_long_row_of_bounces_in_one_step_ends_in_rest() {
    let run = Simulation::new(&Ball)
        .initial(Vector1::new(1.25e-6), Vector1::zeros())
        .stops(0.995)
        .method(Method::RungeKutta4 { step: 1.0 })
        .samples(2)
        .run()
        .unwrap();
    let at_rest = [run.q[1][0], run.qd[1][0], run.qdd[1][0]];
    assert_eq!(at_rest, [0.0; 3]);
    assert!((1_200..2_000).contains(&run.work.steps), "{:?}", run.work);
}

/// Joints that throw each other off their stops bounce ever less, and come to rest together: at their stops, exactly.
#[test]
fn two_joints_come_to_rest_at_their_stops() {
    let others = [
        Method::RungeKutta4 { step: 1e-3 },
        Method::GaussLegendre4 { step: 2e-3 },
        Dop853::default().into(),
    ];
    let tau = Vector2::new(20.0, -10.0);
    let starts = others.map(|method| (tau, 0.3, method));
    let by_default = [
        (tau, 0.0),
        (tau, 0.1),
        (tau, 0.3),
        (Vector2::new(25.0, -9.0), 0.3),
        (Vector2::new(-15.0, -2.0), 0.5),
        (Vector2::new(20.0, -5.0), 0.3),
    ];
    let by_default = by_default.map(|(tau, e)| (tau, e, Method::default()));
    for (tau, restitution, method) in starts.into_iter().chain(by_default) {
        let (run, calls) = pressed(tau, restitution, method);
        let what = format!("{tau}, e = {restitution}, {method:?}: {calls} calls");
        assert!(calls < 100_000, "{what}");
        let energies = run.energies(&Pressed);
        let left = |k: usize| energies[k] - tau.dot(&run.q[k]);
        assert!((1..101).all(|k| left(k) < left(k - 1) + 1e-6), "{what}");
        if tau[0] == 20.0 && tau[1] == -10.0 {
            assert_eq!(
                (run.q[100], run.qd[100]),
                (Vector2::new(1.2, -0.8), Vector2::zeros()),
                "{what}"
            );
        }
    }
    let run = TaylorSimulation::new(&Pressed).torque(tau).stops(0.3);
    let run = run.duration(2.0).run().unwrap();
    assert_eq!(
        (run.q[100], run.qd[100]),
        (Vector2::new(1.2, -0.8), Vector2::zeros())
    );
    assert!(run.work.evaluations < 20_000, "{:?}", run.work);
}

/// A rise of an Euler step is no bounce: the ball, which fell for 1/2 s, rests before another 1/2 s has passed.
#[test]
fn a_ball_comes_to_rest_by_euler_s_explicit_method() {
    for (step, restitution) in [(1e-3, 0.5), (1e-2, 0.3), (1e-3, 0.0), (2.5e-3, 0.1)] {
        let run = dropped(Method::ExplicitEuler { step }, restitution, 3.0, 31);
        let end = 0.5 + (1.0 * restitution) / (1.0 - restitution);
        for (k, t) in run.t.iter().enumerate().filter(|(_, t)| **t > end + 0.1) {
            let found = [run.q[k][0], run.qd[k][0], run.qdd[k][0]];
            assert_eq!(found, [0.0; 3], "step {step}, e = {restitution}, {t} s");
        }
    }
}

/// From 1/2 s on a law lifts the ball at rest, and presses it down as soon as it rises: there is no motion.
#[test]
fn impacts_without_end_are_an_error_of_their_joints() {
    for step in [1e-2, 3e-3] {
        let law = |t: f64, _: &Vector1<f64>, qd: &Vector1<f64>| {
            let lifts = t > 0.5 && qd[0] <= 0.0;
            Vector1::new(if lifts { 40.0 } else { -100.0 })
        };
        let run = Simulation::new(&Ball).torque(law).stops(0.5);
        let run = run.method(Method::RungeKutta4 { step });
        let end = run.duration(2.0).samples(5).run().unwrap_err();
        let what = format!("step {step}: {end}");
        let is_named = matches!(end.cause, Cause::Impacts { joints } if joints.iter().eq([0]));
        assert!(is_named && (end.time - 0.5).abs() < 1e-9, "{what}");
        let work = end.trajectory.work;
        assert!(work.evaluations < 500_000, "{what}: {work:?}");
    }
}
