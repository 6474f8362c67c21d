//! Pairs of numbers whose squares are known together.
//!
//! A vector (x, y) that is turned keeps its length, but each of its new components may be as long as it was
//! whole: by intervals alone, which know components, lengths grow with every turn. So they are kept beside them. With
//! |(a, b)| for the square root of a^2 + b^2, and by Cauchy's inequality
//!
//!   |a x + b y| <= |(a, b)| |(x, y)|,   |(a x + b y, b x - a y)| = |(a, b)| |(x, y)|,   |(a t, b t)| = |(a, b)| |t|.
//!
//! The same holds of errors: what (x, y) was wrong by is turned, and turned back, without growing.

use super::ranged::{Each, each, norm, plus, rounding, sum, times};
use crate::program::Operand;
use std::collections::BTreeMap;

/// The length of a pair, and that of its error, at most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Length {
    pub(super) size: f64,
    pub(super) error: Each,
}

impl Length {
    /// The length of the pair (a t, b t).
    fn scaled(self, t: Length) -> Self {
        Length {
            size: times(self.size, t.size),
            error: each(|k| {
                let computed = plus(t.size, t.error[k]);
                plus(times(self.size, t.error[k]), times(self.error[k], computed))
            }),
        }
    }

    /// With two numbers that were rounded by so much besides.
    fn with_roundings(self, a: Each, b: Each) -> Self {
        Length {
            error: sum(self.error, each(|k| norm(a[k], b[k]))),
            ..self
        }
    }

    /// The largest roundings of a number that is no longer than it.
    fn rounding(self) -> Each {
        rounding(self.error.map(|error| plus(self.size, error)))
    }
}

/// Two operands in the order of their names.
type Pair = (Operand, Operand);

fn pair<T: Ord>(a: T, b: T) -> (T, T) {
    if a < b { (a, b) } else { (b, a) }
}

/// a x + b y or a x - b y.
#[derive(Clone, Copy)]
pub(super) struct SumOfProducts {
    pub(super) first: (Operand, Operand),
    pub(super) second: (Operand, Operand),
    pub(super) is_difference: bool,
}

impl SumOfProducts {
    /// Both ways to read it as a product of pairs.
    pub(super) fn turns(self) -> [Turn; 2] {
        let ((a, x), (b, y)) = (self.first, self.second);
        let is_difference = self.is_difference;
        let turn = |coefficients, vector| Turn {
            coefficients,
            vector,
            is_difference,
        };
        [turn((a, b), (x, y)), turn((a, y), (x, b))]
    }
}

/// A sum of products as a component of a turned vector.
#[derive(Clone, Copy)]
pub(super) struct Turn {
    pub(super) coefficients: Pair,
    pub(super) vector: Pair,
    is_difference: bool,
}

impl Turn {
    /// The same for both components, whichever of the pairs turns the other one.
    fn key(self) -> (Pair, Pair) {
        let ((a, b), (x, y)) = (self.coefficients, self.vector);
        pair(pair(a, b), pair(x, y))
    }

    /// Whether a x + b y is read as b y + a x would be, and not as a y + b x.
    fn is_straight(self) -> bool {
        let ((a, b), (x, y)) = (self.coefficients, self.vector);
        (a < b) == (x < y)
    }
}

/// One component of a turned vector: the other one may follow.
struct Component {
    result: Operand,
    turn: Turn,
    rounding: Each,
}

/// The pairs whose lengths are known.
#[derive(Default)]
pub(super) struct Pairs {
    lengths: BTreeMap<Pair, Length>,
    /// With which operands there is a length.
    partners: BTreeMap<Operand, Vec<Operand>>,
    components: BTreeMap<(Pair, Pair), Vec<Component>>,
    products: BTreeMap<Pair, Operand>,
}

impl Pairs {
    /// The length of a pair, where it is known.
    pub(super) fn length(&self, a: Operand, b: Operand) -> Option<Length> {
        self.lengths.get(&pair(a, b)).copied()
    }

    /// Says the length of a pair.
    pub(super) fn set(&mut self, a: Operand, b: Operand, length: Length) {
        self.lengths.insert(pair(a, b), length);
        self.partners.entry(a).or_default().push(b);
        self.partners.entry(b).or_default().push(a);
    }

    /// Adds a product: it makes a pair with the product of its factor's partner and the same other factor. `rounded` is
    /// the largest rounding of the product.
    pub(super) fn product(
        &mut self,
        [a, b]: [Operand; 2],
        [size_a, size_b]: [Length; 2],
        result: Operand,
        rounded: Each,
    ) {
        for (a, t, size) in [(a, b, size_b), (b, a, size_a)] {
            let partners = self.partners.get(&a).cloned().unwrap_or_default();
            for partner in partners {
                let other = self.products.get(&pair(partner, t)).copied();
                let (Some(other), Some(length)) = (other, self.length(a, partner)) else {
                    continue;
                };
                let scaled = length.scaled(size);
                // The other product is no longer than the pair.
                let roundings = scaled.rounding();
                self.set(other, result, scaled.with_roundings(rounded, roundings));
            }
        }
        self.products.insert(pair(a, b), result);
    }

    /// Adds a sum of products: it makes a pair with the other component of the same turned vector. `length` is that of
    /// the turned vector, `rounded` the largest rounding of the sum and its products.
    pub(super) fn component(&mut self, result: Operand, turn: Turn, length: Length, rounded: Each) {
        let is_other = |other: &&Component| {
            let is_turned = other.turn.is_straight() != turn.is_straight();
            is_turned && other.turn.is_difference != turn.is_difference
        };
        let ((a, b), (x, y)) = turn.key();
        if a == b || x == y {
            return;
        }
        let components = self.components.entry(turn.key()).or_default();
        let other = components.iter().find(is_other);
        let pair = other.map(|other| (other.result, other.rounding));
        components.push(Component {
            result,
            turn,
            rounding: rounded,
        });
        if let Some((other, rounding)) = pair {
            self.set(other, result, length.with_roundings(rounding, rounded));
        }
    }
}

/// The length of a turned vector, and what the roundings of a component's two products come to: |a x| + |b y| is at
/// most the length too.
pub(super) fn turned(coefficients: Length, vector: Length) -> (Length, Each) {
    let turned = coefficients.scaled(vector);
    (turned, turned.rounding())
}
