//! The bounds of a function, and the line about them that every language has.

use super::degree::degree;
use super::{largest_in_parts, over_limits};
use crate::function::{Argument, Part, Request, Shape, Size, spans};
use crate::mechanism::Mechanism;
use crate::program::{Program, Proven};
use crate::robot::{Bounds, JointType, Robot, Symbol};
use core::ops::Range;

/// The largest rounding errors of the functions that one program computes, in double and in single precision, joints within their
/// limits and all other arguments up to 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Rounding {
    /// For each of the functions its name and its bounds, infinite where there is none.
    bounds: Vec<(String, [f64; 2])>,
    /// The unit of the values, if they have one.
    unit: Option<String>,
    conditions: String,
    growth: String,
    /// Why a bound is infinite.
    reason: &'static str,
}

/// The bounds of the functions that one program computes. `None` where there is nothing to say: see [`over_limits`].
pub fn rounding(robot: &Robot, request: &Request, proven: &Proven) -> Option<Rounding> {
    let Proven { program, constants } = proven;
    let errors = over_limits(robot, program, constants)?;
    let parts = request.parts();
    let freedoms = robot.freedoms();
    let outputs = spans(parts, freedoms, program.outputs.len());
    let values = |(part, span): (&Part, Range<usize>)| {
        let count = part.function.entries(freedoms, span.len());
        (*part, span.start..span.start + count)
    };
    let spans: Vec<_> = parts.iter().zip(outputs).map(values).collect();
    let bound = |(part, span): &(Part, Range<usize>)| {
        let errors = &errors[span.clone()];
        let largest = match robot.bounds {
            Bounds::Whole => {
                [0, 1].map(|k| errors.iter().map(|error| error[k]).fold(0.0, f64::max))
            }
            Bounds::Tight => largest_in_parts(robot, program, constants, span.clone(), errors),
        };
        (robot.name_of(*part), largest)
    };
    let growth = match &spans[..] {
        [(_, span)] => growth(program, span.clone()),
        _ => String::new(),
    };
    Some(Rounding {
        bounds: spans.iter().map(bound).collect(),
        unit: unit(robot, parts),
        conditions: conditions(program),
        growth,
        reason: reason(robot, program),
    })
}

impl Rounding {
    /// The largest error of all values, in double and in single precision.
    pub fn largest(&self) -> [f64; 2] {
        let bounds = self.bounds.iter();
        bounds.fold([0.0; 2], |[double, single], (_, bound)| {
            [double.max(bound[0]), single.max(bound[1])]
        })
    }

    /// `Rounding: at most 1.3e-12 N m (double), 7.0e-4 N m (single) for joints within their limits.`
    pub fn line(&self) -> String {
        let [double, single] = self.largest();
        if single == 0.0 && double == 0.0 {
            return "Rounding: none.".to_owned();
        }
        if double == f64::INFINITY && single == f64::INFINITY {
            return format!("Rounding: no bound, because {}.", self.reason);
        }
        let both = |bound: &[f64; 2]| {
            let [double, single] = bound.map(|bound| self.at_most(bound));
            format!("{double} (double), {single} (single)")
        };
        let named = |(name, bound): &(String, [f64; 2])| format!("{} of `{name}`", both(bound));
        let bounds = match &self.bounds[..] {
            [(_, bound)] => both(bound),
            bounds => bounds.iter().map(named).collect::<Vec<_>>().join(", "),
        };
        let units = if self.unit.is_none() {
            " in SI units"
        } else {
            ""
        };
        format!(
            "Rounding: at most {bounds}{units} for {}{}.",
            self.conditions, self.growth
        )
    }

    /// `3.2e-15 N m`: two digits, rounded up.
    fn at_most(&self, bound: f64) -> String {
        let number = match bound {
            0.0 => return "0".to_owned(),
            f64::INFINITY => return "infinity".to_owned(),
            bound => rounded_up(bound),
        };
        match &self.unit {
            Some(unit) => format!("{number} {unit}"),
            None => number,
        }
    }
}

/// A number with two digits that is no less.
fn rounded_up(bound: f64) -> String {
    let mut raised = bound;
    loop {
        let text = format!("{raised:.1e}");
        if text.parse().is_ok_and(|shown: f64| shown >= bound) {
            return text;
        }
        raised *= 1.01;
    }
}

/// The unit of the values of functions that have the same one, which joints that slide change.
fn unit(robot: &Robot, parts: &[Part]) -> Option<String> {
    let (first, others) = parts.split_first()?;
    let units = first.function.row().unit?;
    let is_same = |part: &Part| part.function.row().unit == Some(units);
    let slides = robot
        .joints()
        .any(|row| row.joint_type == JointType::Prismatic);
    let turns = robot
        .joints()
        .any(|row| row.joint_type == JointType::Revolute);
    let [of_turns, of_slides] = units;
    let unit = match (turns, slides) {
        _ if of_turns == of_slides => of_turns.to_owned(),
        _ if robot.freedoms().has_base() => return None,
        // The entries of a matrix have more units than both.
        (true, true) if !matches!(first.function.shape(), Shape::Matrix(_, Size::One)) => {
            return None;
        }
        (true, true) => format!("{of_turns} or {of_slides}"),
        (false, true) => of_slides.to_owned(),
        (_, false) => of_turns.to_owned(),
    };
    others.iter().all(is_same).then_some(unit)
}

/// Why there is no bound, if there is none.
fn reason(robot: &Robot, program: &Program) -> &'static str {
    let arm = Mechanism::from(robot);
    let of_field = |symbol: &Symbol| {
        matches!(
            symbol,
            Symbol::Field(_) | Symbol::AngleSine(_) | Symbol::AngleCosine(_)
        )
    };
    let slides_freely = |symbol: &Symbol| match symbol {
        Symbol::Position(i) => {
            super::input(&arm, symbol).range.size() == f64::INFINITY
                && arm.joint_of_symbol(*i).limits.is_none()
        }
        _ => false,
    };
    if program.inputs.iter().any(of_field) {
        "it depends on fields"
    } else if program.inputs.iter().any(slides_freely) {
        "a joint slides without limits"
    } else {
        "a divisor may vanish"
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
