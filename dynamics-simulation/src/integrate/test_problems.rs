//! A problem with a known solution, for measuring the order of a stepper.

use core::convert::Infallible;

use nalgebra::{Const, SVector, Vector1};

use super::{OneStep, Phase, Start};

pub(super) type Acceleration = fn(f64, &Phase<Const<1>>) -> Result<SVector<f64, 1>, Infallible>;

pub(super) fn vector(x: f64) -> SVector<f64, 1> {
    Vector1::new(x)
}

/// q'' = -2 q' - 5 q + 5 t + 2 with the solution q = exp(-t) sin(2 t) + t: it depends on time,
/// position and velocity, so that a slip in any of them costs the order.
pub(super) const ACCELERATION: Acceleration = |t, phase| {
    Ok(vector(
        -2.0 * phase.qd[0] - 5.0 * phase.q[0] + 5.0 * t + 2.0,
    ))
};

pub(super) fn solution(t: f64) -> Phase<Const<1>> {
    let (sin, cos) = (2.0 * t).sin_cos();
    let decay = (-t).exp();
    Phase {
        q: vector(decay * sin + t),
        qd: vector(decay * (2.0 * cos - sin) + 1.0),
    }
}

pub(super) fn distance(a: &Phase<Const<1>>, b: &Phase<Const<1>>) -> f64 {
    (a.q - b.q).norm().max((a.qd - b.qd).norm())
}

/// Orders observed between successive numbers of steps over two seconds.
pub(super) fn convergence_orders(
    mut method: impl OneStep<Acceleration, Infallible, Const<1>>,
    steps: &[usize],
) -> Vec<f64> {
    let mut error = |steps: usize| {
        let h = 2.0 / steps as f64;
        let end = (0..steps).fold(solution(0.0), |phase, i| {
            let t = i as f64 * h;
            let step = method.step(&ACCELERATION, &Start { t, phase, h });
            step.unwrap()
        });
        distance(&end, &solution(2.0)).log2()
    };
    let errors: Vec<f64> = steps.iter().map(|steps| error(*steps)).collect();
    errors.windows(2).map(|pair| pair[0] - pair[1]).collect()
}
