//! A node as two operations on three others that are there anyway:
//! x + (y + z), x + y z, x (y + z), x y z, with any signs.

use super::Network;
use super::resubstitute::canonical;
use crate::expr::{Edge, Fingerprint, FingerprintMap, NodeId, Operation};

/// The sums and products of all pairs of some nodes, by value.
struct Pairs(FingerprintMap<Operation>);

impl Pairs {
    fn new(network: &Network<'_>, nodes: &[NodeId]) -> Self {
        let mut pairs = FingerprintMap::default();
        for (count, &a) in nodes.iter().enumerate() {
            let x = network.value(a);
            for &b in &nodes[..=count] {
                if network.is_constant(a) && network.is_constant(b) {
                    continue;
                }
                let y = network.value(b);
                pairs
                    .entry(canonical(x * y).0.get())
                    .or_insert(Operation::Mul(a, b));
                for b_negative in [false, true] {
                    let sum = if b_negative { x - y } else { x + y };
                    // A node's own value is the canonical one: -(a + b) is -a - b.
                    let (value, negative) = canonical(sum);
                    let sum = Operation::Add(a.edge(negative), b.edge(b_negative != negative));
                    if !value.is_zero() {
                        pairs.entry(value.get()).or_insert(sum);
                    }
                }
            }
        }
        Pairs(pairs)
    }

    /// The pair of a value, and the sign that gives the value.
    fn find(&self, value: Fingerprint) -> Option<(Operation, bool)> {
        let (canonical, negative) = canonical(value);
        self.0
            .get(&canonical.get())
            .map(|&operation| (operation, negative))
    }
}

/// Redefines every node that two operations on other active nodes can replace
/// with fewer operations in all.
pub(super) fn resubstitute_pairs(network: &mut Network<'_>, left: &mut usize) {
    let order = network.order();
    let mut nodes = network.leaves();
    nodes.extend(&order);
    let work = 2 * nodes.len() * nodes.len();
    if work > *left {
        return;
    }
    *left -= work;
    let pairs = Pairs::new(network, &nodes);
    for id in order {
        if network.is_active(id) && network.cone(id) >= 3 && *left >= 3 * nodes.len() {
            *left -= 3 * nodes.len();
            replace(network, &pairs, id);
        }
    }
}

/// A definition of two operations: the outer one reads the inner one's node.
struct Replacement {
    outer: Operation,
    inner: NodeId,
    inner_operation: Operation,
}

fn replace(network: &mut Network<'_>, pairs: &Pairs, id: NodeId) {
    let order = network.order();
    let depends = network.dependents(id, &order);
    let is_available = |network: &Network<'_>, other: NodeId| {
        network.is_active(other) && !depends.get(other.index()).is_some_and(|&depends| depends)
    };
    let mut candidates = network.leaves();
    candidates.extend(order);
    candidates.retain(|&other| is_available(network, other));
    let target = network.value(id);
    for x in candidates {
        let value = network.value(x);
        let product = network.inverse(x).map(|inverse| target * inverse);
        let questions = [
            (Some(target - value), Some(false)),
            (Some(target + value), Some(true)),
            (product, None),
        ];
        for (rest, sum_sign) in questions {
            let Some((inner_operation, negative)) = rest.and_then(|rest| pairs.find(rest)) else {
                continue;
            };
            if !inner_operation
                .operands()
                .all(|operand| is_available(network, operand))
            {
                continue;
            }
            let Some(inner) = network.inner_node(inner_operation) else {
                continue;
            };
            let outer = match sum_sign {
                Some(sign) => Operation::Add(x.edge(sign), inner.edge(negative)),
                None => Operation::Mul(x, inner),
            };
            try_replacement(
                network,
                id,
                &Replacement {
                    outer,
                    inner,
                    inner_operation,
                },
            );
        }
    }
}

/// Redefines the node if that saves operations.
fn try_replacement(network: &mut Network<'_>, id: NodeId, replacement: &Replacement) {
    let before = network.cost();
    let old = network.definition(id);
    let old_inner = network.definition(replacement.inner);
    network.define_inactive(replacement.inner, replacement.inner_operation);
    network.redefine(id, replacement.outer);
    if network.cost() >= before {
        network.redefine(id, old);
        network.define_inactive(replacement.inner, old_inner);
    }
}

impl Network<'_> {
    /// The node of an operation, where it is not active yet and takes an operation.
    fn inner_node(&mut self, operation: Operation) -> Option<NodeId> {
        let graph = self.graph();
        let edge: Edge = match operation {
            Operation::Add(a, b) => graph.add(a, b),
            Operation::Mul(a, b) => graph.mul(a.edge(false), b.edge(false)),
            _ => return None,
        };
        self.grow();
        let id = edge.node();
        (!self.is_active(id) && !self.is_free(id)).then_some(id)
    }
}
