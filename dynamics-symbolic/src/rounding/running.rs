//! The nodes of a graph at some points, each with a bound on its error.

use super::constants::{certain, constant};
use super::{Bounded, POINTS};
use crate::exact::negate_if;
use crate::expr::{Edge, Graph, Level, NodeId, Operation};
use crate::program::{Operand, Program};
use crate::robot::Symbol;

/// A node at all points.
pub type Point = [Bounded; POINTS];

/// The nodes of a graph at some points. A node is what the graph says it is until another definition
/// is given: its value stays, but not the bound on its error.
pub struct Running<'g> {
    graph: &'g Graph,
    meanings: Vec<Symbol>,
    symbols: Vec<Point>,
    nodes: Vec<Option<Point>>,
    /// Constants in doubles, with the error of evaluating them so.
    constants: Vec<Option<Bounded>>,
}

impl<'g> Running<'g> {
    /// The nodes of a graph where the symbols, which stand for `meanings`, have the values that `point` gives them.
    pub fn new(
        graph: &'g Graph,
        meanings: &[Symbol],
        point: impl Fn(usize, &Symbol) -> Bounded,
    ) -> Self {
        let at = |symbol| core::array::from_fn(|k| point(k, symbol));
        Running {
            graph,
            meanings: meanings.to_vec(),
            symbols: meanings.iter().map(at).collect(),
            nodes: Vec::new(),
            constants: Vec::new(),
        }
    }

    /// A node at all points.
    pub fn node(&mut self, root: NodeId) -> Point {
        if let Some(&Some(known)) = self.nodes.get(root.index()) {
            return known;
        }
        self.nodes.resize(self.graph.len(), None);
        self.graph.visit_operands_first(
            self,
            root,
            |this, id| this.nodes[id.index()].is_some(),
            |this, id, operation| this.nodes[id.index()] = Some(this.evaluate(id, operation)),
        );
        self.nodes[root.index()].expect("the root was evaluated")
    }

    fn evaluate(&mut self, id: NodeId, operation: Operation) -> Point {
        if self.graph.level_of(id) == Level::Constant {
            return [Bounded::constant(self.constant(id)); POINTS];
        }
        if let Operation::Symbol(index) = operation {
            return self.symbols[index as usize];
        }
        let is_flipped = self.graph.is_flipped(id, operation);
        self.result(operation).map(|x| negate_if(x, is_flipped))
    }

    /// The result of an operation on nodes, as it is computed.
    fn result(&mut self, operation: Operation) -> Point {
        let both = |a: Point, b: Point, result: fn(Bounded, Bounded) -> Bounded| {
            core::array::from_fn(|k| result(a[k], b[k]))
        };
        match operation {
            Operation::Add(a, b) => both(self.edge(a), self.edge(b), |a, b| a + b),
            Operation::Mul(a, b) => both(self.node(a), self.node(b), |a, b| a * b),
            Operation::Div(a, b) => both(self.node(a), self.node(b), |a, b| a / b),
            Operation::Symbol(_) | Operation::Rational(_) => {
                unreachable!("leaves are read as nodes")
            }
        }
    }

    fn edge(&mut self, edge: Edge) -> Point {
        let node = self.node(edge.node());
        node.map(|x| negate_if(x, edge.is_negative()))
    }

    /// The bounds on the errors of a node if an operation defines it.
    pub fn errors(&mut self, operation: Operation) -> [f64; POINTS] {
        self.result(operation).map(|x| x.error)
    }

    /// Gives a node other bounds on its error; the old ones.
    pub fn set_errors(&mut self, id: NodeId, errors: [f64; POINTS]) -> [f64; POINTS] {
        let old = self.node(id);
        let new = core::array::from_fn(|k| Bounded {
            error: errors[k],
            ..old[k]
        });
        self.nodes[id.index()] = Some(new);
        old.map(|x| x.error)
    }

    /// The double that a constant is rounded to, or one that is near enough to count with.
    pub fn constant(&mut self, root: NodeId) -> f64 {
        self.constants.resize(self.graph.len(), None);
        self.graph.visit_operands_first(
            self,
            root,
            |this, id| this.constants[id.index()].is_some(),
            |this, id, operation| {
                this.constants[id.index()] = Some(this.evaluate_constant(id, operation));
            },
        );
        self.constants[root.index()].map_or(f64::NAN, |constant| constant.value)
    }

