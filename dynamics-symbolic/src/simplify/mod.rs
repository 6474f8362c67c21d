//! Shorter programs for the same outputs.
//!
//! Nodes of the graph are known by their value in a prime field. That makes
//! one question cheap which rewriting rules can only approach: is this node
//! the sum, difference or product of two others that the program computes
//! anyway? Where the answer is yes and the node's present definition takes
//! more operations that nothing else needs, the definition is replaced
//! (resubstitution, as in the synthesis of logic circuits).

mod network;
mod pairs;
mod resubstitute;
mod scale;

pub use network::Network;

/// How much work the search for shorter programs may do, in look-ups.
#[derive(Clone, Copy, Debug)]
pub struct Effort(pub usize);

/// Shortens a network until nothing is found, or the effort is spent.
pub fn simplify(network: &mut Network<'_>, effort: Effort) {
    let mut left = effort.0;
    loop {
        let before = network.cost();
        resubstitute::resubstitute(network, &mut left);
        pairs::resubstitute_pairs(network, &mut left);
        scale::rescale(network);
        if network.cost() == before || left == 0 {
            return;
        }
    }
}
