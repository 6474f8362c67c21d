//! Which multiple of each sum is computed.
//!
//! A sum c1 x1 + c2 x2 + ... with constant coefficients may be computed as any
//! multiple of itself: the multiple passes through products for nothing and is
//! made good in the coefficients of the sums that read it, or at an output.
//! Computed as x1 + (c2/c1) x2 + ..., the sum takes one multiplication less,
//! and where its readers multiply by a constant anyway none is added. The
//! multiples are chosen one by one for as long as coefficients become 1.

use super::Network;
use crate::expr::{Edge, Expr, Fingerprint, Graph, NodeId, Operation};

/// How often moves that cost nothing are made.
const DRIFTS: usize = 2;

/// A constant, exact and as a fingerprint.
#[derive(Clone, Copy)]
struct Scale<'g> {
    exact: Expr<'g>,
    value: Fingerprint,
    inverse: Fingerprint,
}

impl<'g> Scale<'g> {
    fn new(exact: Expr<'g>) -> Option<Self> {
        let value = exact.fingerprint();
        Some(Scale {
            exact,
            value,
            inverse: value.inverse()?,
        })
    }

    fn times(self, o: Self) -> Self {
        Scale {
            exact: self.exact * o.exact,
            value: self.value * o.value,
            inverse: self.inverse * o.inverse,
        }
    }

    fn over(self, o: Self) -> Self {
        Scale {
            exact: self.exact / o.exact,
            value: self.value * o.inverse,
            inverse: self.inverse * o.value,
        }
    }

    fn is_unit(self) -> bool {
        is_unit(self.value)
    }
}

fn is_unit(value: Fingerprint) -> bool {
    value == Fingerprint::ONE || value == -Fingerprint::ONE
}

/// A term of a sum: a constant times a node, or a constant alone.
struct Term<'g> {
    coefficient: Scale<'g>,
    node: Option<NodeId>,
    /// The sums whose multiples are factors of the node's multiple, with their powers.
    factors: Vec<(usize, bool)>,
}

/// A sum, with the multiple of it that is computed.
struct Sum<'g> {
    terms: Vec<Term<'g>>,
    scale: Scale<'g>,
    is_output: bool,
    /// Terms of other sums that the multiple of this one is a factor of.
    readers: Vec<(usize, usize)>,
}

/// A multiple to try.
#[derive(Clone, Copy)]
enum Candidate {
    /// The sum itself.
    One,
    /// That which makes the coefficient of this term 1.
    Own(usize),
    /// That which makes the coefficient 1 in this reader, in this term of it.
    Reader(usize, usize),
}

struct Scaling<'n, 'g> {
    network: &'n Network<'g>,
    sums: Vec<Sum<'g>>,
    sum_of: Vec<Option<usize>>,
    /// Outputs that are products of sums: the factors of their multiple.
    products: Vec<Vec<(usize, bool)>>,
    one: Scale<'g>,
}

/// Chooses the multiples, and rewrites the network accordingly.
pub(super) fn rescale(network: &mut Network<'_>) {
    let order = network.order();
    let graph = network.graph();
    let Some(mut scaling) = Scaling::new(network, graph, &order) else {
        return;
    };
    scaling.descend();
    let definitions = scaling.rewrite(graph, &order);
    let rewritten = Network::with_definitions(graph, network.outputs(), definitions);
    if rewritten.cost() < network.cost() {
        *network = rewritten;
    }
}

impl<'n, 'g> Scaling<'n, 'g> {
    /// `None` where a constant has no inverse fingerprint.
    fn new(network: &'n Network<'g>, graph: &'g Graph, order: &[NodeId]) -> Option<Self> {
        let one = Scale::new(graph.one())?;
        let mut scaling = Scaling {
            network,
            sums: Vec::new(),
            sum_of: vec![None; graph.len()],
            products: Vec::new(),
            one,
        };
        let absorbed = absorbed(network, order);
        for &id in order {
            if is_linear(network, id) && !absorbed[id.index()] {
                let terms = scaling.terms(id, &absorbed)?;
                let is_output = network.outputs().iter().any(|output| output.node() == id);
                scaling.sum_of[id.index()] = Some(scaling.sums.len());
                scaling.sums.push(Sum {
                    terms,
                    scale: one,
                    is_output,
                    readers: Vec::new(),
                });
            }
        }
        scaling.connect();
        Some(scaling)
    }

