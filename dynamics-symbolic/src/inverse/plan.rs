//! The way from the pose of a frame to the positions of the joints.

use crate::program::{Program, Proven};

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

/// A step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Step {
    /// The symbols that it gives values to.
    pub solved: Solved,
    /// Its equation.
    pub rule: Rule,
}

/// The symbols to which a step gives values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Solved {
    /// The joint of that number among those that move.
    Joint(usize),
    /// Numbers from that place on behind the entries of the pose.
    Numbers(usize),
    /// None: it is a condition.
    Nothing,
}

/// Where numbers begin behind the twelve entries of the pose: first sine and cosine of the elbow's angle.
pub const ELBOW: usize = 12;

impl Step {
    /// The joint that it solves for.
    pub fn joint(&self) -> Option<usize> {
        match self.solved {
            Solved::Joint(joint) => Some(joint),
            Solved::Numbers(_) | Solved::Nothing => None,
        }
    }

    /// The places of the numbers that it finds behind the entries of the pose.
    pub fn numbers(&self) -> core::ops::Range<usize> {
        match self.solved {
            Solved::Numbers(place) => place..place + self.rule.numbers(),
            Solved::Joint(_) | Solved::Nothing => 0..0,
        }
    }
}

/// The equation of a step, by its coefficients.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// `cosine`, `sine`, `length`, `size`: the angle whose cosine and sine are these over `length`. If that vanishes beside
    /// `size`, any angle will do.
    Turn,
    /// `a`, `b`, `c`, `size`: a cos q + b sin q = c. `size` is as large as the squares of the numbers that c is the sum of.
    Turns,
    /// `a`, `b`, `known`, `found`, `x0`, `x1`, `y0`, `y1`, `rest`: |y - Rz(q) x|^2 + rest = found, which is
    /// a cos q + b sin q = (known - found) / 2.
    Distance,
    /// `a`, `b`, `c`, `discriminant`: as `Turns`, with a^2 + b^2 - c^2 in a form without cancellation.
    ExactTurns,
    /// `a`, `b`, `c`, `along`, `across`, `twice`: as `Turns`, with a^2 + b^2 - c^2 = (1 - along) (1 + along - twice) and
    /// (1 - along) (1 + along) = across.
    InclinedTurns,
    /// `d`: the position itself.
    Slide,
    /// `b`, `discriminant`, `size`: d = b + root or b - root of the discriminant, a difference of numbers as large as `size`.
    Slides,
    /// `square`: its root.
    Root,
    /// `x`, `y`, `z`, another vector, `size`: the direction of the first vector, or of the other one if the square of the first
    /// vanishes beside `size`.
    Direction,
    /// `x`, `y`, `z`, `size`: the pose is out of reach unless the sum of the squares of the first three vanishes beside `size`.
    Condition,
}

impl Rule {
    /// How many coefficients it has.
    pub const fn coefficients(self) -> usize {
        match self {
            Rule::Slide | Rule::Root => 1,
            Rule::Slides => 3,
            Rule::InclinedTurns => 6,
            Rule::Direction => 7,
            Rule::Distance => 9,
            Rule::Turn | Rule::Turns | Rule::ExactTurns | Rule::Condition => 4,
        }
    }

    /// How many numbers it finds that are no position of a joint.
    pub const fn numbers(self) -> usize {
        match self {
            Rule::Root => 1,
            Rule::Direction => 3,
            _ => 0,
        }
    }

    /// How many positions solve it at most.
    pub const fn solutions(self) -> usize {
        match self {
            Rule::Turns
            | Rule::Distance
            | Rule::ExactTurns
            | Rule::InclinedTurns
            | Rule::Slides => 2,
            Rule::Turn | Rule::Slide | Rule::Root | Rule::Direction | Rule::Condition => 1,
        }
    }
}

impl Plan {
    /// The program of a plan that was proven, with rounded constants.
    pub(crate) fn proven(&self) -> Proven {
        Proven::rounding(self.program.clone())
    }

    /// The place of an entry of the pose, one of the first twelve: its row and its column.
    pub(crate) fn place_in_pose(entry: usize) -> (usize, usize) {
        if entry < 9 {
            (entry / 3, entry % 3)
        } else {
            (entry - 9, 3)
        }
    }

    /// The most solutions.
    pub fn branches(&self) -> usize {
        self.steps
            .iter()
            .map(|step| step.rule.solutions())
            .product()
    }

    /// The index of each step's first coefficient among the outputs of the program.
    pub fn first_outputs(&self) -> Vec<usize> {
        let mut next = 0;
        let first = |step: &Step| {
            let first = next;
            next += step.rule.coefficients();
            first
        };
        self.steps.iter().map(first).collect()
    }
}
