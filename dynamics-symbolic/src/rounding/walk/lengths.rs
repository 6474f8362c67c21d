//! Lengths of vectors whose components are computed one by one.
//!
//! A vector that is turned keeps its length, but each of its new components may be as long as it was whole: by
//! intervals alone, which know components, lengths grow with every turn. So the lengths of pairs and of triples are
//! bounded too, from the components that were computed last backwards. With |S| for the square root of the sum of
//! squares, and by the inequalities of Cauchy and of the triangle
//!
//!   |a x + b y| <= |(a, b)| |(x, y)|,
//!   |(a x + b y, b x - a y, z)| <= max(1, |(a, b)|) |(x, y, z)|,
//!   |(a t, b t, c t)| = |t| |(a, b, c)|,   |S + T| <= |S| + |T|.
//!
//! The same holds of errors: the error of (x, y) is turned without growing.

use super::{Node, Operation, Walk};
use crate::rounding::ranged::{Each, each, norm, plus, rounding, sum, times};

/// The length of a vector, and that of its error, at most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Length {
    pub(super) size: f64,
    pub(super) error: Each,
}

impl Length {
    /// No length at all.
    const ZERO: Self = Length {
        size: 0.0,
        error: [0.0; 2],
    };

    /// Both bounds hold.
    pub(super) fn and(self, other: Self) -> Self {
        Length {
            size: self.size.min(other.size),
            error: each(|k| self.error[k].min(other.error[k])),
        }
    }

    /// The length of the vector that has the components of both.
    fn beside(self, other: Self) -> Self {
        Length {
            size: norm(self.size, other.size),
            error: each(|k| norm(self.error[k], other.error[k])),
        }
    }

    /// The length of the vector times t, or turned and stretched by a pair of length t.
    pub(super) fn scaled(self, t: Self) -> Self {
        Length {
            size: times(self.size, t.size),
            error: each(|k| {
                let computed = plus(t.size, t.error[k]);
                plus(times(self.size, t.error[k]), times(self.error[k], computed))
            }),
        }
    }

    /// The length of a sum.
    fn plus(self, other: Self) -> Self {
        Length {
            size: plus(self.size, other.size),
            error: sum(self.error, other.error),
        }
    }

    /// With components that were rounded besides.
    fn rounded(self, roundings: impl IntoIterator<Item = Each>) -> Self {
        let all = roundings.into_iter();
        let all = all.fold([0.0; 2], |all, one| each(|k| norm(all[k], one[k])));
        Length {
            error: sum(self.error, all),
            ..self
        }
    }

    /// The largest lengths of the computed vector.
    pub(super) fn computed(self) -> Each {
        self.error.map(|error| plus(self.size, error))
    }
}

/// One, two or three nodes in order.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) struct Vector([Node; 3]);

impl Vector {
    /// `None` where there are more than three nodes, or one of them is there twice.
    pub(super) fn new(nodes: impl IntoIterator<Item = Node>) -> Option<Self> {
        let mut vector = [Node::NONE; 3];
        let mut count = 0;
        for node in nodes {
            *vector.get_mut(count)? = node;
            count += 1;
        }
        vector.sort_unstable();
        let is_twice = |k: usize| k + 1 < count && vector[k] == vector[k + 1];
        (!is_twice(0) && !is_twice(1)).then_some(Vector(vector))
    }

    fn nodes(&self) -> impl DoubleEndedIterator<Item = Node> + Clone {
        self.0.into_iter().filter(|node| *node != Node::NONE)
    }

    /// The node that was computed last.
    fn last(&self) -> Node {
        self.nodes().next_back().expect("not empty")
    }

    /// The same with other nodes in place of some.
    fn with(&self, gone: &[Node], new: &[Node]) -> Option<Self> {
        let kept = self.nodes().filter(|node| !gone.contains(node));
        Vector::new(kept.chain(new.iter().copied()))
    }
}

impl Walk {
    /// The length of a vector.
    pub(super) fn length(&mut self, vector: Vector) -> Length {
        if let Some(known) = self.known_length(vector) {
            return known;
        }
        let mut length = self.apart(vector);
        let others = self.deeper(|walk| {
            [
                walk.turned_back(vector),
                walk.split_sums(vector),
                walk.common_factor(vector),
            ]
        });
        for other in others.into_iter().flatten().flatten() {
            length = length.and(other);
        }
        self.keep_length(vector, length);
        length
    }

