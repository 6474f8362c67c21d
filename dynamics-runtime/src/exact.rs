//! Sums and products of doubles, and what their rounding leaves out, exactly.

use crate::float::{FUSED, Float as _};
#[cfg(feature = "std")]
use crate::size::JointVector;

/// `a + b` rounded, and what the rounding has left out (2Sum: D. E. Knuth, *The Art of Computer
/// Programming* 2, theorem 4.2.2 B).
#[inline(always)]
pub fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let part = sum - a;
    (sum, (a - (sum - part)) + (b - part))
}

/// The same of every entry.
#[cfg(feature = "std")]
#[inline(always)]
pub fn two_sums<V: JointVector>(a: &V, b: &V) -> (V, V) {
    let size = a.entries().len();
    let sums = |part: fn((f64, f64)) -> f64| V::from_entries(size, |i| part(two_sum(a[i], b[i])));
    (sums(|(sum, _)| sum), sums(|(_, rest)| rest))
}

/// The same where |a| >= |b| or a = 0 (Fast2Sum; Dekker 1971).
#[inline(always)]
pub(crate) fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// `a b` rounded, and what the rounding has left out (2Prod): by a fused operation where the target
/// has it, else by the halves of the factors, which is several times faster than a fused operation
/// in software.
#[inline]
pub(crate) fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let rest = if FUSED {
        a.fused(b, -product)
    } else {
        by_halves(a, b, product)
    };
    (product, rest)
}

/// `a b - product`, where `product` is the rounded product (Dekker 1971).
#[inline]
fn by_halves(a: f64, b: f64, product: f64) -> f64 {
    let ((a1, a2), (b1, b2)) = (halves(a), halves(b));
    let rest = ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2;
    // The halves of numbers beyond 2^996 overflow.
    if rest.is_nan() {
        a.fused(b, -product)
    } else {
        rest
    }
}

/// A number as the sum of two that have 26 bits each (Veltkamp 1968).
#[inline]
fn halves(x: f64) -> (f64, f64) {
    // 2^27 + 1
    let scaled = 134_217_729.0 * x;
    let upper = scaled - (scaled - x);
    (upper, x - upper)
}
