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
    pub const DEFAULT: Effort = Effort {
        lookups: 1_000_000,
        pairs: 300,
    };
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::{Expr, Graph, Level, Operation};
    use crate::program::Program;
    use crate::robot::Symbol;

    fn program(graph: &Graph, network: &Network<'_>, symbols: usize) -> Program {
        let meanings: Vec<_> = (0..symbols).map(Symbol::Position).collect();
        Program::new(graph, &meanings, network.outputs(), &|id| {
            network.definition(id)
        })
    }

    fn simplified(graph: &Graph, outputs: &[Expr<'_>], symbols: usize) -> Program {
        let outputs: Vec<_> = outputs.iter().map(|e| e.edge()).collect();
        let mut network = Network::new(graph, &outputs);
        simplify(&mut network, Effort::DEFAULT);
        program(graph, &network, symbols)
    }

    #[test]
    fn a_common_factor_is_taken_out() {
        let graph = Graph::new();
        let [x, y, z] = [(); 3].map(|()| graph.symbol(Level::Variable));
        let program = simplified(&graph, &[x + y, x * z + y * z], 3);
        assert_eq!(program.operations().total(), 2);
    }

    #[test]
    fn a_difference_of_squares_is_a_product_where_its_factors_are_there() {
        let graph = Graph::new();
        let [x, y] = [(); 2].map(|()| graph.symbol(Level::Variable));
        let program = simplified(&graph, &[x + y, x - y, x * x - y * y], 2);
        assert_eq!(program.operations().total(), 3);
    }

    #[test]
    fn constants_move_to_where_they_merge() {
        let graph = Graph::new();
        let [x, y, z, w] = [(); 4].map(|()| graph.symbol(Level::Variable));
        let three = graph.rational(&crate::exact::Rational::from(3));
        let third = graph.one() / three;
        // (3 x y + 3 z w) / 3
        let sum = (three * x) * y + (three * z) * w;
        let program = simplified(&graph, &[third * sum * x], 4);
        assert_eq!(program.operations().multiplications, 3);
    }

    /// A wrong simplification, on purpose: the proof is what must notice.
    #[test]
    fn a_wrong_definition_changes_what_the_program_computes() {
        let graph = Graph::new();
        let [x, y, z] = [(); 3].map(|()| graph.symbol(Level::Variable));
        let output = (x * y + z) * x;
        let mut network = Network::new(&graph, &[output.edge()]);
        let sound = program(&graph, &network, 3);
        let sum = (x * y + z).edge().node();
        let Operation::Add(a, b) = network.definition(sum) else {
            panic!("a sum")
        };
        network.redefine(sum, Operation::Add(a, -b));
        let damaged = program(&graph, &network, 3);
        assert_ne!(sound.instructions, damaged.instructions);
    }
}
