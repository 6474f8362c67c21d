//! The arena of nodes, and the constructors that fold and share.

use super::Operation;
use super::fingerprint::{Fingerprint, FingerprintMap};
use super::node::{Edge, Level, NodeId};
use crate::exact::{Rational, SplitMix64, is_short, negate_if};
use core::cell::{RefCell, RefMut};

/// A node: what it is, how deep its dependencies go, its fingerprint, and whether its definition is
/// held: see [`Graph::holding`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Node {
    pub(crate) operation: Operation,
    pub(crate) level: Level,
    pub(crate) value: Fingerprint,
    pub(crate) held: bool,
}

/// The nodes, found by their values.
#[derive(Default)]
pub(crate) struct Arena {
    nodes: Vec<Node>,
    rationals: Vec<Rational>,
    by_value: FingerprintMap<NodeId>,
    symbols: u32,
}

/// A graph of expressions. Its [`Expr`](super::Expr) handles are `Copy` and have operators.
pub struct Graph {
    arena: RefCell<Arena>,
    pub(super) random: RefCell<SplitMix64>,
}

impl Default for Graph {
    fn default() -> Self {
        Graph::new()
    }
}

impl Graph {
    /// A graph with the numbers 0 and 1.
    pub fn new() -> Self {
        let graph = Graph {
            arena: RefCell::default(),
            random: RefCell::new(SplitMix64::new(0x0072_6f62_6f74)),
        };
        graph.arena().rational(&Rational::ZERO);
        graph.arena().rational(&Rational::ONE);
        graph
    }

    /// A new symbol with that value at the graph's random point.
    pub(super) fn symbol_with(&self, level: Level, value: Fingerprint) -> Edge {
        let mut arena = self.arena.borrow_mut();
        let operation = Operation::Symbol(arena.symbols);
        arena.symbols += 1;
        // A node is the symbol itself, not minus it; circles are symmetric to both axes.
        let value = negate_if(value, value.get() > (-value).get());
        arena.intern(operation, level, value)
    }

    /// The arena, to add nodes: nothing else may read the graph meanwhile.
    pub(crate) fn arena(&self) -> RefMut<'_, Arena> {
        self.arena.borrow_mut()
    }

    /// The number of nodes.
    pub(crate) fn len(&self) -> usize {
        self.arena.borrow().nodes.len()
    }

    /// The operation of the node.
    pub fn operation(&self, id: NodeId) -> Operation {
        self.node(id).operation
    }

    /// The level of the node.
    pub fn level_of(&self, id: NodeId) -> Level {
        self.node(id).level
    }

    /// Does some work and holds the definitions of the nodes that are new after it: no search for shorter programs
    /// replaces them, nor those of nodes that read them. So the rounding errors of a solution's steps stay together.
    pub fn holding<T>(&self, work: impl FnOnce() -> T) -> T {
        let first = self.len();
        let result = work();
        for node in &mut self.arena.borrow_mut().nodes[first..] {
            node.held = true;
        }
        result
    }

    /// Does some work and forgets what it added to the graph, which the result must not name. Nodes from before may
    /// have got a definition by new ones meanwhile: they have their own again.
    pub(crate) fn trying<T>(&self, work: impl FnOnce() -> T) -> T {
        let (nodes, rationals, symbols) = {
            let arena = self.arena.borrow();
            (arena.nodes.clone(), arena.rationals.len(), arena.symbols)
        };
        let random = self.random.borrow().clone();
        let result = work();
        *self.random.borrow_mut() = random;
        let arena = &mut *self.arena.borrow_mut();
        for node in arena.nodes.drain(nodes.len()..) {
            arena.by_value.remove(&node.value.get());
        }
        arena.nodes.copy_from_slice(&nodes);
        arena.rationals.truncate(rationals);
        arena.symbols = symbols;
        result
    }

    pub(crate) fn node(&self, id: NodeId) -> Node {
        self.arena.borrow().nodes[id.index()]
    }

    /// Whether a node is minus the product or quotient of its operands: fingerprints are of the node up to sign.
    pub(crate) fn is_flipped(&self, id: NodeId, operation: Operation) -> bool {
        let value = |id: NodeId| self.node(id).value;
        match operation {
            Operation::Mul(a, b) => value(a) * value(b) != value(id),
            Operation::Div(a, b) => value(id) * value(b) != value(a),
            Operation::Rational(_) | Operation::Symbol(_) | Operation::Add(..) => false,
        }
    }

    /// Calls `visit` with a node and those that it is made of, operands first, except for known ones. `visit` must make
    /// its node known. The stack is explicit, because chains are long.
    pub(crate) fn visit_operands_first<S>(
        &self,
        state: &mut S,
        root: NodeId,
        is_known: impl Fn(&S, NodeId) -> bool,
        mut visit: impl FnMut(&mut S, NodeId, Operation),
    ) {
        let mut stack = vec![root];
        while let Some(&id) = stack.last() {
            if is_known(state, id) {
                stack.pop();
                continue;
            }
            let operation = self.operation(id);
            let depth = stack.len();
            stack.extend(operation.operands().filter(|id| !is_known(state, *id)));
            if stack.len() == depth {
                visit(state, id, operation);
                stack.pop();
            }
        }
    }

    /// The exact number of a [`Operation::Rational`] node.
    pub fn rational_of(&self, index: u32) -> Rational {
        self.arena.borrow().rationals[index as usize].clone()
    }
}

