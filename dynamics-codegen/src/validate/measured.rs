//! Values of cells on their way through an expression.

use dynamics_symbolic::robot::Value;

/// A value and how it came about.
#[derive(Clone)]
pub(super) struct Measured {
    pub(super) value: Value,
    /// The number of its terms.
    pub(super) terms: usize,
    /// Whether two values were put together in it.
    pub(super) is_computed: bool,
}

impl Measured {
    /// A number or a name.
    pub(super) fn of(value: Value) -> Measured {
        Measured {
            value,
            terms: 1,
            is_computed: false,
        }
    }
}
