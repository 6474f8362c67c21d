//! What can be said of the values of a function, however long their formulas are.

use crate::function::{Function, Shape, Size};
use crate::program::{Constant, Operand, Output, Program};
use crate::robot::{Robot, Symbol};
use core::ops::Range;
use std::collections::{BTreeMap, BTreeSet};

/// More values than this are counted and not listed.
const MOST_LISTED: usize = 49;

/// Which values of a function are zero or constant, and what the others depend on.
pub struct Structure {
    values: usize,
    zero: Vec<String>,
    constant: Vec<String>,
    /// Values by what they depend on.
    variable: BTreeMap<BTreeSet<Variable>, Vec<String>>,
}

/// A variable of one joint: the letter and the index of the joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Variable(Letter, usize);

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Letter {
    Position,
    Velocity,
    Acceleration,
    Force,
    Other(crate::function::Argument),
}

impl Letter {
    fn name(self) -> &'static str {
        match self {
            Letter::Position => "q",
            Letter::Velocity => "qd",
            Letter::Acceleration => "qdd",
            Letter::Force => "tau",
            Letter::Other(argument) => argument.name(),
        }
    }
}

impl Structure {
    /// The structure of the outputs in a span of a program, which are the values of a function. `None` where
    /// the values have no letter, and where there is only one.
    pub fn new(
        robot: &Robot,
        function: Function,
        program: &Program,
        span: Range<usize>,
    ) -> Option<Self> {
        let symbol = function.row().symbol?;
        let outputs = &program.outputs[span];
        let indices = indices(function, robot.dof(), outputs.len())?;
        if outputs.len() < 2 {
            return None;
        }
        let read = variables(robot, program);
        let is_symmetric = is_symmetric(outputs, &indices);
        let mut structure = Structure {
            values: outputs.len(),
            zero: Vec::new(),
            constant: Vec::new(),
            variable: BTreeMap::new(),
        };
        for (output, index) in outputs.iter().zip(&indices) {
            if is_symmetric && matches!(index.as_slice(), [i, j] if i > j) {
                continue;
            }
            let digits: String = index.iter().map(usize::to_string).collect();
            let name = format!("{symbol}{digits}");
            let depends_on = match output.operand {
                Operand::Constant(id) => {
                    match program.constants.get(id) {
                        Constant::Rational(x) if x.is_zero() => structure.zero.push(name),
                        _ => structure.constant.push(name),
                    }
                    continue;
                }
                Operand::Input(i) => variable(robot, &program.inputs[i as usize])
                    .into_iter()
                    .collect(),
                Operand::Result(i) => read[i as usize].clone(),
            };
            match depends_on.is_empty() {
                true => structure.constant.push(name),
                false => structure.variable.entry(depends_on).or_default().push(name),
            }
        }
        Some(structure)
    }

    /// A sentence: `M13 is zero; M33 is constant; M11 depends on q2, q3.`
    pub fn sentence(&self) -> String {
        let mut clauses = Vec::new();
        let is = |names: &[String]| if names.len() == 1 { "is" } else { "are" };
        if self.values > MOST_LISTED {
            let count = |names: &[String], what: &str| match names.len() {
                0 => None,
                count => Some(format!("{count} {} {what}", is(names))),
            };
            clauses.extend(count(&self.zero, "zero"));
            clauses.extend(count(&self.constant, "constant"));
            let all = self.variable.keys().flatten().copied().collect();
            clauses.push(format!(
                "of {} values all depend on {} at most",
                self.values,
                list(&all)
            ));
            return sentence(&clauses);
        }
        for (names, what) in [(&self.zero, "zero"), (&self.constant, "constant")] {
            if !names.is_empty() {
                clauses.push(format!("{} {} {what}", names.join(", "), is(names)));
            }
        }
        for (variables, names) in &self.variable {
            let depend = if names.len() == 1 {
                "depends"
            } else {
                "depend"
            };
            clauses.push(format!(
                "{} {depend} on {}",
                names.join(", "),
                list(variables)
            ));
        }
        sentence(&clauses)
    }
}

