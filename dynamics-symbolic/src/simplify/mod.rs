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
mod survey;

pub use network::Network;

/// How much work the search for shorter programs may do.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Look-ups of values in all.
    pub lookups: usize,
    /// The longest program, in nodes, whose pairs are tabulated: the table grows with its square.
    pub pairs: usize,
}

impl Effort {
    /// Fractions of a second for six joints where the engine runs unoptimised.
    pub const DEFAULT: Effort = Effort { lookups: 3_000_000, pairs: 300 };
}

/// Shortens a network until nothing is found, or the effort is spent.
pub fn simplify(network: &mut Network<'_>, effort: Effort) {
    let mut left = effort.lookups;
    loop {
        shorten(network, &mut left);
        let before = network.cost();
        pairs::resubstitute_pairs(network, effort.pairs, &mut left);
        if network.cost() == before {
            return;
        }
    }
}

fn shorten(network: &mut Network<'_>, left: &mut usize) {
    loop {
        let before = network.cost();
        resubstitute::resubstitute(network, left);
        scale::rescale(network);
        if network.cost() == before || *left == 0 {
            return;
        }
    }
}
