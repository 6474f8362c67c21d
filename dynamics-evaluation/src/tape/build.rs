//! From a program to its tape.

use dynamics_symbolic::Proven;
use dynamics_symbolic::program::{Instruction, Line, Operand, Program, Rest};
use dynamics_symbolic::robot::Symbol;

use super::order::order;
use super::places::{LastReaders, Slots, TooLong, last_readers};
use super::{Operation, Output, Place, Step, Tape};

impl Tape {
    /// The tape of a proven program.
    pub(crate) fn new(proven: &Proven) -> Result<Self, TooLong> {
        let lines = proven.program.lines();
        let order = order(&proven.program, &lines);
        let mut builder = Builder::new(proven, last_readers(&proven.program, &lines, &order))?;
        for (time, index) in order.into_iter().enumerate() {
            if let Some(line) = &lines[index] {
                builder.line(index, time, line)?;
            }
        }
        builder.finish(&proven.program)
    }
}

/// A tape that is being written.
struct Builder<'p> {
    program: &'p Program,
    tape: Tape,
    /// Where each constant of the program's pool, each input and each result is, once it is known.
    constants: Vec<Option<Place>>,
    inputs: Vec<Option<Place>>,
    results: Vec<Option<Place>>,
    /// When each input and each result is read for the last time.
    last: LastReaders,
    slots: Slots,
}

/// Whether a symbol has the same value at all states.
fn is_shared(symbol: &Symbol) -> bool {
    matches!(
        symbol,
        Symbol::Pi | Symbol::Field(_) | Symbol::AngleSine(_) | Symbol::AngleCosine(_)
    )
}

fn index(count: usize) -> Result<u16, TooLong> {
    u16::try_from(count).map_err(|_| TooLong)
}

impl<'p> Builder<'p> {
    fn new(proven: &'p Proven, last: LastReaders) -> Result<Self, TooLong> {
        let program = &proven.program;
        let mut constants = vec![None; proven.constants.len()];
        let mut values = Vec::new();
        for (place, &x) in constants.iter_mut().zip(&proven.constants) {
            if !x.is_nan() {
                *place = Some(Place::Shared(index(values.len())?));
                values.push(x);
            }
        }
        let mut inputs = vec![None; program.inputs.len()];
        let mut parameters = Vec::new();
        for (place, symbol) in inputs.iter_mut().zip(&program.inputs) {
            if is_shared(symbol) {
                *place = Some(Place::Shared(index(values.len() + parameters.len())?));
                parameters.push(symbol.clone());
            }
        }
        let tape = Tape {
            constants: values,
            parameters,
            shared: Vec::new(),
            inputs: Vec::new(),
            steps: Vec::new(),
            slots: 0,
            outputs: Vec::new(),
        };
        Ok(Builder {
            program,
            tape,
            constants,
            inputs,
            results: vec![None; program.instructions.len()],
            last,
            slots: Slots::default(),
        })
    }

    /// Writes a line: among what all states share where nothing that it reads depends on the state.
    fn line(&mut self, line_index: usize, time: usize, line: &Line) -> Result<(), TooLong> {
        let operands = line.operands();
        let mut places = Vec::with_capacity(operands.len());
        for operand in &operands {
            places.push(self.place(*operand)?);
        }
        let operation = operation(line, &places);
        if places.iter().all(|place| matches!(place, Place::Shared(_))) {
            let tape = &mut self.tape;
            let count = tape.constants.len() + tape.parameters.len() + tape.shared.len();
            tape.shared.push(operation);
            self.results[line_index] = Some(Place::Shared(index(count)?));
            return Ok(());
        }
        let mut copies = Vec::new();
        let operation = self.with_one_shared_factor(operation, &mut copies)?;
        // A line may write where it has read: what is read for the last time is free before.
        for operand in operands {
            self.release(operand, time);
        }
        for slot in copies {
            self.slots.give_back(slot);
        }
        let to = self.slots.take()?;
        self.tape.steps.push(Step::Compute { operation, to });
        self.results[line_index] = Some(Place::Slot(to));
        Ok(())
    }

    /// Where an operand is; an input is read before the first line that needs it.
    fn place(&mut self, operand: Operand) -> Result<Place, TooLong> {
        let known = match operand {
            Operand::Constant(id) => self.constants[id.index()],
            Operand::Input(input) => self.inputs[input as usize],
            Operand::Result(result) => self.results[result as usize],
        };
        match (known, operand) {
            (Some(place), _) => Ok(place),
            (None, Operand::Input(input)) => self.read(input as usize),
            (None, _) => {
                unreachable!("constants are rounded, and results computed, before they are read")
            }
        }
    }

