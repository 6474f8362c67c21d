//! The active nodes of a network in their order, and by value.

use super::Network;
use crate::exact::negate_if;
use crate::expr::{Fingerprint, FingerprintMap, NodeId};
use core::cell::RefCell;

/// A look at a network: valid until a definition changes. Nodes that are held, and nodes that read these, are
/// left out.
pub(super) struct Survey {
    /// Every active node that takes an operation, operands before readers.
    whole: Vec<NodeId>,
    order: Vec<NodeId>,
    leaves: Vec<NodeId>,
    /// The place of each node in the order, from 1; leaves are at 0.
    positions: Vec<u32>,
    index: ByValue,
}

impl Survey {
    pub(super) fn new(network: &Network<'_>) -> Self {
        let (mut order, leaves) = (network.order(), network.leaves());
        let fixed = network.fixed(&order);
        let whole = order.clone();
        order.retain(|id| !fixed[id.index()]);
        let mut positions = vec![0; network.len()];
        for (position, id) in order.iter().enumerate() {
            positions[id.index()] = position as u32 + 1;
        }
        let nodes = order.iter().chain(&leaves);
        let index = ByValue::new(nodes.map(|&id| (network.value(id), id)).collect());
        Survey {
            whole,
            order,
            leaves,
            positions,
            index,
        }
    }

    /// Active nodes that take an operation and may be redefined, operands before readers.
    pub(super) fn order(&self) -> &[NodeId] {
        &self.order
    }

    /// The nodes that come after a node, among them all that depend on it; what is held too.
    pub(super) fn readers_after(&self, id: NodeId) -> &[NodeId] {
        let place = self.whole.iter().position(|&other| other == id);
        place.map_or(&[], |place| &self.whole[place + 1..])
    }

    /// The node of a value, with the sign that gives the value.
    pub(super) fn find(&self, value: Fingerprint) -> Option<(NodeId, bool)> {
        self.index.find(value)
    }

    /// Every active node that a definition may read.
    pub(super) fn nodes(&self) -> Vec<NodeId> {
        self.leaves.iter().chain(&self.order).copied().collect()
    }

    /// The nodes that depend on a node, itself included: what its definition may not read.
    pub(super) fn dependents(&self, id: NodeId) -> Dependents {
        Dependents {
            first: self.positions[id.index()] as usize,
            depends: RefCell::new(vec![true]),
        }
    }

    /// Whether the node at a position is one of some dependents. They are found as
    /// far as they are requested: most questions are about nodes nearby.
    fn depends(&self, network: &Network<'_>, dependents: &Dependents, position: usize) -> bool {
        let Some(place) = position.checked_sub(dependents.first) else {
            return false;
        };
        let mut depends = dependents.depends.borrow_mut();
        for &node in &self.order[(dependents.first + depends.len() - 1).min(position)..position] {
            let reads = network.definition(node).operands().any(|operand| {
                let place = self.position(operand).checked_sub(dependents.first);
                place.is_some_and(|place| depends[place])
            });
            depends.push(reads);
        }
        depends[place]
    }

    fn position(&self, id: NodeId) -> usize {
        let position = self.positions.get(id.index());
        position.map_or(0, |&position| position as usize)
    }

    /// Whether a definition of the node of some dependents may read a node.
    pub(super) fn is_available(
        &self,
        network: &Network<'_>,
        dependents: &Dependents,
        id: NodeId,
    ) -> bool {
        network.is_active(id) && !self.depends(network, dependents, self.position(id))
    }

    /// The leaves, and up to `window` nodes before and after the node of some
    /// dependents, as far as its definition may read them.
    pub(super) fn candidates(
        &self,
        network: &Network<'_>,
        dependents: &Dependents,
        window: usize,
    ) -> Vec<NodeId> {
        let position = dependents.first - 1;
        let from = position.saturating_sub(window);
        let to = position.saturating_add(window).min(self.order.len());
        let near = self.order[from..to]
            .iter()
            .filter(|&&id| self.is_available(network, dependents, id));
        self.leaves.iter().chain(near).copied().collect()
    }
}

/// Whether the nodes from a node on depend on it, as far as that is known.
pub(super) struct Dependents {
    first: usize,
    depends: RefCell<Vec<bool>>,
}

/// The smaller of the representatives of a value and its opposite, and whether that is the opposite.
pub(super) fn canonical(value: Fingerprint) -> (Fingerprint, bool) {
    let is_opposite = (-value).get() < value.get();
    (negate_if(value, is_opposite), is_opposite)
}

/// Nodes by value. Nine of ten values that are looked up belong to no node; most of these are recognised by
/// their last bits, without a look into the map.
struct ByValue {
    /// Whether some value, or its opposite, has these last bits.
    last_bits: Vec<bool>,
    nodes: FingerprintMap<NodeId>,
}

impl ByValue {
    fn new(nodes: Vec<(Fingerprint, NodeId)>) -> Self {
        let mut last_bits = vec![false; (32 * nodes.len()).next_power_of_two()];
        let mask = last_bits.len() - 1;
        for (value, _) in &nodes {
            for value in [*value, -*value] {
                last_bits[value.get() as usize & mask] = true;
            }
        }
        let nodes = nodes.into_iter().map(|(value, id)| (value.get(), id));
        ByValue {
            last_bits,
            nodes: nodes.collect(),
        }
    }

    fn find(&self, value: Fingerprint) -> Option<(NodeId, bool)> {
        if !self.last_bits[value.get() as usize & (self.last_bits.len() - 1)] {
            return None;
        }
        let (canonical, negative) = canonical(value);
        let node = self.nodes.get(&canonical.get());
        node.map(|&id| (id, negative))
    }
}
