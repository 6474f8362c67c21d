//! The network with the multiples that were chosen.

use super::multiple::{Multiple, Scale};
use super::terms::{TermId, is_linear};
use super::{Scaling, common};
use crate::expr::{Edge, NodeId, Operation};
use crate::simplify::Writer;

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
            let terms = self.written_terms(writer, sum);
            return Some(common::write_sum(writer, terms));
        }
        let operation = self.network.definition(id);
        let is_absorbed = is_linear(self.network, id);
        (!is_absorbed).then(|| writer.rewritten(id, operation))
    }

    /// The terms of the multiple of a sum that is computed.
    fn written_terms(&self, writer: &Writer<'g>, sum: usize) -> Vec<common::Term> {
        let terms = self.sums[sum].terms.iter().enumerate();
        let written = terms.map(|(index, term)| {
            let coefficient: Multiple<'g> = self.coefficient(TermId { sum, term: index });
            let coefficient = coefficient.over(self.sums[sum].multiple).exact.edge();
            common::Term {
                coefficient,
                node: term.node.map(|node| writer.stored(node)),
                operands: term.node.and_then(|node| self.operands(writer, node)),
            }
        });
        written.collect()
    }

    /// A product that one node alone reads, as the nodes that are computed in the place of its operands.
    fn operands(&self, writer: &Writer<'g>, node: NodeId) -> Option<[Edge; 2]> {
        let network = self.network;
        if network.readers(node) > 1 || network.is_free(node) {
            return None;
        }
        let operation = network.definition(node);
        let Operation::Mul(a, b) = operation else {
            return None;
        };
        let is_flipped = network.graph().is_flipped(node, operation);
        let [a, b] = [a, b].map(|id| writer.stored(id));
        let is_linear = is_linear(network, node);
        (!is_linear).then(|| [a.negate_if(is_flipped), b])
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
