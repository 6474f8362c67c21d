//! Common factors: l1^2 (m1 + m2) for m1 l1^2 + m2 l1^2.

use super::atom::Atom;
use super::expression::{Base, Expression, Factor, Number, Term};
use super::multiply_out::Atoms;
use crate::exact::Rational;
use crate::polynomial::{Monomial, Polynomial, exponent, inverse, product};
use crate::program::{Constant, ConstantId, ConstantPool};
use crate::robot::Symbol;
use std::collections::BTreeMap;

/// A term of a polynomial whose constants have become one number.
#[derive(Clone)]
struct Single {
    is_negative: bool,
    number: Number,
    monomial: Monomial<Atom>,
}

/// A polynomial as a sum: what is multiplied by the same velocities and accelerations together, in it
/// what is multiplied by the same sines and positions, in that what differs in one parameter.
pub(super) fn collected(atoms: &Atoms, polynomial: &Polynomial<Atom>) -> Expression {
    let mut by_motion: BTreeMap<Key, BTreeMap<Key, Vec<Single>>> = BTreeMap::new();
    for single in numbered(atoms, polynomial) {
        let [parameters, rest] = parted(&single.monomial, Atom::is_parameter);
        let [motion, position] = parted(&rest, Atom::is_motion);
        let same_motion = by_motion.entry(Key::new(&motion)).or_default();
        let same_position = same_motion.entry(Key::new(&position)).or_default();
        same_position.push(Single {
            monomial: parameters,
            ..single
        });
    }
    let sum = by_motion.into_iter().flat_map(|(motion, by_position)| {
        let motion = motion.monomial();
        let mut terms: Vec<Term> = by_position.into_iter().flat_map(with_position).collect();
        if !motion.is_empty() {
            if terms.len() > 1 {
                terms = vec![in_parentheses(terms)];
            }
            terms = terms.into_iter().map(|term| times(term, &motion)).collect();
        }
        terms
    });
    Expression(sum.collect())
}

/// The factors that some atoms are, and the others.
fn parted(monomial: &Monomial<Atom>, is_first: impl Fn(Atom) -> bool) -> [Monomial<Atom>; 2] {
    let (first, others) = monomial.iter().partition(|(atom, _)| is_first(*atom));
    [first, others]
}

/// The terms that are multiplied by the same sines and positions.
fn with_position((position, sum): (Key, Vec<Single>)) -> Vec<Term> {
    let position = position.monomial();
    if position.is_empty() {
        buckets(sum)
    } else {
        vec![times(factored(sum), &position)]
    }
}

/// A monomial in the order of sums: x^2 before x y, and that before y^2.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Key(Monomial<Atom>);

impl Key {
    fn new(monomial: &Monomial<Atom>) -> Self {
        Key(inverse(monomial))
    }

    fn monomial(&self) -> Monomial<Atom> {
        inverse(&self.0)
    }
}

/// A sum as a factor, with its sign and its number in front where all terms have the same.
fn in_parentheses(mut terms: Vec<Term>) -> Term {
    let is_negative = terms.iter().all(|term| term.is_negative);
    let first = terms[0].number.clone();
    let is_multiple = terms.iter().all(|term| term.number == first);
    for term in &mut terms {
        term.is_negative ^= is_negative;
        if is_multiple {
            term.number = Number::ONE;
        }
    }
    let number = if is_multiple { first } else { Number::ONE };
    Term::new(is_negative, number, vec![Factor::sum(Expression(terms))])
}

/// A sum of terms as one term: what all have in common in front of the rest.
fn factored(mut sum: Vec<Single>) -> Term {
    let common = common_factor(&sum);
    let divisor = inverse(&common);
    for single in &mut sum {
        single.monomial = product(&single.monomial, &divisor);
    }
    let mut terms = buckets(sum);
    if let [_] = terms.as_slice() {
        return times(terms.remove(0), &common);
    }
    in_front(&common, in_parentheses(terms))
}

