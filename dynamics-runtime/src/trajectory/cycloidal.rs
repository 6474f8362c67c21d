//! The cycloidal law.

use core::f64::consts::{PI, TAU};
use core::fmt;

use nalgebra::SVector;

use crate::State;

/// Motion of all joints from rest to rest by the cycloidal law.
///
/// With x = 2 pi t / T:
///
/// - `q = q_0 + (q_T - q_0) (x - sin x) / (2 pi)`,
/// - `qd = (q_T - q_0) (1 - cos x) / T`,
/// - `qdd = (q_T - q_0) 2 pi sin x / T^2`.
///
/// Velocity and acceleration are zero at both ends. Before t = 0 and after t = T the joints rest at
/// the ends. Source: S. K. Saha, *Introduction to Robotics*, the trajectory of the examples of
/// inverse dynamics.
///
/// The distances from the start and to the end, the velocity and the acceleration are accurate to a
/// few units in the last place at all times, near their zeros too, where the formulas as they stand
/// cancel; held by `tests/suite/trajectories.rs`.
///
/// ```
/// use dynamics_runtime::{Cycloidal, nalgebra::SVector};
///
/// let turn = Cycloidal::new(SVector::from([0.0]), SVector::from([2.0]), 4.0)?;
/// let halfway = turn.at(2.0);
/// assert_eq!((halfway.q[0], halfway.qd[0]), (1.0, 1.0));
/// assert_eq!(turn.at(5.0).q[0], 2.0);
/// # Ok::<(), dynamics_runtime::InvalidDuration>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cycloidal<const N: usize> {
    start: SVector<f64, N>,
    end: SVector<f64, N>,
    duration: f64,
}

/// The duration of a trajectory is not a positive finite number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InvalidDuration(
    /// The duration, s.
    pub f64,
);

impl fmt::Display for InvalidDuration {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a trajectory cannot last {} s", self.0)
    }
}

impl core::error::Error for InvalidDuration {}

impl<const N: usize> Cycloidal<N> {
    /// From `start` at t = 0 to `end` at t = `duration` in s.
    ///
    /// # Errors
    ///
    /// [`InvalidDuration`] unless the duration is positive and finite.
    pub fn new(
        start: SVector<f64, N>,
        end: SVector<f64, N>,
        duration: f64,
    ) -> Result<Self, InvalidDuration> {
        if duration > 0.0 && duration.is_finite() {
            Ok(Cycloidal {
                start,
                end,
                duration,
            })
        } else {
            Err(InvalidDuration(duration))
        }
    }

    /// Position, velocity and acceleration of all joints at time `t` in s. NaN gives NaN.
    pub fn at(&self, t: f64) -> State<N> {
        let t = t.clamp(0.0, self.duration);
        let distance = self.end - self.start;
        // From the nearer end: the law is symmetric about the middle, and T - t is exact there.
        let left = self.duration - t;
        let first_half = t <= left;
        let x = TAU * t.min(left) / self.duration;
        let travelled = distance * (x_minus_sine(x) / TAU);
        State {
            q: if first_half {
                self.start + travelled
            } else {
                self.end - travelled
            },
            // 1 - cos x = 2 sin^2(x/2), without the cancellation.
            qd: distance * (2.0 * (0.5 * x).sin().powi(2) / self.duration),
            qdd: distance * (TAU * self.sine(t) / (self.duration * self.duration)),
        }
    }

    /// sin(2 pi t / T), from the nearest of its zeros 0, T/2 and T: the distance from it is exact.
    fn sine(&self, t: f64) -> f64 {
        let quarter = 0.25 * self.duration;
        let sine = |distance: f64| (TAU * distance / self.duration).sin();
        if t < quarter {
            sine(t)
        } else if t > 3.0 * quarter {
            -sine(self.duration - t)
        } else {
            sine(0.5 * self.duration - t)
        }
    }
}

/// x - sin x for x from 0 to pi, to a few units in the last place.
fn x_minus_sine(x: f64) -> f64 {
    /// Below it the difference cancels, and the series needs few terms.
    const SERIES_BELOW: f64 = 0.5 * PI;
    /// The first term left out is below 2^-53 of the sum.
    const TERMS: i32 = 10;
    if x >= SERIES_BELOW {
        return x - x.sin();
    }
    // x^3/3! (1 - x^2/(4 5) (1 - x^2/(6 7) (...)))
    let square = x * x;
    let ratio = |k| square / f64::from((2 * k + 2) * (2 * k + 3));
    let nested = (1..TERMS)
        .rev()
        .fold(1.0, |inner, k| 1.0 - ratio(k) * inner);
    x * square / 6.0 * nested
}

