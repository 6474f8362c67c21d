//! Cases that must hold to the bit, and cases that must be refused.

use std::cell::Cell;

use robot_dynamics::nalgebra::{SVector, Vector1, Vector2, Vector6};
use robot_dynamics::{
    Method, NewtonEuler, Simulation,
    simulation::{Cause, DormandPrince, InvalidSetting},
};

use super::arms::*;
use super::effort::Effort;
use super::motion::Counted;
use super::score::Score;

pub(crate) fn scores(effort: Effort) -> Vec<Score> {
    vec![
        times_of_many_steps(effort),
        vertical_first_joint(),
        scaled_units(),
        tolerances(),
        tiny_tolerance(),
        not_a_number(),
    ]
}

/// Positions of the PUMA, velocities after them.
fn states(count: usize) -> impl Iterator<Item = [Vector6<f64>; 2]> {
    (0..count).map(|k| {
        [2.3, 3.1].map(|w| Vector6::from_fn(|i, _| 3.0 * f64::sin(1.7 * k as f64 + w * i as f64)))
    })
}

/// Joint 1 is vertical: M and V do not depend on its angle, to the bit.
fn vertical_first_joint() -> Score {
    let changes = |[q, qd]: &[Vector6<f64>; 2]| {
        let mut turned = *q;
        turned[0] = 1e3 * q[1] - q[0];
        Puma560.mass_matrix(q) != Puma560.mass_matrix(&turned)
            || Puma560.coriolis_vector(q, qd) != Puma560.coriolis_vector(&turned, qd)
    };
    let changed = states(200).filter(changes).count();
    Score::at_most(
        "HC35",
        "states of 200 at which M or V depend on q_1",
        changed as f64,
        0.0,
    )
    .naive(200.0)
}

/// The time of a step is a multiple of the step, not a sum of steps.
fn times_of_many_steps(effort: Effort) -> Score {
    let steps = effort.pick(100_000_u32, 10_000_000);
    let duration = f64::from(steps) * 1e-3;
    let time = |step: u32| f64::from(step) * (duration / f64::from(steps));
    // (steps whose law was called, times that are those of no step); a sample calls the law at its own time.
    let seen = Cell::new((0_u32, 0_u32));
    let law = |t: f64, _q: &SVector<f64, 1>, _qd: &SVector<f64, 1>| {
        let (calls, wrong) = seen.get();
        let is_next = calls < steps && t == time(calls);
        let is_of_sample = t == time(calls) || t == time(calls.saturating_sub(1));
        let is_wrong = !is_next && !is_of_sample;
        seen.set((calls + u32::from(is_next), wrong + u32::from(is_wrong)));
        Vector1::zeros()
    };
    let simulation = Simulation::new(&Cart).torque(law);
    let method = Method::SemiImplicitEuler { step: 1e-3 };
    let run = simulation
        .method(method)
        .duration(duration)
        .samples(2)
        .run();
    let missing = steps - seen.get().0;
    let wrong = match run.is_ok_and(|motion| motion.t[1] == duration) {
        true => missing + seen.get().1,
        false => steps,
    };
    Score::at_most(
        "HC37",
        format!("times of {steps} steps of 1 ms that are not k h"),
        f64::from(wrong),
        0.0,
    )
    .naive(f64::from(steps))
}

