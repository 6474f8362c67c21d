//! Angles of parallel axes, added up: sin(q1 + q2) for s1 c2 + c1 s2.
//!
//! In the angles of a group of parallel axes a polynomial is a Fourier polynomial: a sum of cosines and sines of whole
//! multiples n1 q1 + n2 q2 + ... Where all multiples are 1, that is what textbooks write c12. Other multiples are
//! written as products, cos(2 q2 + q3) = 2 c2 c23 - c3, by the identity that leaves the fewest terms.

use super::atom::{Atom, Run};
use super::groups::{Groups, Member};
use crate::exact::{Rational, negate_if};
use crate::polynomial::{self, Monomial, Polynomial, product};
use std::collections::BTreeMap;

/// A polynomial in sines and cosines of sums of angles.
pub(super) fn merged(polynomial: &Polynomial<Atom>, groups: &Groups) -> Polynomial<Atom> {
    let mut merged = polynomial.clone();
    for (group, members) in groups.members_of_all() {
        if members.len() > 1 {
            merged = merged_in(&merged, group, members);
        }
    }
    with_squares_of_sines(merged)
}

/// The multiples n of the angles of a group.
type Multiples = Vec<i32>;

/// Amplitudes of cos(n . q) and sin(n . q), where the first multiple that is not 0 is positive. The
/// angles are counted about the first axis of the group.
type Waves = BTreeMap<Multiples, [Rational; 2]>;

const NONE: [Rational; 2] = [Rational::ZERO, Rational::ZERO];

fn merged_in(polynomial: &Polynomial<Atom>, group: usize, members: &[Member]) -> Polynomial<Atom> {
    let mut by_rest: BTreeMap<Monomial<Atom>, Waves> = BTreeMap::new();
    for (monomial, coefficient) in polynomial.terms() {
        let turns = |(atom, power): &&(Atom, i32)| match atom {
            Atom::Cosine(run) | Atom::Sine(run) => run.group == group && *power > 0,
            _ => false,
        };
        let (turning, rest): (Monomial<Atom>, _) = monomial.iter().partition(turns);
        let waves = waves_of(&turning, members, coefficient);
        add_waves(by_rest.entry(rest).or_default(), waves);
    }
    let mut sum = Polynomial::zero();
    for (rest, waves) in by_rest {
        for (monomial, coefficient) in in_products(waves, group, members).terms() {
            sum.add_term(product(&rest, monomial), coefficient);
        }
    }
    sum
}

/// A coefficient times a product of sines and cosines as exponentials exp(i n . q), real and imaginary
/// parts of their amplitudes: cos q = (z + 1/z) / 2, sin q = (z - 1/z) / 2i with z = exp(i q).
fn waves_of(
    turning: &Monomial<Atom>,
    members: &[Member],
    coefficient: &Rational,
) -> BTreeMap<Multiples, [Rational; 2]> {
    let start = vec![0; members.len()];
    let mut waves = BTreeMap::from([(start, [coefficient.clone(), Rational::ZERO])]);
    for &(atom, power) in turning {
        let (Atom::Cosine(run) | Atom::Sine(run)) = atom else {
            unreachable!("factors that turn are sines and cosines");
        };
        for _ in 0..power {
            let mut next: BTreeMap<Multiples, [Rational; 2]> = BTreeMap::new();
            for (multiples, [re, im]) in waves {
                for step in [1, -1] {
                    let mut key = multiples.clone();
                    key[run.first] += step;
                    let half = |x: &Rational| x / Rational::from(2);
                    let is_positive = (step == 1) != members[run.first].is_reversed;
                    let [x, y] = match atom {
                        Atom::Cosine(_) => [half(&re), half(&im)],
                        // (re + i im) / 2i
                        _ if is_positive => [half(&im), -half(&re)],
                        _ => [-half(&im), half(&re)],
                    };
                    let sum = next.entry(key).or_insert(NONE);
                    sum[0] += x;
                    sum[1] += y;
                }
            }
            waves = next;
        }
    }
    waves
}

/// Adds exponentials, which come with their conjugates: c z + conj(c) / z = 2 Re c cos - 2 Im c sin.
fn add_waves(sum: &mut Waves, exponentials: BTreeMap<Multiples, [Rational; 2]>) {
    for (multiples, [re, im]) in exponentials {
        let factor = match multiples.iter().find(|&&n| n != 0) {
            None => 1,
            Some(n) if *n > 0 => 2,
            Some(_) => continue,
        };
        let [cosine, sine] = sum.entry(multiples).or_insert(NONE);
        *cosine += re * Rational::from(factor);
        *sine -= im * Rational::from(factor);
    }
}

