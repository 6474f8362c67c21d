//! The network with the multiples that were chosen.

use super::Scaling;
use super::terms::TermId;
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
        let held = fixed.filter_map(|id| writer.stored[id.index()]);
        let held = held.map(Edge::node).collect();
        (writer.definitions, held)
    }

    /// What is computed in the place of a node: nothing where a sum has absorbed it.
    fn write_node(&self, writer: &mut Writer<'g>, id: NodeId) -> Option<Edge> {
        if let Some(sum) = self.sum_of[id.index()] {
            return Some(self.write_sum(writer, sum));
        }
        match self.network.definition(id) {
            Operation::Mul(a, b)
                if !self.network.is_constant(a) && !self.network.is_constant(b) =>
            {
                let flipped = self.network.is_flipped(id, a, b);
                let (a, b) = (writer.stored(a), writer.stored(b));
                Some(writer.mul(a, b).negate_if(flipped))
            }
            Operation::Div(a, b) => {
                let flipped = self.network.is_flipped_quotient(id, a, b);
                let (a, b) = (writer.stored(a), writer.stored(b));
                Some(writer.div(a, b).negate_if(flipped))
            }
            _ => None,
        }
    }

    fn write_sum(&self, writer: &mut Writer<'g>, sum: usize) -> Edge {
        let mut total: Option<Edge> = None;
        for (index, term) in self.sums[sum].terms.iter().enumerate() {
            let coefficient = self
                .exact_coefficient(TermId { sum, term: index })
                .over(self.sums[sum].multiple)
                .exact
                .edge();
            let term = match term.node {
                None => coefficient,
                Some(node) => writer.scaled(coefficient, writer.stored(node)),
            };
            total = Some(match total {
                None => term,
                Some(total) => writer.add(total, term),
            });
        }
        total.expect("a sum is not zero: a term remains")
    }

    /// Undoes the multiple of an output.
    fn correct(&self, writer: &mut Writer<'g>, output: NodeId) {
        let multiple = match self.sum_of[output.index()] {
            Some(sum) => self.sums[sum].multiple,
            None => self.exact_product(&self.factors(output)),
        };
        if !self.network.is_free(output) {
            writer.scaled(multiple.exact.edge(), writer.stored(output));
        }
    }
}
