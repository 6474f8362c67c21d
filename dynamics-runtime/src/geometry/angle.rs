//! Sines and cosines of joint angles and of the table's constant angles.

use core::f64::consts::{FRAC_PI_2, TAU};

use crate::Scalar;
use crate::float::sin_cos;

/// Constant angles closer than this to a multiple of pi/2, relative to the angle, mean exactly that
/// multiple: the multiple itself is a rounded number.
///
/// The macro's own rule is wider: decimals within 1e-9 rad are written into the table as the double
/// nearest to the multiple. It takes whole turns off large constants before it rounds them.
const RIGHT_ANGLE_TOLERANCE: f64 = 4.0 * f64::EPSILON;

/// Sine and cosine of one angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SinCos {
    /// The sine.
    pub sin: f64,
    /// The cosine.
    pub cos: f64,
}

impl SinCos {
    /// The angle zero.
    pub const ZERO: SinCos = SinCos { sin: 0.0, cos: 1.0 };

    /// The angle of a joint by itself: all others are evaluated side by side.
    #[cold]
    pub fn of_joint(angle: f64) -> Self {
        let [(sin, cos)] = f64::sin_cos_array([angle]);
        SinCos { sin, cos }
    }

    /// A constant angle of the table: at multiples of pi/2 the values are 0 and +-1 exactly.
    pub fn of_constant(angle: f64) -> Self {
        let quarters = libm::round(angle / FRAC_PI_2);
        if (angle - quarters * FRAC_PI_2).abs() > RIGHT_ANGLE_TOLERANCE * angle.abs() {
            let (sin, cos) = sin_cos(angle);
            return SinCos { sin, cos };
        }
        let (sin, cos) = match libm::fmod(quarters, 4.0) {
            0.0 => (0.0, 1.0),
            1.0 | -3.0 => (1.0, 0.0),
            2.0 | -2.0 => (0.0, -1.0),
            3.0 | -1.0 => (-1.0, 0.0),
            // The angle is not finite.
            _ => (f64::NAN, f64::NAN),
        };
        SinCos { sin, cos }
    }

    /// The angle with the other sign.
    #[inline(always)]
    pub fn opposite(self) -> Self {
        SinCos {
            sin: -self.sin,
            cos: self.cos,
        }
    }

    /// The sum of two angles, by the addition theorems.
    ///
    /// Adding a constant to a joint angle before taking the sine would round the sum: at 1e6 rad
    /// that costs ten digits.
    #[inline(always)]
    pub fn plus(self, other: SinCos) -> Self {
        SinCos {
            sin: self.sin * other.cos + self.cos * other.sin,
            cos: self.cos * other.cos - self.sin * other.sin,
        }
    }
}

/// `angle` turned by so many quarter turns: an angle of a generated table that depends on fields.
///
/// A sum beyond a turn would round away digits of `angle`, and is less whole turns.
#[doc(hidden)]
pub fn turned(angle: f64, quarter_turns: f64) -> f64 {
    let turn = quarter_turns * FRAC_PI_2;
    if (angle + turn).abs() <= TAU {
        return angle + turn;
    }
    let (sin, cos) = sin_cos(angle);
    libm::atan2(sin, cos) + turn
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, PI};

    use super::{SinCos, turned};

    #[test]
    #[cfg_attr(miri, ignore = "the standard library's sines vary there on purpose")]
    fn a_turn_by_quarters_keeps_the_digits_of_large_angles() {
        assert_eq!(turned(0.3, 1.0), 0.3 + FRAC_PI_2);
        assert_eq!(turned(-6.0, 2.0), -6.0 + PI);
        for angle in [1e6, -1e6, 7.0, 1e15] {
            let sum = turned(angle, 1.0);
            assert!((sum.sin() - angle.cos()).abs() < 4e-16, "{angle}");
            assert!((sum.cos() + angle.sin()).abs() < 4e-16, "{angle}");
        }
        assert!(turned(f64::NAN, 1.0).is_nan() && turned(f64::INFINITY, 1.0).is_nan());
    }

    fn of(angle: f64) -> (f64, f64) {
        let SinCos { sin, cos } = SinCos::of_constant(angle);
        (sin, cos)
    }

    #[test]
    fn right_angles_are_exact() {
        assert_eq!(of(0.0), (0.0, 1.0));
        assert_eq!(of(FRAC_PI_2), (1.0, 0.0));
        assert_eq!(of(-FRAC_PI_2), (-1.0, 0.0));
        assert_eq!(of(PI), (0.0, -1.0));
        assert_eq!(of(-7.0 * FRAC_PI_2), (1.0, 0.0));
        assert_eq!(of(FRAC_PI_2.next_up()), (1.0, 0.0));
    }

    #[test]
    #[cfg_attr(miri, ignore = "the standard library's sines vary there on purpose")]
    fn other_angles_are_left_alone() {
        for angle in [1.0, -0.3, 1e-300, FRAC_PI_2 + 1e-10, PI - 1e-5] {
            assert_eq!(of(angle), angle.sin_cos());
        }
    }

    #[test]
    fn what_is_not_finite_propagates() {
        assert!(of(f64::NAN).0.is_nan() && of(f64::INFINITY).1.is_nan());
    }

    #[test]
    #[cfg_attr(miri, ignore = "the standard library's sines vary there on purpose")]
    fn a_constant_offset_does_not_round_the_joint_angle() {
        let joint = SinCos::of_joint(1e6);
        let sum = joint.plus(SinCos::of_constant(FRAC_PI_2));
        assert_eq!((sum.sin, sum.cos), (1e6_f64.cos(), -1e6_f64.sin()));
    }
}