    fn read(&mut self, input: usize) -> Result<Place, TooLong> {
        let to = self.slots.take()?;
        let symbol = &self.program.inputs[input];
        let step = match *symbol {
            Symbol::Sine(joint) | Symbol::Cosine(joint) => {
                let is_sine = matches!(symbol, Symbol::Sine(_));
                let other = match is_sine {
                    true => Symbol::Cosine(joint),
                    false => Symbol::Sine(joint),
                };
                let beside = self.slots.take()?;
                let other = self
                    .program
                    .inputs
                    .iter()
                    .position(|symbol| *symbol == other);
                match other {
                    Some(other) => self.inputs[other] = Some(Place::Slot(beside)),
                    None => self.slots.give_back(beside),
                }
                let (sine, cosine) = if is_sine { (to, beside) } else { (beside, to) };
                let joint = index(joint)?;
                Step::SinCos {
                    joint,
                    sine,
                    cosine,
                }
            }
            _ => {
                self.tape.inputs.push(symbol.clone());
                let input = index(self.tape.inputs.len() - 1)?;
                Step::Read { input, to }
            }
        };
        self.tape.steps.push(step);
        self.inputs[input] = Some(Place::Slot(to));
        Ok(Place::Slot(to))
    }

    /// Frees the slot of an operand that no later line reads.
    fn release(&mut self, operand: Operand, time: usize) {
        let (place, last) = match operand {
            Operand::Constant(_) => return,
            Operand::Input(i) => (self.inputs[i as usize], self.last.of_inputs[i as usize]),
            Operand::Result(i) => (self.results[i as usize], self.last.of_results[i as usize]),
        };
        if let (Some(Place::Slot(slot)), true) = (place, last == time) {
            self.slots.give_back(slot);
        }
    }

    /// A product of two shared numbers has one of them in a slot: the lanes know products of slots, and
    /// of a slot and a shared number.
    /// `copies` are the slots that it takes.
    fn with_one_shared_factor(
        &mut self,
        operation: Operation,
        copies: &mut Vec<u16>,
    ) -> Result<Operation, TooLong> {
        let mut in_slot = |factors: [Place; 2]| -> Result<[Place; 2], TooLong> {
            let [x, y] = factors;
            let (Place::Shared(_), Place::Shared(_)) = (x, y) else {
                return Ok(factors);
            };
            let to = self.slots.take()?;
            copies.push(to);
            let operation = Operation::Copy(y);
            self.tape.steps.push(Step::Compute { operation, to });
            Ok([x, Place::Slot(to)])
        };
        Ok(match operation {
            Operation::MulAdd(product, c) => Operation::MulAdd(in_slot(product)?, c),
            Operation::MulSub(product, c) => Operation::MulSub(in_slot(product)?, c),
            Operation::NegMulAdd(product, c) => Operation::NegMulAdd(in_slot(product)?, c),
            Operation::Sum(product, other) => Operation::Sum(in_slot(product)?, in_slot(other)?),
            Operation::Difference(product, other) => {
                Operation::Difference(in_slot(product)?, in_slot(other)?)
            }
            other => other,
        })
    }

    fn finish(mut self, program: &Program) -> Result<Tape, TooLong> {
        for output in &program.outputs {
            let place = self.place(output.operand)?;
            self.tape.outputs.push(Output {
                place,
                negative: output.negative,
            });
        }
        self.tape.slots = self.slots.count();
        Ok(self.tape)
    }
}

/// The operation of a line whose operands are at these places.
fn operation(line: &Line, places: &[Place]) -> Operation {
    match (line, places) {
        (Line::Single(instruction), &[a, b]) => match instruction {
            Instruction::Add(..) => Operation::Add(a, b),
            Instruction::Sub(..) => Operation::Sub(a, b),
            Instruction::Mul(..) => Operation::Mul(a, b),
            Instruction::Div(..) => Operation::Div(a, b),
        },
        (
            Line::Fused {
                is_subtracted,
                rest,
                ..
            },
            &[x, y, ref others @ ..],
        ) => match (rest, is_subtracted, others) {
            (Rest::Plus(_), false, &[c]) => Operation::MulAdd([x, y], c),
            (Rest::Plus(_), true, &[c]) => Operation::NegMulAdd([x, y], c),
            (Rest::Minus(_), _, &[c]) => Operation::MulSub([x, y], c),
            (Rest::Product(..), false, &[a, b]) => Operation::Sum([x, y], [a, b]),
            (Rest::Product(..), true, &[a, b]) => Operation::Difference([x, y], [a, b]),
            _ => unreachable!("a line has as many places as operands"),
        },
        _ => unreachable!("a line has as many places as operands"),
    }
}
