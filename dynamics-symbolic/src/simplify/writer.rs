//! Another network for the same outputs, written node by node.

use crate::expr::{Edge, Graph, NodeId, Operation};

/// Writes operations on the graph exactly as they are given, and keeps them as definitions.
pub(super) struct Writer<'g> {
    graph: &'g Graph,
    pub(super) definitions: Vec<(NodeId, Operation)>,
    /// The node that is computed in the place of each node, by its index.
    pub(super) stored: Vec<Option<Edge>>,
}

impl<'g> Writer<'g> {
    pub(super) fn new(graph: &'g Graph) -> Self {
        Writer {
            graph,
            definitions: Vec::new(),
            stored: vec![None; graph.len()],
        }
    }

    /// The node that is computed in the place of a node.
    pub(super) fn stored(&self, node: NodeId) -> Edge {
        let stored = self.stored.get(node.index()).copied().flatten();
        stored.unwrap_or(node.edge(false))
    }

    fn keep(&mut self, (edge, operation): (Edge, Operation)) -> Edge {
        self.definitions.push((edge.node(), operation));
        edge
    }

    pub(super) fn one(&self) -> Edge {
        self.graph.one().edge()
    }

    pub(super) fn scaled(&mut self, coefficient: Edge, edge: Edge) -> Edge {
        if coefficient.node() == self.one().node() {
            return edge.negate_if(coefficient.is_negative());
        }
        self.mul(coefficient, edge)
    }

    pub(super) fn add(&mut self, a: Edge, b: Edge) -> Edge {
        self.keep(self.graph.arena().write_sum(a, b))
    }

    pub(super) fn mul(&mut self, a: Edge, b: Edge) -> Edge {
        self.keep(self.graph.arena().write_product(a, b))
    }

    /// The operation of a node on what is computed in the place of its operands, some of which may be zero.
    pub(super) fn rewritten(&mut self, id: NodeId, operation: Operation) -> Edge {
        let is_zero = |edge: Edge| edge.node() == NodeId::ZERO;
        let flipped = self.graph.is_flipped(id, operation);
        match operation {
            Operation::Add(a, b) => {
                let signed = |edge: Edge| self.stored(edge.node()).negate_if(edge.is_negative());
                match [a, b].map(signed) {
                    [a, b] if is_zero(a) => b,
                    [a, b] if is_zero(b) => a,
                    [a, b] => self.add(a, b),
                }
            }
            Operation::Mul(a, b) => match [a, b].map(|id| self.stored(id)) {
                [a, b] if is_zero(a) || is_zero(b) => NodeId::ZERO.edge(false),
                [a, b] => self.mul(a, b).negate_if(flipped),
            },
            Operation::Div(a, b) => match [a, b].map(|id| self.stored(id)) {
                [a, _] if is_zero(a) => a,
                [a, b] => self
                    .keep(self.graph.arena().write_quotient(a, b))
                    .negate_if(flipped),
            },
            Operation::Rational(_) | Operation::Symbol(_) => id.edge(false),
        }
    }
}
