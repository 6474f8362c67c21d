//! Sines in double precision.
//!
//! Angles beyond the reduction in lanes take the exact one of the `libm` crate (Payne and Hanek 1983), which
//! is the same on every platform; the C library's loses up to 80 units in the last place near multiples of
//! pi/2.
//!
//! Error below one unit in the last place for |x| <= 1e5, which is proven (see the tests); measured on ten million
//! angles against double-double values it is below 0.8, and beyond 1e5 too. In the lanes of
//! batches, which evaluate the same polynomials in fewer operations, it is measured below 0.9.

mod polynomial;
#[cfg(test)]
mod proof;
mod reduction;

use super::lanes::{Kernel, Lanes, Reduced};

impl Kernel for f64 {
    const HALF: Self = 0.5;
    const ONE: Self = 1.0;
    const LARGEST: f64 = 1e5;

    #[inline(always)]
    fn reduce<L: Lanes<Number = f64>>(x: L) -> Reduced<L> {
        reduction::reduce(x)
    }

    #[inline(always)]
    fn sin_cos_reduced<L: Lanes<Number = f64>>(x: L, d: L) -> (L, L) {
        polynomial::sin_cos_reduced(x, d)
    }

    #[cfg(feature = "std")]
    #[inline(always)]
    fn sine_reduced<L: Lanes<Number = f64>>(x: L, d: L) -> L {
        polynomial::sine_reduced(x, d)
    }

    #[inline]
    fn sin_cos_of_large(self) -> (f64, f64) {
        libm::sincos(self)
    }
}
