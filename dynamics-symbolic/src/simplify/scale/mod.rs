//! The choice of the multiple of each sum that is computed.
//!
//! A sum c1 x1 + c2 x2 + ... with constant coefficients may be computed as any multiple of itself: the multiple passes
//! through products for nothing and is made good in the coefficients of the sums that read it, or at an output. As
//! x1 + (c2/c1) x2 + ..., the sum takes one multiplication less, and none is added if its readers multiply by a constant
//! anyway. The multiples are chosen one by one for as long as coefficients become 1.

mod common;
mod cost;
mod descent;
mod multiple;
mod rewrite;
mod terms;

use super::{Judge, Network};
use crate::expr::{Graph, NodeId};
use multiple::Multiple;
use terms::{Factor, Sum};

/// The sums of a network, each with the multiple of it that is computed.
struct Scaling<'n, 'g> {
    network: &'n Network<'g>,
    sums: Vec<Sum<'g>>,
    /// The sum that a node is, by the index of the node.
    sum_of: Vec<Option<usize>>,
    /// About what the constants among the leaves are, by the index of the node.
    constants: Vec<f64>,
    /// Outputs that are products of sums: the factors of their multiple.
    products: Vec<Vec<Factor>>,
    one: Multiple<'g>,
    /// The sums that no other multiple improves, as long as nothing they meet changes.
    settled: Vec<bool>,
}

/// Chooses the multiples, and rewrites the network where that saves operations and keeps the errors
/// of the outputs within what is allowed.
pub(super) fn rescale<'g>(network: &mut Network<'g>, judge: &mut Judge<'g>) {
    let order = network.order();
    let graph: &Graph = network.graph();
    let Some(mut scaling) = Scaling::new(network, &order, judge) else {
        return;
    };
    scaling.descend();
    let (definitions, held) = scaling.rewrite(&order);
    let rewritten = Network::with_definitions(graph, network.outputs(), definitions, &held);
    if rewritten.cost() < network.cost() && judge.accepts_all(&rewritten, network) {
        *network = rewritten;
    }
}

impl<'n, 'g> Scaling<'n, 'g> {
    /// The sums as they are. `None` where a constant has no inverse fingerprint.
    fn new(network: &'n Network<'g>, order: &[NodeId], judge: &mut Judge<'g>) -> Option<Self> {
        let graph = network.graph();
        let mut constants = vec![f64::NAN; graph.len()];
        for id in network.leaves() {
            if network.is_constant(id) {
                constants[id.index()] = judge.constant(id);
            }
        }
        let mut scaling = Scaling {
            network,
            sums: Vec::new(),
            sum_of: vec![None; graph.len()],
            constants,
            products: Vec::new(),
            one: Multiple::new(graph.one(), 1.0)?,
            settled: Vec::new(),
        };
        scaling.collect(order)?;
        scaling.connect();
        scaling.settled = vec![false; scaling.sums.len()];
        Some(scaling)
    }
}
