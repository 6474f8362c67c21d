//! The way from the pose of a frame to the positions of the joints.

use crate::function::Argument;
use crate::program::{Operand, Program, Proven};
use crate::robot::Symbol;
use core::ops::Range;

/// One joint after the other, each from an equation in which it is the only unknown.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The steps, in the order in which they are taken.
    pub steps: Vec<Step>,
    /// Coefficients of all steps, those of one after those of the other. It reads the pose, and sines and cosines or positions
    /// of joints from earlier steps.
    pub program: Program,
    /// How many joints move.
    pub joints: usize,
    /// The part of the pose that is read.
    pub target: Target,
    /// The names of the branches.
    pub branches: BranchNames,
    /// The elbow of seven joints: the line from the shoulder to the wrist, the way from it to the elbow, and the direction of
    /// axis 4. All are in the frame of the first joint before it moves, and their size stands behind them.
    pub elbow: Option<Program>,
}

/// The branches of a plan.
#[derive(Clone, Debug, Default)]
pub struct BranchNames {
    /// The joints with two roots, by their numbers.
    pub joints: Vec<usize>,
    /// A name for each choice of roots: a joint's second root adds one bit to the index, the first joint's the least.
    pub names: Vec<String>,
}

/// The part of a pose that an arm reaches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// All of it.
    Pose,
    /// The position of its origin.
    Position,
    /// All of it, and the angle of the elbow of seven joints.
    PoseAndElbow,
    /// The position, and the angle about the axis that all joints have in common.
    PositionAndAngle,
}

/// Where numbers begin behind the twelve entries of the pose: first sine and cosine of the elbow's angle.
pub const ELBOW: usize = 12;

/// A step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// Solves for the joint of that number among those that move.
    Joint(usize, Rule),
    /// Coefficients `x`, `y`, `z`, another vector, `size`: finds the direction of the first vector, or of the other one if the
    /// square of the first vanishes beside `size`. Its three numbers begin at that place behind the entries of the pose.
    Direction(usize),
    /// Coefficients `x`, `y`, `z`, `size`: the pose is out of reach unless the square of the vector vanishes beside `size`.
    Condition,
}

/// The equation of a joint, by its coefficients.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// `cosine`, `sine`, `length`, `size`: the angle whose cosine and sine are these over `length`. If that vanishes beside
    /// `size`, any angle will do.
    Turn,
    /// `a`, `b`, `c`, `discriminant`, `size`: a cos q + b sin q = c, with the discriminant a^2 + b^2 - c^2 in the form that keeps
    /// most digits. `size` is as large as the numbers that the discriminant is the sum of, or zero if it is a square.
    Turns,
    /// `a`, `b`, `c` of a point, `u`, `v`, `w` of the direction of a line on which it is, `size`: the equation of `Turns` holds for
    /// both, and for their sum with any factor. The solver takes the root of `size`, or its negative.
    TurnsOfLine,
    /// `d`: the position itself.
    Slide,
    /// `b`, `discriminant`, `size`: d = b + root or b - root of the discriminant, a difference of numbers as large as `size`.
    Slides,
}

impl Step {
    /// The function that solves it, in the runtime and in files of other languages; how many coefficients it has, and how
    /// many solutions at most.
    const fn row(self) -> (&'static str, usize, usize) {
        match self {
            Step::Joint(_, Rule::Turn) => ("turn", 4, 1),
            Step::Joint(_, Rule::Turns) => ("turns", 5, 2),
            Step::Joint(_, Rule::TurnsOfLine) => ("turns_of_line", 7, 2),
            Step::Joint(_, Rule::Slide) => ("slide", 1, 1),
            Step::Joint(_, Rule::Slides) => ("slides", 3, 2),
            Step::Direction(_) => ("direction", 7, 1),
            Step::Condition => ("is_reached", 4, 1),
        }
    }

    /// The function that solves it.
    pub const fn name(self) -> &'static str {
        self.row().0
    }

    /// How many coefficients it has.
    pub const fn coefficients(self) -> usize {
        self.row().1
    }

    /// How many solutions it has at most.
    pub const fn solutions(self) -> usize {
        self.row().2
    }

    /// The part of its solution that a symbol of the program stands for; `None` of another step's.
    pub fn part(self, symbol: &Symbol) -> Option<&'static str> {
        match (self, symbol) {
            (Step::Joint(joint, _), Symbol::Sine(i) | Symbol::Position(i)) if *i == joint => {
                Some("sine")
            }
            (Step::Joint(joint, _), Symbol::Cosine(i)) if *i == joint => Some("cosine"),
            (Step::Direction(place), Symbol::Entry(Argument::Pose, k)) => {
                ["x", "y", "z"].get(k.checked_sub(place)?).copied()
            }
            _ => None,
        }
    }
}

