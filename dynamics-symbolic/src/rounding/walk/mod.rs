//! A walk over a program in intervals, node by node.

mod lengths;

use super::ranged::{Each, Ranged, each, norm, plus, rounding, sum};
use lengths::{Length, Vector};
use std::collections::HashMap;

/// How far lengths are followed back.
const DEEPEST: usize = 200;

/// A number that is given or computed.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(super) struct Node(u32);

impl Node {
    /// Behind all nodes.
    const NONE: Self = Node(u32::MAX);

    fn index(self) -> usize {
        self.0 as usize
    }
}

/// Where a node is from.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Operation {
    Given,
    Add(Node, Node),
    Sub(Node, Node),
    Mul(Node, Node),
    Div(Node, Node),
}

/// A component of a turned vector: a x + b y, beside the other one, b x - a y.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Turn {
    coefficients: [Node; 2],
    vector: [Node; 2],
    partner: Node,
}

/// Two pairs, in order: one that is turned, and the one that turns it.
type Pairs = [[Node; 2]; 2];

/// A sum of products a x + b y that may be a component of a turned vector.
#[derive(Clone, Copy)]
struct Component {
    node: Node,
    /// Whether it is read as a x + b y with the pairs in order, and not as a y + b x.
    is_straight: bool,
    is_difference: bool,
}

/// Nodes with their values and the lengths that are known.
#[derive(Default)]
pub(super) struct Walk {
    operations: Vec<Operation>,
    values: Vec<Ranged>,
    turns: Vec<Option<Turn>>,
    components: HashMap<Pairs, Vec<Component>>,
    lengths: HashMap<Vector, Length>,
    /// How many lengths wait for those from which they follow.
    depth: usize,
}

impl Walk {
    fn operation(&self, node: Node) -> Operation {
        self.operations[node.index()]
    }

    pub(super) fn value(&self, node: Node) -> Ranged {
        self.values[node.index()]
    }

    fn turn(&self, node: Node) -> Option<Turn> {
        self.turns[node.index()]
    }

    fn known_length(&self, vector: Vector) -> Option<Length> {
        self.lengths.get(&vector).copied()
    }

    fn keep_length(&mut self, vector: Vector, length: Length) {
        self.lengths.insert(vector, length);
    }

    /// A sine and its cosine, a vector of length 1.
    pub(super) fn circle(&mut self, pair: [Node; 2]) {
        let [s, c] = pair.map(|node| self.value(node).error);
        let error = each(|k| norm(s[k], c[k]));
        let vector = Vector::new(pair).expect("two nodes");
        self.keep_length(vector, Length { size: 1.0, error });
    }

    pub(super) fn given(&mut self, value: Ranged) -> Node {
        self.push(Operation::Given, value)
    }

    /// Calls it if not too many wait already: chains of sums are as long as programs.
    fn deeper<T>(&mut self, of: impl FnOnce(&mut Self) -> T) -> Option<T> {
        if self.depth == DEEPEST {
            return None;
        }
        self.depth += 1;
        let found = of(self);
        self.depth -= 1;
        Some(found)
    }

    fn push(&mut self, operation: Operation, value: Ranged) -> Node {
        let node = Node(self.values.len() as u32);
        self.operations.push(operation);
        self.values.push(value);
        self.turns.push(None);
        node
    }

    /// The result of an operation.
    pub(super) fn compute(&mut self, operation: Operation) -> Node {
        let value = match operation {
            Operation::Given => unreachable!("computed"),
            Operation::Add(a, b) => self.value(a) + self.value(b),
            Operation::Sub(a, b) => self.value(a) + -self.value(b),
            Operation::Mul(a, b) => self.value(a) * self.value(b),
            Operation::Div(a, b) => self.value(a) / self.value(b),
        };
        let node = self.push(operation, value);
        match operation {
            Operation::Add(a, b) => self.sum(node, [a, b], false),
            Operation::Sub(a, b) => self.sum(node, [a, b], true),
            _ => (),
        }
        node
    }

    /// Tightens a sum of products, which may be a component of a turned vector.
    fn sum(&mut self, node: Node, [first, second]: [Node; 2], is_difference: bool) {
        let (Operation::Mul(a, x), Operation::Mul(b, y)) =
            (self.operation(first), self.operation(second))
        else {
            return;
        };
        let mut value = self.value(node);
        for [coefficients, vector] in [[[a, b], [x, y]], [[a, y], [x, b]]] {
            self.component(node, [coefficients, vector], is_difference);
            let [Some(coefficients), Some(vector)] =
                [coefficients, vector].map(|pair| self.length_of(pair))
            else {
                continue;
            };
            let turned = vector.scaled(coefficients);
            value.tighten(turned, rounding(turned.computed()));
        }
        self.values[node.index()] = value;
        let vector = Vector::new([node]).expect("one");
        let length = self.length(vector);
        self.values[node.index()].range = value.range.within(length.size);
        let error = each(|k| value.error[k].min(length.error[k]));
        self.values[node.index()].error = error;
    }

    /// Says that a node is a component of a vector that is turned by a pair; the other one may be known.
    fn component(&mut self, node: Node, [coefficients, vector]: Pairs, is_difference: bool) {
        let sorted = |pair: [Node; 2]| [pair[0].min(pair[1]), pair[0].max(pair[1])];
        let is_pair = |pair: [Node; 2]| pair[0] != pair[1];
        if !is_pair(coefficients) || !is_pair(vector) || self.turn(node).is_some() {
            return;
        }
        let mut key = [coefficients, vector].map(sorted);
        key.sort_unstable();
        let component = Component {
            node,
            is_straight: (coefficients[0] < coefficients[1]) == (vector[0] < vector[1]),
            is_difference,
        };
        let known = self.components.entry(key).or_default();
        let is_other = |other: &&Component| {
            other.is_straight != component.is_straight
                && other.is_difference != component.is_difference
        };
        let partner = known.iter().find(is_other).map(|other| other.node);
        known.push(component);
        let Some(partner) = partner.filter(|other| self.turn(*other).is_none()) else {
            return;
        };
        // The pair of length 1 turns the other one.
        let mut pairs = [coefficients, vector];
        let lengths = pairs.map(|pair| self.length_of(pair).map_or(f64::INFINITY, |x| x.size));
        if (lengths[1] - 1.0).abs() < (lengths[0] - 1.0).abs() {
            pairs.reverse();
        }
        let [coefficients, vector] = pairs;
        for (one, other) in [(node, partner), (partner, node)] {
            self.turns[one.index()] = Some(Turn {
                coefficients,
                vector,
                partner: other,
            });
        }
    }
}

impl Ranged {
    /// The same of a sum of products that has so much length before it is rounded.
    fn tighten(&mut self, turned: Length, roundings: Each) {
        let range = self.range.within(turned.size);
        let error = sum(turned.error, roundings);
        let last = rounding(error.map(|error| plus(range.size(), error)));
        let error = sum(error, last);
        self.range = range;
        self.error = each(|k| self.error[k].min(error[k]));
    }
}
