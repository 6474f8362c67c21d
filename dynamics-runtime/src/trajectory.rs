//! Trajectories for joints to follow: the cycloidal law.

use core::f64::consts::{PI, TAU};
use core::fmt;

use nalgebra::SVector;

use crate::State;
use crate::float::{first_non_finite, sin_cos};

/// Motion of all joints from rest to rest by the cycloidal law.
///
/// With x = 2 pi t / T:
///
/// - `q = q_0 + (q_T - q_0) (x - sin x) / (2 pi)`,
/// - `qd = (q_T - q_0) (1 - cos x) / T`,
/// - `qdd = (q_T - q_0) 2 pi sin x / T^2`.
///
/// Velocity and acceleration are zero at both ends. Before t = 0 and after t = T the joints rest at the ends. Source:
/// S. K. Saha, *Introduction to Robotics*, the trajectory of the examples of inverse dynamics.
///
/// The distances from both ends, the velocity and the acceleration are accurate to a few units in the last place at all
/// times, also near their zeros, where the formulas above would cancel; `tests/suite/trajectories.rs` tests it.
///
/// ```
/// use robot_dynamics::{Cycloidal, nalgebra::SVector};
///
/// let turn = Cycloidal::new(SVector::from([0.0]), SVector::from([2.0]), 4.0)?;
/// let halfway = turn.at(2.0);
/// assert_eq!((halfway.q[0], halfway.qd[0]), (1.0, 1.0));
/// assert_eq!(turn.at(5.0).q[0], 2.0);
/// # Ok::<(), robot_dynamics::simulation::InvalidDuration>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cycloidal<const N: usize> {
    start: SVector<f64, N>,
    end: SVector<f64, N>,
    duration: f64,
}

/// A duration that no trajectory between these positions can have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InvalidDuration {
    /// The duration, s.
    pub duration: f64,
    /// The first joint, counted from 0, whose distance, velocity or acceleration would not be
    /// finite; `None` where the duration itself is not a positive finite number.
    pub joint: Option<usize>,
}

impl fmt::Display for InvalidDuration {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let InvalidDuration { duration, joint } = self;
        match joint {
            None => write!(f, "a trajectory cannot last {duration:?} s"),
            Some(joint) => write!(
                f,
                "joint {} cannot travel its distance in {duration:?} s: its rates are not finite",
                joint + 1
            ),
        }
    }
}

impl core::error::Error for InvalidDuration {}

impl<const N: usize> Cycloidal<N> {
    /// From `start` at t = 0 to `end` at t = `duration` in s.
    ///
    /// # Errors
    ///
    /// [`InvalidDuration`] unless the duration is positive and finite, and with it every joint's
    /// distance, velocity and acceleration.
    pub fn new(
        start: SVector<f64, N>,
        end: SVector<f64, N>,
        duration: f64,
    ) -> Result<Self, InvalidDuration> {
        let refused = |joint| Err(InvalidDuration { duration, joint });
        if !(duration > 0.0 && duration.is_finite()) {
            return refused(None);
        }
        let law = Cycloidal {
            start,
            end,
            duration,
        };
        // It is not finite where the distance or the greatest velocity is not.
        let greatest_acceleration = law.acceleration(1.0);
        match first_non_finite(greatest_acceleration.as_slice()) {
            Some(joint) => refused(Some(joint)),
            None => Ok(law),
        }
    }

    /// Position, velocity and acceleration of all joints at time `t` in s. NaN gives NaN.
    pub fn at(&self, t: f64) -> State<N> {
        let t = t.clamp(0.0, self.duration);
        let distance = self.end - self.start;
        // From the nearer end: the law is symmetric about the middle, and T - t is exact there.
        let left = self.duration - t;
        let first_half = t <= left;
        let x = TAU * (t.min(left) / self.duration);
        let (half, _) = sin_cos(0.5 * x);
        let travelled = distance * (x_minus_sine(x) / TAU);
        State {
            q: if first_half {
                self.start + travelled
            } else {
                self.end - travelled
            },
            // 1 - cos x = 2 sin^2(x/2), without the cancellation.
            qd: (distance / self.duration * (2.0 * half * half)).map(positive_zero),
            qdd: self.acceleration(self.sine(t)).map(positive_zero),
        }
    }

    /// The motion at `n` times at equal intervals, the first at t = 0 and the last at the end: the
    /// times of the samples of a `Simulation`. One sample is that of t = 0.
    pub fn samples(&self, n: usize) -> impl Iterator<Item = (f64, State<N>)> + use<N> {
        let law = *self;
        (0..n).map(move |k| {
            let t = match k {
                0 => 0.0,
                last if last + 1 == n => law.duration,
                _ => law.duration * k as f64 / (n - 1) as f64,
            };
            (t, law.at(t))
        })
    }

    /// qdd where sin x is `sine`; no T^2, which may overflow or vanish where qdd does neither.
    fn acceleration(&self, sine: f64) -> SVector<f64, N> {
        (self.end - self.start) / self.duration * (TAU * sine) / self.duration
    }

