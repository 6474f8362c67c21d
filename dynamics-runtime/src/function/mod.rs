//! Generated functions under one signature: what evaluates them at many states needs no more.

mod arrangement;
mod provided;

pub(crate) use arrangement::Of;
#[cfg(feature = "std")]
pub(crate) use arrangement::each_tuple;
pub use arrangement::{Arrangement, Entries, Number};

use core::convert::Infallible;

use crate::{Inputs, Scalar, SingularMassMatrix};

/// The functions by their names: a type for each, for [`Function`].
#[doc(hidden)]
pub mod functions {
    dynamics_items::function_names! {}

    /// Several functions as one, by their number among those of a robot.
    #[derive(Clone, Copy, Debug)]
    pub struct Fused<const INDEX: usize>;
}

/// A generated function: `F` is one of [`functions`].
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not have this function: it is not in `functions`",
    note = "add it by its name without `_batch`: `functions: [default, jacobian]`"
)]
pub trait Function<F, const N: usize> {
    /// The vectors that it takes, a tuple.
    type Arguments: Arrangement;

    /// The arrangement of its values.
    type Values: Arrangement;

    /// The error that it may return in place of values.
    type Error: Into<SingularMassMatrix>;

    /// The names of the arguments.
    const ARGUMENTS: &'static [&'static str];

    /// The name of the results.
    const RESULT: &'static str;

    /// Roughly the number of operations, those of the sines with them.
    const WORK: u32;

    /// Whether it may be evaluated in lanes.
    const IN_LANES: bool = true;

    /// The value at a state.
    ///
    /// # Errors
    ///
    /// Where it solves with M and M is singular.
    fn at<T: Scalar>(
        &self,
        function: F,
        inputs: &impl Inputs<T>,
        arguments: &Of<Self::Arguments, T>,
    ) -> Result<Of<Self::Values, T>, Self::Error>;
}

/// The error that does not happen.
#[doc(hidden)]
impl From<Infallible> for SingularMassMatrix {
    fn from(never: Infallible) -> Self {
        match never {}
    }
}
