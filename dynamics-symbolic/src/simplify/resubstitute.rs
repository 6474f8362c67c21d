//! A node as one operation on two others that are there anyway.
//!
//! A redefinition reads other nodes of equal value. Forward dynamics must not allow that in the steps that solve for
//! accelerations (`Graph::holding`): where M is nearly singular all accelerations are wrong in many digits, but
//! together they satisfy the equations to rounding, as the result of any elimination does. An equal definition that
//! reads other nodes, such as (tau1 + tau2) / I for a joint that feels the sum, loses this property: torques were
//! wrong by up to 9e-9 among 1,500 random arms. Holding the definitions costs nothing for most arms and two
//! operations for the UR5. `tests/suite/residuals` measures the residuals.

use super::survey::{Dependents, Survey};
use super::{Judge, Network};
use crate::exact::negate_if;
use crate::expr::{NodeId, Operation};

/// Redefines every node that one operation on other active nodes can replace
/// with fewer operations in all, as far as the errors of the outputs allow it.
pub(super) fn resubstitute<'g>(network: &mut Network<'g>, judge: &mut Judge<'g>, left: &mut usize) {
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
        let cost = network.cost();
        let mut shorter = Vec::new();
        for operation in single_operations(network, &survey, &dependents, id, &candidates) {
            network.redefine(id, operation);
            if network.cost() < cost {
                shorter.push((network.cost(), operation));
            }
            network.redefine(id, old);
        }
        shorter.sort_by_key(|(cost, _)| *cost);
        for (_, operation) in shorter.into_iter().take(MOST_JUDGED) {
            network.redefine(id, operation);
            if judge.accepts(network, &survey, &[id]) {
                survey = Survey::new(network);
                break;
            }
            network.redefine(id, old);
        }
    }
}

/// How many definitions of one node are judged by their errors, the shortest first.
const MOST_JUDGED: usize = 4;

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
            let rest = target - negate_if(value, negative);
            if let Some((b, sign)) = survey.find(rest)
                && is_available(b)
            {
                found.push(Operation::Add(a.edge(negative), b.edge(sign)));
            }
        }
        // n = a b, asked as: is there a node of the value n / a.
        if let Some(inverse) = network.inverse(a)
            && let Some((b, _)) = survey.find(target * inverse)
            && is_available(b)
        {
            found.push(Operation::Mul(a, b));
        }
    }
    found
}
