//! Factors that terms of a sum have in common: f x + f y is written as f (x + y), a multiplication less for each further
//! term.
//!
//! The factor is a constant, or an operand of products that nothing else reads.

use crate::expr::{Edge, NodeId};
use crate::simplify::Writer;
use std::collections::{HashMap, VecDeque};

/// A term as it is written.
#[derive(Clone, Copy)]
pub(super) struct Term {
    /// The constant.
    pub(super) coefficient: Edge,
    /// The node that it multiplies; `None` if the term is a constant alone.
    pub(super) node: Option<Edge>,
    /// The node as a product, if nothing else reads that.
    pub(super) operands: Option<[Edge; 2]>,
}

impl Term {
    /// The other operand of a product with this one, where the term is one.
    fn over(&self, factor: NodeId) -> Option<Edge> {
        let [a, b] = self.operands?;
        match [a, b].map(Edge::node) {
            [node, _] if node == factor => Some(b.negate_if(a.is_negative())),
            [_, node] if node == factor => Some(a.negate_if(b.is_negative())),
            _ => None,
        }
    }
}

/// The sum of some terms, at least one.
pub(super) fn write_sum(writer: &mut Writer<'_>, mut terms: Vec<Term>) -> Edge {
    while let Some(factor) = most_common(&terms) {
        take_out(writer, &mut terms, factor);
    }
    let mut total: Option<Edge> = None;
    let mut left = VecDeque::from(terms);
    while let Some(term) = left.pop_front() {
        let term = match term.node {
            None => term.coefficient,
            Some(node) => {
                let inner = add_alike(writer, (term.coefficient, node), &mut left);
                writer.scaled(term.coefficient, inner)
            }
        };
        total = Some(total.map_or(term, |total| writer.add(total, term)));
    }
    total.expect("a sum has a term")
}

/// The operand that most products have in common, the first of those that are equally common; none if each is in one.
fn most_common(terms: &[Term]) -> Option<NodeId> {
    let mut counts = HashMap::new();
    let products = || terms.iter().filter_map(|term| term.operands);
    for [a, b] in products() {
        *counts.entry(a.node()).or_insert(0) += 1;
        if b.node() != a.node() {
            *counts.entry(b.node()).or_insert(0) += 1;
        }
    }
    let operands = products().flatten().map(Edge::node);
    let common = operands.filter(|node| counts[node] > 1);
    common.reduce(|best, node| {
        if counts[&node] > counts[&best] {
            node
        } else {
            best
        }
    })
}

/// Writes the products with a factor as one, in the place of the first of them.
fn take_out(writer: &mut Writer<'_>, terms: &mut Vec<Term>, factor: NodeId) {
    let mut place = None;
    let mut inner: Option<Edge> = None;
    let mut left = Vec::with_capacity(terms.len());
    for term in terms.drain(..) {
        let Some(other) = term.over(factor) else {
            left.push(term);
            continue;
        };
        place.get_or_insert(left.len());
        let other = writer.scaled(term.coefficient, other);
        inner = Some(inner.map_or(other, |inner| writer.add(inner, other)));
    }
    *terms = left;
    if let (Some(place), Some(inner)) = (place, inner) {
        let product = writer.mul(factor.edge(false), inner);
        let coefficient = writer.one();
        let (node, operands) = (Some(product), None);
        terms.insert(
            place,
            Term {
                coefficient,
                node,
                operands,
            },
        );
    }
}

/// Adds to the node of one term those of the terms with the same coefficient that are left, which must not be 1.
fn add_alike(
    writer: &mut Writer<'_>,
    (coefficient, first): (Edge, Edge),
    left: &mut VecDeque<Term>,
) -> Edge {
    let mut total = first;
    if coefficient.node() == writer.one().node() {
        return total;
    }
    left.retain(|other| match other.node {
        Some(node) if other.coefficient.node() == coefficient.node() => {
            let is_against = other.coefficient.is_negative() != coefficient.is_negative();
            total = writer.add(total, node.negate_if(is_against));
            false
        }
        _ => true,
    });
    total
}
