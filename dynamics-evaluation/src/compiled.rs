//! A function of a robot, ready to be evaluated.

use dynamics_runtime::{Operations, Scalar};
use dynamics_symbolic::function::Argument;
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Proven, Request};

use crate::block::{Stage, stages};
use crate::error::{BuildError, EvaluationError};
use crate::layout::Layout;
use crate::single::{Prepared, Single};
use crate::tape::Tape;

/// A function of a robot.
#[derive(Clone, Debug)]
pub(crate) struct Compiled {
    pub(crate) request: Request,
    pub(crate) layout: Layout,
    pub(crate) operations: Operations,
    /// The arguments, each with its number of entries.
    pub(crate) arguments: Vec<(Argument, usize)>,
    pub(crate) tape: Tape,
    /// The tape at one state, with its numbers for the present values of the fields; none if it is too long.
    pub(crate) single: Option<(Single, Prepared)>,
    pub(crate) stages: Vec<Stage>,
    /// The numbers that all states share, for the present values of the fields.
    pub(crate) shared: Vec<f64>,
}

impl Compiled {
    pub(crate) fn new(
        robot: &Robot,
        request: Request,
        proven: &Proven,
    ) -> Result<Self, BuildError> {
        let too_long = |_| BuildError::TooLong(request.name().to_owned());
        let tape = Tape::new(proven).map_err(too_long)?;
        let request = robot.request(request);
        let (freedoms, outputs) = (robot.freedoms(), proven.program.outputs.len());
        let layout = Layout::new(&request, freedoms, outputs);
        let arguments = request.arguments().into_iter().filter_map(|argument| {
            let shape = argument.shape()?;
            Some((argument, shape.entries(layout.sizes)))
        });
        let counted = proven.program.operations();
        Ok(Compiled {
            arguments: arguments.collect(),
            operations: Operations {
                multiplications: counted.multiplications,
                additions: counted.additions,
                divisions: counted.divisions,
                sin_cos: counted.sin_cos,
                exponentials: counted.exponentials,
            },
            single: Single::new(&tape, &layout).map(|single| (single, Prepared::default())),
            stages: stages(&tape),
            shared: Vec::new(),
            layout,
            tape,
            request,
        })
    }

    /// The entries of arguments, which are those of the function in their order; NaN of any other.
    pub(crate) fn entry<T: Scalar>(
        &self,
        arguments: &[&[T]],
        constant: &impl Fn(f64) -> T,
    ) -> impl Fn(Argument, usize) -> T {
        move |argument, i| {
            let mut known = self.arguments.iter();
            let place = known.position(|(known, _)| *known == argument);
            place.map_or_else(|| constant(f64::NAN), |place| arguments[place][i])
        }
    }

    /// Whether arguments have the lengths that so many states take.
    pub(crate) fn check_lengths<T>(
        &self,
        arguments: &[&[T]],
        states: usize,
    ) -> Result<(), EvaluationError> {
        if arguments.len() != self.arguments.len() {
            let expected = self.arguments.iter();
            return Err(EvaluationError::Arguments {
                found: arguments.len(),
                expected: expected.map(|(argument, _)| argument.name()).collect(),
            });
        }
        let mut pairs = self.arguments.iter().zip(arguments);
        pairs.try_for_each(|((argument, width), found)| {
            check_length(argument.name(), found.len(), states * width)
        })
    }
}

pub(crate) fn check_length(
    argument: &'static str,
    found: usize,
    expected: usize,
) -> Result<(), EvaluationError> {
    if found == expected {
        return Ok(());
    }
    Err(EvaluationError::Length {
        argument,
        found,
        expected,
    })
}
