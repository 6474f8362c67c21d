//! The steps that a search has found.

use super::plan::Step;
use crate::expr::Expr;

/// A step with its coefficients.
pub(super) struct Found<'g> {
    pub(super) step: Step,
    pub(super) coefficients: Vec<Expr<'g>>,
}