fn sentence(clauses: &[String]) -> String {
    format!("{}.", clauses.join("; "))
}

/// `q2 to q5, qd1`.
fn list(variables: &BTreeSet<Variable>) -> String {
    let mut runs: Vec<(Variable, usize)> = Vec::new();
    for &Variable(letter, index) in variables {
        match runs.last_mut() {
            Some((Variable(last, _), end)) if *last == letter && *end + 1 == index => *end = index,
            _ => runs.push((Variable(letter, index), index)),
        }
    }
    let name = |(Variable(letter, start), end): &(Variable, usize)| {
        let letter = letter.name();
        match end - start {
            0 => format!("{letter}{}", start + 1),
            1 => format!("{letter}{}, {letter}{}", start + 1, end + 1),
            _ => format!("{letter}{} to {letter}{}", start + 1, end + 1),
        }
    };
    let names: Vec<String> = runs.iter().map(name).collect();
    names.join(", ")
}

/// The variables that each instruction depends on.
fn variables(robot: &Robot, program: &Program) -> Vec<BTreeSet<Variable>> {
    let mut sets: Vec<BTreeSet<Variable>> = Vec::with_capacity(program.instructions.len());
    for instruction in &program.instructions {
        let (a, b) = instruction.operands();
        let of = |operand| match operand {
            Operand::Constant(_) => BTreeSet::new(),
            Operand::Input(i) => variable(robot, &program.inputs[i as usize])
                .into_iter()
                .collect(),
            Operand::Result(i) => sets[i as usize].clone(),
        };
        let mut both: BTreeSet<Variable> = of(a);
        both.extend(of(b));
        sets.push(both);
    }
    sets
}

fn variable(robot: &Robot, symbol: &Symbol) -> Option<Variable> {
    let (letter, index) = match symbol {
        Symbol::Pi | Symbol::Field(_) | Symbol::AngleSine(_) | Symbol::AngleCosine(_) => {
            return None;
        }
        Symbol::Sine(i) | Symbol::Cosine(i) | Symbol::Position(i) => (Letter::Position, i),
        Symbol::Velocity(i) | Symbol::VelocitySign(i) | Symbol::Stribeck(i) => {
            (Letter::Velocity, i)
        }
        Symbol::Acceleration(i) => (Letter::Acceleration, i),
        Symbol::Force(i) => (Letter::Force, i),
        Symbol::Entry(argument, i) => (Letter::Other(*argument), i),
    };
    // What a follower does depends on the joint that it follows.
    let followed = robot.followed(*index);
    let is_followed = robot.follower_of(symbol).is_some();
    let leader = followed.filter(|_| is_followed).map(|(leader, _)| leader);
    Some(Variable(letter, leader.unwrap_or(*index)))
}

/// The indices of the values of a function that are numbers, vectors or matrices, counted from 1.
pub(super) fn indices(function: Function, dof: usize, values: usize) -> Option<Vec<Vec<usize>>> {
    let sizes = function.sizes(dof, values);
    match function.shape() {
        Shape::Number => Some(vec![Vec::new()]),
        Shape::Matrix(_, Size::One) => Some((1..=values).map(|i| vec![i]).collect()),
        Shape::Matrix(_, columns) => {
            let columns = columns.of(sizes).max(1);
            let index = |k: usize| vec![k / columns + 1, k % columns + 1];
            Some((0..values).map(index).collect())
        }
        Shape::Each(_) | Shape::Tuple(_) | Shape::Series => None,
    }
}

fn is_symmetric(outputs: &[Output], indices: &[Vec<usize>]) -> bool {
    let at = |i: usize, j: usize| {
        let place = indices.iter().position(|index| *index == [i, j]);
        place.map(|place| outputs[place])
    };
    indices
        .iter()
        .enumerate()
        .all(|(k, index)| match index.as_slice() {
            [i, j] => at(*j, *i) == Some(outputs[k]),
            _ => false,
        })
}
