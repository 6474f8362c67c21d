//! Angles that are whole multiples of common ones.

use super::Residue;

/// The largest numerator and denominator of a ratio of two angles.
const LARGEST: i64 = 1_000;

/// The largest common denominator.
const MOST: i64 = 1_000_000;

/// Angles k_i x by the factors k_i of one angle x: for each of them a number, which is the same where the
/// ratio of two factors is a fraction of small numbers, and the whole multiple that it is of an angle that
/// all those with this number have in common. A sine of one number is independent of those of another.
pub fn common_angles<const P: u64>(factors: &[Residue<P>]) -> Vec<(usize, i64)> {
    // The first factor of each number, and a common denominator of all ratios to it.
    let mut known: Vec<(Residue<P>, i64)> = Vec::new();
    let mut ratios = Vec::with_capacity(factors.len());
    for &factor in factors {
        let found = known
            .iter()
            .enumerate()
            .find_map(|(number, (first, common))| {
                let ratio = small_fraction(factor * first.inverse()?)?;
                let common = common * (ratio.1 / greatest_divisor(*common, ratio.1));
                (common <= MOST).then_some((number, ratio, common))
            });
        let (number, ratio) = match found {
            Some((number, ratio, common)) => {
                known[number].1 = common;
                (number, ratio)
            }
            None => {
                let (first, ratio) = match factor.is_zero() {
                    true => (Residue::ONE, (0, 1)),
                    false => (factor, (1, 1)),
                };
                known.push((first, 1));
                (known.len() - 1, ratio)
            }
        };
        ratios.push((number, ratio));
    }
    let multiple = |(number, (numerator, denominator)): (usize, (i64, i64))| {
        (number, numerator * (known[number].1 / denominator))
    };
    ratios.into_iter().map(multiple).collect()
}

/// The fraction of small numbers that has this residue, by the steps of Euclid's algorithm: a residue of
/// any other number is one by a chance of 10^-12.
fn small_fraction<const P: u64>(x: Residue<P>) -> Option<(i64, i64)> {
    let (mut r0, mut r1) = (P as i64, x.get() as i64);
    let (mut t0, mut t1) = (0_i64, 1_i64);
    while r1 > LARGEST {
        let quotient = r0 / r1;
        (r0, r1) = (r1, r0 - quotient * r1);
        (t0, t1) = (t1, t0.checked_sub(quotient.checked_mul(t1)?)?);
    }
    let (numerator, denominator) = if t1 < 0 { (-r1, -t1) } else { (r1, t1) };
    (denominator <= LARGEST).then_some((numerator, denominator))
}

fn greatest_divisor(a: i64, b: i64) -> i64 {
    if b == 0 {
        a
    } else {
        greatest_divisor(b, a % b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{Rational, SplitMix64};

    type Number = Residue<{ (1 << 61) - 1 }>;

    fn fraction(numerator: i64, denominator: u64) -> Number {
        let x = Rational::from_parts(numerator.into(), denominator.into());
        Number::from_rational(&x).unwrap()
    }

    #[test]
    fn fractions_have_a_common_angle() {
        let factors = [(1, 1), (-1, 2), (2, 1), (5, 3), (0, 1)].map(|(n, d)| fraction(n, d));
        let expected = [(0, 6), (0, -3), (0, 12), (0, 10), (0, 0)];
        assert_eq!(common_angles(&factors), expected);
        assert_eq!(common_angles(&[Number::ZERO]), [(0, 0)]);
    }

    #[test]
    fn a_parameter_has_an_angle_of_its_own() {
        let k = Number::random(&mut SplitMix64::new(1));
        let factors = [Number::ONE, k, -Number::ONE, fraction(-2, 3) * k];
        assert_eq!(common_angles(&factors), [(0, 1), (1, 3), (0, -1), (1, -2)]);
    }
}