/// The powers that all terms have.
fn common_factor(sum: &[Single]) -> Monomial<Atom> {
    let mut common = sum[0].monomial.clone();
    for single in sum {
        for (atom, power) in &mut common {
            *power = (*power).min(exponent(&single.monomial, *atom)).max(0);
        }
    }
    common.retain(|(_, power)| *power > 0);
    common
}

/// Terms that differ in one parameter together, as long as there are any.
fn buckets(mut sum: Vec<Single>) -> Vec<Term> {
    let mut terms = Vec::new();
    while let Some(first) = sum.first() {
        let contexts = contexts(first).filter(|(_, context)| !context.is_empty());
        let counted = contexts.map(|(_, context)| {
            let is_member = |single: &&Single| member(single, &context).is_some();
            (sum.iter().filter(is_member).count(), context)
        });
        let largest = counted.reduce(|best, next| if next.0 > best.0 { next } else { best });
        let Some((2.., context)) = largest else {
            let single = sum.remove(0);
            let number = Term::new(single.is_negative, single.number, Vec::new());
            terms.push(times(number, &single.monomial));
            continue;
        };
        let is_member = |single: &Single| member(single, &context).is_some();
        let (members, others): (Vec<Single>, Vec<Single>) = sum.into_iter().partition(is_member);
        sum = others;
        terms.push(together(&members, &context));
    }
    terms
}

/// The rest of a term without one of its parameters, for each of them that is not a power.
fn contexts(single: &Single) -> impl Iterator<Item = (Atom, Monomial<Atom>)> {
    let plain = single.monomial.iter().filter(|(_, power)| *power == 1);
    plain.map(|&(atom, _)| (atom, product(&single.monomial, &[(atom, -1)])))
}

/// The factor of a term beside the context: a parameter, or nothing but its number.
fn member(single: &Single, context: &Monomial<Atom>) -> Option<Option<Atom>> {
    if single.monomial == *context {
        return Some(None);
    }
    contexts(single).find_map(|(atom, rest)| (rest == *context).then_some(Some(atom)))
}

/// Members of one context as one term: the context in front of their sum.
fn together(members: &[Single], context: &Monomial<Atom>) -> Term {
    let term = |single: &Single| {
        let factor = member(single, context).flatten().map(Factor::atom);
        let number = single.number.clone();
        Term::new(single.is_negative, number, factor.into_iter().collect())
    };
    in_front(context, in_parentheses(members.iter().map(term).collect()))
}

/// A term times a monomial, which is written behind it.
fn times(mut term: Term, monomial: &Monomial<Atom>) -> Term {
    let (factors, divisors) = powers(monomial);
    term.factors.extend(factors);
    term.divisors.extend(divisors);
    term
}

/// A term times a monomial, which is written in front of it.
fn in_front(monomial: &Monomial<Atom>, mut term: Term) -> Term {
    let (factors, divisors) = powers(monomial);
    term.factors = [factors, term.factors].concat();
    term.divisors.extend(divisors);
    term
}

fn powers(monomial: &Monomial<Atom>) -> (Vec<Factor>, Vec<Factor>) {
    let factor = |&(atom, power): &(Atom, i32)| Factor {
        base: Base::Atom(atom),
        exponent: power.unsigned_abs(),
    };
    let (above, below): (Vec<_>, Vec<_>) = monomial.iter().partition(|(_, power)| *power > 0);
    let factors = |powers: Vec<_>| powers.into_iter().map(factor).collect();
    (factors(above), factors(below))
}

/// The terms of a polynomial, pi and constant angles made part of the number before the rest.
fn numbered(atoms: &Atoms, polynomial: &Polynomial<Atom>) -> Vec<Single> {
    let mut by_rest: BTreeMap<Monomial<Atom>, Polynomial<Atom>> = BTreeMap::new();
    for (monomial, coefficient) in polynomial.terms() {
        let [constant, rest] = parted(monomial, |atom| is_constant(atoms, atom));
        let sum = by_rest.entry(rest).or_insert_with(Polynomial::zero);
        sum.add_term(constant, coefficient);
    }
    let numbers = rounded(atoms, by_rest.values());
    let terms = by_rest.into_keys().zip(numbers);
    let singles = terms.map(|(monomial, (is_negative, number))| Single {
        is_negative,
        number,
        monomial,
    });
    // Constants may cancel in a way that only their digits show.
    let is_zero = |single: &Single| single.number == Number::Rounded(0.0);
    singles.filter(|single| !is_zero(single)).collect()
}

