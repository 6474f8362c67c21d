//! From a program to its tape.

use dynamics_symbolic::Proven;
use dynamics_symbolic::program::{Instruction, Line, Operand, Program, Rest};
use dynamics_symbolic::robot::Symbol;

use super::lines::{Lines, is_shared_symbol};
use super::order::order;
use super::places::{Slots, TooLong, last_readers};
use super::{Operation, Output, Place, Step, Tape};

impl Tape {
    /// The tape of a proven program.
    pub(crate) fn new(proven: &Proven) -> Result<Self, TooLong> {
        let lines = Lines::new(&proven.program);
        let order = order(&lines);
        let last = last_readers(&lines, &order);
        let mut builder = Builder::new(proven, &lines, last)?;
        for line in lines.shared() {
            builder.shared(line)?;
        }
        let mut time = 0;
        for chain in order.chunk_by(|line, next| lines.reads_once(*next, *line)) {
            builder.chain(chain, time)?;
            time += chain.len();
        }
        builder.finish(&proven.program)
    }
}

/// A tape that is being written.
struct Builder<'p> {
    lines: &'p Lines<'p>,
    tape: Tape,
    /// Where each constant of the program's pool is, if a program reads it.
    constants: Vec<Option<Place>>,
    /// Where each input and each result is, once it is known.
    places: Vec<Option<Place>>,
    /// When each input and each result is read for the last time.
    last: Vec<usize>,
    slots: Slots,
}

pub(super) fn index(count: usize) -> Result<u16, TooLong> {
    u16::try_from(count).map_err(|_| TooLong)
}

impl<'p> Builder<'p> {
    fn new(proven: &'p Proven, lines: &'p Lines<'p>, last: Vec<usize>) -> Result<Self, TooLong> {
        let program = &proven.program;
        let mut constants = vec![None; proven.constants.len()];
        let mut values = Vec::new();
        for (place, &x) in constants.iter_mut().zip(&proven.constants) {
            if !x.is_nan() {
                *place = Some(Place::Shared(index(values.len())?));
                values.push(x);
            }
        }
        let mut places = vec![None; lines.numbers()];
        let mut parameters = Vec::new();
        for (place, symbol) in places.iter_mut().zip(&program.inputs) {
            if is_shared_symbol(symbol) {
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
            lines,
            tape,
            constants,
            places,
            last,
            slots: Slots::default(),
        })
    }

    /// Writes a line among what is computed for all states together.
    fn shared(&mut self, line: usize) -> Result<(), TooLong> {
        if let Some(operation) = self.operation(line, None)? {
            self.places[self.lines.result(line)] = Some(self.shared_value(operation)?);
        }
        Ok(())
    }

    fn shared_value(&mut self, operation: Operation) -> Result<Place, TooLong> {
        let tape = &mut self.tape;
        let count = tape.constants.len() + tape.parameters.len() + tape.shared.len();
        tape.shared.push(operation);
        Ok(Place::Shared(index(count)?))
    }

    /// Writes lines of which each reads the result of the one before. Their inputs are read before them, so that nothing
    /// comes in between.
    fn chain(&mut self, chain: &[usize], start: usize) -> Result<(), TooLong> {
        for line in chain {
            for operand in self.lines.operands(*line) {
                if let Operand::Input(input) = operand {
                    self.input(input as usize)?;
                }
            }
        }
        let mut before = None;
        for (time, &line) in (start..).zip(chain) {
            let Some(operation) = self.operation(line, before)? else {
                continue;
            };
            // A line may write where it has read: an operand that is read for the last time is free before.
            for operand in self.lines.operands(line) {
                self.release(operand, time);
            }
            let result = self.lines.result(line);
            let is_kept = time + 1 == start + chain.len() || self.last[result] > time + 1;
            let to = is_kept.then(|| self.slots.take()).transpose()?;
            self.tape.steps.push(Step::Compute { operation, to });
            self.places[result] = to.map(Place::Slot);
            before = Some(line);
        }
        Ok(())
    }