    pub(super) fn length_of(&mut self, nodes: impl IntoIterator<Item = Node>) -> Option<Length> {
        Vector::new(nodes).map(|vector| self.length(vector))
    }

    /// From parts whose lengths are known.
    fn apart(&mut self, vector: Vector) -> Length {
        let single = |walk: &Self, node: Node| {
            let value = walk.value(node);
            Length {
                size: value.range.size(),
                error: value.error,
            }
        };
        let each = vector.nodes();
        let mut length = each
            .clone()
            .map(|node| single(self, node))
            .fold(Length::ZERO, Length::beside);
        if each.clone().count() == 3 {
            for node in each {
                let pair = vector.with(&[node], &[]).expect("two of three");
                let pair = self.length(pair).beside(single(self, node));
                length = length.and(pair);
            }
        }
        length
    }

    /// From the vector before its last component was computed by a turn.
    fn turned_back(&mut self, vector: Vector) -> Option<Length> {
        let last = vector.last();
        let turn = self.turn(last)?;
        let partner = vector.nodes().find(|node| *node == turn.partner);
        let gone = [last, turn.partner];
        let before = vector.with(&gone, &turn.vector)?;
        let is_alone = vector.nodes().all(|node| gone.contains(&node));
        let mut coefficients = self.length_of(turn.coefficients)?;
        if !is_alone {
            coefficients.size = coefficients.size.max(1.0);
        }
        // The roundings of a component's products: |a x| + |b y| is at most |(a, b)| |(x, y)|.
        let turned = self.length_of(turn.vector)?.scaled(coefficients);
        let products = rounding(turned.computed());
        let whole = self.length(before).scaled(coefficients);
        let roundings = [Some(last), partner].into_iter().flatten();
        let roundings: Vec<_> = roundings
            .map(|node| sum(products, rounding(self.value(node).computed())))
            .collect();
        Some(whole.rounded(roundings))
    }

    /// By the inequality of the triangle: of each component that is a sum what was computed last, and the rest.
    fn split_sums(&mut self, vector: Vector) -> Option<Length> {
        let is_single = vector.nodes().count() == 1;
        if is_single || self.terms(vector.last()).is_none() {
            return None;
        }
        let (mut lasts, mut rests, mut roundings) = (Vec::new(), Vec::new(), Vec::new());
        for node in vector.nodes() {
            match self.terms(node) {
                Some((a, b)) => {
                    lasts.push(a.max(b));
                    rests.push(a.min(b));
                    roundings.push(rounding(self.value(node).computed()));
                }
                None => lasts.push(node),
            }
        }
        let (lasts, rests) = (self.length_of(lasts)?, self.length_of(rests)?);
        Some(lasts.plus(rests).rounded(roundings))
    }

    /// The terms of a sum that is no turned component.
    fn terms(&self, node: Node) -> Option<(Node, Node)> {
        if self.turn(node).is_some() {
            return None;
        }
        match self.operation(node) {
            Operation::Add(a, b) | Operation::Sub(a, b) => Some((a, b)),
            _ => None,
        }
    }

    /// A factor that all components have.
    fn common_factor(&mut self, vector: Vector) -> Option<Length> {
        let is_single = vector.nodes().count() == 1;
        let Operation::Mul(a, b) = self.operation(vector.last()) else {
            return None;
        };
        if is_single {
            return None;
        }
        let mut best: Option<Length> = None;
        for factor in [a, b] {
            let other = |node: Node| match self.operation(node) {
                Operation::Mul(x, y) if x == factor => Some(y),
                Operation::Mul(x, y) if y == factor => Some(x),
                _ => None,
            };
            let others: Option<Vec<_>> = vector.nodes().map(other).collect();
            let Some(others) = others.and_then(Vector::new) else {
                continue;
            };
            let factor = self.length_of([factor])?;
            let roundings: Vec<_> = vector
                .nodes()
                .map(|node| rounding(self.value(node).computed()))
                .collect();
            let length = self.length(others).scaled(factor).rounded(roundings);
            best = Some(best.map_or(length, |best| best.and(length)));
        }
        best
    }
}