    /// sin(2 pi t / T), from the nearest of its zeros 0, T/2 and T: the distance from it is exact.
    fn sine(&self, t: f64) -> f64 {
        let quarter = 0.25 * self.duration;
        let sine = |distance: f64| sin_cos(TAU * (distance / self.duration)).0;
        if t < quarter {
            sine(t)
        } else if t > 3.0 * quarter {
            -sine(self.duration - t)
        } else {
            sine(0.5 * self.duration - t)
        }
    }
}

/// The number itself, and +0 for -0.
fn positive_zero(x: f64) -> f64 {
    x + 0.0
}

/// x - sin x for x from 0 to pi, to a few units in the last place.
fn x_minus_sine(x: f64) -> f64 {
    /// Below it the difference cancels, and the series needs few terms.
    const SERIES_BELOW: f64 = 0.5 * PI;
    /// The first term left out is below 2^-53 of the sum.
    const TERMS: i32 = 10;
    if x >= SERIES_BELOW {
        return x - sin_cos(x).0;
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

    use approx::{assert_abs_diff_eq, assert_relative_eq};
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
            assert_relative_eq!(computed, expected, epsilon = 0.0, max_relative = 2e-15);
        }
    }

    #[test]
    fn halves_of_the_series_and_of_the_formula_meet() {
        let (below, above) = (2.5 - 1e-12, 2.5 + 1e-12);
        let (a, b) = (half_turn().at(below), half_turn().at(above));
        let slope = (b.q[0] - a.q[0]) / (above - below);
        assert_relative_eq!(slope, a.qd[0], max_relative = 1e-3);
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
            assert_abs_diff_eq!(slope(before.q[0], after.q[0]), now.qd[0], epsilon = 1e-9);
            assert_abs_diff_eq!(slope(before.qd[0], after.qd[0]), now.qdd[0], epsilon = 1e-9);
        }
    }

    #[test]
    fn zeros_at_the_ends_are_positive() {
        let law = Cycloidal::new(Vector2::zeros(), Vector2::new(3.0, -2.0), 2.0).unwrap();
        for t in [-1.0, 0.0, 2.0, 3.0] {
            let state = law.at(t);
            for rate in state.qd.iter().chain(&state.qdd) {
                assert!(*rate == 0.0 && rate.is_sign_positive(), "t = {t}: {rate}");
            }
        }
    }

    #[test]
    fn durations_that_are_none_are_refused() {
        for duration in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let error = Cycloidal::new(Vector1::zeros(), Vector1::zeros(), duration).unwrap_err();
            assert_eq!(error.joint, None);
            assert_eq!(error.duration.to_bits(), duration.to_bits());
            assert_eq!(
                error.to_string(),
                format!("a trajectory cannot last {duration:?} s")
            );
        }
    }

    #[test]
    fn rates_that_are_not_finite_are_refused() {
        for (start, end, duration) in [
            (0.0, 1.0, 1e-320),
            (0.0, 1.0, 1e-160),
            (0.0, 1e308, 1.0),
            (-1e308, 1e308, 1e10),
            (0.0, f64::INFINITY, 1.0),
            (f64::NAN, 0.0, 1.0),
        ] {
            let [start, end] = [start, end].map(|x| Vector2::new(0.0, x));
            let error = Cycloidal::new(start, end, duration).unwrap_err();
            let expected = InvalidDuration {
                duration,
                joint: Some(1),
            };
            assert_eq!(error, expected);
            assert_eq!(
                error.to_string(),
                format!(
                    "joint 2 cannot travel its distance in {duration:?} s: its rates are not finite"
                )
            );
        }
    }

    /// A motion that is accepted is finite at all times.
    #[test]
    fn extreme_durations_and_distances_are_finite() {
        for (distance, duration) in [
            (0.0, 1e-320),
            (1e-200, 1e-200),
            (1.0, 1e-150),
            (1e307, 10.0),
            (1.0, f64::MAX),
            (f64::MAX, f64::MAX),
        ] {
            let law = Cycloidal::new(Vector1::zeros(), Vector1::new(distance), duration).unwrap();
            for k in 0..=32 {
                let state = law.at(duration * (f64::from(k) / 32.0));
                for value in [state.q[0], state.qd[0], state.qdd[0]] {
                    assert!(value.is_finite(), "{distance:e} {duration:e}");
                }
            }
            assert_eq!(law.at(duration).q[0], distance);
        }
    }

    #[test]
    fn samples_are_at_equal_intervals() {
        let law = half_turn();
        let samples: Vec<_> = law.samples(4).collect();
        let times = [0.0, 10.0 / 3.0, 20.0 / 3.0, 10.0];
        assert_eq!(samples.len(), 4);
        for ((t, state), expected) in samples.into_iter().zip(times) {
            assert_eq!((t, state), (expected, law.at(expected)));
        }
        assert_eq!(law.samples(0).count(), 0);
        assert_eq!(law.samples(1).next(), Some((0.0, law.at(0.0))));
    }

    #[test]
    fn a_time_that_is_not_a_number_gives_none() {
        let state = half_turn().at(f64::NAN);
        assert!(state.q[0].is_nan() && state.qd[0].is_nan() && state.qdd[0].is_nan());
    }
}