/// Units that are powers of two change no digit of a result: lengths 2^a, masses 2^b.
fn scaled_units() -> Score {
    let arm = |a: i32, b: i32| {
        let [length, mass] = [2_f64.powi(a), 2_f64.powi(b)];
        let inertia = mass * length * length;
        Scaled {
            a1: 0.7 * length,
            m1: 1.3 * mass,
            c1: -0.31 * length,
            i1: 0.11 * inertia,
            a2: 0.45 * length,
            m2: 0.9 * mass,
            c2: -0.17 * length,
            i2: 0.03 * inertia,
            g: 9.81 * length,
        }
    };
    let results = |arm: &Scaled, torque: f64| {
        let mut numbers = Vec::new();
        for k in 0..24 {
            let at = |w: f64| Vector2::from_fn(|i, _| f64::sin(1.7 * f64::from(k) + w * i as f64));
            let (q, qd, qdd) = (at(2.3) * 3.0, at(3.1), at(0.7) * 5.0);
            let tau = at(1.1) * torque;
            let numeric = NewtonEuler::new(&arm.table());
            let forces = [
                arm.inverse_dynamics(&q, &qd, &qdd),
                numeric.inverse_dynamics(&q, &qd, &qdd),
            ];
            let matrices = [arm.mass_matrix(&q), numeric.mass_matrix(&q)];
            numbers.extend(forces.iter().flatten().map(|x| x / torque));
            numbers.extend(matrices.iter().flatten().map(|x| x / torque));
            for qdd in [
                arm.forward_dynamics(&q, &qd, &tau),
                numeric.forward_dynamics(&q, &qd, &tau),
            ] {
                numbers.extend(qdd.unwrap_or(Vector2::repeat(f64::NAN)).iter());
            }
        }
        numbers
    };
    let expected = results(&arm(0, 0), 1.0);
    let powers = [(-10, -20), (30, 40), (-60, -60), (100, 100), (7, 17)];
    let violations: usize = powers
        .iter()
        .map(|(a, b)| {
            let found = results(&arm(*a, *b), 2_f64.powi(b + 2 * a));
            let pairs = found.iter().zip(&expected);
            pairs.filter(|(x, y)| x.to_bits() != y.to_bits()).count()
        })
        .sum();
    let all = powers.len() * expected.len();
    Score::at_most(
        "HC38",
        format!("digits that change with the units, in {all} numbers"),
        violations as f64,
        0.0,
    )
    .naive(all as f64)
}

/// A tolerance that no step can meet is refused before the first.
fn tolerances() -> Score {
    let pairs = [
        (1e-6, 0.0),
        (0.0, 1e-15),
        (-1e-6, 1e-6),
        (f64::NAN, 1e-6),
        (1e-6, f64::INFINITY),
    ];
    let is_accepted = |(relative, absolute): &(f64, f64)| {
        let settings = DormandPrince::with_tolerance(*relative).absolute_tolerance(*absolute);
        let start = (Vector1::new(2.0), Vector1::zeros());
        let simulation = Simulation::new(&OneLink).method(settings);
        let cause = simulation
            .initial(start.0, start.1)
            .run()
            .map_err(|e| e.cause);
        !matches!(
            cause,
            Err(Cause::InvalidSetting(InvalidSetting::Tolerance(_)))
        )
    };
    let accepted = pairs.iter().filter(|pair| is_accepted(pair)).count();
    Score::at_most(
        "HC40",
        "impossible tolerances that are accepted",
        accepted as f64,
        0.0,
    )
    .naive(5.0)
}

/// A tolerance below the rounding errors ends, with an error or without.
fn tiny_tolerance() -> Score {
    let settings = DormandPrince::with_tolerance(1e-17).absolute_tolerance(1e-15);
    let arm = Counted::new(&OneLink);
    let simulation = Simulation::new(&arm).method(settings);
    let _ = simulation
        .initial(Vector1::new(2.0), Vector1::zeros())
        .samples(2)
        .run();
    Score::at_most(
        "HC40",
        "evaluations for 1 s at a tolerance of 1e-17",
        arm.calls(),
        800_000.0,
    )
}

/// Values that are not numbers are refused, or stay visible.
fn not_a_number() -> Score {
    let mut hidden = 0;
    for bad in [f64::NAN, f64::INFINITY] {
        for joint in 0..6 {
            let [mut q, qd] = states(1).next().expect("a state");
            q[joint] = bad;
            // The first joint is vertical, and the last link is the same all round: nothing depends on
            // their angles, which are never read.
            if (1..5).contains(&joint) {
                let qdd = Puma560.forward_dynamics(&q, &qd, &SVector::zeros());
                hidden += usize::from(qdd.is_ok_and(|qdd| qdd.iter().any(|x| x.is_finite())));
            }
            let run = Simulation::new(&Puma560).initial(q, qd).run();
            let expected = InvalidSetting::InitialState { joint };
            let refused = run.is_err_and(|e| e.cause == Cause::InvalidSetting(expected));
            hidden += usize::from(!refused);
        }
    }
    let push = Simulation::new(&OneLink).torque(|_t, _q, _qd| Vector1::new(f64::NAN));
    let refused = push
        .run()
        .is_err_and(|e| e.cause == Cause::NonFiniteTorque { joint: 0 });
    hidden += usize::from(!refused);
    Score::at_most(
        "HC41",
        "inputs of 21 that are not numbers and pass",
        hidden as f64,
        0.0,
    )
    .naive(21.0)
}
