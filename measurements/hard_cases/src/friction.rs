//! Dry friction.

use robot_dynamics::nalgebra::Vector1;
use robot_dynamics::{Friction, Method, Simulation, simulation::Radau5};

use super::arms::*;
use super::motion::{Counted, dop853};
use super::score::Score;

pub(crate) fn scores() -> Vec<Score> {
    let mut scores = vec![sign_of_zero()];
    scores.extend(stopping());
    scores.extend(sticking());
    scores.extend(much_viscous_friction());
    scores
}

/// sign(0) = 0, of either zero; a velocity that is not a number stays one.
fn sign_of_zero() -> Score {
    let friction = |speed: f64| DryJoint.friction_vector(&Vector1::new(speed))[0];
    let wrong = [
        friction(0.0) != 0.0,
        friction(-0.0) != 0.0,
        !friction(f64::NAN).is_nan(),
        friction(1e-300) != 1.0,
        friction(-1e-300) != -1.0,
    ];
    let wrong = wrong.iter().filter(|wrong| **wrong).count();
    Score::at_most("HC24", "wrong signs of 5", wrong as f64, 0.0).naive(2.0)
}

/// 1 rad/s against 1 N m of dry friction on 1 kg m^2: it stops after 1 s and 0.5 rad, and stays.
fn stopping() -> [Score; 3] {
    let id = "HC22";
    let arm = Counted::new(&DryJoint);
    let simulation = Simulation::new(&arm)
        .friction(Friction::Sticking)
        .method(dop853(1e-12));
    let start = simulation.initial(Vector1::zeros(), Vector1::new(1.0));
    let run = start.duration(2.0).samples(2).run();
    let (angle, speed) = run.map_or((f64::NAN, f64::NAN), |m| (m.q[1][0], m.qd[1][0]));
    [
        Score::at_most(
            id,
            "error of q after 2 s, sticking",
            (angle - 0.5).abs(),
            1e-12,
        )
        .naive(4e-7),
        Score::at_most(id, "speed after 2 s, sticking", speed.abs(), 0.0).naive(3.8e-6),
        Score::at_most(id, "evaluations, sticking", arm.calls(), 2_000.0).naive(57_896.0),
    ]
}

/// A torque of half the friction: the joint stays where it is; with a smooth law it creeps, as its documentation
/// says, at speed atanh(1/2).
fn sticking() -> [Score; 2] {
    let id = "HC23";
    let angle = |friction: Friction, method: Method| {
        let simulation = Simulation::new(&DryJoint).torque(|_t, _q, _qd| Vector1::new(0.5));
        let run = simulation
            .friction(friction)
            .method(method)
            .duration(10.0)
            .samples(2)
            .run();
        run.map_or(f64::NAN, |m| m.q[1][0])
    };
    let speed = 1e-3;
    let creep = angle(
        Friction::Regularised { speed },
        Radau5::with_tolerance(1e-9).into(),
    );
    let expected = 10.0 * speed * 0.5_f64.atanh();
    [
        Score::at_most(
            id,
            "rad in 10 s under half the friction, sticking",
            angle(Friction::Sticking, dop853(1e-12)).abs(),
            1e-14,
        )
        .naive(creep),
        Score::at_most(
            id,
            "creep of the smooth law over that of its documentation, minus 1",
            (creep / expected - 1.0).abs(),
            1e-3,
        ),
    ]
}

/// A torque of -G sin q, G = 10^3 N m, against b = 10^6 N m s: the velocity settles within microseconds to
/// -G/b sin q, up to (G/b)^2, and an explicit method cannot take longer steps. So
/// tan(q/2) = tan(1/2) exp(-G t/b), up to terms of G/b^2 = 10^-9. (The entry's digits are those of
/// 0.9991588 rad, 4e-8 from it.)
fn much_viscous_friction() -> [Score; 2] {
    let id = "HC21";
    let arm = Counted::new(&StiffJoint);
    let settings = Radau5::with_tolerance(1e-8).max_step(f64::INFINITY);
    let simulation = Simulation::new(&arm)
        .torque(|_t, q, _qd| Vector1::new(-1e3 * q[0].sin()))
        .method(settings)
        .initial(Vector1::new(1.0), Vector1::zeros());
    let run = simulation.samples(2).run();
    let exact = 2.0 * (0.5_f64.tan() * (-1e-3_f64).exp()).atan();
    let error = run.map_or(f64::INFINITY, |m| (m.q[1][0] - exact).abs());
    [
        Score::at_most(
            id,
            "evaluations for 1 s, Radau 5 at 1e-8",
            arm.calls(),
            1_000.0,
        )
        .naive(1_814_714.0),
        Score::at_most(id, "error of q after 1 s, Radau 5 at 1e-8", error, 1e-8),
    ]
}
