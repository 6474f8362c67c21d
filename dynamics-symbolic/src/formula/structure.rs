//! The structure of a function's values, which is known however long their formulas are.

use super::entries::{Letter, digits};
use crate::function::{Argument, Freedoms, Function, Shape, Size};
use crate::program::{Constant, Operand, Output, Program};
use crate::robot::{Robot, Symbol};
use core::ops::Range;
use std::collections::{BTreeMap, BTreeSet};

/// More values than this are counted and not listed.
const MOST_LISTED: usize = 49;

/// The values of a function that are zero or constant, and the variables that the others depend on.
pub struct Structure {
    freedoms: Freedoms,
    values: usize,
    zero: Vec<String>,
    constant: Vec<String>,
    /// Values by what they depend on.
    variable: BTreeMap<BTreeSet<Variable>, Vec<String>>,
}

/// An entry of an argument, such as the position of one joint.
type Variable = (Argument, usize);

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
        let indices = indices(function, robot.freedoms(), outputs.len())?;
        if outputs.len() < 2 {
            return None;
        }
        let results = variables(robot, program);
        let is_symmetric = is_symmetric(outputs, &indices);
        let mut structure = Structure {
            freedoms: robot.freedoms(),
            values: outputs.len(),
            zero: Vec::new(),
            constant: Vec::new(),
            variable: BTreeMap::new(),
        };
        for (output, index) in outputs.iter().zip(&indices) {
            if is_symmetric && matches!(index.as_slice(), [i, j] if i > j) {
                continue;
            }
            let name = format!("{symbol}{}", digits(index));
            let is_zero =
                |id| matches!(program.constants.get(id), Constant::Rational(x) if x.is_zero());
            let depends_on = read(robot, program, &results, output.operand);
            let names = match output.operand {
                Operand::Constant(id) if is_zero(id) => &mut structure.zero,
                _ if depends_on.is_empty() => &mut structure.constant,
                _ => structure.variable.entry(depends_on).or_default(),
            };
            names.push(name);
        }
        Some(structure)
    }

    /// A sentence: `M13 is zero; M33 is constant; M11 depends on q2, q3.`
    pub fn sentence(&self) -> String {
        let is_counted = self.values > MOST_LISTED;
        let mut clauses = Vec::new();
        for (names, kind) in [(&self.zero, "zero"), (&self.constant, "constant")] {
            let count = names.len().to_string();
            let subject = if is_counted { count } else { names.join(", ") };
            match names.len() {
                0 => {}
                1 => clauses.push(format!("{subject} is {kind}")),
                _ => clauses.push(format!("{subject} are {kind}")),
            }
        }
        if is_counted {
            let all = list(
                self.freedoms,
                &self.variable.keys().flatten().copied().collect(),
            );
            let count = self.values;
            clauses.push(format!("of {count} values all depend on {all} at most"));
        } else {
            for (variables, names) in &self.variable {
                let (subject, variables) = (names.join(", "), list(self.freedoms, variables));
                let ending = if names.len() == 1 { "s" } else { "" };
                clauses.push(format!("{subject} depend{ending} on {variables}"));
            }
        }
        format!("{}.", clauses.join("; "))
    }
}

/// `q2 to q5, qd1`. The numbers of a base are one run, and those of the joints another.
fn list(freedoms: Freedoms, variables: &BTreeSet<Variable>) -> String {
    let begins = |argument: &Argument, index| match argument {
        Argument::Base => true,
        Argument::Position => false,
        _ => freedoms.has_base() && index == freedoms.base,
    };
    let mut runs: Vec<(Variable, usize)> = Vec::new();
    for &(argument, index) in variables {
        match runs.last_mut() {
            Some(((last, _), end))
                if *last == argument && *end + 1 == index && !begins(&argument, index) =>
            {
                *end = index;
            }
            _ => runs.push(((argument, index), index)),
        }
    }
    let name = |((argument, start), end): &(Variable, usize)| {
        let [first, last] = [start, end].map(|&index| Letter::new(freedoms, *argument, index).text);
        match end - start {
            0 => first,
            1 => format!("{first}, {last}"),
            _ => format!("{first} to {last}"),
        }
    };
    let names: Vec<String> = runs.iter().map(name).collect();
    names.join(", ")
}

/// The variables that each instruction depends on.
fn variables(robot: &Robot, program: &Program) -> Vec<BTreeSet<Variable>> {
    let mut sets: Vec<BTreeSet<Variable>> = Vec::with_capacity(program.instructions.len());
    for instruction in &program.instructions {
        let [a, b] = instruction.operands();
        let mut both = read(robot, program, &sets, a);
        both.extend(read(robot, program, &sets, b));
        sets.push(both);
    }
    sets
}

/// The variables that an operand depends on; `results` has those of the instructions so far.
fn read(
    robot: &Robot,
    program: &Program,
    results: &[BTreeSet<Variable>],
    operand: Operand,
) -> BTreeSet<Variable> {
    match operand {
        Operand::Constant(_) => BTreeSet::new(),
        Operand::Input(i) => variable(robot, &program.inputs[i as usize])
            .into_iter()
            .collect(),
        Operand::Result(i) => results[i as usize].clone(),
    }
}

/// The variable that a symbol depends on; a follower's symbols depend on the joint that it follows.
fn variable(robot: &Robot, symbol: &Symbol) -> Option<Variable> {
    let (argument, index) = symbol.argument()?;
    let follower = robot.follower_of(symbol);
    let leader = follower.and_then(|_| robot.followed(index));
    let freedom = leader.map_or(index, |(leader, _)| leader);
    Some((argument, robot.entry_of(argument, freedom)))
}

/// The indices of the values of a function that are numbers, vectors or matrices, counted from 1.
pub(super) fn indices(
    function: Function,
    freedoms: Freedoms,
    values: usize,
) -> Option<Vec<Vec<usize>>> {
    let sizes = function.sizes(freedoms, values);
    match function.shape() {
        Shape::Number => Some(vec![Vec::new()]),
        Shape::Matrix(_, Size::One) => Some((1..=values).map(|i| vec![i]).collect()),
        Shape::Matrix(_, columns) => {
            let columns = columns.of(sizes).max(1);
            let index = |k: usize| vec![k / columns + 1, k % columns + 1];
            Some((0..values).map(index).collect())
        }
        Shape::Each(..) | Shape::Tuple(_) | Shape::Series => None,
    }
}

fn is_symmetric(outputs: &[Output], indices: &[Vec<usize>]) -> bool {
    let at = |i: usize, j: usize| {
        let place = indices.iter().position(|index| *index == [i, j]);
        place.map(|place| outputs[place])
    };
    let mut values = indices.iter().zip(outputs);
    values.all(|(index, output)| match index.as_slice() {
        [i, j] => at(*j, *i) == Some(*output),
        _ => false,
    })
}
