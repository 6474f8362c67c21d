//! The report of a comparison.

use core::fmt;

use dynamics_runtime::{Conditioning, Pose, SizedState};
use nalgebra::Dyn;

use super::deviation::Deviation;
use super::functions::reason;

/// The largest error of every generated function, and where it occurs.
///
/// Printed, it is a table, then the functions that could not be compared, then the states of the errors beyond the
/// tolerance. The alternate form `{:#}` prints the states of the largest errors of all functions.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[must_use]
#[non_exhaustive]
pub struct Report {
    /// One entry for each function that was compared, and one for each part of a method that returns
    /// several functions.
    pub functions: Vec<FunctionReport>,
    /// The functions that could be compared at no state. Forward dynamics is one of them if the mass matrix is singular
    /// everywhere, because an error is the right answer then. So is a regressor without `base_parameters`, or these
    /// without a regressor, because only their product is compared.
    pub not_compared: Vec<&'static str>,
    /// Number of states at which the robot was evaluated.
    pub states: usize,
    /// Seed of the random states.
    pub seed: u64,
    /// The state at which the mass matrix of the table is nearest to singular: its name, the joint and
    /// the least pivot.
    pub nearest_to_singular: Option<(String, Conditioning)>,
    joint_names: Vec<String>,
}

/// The largest error of one function, relative to the natural scale of its values.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct FunctionReport {
    /// Name of the function.
    pub function: &'static str,
    /// The frame that it is about, by its name in methods; `None` for the tip, and for a function that is about no frame.
    pub frame: Option<String>,
    /// The method that returned it with others; `None` where the function has a method of its own.
    pub method: Option<String>,
    /// Number of states at which it was compared.
    pub states: usize,
    /// The largest relative error; infinite where a value was not a number.
    pub error: f64,
    /// The largest proven bound of the function's rounding at any of the states, relative to the same scale. It is
    /// infinite if nothing is proven, and `None` if it was not requested.
    pub rounding: Option<f64>,
    /// The largest error that passes.
    pub tolerance: f64,
    /// Whether nothing can be said there, because the numbers that are compared with are not finite.
    pub overflows: bool,
    /// The joint of the entry with the largest error, counted from 0, where there is one.
    pub joint: Option<usize>,
    /// Name of the state of the largest error.
    pub label: String,
    /// Where a base that moves stands there: its rotation by rows, then its position, m; `None` for a base that stands.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub base: Option<[f64; 12]>,
    /// Joint positions there.
    pub q: Vec<f64>,
    /// Velocities there, of a base that moves and of the joints.
    pub qd: Vec<f64>,
    /// Accelerations there.
    pub qdd: Vec<f64>,
}

impl FunctionReport {
    /// Whether the error is within the tolerance.
    pub fn is_ok(&self) -> bool {
        self.error <= self.tolerance
    }

    fn verdict(&self) -> &'static str {
        match (self.is_ok(), self.overflows) {
            (true, _) => "ok",
            (_, true) => "overflow",
            (_, false) => "WRONG",
        }
    }

    /// The function with its frame, and the method that returned it where that is another.
    fn name(&self) -> String {
        let frame = self.frame.as_ref();
        let name = frame.map_or(self.function.into(), |frame| {
            format!("{}_{frame}", self.function)
        });
        match &self.method {
            None => name,
            Some(method) => format!("{name} of {method}"),
        }
    }

    fn is_of(&self, function: &str, of: Of<'_>) -> bool {
        (self.function, self.frame.as_deref(), self.method.as_deref())
            == (function, of.frame, of.method)
    }
}

/// Where a function was found.
#[derive(Clone, Copy)]
pub(super) struct Of<'a> {
    /// The method that returned it with others.
    pub(super) method: Option<&'a str>,
    /// The frame that it is about.
    pub(super) frame: Option<&'a str>,
}

impl Report {
    pub(super) fn new(joint_names: Vec<String>, states: usize, seed: u64) -> Self {
        Report {
            functions: Vec::new(),
            not_compared: Vec::new(),
            states,
            seed,
            nearest_to_singular: None,
            joint_names,
        }
    }

    /// Keeps the least relative pivot; one that is not a number is less than any other.
    pub(super) fn note_conditioning(&mut self, label: &str, found: Conditioning) {
        let is_least = self.nearest_to_singular.as_ref().is_none_or(|(_, least)| {
            let (found, least) = (found.relative_pivot, least.relative_pivot);
            !least.is_nan() && (found.is_nan() || found < least)
        });
        if is_least {
            self.nearest_to_singular = Some((label.into(), found));
        }
    }

    /// Takes in what was found at one state, of a function or of a part of a method.
    pub(super) fn record(
        &mut self,
        of: Of<'_>,
        deviation: &Deviation,
        tolerance: f64,
        label: &str,
        (base, state): (Option<&Pose<f64>>, &SizedState<Dyn>),
    ) {
        let Some(error) = deviation.error else {
            self.miss(deviation.function);
            return;
        };
        let entry = self.entry(deviation.function, of, tolerance);
        entry.states += 1;
        if entry.states == 1 || error > entry.error {
            entry.error = error;
            entry.overflows = deviation.overflows;
            entry.joint = deviation.joint;
            entry.label = label.into();
            entry.base = base.map(|base| base.entries().into());
            [entry.q, entry.qd, entry.qdd] =
                [&state.q, &state.qd, &state.qdd].map(|values| values.as_slice().to_vec());
        }
    }

    /// Takes in what a function of its own method rounds at most at one state.
    pub(super) fn note_rounding(&mut self, frame: Option<&str>, found: &Deviation) {
        let method = None;
        let is_it = |f: &&mut FunctionReport| f.is_of(found.function, Of { method, frame });
        let known = self.functions.iter_mut().find(is_it);
        if let (Some(entry), Some(_)) = (known, found.error) {
            let largest = entry.rounding.unwrap_or_default().max(found.rounding);
            entry.rounding = Some(largest);
        }
    }

