//! Polynomials over named variables, to be read: the formulas of the base parameters.

use crate::exact::{Rational, negate_if};
use crate::formula::signed_sum;
use crate::operators::impl_operators;
use crate::polynomial::{self, times};
use core::cell::{Cell, RefCell};

/// A product of powers of variables, which are counted as they come.
type Monomial = polynomial::Monomial<usize>;

type Terms = polynomial::Polynomial<usize>;

/// A polynomial with more terms than that is no help to a reader, and is not worked out.
const MOST_TERMS: usize = 300;

/// The variables, and every polynomial that was made.
#[derive(Default)]
pub(super) struct Polynomials {
    names: RefCell<Vec<String>>,
    /// The sine that belongs to a cosine, sin^2 = 1 - cos^2: (sine, cosine).
    circles: RefCell<Vec<(usize, usize)>>,
    all: RefCell<Vec<Terms>>,
    overflow: Cell<bool>,
}

/// A handle of a polynomial.
#[derive(Clone, Copy)]
pub(super) struct Polynomial<'p> {
    arena: &'p Polynomials,
    index: usize,
}

impl Polynomials {
    /// Whether a polynomial had too many terms: none that was made of it counts then.
    pub(super) fn overflow(&self) -> bool {
        self.overflow.get()
    }

    pub(super) fn number(&self, x: i64) -> Polynomial<'_> {
        self.rational(Rational::from(x))
    }

    pub(super) fn rational(&self, x: Rational) -> Polynomial<'_> {
        self.push(Terms::number(x))
    }

    pub(super) fn variable(&self, name: String) -> Polynomial<'_> {
        let mut names = self.names.borrow_mut();
        names.push(name);
        self.push(Terms::variable(names.len() - 1))
    }

    /// Sine and cosine of one angle.
    pub(super) fn circle(&self, names: [String; 2]) -> (Polynomial<'_>, Polynomial<'_>) {
        let first = self.names.borrow().len();
        self.circles.borrow_mut().push((first, first + 1));
        let [sine, cosine] = names.map(|name| self.variable(name));
        (sine, cosine)
    }

    fn push(&self, mut terms: Terms) -> Polynomial<'_> {
        if terms.len() > MOST_TERMS {
            self.overflow.set(true);
            terms = Terms::zero();
        }
        let mut all = self.all.borrow_mut();
        all.push(terms);
        Polynomial {
            arena: self,
            index: all.len() - 1,
        }
    }
}

impl Polynomial<'_> {
    fn terms(self) -> Terms {
        self.arena.all.borrow()[self.index].clone()
    }

    pub(super) fn is_zero(self) -> bool {
        self.terms().len() == 0
    }

    /// The names of the variables in it.
    pub(super) fn variables(self) -> Vec<String> {
        let names = self.arena.names.borrow();
        let terms = self.terms();
        let variables = terms.terms().flat_map(|(monomial, _)| monomial);
        variables.map(|&(v, _)| names[v].clone()).collect()
    }

    /// The sum as text, short terms first: `J1zz + J2yy + a2^2 (m2 + m3)`.
    pub(super) fn text(self) -> String {
        let groups = self.groups();
        let terms = groups
            .iter()
            .map(|group| (group.members[0].1, self.group_text(group)));
        match &terms.collect::<Vec<_>>()[..] {
            [] => "0".to_owned(),
            terms => signed_sum(terms, [" + ", " - ", "-"]),
        }
    }

    /// Terms that differ in their last factor, the inertial parameter, alone.
    fn groups(self) -> Vec<Group> {
        let all = self.terms();
        let mut terms: Vec<(Monomial, Rational)> =
            all.terms().map(|(m, c)| (m.clone(), c.clone())).collect();
        terms.sort_by_key(|(monomial, _)| {
            let degree: i32 = monomial.iter().map(|&(_, power)| power).sum();
            (degree, monomial.last().copied(), monomial.clone())
        });
        let mut groups: Vec<Group> = Vec::new();
        for (mut common, coefficient) in terms {
            let last = common.pop();
            let is_negative = coefficient < Rational::ZERO;
            let size = negate_if(coefficient, is_negative);
            let same = |group: &&mut Group| group.common == common && group.size == size;
            let is_plain = common.is_empty() || last.is_none_or(|(_, power)| power > 1);
            match groups.iter_mut().find(same).filter(|_| !is_plain) {
                Some(group) => group.members.push((last, is_negative)),
                None => groups.push(Group {
                    common,
                    size,
                    members: vec![(last, is_negative)],
                }),
            }
        }
        groups
    }

    /// Without the sign of the first member.
    fn group_text(self, group: &Group) -> String {
        let names = self.arena.names.borrow();
        let factor = |&(variable, power): &(usize, i32)| match power {
            1 => names[variable].clone(),
            _ => format!("{}^{power}", names[variable]),
        };
        let mut factors: Vec<_> = group.common.iter().map(factor).collect();
        let is_number = factors.is_empty() && group.members[0].0.is_none();
        if !group.size.is_one() || is_number {
            factors.insert(0, group.size.to_string());
        }
        let (first, others) = group.members.split_first().expect("a group has a term");
        let mut sum: String = first.0.iter().map(factor).collect();
        for (member, is_negative) in others {
            let sign = if *is_negative == first.1 { "+" } else { "-" };
            let member: String = member.iter().map(factor).collect();
            sum = format!("{sum} {sign} {member}");
        }
        if !others.is_empty() {
            sum = format!("({sum})");
        }
        if !sum.is_empty() {
            factors.push(sum);
        }
        factors.join(" ")
    }
}

