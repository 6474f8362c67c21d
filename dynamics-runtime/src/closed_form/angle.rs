//! Angles of points of the unit circle, many at once.
//!
//! The library's arc tangent takes most of the time of a closed form, one angle after the other. Here are no branches, so that
//! the compiler evaluates as many angles at once as the processor has lanes, and the digits are the same on every platform.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use super::Real;

/// tan(pi/8)
const TANGENT_OF_EIGHTH: f64 = 0.414_213_562_373_095_04;

/// The angle from -pi to pi with this sine and cosine, up to a common positive factor; 0 where both vanish. The error is below
/// 5e-16 rad, for a sine that is small beside the cosine below two units in the last place; in single precision below 3e-7 rad.
#[inline(always)]
pub(super) fn angle<T: Real>(sine: T, cosine: T) -> T {
    let [zero, one, eighth, quarter, half] = [0.0, 1.0, FRAC_PI_4, FRAC_PI_2, PI].map(T::from_f64);
    let size = |x: T| if x > zero { x } else { zero - x };
    let (s, c) = (size(sine), size(cosine));
    let is_steep = s > c;
    let (small, large) = if is_steep { (c, s) } else { (s, c) };
    // tan(x - pi/4) = (tan x - 1) / (tan x + 1)
    let is_far = small > T::from_f64(TANGENT_OF_EIGHTH) * large;
    let (over, under) = if is_far {
        (small - large, small + large)
    } else {
        (small, large)
    };
    let z = over / if under == zero { one } else { under };
    let square = z * z;
    let angle = z - z * (square * square.arc_tangent());
    let angle = if is_far { eighth + angle } else { angle };
    let angle = if is_steep { quarter - angle } else { angle };
    let angle = if cosine < zero { half - angle } else { angle };
    if sine < zero { -angle } else { angle }
}

/// Replaces cosines by the angles that they and the sines belong to, above -pi and up to pi.
pub(super) fn angles<T: Real>(sines: &[T], cosines: &mut [T]) {
    let half_turn = T::from_f64(PI);
    T::vectorized(
        #[inline(always)]
        || {
            for (sine, cosine) in sines.iter().zip(cosines) {
                let angle = angle(*sine, *cosine);
                // An angle that rounding takes to -pi, from above, is half a turn all the same.
                let is_half_turn = angle <= -half_turn;
                *cosine = if is_half_turn { half_turn } else { angle };
            }
        },
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_are_those_of_the_library() {
        let mut worst = 0.0_f64;
        for k in -100_000..=100_000 {
            let x = f64::from(k) * (PI / 100_000.0);
            let (s, c) = x.sin_cos();
            let expected = s.atan2(c);
            worst = worst.max((angle(s, c) - expected).abs());
            assert!((angle(s * 1e-9, c * 1e-9) - expected).abs() < 9e-16);
        }
        assert!(worst < 5e-16, "{worst:e}");
    }

    #[test]
    fn angles_in_single_precision_are_those_of_the_library() {
        let mut worst = 0.0_f64;
        for k in -100_000..=100_000 {
            let x = f64::from(k) * (PI / 100_000.0);
            let (s, c) = (x.sin() as f32, x.cos() as f32);
            let expected = f64::from(s).atan2(f64::from(c));
            worst = worst.max((f64::from(angle(s, c)) - expected).abs());
        }
        assert!(worst < 3e-7, "{worst:e}");
        for k in 1..200 {
            let x = 0.9_f32.powi(k);
            let relative = f64::from(angle(x, 1.0)) / f64::from(x).atan() - 1.0;
            assert!(relative.abs() < 3e-7, "{x} {relative:e}");
        }
    }

    #[test]
    fn small_angles_keep_their_digits() {
        for k in 1..300 {
            let x = 0.9_f64.powi(k);
            assert!((angle(x, 1.0) / x.atan() - 1.0).abs() < 5e-16, "{x}");
        }
        assert_eq!(angle(1e-300, 1.0), 1e-300);
    }

    /// A sine that is nothing but rounding belongs to half a turn, whatever its sign.
    #[test]
    fn half_a_turn_is_pi() {
        let (sines, mut cosines) = ([0.0, -0.0, -1e-300, -1.2e-16, 1.2e-16, -1e-9], [-1.0; 6]);
        angles(&sines, &mut cosines);
        assert_eq!(cosines[..5], [PI; 5]);
        assert!(cosines[5] > -PI && cosines[5] < -3.1);
        let (sines, mut cosines) = ([-1e-9_f32, 1e-9, -1e-6], [-1.0_f32; 3]);
        angles(&sines, &mut cosines);
        assert_eq!(cosines[..2], [core::f32::consts::PI; 2]);
        assert!(cosines[2] > -core::f32::consts::PI && cosines[2] < -3.1);
        let mut cosines = [-1.0];
        angles(&[f64::NAN], &mut cosines);
        assert!(cosines[0].is_nan());
    }

    #[test]
    fn quarters_are_exact() {
        let of = |s: f64, c: f64| angle(s, c);
        assert_eq!(
            [of(0.0, 1.0), of(1.0, 0.0), of(-1.0, 0.0)],
            [0.0, FRAC_PI_2, -FRAC_PI_2]
        );
        assert_eq!([of(0.0, -1.0), of(-0.0, -1.0), of(0.0, 0.0)], [PI, PI, 0.0]);
        assert!(of(f64::NAN, 1.0).is_nan());
    }
}