    /// The terms of a sum, sums that only it reads included.
    fn terms(&self, id: NodeId, absorbed: &[bool]) -> Option<Vec<Term<'g>>> {
        let mut terms = Vec::new();
        let mut stack = vec![(id.edge(false), self.one)];
        while let Some((edge, coefficient)) = stack.pop() {
            let coefficient = if edge.is_negative() {
                Scale {
                    exact: -coefficient.exact,
                    value: -coefficient.value,
                    inverse: -coefficient.inverse,
                }
            } else {
                coefficient
            };
            let node = edge.node();
            if self.network.is_constant(node) {
                let constant = Scale::new(self.network.graph().expr(node.edge(false)))?;
                terms.push(Term {
                    coefficient: coefficient.times(constant),
                    node: None,
                    factors: Vec::new(),
                });
            } else if node == id || absorbed[node.index()] {
                match self.network.definition(node) {
                    Operation::Add(a, b) => stack.extend([(b, coefficient), (a, coefficient)]),
                    Operation::Mul(a, b) => {
                        let (constant, other) = if self.network.is_constant(a) {
                            (a, b)
                        } else {
                            (b, a)
                        };
                        let constant = Scale::new(self.network.graph().expr(constant.edge(false)))?;
                        let flipped = self.network.is_flipped(node, a, b);
                        stack.push((other.edge(flipped), coefficient.times(constant)));
                    }
                    _ => return None,
                }
            } else {
                let factors = self.factors(node);
                terms.push(Term {
                    coefficient,
                    node: Some(node),
                    factors,
                });
            }
        }
        merge(terms)
    }

    /// The sums whose multiples are passed on by a node.
    fn factors(&self, node: NodeId) -> Vec<(usize, bool)> {
        let mut factors = Vec::new();
        let mut stack = vec![(node, false)];
        while let Some((node, inverted)) = stack.pop() {
            if let Some(sum) = self.sum_of[node.index()] {
                factors.push((sum, inverted));
            } else if !self.network.is_free(node) {
                match self.network.definition(node) {
                    Operation::Mul(a, b) => stack.extend([(a, inverted), (b, inverted)]),
                    Operation::Div(a, b) => stack.extend([(a, inverted), (b, !inverted)]),
                    _ => {}
                }
            }
        }
        factors
    }

    fn connect(&mut self) {
        for reader in 0..self.sums.len() {
            for term in 0..self.sums[reader].terms.len() {
                for (sum, _) in self.sums[reader].terms[term].factors.clone() {
                    if self.sums[sum].readers.last() != Some(&(reader, term)) {
                        self.sums[sum].readers.push((reader, term));
                    }
                }
            }
        }
        let outputs = self.network.outputs().iter();
        let products = outputs.filter(|output| self.sum_of[output.node().index()].is_none());
        self.products = products.map(|output| self.factors(output.node())).collect();
    }

    /// The multiple that a product of sums carries.
    fn multiple(&self, factors: &[(usize, bool)]) -> Fingerprint {
        factors
            .iter()
            .fold(Fingerprint::ONE, |product, &(sum, inverted)| {
                let scale = self.sums[sum].scale;
                product * if inverted { scale.inverse } else { scale.value }
            })
    }

    fn is_multiplied(&self, reader: usize, term: usize) -> bool {
        let sum = &self.sums[reader];
        let term = &sum.terms[term];
        term.node.is_some()
            && !is_unit(term.coefficient.value * self.multiple(&term.factors) * sum.scale.inverse)
    }

    /// Multiplications by constants that depend on the multiple of a sum.
    fn local_cost(&self, sum: usize) -> usize {
        let own = (0..self.sums[sum].terms.len())
            .filter(|&term| self.is_multiplied(sum, term))
            .count();
        let readers = self.sums[sum]
            .readers
            .iter()
            .filter(|&&(r, t)| self.is_multiplied(r, t))
            .count();
        let output = self.sums[sum].is_output && !self.sums[sum].scale.is_unit();
        let products = self
            .products
            .iter()
            .filter(|factors| {
                factors.iter().any(|&(s, _)| s == sum) && !is_unit(self.multiple(factors))
            })
            .count();
        own + readers + output as usize + products
    }

    /// All multiplications by constants.
    fn total_cost(&self) -> usize {
        let terms = (0..self.sums.len()).map(|sum| {
            (0..self.sums[sum].terms.len())
                .filter(|&term| self.is_multiplied(sum, term))
                .count()
        });
        let outputs = self
            .sums
            .iter()
            .filter(|sum| sum.is_output && !sum.scale.is_unit())
            .count();
        let products = self
            .products
            .iter()
            .filter(|factors| !is_unit(self.multiple(factors)))
            .count();
        terms.sum::<usize>() + outputs + products
    }

    /// Descents from several starts: from the sums as they are, and from sums
    /// whose first coefficient is 1. The best multiples found are kept.
    fn descend(&mut self) {
        let mut best = (self.total_cost(), self.scales());
        for longest in [0, 1, usize::MAX] {
            self.start(longest);
            for _ in 0..DRIFTS {
                self.settle();
                let cost = self.total_cost();
                if cost < best.0 {
                    best = (cost, self.scales());
                }
                // Moves that cost nothing carry multiples towards the readers, where they meet others.
                for sum in 0..self.sums.len() {
                    self.improve(sum, true);
                }
            }
        }
        for (sum, scale) in self.sums.iter_mut().zip(best.1) {
            sum.scale = scale;
        }
    }

    /// Improves multiples until none can be.
    fn settle(&mut self) {
        loop {
            let improved = (0..self.sums.len())
                .filter(|&sum| self.improve(sum, false))
                .count();
            if improved == 0 {
                return;
            }
        }
    }

    /// Sums of up to `longest` terms with a first coefficient of 1, the others as they are.
    fn start(&mut self, longest: usize) {
        for sum in 0..self.sums.len() {
            let candidate = self.candidates(sum)[0];
            let is_short = self.sums[sum].terms.len() <= longest;
            self.sums[sum].scale = if is_short {
                self.exact(sum, candidate)
            } else {
                self.one
            };
        }
    }

    fn scales(&self) -> Vec<Scale<'g>> {
        self.sums.iter().map(|sum| sum.scale).collect()
    }

    /// Takes the best of the multiples that make one coefficient 1, or the sum
    /// itself; with `drift`, another one also where it is no better.
    fn improve(&mut self, sum: usize, drift: bool) -> bool {
        let old = self.sums[sum].scale;
        let mut best = (self.local_cost(sum), None);
        for candidate in self.candidates(sum) {
            let (value, inverse) = self.approach(sum, candidate);
            if value == old.value {
                continue;
            }
            self.sums[sum].scale = Scale {
                exact: old.exact,
                value,
                inverse,
            };
            let cost = self.local_cost(sum);
            if cost < best.0 || drift && cost == best.0 && best.1.is_none() {
                best = (cost, Some(candidate));
            }
            self.sums[sum].scale = old;
        }
        if let Some(candidate) = best.1 {
            self.sums[sum].scale = self.exact(sum, candidate);
        }
        best.1.is_some()
    }

    fn candidates(&self, sum: usize) -> Vec<Candidate> {
        let terms = self.sums[sum].terms.iter().enumerate();
        let own = terms
            .filter(|(_, term)| term.node.is_some())
            .map(|(index, _)| Candidate::Own(index));
        let readers = self.sums[sum]
            .readers
            .iter()
            .filter_map(|&(reader, index)| {
                // Linear readers only: the multiple enters once.
                let factors = &self.sums[reader].terms[index].factors;
                let mut powers = factors.iter().filter(|&&(other, _)| other == sum);
                let linear = powers.next() == Some(&(sum, false)) && powers.next().is_none();
                linear.then_some(Candidate::Reader(reader, index))
            });
        own.chain(readers).chain([Candidate::One]).collect()
    }

    /// The multiple that a candidate stands for, and its inverse, as fingerprints.
    fn approach(&self, sum: usize, candidate: Candidate) -> (Fingerprint, Fingerprint) {
        match candidate {
            Candidate::One => (Fingerprint::ONE, Fingerprint::ONE),
            Candidate::Own(index) => {
                let term = &self.sums[sum].terms[index];
                let (value, inverse) = self.multiple_and_inverse(&term.factors);
                (
                    term.coefficient.value * value,
                    term.coefficient.inverse * inverse,
                )
            }
            Candidate::Reader(reader, index) => {
                let (sum, reader) = (&self.sums[sum], &self.sums[reader]);
                let term = &reader.terms[index];
                let (value, inverse) = self.multiple_and_inverse(&term.factors);
                (
                    sum.scale.value * reader.scale.value * term.coefficient.inverse * inverse,
                    sum.scale.inverse * reader.scale.inverse * term.coefficient.value * value,
                )
            }
        }
    }

    /// The multiple that a candidate stands for.
    fn exact(&self, sum: usize, candidate: Candidate) -> Scale<'g> {
        match candidate {
            Candidate::One => self.one,
            Candidate::Own(index) => {
                let term = &self.sums[sum].terms[index];
                term.coefficient.times(self.exact_multiple(&term.factors))
            }
            Candidate::Reader(reader, index) => {
                let term = &self.sums[reader].terms[index];
                let coefficient = term.coefficient.times(self.exact_multiple(&term.factors));
                self.sums[sum]
                    .scale
                    .times(self.sums[reader].scale)
                    .over(coefficient)
            }
        }
    }

    fn multiple_and_inverse(&self, factors: &[(usize, bool)]) -> (Fingerprint, Fingerprint) {
        factors.iter().fold(
            (Fingerprint::ONE, Fingerprint::ONE),
            |(product, inverse), &(sum, inverted)| {
                let scale = self.sums[sum].scale;
                let (a, b) = if inverted {
                    (scale.inverse, scale.value)
                } else {
                    (scale.value, scale.inverse)
                };
                (product * a, inverse * b)
            },
        )
    }

    fn exact_multiple(&self, factors: &[(usize, bool)]) -> Scale<'g> {
        factors.iter().fold(self.one, |product, &(sum, inverted)| {
            let scale = self.sums[sum].scale;
            if inverted {
                product.over(scale)
            } else {
                product.times(scale)
            }
        })
    }

    /// The definitions of the rewritten network.
    fn rewrite(&self, graph: &'g Graph, order: &[NodeId]) -> Vec<(NodeId, Operation)> {
        let mut writer = Writer {
            graph,
            definitions: Vec::new(),
            stored: vec![None; graph.len()],
        };
        for &id in order {
            let stored = match (self.sum_of[id.index()], self.network.definition(id)) {
                (Some(sum), _) => self.write_sum(&mut writer, &self.sums[sum]),
                (None, Operation::Mul(a, b))
                    if !self.network.is_constant(a) && !self.network.is_constant(b) =>
                {
                    let flipped = self.network.is_flipped(id, a, b);
                    let (a, b) = (writer.stored(a), writer.stored(b));
                    writer.mul(a, b).negate_if(flipped)
                }
                (None, Operation::Div(a, b)) => {
                    let flipped = self.network.is_flipped_quotient(id, a, b);
                    let (a, b) = (writer.stored(a), writer.stored(b));
                    writer.div(a, b).negate_if(flipped)
                }
                // Absorbed by the one sum that reads it.
                _ => continue,
            };
            writer.stored[id.index()] = Some(stored);
        }
        for output in self.network.outputs() {
            let multiple = match self.sum_of[output.node().index()] {
                Some(sum) => self.sums[sum].scale,
                None => self.exact_multiple(&self.factors(output.node())),
            };
            if !self.network.is_free(output.node()) {
                let stored = writer.stored(output.node());
                writer.scaled(multiple.exact.edge(), stored);
            }
        }
        writer.definitions
    }

    fn write_sum(&self, writer: &mut Writer<'g>, sum: &Sum<'g>) -> Edge {
        let mut total: Option<Edge> = None;
        for term in &sum.terms {
            let multiple = self.exact_multiple(&term.factors);
            let coefficient = term
                .coefficient
                .times(multiple)
                .over(sum.scale)
                .exact
                .edge();
            let term = match term.node {
                None => coefficient,
                Some(node) => {
                    let stored = writer.stored(node);
                    writer.scaled(coefficient, stored)
                }
            };
            total = Some(match total {
                None => term,
                Some(total) => writer.add(total, term),
            });
        }
        total.expect("a sum has terms")
    }
}

