//! Square roots of rational numbers.

use super::Rational;
use dashu_int::ops::{BitTest, SquareRoot};
use dashu_int::{IBig, UBig};

/// Bits to which an irrational root is known.
const PRECISION: usize = 256;

/// The square root: exactly, where it is rational, or else a rational number that differs from it by less
/// than 1e-60 of its size. None where `x` is negative.
pub fn square_root(x: &Rational) -> Option<Rational> {
    // sqrt(p / q) = sqrt(p q) / q
    let denominator = x.denominator().clone();
    let product = UBig::try_from(x.numerator() * IBig::from(denominator.clone())).ok()?;
    let root = product.sqrt();
    if &root * &root == product {
        return Some(Rational::from(root) / Rational::from(denominator));
    }
    let bits = PRECISION.saturating_sub(product.bit_len() / 2);
    let root = (product << (2 * bits)).sqrt();
    Some(Rational::from(root) / Rational::from(denominator << bits))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn root(numerator: i64, denominator: u64) -> Option<Rational> {
        square_root(&Rational::from_parts(numerator.into(), denominator.into()))
    }

    #[test]
    fn roots_of_squares_are_exact() {
        assert_eq!(
            root(9, 4),
            Some(Rational::from_parts(3.into(), 2_u8.into()))
        );
        assert_eq!(root(0, 1), Some(Rational::ZERO));
        assert_eq!(root(-1, 4), None);
        let prime = 1_000_003;
        assert_eq!(root(prime * prime, 1), Some(Rational::from(prime)));
    }

    #[test]
    fn other_roots_are_near() {
        let bound = Rational::ONE / Rational::from(10).pow(60);
        for (numerator, denominator) in [(2, 1_u64), (1, 2), (3, 1_000_000_000_000), (i64::MAX, 7)]
        {
            let x = Rational::from_parts(numerator.into(), denominator.into());
            let root = square_root(&x).unwrap();
            // The square differs by twice as much as the root.
            let error = (&root * &root - &x) / &x;
            assert!(error <= Rational::ZERO && -error < bound, "{x}");
            assert_eq!(root.to_f64().value(), x.to_f64().value().sqrt());
        }
    }
}