impl Plan {
    /// The program of a plan that was proven, with rounded constants.
    pub fn proven(&self) -> Proven {
        Proven::rounding(self.program.clone())
    }

    /// The program of seven joints' elbow, with rounded constants.
    pub fn proven_elbow(&self) -> Option<Proven> {
        self.elbow.clone().map(Proven::rounding)
    }

    /// The place of an entry of the pose, one of the first twelve: its row and its column.
    pub fn place_in_pose(entry: usize) -> (usize, usize) {
        if entry < 9 {
            (entry / 3, entry % 3)
        } else {
            (entry - 9, 3)
        }
    }

    /// The most solutions.
    pub fn most(&self) -> usize {
        self.steps.iter().map(|step| step.solutions()).product()
    }

    /// The coefficients of the step of that number, among the outputs of the program.
    pub fn outputs_of(&self, step: usize) -> Range<usize> {
        let before = self.steps[..step].iter();
        let first = before.map(|step| step.coefficients()).sum();
        first..first + self.steps[step].coefficients()
    }

    /// Whether the equation of a step may have no solution at a pose that is in reach of other positions of joints before it.
    /// Without a size its discriminant is a square.
    fn may_fail(&self, step: usize) -> bool {
        let has_two = self.steps[step].solutions() == 2;
        let size = self.outputs_of(step).end - 1;
        let constants = self.program.rounded_constants();
        let is_zero = match self.program.outputs[size].operand {
            Operand::Constant(id) => constants[id.index()] == 0.0,
            Operand::Input(_) | Operand::Result(_) => false,
        };
        has_two && !is_zero
    }

    /// The joints whose families ask how far the equation of a step is from having a solution.
    pub fn families_before(&self, step: usize) -> Vec<usize> {
        let earlier = self.steps[..step].iter().enumerate();
        let joints = earlier.filter_map(|(k, step)| match step {
            Step::Joint(joint, _) if self.has_family(k) => Some(*joint),
            _ => None,
        });
        let fails = self.may_fail(step);
        joints.filter(|_| fails).collect()
    }

    /// Whether other positions of a joint, where a pose leaves it free, may decide if the equation of a later one has a
    /// solution: that of a step reads it.
    pub fn has_family(&self, step: usize) -> bool {
        let slides = |rule| matches!(rule, Rule::Slide | Rule::Slides);
        let turns = matches!(self.steps[step], Step::Joint(_, rule) if !slides(rule));
        let mut later = step + 1..self.steps.len();
        turns && later.any(|k| self.may_fail(k) && self.reads(k, step))
    }

    /// Whether any joint has a family.
    pub fn has_families(&self) -> bool {
        (0..self.steps.len()).any(|step| self.has_family(step))
    }

    /// Whether the coefficients of a step read the solution of an earlier one.
    fn reads(&self, step: usize, earlier: usize) -> bool {
        let outputs = self.program.outputs[self.outputs_of(step)].iter();
        let mut stack: Vec<Operand> = outputs.map(|output| output.operand).collect();
        let mut seen = vec![false; self.program.instructions.len()];
        while let Some(operand) = stack.pop() {
            match operand {
                Operand::Input(k) => {
                    let symbol = &self.program.inputs[k as usize];
                    if self.steps[earlier].part(symbol).is_some() {
                        return true;
                    }
                }
                Operand::Result(k) if !seen[k as usize] => {
                    seen[k as usize] = true;
                    stack.extend(self.program.instructions[k as usize].operands());
                }
                Operand::Result(_) | Operand::Constant(_) => {}
            }
        }
        false
    }

    /// The inputs of the program that are parts of a step's solution, by their indices, each with the name of that part.
    pub fn inputs_of(&self, step: Step) -> impl Iterator<Item = (usize, &'static str)> {
        let inputs = self.program.inputs.iter().enumerate();
        inputs.filter_map(move |(index, symbol)| Some((index, step.part(symbol)?)))
    }

    /// For each instruction the number of steps whose joints it depends on.
    pub fn stages(&self) -> Vec<usize> {
        let program = &self.program;
        let of_input = |symbol: &Symbol| {
            let mut steps = self.steps.iter();
            let step = steps.position(|step| step.part(symbol).is_some());
            step.map_or(0, |step| step + 1)
        };
        let inputs: Vec<usize> = program.inputs.iter().map(of_input).collect();
        let mut stages: Vec<usize> = Vec::with_capacity(program.instructions.len());
        for instruction in &program.instructions {
            let of_operand = |operand: &Operand| match operand {
                Operand::Constant(_) => 0,
                Operand::Input(index) => inputs[*index as usize],
                Operand::Result(index) => stages[*index as usize],
            };
            let operands = instruction.operands();
            stages.push(operands.iter().map(of_operand).max().unwrap_or(0));
        }
        stages
    }
}
