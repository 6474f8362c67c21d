//! Straight-line programs: what is proven, and what is emitted.

mod angle;
mod arithmetic;
mod balance;
mod build;
mod circle;
mod constant;
mod count;
mod cycles;
mod evaluate;
mod line;
mod order;
mod readers;
mod real;
mod signed;

pub use angle::rounded_angle;
pub use arithmetic::Arithmetic;
pub(crate) use arithmetic::by_operators;
pub use circle::sine_and_cosine;
pub use constant::{Constant, ConstantId, ConstantPool};
pub use count::Operations;
pub use line::{Line, Rest};
pub(crate) use readers::Readers;
pub use real::{Approximation, Real};
pub use signed::UpToSign;

use crate::function::{Freedoms, Request, Sizes, sizes_of};
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

impl Operand {
    /// The index of the instruction whose result it is.
    pub(crate) fn result(self) -> Option<u32> {
        match self {
            Operand::Result(index) => Some(index),
            Operand::Constant(_) | Operand::Input(_) => None,
        }
    }
}

impl Instruction {
    /// The same operation of other operands.
    pub(crate) fn map(self, mut other: impl FnMut(Operand) -> Operand) -> Self {
        match self {
            Instruction::Add(a, b) => Instruction::Add(other(a), other(b)),
            Instruction::Sub(a, b) => Instruction::Sub(other(a), other(b)),
            Instruction::Mul(a, b) => Instruction::Mul(other(a), other(b)),
            Instruction::Div(a, b) => Instruction::Div(other(a), other(b)),
        }
    }

    /// The two operands.
    pub fn operands(&self) -> [Operand; 2] {
        match *self {
            Instruction::Add(a, b)
            | Instruction::Sub(a, b)
            | Instruction::Mul(a, b)
            | Instruction::Div(a, b) => [a, b],
        }
    }

    /// The sign of the operation, which all languages have in common.
    pub fn operator(&self) -> char {
        match self {
            Instruction::Add(..) => '+',
            Instruction::Sub(..) => '-',
            Instruction::Mul(..) => '*',
            Instruction::Div(..) => '/',
        }
    }
}

/// An output of a program: a value, or minus that value.
pub type Output = UpToSign;

/// A program without branches: each instruction reads inputs, constants and earlier results.
#[derive(Clone, Debug)]
pub struct Program {
    /// The meanings of the inputs.
    pub inputs: Vec<Symbol>,
    /// The exact constants.
    pub constants: ConstantPool,
    /// The instructions in order of execution.
    pub instructions: Vec<Instruction>,
    /// The outputs in the order of the function's contract.
    pub outputs: Vec<Output>,
    /// Whether this is the plain recursion, because every shorter program loses digits.
    pub is_plain: bool,
}

/// A program that is equal to the textbook definition of what it computes.
#[derive(Clone, Debug)]
pub struct Proven {
    /// The program.
    pub program: Program,
    /// Its constants, correctly rounded; NaN where the program reads none.
    pub constants: Vec<f64>,
}

impl Proven {
    /// A program that was proven, with its constants rounded.
    pub(crate) fn rounding(program: Program) -> Self {
        let constants = program.rounded_constants();
        Proven { program, constants }
    }

    /// The same for a compiler that keeps the order of lines.
    pub fn ordered(&self) -> Self {
        Proven {
            program: self.program.ordered(),
            constants: self.constants.clone(),
        }
    }

    /// Whether a constant is too large for a double.
    pub(crate) fn overflows(&self) -> bool {
        self.constants.iter().any(|x| x.is_infinite())
    }

    /// The sizes in the shapes of the functions that the program computes, of so many joints.
    pub fn sizes(&self, request: &Request, freedoms: impl Into<Freedoms>) -> Sizes {
        sizes_of(request.parts(), freedoms, self.program.outputs.len())
    }
}

impl Program {
    /// The constants as doubles, correctly rounded; NaN where the program reads none.
    pub fn rounded_constants(&self) -> Vec<f64> {
        let needed = self.needed_constants();
        self.constants
            .round(|id| needed.get(id.index()).copied().unwrap_or(false))
    }

    /// The factors of the product that an operand is, if it is one.
    pub(crate) fn product(&self, operand: Operand) -> Option<(Operand, Operand)> {
        let Operand::Result(index) = operand else {
            return None;
        };
        match self.instructions[index as usize] {
            Instruction::Mul(a, b) => Some((a, b)),
            _ => None,
        }
    }

    /// Whether instructions or outputs read a constant; others serve to define it.
    pub(crate) fn needed_constants(&self) -> Vec<bool> {
        let read = self.instructions.iter().flat_map(Instruction::operands);
        let operands = read.chain(self.outputs.iter().map(|output| output.operand));
        let mut needed = Vec::new();
        for operand in operands {
            if let Operand::Constant(id) = operand {
                if needed.len() <= id.index() {
                    needed.resize(id.index() + 1, false);
                }
                needed[id.index()] = true;
            }
        }
        needed
    }
}
