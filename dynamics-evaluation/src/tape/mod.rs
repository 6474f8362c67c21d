//! Programs as they are evaluated: a step for each line, between numbered places.
//!
//! A number that depends on constants and fields alone is computed once when a field changes. A number that depends on
//! the state gets a slot, which others take over after its last reader. Lines are put into an order that keeps few
//! numbers, and in which a line follows the one whose result it reads (`order`). The Panda's forward dynamics of 1,065
//! operations needs 87 slots, 107 in the order in which it is emitted. A call is the same operations in the same order
//! as the generated method, and its digits are the same: `Program::lines` says for both which products are written into
//! sums.

mod build;
mod lines;
mod order;
mod places;
mod staged;

pub(crate) use lines::is_shared_symbol;
pub(crate) use staged::Staged;

use dynamics_symbolic::robot::Symbol;

/// A program as it is evaluated.
///
/// All states share the numbers that depend on constants and fields alone. A number of a state has a slot, which others
/// take over after its last reader, or none where the next operation alone reads it.
#[derive(Clone, Debug)]
pub(crate) struct Tape {
    /// The constants that are read, the first of the shared numbers.
    pub(crate) constants: Vec<f64>,
    /// Fields, and sines and cosines of angles made of them: the next ones.
    pub(crate) parameters: Vec<Symbol>,
    /// Their results: the last ones, one for each operation.
    pub(crate) shared: Vec<Operation>,
    /// The numbers that are read of a state.
    pub(crate) inputs: Vec<Symbol>,
    /// The work at each state.
    pub(crate) steps: Vec<Step>,
    /// The number of slots.
    pub(crate) slots: usize,
    /// The outputs in the order of the program.
    pub(crate) outputs: Vec<Output>,
}

/// Where an operand is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Place {
    /// Nowhere: it is the result of the operation before.
    Last,
    /// Among the numbers that all states share.
    Shared(u16),
    /// In a slot.
    Slot(u16),
}

impl Place {
    /// Its number there.
    pub(crate) fn index(self) -> u16 {
        match self {
            Place::Last => 0,
            Place::Shared(index) | Place::Slot(index) => index,
        }
    }
}

/// A step at each state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Step {
    /// Reads the input of that index into a slot.
    Read { input: u16, to: u16 },
    /// Sine and cosine of a joint's position.
    SinCos {
        joint: u16,
        /// The slot of the sine.
        sine: u16,
        /// The slot of the cosine.
        cosine: u16,
    },
    /// An operation.
    Compute {
        operation: Operation,
        /// The slot of the result; none where the next step, an operation too, alone reads it.
        to: Option<u16>,
    },
}

/// One line of a program between places, of which one at most is the last result. Factors that may be exchanged, and
/// the terms of a sum, stand in the order of their places: the last result before what all states share, and that
/// before slots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Operation {
    Add(Place, Place),
    Sub(Place, Place),
    Mul(Place, Place),
    Div(Place, Place),
    /// x y + c, rounded once where that is one instruction, as all that follow
    MulAdd(Place, Place, Place),
    /// x y - c
    MulSub(Place, Place, Place),
    /// c - x y
    NegMulAdd(Place, Place, Place),
    /// x y + a b, where a b is rounded by itself
    Sum(Place, Place, Place, Place),
    /// a b - x y, where a b is rounded by itself
    Difference(Place, Place, Place, Place),
}

/// An output: where it is, and whether its sign is changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Output {
    pub(crate) place: Place,
    /// Whether the output is minus the value there.
    pub(crate) negative: bool,
}
