//! A program multiplied out: each output as a polynomial, exactly.

use super::atom::Atom;
use super::groups::Groups;
use crate::exact::{MOST_BITS, Rational, bit_length, negate_if};
use crate::polynomial::{Monomial, Polynomial, add_reduced, inverse, product};
use crate::program::{Arithmetic, Program};
use crate::robot::{Symbol, Value};
use std::rc::Rc;

/// How far a program is multiplied out.
#[derive(Clone, Copy, Debug)]
pub struct Budget {
    /// The largest number of terms of a value.
    pub terms: usize,
    /// The number of terms that products of terms become, for all values together. A term with a long number counts
    /// once more for every 256 bits of it.
    pub products: usize,
}

/// Bits of a number that take about as long to compute as a term does otherwise.
const BITS_OF_ONE_MORE: usize = 256;

impl Budget {
    /// The budget of a formula that nobody requested.
    pub const UNASKED: Budget = Budget {
        terms: 300,
        products: 5_000,
    };
}

/// Why there is no formula: it has so many terms, or more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooLong {
    /// The number of terms.
    pub terms: usize,
    /// Whether there are more.
    pub or_more: bool,
}

impl core::fmt::Display for TooLong {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let more = if self.or_more { "more than " } else { "" };
        write!(
            f,
            "too long: {more}{} terms; `robot-dynamics show`",
            self.terms
        )
    }
}

/// The meanings of the atoms that are numbered as they come.
#[derive(Default)]
pub(super) struct Atoms {
    /// Constant and parametric angles.
    pub(super) angles: Vec<Value>,
    /// Sums that something is divided by.
    pub(super) divisors: Vec<Polynomial<Atom>>,
}

/// The outputs of a program as polynomials, or how long those are that are beyond the budget.
pub(super) fn multiplied_out(
    groups: &Groups,
    program: &Program,
    budget: Budget,
) -> (Atoms, Vec<Result<Polynomial<Atom>, TooLong>>) {
    let mut expansion = Expansion {
        groups,
        atoms: Atoms::default(),
        budget,
    };
    let values = program.evaluate(&mut expansion);
    let given_up = Err(TooLong {
        terms: budget.terms,
        or_more: true,
    });
    let value = |value: Number| value.map_or(given_up.clone(), |p| Ok(Rc::unwrap_or_clone(p)));
    (expansion.atoms, values.into_iter().map(value).collect())
}

/// The arithmetic of polynomials. `None` is one that is too long.
struct Expansion<'g> {
    groups: &'g Groups,
    atoms: Atoms,
    budget: Budget,
}

type Number = Option<Rc<Polynomial<Atom>>>;

impl Expansion<'_> {
    /// The index of an angle and whether the angle or its opposite has it.
    fn angle(&mut self, angle: &Value) -> (usize, bool) {
        let opposite = -angle.clone();
        let known = |known: &Value| known == angle || *known == opposite;
        let position = self.atoms.angles.iter().position(known);
        let index = position.unwrap_or_else(|| {
            self.atoms.angles.push(angle.clone());
            self.atoms.angles.len() - 1
        });
        (index, self.atoms.angles[index] != *angle)
    }

    /// The value, unless it has too many terms or a number that is too long.
    fn limited(&self, value: Polynomial<Atom>) -> Number {
        let is_short = |(_, x): (_, &Rational)| bit_length(x) <= MOST_BITS;
        let is_good = value.len() <= self.budget.terms && value.terms().all(is_short);
        is_good.then(|| Rc::new(value))
    }

    fn product(&mut self, a: &Polynomial<Atom>, b: &Polynomial<Atom>) -> Number {
        if a.len() * b.len() > self.budget.products {
            return None;
        }
        let mut sum = Polynomial::zero();
        for (left, x) in a.terms() {
            for (right, y) in b.terms() {
                let number = x * y;
                let size = 1 + bit_length(&number) / BITS_OF_ONE_MORE;
                let terms = add_reduced(&mut sum, product(left, right), &number, &Atom::cosine);
                self.budget.products = self.budget.products.checked_sub(terms * size)?;
            }
        }
        self.limited(sum)
    }
}

impl Arithmetic for Expansion<'_> {
    type Number = Number;

    fn rational(&mut self, x: &Rational) -> Number {
        Some(Rc::new(Polynomial::number(x.clone())))
    }

    fn symbol(&mut self, symbol: &Symbol) -> Number {
        let atom = match symbol {
            Symbol::Pi => Atom::Pi,
            Symbol::Field(i) => Atom::Field(*i),
            Symbol::AngleCosine(angle) => Atom::AngleCosine(self.angle(angle).0),
            Symbol::AngleSine(angle) => {
                let (index, is_opposite) = self.angle(angle);
                let sign = negate_if(Rational::ONE, is_opposite);
                let sine = vec![(Atom::AngleSine(index), 1)];
                return Some(Rc::new(Polynomial::term(sine, sign)));
            }
            Symbol::Sine(i) => Atom::Sine(self.groups.run_of(*i)?),
            Symbol::Cosine(i) => Atom::Cosine(self.groups.run_of(*i)?),
            Symbol::Position(i) => Atom::Position(*i),
            Symbol::Velocity(i) => Atom::Velocity(*i),
            Symbol::Acceleration(i) => Atom::Acceleration(*i),
            Symbol::Force(i) => Atom::Force(*i),
            Symbol::VelocitySign(i) => Atom::VelocitySign(*i),
            Symbol::Stribeck(i) => Atom::Stribeck(*i),
            Symbol::Entry(argument, i) => Atom::Entry(*argument, *i),
        };
        Some(Rc::new(Polynomial::variable(atom)))
    }

    fn neg(&mut self, a: Number) -> Number {
        let mut negative = Polynomial::zero();
        negative.add_multiple(&*a?, &-Rational::ONE);
        Some(Rc::new(negative))
    }

    fn add(&mut self, a: Number, b: Number) -> Number {
        let (a, b) = (a?, b?);
        let (long, short) = if a.len() < b.len() { (b, a) } else { (a, b) };
        let mut sum = Rc::unwrap_or_clone(long);
        sum.add_multiple(&short, &Rational::ONE);
        self.limited(sum)
    }

    fn mul(&mut self, a: Number, b: Number) -> Number {
        self.product(&*a?, &*b?)
    }

    /// By a single term exactly; by a sum as a power of a variable that stands for the sum.
    fn div(&mut self, a: Number, b: Number) -> Number {
        let (a, b) = (a?, b?);
        let mut terms = b.terms();
        let factor = match (terms.next(), terms.next()) {
            (None, _) => return None,
            // A negative power of a sine would not be reduced beside a positive one.
            (Some((monomial, coefficient)), None) if !has_sine(monomial) => {
                let inverse = inverse(monomial);
                Polynomial::term(inverse, Rational::ONE / coefficient)
            }
            _ => {
                let known = self.atoms.divisors.iter().position(|known| *known == *b);
                let index = known.unwrap_or_else(|| {
                    self.atoms.divisors.push((*b).clone());
                    self.atoms.divisors.len() - 1
                });
                Polynomial::term(vec![(Atom::Divisor(index), -1)], Rational::ONE)
            }
        };
        self.product(&a, &factor)
    }
}

fn has_sine(monomial: &Monomial<Atom>) -> bool {
    monomial.iter().any(|(atom, _)| atom.cosine().is_some())
}