fn is_constant(atoms: &Atoms, atom: Atom) -> bool {
    match atom {
        Atom::Pi => true,
        Atom::AngleCosine(i) | Atom::AngleSine(i) => atoms.angles[i].is_number(),
        Atom::Divisor(i) => {
            let mut factors = atoms.divisors[i].terms().flat_map(|(monomial, _)| monomial);
            factors.all(|(atom, _)| is_constant(atoms, *atom))
        }
        _ => false,
    }
}

/// Constants as numbers with their signs: exactly where they are rational.
fn rounded<'a>(
    atoms: &Atoms,
    constants: impl Iterator<Item = &'a Polynomial<Atom>>,
) -> Vec<(bool, Number)> {
    let mut pool = Pool {
        atoms,
        constants: ConstantPool::default(),
        factors: BTreeMap::new(),
    };
    let exact = constants.map(|constant| match as_rational(constant) {
        Some(x) => Ok(x.clone()),
        None => Err(pool.sum(constant)),
    });
    let constants: Vec<Result<_, _>> = exact.collect();
    let inexact = constants.iter().filter_map(|x| x.as_ref().err().copied());
    let sums: Vec<ConstantId> = inexact.collect();
    let values = pool.constants.round(|id| sums.binary_search(&id).is_ok());
    let number = |constant: Result<Rational, ConstantId>| match constant {
        Ok(x) if x < Rational::ZERO => (true, Number::Exact(-x)),
        Ok(x) => (false, Number::Exact(x)),
        Err(sum) => {
            let value = values[sum.index()];
            (value < 0.0, Number::Rounded(value.abs()))
        }
    };
    constants.into_iter().map(number).collect()
}

fn as_rational(constant: &Polynomial<Atom>) -> Option<&Rational> {
    let rational = constant.coefficient(&Monomial::new());
    rational.filter(|_| constant.len() == 1)
}

/// Constants of one polynomial, in which pi and the sines of constant angles, which take long to round, stand once.
struct Pool<'a> {
    atoms: &'a Atoms,
    constants: ConstantPool,
    factors: BTreeMap<Atom, ConstantId>,
}

impl Pool<'_> {
    fn sum(&mut self, constant: &Polynomial<Atom>) -> ConstantId {
        let mut sum = self.constants.push(Constant::Rational(Rational::ZERO));
        for (monomial, coefficient) in constant.terms() {
            let mut product = self.constants.push(Constant::Rational(coefficient.clone()));
            for &(atom, power) in monomial {
                let factor = self.factor(atom);
                let by_factor = if power > 0 {
                    Constant::Mul
                } else {
                    Constant::Div
                };
                for _ in 0..power.unsigned_abs() {
                    product = self.constants.push(by_factor(product, factor));
                }
            }
            sum = self.constants.push(Constant::Add(sum, product));
        }
        sum
    }

    fn factor(&mut self, atom: Atom) -> ConstantId {
        if let Some(known) = self.factors.get(&atom) {
            return *known;
        }
        let atoms = self.atoms;
        let symbol = match atom {
            Atom::Divisor(i) => return self.sum(&atoms.divisors[i]),
            Atom::AngleCosine(i) => Symbol::AngleCosine(atoms.angles[i].clone()),
            Atom::AngleSine(i) => Symbol::AngleSine(atoms.angles[i].clone()),
            _ => Symbol::Pi,
        };
        let factor = self.constants.push(Constant::Symbol(symbol));
        self.factors.insert(atom, factor);
        factor
    }
}
