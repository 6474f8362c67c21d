//! sin^2 + cos^2 = 1.

use super::atom::Atom;
use crate::exact::Rational;
use crate::polynomial::{Monomial, Polynomial, product};

/// Adds a term with squares of sines written by cosines, sin^2 = 1 - cos^2. Returns how many terms it became.
pub(super) fn add_reduced(
    sum: &mut Polynomial<Atom>,
    monomial: Monomial<Atom>,
    coefficient: &Rational,
) -> usize {
    let square = monomial.iter().find_map(|&(atom, power)| {
        let cosine = match atom {
            Atom::Sine(run) => Atom::Cosine(run),
            Atom::AngleSine(index) => Atom::AngleCosine(index),
            _ => return None,
        };
        (power > 1).then_some((atom, cosine))
    });
    let Some((sine, cosine)) = square else {
        sum.add_term(monomial, coefficient);
        return 1;
    };
    let rest = product(&monomial, &[(sine, -2)]);
    let with_cosine = product(&rest, &[(cosine, 2)]);
    add_reduced(sum, with_cosine, &-coefficient.clone()) + add_reduced(sum, rest, coefficient)
}