    /// Notes a function that could not be compared at a state, unless it was at another.
    fn miss(&mut self, function: &'static str) {
        let compared = self.functions.iter().any(|f| f.function == function);
        if !compared && !self.not_compared.contains(&function) {
            self.not_compared.push(function);
        }
    }

    fn entry(&mut self, function: &'static str, of: Of<'_>, tolerance: f64) -> &mut FunctionReport {
        let known = self.functions.iter().position(|f| f.is_of(function, of));
        let index = known.unwrap_or_else(|| {
            self.not_compared.retain(|missed| *missed != function);
            self.functions.push(FunctionReport {
                function,
                frame: of.frame.map(String::from),
                method: of.method.map(String::from),
                states: 0,
                error: 0.0,
                rounding: None,
                tolerance,
                overflows: false,
                joint: None,
                label: String::new(),
                base: None,
                q: Vec::new(),
                qd: Vec::new(),
                qdd: Vec::new(),
            });
            self.functions.len() - 1
        });
        &mut self.functions[index]
    }

    /// Whether every error is within its tolerance, there was something to compare, and no pivot of the table's mass
    /// matrix is negative: such an arm cannot be simulated, right as its functions are.
    pub fn is_ok(&self) -> bool {
        !self.functions.is_empty()
            && self.functions.iter().all(FunctionReport::is_ok)
            && !self.has_negative_inertia()
    }

    /// Whether the mass matrix has a pivot that is negative by more than rounding.
    pub fn has_negative_inertia(&self) -> bool {
        let nearest = self.nearest_to_singular.as_ref();
        nearest.is_some_and(|(_, nearest)| nearest.relative_pivot < -NEGATIVE)
    }

    /// Panics with the printed report unless [`Report::is_ok`].
    #[track_caller]
    pub fn assert_ok(&self) {
        assert!(self.is_ok(), "{self}");
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "comparison with recursive Newton-Euler at {} states (seed {})",
            self.states, self.seed
        )?;
        if self.functions.is_empty() {
            write!(f, "\nno function of this robot can be compared")?;
        } else {
            self.fmt_table(f)?;
        }
        if let Some((label, nearest)) = &self.nearest_to_singular {
            let (pivot, joint) = (nearest.relative_pivot, &self.joint_names[nearest.joint]);
            let (not, or, so) = if self.has_negative_inertia() {
                (
                    "NOT positive definite, ",
                    "",
                    "the inertia that the joint feels is negative: check masses, inertia tensors and motors for data that \
                     no body can have"
                        .to_owned(),
                )
            } else {
                let lost = nearest.lost_digits();
                (
                    "",
                    " at least",
                    format!("{lost:.1} digits of accelerations lost"),
                )
            };
            write!(
                f,
                "\nmass matrix: {not}relative pivot {pivot:.1e}{or}, of joint {joint} in state {label:?}: {so}"
            )?;
        }
        for function in &self.not_compared {
            let reason = reason(function);
            write!(f, "\n{function}: not compared at any state ({reason})")?;
        }
        for function in &self.functions {
            if f.alternate() || !function.is_ok() {
                write!(f, "\n{function}")?;
            }
        }
        Ok(())
    }
}

/// The most that rounding takes from a pivot, relative to its diagonal entry.
const NEGATIVE: f64 = 1e-10;

const COLUMNS: usize = 8;
const HEADS: [&str; COLUMNS] = [
    "function",
    "states",
    "error",
    "rounding",
    "tolerance",
    "",
    "joint",
    "state",
];
const NUMBERS: core::ops::RangeInclusive<usize> = 1..=4;
/// The column that is left out where no function has an entry in it.
const ROUNDING: usize = 3;

impl Report {
    fn cells(&self, row: &FunctionReport) -> [String; COLUMNS] {
        [
            row.name(),
            row.states.to_string(),
            format!("{:.1e}", row.error),
            row.rounding
                .map_or_else(String::new, |x| format!("{x:.1e}")),
            format!("{:.1e}", row.tolerance),
            row.verdict().into(),
            row.joint.map_or("", |i| &self.joint_names[i]).into(),
            row.label.clone(),
        ]
    }

    /// Names to the left, numbers to the right of their columns.
    fn fmt_table(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut lines = vec![HEADS.map(String::from)];
        lines.extend(self.functions.iter().map(|row| self.cells(row)));
        let has_rounding = self.functions.iter().any(|row| row.rounding.is_some());
        let width = |i: usize| lines.iter().map(|line| line[i].chars().count()).max();
        let widths: [usize; COLUMNS] = core::array::from_fn(|i| width(i).unwrap_or(0));
        for line in &lines {
            let cells = line.iter().zip(widths).enumerate();
            let shown = cells.filter(|(i, _)| *i != ROUNDING || has_rounding);
            let padded = shown.map(|(i, (cell, width))| {
                if NUMBERS.contains(&i) {
                    format!("{cell:>width$}")
                } else {
                    format!("{cell:width$}")
                }
            });
            let text: Vec<String> = padded.collect();
            write!(f, "\n{}", text.join("  ").trim_end())?;
        }
        Ok(())
    }
}

/// The function, its error and the state of the error.
impl fmt::Display for FunctionReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{}: error {:.1e} at {:?}",
            self.name(),
            self.error,
            self.label
        )?;
        if let Some(base) = &self.base {
            write!(f, "\n  base = {base:?}")?;
        }
        write!(
            f,
            "\n  q = {:?}\n  qd = {:?}\n  qdd = {:?}",
            self.q, self.qd, self.qdd
        )
    }
}
