//! Errors of batches.

use core::fmt;

use crate::SingularMassMatrix;
use crate::function::functions;

/// An argument of a batch holds another number of states than the first one, which is `q` for nearly all functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LengthMismatch {
    /// The argument, by its name; of the arms of [`Batch::with_parameters`](crate::Batch::with_parameters)
    /// `parameters`.
    pub argument: &'static str,
    /// The number of states in it; where its columns differ from one another, the length of the
    /// first one that differs.
    pub found: usize,
    /// The number of states in the first argument.
    pub expected: usize,
}

impl LengthMismatch {
    /// Whether arguments have the number of states that is expected.
    #[doc(hidden)]
    pub fn test(expected: usize, lengths: &[(&'static str, usize)]) -> Result<(), LengthMismatch> {
        let other = lengths.iter().find(|(_, found)| *found != expected);
        other.map_or(Ok(()), |&(argument, found)| {
            Err(LengthMismatch {
                argument,
                found,
                expected,
            })
        })
    }
}

impl fmt::Display for LengthMismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let LengthMismatch {
            argument,
            found,
            expected,
        } = self;
        let first = functions::first_argument(argument);
        write!(
            f,
            "`{argument}` has {found} states where `{first}` has {expected}"
        )
    }
}

impl core::error::Error for LengthMismatch {}

/// A batch of a function that solves with M failed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BatchError {
    /// An argument holds another number of states than `q`. Nothing was written.
    Length(LengthMismatch),
    /// The mass matrix of a state is not positive definite. The values of all states that
    /// have none are NaN, those of the others are written.
    Singular {
        /// The first such state, counted from 0.
        state: usize,
        /// The error of `forward_dynamics` at that state.
        error: SingularMassMatrix,
    },
}

impl From<LengthMismatch> for BatchError {
    fn from(mismatch: LengthMismatch) -> Self {
        BatchError::Length(mismatch)
    }
}

impl fmt::Display for BatchError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BatchError::Length(mismatch) => mismatch.fmt(f),
            BatchError::Singular { state, error } => write!(f, "state {state}: {error}"),
        }
    }
}

impl core::error::Error for BatchError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            BatchError::Length(mismatch) => Some(mismatch),
            BatchError::Singular { error, .. } => Some(error),
        }
    }
}
