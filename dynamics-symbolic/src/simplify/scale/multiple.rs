//! Constant multiples: exact, and as fingerprints for the search.

use crate::expr::{Expr, Fingerprint};

/// The fingerprint of a constant, and that of its inverse.
#[derive(Clone, Copy)]
pub(super) struct Ratio {
    pub(super) value: Fingerprint,
    pub(super) inverse: Fingerprint,
}

impl Ratio {
    pub(super) const ONE: Ratio = Ratio {
        value: Fingerprint::ONE,
        inverse: Fingerprint::ONE,
    };

    pub(super) fn inverted(self) -> Self {
        Ratio {
            value: self.inverse,
            inverse: self.value,
        }
    }

    pub(super) fn times(self, o: Self) -> Self {
        Ratio {
            value: self.value * o.value,
            inverse: self.inverse * o.inverse,
        }
    }

    pub(super) fn over(self, o: Self) -> Self {
        self.times(o.inverted())
    }
}

/// A constant that is not zero. The search compares ratios alone: exact numbers
/// are slow, and every operation on them adds a node to the graph.
#[derive(Clone, Copy)]
pub(super) struct Multiple<'g> {
    pub(super) exact: Expr<'g>,
    pub(super) ratio: Ratio,
}

impl<'g> Multiple<'g> {
    /// `None` where the constant has no inverse fingerprint.
    pub(super) fn new(exact: Expr<'g>) -> Option<Self> {
        let value = exact.fingerprint();
        let inverse = value.inverse()?;
        Some(Multiple {
            exact,
            ratio: Ratio { value, inverse },
        })
    }

    pub(super) fn times(self, o: Self) -> Self {
        Multiple {
            exact: self.exact * o.exact,
            ratio: self.ratio.times(o.ratio),
        }
    }

    pub(super) fn over(self, o: Self) -> Self {
        Multiple {
            exact: self.exact / o.exact,
            ratio: self.ratio.over(o.ratio),
        }
    }

    pub(super) fn negate_if(self, negate: bool) -> Self {
        if !negate {
            return self;
        }
        Multiple {
            exact: -self.exact,
            ratio: Ratio {
                value: -self.ratio.value,
                inverse: -self.ratio.inverse,
            },
        }
    }
}