impl Arena {
    fn node(&self, edge: Edge) -> &Node {
        &self.nodes[edge.node().index()]
    }

    pub(super) fn value(&self, edge: Edge) -> Fingerprint {
        let value = self.node(edge).value;
        negate_if(value, edge.is_negative())
    }

    fn level(&self, edge: Edge) -> Level {
        self.node(edge).level
    }

    /// The node of that value: the one that exists, or a new one. A node's own
    /// sign is the one whose fingerprint is the smaller representative.
    fn intern(&mut self, operation: Operation, level: Level, value: Fingerprint) -> Edge {
        self.write(operation, level, value).0
    }

    /// As [`Arena::intern`], with the operation as a definition of the node.
    fn write(
        &mut self,
        operation: Operation,
        level: Level,
        value: Fingerprint,
    ) -> (Edge, Operation) {
        let negative = value.get() > (-value).get();
        let value = negate_if(value, negative);
        let operation = match operation {
            Operation::Add(a, b) => {
                let (a, b) = (a.negate_if(negative), b.negate_if(negative));
                Operation::Add(a.min(b), a.max(b))
            }
            Operation::Mul(a, b) => Operation::Mul(a.min(b), a.max(b)),
            other => other,
        };
        let id = match self.by_value.get(&value.get()) {
            Some(&id) => {
                let node = &mut self.nodes[id.index()];
                if level < node.level {
                    // The same value with fewer dependencies: it cannot depend on this node.
                    node.operation = operation;
                    node.level = level;
                }
                id
            }
            None => {
                let id = NodeId::from_index(self.nodes.len());
                self.nodes.push(Node {
                    operation,
                    level,
                    value,
                    held: false,
                });
                self.by_value.insert(value.get(), id);
                id
            }
        };
        (id.edge(negative), operation)
    }

    /// The node of a sum, and the sum as that node's definition, not folded.
    pub(crate) fn write_sum(&mut self, a: Edge, b: Edge) -> (Edge, Operation) {
        let value = self.value(a) + self.value(b);
        self.write(Operation::Add(a, b), self.level_of_both(a, b), value)
    }

    /// As [`Arena::write_sum`], of a product.
    pub(crate) fn write_product(&mut self, a: Edge, b: Edge) -> (Edge, Operation) {
        let value = self.node(a).value * self.node(b).value;
        self.write_with_signs(a, b, Operation::Mul(a.node(), b.node()), value)
    }

    /// As [`Arena::write_sum`], of a quotient.
    pub(crate) fn write_quotient(&mut self, a: Edge, b: Edge) -> (Edge, Operation) {
        let inverse = self.node(b).value.inverse().unwrap_or(Fingerprint::ZERO);
        let value = self.node(a).value * inverse;
        self.write_with_signs(a, b, Operation::Div(a.node(), b.node()), value)
    }

