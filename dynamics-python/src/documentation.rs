//! The documentation of a robot's function: the arguments with their shapes and units, and the shape of the value.

use dynamics_evaluation::Arrangement;
use dynamics_symbolic::Request;
use dynamics_symbolic::emit::{meanings, quantities};
use dynamics_symbolic::function::{Argument as Name, Sizes};
use dynamics_symbolic::robot::Robot;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arguments::{Argument, UNKNOWN, shape};

/// The settings of a call, which all functions have.
const SETTINGS: &str = "\
out: an array of numpy, which takes the value; it may be an argument, or share its memory
threads: how many threads share the states, at most as many as there are processors, 1 where nothing is said
on_singular: \"raise\" raises `SingularMassMatrix` where M(q) is singular, \"nan\" gives NaN at these states
a field, by its name: a value, or an array with a value for each state, in place of the robot's own";

/// The text that `help` shows of a function. Nothing is derived for it.
pub(crate) fn documentation(robot: &Robot, request: &Request) -> String {
    let arguments = arguments(robot, request);
    let names = arguments.iter().map(|of| &*of.name);
    let settings = "*, out=None, threads=None, on_singular=\"raise\"";
    let call: Vec<_> = names.chain([settings]).collect();
    let mut lines = vec![
        format!("{}({})", request.name(), call.join(", ")),
        String::new(),
    ];
    let quantities = quantities(robot, request);
    lines.extend(quantities.iter().map(|line| line.trim().to_owned()));
    lines.push(String::new());
    let meanings = meanings(robot, request);
    for (argument, name) in arguments.iter().zip(request.arguments()) {
        let meaning = meanings.iter().find(|(of, _)| *of == name);
        let meaning = meaning.map_or("", |(_, meaning)| meaning);
        let line = format!("{}: {} {meaning}", argument.name, argument.shape());
        lines.push(line.trim_end().to_owned());
    }
    let value = match Arrangement::of(request, sizes(robot)) {
        Arrangement::Array(axes) => shape(&axes),
        tuple => format!("a tuple: {}", shapes(&tuple)),
    };
    lines.extend([String::new(), format!("Returns {value}."), String::new()]);
    lines.push(SETTINGS.to_owned());
    lines.join("\n")
}

/// The arguments of a function.
pub(crate) fn arguments(robot: &Robot, request: &Request) -> Vec<Argument> {
    let (sizes, moves) = (sizes(robot), robot.freedoms().has_base());
    let entries = |argument: &Name| argument.shape().map_or(0, |shape| shape.entries(sizes));
    let arguments = request.arguments().into_iter();
    let arguments = arguments.map(|of| Argument::new(of.name(), entries(&of), moves));
    arguments.collect()
}

/// The `inspect.Signature` of a function.
pub(crate) fn signature<'py>(
    py: Python<'py>,
    robot: &Robot,
    request: &Request,
) -> PyResult<Bound<'py, PyAny>> {
    let inspect = py.import("inspect")?;
    let parameter = inspect.getattr("Parameter")?;
    let arguments = arguments(robot, request).into_iter().map(|argument| {
        let kind = parameter.getattr("POSITIONAL_OR_KEYWORD")?;
        parameter.call1((&*argument.name, kind))
    });
    let settings = [
        ("out", None),
        ("threads", None),
        ("on_singular", Some("raise")),
    ];
    let settings = settings.into_iter().map(|(name, default)| {
        let keywords = PyDict::new(py);
        keywords.set_item("default", default)?;
        parameter.call((name, parameter.getattr("KEYWORD_ONLY")?), Some(&keywords))
    });
    let parameters = arguments.chain(settings).collect::<PyResult<Vec<_>>>()?;
    inspect.getattr("Signature")?.call1((parameters,))
}

/// The sizes of a robot, of which the number of base parameters is not known before a derivation.
fn sizes(robot: &Robot) -> Sizes {
    Sizes {
        freedoms: robot.freedoms(),
        parameters: UNKNOWN,
    }
}

/// The shapes of the arrays of a tuple.
fn shapes(arrangement: &Arrangement) -> String {
    match arrangement {
        Arrangement::Array(axes) => shape(axes),
        Arrangement::Tuple(all) => all.iter().map(shapes).collect::<Vec<_>>().join(", "),
    }
}
