//! The operations of generated functions.
//!
//! Programs make their constants by `Scalar::constant`, exact numbers rounded once, and read fields by
//! `Scalar::exact`: the two differ for this scalar alone.

use num_traits::Zero;

use super::outward::Bound;
use super::rounded::Magnitude;
use super::{Certified, Rounded};
use crate::Scalar;

#[diagnostic::do_not_recommend]
impl<F: Rounded> Scalar for Certified<F> {
    /// A constant: an exact number that was rounded to the double `x`, which is rounded to the precision.
    fn from_f64(x: f64) -> Self {
        let Certified { value, error } = Self::read(x);
        // A constant that is zero is written only where it is zero exactly.
        let rounding = if x == 0.0 { 0.0 } else { x.rounding() };
        Certified::new(value, error + Bound::new(F::Magnitude::at_least(rounding)))
    }

    fn exact(self, x: f64) -> Self {
        Self::read(x)
    }

    /// As far again from the exact constant as the other single is, which is a neighbour: their difference is exact.
    fn rounded_once(self, single: f32) -> Self {
        let value = self.value.rounded_once(single);
        let distance = Bound::new((value - self.value).magnitude());
        Certified::new(value, self.error + distance)
    }

    fn epsilon() -> Self {
        Certified::exact(F::epsilon())
    }

    fn sin_cos(self) -> (Self, Self) {
        let [pair] = Self::sin_cos_array([self]);
        pair
    }

    /// |sin a' - sin a| <= |cos a'| |e_a| + e_a^2 / 2, by Taylor's theorem, and no more than |e_a|; the same of
    /// the cosine.
    fn sin_cos_array<const K: usize>(angles: [Self; K]) -> [(Self, Self); K] {
        let values = F::sin_cos_array(angles.map(|angle| angle.value));
        core::array::from_fn(|i| {
            let (angle, (sine, cosine)) = (angles[i], values[i]);
            if angle.is_zero() {
                return (angle, Certified::exact(cosine));
            }
            let kernel = [sine, cosine].map(|x| Bound::new(angle.value.sine_error(x)));
            let e = angle.error;
            let half_square = e * e * Bound::new(F::Magnitude::HALF);
            let passed_on = |slope: F, error: Bound<F::Magnitude>| {
                let slope = Bound::new(slope.magnitude()) + error;
                e.min(slope * e + half_square)
            };
            (
                Certified::new(sine, kernel[0] + passed_on(cosine, kernel[1])),
                Certified::new(cosine, kernel[1] + passed_on(sine, kernel[0])),
            )
        })
    }

    /// |sqrt a' - sqrt a| = |e_a| / (sqrt a' + sqrt a), where the sum of roots is at least sqrt a', and twice the
    /// root of a' - |e_a|.
    fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        if self.is_zero() {
            return self;
        }
        let rounding = Bound::new(value.rounding());
        if self.error == Bound::NONE {
            return Certified::new(value, rounding);
        }
        let root = |least: Bound<F::Magnitude>| Bound::new(least.get().root().below());
        let least_argument = self.least_size().beyond(self.error);
        let least = least_argument.and_then(|least| root(least).beyond(Bound::NONE));
        let root = Bound::new(value.least_magnitude()).beyond(rounding);
        let (Some(root), Some(least)) = (root, least) else {
            return Certified::new(value, Bound::UNKNOWN);
        };
        let half = Bound::new(F::Magnitude::HALF);
        let passed_on = (self.error / root).min(half * self.error / least);
        Certified::new(value, passed_on + rounding)
    }

    /// |exp a' - exp a| <= exp a' (exp |e_a| - 1), which is at most exp a' (|e_a| + e_a^2) up to |e_a| = 1.
    fn exp(self) -> Self {
        let value = Scalar::exp(self.value);
        let kernel = Bound::new(value.kernel_error());
        let e = self.error;
        if e == Bound::NONE {
            return Certified::new(value, kernel);
        }
        let is_small = e.get() <= F::Magnitude::ONE;
        let grown = if is_small { e + e * e } else { Bound::UNKNOWN };
        let largest = Bound::new(value.magnitude()) + kernel;
        Certified::new(value, kernel + largest * grown)
    }

    fn mul_add(self, a: Self, b: Self) -> Self {
        if !F::FUSED {
            return self * a + b;
        }
        let value = self.value.mul_add(a.value, b.value);
        let rounding = Self::rounding(value, self.value == F::ZERO || a.value == F::ZERO);
        Certified::new(value, self.error_of_product(a) + b.error + rounding)
    }

    /// Certain where the number cannot be zero, or is it exactly; else off by up to 1 + |sign a'|.
    fn sign(self) -> Self {
        let value = self.value.sign();
        let one = F::Magnitude::ONE;
        let error = if self.error == Bound::UNKNOWN {
            Bound::UNKNOWN
        } else if self.error == Bound::NONE || self.least_size().beyond(self.error).is_some() {
            Bound::NONE
        } else {
            Bound::new(if value == F::ZERO { one } else { one + one })
        };
        Certified::new(value, error)
    }

    /// The answer for the value: the same branches are taken as without bounds.
    fn is_positive(self) -> bool {
        self.value.is_positive()
    }

    fn ratio_to_f64(self, of: Self) -> f64 {
        self.value.ratio_to_f64(of.value)
    }
}

impl<F: Rounded> Certified<F> {
    /// A double, as it is read in this precision.
    fn read(x: f64) -> Self {
        let value = F::from_f64(x);
        // Exact: the difference has no more digits than x.
        let distance = F::Magnitude::at_least((x - value.to_f64()).abs());
        Certified::new(value, Bound::new(distance))
    }
}
