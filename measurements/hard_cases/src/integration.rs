//! Motions whose end is known.

use std::f64::consts::PI;

use robot_dynamics::nalgebra::{SVector, Vector1, Vector2, Vector6};
use robot_dynamics::{
    ForwardDynamics, Method, Simulation, TaylorSimulation, Trajectory,
    simulation::{Dop853, DormandPrince, Taylor},
};

use super::arms::*;
use super::entries::{absolute_error, entry, largest};
use super::motion::{Counted, dop853, dormand_prince, free};
use super::score::Score;
use testkit::references::Decimal;

pub(crate) fn scores() -> Vec<Score> {
    let mut scores = two_rods();
    scores.extend(from_rest());
    scores.extend(puma());
    for (id, bound, naive) in [
        ("HC28.1", 1e-11, 6e-5),
        ("HC28.2", 5e-11, 1e-4),
        ("HC28.3", 1e-8, 7.5e-4),
        ("HC28.3.14159", 1e-2, 6.3),
    ] {
        scores.push(pendulum(id, bound, naive));
    }
    scores.extend(upright());
    scores.extend(past_the_origin());
    scores.extend(growth_of_a_step());
    scores.extend(pulse());
    scores
}

/// The largest error of the last positions; infinite where the motion ended early.
fn end_error<const N: usize>(motion: Option<Trajectory<N>>, q: &[Decimal]) -> f64 {
    motion.map_or(f64::INFINITY, |motion| {
        absolute_error(&motion.q[motion.len() - 1], q)
    })
}

/// Two rods that fall from the horizontal for 10 s, which multiplies errors by 2400.
fn two_rods() -> Vec<Score> {
    let rest = Vector2::zeros();
    let exact = entry("HC25").exact("q");
    let error = |method: Method| end_error(free(&TwoRods, method, rest, rest, 10.0, 2), &exact);
    let (rk4, dop853) = (Method::RungeKutta4 { step: 1e-3 }, dop853(1e-12));
    let of = "error of q after 10 s";
    vec![
        Score::at_most(
            "HC25",
            format!("{of}, Runge-Kutta 4, 1 ms"),
            error(rk4),
            2e-8,
        )
        .naive(0.23),
        Score::at_most(
            "HC25",
            format!("{of}, DOP853 at 1e-12"),
            error(dop853),
            1e-9,
        )
        .naive(0.23),
    ]
}

/// At rest the derivatives that an error estimate looks at vanish: the first step must not be the
/// whole motion.
fn from_rest() -> Vec<Score> {
    let rest = Vector2::zeros();
    let exact = entry("HC25").exact("q");
    let dormand_prince = DormandPrince::with_tolerance(1e-12);
    let dop853 = Dop853::with_tolerance(1e-12);
    let runs: [(&str, Method); 4] = [
        ("Dormand-Prince", dormand_prince.into()),
        (
            "Dormand-Prince, steps of any length",
            dormand_prince.max_step(f64::INFINITY).into(),
        ),
        ("DOP853", dop853.into()),
        (
            "DOP853, steps of any length",
            dop853.max_step(f64::INFINITY).into(),
        ),
    ];
    let score = |(name, method): (&str, Method)| {
        let arm = Counted::new(&TwoRods);
        let motion = free(&arm, method, rest, rest, 10.0, 2);
        let error = end_error(motion, &exact);
        [
            Score::at_most(
                "HC26",
                format!("error of q after 10 s, {name}"),
                error,
                1e-9,
            )
            .naive(7.9e24),
            Score::at_least("HC26", format!("evaluations, {name}"), arm.calls(), 1_000.0)
                .naive(20.0),
        ]
    };
    let mut scores = runs.map(score).concat();
    scores.push(taylor_from_rest(&exact));
    scores
}

/// The series of a start from rest has no odd terms, and those of some orders end in a term that vanishes: another
/// integrator of this kind takes one step of 10 s at orders 8, 12 and 20.
fn taylor_from_rest(exact: &[Decimal]) -> Score {
    let error = |order: usize| {
        let tight = Taylor::with_tolerance(1e-14);
        let settings = tight.order(order).max_step(f64::INFINITY);
        let simulation = TaylorSimulation::new(&TwoRods).settings(settings);
        end_error(simulation.duration(10.0).samples(2).run().ok(), exact)
    };
    let worst = largest((8..=30).map(error));
    let quantity = "error of q after 10 s, Taylor series, worst of orders 8 to 30";
    Score::at_most("HC26", quantity, worst, 1e-9).naive(7.9e24)
}

