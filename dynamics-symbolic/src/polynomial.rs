//! Polynomials with exact coefficients over any variables.

use crate::exact::Rational;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry as Slot;

/// A product of powers of variables, by ascending variable; no exponent is zero, some may be negative.
pub(crate) type Monomial<V> = Vec<(V, i32)>;

/// A sum of monomials with coefficients; none is zero.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Polynomial<V> {
    terms: BTreeMap<Monomial<V>, Rational>,
}

impl<V: Copy + Ord> Polynomial<V> {
    /// No terms.
    pub(crate) fn zero() -> Self {
        Polynomial {
            terms: BTreeMap::new(),
        }
    }

    /// A number.
    pub(crate) fn number(x: Rational) -> Self {
        Self::term(Monomial::new(), x)
    }

    /// A variable.
    pub(crate) fn variable(variable: V) -> Self {
        Self::term(vec![(variable, 1)], Rational::ONE)
    }

    /// One term.
    pub(crate) fn term(monomial: Monomial<V>, coefficient: Rational) -> Self {
        let mut sum = Self::zero();
        sum.add_term(monomial, &coefficient);
        sum
    }

    /// The number of terms.
    pub(crate) fn len(&self) -> usize {
        self.terms.len()
    }

    /// The terms by ascending monomial.
    pub(crate) fn terms(&self) -> impl Iterator<Item = (&Monomial<V>, &Rational)> {
        self.terms.iter()
    }

    /// The coefficient of a monomial, where it has one.
    pub(crate) fn coefficient(&self, monomial: &Monomial<V>) -> Option<&Rational> {
        self.terms.get(monomial)
    }

    /// Takes a term out.
    pub(crate) fn remove(&mut self, monomial: &Monomial<V>) -> Option<Rational> {
        self.terms.remove(monomial)
    }

    /// Adds a term.
    pub(crate) fn add_term(&mut self, monomial: Monomial<V>, coefficient: &Rational) {
        if coefficient.is_zero() {
            return;
        }
        match self.terms.entry(monomial) {
            Slot::Vacant(slot) => {
                slot.insert(coefficient.clone());
            }
            Slot::Occupied(mut slot) => {
                *slot.get_mut() += coefficient;
                if slot.get().is_zero() {
                    slot.remove();
                }
            }
        }
    }

    /// Adds a multiple of another one.
    pub(crate) fn add_multiple(&mut self, other: &Self, factor: &Rational) {
        for (monomial, coefficient) in &other.terms {
            self.add_term(monomial.clone(), &(coefficient * factor));
        }
    }
}

/// Adds a term without squares of sines: sin^2 = 1 - cos^2. `cosine` gives the cosine that belongs to a sine. Returns
/// how many terms it became.
pub(crate) fn add_reduced<V: Copy + Ord>(
    sum: &mut Polynomial<V>,
    monomial: Monomial<V>,
    coefficient: &Rational,
    cosine: &impl Fn(V) -> Option<V>,
) -> usize {
    let powers = monomial.iter().filter(|(_, power)| *power > 1);
    let mut squares = powers.filter_map(|(sine, _)| Some((*sine, cosine(*sine)?)));
    let Some((sine, cosine_of_sine)) = squares.next() else {
        sum.add_term(monomial, coefficient);
        return 1;
    };
    let rest = product(&monomial, &[(sine, -2)]);
    let with_cosine = product(&rest, &[(cosine_of_sine, 2)]);
    add_reduced(sum, with_cosine, &-coefficient.clone(), cosine)
        + add_reduced(sum, rest, coefficient, cosine)
}

/// The product of two polynomials without squares of sines.
pub(crate) fn times<V: Copy + Ord>(
    a: &Polynomial<V>,
    b: &Polynomial<V>,
    cosine: &impl Fn(V) -> Option<V>,
) -> Polynomial<V> {
    let mut sum = Polynomial::zero();
    for (left, x) in a.terms() {
        for (right, y) in b.terms() {
            add_reduced(&mut sum, product(left, right), &(x * y), cosine);
        }
    }
    sum
}

/// The product of two monomials.
pub(crate) fn product<V: Copy + Ord>(a: &[(V, i32)], b: &[(V, i32)]) -> Monomial<V> {
    let mut powers: Monomial<V> = Vec::with_capacity(a.len() + b.len());
    powers.extend(a);
    for &(variable, power) in b {
        match powers.binary_search_by_key(&variable, |(v, _)| *v) {
            Ok(place) => powers[place].1 += power,
            Err(place) => powers.insert(place, (variable, power)),
        }
    }
    powers.retain(|(_, power)| *power != 0);
    powers
}

/// The exponent of a variable in a monomial.
pub(crate) fn exponent<V: Copy + Ord>(monomial: &[(V, i32)], variable: V) -> i32 {
    let power = monomial.iter().find(|(v, _)| *v == variable);
    power.map_or(0, |(_, exponent)| *exponent)
}

/// One over a monomial.
pub(crate) fn inverse<V: Copy>(monomial: &[(V, i32)]) -> Monomial<V> {
    monomial.iter().map(|&(v, power)| (v, -power)).collect()
}
