//! Chaos, and what a long run keeps.

use std::thread;

use robot_dynamics::nalgebra::{Vector1, Vector2};
use robot_dynamics::{Energy, ForwardDynamics, Method};

use super::arms::*;
use super::effort::Effort;
use super::entries::entry;
use super::motion::{dop853, dormand_prince, free};
use super::score::Score;

pub(crate) fn scores(effort: Effort) -> Vec<Score> {
    // Side by side: each is one long run after another.
    thread::scope(|scope| {
        let others = scope.spawn(|| [chaos(), swing(effort)].concat());
        let rest = scope.spawn(|| momenta(effort));
        let pruned = vec![
            pruned(&ElbowAtTenthOfPercent, "0.1 %"),
            pruned(&ElbowAtOnePercent, "1 %"),
            pruned(&ElbowAtThreePercent, "3 %"),
        ];
        let ended = [others.join(), rest.join()].map(|run| run.expect("no run panics"));
        [ended.concat(), pruned].concat()
    })
}

/// Growth of the distance between two motions of the rods, per second.
const LYAPUNOV: f64 = 0.777;

/// Two runs that differ in their tolerance agree until the motion has multiplied their errors to
/// 1 rad: about 10 s + ln(1/e)/lambda, where e is their difference after 10 s. Beyond it no digit
/// means anything; the energy still does.
fn chaos() -> Vec<Score> {
    let (id, rest) = ("HC30", Vector2::zeros());
    let run = |tolerance: f64| free(&TwoRods, dormand_prince(tolerance), rest, rest, 45.0, 451);
    let (Some(a), Some(b)) = (run(1e-11), run(1e-12)) else {
        return vec![Score::at_most(id, "runs that end early", 1.0, 0.0)];
    };
    let distance = |k: usize| (a.q[k] - b.q[k]).amax();
    let estimate = 10.0 - distance(100).ln() / LYAPUNOV;
    let parted = (0..a.len()).find(|k| distance(*k) > 1.0);
    let parted = parted.map_or(f64::INFINITY, |k| a.t[k]);
    vec![
        Score::at_most(
            id,
            "s, until two runs are 1 rad apart, over the Lyapunov estimate",
            parted / estimate,
            1.2,
        ),
        Score::at_least(
            id,
            "s, until two runs are 1 rad apart, over the Lyapunov estimate",
            parted / estimate,
            0.7,
        ),
        Score::at_most(
            id,
            "drift of the energy over 45 s, J",
            b.energy_drift(&TwoRods),
            1e-7,
        ),
    ]
}

/// A rod that swings by 2 rad for 10^5 s: a symplectic method keeps its energy within a band, whatever the time;
/// the classical Runge-Kutta method loses it at a steady rate.
fn swing(effort: Effort) -> Vec<Score> {
    let id = "HC31";
    let duration = effort.pick(200.0, 1e5);
    let drift = |method: Method| {
        let (q, qd) = (Vector1::new(2.0), Vector1::zeros());
        let motion = free(&OneLink, method, q, qd, duration, 1_001);
        motion.map_or(f64::INFINITY, |m| m.energy_drift(&OneLink) / 29.43)
    };
    let quantity = |name: &str| format!("drift of the energy over {duration} s, {name}");
    let (fine, coarse) = (0.01, 0.05);
    vec![
        Score::at_most(
            id,
            quantity("Gauss-Legendre 6, 10 ms"),
            drift(Method::GaussLegendre6 { step: fine }),
            1e-11,
        )
        .naive(drift(Method::RungeKutta4 { step: fine })),
        Score::at_most(
            id,
            quantity("implicit midpoint, 50 ms"),
            drift(Method::ImplicitMidpoint { step: coarse }),
            effort.pick(1.0, 1e-2),
        ),
    ]
}

/// The semi-implicit Euler scheme is symplectic in (q, p), not in (q, qd) where M depends on q: the
/// rods lose their energy. In momenta they keep it.
fn momenta(effort: Effort) -> Vec<Score> {
    let (id, rest) = ("HC32", Vector2::zeros());
    let duration = effort.pick(200.0, 10_000.0);
    let drift = |method: Method| {
        let motion = free(&TwoRods, method, rest, rest, duration, 301);
        motion.map_or(f64::INFINITY, |m| m.energy_drift(&TwoRods) / 54.0)
    };
    let step = 0.01;
    let velocities = drift(Method::SemiImplicitEuler { step });
    let what = format!("share of the energy lost in {duration} s, 10 ms");
    vec![
        Score::at_least(
            id,
            format!("{what}, semi-implicit Euler in (q, qd)"),
            velocities,
            0.1,
        ),
        Score::at_most(
            id,
            format!("{what}, implicit midpoint in (q, p)"),
            drift(Method::ImplicitMidpoint { step }),
            0.01,
        )
        .naive(velocities),
        Score::at_most(
            id,
            format!("{what}, Gauss-Legendre 4 in (q, p)"),
            drift(Method::GaussLegendre4 { step }),
            1e-5,
        )
        .naive(velocities),
    ]
}

/// A pruned Lagrangian still has an energy, and keeps it.
fn pruned(arm: &(impl ForwardDynamics<3> + Energy<3>), share: &str) -> Score {
    let entry = entry("HC46");
    let (q, qd) = (entry.vector("q0"), entry.vector("qd0"));
    let motion = free(arm, dop853(1e-11), q, qd, 20.0, 201);
    let drift = motion.map_or(f64::INFINITY, |m| m.energy_drift(arm));
    let quantity = format!("drift of the energy over 20 s, terms below {share} left out, J");
    Score::at_most("HC46", quantity, drift, 1e-7).naive(0.63)
}
