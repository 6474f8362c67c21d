//! Operations whose results cancel in every output.
//!
//! Where x y is subtracted in one sum and added in a multiple of another one, no single node shows it. The
//! derivatives of the outputs by every node do, found in one pass backwards (adjoints: A. Griewank,
//! A. Walther, Evaluating Derivatives, 2008, section 3.2): a node by which all derivatives are zero may have
//! any value, zero among them.

use super::{Judge, Network, Writer};
use crate::exact::SplitMix64;
use crate::expr::{Edge, Fingerprint, NodeId, Operation};

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
        writer.stored[id.index()] = Some(match cancels(id) {
            true => NodeId::ZERO.edge(false),
            false => rewritten(network, &mut writer, id),
        });
    }
    let mut outputs = network.outputs().iter().map(|output| output.node());
    let same = outputs.all(|id| writer.stored(id) == id.edge(false));
    let held = order.iter().filter(|id| fixed[id.index()]);
    let held: Vec<_> = held.map(|&id| writer.stored(id).node()).collect();
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
        add(
            &mut adjoints,
            output.node(),
            Fingerprint::random(&mut random),
        );
    }
    for &id in order.iter().rev() {
        let own = adjoints[id.index()];
        match network.definition(id) {
            Operation::Rational(_) | Operation::Symbol(_) => {}
            Operation::Add(a, b) => {
                for edge in [a, b] {
                    let share = if edge.is_negative() { -own } else { own };
                    add(&mut adjoints, edge.node(), share);
                }
            }
            Operation::Mul(a, b) => {
                let own = if network.is_flipped(id, a, b) {
                    -own
                } else {
                    own
                };
                add(&mut adjoints, a, own * network.value(b));
                add(&mut adjoints, b, own * network.value(a));
            }
            // y = +-a / b: dy/da = +-1 / b, dy/db = -y / b
            Operation::Div(a, b) => {
                let inverse = network.inverse(b).unwrap_or(Fingerprint::ONE);
                let by_divisor = own * network.value(id) * inverse;
                let own = if network.is_flipped_quotient(id, a, b) {
                    -own
                } else {
                    own
                };
                add(&mut adjoints, a, own * inverse);
                add(&mut adjoints, b, -by_divisor);
            }
        }
    }
    adjoints
}

/// A node on what is computed in the place of those that it reads.
fn rewritten(network: &Network<'_>, writer: &mut Writer<'_>, id: NodeId) -> Edge {
    let zero = NodeId::ZERO;
    match network.definition(id) {
        Operation::Add(a, b) => {
            let [a, b] = [a, b].map(|edge| {
                let stored = writer.stored(edge.node());
                stored.negate_if(edge.is_negative())
            });
            match (a.node() == zero, b.node() == zero) {
                (true, _) => b,
                (_, true) => a,
                _ => writer.add(a, b),
            }
        }
        Operation::Mul(a, b) => {
            let flipped = network.is_flipped(id, a, b);
            let [a, b] = [a, b].map(|id| writer.stored(id));
            match a.node() == zero || b.node() == zero {
                true => zero.edge(false),
                false => writer.mul(a, b).negate_if(flipped),
            }
        }
        Operation::Div(a, b) => {
            let flipped = network.is_flipped_quotient(id, a, b);
            let [a, b] = [a, b].map(|id| writer.stored(id));
            match a.node() == zero {
                true => zero.edge(false),
                false => writer.div(a, b).negate_if(flipped),
            }
        }
        Operation::Rational(_) | Operation::Symbol(_) => id.edge(false),
    }
}
