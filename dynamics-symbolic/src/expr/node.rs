//! Nodes, and edges to them.

/// The index of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct NodeId(u32);

impl NodeId {
    /// The number 0, the first node of every graph.
    pub(crate) const ZERO: NodeId = NodeId(0);
    /// The number 1, the second one.
    pub(super) const ONE: NodeId = NodeId(1);

    /// The index as a number.
    pub fn index(self) -> usize {
        self.0 as usize
    }

    /// The node of that index.
    pub(crate) fn from_index(index: usize) -> Self {
        NodeId(u32::try_from(index).expect("fewer than 2^31 nodes"))
    }

    /// The node itself, or minus the node.
    pub fn edge(self, negative: bool) -> Edge {
        Edge(self.0 << 1 | negative as u32)
    }
}

/// A node with a sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Edge(u32);

impl Edge {
    /// The node without the sign.
    pub fn node(self) -> NodeId {
        NodeId(self.0 >> 1)
    }

    /// Whether the edge stands for minus its node.
    pub fn is_negative(self) -> bool {
        self.0 & 1 == 1
    }

    /// Minus this edge where `negate` holds, else this edge.
    pub fn negate_if(self, negate: bool) -> Edge {
        Edge(self.0 ^ negate as u32)
    }
}

impl core::ops::Neg for Edge {
    type Output = Edge;

    fn neg(self) -> Edge {
        self.negate_if(true)
    }
}

/// The kind of symbols that an expression depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Level {
    /// Known at compile time: evaluated exactly, rounded once.
    Constant,
    /// Depends on parameters only.
    Parameter,
    /// Depends on variables.
    Variable,
}