#[cfg(test)]
mod tests {
    use core::f64::consts::PI;

    use nalgebra::{Vector1, Vector2};

    use super::{Cycloidal, InvalidDuration};

    /// t, q, qd, qdd from 0 to pi in 10 s, from a computation of 40 digits with these doubles.
    const REFERENCE: [[f64; 4]; 3] = [
        [
            0.2,
            1.652362896437421e-4,
            2.4772396421797702e-3,
            2.4739788671780355e-2,
        ],
        [5.0, 0.5 * PI, 0.2 * PI, 0.0],
        [
            9.8,
            3.1414274173001493,
            2.477239642179752e-3,
            -2.4739788671780265e-2,
        ],
    ];

    fn half_turn() -> Cycloidal<1> {
        Cycloidal::new(Vector1::new(0.0), Vector1::new(PI), 10.0).unwrap()
    }

    #[test]
    fn values_are_accurate_close_to_the_ends() {
        for [t, q, qd, qdd] in REFERENCE {
            let state = half_turn().at(t);
            for (computed, expected) in [(state.q[0], q), (state.qd[0], qd), (state.qdd[0], qdd)] {
                let error = (computed - expected).abs();
                // 0.2 and 9.8 are not those decimals: the acceleration's sine shows their rounding.
                assert!(
                    error <= 2e-15 * expected.abs() + 1e-16,
                    "t = {t}: {error:e}"
                );
            }
        }
    }

    /// Close to the start q = d (2 pi)^2 s^3 / 6 (1 - (2 pi s)^2 / 20), s = t / T.
    #[test]
    fn small_times_keep_their_digits() {
        for s in [1e-3, 1e-6, 1e-12] {
            let x = 2.0 * PI * s;
            let expected = x * x * x / 6.0 * (1.0 - x * x / 20.0 + x.powi(4) / 840.0) / 2.0;
            let computed = half_turn().at(10.0 * s).q[0];
            assert!((computed / expected - 1.0).abs() < 2e-15, "s = {s}");
        }
    }

    #[test]
    fn halves_of_the_series_and_of_the_formula_meet() {
        let (below, above) = (2.5 - 1e-12, 2.5 + 1e-12);
        let (a, b) = (half_turn().at(below), half_turn().at(above));
        let slope = (b.q[0] - a.q[0]) / (above - below);
        assert!((slope / a.qd[0] - 1.0).abs() < 1e-3);
    }

    #[test]
    fn joints_rest_outside_the_duration() {
        let start = Vector2::new(1.0, -2.0);
        let end = Vector2::new(3.0, 0.1);
        let law = Cycloidal::new(start, end, 2.0).unwrap();
        for (t, q) in [(-1.0, start), (0.0, start), (2.0, end), (7.0, end)] {
            let state = law.at(t);
            assert_eq!(state.q, q);
            assert_eq!(state.qd.amax(), 0.0);
            assert_eq!(state.qdd.amax(), 0.0);
        }
    }

    #[test]
    fn velocity_and_acceleration_are_derivatives() {
        let h = 1e-5;
        for t in [0.4, 2.5, 4.9, 5.1, 8.3] {
            let [before, now, after] = [t - h, t, t + h].map(|t| half_turn().at(t));
            let slope = |a: f64, b: f64| (b - a) / (2.0 * h);
            assert!((slope(before.q[0], after.q[0]) - now.qd[0]).abs() < 1e-9);
            assert!((slope(before.qd[0], after.qd[0]) - now.qdd[0]).abs() < 1e-9);
        }
    }

    #[test]
    fn durations_that_are_none_are_refused() {
        for duration in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let error = Cycloidal::new(Vector1::zeros(), Vector1::zeros(), duration).unwrap_err();
            assert_eq!(error.to_string(), InvalidDuration(duration).to_string());
        }
    }

    #[test]
    fn a_time_that_is_not_a_number_gives_none() {
        let state = half_turn().at(f64::NAN);
        assert!(state.q[0].is_nan() && state.qd[0].is_nan() && state.qdd[0].is_nan());
    }
}
