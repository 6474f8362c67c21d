//! Programs some of whose lines are carried out before all inputs are known.

use dynamics_symbolic::Proven;
use dynamics_symbolic::program::{Operand, UpToSign};
use dynamics_symbolic::robot::Symbol;

use super::build::{index, operation};
use super::lines::Lines;
use super::places::TooLong;
use super::{Operation, Output, Place};

/// A program whose numbers keep their slots: the inputs first, and a result for each instruction behind them.
#[derive(Clone, Debug)]
pub(crate) struct Staged {
    /// All constants; NaN where none is read.
    constants: Vec<f64>,
    /// The meanings of the inputs.
    pub(crate) inputs: Vec<Symbol>,
    /// The operation of each instruction; none of one that is written into another one.
    operations: Vec<Option<Operation>>,
    outputs: Vec<Output>,
}

impl Staged {
    pub(crate) fn new(proven: &Proven) -> Result<Self, TooLong> {
        let (lines, program) = (Lines::new(&proven.program), &proven.program);
        let place = |operand: Operand| match operand {
            Operand::Constant(id) => index(id.index()).map(Place::Shared),
            Operand::Input(input) => index(input as usize).map(Place::Slot),
            Operand::Result(line) => index(lines.result(line as usize)).map(Place::Slot),
        };
        let operation = |line: usize| {
            let Some(line) = lines.line(line) else {
                return Ok(None);
            };
            let places = line.operands().into_iter().map(place);
            Ok(Some(operation(
                line,
                &places.collect::<Result<Vec<_>, _>>()?,
            )))
        };
        let output = |output: &UpToSign| {
            Ok(Output {
                place: place(output.operand)?,
                negative: output.negative,
            })
        };
        Ok(Staged {
            constants: proven.constants.clone(),
            inputs: program.inputs.clone(),
            operations: (0..lines.count())
                .map(operation)
                .collect::<Result<_, _>>()?,
            outputs: program
                .outputs
                .iter()
                .map(output)
                .collect::<Result<_, _>>()?,
        })
    }

    /// The numbers of a call, of which none is known.
    pub(crate) fn unknown(&self) -> Vec<f64> {
        vec![f64::NAN; self.inputs.len() + self.operations.len()]
    }

    /// Carries out the operations of instructions, in their order.
    pub(crate) fn compute(&self, numbers: &mut [f64], instructions: &[usize]) {
        for &instruction in instructions {
            if let Some(operation) = &self.operations[instruction] {
                let value = operation.value(&|place| self.at(numbers, place));
                numbers[self.inputs.len() + instruction] = value;
            }
        }
    }

    /// The output of that index.
    pub(crate) fn output(&self, numbers: &[f64], index: usize) -> f64 {
        let Output { place, negative } = self.outputs[index];
        let value = self.at(numbers, place);
        if negative { -value } else { value }
    }

    fn at(&self, numbers: &[f64], place: Place) -> f64 {
        match place {
            Place::Shared(index) => self.constants[usize::from(index)],
            Place::Slot(_) | Place::Last => numbers[usize::from(place.index())],
        }
    }
}