/// c1 x + c2 x = (c1 + c2) x, also where other terms stand between.
fn merge(terms: Vec<Term<'_>>) -> Option<Vec<Term<'_>>> {
    let mut merged: Vec<Term<'_>> = Vec::with_capacity(terms.len());
    for term in terms {
        match merged.iter_mut().find(|other| other.node == term.node) {
            Some(other) => {
                let sum = other.coefficient.exact + term.coefficient.exact;
                if sum.is_zero() {
                    merged.retain(|other| other.node != term.node);
                } else {
                    other.coefficient = Scale::new(sum)?;
                }
            }
            None => merged.push(term),
        }
    }
    Some(merged)
}

/// Whether a node is a sum, or a constant multiple.
fn is_linear(network: &Network<'_>, id: NodeId) -> bool {
    match network.definition(id) {
        Operation::Add(..) => true,
        Operation::Mul(a, b) => network.is_constant(a) || network.is_constant(b),
        _ => false,
    }
}

/// Sums that one other sum alone reads are part of it. Not those that are
/// multiplied before: the constant would be distributed over their terms.
fn absorbed(network: &Network<'_>, order: &[NodeId]) -> Vec<bool> {
    let mut absorbed = vec![false; network.graph().len()];
    for &id in order
        .iter()
        .filter(|&&id| matches!(network.definition(id), Operation::Add(..)))
    {
        for operand in network.definition(id).operands() {
            if network.readers(operand) == 1
                && !network.is_free(operand)
                && is_linear(network, operand)
            {
                absorbed[operand.index()] = true;
            }
        }
    }
    for output in network.outputs() {
        absorbed[output.node().index()] = false;
    }
    absorbed
}

/// Writes operations on the graph exactly as they are given, and keeps them as definitions.
struct Writer<'g> {
    graph: &'g Graph,
    definitions: Vec<(NodeId, Operation)>,
    stored: Vec<Option<Edge>>,
}

impl Writer<'_> {
    /// What is computed in the place of a node.
    fn stored(&self, node: NodeId) -> Edge {
        self.stored
            .get(node.index())
            .copied()
            .flatten()
            .unwrap_or(node.edge(false))
    }

    fn keep(&mut self, (edge, operation): (Edge, Operation)) -> Edge {
        self.definitions.push((edge.node(), operation));
        edge
    }

    fn scaled(&mut self, coefficient: Edge, edge: Edge) -> Edge {
        let one = self.graph.one().edge();
        if coefficient.node() == one.node() {
            return edge.negate_if(coefficient.is_negative());
        }
        self.mul(coefficient, edge)
    }

    fn add(&mut self, a: Edge, b: Edge) -> Edge {
        let written = self.graph.write_sum(a, b);
        self.keep(written)
    }

    fn mul(&mut self, a: Edge, b: Edge) -> Edge {
        let written = self.graph.write_product(a, b);
        self.keep(written)
    }

    fn div(&mut self, a: Edge, b: Edge) -> Edge {
        let written = self.graph.write_quotient(a, b);
        self.keep(written)
    }
}
