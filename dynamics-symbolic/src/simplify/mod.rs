//! Shorter programs for the same outputs.
//!
//! Nodes of the graph are known by their value in a prime field. So it is cheap to ask whether a node is the sum,
//! difference or product of two others that the program computes anyway. If its present definition takes more
//! operations, which nothing else needs, that is replaced (resubstitution, as in the synthesis of logic circuits).

mod cancel;
mod judge;
mod network;
mod pairs;
mod resubstitute;
mod scale;
mod survey;
mod writer;

pub use judge::Judge;
pub use network::Network;
use writer::Writer;

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

/// Shortens a network until nothing is found, or the effort is spent. No definition is taken by which
/// an output's error exceeds what the judge allows.
pub fn simplify<'g>(network: &mut Network<'g>, judge: &mut Judge<'g>, effort: Effort) {
    let mut left = effort.lookups;
    loop {
        shorten(network, judge, &mut left);
        let before = network.cost();
        pairs::resubstitute_pairs(network, judge, effort.pairs, &mut left);
        if network.cost() == before {
            return;
        }
    }
}

/// Shortens each group of outputs that have no variable in common with others by itself, each with that effort.
pub fn simplify_apart<'g>(network: &mut Network<'g>, judge: &mut Judge<'g>, effort: Effort) {
    let mut parts = network.apart();
    for part in &mut parts {
        simplify(part, judge, effort);
    }
    network.join(&parts);
}

fn shorten<'g>(network: &mut Network<'g>, judge: &mut Judge<'g>, left: &mut usize) {
    // Whatever changes a network makes it shorter: one of this cost was rescaled in vain.
    let mut scaled = None;
    loop {
        let before = network.cost();
        cancel::cancel(network, judge);
        resubstitute::resubstitute(network, judge, left);
        let unscaled = network.cost();
        if scaled != Some(unscaled) {
            scale::rescale(network, judge);
            scaled = (network.cost() == unscaled).then_some(unscaled);
        }
        if network.cost() == before || *left == 0 {
            return;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::{Edge, Expr, Graph, Level, Operation};
    use crate::program::Program;
    use crate::robot::Symbol;
    use crate::rounding::{Bounded, POINTS, Rounded, Running, UNIT};

    fn meanings(symbols: usize) -> Vec<Symbol> {
        (0..symbols).map(Symbol::Position).collect()
    }

    /// Shortens the program of some outputs; no output may have an error above `allowed` where symbol i is `value(i)`.
    fn judged(graph: &Graph, outputs: &[Expr<'_>], values: &[f64], allowed: f64) -> Program {
        let outputs: Vec<Edge> = outputs.iter().map(|e| e.edge()).collect();
        let mut network = Network::new(graph, &outputs);
        let meanings = meanings(values.len());
        let running = Running::new(graph, &meanings, |_, symbol| match symbol {
            Symbol::Position(i) => Bounded::rounded(values[*i]),
            other => panic!("{other:?}"),
        });
        let allowed = vec![[allowed; POINTS]; outputs.len()];
        let mut judge = Judge::new(&network, running, allowed);
        simplify(&mut network, &mut judge, Effort::DEFAULT);
        network.program(&meanings)
    }

    fn simplified(graph: &Graph, outputs: &[Expr<'_>], symbols: usize) -> Program {
        let values: Vec<f64> = (0..symbols).map(|i| 0.7 + 0.3 * i as f64).collect();
        judged(graph, outputs, &values, f64::INFINITY)
    }

    /// s^2 z = z - c^2 z takes an operation less than two products, but where the sine is small it has
    /// the error of z. c^2 z = z - s^2 z is as short.
    #[test]
    fn a_definition_that_costs_digits_is_not_taken() {
        let values = [1e-3, (1.0_f64 - 1e-6).sqrt(), 1.0];
        let error = |allowed: f64| {
            let graph = Graph::new();
            let (s, c) = graph.circle(Level::Variable);
            let z = graph.symbol(Level::Variable);
            let program = judged(&graph, &[s * s * z, c * c * z], &values, allowed);
            assert_eq!(program.operations().total(), 3);
            let at = |symbol: &Symbol| match symbol {
                Symbol::Position(i) => Bounded::rounded(values[*i]),
                other => panic!("{other:?}"),
            };
            Rounded::new(&program).outputs(&at)[0].error
        };
        assert!(error(f64::INFINITY) > UNIT);
        assert!(error(1e-5 * UNIT) < 1e-5 * UNIT);
    }

    /// Coefficients that differ by more than the largest multiple are left as they are.
    #[test]
    fn no_multiple_is_enormous() {
        let graph = Graph::new();
        let [x, y, z] = [(); 3].map(|()| graph.symbol(Level::Variable));
        let tiny = graph.rational(&crate::exact::Rational::from_parts(
            1.into(),
            (1_u64 << 40).into(),
        ));
        let three = graph.rational(&crate::exact::Rational::from(3));
        let program = simplified(&graph, &[(tiny * x + three * tiny * y) * z + z], 3);
        let largest = program
            .rounded_constants()
            .into_iter()
            .filter(|x| !x.is_nan());
        assert!(largest.fold(0.0, f64::max) <= 3.0);
        assert_eq!(program.operations().multiplications, 3);
    }

    #[test]
    fn a_common_factor_is_taken_out() {
        let graph = Graph::new();
        let [x, y, z] = [(); 3].map(|()| graph.symbol(Level::Variable));
        let program = simplified(&graph, &[x + y, x * z + y * z], 3);
        assert_eq!(program.operations().total(), 2);
    }

    /// 3 x + z w - 3 y + u w + v: a product for each factor, wherever its terms stand.
    #[test]
    fn factors_of_several_terms_are_taken_out() {
        let graph = Graph::new();
        let [x, y, z, w, u, v] = [(); 6].map(|()| graph.symbol(Level::Variable));
        let three = graph.rational(&crate::exact::Rational::from(3));
        let sum = three * x + z * w - three * y + u * w + v;
        let count = simplified(&graph, &[sum], 6).operations();
        assert_eq!([count.multiplications, count.additions], [2, 4]);
        // A product that another output reads is computed in any case.
        let count = simplified(&graph, &[sum, z * w], 6).operations();
        assert_eq!([count.multiplications, count.additions], [3, 4]);
    }

    /// 3 (z - x y^2) + 3 x (y^2 + w): what y^2 adds to one term it takes from the other.
    #[test]
    fn what_cancels_is_not_computed() {
        let graph = Graph::new();
        let [x, y, z, w] = [(); 4].map(|()| graph.symbol(Level::Variable));
        let three = graph.rational(&crate::exact::Rational::from(3));
        let output = three * (z - x * (y * y)) + (three * x) * (y * y + w);
        let program = simplified(&graph, &[output], 4);
        assert_eq!(program.operations().total(), 3);
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
        let sound = network.program(&meanings(3));
        let sum = (x * y + z).edge().node();
        let Operation::Add(a, b) = network.definition(sum) else {
            panic!("a sum")
        };
        network.redefine(sum, Operation::Add(a, -b));
        let damaged = network.program(&meanings(3));
        assert_ne!(sound.instructions, damaged.instructions);
    }
}
