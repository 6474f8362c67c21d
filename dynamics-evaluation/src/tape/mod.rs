//! Programs as they are evaluated: a step for each line, between numbered places.

mod build;
mod order;
mod places;

use dynamics_symbolic::robot::Symbol;

/// A program as it is evaluated.
///
/// What depends on constants and fields alone is a number that all states share; what depends on the
/// state has a slot, which others take over after its last reader.
#[derive(Clone, Debug)]
pub(crate) struct Tape {
    /// The constants that are read, the first of the shared numbers.
    pub(crate) constants: Vec<f64>,
    /// Fields, and sines and cosines of angles made of them: the next ones.
    pub(crate) parameters: Vec<Symbol>,
    /// What is computed of these: the last ones, one for each operation.
    pub(crate) shared: Vec<Operation>,
    /// What is read of a state.
    pub(crate) inputs: Vec<Symbol>,
    /// What is done at each state.
    pub(crate) steps: Vec<Step>,
    /// How many slots that takes.
    pub(crate) slots: usize,
    /// The outputs in the order of the program.
    pub(crate) outputs: Vec<Output>,
}

/// Where an operand is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// Among the numbers that all states share.
    Shared(u16),
    /// In a slot.
    Slot(u16),
}

/// A step at each state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Step {
    /// Reads the input of that index into a slot.
    Read {
        /// The input.
        input: u16,
        /// The slot.
        to: u16,
    },
    /// Sine and cosine of a joint's position.
    SinCos {
        /// The joint.
        joint: u16,
        /// The slot of the sine.
        sine: u16,
        /// The slot of the cosine.
        cosine: u16,
    },
    /// An operation.
    Compute {
        /// What is computed.
        operation: Operation,
        /// The slot of the result.
        to: u16,
    },
}

/// One line of a program between places.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Operation {
    /// a + b
    Add(Place, Place),
    /// a - b
    Sub(Place, Place),
    /// a b
    Mul(Place, Place),
    /// a / b
    Div(Place, Place),
    /// x y + c, rounded once where that is one instruction, as all that follow
    MulAdd([Place; 2], Place),
    /// x y - c
    MulSub([Place; 2], Place),
    /// c - x y
    NegMulAdd([Place; 2], Place),
    /// x y + a b, where a b is rounded by itself
    Sum([Place; 2], [Place; 2]),
    /// a b - x y, where a b is rounded by itself
    Difference([Place; 2], [Place; 2]),
    /// The number itself: what all states share, in a slot.
    Copy(Place),
}

/// An output: where it is, and whether its sign is changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Output {
    /// The place.
    pub(crate) place: Place,
    /// Whether minus that is put out.
    pub(crate) negative: bool,
}
