//! The operations of the graph.

use super::{Edge, NodeId};

/// The operation of a node. Negation is no operation: an [`Edge`] carries a sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Operation {
    /// The rational number of that index in the graph's table.
    Rational(u32),
    /// A symbol: a number whose value is not known to the graph.
    Symbol(u32),
    /// The sum of two edges.
    Add(Edge, Edge),
    /// The product of two nodes.
    Mul(NodeId, NodeId),
    /// The quotient of two nodes.
    Div(NodeId, NodeId),
}

impl Operation {
    /// The nodes that the operation reads.
    pub fn operands(self) -> impl Iterator<Item = NodeId> {
        let (first, second) = match self {
            Operation::Rational(_) | Operation::Symbol(_) => (None, None),
            Operation::Add(a, b) => (Some(a.node()), Some(b.node())),
            Operation::Mul(a, b) | Operation::Div(a, b) => (Some(a), Some(b)),
        };
        first.into_iter().chain(second)
    }
}
