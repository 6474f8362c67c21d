//! Angles that are whole multiples of common ones.
//!
//! Joints that follow one leader turn by the angles k_i x. Twice the kinetic energy of a link is of degree 2 at most
//! in the sine and the cosine of each angle, and the potential energy is of degree 1. So every energy is a sum of
//! waves exp(i (e . k) x) with whole numbers |e_i| <= 2, whose amplitudes are polynomials in positions and velocities.
//! Waves of different frequencies are linearly independent. A combination of energies is therefore constant if and
//! only if the amplitudes of each frequency add up to none.
//!
//! Two waves e and e' have one frequency if (e - e') . k = 0, where |e_i - e'_i| <= 4. Such a relation is called
//! short. All that matters about the factors is which short relations they have. Angles that satisfy these
//! relations, and are independent otherwise, lead to the same combinations: cos 1000 x and cos 997 x count as those
//! of two angles. If a relation is left out, every combination that is found still holds, but some may be missed.

use super::{Residue, negate_if};
use std::collections::BTreeMap;

/// The largest coefficient of a short relation.
const LARGEST_COEFFICIENT: i64 = 4;

/// The largest multiple of an angle. A relation that would need a larger one is left out: factors such as 1, 4, 16,
/// 64 and 256 have one.
const LARGEST_MULTIPLE: i64 = 64;

/// Among how many factors relations are looked for: a leader and as many followers as the macro allows. The work is
/// 9^5 sums for 9 factors.
const MOST_FACTORS: usize = 9;

/// Angles k_i x by the factors k_i of one angle x, as whole multiples of independent angles: for each factor as many
/// multiples as there are angles.
pub fn common_angles<const P: u64>(factors: &[Residue<P>]) -> Vec<Vec<i64>> {
    let mut angles: Vec<Vec<i64>> = (0..factors.len())
        .map(|own| (0..factors.len()).map(|i| i64::from(i == own)).collect())
        .collect();
    for (group, some) in factors.chunks(MOST_FACTORS).enumerate() {
        for_each_relation(some, |relation| {
            let mut whole = vec![0; group * MOST_FACTORS];
            whole.extend(relation);
            if let Some(fewer) = with_relation(&angles, &whole) {
                angles = fewer;
            }
        });
    }
    let multiples = |i: usize| angles.iter().map(|angle| angle[i]).collect();
    (0..factors.len()).map(multiples).collect()
}

/// Calls `use_relation` with short relations of the factors, of which all others are combinations.
///
/// A relation says that a sum of the first half of the terms is the opposite of a sum of the second half. A number
/// that is not zero has the residue zero by a chance of 9^9 / 2^61, about 2e-10, for all relations together.
fn for_each_relation<const P: u64>(factors: &[Residue<P>], mut use_relation: impl FnMut(Vec<i64>)) {
    let (left, right) = factors.split_at(factors.len() / 2);
    let mut by_sum: BTreeMap<Residue<P>, Vec<Vec<i64>>> = BTreeMap::new();
    for (sum, coefficients) in sums(left) {
        by_sum.entry(sum).or_default().push(coefficients);
    }
    for (sum, others) in sums(right) {
        let Some(opposite) = by_sum.get_mut(&-sum) else {
            continue;
        };
        for coefficients in opposite.iter() {
            use_relation([&coefficients[..], &others].concat());
        }
        // With the next sum of the same value one of them is enough.
        opposite.truncate(1);
    }
}

/// All sums of the factors with coefficients of short relations.
fn sums<const P: u64>(factors: &[Residue<P>]) -> Vec<(Residue<P>, Vec<i64>)> {
    let mut sums = vec![(Residue::ZERO, Vec::new())];
    for &factor in factors {
        let mut longer = Vec::new();
        for (sum, coefficients) in &sums {
            for coefficient in -LARGEST_COEFFICIENT..=LARGEST_COEFFICIENT {
                let size = Residue::new(coefficient.unsigned_abs()) * factor;
                let term = negate_if(size, coefficient < 0);
                longer.push((*sum + term, [&coefficients[..], &[coefficient]].concat()));
            }
        }
        sums = longer;
    }
    sums
}

