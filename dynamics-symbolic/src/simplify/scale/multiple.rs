//! Constant multiples: exact, and as fingerprints for the search.

use crate::expr::{Expr, Fingerprint};

/// The fingerprint of a constant, that of its inverse, and about what it is in doubles.
#[derive(Clone, Copy)]
pub(super) struct Ratio {
    pub(super) value: Fingerprint,
    pub(super) inverse: Fingerprint,
    pub(super) number: f64,
}

/// The largest multiple of a sum, and the inverse of the smallest.
const LARGEST: f64 = (1_u64 << 30) as f64;

impl Ratio {
    /// Whether a sum may be computed as this multiple of itself. A multiple loses no digits by itself,
    /// but those of multiples are multiplied, and overflow in the end.
    pub(super) fn is_moderate(self) -> bool {
        let size = self.number.abs();
        (1.0 / LARGEST..=LARGEST).contains(&size)
    }
}

/// A constant that is not zero. The search compares ratios alone: exact numbers
/// are slow, and every operation on them adds a node to the graph.
#[derive(Clone, Copy)]
pub(super) struct Multiple<'g> {
    pub(super) exact: Expr<'g>,
    pub(super) ratio: Ratio,
}

/// A multiple, exact or as the ratio that stands for it.
pub(super) trait Scale<'g>: Copy {
    fn new(multiple: Multiple<'g>) -> Self;
    fn times(self, o: Self) -> Self;
    fn over(self, o: Self) -> Self;
}

impl<'g> Scale<'g> for Ratio {
    fn new(multiple: Multiple<'g>) -> Self {
        multiple.ratio
    }

    fn times(self, o: Self) -> Self {
        Ratio {
            value: self.value * o.value,
            inverse: self.inverse * o.inverse,
            number: self.number * o.number,
        }
    }

    fn over(self, o: Self) -> Self {
        self.times(Ratio {
            value: o.inverse,
            inverse: o.value,
            number: 1.0 / o.number,
        })
    }
}

impl<'g> Scale<'g> for Multiple<'g> {
    fn new(multiple: Multiple<'g>) -> Self {
        multiple
    }

    fn times(self, o: Self) -> Self {
        Multiple {
            exact: self.exact * o.exact,
            ratio: self.ratio.times(o.ratio),
        }
    }

    fn over(self, o: Self) -> Self {
        Multiple {
            exact: self.exact / o.exact,
            ratio: self.ratio.over(o.ratio),
        }
    }
}

impl<'g> Multiple<'g> {
    /// A constant that is about `number`. `None` where it has no inverse fingerprint.
    pub(super) fn new(exact: Expr<'g>, number: f64) -> Option<Self> {
        let value = exact.fingerprint();
        let inverse = value.inverse()?;
        Some(Multiple {
            exact,
            ratio: Ratio {
                value,
                inverse,
                number,
            },
        })
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
                number: -self.ratio.number,
            },
        }
    }
}