/// The PUMA 560 falls for 3 s; joint 1 is vertical, so its momentum stays what it is.
fn puma() -> Vec<Score> {
    let id = "HC27";
    let (entry, rest) = (entry(id), Vector6::zeros());
    let motion = free(&Puma560, dop853(1e-12), rest, rest, 3.0, 31);
    let Some(motion) = motion else {
        return vec![Score::at_most(id, "error of q", f64::INFINITY, 0.0)];
    };
    let states = motion.q.iter().zip(&motion.qd);
    let momentum = largest(states.map(|(q, qd)| (Puma560.mass_matrix(q) * qd)[0]));
    let energy = motion.energy_drift(&Puma560);
    let q = absolute_error(&motion.q[30], &entry.exact("q"));
    vec![
        Score::at_most(id, "error of q after 3 s, DOP853 at 1e-12", q, 1e-10).naive(1.7e-2),
        Score::at_most(id, "drift of the momentum about joint 1", momentum, 1e-10).naive(3.3e-2),
        Score::at_most(id, "drift of the energy, J", energy, 1e-9).naive(3.4e-2),
    ]
}

/// theta(10 s) of a rod, against the elliptic function.
fn pendulum(id: &'static str, bound: f64, naive: f64) -> Score {
    let entry = entry(id);
    let start = Vector1::new(entry.number("theta0"));
    let motion = free(&OneLink, dop853(1e-12), start, Vector1::zeros(), 10.0, 2);
    let exact = entry.exact("theta");
    let error = motion.map_or(f64::INFINITY, |motion| absolute_error(&motion.q[1], &exact));
    Score::at_most(
        id,
        "error of theta after 10 s, DOP853 at 1e-12",
        error,
        bound,
    )
    .naive(naive)
}

/// The time at which a rod that starts upright, at the double nearest to pi, swings through the bottom. If its angle is
/// counted from the top, its start is 1.2e-16 and not lost. From the bottom, a step of 10 ms changes pi by less than
/// its rounding, a step of 0.1 s by more.
fn upright() -> Vec<Score> {
    let id = "HC29";
    // fl(pi) - pi
    let offset = -1.224_646_799_147_353_2e-16;
    let exact = entry(id).exact("t_f64")[0].nearest();
    let [offset, coarse, fine] = [
        fall(&UprightLink, 1e-3, offset, 0.0),
        fall(&OneLink, 0.1, PI, PI),
        fall(&OneLink, 0.01, PI, PI),
    ];
    vec![
        Score::at_most(
            id,
            "error of the fall time, counted from the top, 1 ms",
            (offset - exact).abs(),
            1e-3,
        )
        .naive(coarse - exact),
        Score::at_least(
            id,
            "delay of the fall, counted from the bottom, by 0.01 s instead of 0.1 s",
            fine - coarse,
            5.0,
        ),
    ]
}

/// The time until the angle is pi away from the upright one; 40 s where it never is.
fn fall(arm: &impl ForwardDynamics<1>, step: f64, start: f64, upright: f64) -> f64 {
    let (start, rest) = (Vector1::new(start), Vector1::zeros());
    let samples = (40.0 / step).round() as usize + 1;
    let method = Method::RungeKutta4 { step };
    let Some(motion) = free(arm, method, start, rest, 40.0, samples) else {
        return f64::NAN;
    };
    let to_go = |k: usize| PI - (motion.q[k][0] - upright).abs();
    let passed = (0..motion.len()).find(|k| to_go(*k) <= 0.0);
    // The speed is greatest at the bottom: there the angle is linear in time.
    passed.map_or(40.0, |k| motion.t[k] + to_go(k) / motion.qd[k][0].abs())
}

