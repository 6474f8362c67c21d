//! Derivatives.

use super::{Edge, Expr, Graph, NodeId, Operation};
use crate::exact::negate_if;
use std::collections::HashMap;

/// A direction: the rates at which symbols change. Symbols that have none are constant.
#[derive(Clone, Default)]
pub struct Direction<'g> {
    rates: HashMap<NodeId, Expr<'g>>,
}

impl<'g> Direction<'g> {
    /// The direction in which nothing changes.
    pub fn new() -> Self {
        Direction::default()
    }

    /// The direction in which, besides, `symbol` changes at a rate.
    pub fn with(mut self, symbol: Expr<'g>, rate: Expr<'g>) -> Self {
        let edge = symbol.edge();
        self.rates.insert(edge.node(), signed(rate, edge));
        self
    }
}

impl<'g> Expr<'g> {
    /// The derivative in a direction: (a + b)' = a' + b', (a b)' = a' b + a b', (a / b)' = (a' - (a / b) b') / b.
    pub fn derivative(self, direction: &Direction<'g>) -> Expr<'g> {
        let mut known: HashMap<NodeId, Expr<'g>> = HashMap::new();
        self.graph.visit_operands_first(
            &mut known,
            self.edge.node(),
            |known, id| known.contains_key(&id),
            |known, id, operation| {
                let rate = rate(self.graph, id, operation, direction, known);
                known.insert(id, rate);
            },
        );
        signed(known[&self.edge.node()], self.edge)
    }
}

fn signed<'g>(expr: Expr<'g>, edge: Edge) -> Expr<'g> {
    negate_if(expr, edge.is_negative())
}

/// The derivative of one node, from those of its operands.
fn rate<'g>(
    graph: &'g Graph,
    id: NodeId,
    operation: Operation,
    direction: &Direction<'g>,
    known: &HashMap<NodeId, Expr<'g>>,
) -> Expr<'g> {
    let node = graph.expr(id.edge(false));
    let expr = |id: NodeId| graph.expr(id.edge(false));
    match operation {
        Operation::Rational(_) => graph.zero(),
        Operation::Symbol(_) => direction.rates.get(&id).copied().unwrap_or(graph.zero()),
        Operation::Add(a, b) => signed(known[&a.node()], a) + signed(known[&b.node()], b),
        Operation::Mul(a, b) => {
            let rate = known[&a] * expr(b) + expr(a) * known[&b];
            // The node is the product up to sign.
            negate_if(rate, expr(a) * expr(b) != node)
        }
        Operation::Div(a, b) => {
            let quotient = expr(a) / expr(b);
            let rate = (known[&a] - quotient * known[&b]) / expr(b);
            negate_if(rate, quotient != node)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::Level;

    #[test]
    fn rules_of_differentiation() {
        let graph = Graph::new();
        let x = graph.symbol(Level::Variable);
        let y = graph.symbol(Level::Variable);
        let along_x = Direction::new().with(x, graph.one());
        assert!(y.derivative(&along_x).is_zero());
        assert_eq!((x * x * y - y).derivative(&along_x), (x + x) * y);
        assert_eq!((y / x).derivative(&along_x), -(y / (x * x)));
        assert_eq!((-x).derivative(&along_x), -graph.one());
    }

    #[test]
    fn a_circle_turns() {
        let graph = Graph::new();
        let (s, c) = graph.circle(Level::Variable);
        let turn = Direction::new().with(s, c).with(c, -s);
        assert_eq!((s * s).derivative(&turn), (s + s) * c);
        assert!((s * s + c * c).derivative(&turn).is_zero());
    }
}
