//! A node as one operation on two others that are there anyway.

use super::Network;
use crate::expr::{Fingerprint, FingerprintMap, NodeId, Operation};

/// Redefines every node that one operation on other active nodes can replace
/// with fewer operations in all.
pub(super) fn resubstitute(network: &mut Network<'_>, left: &mut usize) {
    for id in network.order() {
        if !network.is_active(id) || network.cone(id) < 2 {
            continue;
        }
        let order = network.order();
        let mut candidates = network.leaves();
        candidates.extend(&order);
        if *left < 3 * candidates.len() {
            *left = 0;
            return;
        }
        *left -= 3 * candidates.len();
        let depends = network.dependents(id, &order);
        candidates.retain(|other| !depends[other.index()]);
        let index = network.index(&candidates);
        let mut best = (network.cost(), network.definition(id));
        let old = best.1;
        for operation in single_operations(network, id, &candidates, &index) {
            network.redefine(id, operation);
            if network.cost() < best.0 {
                best = (network.cost(), operation);
            }
            network.redefine(id, old);
        }
        if best.1 != old {
            network.redefine(id, best.1);
        }
    }
}

/// The smaller of the representatives of a value and its opposite, and whether that is the opposite.
pub(super) fn canonical(value: Fingerprint) -> (Fingerprint, bool) {
    let opposite = -value;
    if opposite.get() < value.get() {
        (opposite, true)
    } else {
        (value, false)
    }
}

/// The node of a value among the candidates, with the sign that gives the value.
fn find(index: &FingerprintMap<NodeId>, value: Fingerprint) -> Option<(NodeId, bool)> {
    let (canonical, negative) = canonical(value);
    index.get(&canonical.get()).map(|&id| (id, negative))
}

/// All sums and products of two candidates that equal a node.
fn single_operations(
    network: &Network<'_>,
    id: NodeId,
    candidates: &[NodeId],
    index: &FingerprintMap<NodeId>,
) -> Vec<Operation> {
    let target = network.value(id);
    let mut found = Vec::new();
    for &a in candidates {
        let value = network.value(a);
        for negative in [false, true] {
            let rest = if negative {
                target + value
            } else {
                target - value
            };
            if let Some((b, sign)) = find(index, rest)
                && b >= a
            {
                found.push(Operation::Add(a.edge(negative), b.edge(sign)));
            }
        }
        // n = a b, asked as: is a b = n for the b of value n / a.
        if let Some(inverse) = network.inverse(a)
            && let Some((b, _)) = find(index, target * inverse)
            && b >= a
        {
            found.push(Operation::Mul(a, b));
        }
    }
    found
}
