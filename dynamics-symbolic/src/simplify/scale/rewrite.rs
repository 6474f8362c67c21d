//! The network with the multiples that were chosen.

use super::Scaling;
use super::multiple::{Multiple, Scale};
use super::terms::{TermId, is_linear};
use crate::expr::{Edge, NodeId, Operation};
use crate::simplify::Writer;
use std::collections::VecDeque;

impl<'g> Scaling<'_, 'g> {
    /// The definitions of the rewritten network, and the nodes whose definitions are held: the
    /// multiples of what is held, or reads it.
    pub(super) fn rewrite(&self, order: &[NodeId]) -> (Vec<(NodeId, Operation)>, Vec<NodeId>) {
        let fixed = self.network.fixed(order);
        let mut writer = Writer::new(self.network.graph());
        for &id in order {
            writer.stored[id.index()] = self.write_node(&mut writer, id);
        }
        for output in self.network.outputs() {
            self.correct(&mut writer, output.node());
        }
        let fixed = order.iter().filter(|id| fixed[id.index()]);
        let edges = fixed.filter_map(|id| writer.stored[id.index()]);
        let held = edges.map(Edge::node).collect();
        (writer.definitions, held)
    }

    /// The node that is computed in the place of another one: none if a sum has absorbed that.
    fn write_node(&self, writer: &mut Writer<'g>, id: NodeId) -> Option<Edge> {
        if let Some(sum) = self.sum_of[id.index()] {
            return Some(self.write_sum(writer, sum));
        }
        let operation = self.network.definition(id);
        let is_absorbed = is_linear(self.network, id);
        (!is_absorbed).then(|| writer.rewritten(id, operation))
    }

    /// The multiple of a sum that is computed. Terms with the same coefficient are added before they are multiplied:
    /// c x + c y is written as c (x + y).
    fn write_sum(&self, writer: &mut Writer<'g>, sum: usize) -> Edge {
        let mut total: Option<Edge> = None;
        let mut left: VecDeque<_> = self.scaled_terms(writer, sum).into();
        while let Some((coefficient, node)) = left.pop_front() {
            let term = match node {
                None => coefficient,
                Some(node) => {
                    let inner = add_alike(writer, (coefficient, node), &mut left);
                    writer.scaled(coefficient, inner)
                }
            };
            total = Some(total.map_or(term, |total| writer.add(total, term)));
        }
        total.expect("a sum is not zero: a term remains")
    }

    /// The terms of the multiple of a sum: constants, and the nodes that they multiply.
    fn scaled_terms(&self, writer: &Writer<'g>, sum: usize) -> Vec<(Edge, Option<Edge>)> {
        let terms = self.sums[sum].terms.iter().enumerate();
        let scaled = terms.map(|(index, term)| {
            let coefficient: Multiple<'g> = self.coefficient(TermId { sum, term: index });
            let coefficient = coefficient.over(self.sums[sum].multiple).exact.edge();
            (coefficient, term.node.map(|node| writer.stored(node)))
        });
        scaled.collect()
    }

    /// Undoes the multiple of an output.
    fn correct(&self, writer: &mut Writer<'g>, output: NodeId) {
        let multiple = match self.sum_of[output.index()] {
            Some(sum) => self.sums[sum].multiple,
            None => self.product(&self.factors(output)),
        };
        if !self.network.is_free(output) {
            writer.scaled(multiple.exact.edge(), writer.stored(output));
        }
    }
}

/// Adds to the node of one term those of the terms with the same coefficient that are left, which must not be 1.
fn add_alike(
    writer: &mut Writer<'_>,
    (coefficient, first): (Edge, Edge),
    left: &mut VecDeque<(Edge, Option<Edge>)>,
) -> Edge {
    let mut total = first;
    if writer.is_unit(coefficient) {
        return total;
    }
    left.retain(|&(other, node)| match node {
        Some(node) if other.node() == coefficient.node() => {
            let is_against = other.is_negative() != coefficient.is_negative();
            total = writer.add(total, node.negate_if(is_against));
            false
        }
        _ => true,
    });
    total
}
