//! Another network for the same outputs, written node by node.

use crate::expr::{Edge, Graph, NodeId, Operation};

/// Writes operations on the graph exactly as they are given, and keeps them as definitions.
pub(super) struct Writer<'g> {
    graph: &'g Graph,
    pub(super) definitions: Vec<(NodeId, Operation)>,
    /// What is computed in the place of each node, by its index.
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

    /// What is computed in the place of a node.
    pub(super) fn stored(&self, node: NodeId) -> Edge {
        let stored = self.stored.get(node.index()).copied().flatten();
        stored.unwrap_or(node.edge(false))
    }

    fn keep(&mut self, (edge, operation): (Edge, Operation)) -> Edge {
        self.definitions.push((edge.node(), operation));
        edge
    }

    pub(super) fn scaled(&mut self, coefficient: Edge, edge: Edge) -> Edge {
        let one = self.graph.one().edge();
        if coefficient.node() == one.node() {
            return edge.negate_if(coefficient.is_negative());
        }
        self.mul(coefficient, edge)
    }

    pub(super) fn add(&mut self, a: Edge, b: Edge) -> Edge {
        let written = self.graph.write_sum(a, b);
        self.keep(written)
    }

    pub(super) fn mul(&mut self, a: Edge, b: Edge) -> Edge {
        let written = self.graph.write_product(a, b);
        self.keep(written)
    }

    pub(super) fn div(&mut self, a: Edge, b: Edge) -> Edge {
        let written = self.graph.write_quotient(a, b);
        self.keep(written)
    }
}
