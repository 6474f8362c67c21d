//! Straight-line programs: what is proven, and what is emitted.

mod build;
mod constant;
mod count;
mod evaluate;
mod real;

pub use constant::{Constant, ConstantId, ConstantPool};
pub use count::Operations;
pub use evaluate::Arithmetic;
pub use real::{Approximation, Real};

use crate::robot::Symbol;

/// Something that an instruction reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Operand {
    /// A constant of the program's pool.
    Constant(ConstantId),
    /// The input of that index in [`Program::inputs`].
    Input(u32),
    /// The result of the instruction of that index.
    Result(u32),
}

/// One operation of arithmetic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Instruction {
    /// a + b
    Add(Operand, Operand),
    /// a - b
    Sub(Operand, Operand),
    /// a * b
    Mul(Operand, Operand),
    /// a / b
    Div(Operand, Operand),
}

impl Instruction {
    /// The two operands.
    pub fn operands(&self) -> (Operand, Operand) {
        match *self {
            Instruction::Add(a, b)
            | Instruction::Sub(a, b)
            | Instruction::Mul(a, b)
            | Instruction::Div(a, b) => (a, b),
        }
    }
}

/// An output: an operand, or minus the operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Output {
    /// What is put out.
    pub operand: Operand,
    /// Whether its sign is changed.
    pub negative: bool,
}

/// A program without branches: each instruction reads inputs, constants and earlier results.
#[derive(Clone, Debug)]
pub struct Program {
    /// What the inputs stand for.
    pub inputs: Vec<Symbol>,
    /// The exact constants.
    pub constants: ConstantPool,
    /// The instructions in order of execution.
    pub instructions: Vec<Instruction>,
    /// The outputs in the order of the function's contract.
    pub outputs: Vec<Output>,
}