/// The angles that are left independent by one more relation. `None` if the angles satisfy it already, or if a
/// multiple would be too large.
///
/// The angles y, of which `angles` has the multiples, then satisfy w . y = 0. The last one that has a part in it is
/// written by the others.
fn with_relation(angles: &[Vec<i64>], relation: &[i64]) -> Option<Vec<Vec<i64>>> {
    let part = |angle: &Vec<i64>| -> i64 { angle.iter().zip(relation).map(|(n, c)| n * c).sum() };
    let last = angles.iter().rposition(|angle| part(angle) != 0)?;
    let (of_last, sign) = (part(&angles[last]), part(&angles[last]).signum());
    let without_last = |angle: &Vec<i64>| -> Vec<i64> {
        let own = part(angle);
        let pairs = angle.iter().zip(&angles[last]);
        let multiples: Vec<i64> = pairs
            .map(|(n, n_last)| sign * (n * of_last - n_last * own))
            .collect();
        let sizes = multiples.iter().map(|n| n.abs());
        let divisor = sizes.fold(0, greatest_divisor);
        multiples.iter().map(|n| n / divisor.max(1)).collect()
    };
    let others = (0..angles.len()).filter(|k| *k != last);
    let fewer: Vec<_> = others.map(|k| without_last(&angles[k])).collect();
    let is_small = |n: &i64| n.abs() <= LARGEST_MULTIPLE;
    fewer.iter().flatten().all(is_small).then_some(fewer)
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

    fn found<const N: usize>(factors: [(i64, u64); N]) -> Vec<Vec<i64>> {
        common_angles(&factors.map(|(n, d)| fraction(n, d)))
    }

    #[test]
    fn fractions_have_a_common_angle() {
        let angles = found([(1, 1), (-1, 2), (2, 1), (5, 3), (0, 1)]);
        assert_eq!(angles, [[6], [-3], [12], [10], [0]]);
        assert_eq!(found([(0, 1)]), [[0; 0]]);
    }

    #[test]
    fn a_parameter_has_an_angle_of_its_own() {
        let k = Number::random(&mut SplitMix64::new(1));
        let factors = [Number::ONE, k, -Number::ONE, fraction(-2, 3) * k];
        assert_eq!(common_angles(&factors), [[1, 0], [0, 3], [-1, 0], [0, -2]]);
    }

    #[test]
    fn decimals_have_angles_of_their_own_but_for_their_short_relations() {
        assert_eq!(found([(1, 1), (-997, 1000)]), [[1, 0], [0, 1]]);
        assert_eq!(found([(1, 1), (1, 5)]), [[1, 0], [0, 1]]);
        // 1/3 + 2/3 in four decimals, and four times one less three times the other.
        let angles = found([(1, 1), (3_333, 10_000), (6_667, 10_000)]);
        assert_eq!(angles, [[1, 0], [0, 1], [1, -1]]);
        let angles = found([(1, 1), (123_457, 1_000_000), (493_828, 3_000_000)]);
        assert_eq!(angles, [[1, 0], [0, 3], [0, 4]]);
    }

    #[test]
    fn multiples_are_bounded() {
        let powers = [0, 1, 2, 3, 4, 5].map(|k| (4_i64.pow(k), 1));
        let angles = found(powers);
        assert!(angles.iter().flatten().all(|n| (0..=64).contains(n)));
        assert_eq!(angles[0].len(), 2);
    }

    #[test]
    fn more_factors_than_relations_are_looked_for() {
        let angles = found([(1, 1); 12]);
        assert_eq!(angles[..9], [[1, 0]; 9]);
        assert_eq!(angles[9..], [[0, 1]; 3]);
    }
}
