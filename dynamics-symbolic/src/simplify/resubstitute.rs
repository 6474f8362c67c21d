//! A node as one operation on two others that are there anyway.

use super::Network;
use super::survey::{Dependents, Survey, find};
use crate::expr::{NodeId, Operation};

/// Redefines every node that one operation on other active nodes can replace
/// with fewer operations in all.
pub(super) fn resubstitute(network: &mut Network<'_>, left: &mut usize) {
    let mut survey = Survey::new(network);
    let window = (*left / (6 * survey.order().len().max(1))).max(NARROWEST);
    for id in survey.order().to_vec() {
        if !network.is_active(id) || network.cone(id) < 2 {
            continue;
        }
        let dependents = survey.dependents(id);
        let candidates = survey.candidates(network, &dependents, window);
        *left = left.saturating_sub(3 * candidates.len());
        if *left == 0 {
            return;
        }
        let old = network.definition(id);
        let mut best = (network.cost(), old);
        for operation in single_operations(network, &survey, &dependents, id, &candidates) {
            network.redefine(id, operation);
            if network.cost() < best.0 {
                best = (network.cost(), operation);
            }
            network.redefine(id, old);
        }
        if best.1 != old {
            network.redefine(id, best.1);
            survey = Survey::new(network);
        }
    }
}

/// In a long program, a node is compared with as many nodes before it, at least.
const NARROWEST: usize = 40;

/// All sums and products of a candidate and another active node that equal a node.
fn single_operations(
    network: &Network<'_>,
    survey: &Survey,
    dependents: &Dependents,
    id: NodeId,
    candidates: &[NodeId],
) -> Vec<Operation> {
    let target = network.value(id);
    let is_available = |other| survey.is_available(network, dependents, other);
    let mut found = Vec::new();
    for &a in candidates {
        let value = network.value(a);
        for negative in [false, true] {
            let rest = if negative {
                target + value
            } else {
                target - value
            };
            if let Some((b, sign)) = find(survey.index(), rest)
                && is_available(b)
            {
                found.push(Operation::Add(a.edge(negative), b.edge(sign)));
            }
        }
        // n = a b, asked as: is there a node of the value n / a.
        if let Some(inverse) = network.inverse(a)
            && let Some((b, _)) = find(survey.index(), target * inverse)
            && is_available(b)
        {
            found.push(Operation::Mul(a, b));
        }
    }
    found
}
