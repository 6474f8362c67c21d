//! Handles of expressions, with the operators of arithmetic.

use super::{Edge, Fingerprint, Graph, Level, NodeId};
use crate::exact::{Rational, circle_point, rotation_point};
use crate::operators::impl_operators;
use core::fmt;

/// An expression of a [`Graph`].
#[derive(Clone, Copy)]
pub struct Expr<'g> {
    pub(crate) graph: &'g Graph,
    pub(crate) edge: Edge,
}

impl Graph {
    /// The handle of an edge.
    pub fn expr(&self, edge: Edge) -> Expr<'_> {
        Expr { graph: self, edge }
    }

    /// A new symbol.
    pub fn symbol(&self, level: Level) -> Expr<'_> {
        let value = Fingerprint::random(&mut self.random.borrow_mut());
        self.expr(self.symbol_with(level, value))
    }

    /// Two new symbols for the sine and the cosine of one angle: a point of the unit circle.
    pub fn circle(&self, level: Level) -> (Expr<'_>, Expr<'_>) {
        let (s, c) = circle_point(&mut self.random.borrow_mut());
        let symbol = |value| self.expr(self.symbol_with(level, value));
        (symbol(s), symbol(c))
    }

    /// Nine new symbols for the entries of a rotation, by rows.
    pub fn rotation(&self, level: Level) -> [[Expr<'_>; 3]; 3] {
        // A symbol is known by the smaller one of its value and minus that: a rotation of such values is drawn.
        let is_smaller = |x: &Fingerprint| x.get() <= (-*x).get();
        let random = &mut self.random.borrow_mut();
        let mut draws = core::iter::repeat_with(|| rotation_point(random));
        let rotation = draws.find(|rotation| rotation.as_flattened().iter().all(is_smaller));
        let symbol = |value| self.expr(self.symbol_with(level, value));
        rotation.expect("one of 512").map(|row| row.map(symbol))
    }

    /// Zero.
    pub fn zero(&self) -> Expr<'_> {
        self.expr(NodeId::ZERO.edge(false))
    }

    /// One.
    pub fn one(&self) -> Expr<'_> {
        self.expr(NodeId::ONE.edge(false))
    }

    /// 1/2.
    pub fn half(&self) -> Expr<'_> {
        self.rational(&(Rational::ONE / Rational::from(2)))
    }

    /// An exact number.
    pub fn rational(&self, x: &Rational) -> Expr<'_> {
        self.expr(self.arena().rational(x))
    }
}

impl<'g> Expr<'g> {
    /// The node and sign that this expression is.
    pub fn edge(self) -> Edge {
        self.edge
    }

    /// Whether the expression is identically zero.
    pub fn is_zero(self) -> bool {
        self.edge.node() == NodeId::ZERO
    }

    /// The level of the expression.
    pub fn level(self) -> Level {
        self.graph.node(self.edge.node()).level
    }

    /// The exact number that the expression is, where it is one.
    pub(crate) fn as_rational(self) -> Option<Rational> {
        self.graph.arena().as_rational(self.edge)
    }

    /// The value at the graph's random point.
    pub(crate) fn fingerprint(self) -> Fingerprint {
        self.graph.arena().value(self.edge)
    }

    fn with(self, edge: Edge) -> Self {
        Expr { edge, ..self }
    }
}

/// Equal as rational functions.
impl PartialEq for Expr<'_> {
    fn eq(&self, other: &Self) -> bool {
        self.edge == other.edge
    }
}

impl fmt::Debug for Expr<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}", self.edge)
    }
}

impl_operators! {
    impl ['g] for Expr<'g>;
    Add add |a, b| a.with(a.graph.arena().add(a.edge, b.edge));
    Sub sub |a, b| a.with(a.graph.arena().add(a.edge, -b.edge));
    Mul mul |a, b| a.with(a.graph.arena().mul(a.edge, b.edge));
    Div div |a, b| a.with(a.graph.arena().div(a.edge, b.edge));
    Neg neg |a| a.with(a.edge.negate_if(!a.is_zero()));
}
