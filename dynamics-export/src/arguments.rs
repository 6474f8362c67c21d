//! The arguments of functions.

use dynamics_symbolic::function::{Argument, Request, Sizes};
use dynamics_symbolic::robot::Robot;

/// The names of what a function reads: the fields of the arm together, if there are any, and the arguments.
pub(crate) fn argument_names(robot: &Robot, request: &Request) -> Vec<&'static str> {
    let fields = (!robot.fields.is_empty()).then_some("arm");
    let arguments = request.arguments();
    let names = arguments.iter().map(|argument| argument.name());
    fields.into_iter().chain(names).collect()
}

/// The arguments of a function, each with its number of entries.
pub(crate) fn argument_sizes(
    request: &Request,
    sizes: Sizes,
) -> impl Iterator<Item = (Argument, usize)> {
    let arguments = request.arguments().into_iter();
    arguments.map(move |argument| {
        let entries = argument.shape().map_or(0, |shape| shape.entries(sizes));
        (argument, entries)
    })
}