    /// The operation of a line, which may read the result of the line before.
    fn operation(
        &mut self,
        line: usize,
        before: Option<usize>,
    ) -> Result<Option<Operation>, TooLong> {
        let Some(line) = self.lines.line(line) else {
            return Ok(None);
        };
        let mut places = Vec::with_capacity(4);
        for operand in line.operands() {
            let is_last = before.is_some_and(|last| operand == Operand::Result(last as u32));
            let place = if is_last {
                Place::Last
            } else {
                self.place(operand)?
            };
            places.push(place);
        }
        Ok(Some(match operation(line, &places) {
            // The product that is rounded by itself is a number that all states share.
            Operation::Sum(x, y, a @ Place::Shared(_), b @ Place::Shared(_)) => {
                Operation::MulAdd(x, y, self.shared_value(Operation::Mul(a, b))?)
            }
            Operation::Difference(x, y, a @ Place::Shared(_), b @ Place::Shared(_)) => {
                Operation::NegMulAdd(x, y, self.shared_value(Operation::Mul(a, b))?)
            }
            operation => operation,
        }))
    }

    fn place(&mut self, operand: Operand) -> Result<Place, TooLong> {
        let known = match operand {
            Operand::Constant(id) => self.constants[id.index()],
            Operand::Input(input) => Some(self.input(input as usize)?),
            Operand::Result(line) => self.places[self.lines.result(line as usize)],
        };
        Ok(known.expect("constants are rounded, and results computed, before they are read"))
    }

    /// Where an input is, which is read unless it is known.
    fn input(&mut self, input: usize) -> Result<Place, TooLong> {
        self.places[input].map_or_else(|| self.read(input), Ok)
    }

    fn read(&mut self, input: usize) -> Result<Place, TooLong> {
        let to = self.slots.take()?;
        let symbol = &self.lines.program.inputs[input];
        let step = match *symbol {
            Symbol::Sine(joint) | Symbol::Cosine(joint) => {
                let beside = self.slots.take()?;
                let (other, sine, cosine) = match symbol {
                    Symbol::Sine(_) => (Symbol::Cosine(joint), to, beside),
                    _ => (Symbol::Sine(joint), beside, to),
                };
                let mut inputs = self.lines.program.inputs.iter();
                match inputs.position(|symbol| *symbol == other) {
                    Some(other) => self.places[other] = Some(Place::Slot(beside)),
                    None => self.slots.give_back(beside),
                }
                Step::SinCos {
                    joint: index(joint)?,
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
        self.places[input] = Some(Place::Slot(to));
        Ok(Place::Slot(to))
    }

    /// Frees the slot of an operand that no later line reads.
    fn release(&mut self, operand: Operand, time: usize) {
        if let Some(number) = self.lines.number(operand)
            && let Some(Place::Slot(slot)) = self.places[number]
            && self.last[number] == time
        {
            self.slots.give_back(slot);
        }
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
pub(super) fn operation(line: &Line, places: &[Place]) -> Operation {
    let sorted = |a: Place, b: Place| if b < a { (b, a) } else { (a, b) };
    match (line, places) {
        (Line::Single(instruction), &[a, b]) => {
            let (first, second) = sorted(a, b);
            match instruction {
                Instruction::Add(..) => Operation::Add(first, second),
                Instruction::Sub(..) => Operation::Sub(a, b),
                Instruction::Mul(..) => Operation::Mul(first, second),
                Instruction::Div(..) => Operation::Div(a, b),
            }
        }
        (
            Line::Fused {
                is_subtracted,
                rest,
                ..
            },
            &[x, y, ref others @ ..],
        ) => {
            let (x, y) = sorted(x, y);
            match (rest, is_subtracted, others) {
                (Rest::Plus(_), false, &[c]) => Operation::MulAdd(x, y, c),
                (Rest::Plus(_), true, &[c]) => Operation::NegMulAdd(x, y, c),
                (Rest::Minus(_), _, &[c]) => Operation::MulSub(x, y, c),
                (Rest::Product(..), _, &[a, b]) => {
                    let (a, b) = sorted(a, b);
                    if *is_subtracted {
                        Operation::Difference(x, y, a, b)
                    } else {
                        Operation::Sum(x, y, a, b)
                    }
                }
                _ => unreachable!("a line has as many places as operands"),
            }
        }
        _ => unreachable!("a line has as many places as operands"),
    }
}
