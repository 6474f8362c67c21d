//! The sentence about errors in the documentation of a method.

use super::degree::degree;
use super::over_limits;
use crate::derive::states::states;
use crate::function::{Argument, Part, Request, spans};
use crate::program::Program;
use crate::robot::{Robot, Symbol};
use crate::rounding::Rounded;
use core::ops::Range;

/// A bound is of use where it is below this share of the function's largest value at some states.
const USEFUL: f64 = 1e-9;

/// The states at which the size of values is sampled, in pairs.
const PAIRS: usize = 4;

/// Their seed.
const SEED: u64 = 0x0062_6f75_6e64;

/// The largest error of each of the functions that one program computes, joints within their limits. `None` where there
/// is nothing to say: see [`over_limits`].
pub(crate) fn note(
    robot: &Robot,
    request: &Request,
    program: &Program,
    constants: &[f64],
) -> Option<String> {
    let errors = over_limits(robot, program, constants)?;
    let sizes = sizes(robot, program, constants);
    let parts = request.parts();
    let values = |(part, span): (&Part, Range<usize>)| {
        let count = part.function.entries(robot.freedoms(), span.len());
        span.start..span.start + count
    };
    let outputs = spans(parts, robot.freedoms(), program.outputs.len());
    let spans: Vec<_> = parts.iter().zip(outputs).map(values).collect();
    let bound = |span: &Range<usize>| useful(&errors[span.clone()], &sizes[span.clone()]);
    let bounds: Vec<_> = spans.iter().map(bound).collect();
    if bounds.iter().all(|bound| *bound == Some(0.0)) {
        return Some(" Rounding error in `f64`: none.".to_owned());
    }
    if bounds.iter().all(Option::is_none) {
        return Some(
            " Rounding error: no bound over the joint limits is of use; `Certified` bounds it at a state."
                .to_owned(),
        );
    }
    let named = |(part, bound): (&Part, &Option<f64>)| {
        format!("{} (`{}`)", at_most(*bound), robot.name_of(*part))
    };
    let (bounds, growth) = match parts {
        [_] => (at_most(bounds[0]), growth(program, spans[0].clone())),
        _ => {
            let bounds: Vec<_> = parts.iter().zip(&bounds).map(named).collect();
            (bounds.join(", "), String::new())
        }
    };
    let conditions = conditions(program);
    Some(format!(
        " Rounding error in `f64` (SI units): {bounds}, proven for {conditions}{growth}."
    ))
}

/// The largest of some errors, where it is of use beside the sizes of the values.
fn useful(errors: &[f64], sizes: &[f64]) -> Option<f64> {
    let largest = |numbers: &[f64]| numbers.iter().copied().fold(0.0, f64::max);
    let error = largest(errors);
    (error <= USEFUL * largest(sizes)).then_some(error)
}

/// The largest sizes of the outputs at some states within the limits.
fn sizes(robot: &Robot, program: &Program, constants: &[f64]) -> Vec<f64> {
    let rounded = Rounded::with_constants(program, constants);
    let mut sizes = vec![0.0_f64; program.outputs.len()];
    for state in states(&robot.into(), SEED, PAIRS).iter().flatten() {
        let outputs = rounded.outputs(&|symbol| state.symbol(symbol));
        for (size, output) in sizes.iter_mut().zip(outputs) {
            *size = size.max(output.value.abs());
        }
    }
    sizes
}

/// `at most 3.2e-15`: two digits, rounded up.
fn at_most(bound: Option<f64>) -> String {
    let bound = match bound {
        None => return "no useful bound".to_owned(),
        Some(0.0) => return "none".to_owned(),
        Some(bound) => bound,
    };
    let mut raised = bound;
    loop {
        let text = format!("{raised:.1e}");
        if text.parse().is_ok_and(|shown: f64| shown >= bound) {
            return format!("at most {text}");
        }
        raised *= 1.01;
    }
}

/// The argument on which a symbol depends.
fn argument(symbol: &Symbol) -> Option<Argument> {
    symbol.argument().map(|(argument, _)| argument)
}

/// The arguments that a program reads, in order.
fn arguments(program: &Program) -> Vec<Argument> {
    let mut arguments: Vec<_> = program.inputs.iter().filter_map(argument).collect();
    arguments.sort();
    arguments.dedup();
    arguments
}

/// The conditions under which the bound holds.
fn conditions(program: &Program) -> String {
    let arguments = arguments(program);
    let limits = "joints within their limits";
    let others = arguments.iter().filter(|x| **x != Argument::Position);
    let names: Vec<_> = others.map(|x| format!("`{}`", x.name())).collect();
    let entries = match &names[..] {
        [] => return limits.to_owned(),
        [name] => name.clone(),
        [names @ .., last] => format!("{} and {last}", names.join(", ")),
    };
    let mut conditions = format!("entries of {entries} up to 1");
    if arguments.contains(&Argument::Position) {
        conditions = format!("{limits} and {conditions}");
    }
    conditions
}

/// How the bound grows with the only argument beside q, where that is a power of it.
fn growth(program: &Program, outputs: Range<usize>) -> String {
    let mut others = arguments(program);
    others.retain(|x| *x != Argument::Position);
    let [only] = others[..] else {
        return String::new();
    };
    let is_no_entry =
        |symbol: &Symbol| matches!(symbol, Symbol::VelocitySign(_) | Symbol::Stribeck(_));
    if program.inputs.iter().any(is_no_entry) {
        return String::new();
    }
    let power = match degree(program, outputs, |symbol| argument(symbol) == Some(only)) {
        Some(1) => "in proportion to",
        Some(2) => "with the square of",
        _ => return String::new(),
    };
    format!("; it grows {power} `{}`", only.name())
}
