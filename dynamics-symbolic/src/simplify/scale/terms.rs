//! The sums of a network as lists of terms.

use super::multiple::{Multiple, Scale};
use super::{Network, Scaling};
use crate::expr::{Edge, NodeId, Operation};

/// A sum whose multiple is a factor of another one, or of its inverse.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct Factor {
    pub(super) sum: usize,
    pub(super) inverted: bool,
}

/// A term of a sum: a constant times a node, or a constant alone.
pub(super) struct Term<'g> {
    pub(super) coefficient: Multiple<'g>,
    pub(super) node: Option<NodeId>,
    /// The sums whose multiples make up the node's multiple.
    pub(super) factors: Vec<Factor>,
}

/// The place of a term: its sum, and its number there.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct TermId {
    pub(super) sum: usize,
    pub(super) term: usize,
}

/// A sum, with the multiple of it that is computed.
pub(super) struct Sum<'g> {
    pub(super) terms: Vec<Term<'g>>,
    pub(super) multiple: Multiple<'g>,
    pub(super) is_output: bool,
    /// Terms of other sums that the multiple of this one is a factor of.
    pub(super) readers: Vec<TermId>,
    /// Outputs, by their index in [`Scaling::products`], of which it is a factor.
    pub(super) products: Vec<usize>,
}

impl<'g> Scaling<'_, 'g> {
    /// Finds the sums. `None` where a constant has no inverse fingerprint.
    pub(super) fn collect(&mut self, order: &[NodeId]) -> Option<()> {
        let absorbed = absorbed(self.network, order);
        let mut is_output = vec![false; self.network.graph().len()];
        for output in self.network.outputs() {
            is_output[output.node().index()] = true;
        }
        for &id in order {
            if !is_linear(self.network, id) || absorbed[id.index()] {
                continue;
            }
            let sum = Sum {
                terms: self.terms(id, &absorbed)?,
                multiple: self.one,
                is_output: is_output[id.index()],
                readers: Vec::new(),
                products: Vec::new(),
            };
            self.sum_of[id.index()] = Some(self.sums.len());
            self.sums.push(sum);
        }
        Some(())
    }

    /// The terms of a sum, sums that only it reads included.
    fn terms(&self, id: NodeId, absorbed: &[bool]) -> Option<Vec<Term<'g>>> {
        let mut terms = Vec::new();
        let mut stack = vec![(id.edge(false), self.one)];
        while let Some((edge, coefficient)) = stack.pop() {
            let coefficient = coefficient.negate_if(edge.is_negative());
            let node = edge.node();
            if self.network.is_constant(node) {
                terms.push(Term {
                    coefficient: coefficient.times(self.constant(node)?),
                    node: None,
                    factors: Vec::new(),
                });
            } else if node == id || absorbed[node.index()] {
                self.open(node, coefficient, &mut stack)?;
            } else {
                terms.push(Term {
                    coefficient,
                    node: Some(node),
                    factors: self.factors(node),
                });
            }
        }
        merge(terms)
    }

    /// Puts the operands of a sum, or of a constant multiple, in its place.
    fn open(
        &self,
        node: NodeId,
        coefficient: Multiple<'g>,
        stack: &mut Vec<(Edge, Multiple<'g>)>,
    ) -> Option<()> {
        let operation = self.network.definition(node);
        match operation {
            Operation::Add(a, b) => stack.extend([(b, coefficient), (a, coefficient)]),
            Operation::Mul(a, b) => {
                let is_first = self.network.is_constant(a);
                let (constant, other) = if is_first { (a, b) } else { (b, a) };
                let coefficient = coefficient.times(self.constant(constant)?);
                let flipped = self.network.graph().is_flipped(node, operation);
                stack.push((other.edge(flipped), coefficient));
            }
            _ => return None,
        }
        Some(())
    }

    fn constant(&self, node: NodeId) -> Option<Multiple<'g>> {
        let number = self.constants[node.index()];
        Multiple::new(self.network.graph().expr(node.edge(false)), number)
    }

    /// The sums whose multiples are passed on by a node.
    pub(super) fn factors(&self, node: NodeId) -> Vec<Factor> {
        let mut factors = Vec::new();
        let mut stack = vec![(node, false)];
        while let Some((node, inverted)) = stack.pop() {
            if let Some(sum) = self.sum_of[node.index()] {
                factors.push(Factor { sum, inverted });
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

    /// Tells every sum where its multiple is read.
    pub(super) fn connect(&mut self) {
        for sum in 0..self.sums.len() {
            for term in 0..self.sums[sum].terms.len() {
                let place = TermId { sum, term };
                for factor in self.sums[sum].terms[term].factors.clone() {
                    push_once(&mut self.sums[factor.sum].readers, place);
                }
            }
        }
        for output in self.network.outputs() {
            if self.sum_of[output.node().index()].is_some() {
                continue;
            }
            let factors = self.factors(output.node());
            for factor in &factors {
                push_once(&mut self.sums[factor.sum].products, self.products.len());
            }
            self.products.push(factors);
        }
    }
}

/// Items that are alike come one after the other.
fn push_once<T: PartialEq>(items: &mut Vec<T>, item: T) {
    if items.last() != Some(&item) {
        items.push(item);
    }
}

/// c1 x + c2 x = (c1 + c2) x, also where other terms stand between.
fn merge(terms: Vec<Term<'_>>) -> Option<Vec<Term<'_>>> {
    let mut merged: Vec<Term<'_>> = Vec::with_capacity(terms.len());
    for term in terms {
        let Some(index) = merged.iter().position(|other| other.node == term.node) else {
            merged.push(term);
            continue;
        };
        let sum = merged[index].coefficient.exact + term.coefficient.exact;
        if sum.is_zero() {
            merged.remove(index);
        } else {
            let number = merged[index].coefficient.ratio.number + term.coefficient.ratio.number;
            merged[index].coefficient = Multiple::new(sum, number)?;
        }
    }
    Some(merged)
}

/// Whether a node is a sum, or a constant multiple.
pub(super) fn is_linear(network: &Network<'_>, id: NodeId) -> bool {
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
    let is_part =
        |id: NodeId| network.readers(id) == 1 && !network.is_free(id) && is_linear(network, id);
    for &id in order {
        let operation = network.definition(id);
        if matches!(operation, Operation::Add(..)) {
            for operand in operation.operands().filter(|&operand| is_part(operand)) {
                absorbed[operand.index()] = true;
            }
        }
    }
    for output in network.outputs() {
        absorbed[output.node().index()] = false;
    }
    absorbed
}