    /// A product or quotient of two nodes: both take the signs of the edges.
    fn write_with_signs(
        &mut self,
        a: Edge,
        b: Edge,
        operation: Operation,
        value: Fingerprint,
    ) -> (Edge, Operation) {
        let (edge, operation) = self.write(operation, self.level_of_both(a, b), value);
        let is_negative = a.is_negative() != b.is_negative();
        (edge.negate_if(is_negative), operation)
    }

    fn level_of_both(&self, a: Edge, b: Edge) -> Level {
        self.level(a).max(self.level(b))
    }

    pub(super) fn rational(&mut self, x: &Rational) -> Edge {
        // A number without faithful image gets no shared node; the proof, over another prime, is what counts.
        let value = Fingerprint::from_rational(x)
            .unwrap_or_else(|| Fingerprint::random(&mut SplitMix64::new(self.nodes.len() as u64)));
        self.number(value, |_| x.clone())
    }

    /// The number of that fingerprint. Fractions are slow, fingerprints are not: the number is worked out only where no
    /// node has it yet.
    fn number(&mut self, value: Fingerprint, exact: impl FnOnce(&Self) -> Rational) -> Edge {
        let index = self.rationals.len() as u32;
        let edge = self.intern(Operation::Rational(index), Level::Constant, value);
        if self.node(edge).operation == Operation::Rational(index) {
            let x = exact(self);
            self.rationals.push(negate_if(x, edge.is_negative()));
        }
        edge
    }

    /// The index of the number of an edge, and whether its sign changes; `None` if the edge is no rational number.
    fn number_of(&self, edge: Edge) -> Option<(u32, bool)> {
        match self.node(edge).operation {
            Operation::Rational(index) => Some((index, edge.is_negative())),
            _ => None,
        }
    }

    /// The indices of two numbers that are short. Sums and products of long ones are not worked out: numbers that are
    /// computed from decimals in many steps have more and more digits.
    fn short_numbers(&self, a: Edge, b: Edge) -> Option<((u32, bool), (u32, bool))> {
        let (x, y) = (self.number_of(a)?, self.number_of(b)?);
        let [first, second] = [x, y].map(|(index, _)| &self.rationals[index as usize]);
        is_short(first, second).then_some((x, y))
    }

    fn exact(&self, (index, negative): (u32, bool)) -> Rational {
        negate_if(self.rationals[index as usize].clone(), negative)
    }

    pub(super) fn as_rational(&self, edge: Edge) -> Option<Rational> {
        Some(self.exact(self.number_of(edge)?))
    }

    fn is_zero(&self, edge: Edge) -> bool {
        edge.node() == NodeId::ZERO
    }

    fn is_constant(&self, edge: Edge) -> bool {
        self.level(edge) == Level::Constant
    }

    fn is_one(&self, edge: Edge) -> bool {
        edge.node() == NodeId::ONE
    }

    pub(crate) fn add(&mut self, a: Edge, b: Edge) -> Edge {
        // Zero has one sign: of two zeros the first counts.
        if self.is_zero(b) {
            return a;
        }
        if self.is_zero(a) {
            return b;
        }
        if let Some((x, y)) = self.short_numbers(a, b) {
            let sum = |arena: &Self| arena.exact(x) + arena.exact(y);
            return match self.value(a) + self.value(b) {
                // The number itself says whether it is zero.
                Fingerprint::ZERO => self.rational(&sum(self)),
                value => self.number(value, sum),
            };
        }
        let folded = self.fold_constant_term(a, b);
        if let Some(sum) = folded.or_else(|| self.fold_constant_term(b, a)) {
            return sum;
        }
        if (self.value(a) + self.value(b)).is_zero() {
            return NodeId::ZERO.edge(false);
        }
        self.write_sum(a, b).0
    }

    /// k1 + (k2 + x) = (k1 + k2) + x for constants k1, k2.
    fn fold_constant_term(&mut self, constant: Edge, sum: Edge) -> Option<Edge> {
        if !self.is_constant(constant) || self.is_constant(sum) {
            return None;
        }
        let Operation::Add(a, b) = self.node(sum).operation else {
            return None;
        };
        let [a, b] = [a, b].map(|edge| edge.negate_if(sum.is_negative()));
        let (inner, rest) = match (self.is_constant(a), self.is_constant(b)) {
            (true, false) => (a, b),
            (false, true) => (b, a),
            _ => return None,
        };
        let folded = self.add(constant, inner);
        Some(self.add(folded, rest))
    }

