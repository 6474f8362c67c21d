//! The first step of a run.

use dynamics_runtime::Size;

use super::{Equations, Phase, Tolerance};

/// A step size at t = 0 at which an Euler step is about as good as the tolerance asks (Hairer, Nørsett,
/// Wanner I, section II.4, "starting step size").
pub(super) fn initial_step<S: Equations<D>, D: Size>(
    system: &S,
    phase: &Phase<D>,
    rate: &Phase<D>,
    tolerance: &Tolerance,
    order: f64,
) -> f64 {
    let norm = |value: &Phase<D>| tolerance.norm(value, phase, phase);
    let (size, speed) = (norm(phase), norm(rate));
    let small = size < 1e-5 || speed < 1e-5;
    let first = if small { 1e-6 } else { 0.01 * size / speed };

    let ahead = phase.plus(first, rate);
    let Ok(rate_ahead) = system.rate(first, &ahead) else {
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
