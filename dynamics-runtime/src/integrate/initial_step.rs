//! The first step of a run.

use super::{Equations, Phase, Tolerance};

/// A step size at which an Euler step meets the tolerance (Hairer, Nørsett, Wanner I, section II.4).
pub(super) fn initial_step<S: Equations<N>, const N: usize>(
    system: &S,
    t: f64,
    phase: &Phase<N>,
    rate: &Phase<N>,
    tolerance: &Tolerance,
    order: f64,
) -> f64 {
    let norm = |value: &Phase<N>| tolerance.norm(value, phase, phase);
    let (size, speed) = (norm(phase), norm(rate));
    let small = size < 1e-5 || speed < 1e-5;
    let first = if small { 1e-6 } else { 0.01 * size / speed };

    let ahead = phase.plus(first, rate);
    let Ok(rate_ahead) = system.rate(t + first, &ahead) else {
        return first;
    };
    let bending = norm(&rate_ahead.minus(rate)) / first;
    let steepness = speed.max(bending);
    let second = if steepness <= 1e-15 {
        (1e-3 * first).max(1e-6)
    } else {
        (0.01 / steepness).powf(1.0 / order)
    };
    second.min(100.0 * first)
}
