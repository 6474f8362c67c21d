//! Chaos, and what a long run keeps.

use robot_dynamics::Method;
use robot_dynamics::nalgebra::Vector2;

use super::arms::*;
use super::motion::{dormand_prince, free};
use super::score::Score;

pub(crate) fn scores(effort: super::Effort) -> Vec<Score> {
    let mut scores = chaos();
    scores.push(semi_implicit_euler(effort));
    scores
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

/// The semi-implicit Euler scheme is symplectic in (q, p), not in (q, qd) where M depends on q: the
/// rods lose their energy. This holds the documentation to it.
fn semi_implicit_euler(effort: super::Effort) -> Score {
    let rest = Vector2::zeros();
    let method = Method::SemiImplicitEuler { step: 0.01 };
    let duration = effort.pick(2_000.0, 10_000.0);
    let motion = free(&TwoRods, method, rest, rest, duration, 2);
    let lost = motion.map_or(f64::INFINITY, |m| m.energy_drift(&TwoRods) / 54.0);
    Score::at_least(
        "HC32",
        "share of the energy that semi-implicit Euler loses, 10 ms",
        lost,
        0.1,
    )
}