/// The waves as products of sines and cosines of runs, the largest multiples first.
fn in_products(mut waves: Waves, group: usize, members: &[Member]) -> Polynomial<Atom> {
    let mut sum = Polynomial::zero();
    let size = |multiples: &Multiples| multiples.iter().map(|n| n.abs()).sum::<i32>();
    while let Some(largest) = waves.keys().max_by_key(|n| size(n)).cloned() {
        let [cosine, sine] = waves.remove(&largest).expect("it is one of them");
        let Some([first, second]) = split(&largest) else {
            let [c, s] = turn(&largest, group, members);
            sum.add_multiple(&c, &cosine);
            sum.add_multiple(&s, &sine);
            continue;
        };
        let [c1, s1] = turn(&first, group, members);
        let [c2, s2] = turn(&second, group, members);
        let difference: Multiples = first.iter().zip(&second).map(|(a, b)| a - b).collect();
        let is_backwards = difference.iter().find(|&&n| n != 0).is_some_and(|n| *n < 0);
        let multiples = difference.iter().map(|n| negate_if(*n, is_backwards));
        let key: Multiples = multiples.collect();
        let mut none = NONE;
        let [by_cosine, by_sine] = waves.get_mut(&key).unwrap_or(&mut none);
        // cos(a + b) = cos a cos b - sin a sin b
        let products = [times(&c1, &c2), times(&s1, &s2)];
        add_wave(&mut sum, cosine, true, products, by_cosine, false);
        // sin(a + b) = sin a cos b + cos a sin b
        let products = [times(&s1, &c2), times(&c1, &s2)];
        add_wave(&mut sum, sine, false, products, by_sine, is_backwards);
    }
    sum
}

/// Adds the wave of a sum of angles, x (A + B) or x (A - B). The wave of the difference of the angles has the other sign
/// between its products: if its amplitude is x or -x, both waves are 2 x A, or 2 x times the other one, and it is taken.
fn add_wave(
    sum: &mut Polynomial<Atom>,
    x: Rational,
    is_difference: bool,
    [a, b]: [Polynomial<Atom>; 2],
    partner: &mut Rational,
    is_opposite: bool,
) {
    let y = negate_if(partner.clone(), is_opposite);
    let second = negate_if(x.clone(), is_difference);
    let twice = Rational::from(2);
    if y == x {
        sum.add_multiple(&a, &(x * twice));
    } else if y == -x.clone() {
        sum.add_multiple(&b, &(second * twice));
    } else {
        sum.add_multiple(&a, &x);
        sum.add_multiple(&b, &second);
        return;
    }
    *partner = Rational::ZERO;
}

/// Multiples that are not those of one run as a sum: the first run, and what is left.
fn split(multiples: &Multiples) -> Option<[Multiples; 2]> {
    let start = multiples.iter().position(|&n| n != 0)?;
    let sign = multiples[start].signum();
    let is_of_run = |n: &&i32| n.signum() == sign;
    let length = multiples[start..].iter().take_while(is_of_run).count();
    let mut first = vec![0; multiples.len()];
    first[start..start + length].fill(sign);
    let rest: Multiples = multiples.iter().zip(&first).map(|(n, m)| n - m).collect();
    rest.iter().any(|&n| n != 0).then_some([first, rest])
}

/// Cosine and sine of n . q in those of runs.
fn turn(multiples: &Multiples, group: usize, members: &[Member]) -> [Polynomial<Atom>; 2] {
    if let Some([first, second]) = split(multiples) {
        let [c1, s1] = turn(&first, group, members);
        let [c2, s2] = turn(&second, group, members);
        let mut cosine = times(&c1, &c2);
        cosine.add_multiple(&times(&s1, &s2), &-Rational::ONE);
        let mut sine = times(&s1, &c2);
        sine.add_multiple(&times(&c1, &s2), &Rational::ONE);
        return [cosine, sine];
    }
    let Some(first) = multiples.iter().position(|&n| n != 0) else {
        return [Polynomial::number(Rational::ONE), Polynomial::zero()];
    };
    let last = multiples.iter().rposition(|&n| n != 0).unwrap_or(first);
    let run = Run { group, first, last };
    let is_negative = (multiples[first] < 0) != members[first].is_reversed;
    let sign = if is_negative { -1 } else { 1 };
    [
        Polynomial::variable(Atom::Cosine(run)),
        Polynomial::term(vec![(Atom::Sine(run), 1)], Rational::from(sign)),
    ]
}

fn times(a: &Polynomial<Atom>, b: &Polynomial<Atom>) -> Polynomial<Atom> {
    polynomial::times(a, b, &Atom::cosine)
}

/// X - X c^2 is X s^2.
fn with_squares_of_sines(polynomial: Polynomial<Atom>) -> Polynomial<Atom> {
    let squares: Vec<(Monomial<Atom>, Atom, Atom)> = polynomial
        .terms()
        .flat_map(|(monomial, _)| {
            let square = |&(atom, power): &(Atom, i32)| match atom {
                Atom::Cosine(run) if power >= 2 => Some((monomial.clone(), atom, Atom::Sine(run))),
                Atom::AngleCosine(angle) if power >= 2 => {
                    Some((monomial.clone(), atom, Atom::AngleSine(angle)))
                }
                _ => None,
            };
            monomial.iter().filter_map(square)
        })
        .collect();
    let mut shorter = polynomial;
    for (with_cosine, cosine, sine) in squares {
        let rest = product(&with_cosine, &[(cosine, -2)]);
        let (Some(a), Some(b)) = (
            shorter.coefficient(&rest),
            shorter.coefficient(&with_cosine),
        ) else {
            continue;
        };
        if *a == -b.clone() {
            let coefficient = shorter.remove(&rest).expect("it was found");
            shorter.remove(&with_cosine);
            shorter.add_term(product(&rest, &[(sine, 2)]), &coefficient);
        }
    }
    shorter
}