/// Terms with the same size and the same factors before the last one.
struct Group {
    common: Monomial,
    size: Rational,
    /// The last factors, and whether the term is negative.
    members: Vec<(Option<(usize, i32)>, bool)>,
}

impl_operators! {
    impl ['p] for Polynomial<'p>;
    Add add |a, b| {
        let mut terms = a.terms();
        terms.add_multiple(&b.terms(), &Rational::ONE);
        a.arena.push(terms)
    };
    Sub sub |a, b| a + -b;
    Neg neg |a| {
        let mut terms = Terms::zero();
        terms.add_multiple(&a.terms(), &-Rational::ONE);
        a.arena.push(terms)
    };
    Mul mul |a, b| {
        let circles = a.arena.circles.borrow();
        let cosine = |variable| {
            let circle = circles.iter().find(|(sine, _)| *sine == variable);
            circle.map(|(_, cosine)| *cosine)
        };
        a.arena.push(times(&a.terms(), &b.terms(), &cosine))
    };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_written_as_a_person_would() {
        let all = Polynomials::default();
        let [a, m, j] = ["a2", "m3", "J2yy"].map(|name| all.variable(name.to_owned()));
        let sum = a * a * m - all.number(2) * a * m + j;
        assert_eq!(sum.text(), "J2yy - 2 a2 m3 + a2^2 m3");
        let other = all.variable("m4".to_owned());
        assert_eq!(
            (sum - a * a * other).text(),
            "J2yy - 2 a2 m3 + a2^2 (m3 - m4)"
        );
        assert_eq!((-j).text(), "-J2yy");
        assert_eq!((j - j).text(), "0");
    }

    #[test]
    fn squares_of_sine_and_cosine_cancel() {
        let all = Polynomials::default();
        let (s, c) = all.circle(["sa1".to_owned(), "ca1".to_owned()]);
        let m = all.variable("m1".to_owned());
        assert_eq!((s * s * m + c * c * m).text(), "m1");
        let fourth = s * s * s * s - all.number(1);
        assert_eq!(fourth.text(), "-2 ca1^2 + ca1^4");
    }

    #[test]
    fn a_polynomial_that_is_too_long_is_given_up() {
        let all = Polynomials::default();
        let mut sum = all.number(0);
        for i in 0..=MOST_TERMS {
            assert!(!all.overflow());
            sum = sum + all.variable(format!("x{i}"));
        }
        assert!(all.overflow() && sum.is_zero());
    }
}
