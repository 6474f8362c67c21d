//! Expressions on a graph in which equal expressions are one node.
//!
//! No robotics in here: the graph knows numbers, symbols, sums, products and quotients. Every node carries its value at
//! one random point of a prime field, and nodes are hash-consed by that value: expressions that are equal as rational
//! functions are one node, up to sign. So common subexpressions, cancellations, sin^2 + cos^2 = 1 and expressions that
//! vanish need no rewriting rules.
//!
//! Two different expressions of degree d share a value by a chance below d / 2^61; the proof of a finished program
//! uses another prime and other points.

mod arena;
mod differentiate;
mod expression;
mod fingerprint;
mod node;
mod operation;

pub use arena::Graph;
pub use differentiate::Direction;
pub use expression::Expr;
pub(crate) use fingerprint::{Fingerprint, FingerprintMap};
pub use node::{Edge, Level, NodeId};
pub use operation::Operation;
