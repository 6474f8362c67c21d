//! Programs as formulas that a person can read.
//!
//! A program is multiplied out into polynomials (`multiply_out`), exactly, so that what is shown is what was proven.
//! The angles of parallel axes are added up (`angles`: c12 = cos(q1 + q2)), what has factors in common is collected
//! (`collect`), and the result is written as text, LaTeX or MathML (`write`). [`Structure`] says what can be said of a
//! program of any length: which of its outputs are zero or constant, and what the others depend on.

mod angles;
mod atom;
mod collect;
mod entries;
mod expression;
mod groups;
mod multiply_out;
mod names;
mod structure;
mod write;

pub use multiply_out::{Budget, TooLong};
pub use structure::Structure;
pub use write::Format;
pub(crate) use write::signed_sum;

use crate::function::{Function, Part, spans};
use crate::program::Program;
use crate::robot::Robot;
use expression::Expression;
use groups::Groups;
use names::Names;

/// Formulas are written for arms of so many joints without being requested.
pub const MOST_JOINTS: usize = 3;

/// A formula of more terms is no help to a reader.
pub const MOST_TERMS: usize = 24;

/// The values of functions of one arm as formulas.
pub struct Formulas {
    names: Names,
    entries: Vec<Entry>,
}

/// One value of a function.
struct Entry {
    function: Function,
    symbol: &'static str,
    indices: Vec<usize>,
    formula: Result<Formula, TooLong>,
}

/// A formula and the number of its terms when multiplied out.
struct Formula {
    expression: Expression,
    terms: usize,
}

/// A value of a function, as it is shown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shown {
    /// The function.
    pub function: Function,
    /// The name of the value, such as `M12`.
    pub name: String,
    /// The formula, or why there is none.
    pub formula: Result<String, TooLong>,
}

/// A value of a function with its formula, as an equation in every format.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Equation {
    /// The name of the value, such as `M12`.
    pub name: String,
    /// `M12 = m2 l2^2 + m2 l1 l2 c2`.
    pub text: String,
    /// The equation for LaTeX's math mode.
    pub latex: String,
    /// The equation as a `math` element.
    pub mathml: String,
}

impl Formulas {
    /// The formulas of a short arm, which are written without being requested.
    pub fn of_short_arm(
        robot: &Robot,
        parts: &[Part],
        program: &Program,
        budget: Budget,
    ) -> Option<Self> {
        // Sines of followers have no letter.
        let mut inputs = program.inputs.iter();
        let is_named = inputs.all(|symbol| robot.follower_of(symbol).is_none());
        let is_short = robot.dof() <= MOST_JOINTS && is_named;
        is_short.then(|| Formulas::new(robot, parts, program, budget))
    }

    /// The formulas of a program of some functions. Functions whose values have no letter of their own to name them by
    /// are left out, and so are those whose values are arranged in arrays and tuples.
    pub fn new(robot: &Robot, parts: &[Part], program: &Program, budget: Budget) -> Self {
        let groups = Groups::new(&robot.into());
        let (atoms, values) = multiply_out::multiplied_out(&groups, program, budget);
        let collected = |polynomial| {
            let merged = angles::merged(polynomial, &groups);
            (merged.len(), collect::collected(&atoms, &merged))
        };
        let mut entries = Vec::new();
        let spans = spans(parts, robot.freedoms(), values.len());
        let named = parts.iter().zip(spans);
        for (part, span) in named.filter(|(part, _)| part.has_letter_in(parts)) {
            let function = part.function;
            let indices = structure::indices(function, robot.freedoms(), span.len());
            let (Some(symbol), Some(indices)) = (function.row().symbol, indices) else {
                continue;
            };
            for (value, indices) in values[span].iter().zip(indices) {
                let formula = value.as_ref().map(|polynomial| {
                    let (terms, expression) = collected(polynomial);
                    Formula { expression, terms }
                });
                entries.push(Entry {
                    function,
                    symbol,
                    indices,
                    formula: formula.map_err(|too_long| *too_long),
                });
            }
        }
        // Divisors are read only if a formula is short enough, and to round them takes long.
        let is_read = entries.iter().any(|entry| entry.formula.is_ok());
        let read = atoms.divisors.iter().filter(|_| is_read);
        let divisors = read.map(|divisor| collected(divisor).1).collect();
        Formulas {
            names: Names::new(robot, groups, atoms.angles, divisors),
            entries,
        }
    }

    /// All values in order, in a format. Formulas of more than `most_terms` terms are left out.
    pub fn shown(&self, format: Format, most_terms: usize) -> Vec<Shown> {
        let shown = |entry: &Entry| Shown {
            function: entry.function,
            name: write::entry_name(format, entry.title()),
            formula: entry
                .readable(most_terms)
                .map(|formula| write::written(format, &self.names, formula)),
        };
        self.entries.iter().map(shown).collect()
    }

    /// The values whose formulas have at most `most_terms` terms, as equations.
    pub fn equations(&self, most_terms: usize) -> Vec<Equation> {
        let equation = |entry: &Entry| {
            let formula = entry.readable(most_terms).ok()?;
            let in_format = |format| write::equation(format, &self.names, entry.title(), formula);
            Some(Equation {
                name: write::entry_name(Format::Text, entry.title()),
                text: in_format(Format::Text),
                latex: in_format(Format::Latex),
                mathml: in_format(Format::MathMl),
            })
        };
        self.entries.iter().filter_map(equation).collect()
    }

    /// The meaning of the short names in the formulas of at most `most_terms` terms: `c12 = cos(q1 + q2)`.
    pub fn legend(&self, most_terms: usize) -> Vec<String> {
        let entries = self.entries.iter();
        let formulas = entries.filter_map(|entry| entry.readable(most_terms).ok());
        write::legend(&self.names, formulas)
    }
}

impl Entry {
    /// The letter of the function and the indices of the value.
    fn title(&self) -> (&str, &[usize]) {
        (self.symbol, &self.indices)
    }

    fn readable(&self, most_terms: usize) -> Result<&Expression, TooLong> {
        match &self.formula {
            Err(too_long) => Err(*too_long),
            Ok(formula) if formula.terms > most_terms => Err(TooLong {
                terms: formula.terms,
                or_more: false,
            }),
            Ok(formula) => Ok(&formula.expression),
        }
    }
}