/// A free point passes the origin at a distance b in a straight line; in polar coordinates its
/// angle turns by half a turn within b seconds.
fn past_the_origin() -> Vec<Score> {
    let run = |b: f64| {
        let radius = f64::hypot(1.0, b);
        // Joint 2 points along (sin q1, -cos q1).
        let q = Vector2::new(f64::atan2(-1.0, -b), radius);
        // v = (1, 0): along the radius, and across it.
        let (s, c) = (-1.0 / radius, -b / radius);
        let qd = Vector2::new(c / radius, s);
        let motion = free(&PolarPoint, dormand_prince(1e-13), q, qd, 2.0, 2);
        let error = motion.map_or(f64::INFINITY, |motion| {
            let q = motion.q[1];
            let (x, y) = (q[1] * q[0].sin(), -q[1] * q[0].cos());
            f64::hypot(x - 1.0, y - b)
        });
        Score::at_most(
            "HC34",
            format!("distance from the end of the line, passing at {b:e} m"),
            error,
            1e-12,
        )
    };
    [0.1, 1e-3, 1e-6, 1e-9].map(run).to_vec()
}

/// The factor by which one step changes the amplitude of an oscillation of 3.836 rad/s.
fn growth_of_a_step() -> Vec<Score> {
    let id = "HC33";
    let w = f64::sqrt(14.715);
    let spring = |_t: f64, q: &SVector<f64, 1>, _qd: &SVector<f64, 1>| -q * (w * w);
    let amplitude = |method: Method, duration: f64| {
        let simulation = Simulation::new(&Cart).torque(spring).method(method);
        let start = simulation.initial(Vector1::new(1.0), Vector1::zeros());
        let motion = start.duration(duration).samples(2).run();
        motion.map_or(f64::INFINITY, |m| f64::hypot(m.q[1][0], m.qd[1][0] / w))
    };
    let craig = amplitude(Method::CraigEuler { step: 0.01 }, 10.0);
    let mut scores = vec![Score::at_most(
        id,
        "Craig's Euler, growth of the amplitude over 10 s: error",
        (craig - 1.4378).abs(),
        1e-3,
    )];
    // 1,000 steps just below and just above the limit of stability.
    let mut around = |name: &str, limit: f64, method: &dyn Fn(f64) -> Method| {
        let at = |share: f64| {
            let step = share * limit / w;
            amplitude(method(step * (1.0 + 1e-9)), 1_000.0 * step)
        };
        let quantity = |share: f64| format!("{name}, amplitude at {share} of the stable step");
        scores.push(Score::at_most(id, quantity(0.999), at(0.999), 100.0));
        scores.push(Score::at_least(id, quantity(1.01), at(1.01), 1e6));
    };
    around("semi-implicit Euler", 2.0, &|step| {
        Method::SemiImplicitEuler { step }
    });
    around("Runge-Kutta 4", 8.0_f64.sqrt(), &|step| {
        Method::RungeKutta4 { step }
    });
    scores
}

/// 1 N m for 10 ms after 5 s at rest: seen where the motion is restarted at the edges, or where no
/// step is longer than the pulse.
fn pulse() -> Vec<Score> {
    let id = "HC39";
    let exact = entry(id).exact("max_theta")[0].nearest();
    let law = |t: f64, _q: &SVector<f64, 1>, _qd: &SVector<f64, 1>| {
        Vector1::new(if (5.0..5.01).contains(&t) { 1.0 } else { 0.0 })
    };
    let settings = |longest| DormandPrince::with_tolerance(1e-10).max_step(longest);
    let largest_angle = |longest: f64| {
        let simulation = Simulation::new(&OneLink).torque(law);
        let motion = simulation
            .method(settings(longest))
            .duration(10.0)
            .samples(10_001)
            .run();
        motion.map_or(f64::NAN, |m| largest(m.q.iter().map(|q| q[0])))
    };
    vec![
        Score::at_most(
            id,
            "error of the largest angle, restarted at the edges",
            (restarted() - exact).abs(),
            1e-7,
        )
        .naive(exact),
        Score::at_most(
            id,
            "error of the largest angle, steps up to 5 ms",
            (largest_angle(5e-3) - exact).abs(),
            1e-7,
        )
        .naive(exact),
    ]
}

/// The pulse as a motion of its own, from rest; then 5 s of free motion.
fn restarted() -> f64 {
    let push = Simulation::new(&OneLink).torque(|_t, _q, _qd| Vector1::new(1.0));
    let push = push
        .method(dormand_prince(1e-12))
        .duration(0.01)
        .samples(2)
        .run();
    let Ok(push) = push else {
        return f64::NAN;
    };
    let swing = free(
        &OneLink,
        dormand_prince(1e-12),
        push.q[1],
        push.qd[1],
        4.99,
        4_991,
    );
    swing.map_or(f64::NAN, |m| largest(m.q.iter().map(|q| q[0])))
}
