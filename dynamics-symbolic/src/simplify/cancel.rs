//! Operations whose results cancel in every output.
//!
//! If x y is subtracted in one sum and added in a multiple of another one, no single node shows it. The derivatives of
//! the outputs by every node do, found in one pass backwards (adjoints: A. Griewank, A. Walther, Evaluating
//! Derivatives, 2008, section 3.2): a node by which all derivatives are zero may have any value, zero among them.
//!
//! Joints that lead others are the reason: a joint about a parallel axis subtracts in one force what it adds in a
//! multiple of another, and derivatives have such pairs too.

use super::{Judge, Network, Writer};
use crate::exact::{SplitMix64, negate_if};
use crate::expr::{Fingerprint, NodeId, Operation};

/// Leaves out what cancels, as far as the errors of the outputs allow it.
pub(super) fn cancel<'g>(network: &mut Network<'g>, judge: &mut Judge<'g>) {
    if let Some(shorter) = without_what_cancels(network)
        && shorter.cost() < network.cost()
        && judge.accepts_all(&shorter, network)
    {
        *network = shorter;
    }
}

/// The network with zero for every node that cancels, if there is one and no output changes.
fn without_what_cancels<'g>(network: &Network<'g>) -> Option<Network<'g>> {
    let order = network.order();
    let fixed = network.fixed(&order);
    let adjoints = adjoints(network, &order);
    let cancels = |id: NodeId| adjoints[id.index()].is_zero() && !fixed[id.index()];
    if !order.iter().any(|&id| cancels(id)) {
        return None;
    }
    let mut writer = Writer::new(network.graph());
    for &id in &order {
        writer.stored[id.index()] = Some(if cancels(id) {
            NodeId::ZERO.edge(false)
        } else {
            writer.rewritten(id, network.definition(id))
        });
    }
    let mut outputs = network.outputs().iter().map(|output| output.node());
    let same = outputs.all(|id| writer.stored(id) == id.edge(false));
    let kept = order.iter().filter(|id| fixed[id.index()]);
    let held: Vec<_> = kept.map(|&id| writer.stored(id).node()).collect();
    let Writer { definitions, .. } = writer;
    same.then(|| Network::with_definitions(network.graph(), network.outputs(), definitions, &held))
}

/// The derivatives of a random combination of the outputs by every node, at the point of the fingerprints.
fn adjoints(network: &Network<'_>, order: &[NodeId]) -> Vec<Fingerprint> {
    let mut adjoints = vec![Fingerprint::ZERO; network.len()];
    let mut random = SplitMix64::new(1);
    let add = |adjoints: &mut Vec<Fingerprint>, id: NodeId, x: Fingerprint| {
        adjoints[id.index()] = adjoints[id.index()] + x;
    };
    for output in network.outputs() {
        let random = Fingerprint::random(&mut random);
        add(&mut adjoints, output.node(), random);
    }
    for &id in order.iter().rev() {
        let own = adjoints[id.index()];
        let operation = network.definition(id);
        let signed = negate_if(own, network.graph().is_flipped(id, operation));
        match operation {
            Operation::Rational(_) | Operation::Symbol(_) => {}
            Operation::Add(a, b) => {
                for edge in [a, b] {
                    add(
                        &mut adjoints,
                        edge.node(),
                        negate_if(own, edge.is_negative()),
                    );
                }
            }
            Operation::Mul(a, b) => {
                add(&mut adjoints, a, signed * network.value(b));
                add(&mut adjoints, b, signed * network.value(a));
            }
            // y = +-a / b: dy/da = +-1 / b, dy/db = -y / b
            Operation::Div(a, b) => {
                let inverse = network.inverse(b).unwrap_or(Fingerprint::ONE);
                add(&mut adjoints, a, signed * inverse);
                add(&mut adjoints, b, -(own * network.value(id) * inverse));
            }
        }
    }
    adjoints
}
