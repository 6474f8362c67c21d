//! How far a series goes.
//!
//! The order follows from the tolerance: it is 1 - 2/3 ln tolerance. The factor 2/3 is between 1/2, for work that
//! grows with the square of the order (Jorba and Zou 2005), and 1, for work in proportion to it. The step follows
//! from the last six coefficients of q and qd: from rest every other coefficient vanishes, and three of four where
//! the motion is symmetric besides. Each step ends by comparing the accelerations of the series with those of the
//! equations, which the next series needs anyway. If they differ, the step is halved.

use dynamics_runtime::{MAX_TAYLOR_ORDER, TaylorCoefficients};
use nalgebra::SVector;

use crate::integrate::Tolerance;

/// Coefficients that the step is chosen from.
///
/// At rest, and where a motion is symmetric in time, up to three of four coefficients vanish: a link that starts
/// horizontally has q_2, q_6, q_10, ... alone. A step chosen from the last two would have no bound.
const WINDOW: usize = 6;

/// The order that a tolerance takes the least work with, `1 - 2/3 ln(tolerance)`.
///
/// Where the work of a step grows with the square of the order it is `1 - ln(tolerance) / 2` (Jorba and Zou 2005, section
/// 3.1), where it is proportional to the order, twice that. Here it is in between.
pub(crate) fn order(tolerance: f64) -> usize {
    let order = (1.0 - tolerance.ln() / 1.5).ceil();
    (order as usize).clamp(FEWEST_ORDERS, MAX_TAYLOR_ORDER)
}

/// The lowest order that steps are chosen for: the window has to leave out q_0 and q_1.
pub(crate) const FEWEST_ORDERS: usize = WINDOW + 2;

/// The step in which the terms of order `p` reach the tolerance.
///
/// With errors in units of the tolerance, the term of order p is `r^p / tolerance` where r is the step over the radius of
/// convergence. Each of the last coefficients gives an estimate of that radius by its root; the least counts:
///
/// `h = min_k (scale / |q_k|)^(1/k) tolerance^(1/p)`, and the same of the velocities, of order p - 1.
pub(crate) fn step_size<const N: usize>(
    q: &TaylorCoefficients<f64, N>,
    p: usize,
    tolerance: &Tolerance,
) -> f64 {
    let smallest = tolerance.relative.min(tolerance.absolute);
    // 1 / (absolute + relative |y|), both in units of the smaller one.
    let weight = |y: &SVector<f64, N>| {
        y.map(|y| smallest / (tolerance.absolute + tolerance.relative * y.abs()))
    };
    let (position, velocity) = (weight(&q[0]), weight(&q[1]));
    let limit = smallest.ln();
    let mut least = f64::INFINITY;
    for k in p + 1 - WINDOW..=p {
        let x = q[k].component_mul(&position).amax();
        let y = q[k].component_mul(&velocity).amax() * k as f64;
        let (order, orders) = (k as f64, p as f64);
        // Logarithms of the estimates; infinite for a coefficient that vanishes.
        let by_position = limit / orders - x.ln() / order;
        let by_velocity = limit / (orders - 1.0) - y.ln() / (order - 1.0);
        least = least.min(by_position).min(by_velocity);
    }
    least.exp()
}

#[cfg(test)]
mod tests {
    use dynamics_runtime::MAX_TAYLOR_ORDER;
    use nalgebra::Vector1;

    use super::{order, step_size};
    use crate::integrate::Tolerance;

    fn tolerance(value: f64) -> Tolerance {
        Tolerance {
            relative: value,
            absolute: value,
        }
    }

    #[test]
    fn the_order_grows_with_the_digits() {
        assert_eq!(order(1e-6), 11);
        assert_eq!(order(1e-12), 20);
        assert_eq!(order(1e-16), 26);
        assert_eq!(order(1e-300), MAX_TAYLOR_ORDER);
        assert_eq!(order(0.5), 8);
    }

    /// q = 1 / (1 - t / r): the last terms of q and qd reach the tolerance.
    #[test]
    fn the_last_term_reaches_the_tolerance() {
        let (radius, p) = (0.3_f64, 18);
        let mut q = [Vector1::new(0.0); MAX_TAYLOR_ORDER + 1];
        for k in 0..=p {
            q[k][0] = radius.powi(-(k as i32));
        }
        let h = step_size(&q, p, &tolerance(1e-12));
        let ratio = h / radius;
        let scale = 1.0 + q[1][0];
        let last = p as f64 * q[p][0] * h.powi(p as i32 - 1) / scale;
        assert!((0.01e-12..=1.0001e-12).contains(&last), "{last:e} {ratio}");
        assert!(ratio > 0.1);
    }

    /// Three of four coefficients vanish.
    #[test]
    fn coefficients_that_vanish_give_no_long_step() {
        for p in 15..=20 {
            let mut q = [Vector1::new(0.0); MAX_TAYLOR_ORDER + 1];
            for k in (2..=p).step_by(4) {
                q[k][0] = 1.0;
            }
            let h = step_size(&q, p, &tolerance(1e-12));
            assert!((0.05..0.4).contains(&h), "order {p}: {h}");
        }
    }
}
