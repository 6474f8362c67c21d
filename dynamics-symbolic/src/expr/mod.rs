//! Expressions on a graph in which equal expressions are one node.
//!
//! No robotics in here: the graph knows numbers, symbols, sums, products and
//! quotients. Every node carries its value at one random point of a prime
//! field, and nodes are hash-consed by that value: two expressions that are
//! equal as rational functions are one node, however they were written, up to
//! sign. That finds common subexpressions, cancellations, sin^2 + cos^2 = 1
//! and expressions that vanish identically, with no rewriting rules. (The
//! chance that two different expressions of degree d share a value is below
//! d / 2^61; the proof of a finished program uses another prime and other
//! points.)

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
