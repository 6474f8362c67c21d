//! A node as two operations on three others that are there anyway:
//! x + (y + z), x + y z, x (y + z), x y z, with any signs.

use super::survey::{Survey, canonical};
use super::{Judge, Network};
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
        let operation = self.0.get(&canonical.get())?;
        Some((*operation, negative))
    }
}

/// Redefines every node that two operations on other active nodes can replace with fewer operations in all, as far as
/// the errors of the outputs allow it. Long programs are left out: the table grows with the square of the length.
pub(super) fn resubstitute_pairs<'g>(
    network: &mut Network<'g>,
    judge: &mut Judge<'g>,
    longest: usize,
    left: &mut usize,
) {
    let mut survey = Survey::new(network);
    let nodes = survey.nodes();
    let work = 2 * nodes.len() * nodes.len();
    if nodes.len() > longest || work > *left {
        return;
    }
    *left -= work;
    let pairs = Pairs::new(network, &nodes);
    for id in survey.order().to_vec() {
        if network.is_active(id) && network.cone(id) >= 3 && *left >= 3 * nodes.len() {
            *left -= 3 * nodes.len();
            if replace(network, judge, &survey, &pairs, id) {
                survey = Survey::new(network);
            }
        }
    }
}

/// A definition of two operations: that of a node, which reads an inner node, and the inner node with its own.
type Replacement = (Operation, (NodeId, Operation));

/// Whether the node was redefined.
fn replace<'g>(
    network: &mut Network<'g>,
    judge: &mut Judge<'g>,
    survey: &Survey,
    pairs: &Pairs,
    id: NodeId,
) -> bool {
    let target = network.value(id);
    let dependents = survey.dependents(id);
    for x in survey.candidates(network, &dependents, usize::MAX) {
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
            let is_available = |other| survey.is_available(network, &dependents, other);
            if !inner_operation.operands().all(is_available) {
                continue;
            }
            let Some(inner) = network.inner_node(inner_operation) else {
                continue;
            };
            let outer = match sum_sign {
                Some(sign) => Operation::Add(x.edge(sign), inner.edge(negative)),
                None => Operation::Mul(x, inner),
            };
            let replacement = (outer, (inner, inner_operation));
            if try_replacement(network, judge, survey, id, replacement) {
                return true;
            }
        }
    }
    false
}

/// Redefines the node if that saves operations and keeps the digits.
fn try_replacement<'g>(
    network: &mut Network<'g>,
    judge: &mut Judge<'g>,
    survey: &Survey,
    id: NodeId,
    (outer, (inner, operation)): Replacement,
) -> bool {
    let before = network.cost();
    let [old, old_inner] = [id, inner].map(|id| network.definition(id));
    network.define_inactive(inner, operation);
    network.redefine(id, outer);
    let is_shorter = network.cost() < before;
    let is_taken = is_shorter && judge.accepts(network, survey, &[inner, id]);
    if !is_taken {
        network.redefine(id, old);
        network.define_inactive(inner, old_inner);
    }
    is_taken
}

impl Network<'_> {
    /// The node of an operation, where it is not active yet, takes an operation and is not held.
    fn inner_node(&mut self, operation: Operation) -> Option<NodeId> {
        let graph = self.graph();
        let edge: Edge = match operation {
            Operation::Add(a, b) => graph.arena().add(a, b),
            Operation::Mul(a, b) => graph.arena().mul(a.edge(false), b.edge(false)),
            _ => return None,
        };
        self.grow();
        let id = edge.node();
        (!self.is_active(id) && !self.is_free(id) && !self.is_held(id)).then_some(id)
    }
}
