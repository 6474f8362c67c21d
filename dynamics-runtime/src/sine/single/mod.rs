//! Sines in single precision, without an operation in another.
//!
//! Error below 0.81 units in the last place for |x| <= 1e4 (measured, see the
//! tests) and beyond, where the reduction is exact, in integers; in the lanes of batches below 0.85 units.

mod integers;
mod polynomial;
mod reduction;
#[cfg(test)]
mod tests;

use super::lanes::{Kernel, Lanes, Reduced};

impl Kernel for f32 {
    const HALF: Self = 0.5;
    const ONE: Self = 1.0;
    const LARGEST: f32 = 1e4;

    #[inline(always)]
    fn reduce<L: Lanes<Number = f32>>(x: L) -> Reduced<L> {
        reduction::reduce(x)
    }

    #[inline(always)]
    fn sin_cos_reduced<L: Lanes<Number = f32>>(x: L, d: L) -> (L, L) {
        polynomial::sin_cos_reduced(x, d)
    }

    #[cfg(feature = "std")]
    #[inline(always)]
    fn sine_reduced<L: Lanes<Number = f32>>(x: L, d: L) -> L {
        polynomial::sine_reduced(x, d)
    }

    fn sin_cos_of_large(self) -> (f32, f32) {
        if !self.is_finite() {
            return (f32::NAN, f32::NAN);
        }
        let (sine, cosine) = super::of_reduced(integers::reduce(self.abs()));
        (if self < 0.0 { -sine } else { sine }, cosine)
    }
}