    fn evaluate_constant(&self, id: NodeId, operation: Operation) -> Bounded {
        let known = |id: NodeId| self.constants[id.index()].expect("operands come first");
        let signed = |edge: Edge| negate_if(known(edge.node()), edge.is_negative());
        let result = match operation {
            Operation::Rational(index) => {
                Bounded::rounded(self.graph.rational_of(index).to_f64().value())
            }
            Operation::Symbol(index) => constant(&self.meanings[index as usize]),
            Operation::Add(a, b) => signed(a) + signed(b),
            Operation::Mul(a, b) => known(a) * known(b),
            Operation::Div(a, b) => known(a) / known(b),
        };
        let evaluated = negate_if(result, self.graph.is_flipped(id, operation));
        match certain(evaluated) {
            Some(_) => evaluated,
            None => Bounded::rounded(self.in_high_precision(id)),
        }
    }

    /// A constant of which doubles say too little: a difference of numbers that are nearly equal.
    fn in_high_precision(&self, id: NodeId) -> f64 {
        let outputs = [id.edge(false)];
        let definition = |id| self.graph.operation(id);
        let program = Program::new(self.graph, &self.meanings, &outputs, &definition);
        let rounded = program.rounded_constants();
        match program.outputs[0].operand {
            Operand::Constant(id) => negate_if(rounded[id.index()], program.outputs[0].negative),
            _ => unreachable!("a constant takes no operation"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use crate::robot::Value;
    use crate::rounding::UNIT;

    fn rational(graph: &Graph, numerator: i64, denominator: u64) -> crate::expr::Expr<'_> {
        graph.rational(&Rational::from_parts(numerator.into(), denominator.into()))
    }

    /// x = 3, and y = 4 with an error of 0.5.
    fn point(_: usize, symbol: &Symbol) -> Bounded {
        match symbol {
            Symbol::Position(0) => Bounded::exact(3.0),
            Symbol::Position(1) => Bounded {
                value: 4.0,
                error: 0.5,
            },
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn signs_of_nodes_are_those_of_their_values() {
        let graph = Graph::new();
        let [x, y] = [(); 2].map(|()| graph.symbol(Level::Variable));
        let meanings = [0, 1].map(Symbol::Position);
        let mut running = Running::new(&graph, &meanings, point);
        for (expression, expected) in [
            (x * y, 12.0),
            (-x * y, -12.0),
            (x - y, -1.0),
            (y - x, 1.0),
            ((x - y) * y, -4.0),
            (x / (x - y), -3.0),
            (-(x - y) / (y * y), 0.0625),
        ] {
            assert_eq!(running.edge(expression.edge())[0].value, expected);
        }
    }

    #[test]
    fn another_definition_has_another_error_and_the_same_value() {
        let graph = Graph::new();
        let [x, y] = [(); 2].map(|()| graph.symbol(Level::Variable));
        let meanings = [0, 1].map(Symbol::Position);
        let mut running = Running::new(&graph, &meanings, point);
        let square = x * x;
        let sum = square + y;
        let id = square.edge().node();
        assert_eq!(running.node(id)[0].error, 9.0 * UNIT);
        let errors = running.errors(Operation::Add(sum.edge(), -y.edge()));
        assert!(errors[0] > 1.0 && errors[0] < 1.0 + 1e-10);
        running.set_errors(id, errors);
        let Bounded { value, error } = running.node(id)[0];
        assert_eq!((value.abs(), error), (9.0, errors[0]));
    }

    /// 1 - sin^2 and cos^2 of 1.5707963 are one node, however it was written first: 7.2e-16 of it is
    /// more than doubles tell apart from the difference of 1 and 1.
    #[test]
    fn constants_that_cancel_are_evaluated_precisely() {
        let graph = Graph::new();
        let (s, _) = graph.circle(Level::Constant);
        let angle = Value::Rational(Rational::from_parts(
            15_707_963.into(),
            10_000_000_u32.into(),
        ));
        let meanings = [Symbol::AngleSine(angle.clone()), Symbol::AngleCosine(angle)];
        let mut running = Running::new(&graph, &meanings, |_, _| Bounded::exact(0.0));
        let difference = graph.one() - s * s;
        let cosine = 2.679_489_657_850_6e-8_f64;
        let constant = running.constant(difference.edge().node()).abs();
        assert!(
            (constant / (cosine * cosine) - 1.0).abs() < 1e-6,
            "{constant:e}"
        );
        let tenth = rational(&graph, 1, 10);
        assert_eq!(running.constant(tenth.edge().node()).abs(), 0.1);
    }
}