    pub(crate) fn mul(&mut self, a: Edge, b: Edge) -> Edge {
        if self.is_zero(a) || self.is_zero(b) {
            return NodeId::ZERO.edge(false);
        }
        if self.is_one(a) {
            return b.negate_if(a.is_negative());
        }
        if self.is_one(b) {
            return a.negate_if(b.is_negative());
        }
        if let Some((x, y)) = self.short_numbers(a, b) {
            let product = |arena: &Self| arena.exact(x) * arena.exact(y);
            return self.number(self.value(a) * self.value(b), product);
        }
        let folded = self.fold_constant_factor(a, b);
        if let Some(product) = folded.or_else(|| self.fold_constant_factor(b, a)) {
            return product;
        }
        self.write_product(a, b).0
    }

    /// k1 (k2 x) = (k1 k2) x for constants k1, k2.
    fn fold_constant_factor(&mut self, constant: Edge, product: Edge) -> Option<Edge> {
        if !self.is_constant(constant) || self.is_constant(product) {
            return None;
        }
        let node = *self.node(product);
        let Operation::Mul(a, b) = node.operation else {
            return None;
        };
        let (inner, rest) = match (self.nodes[a.index()].level, self.nodes[b.index()].level) {
            (Level::Constant, _) => (a, b),
            (_, Level::Constant) => (b, a),
            _ => return None,
        };
        // The product's own sign may differ from its factors': compare values.
        let flipped = node.value != self.nodes[a.index()].value * self.nodes[b.index()].value;
        let folded = self.mul(constant, inner.edge(false));
        Some(self.mul(folded, rest.edge(flipped != product.is_negative())))
    }

    pub(crate) fn div(&mut self, a: Edge, b: Edge) -> Edge {
        if self.is_zero(a) {
            return a;
        }
        if let Some(y) = self.as_rational(b).filter(|y| !y.is_zero()) {
            let reciprocal = self.rational(&(Rational::ONE / y));
            return self.mul(a, reciprocal);
        }
        self.write_quotient(a, b).0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{MOST_BITS, bit_length};

    /// A trial leaves no trace: the same nodes, numbers and random values are the next ones.
    #[test]
    fn trials_are_forgotten() {
        let graph = Graph::new();
        let x = graph.symbol(Level::Variable);
        let work = || {
            let y = graph.symbol(Level::Variable);
            let third = graph.rational(&(Rational::ONE / Rational::from(3)));
            let z = third * (x + y) * y;
            (y.edge(), third.edge(), z.edge(), graph.len())
        };
        let first = graph.trying(work);
        assert_eq!(graph.len(), x.edge().node().index() + 1);
        assert_eq!(graph.trying(work), first);
        assert_eq!(work(), first);
        let third = graph.rational(&(Rational::ONE / Rational::from(3)));
        assert_eq!(third.edge(), first.1);
    }

    /// Squares of a decimal, of which the last would have 10^9 digits: they are operations that are not carried out,
    /// and equal ones are still known to be equal.
    #[test]
    fn numbers_get_no_longer_than_the_longest() {
        let graph = Graph::new();
        let decimal = graph.rational(&(Rational::from(997) / Rational::from(1_000)));
        let (mut power, mut inverse) = (decimal, graph.one() / decimal);
        for _ in 0..30 {
            (power, inverse) = (power * power + decimal - decimal, inverse * inverse);
        }
        assert!(power.as_rational().is_none());
        assert_eq!(power.level(), Level::Constant);
        assert_eq!(power * inverse, graph.one());
        assert!((power - graph.one() / inverse).is_zero());
        let arena = graph.arena.borrow();
        let longest = arena.rationals.iter().map(bit_length).max();
        assert!(longest.is_some_and(|bits| (MOST_BITS / 2..=MOST_BITS + 1).contains(&bits)));
    }
}
