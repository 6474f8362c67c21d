//! From a tape to steps that are all alike, in the order of their depth.

use dynamics_symbolic::robot::Symbol;

use super::{INDICES, Line, Of, Part, Quotient, Single};
use crate::layout::{Layout, Test};
use crate::tape::{Operation, Output, Place, Step, Tape};

/// How much longer a quotient is waited for than a product and a sum.
const DEPTH_OF_QUOTIENT: usize = 3;

impl Single {
    /// `None` if the tape has more numbers than indices can tell apart: it is then evaluated step by step.
    pub(crate) fn new(tape: &Tape, layout: &Layout) -> Option<Self> {
        let mut builder = Builder::new(tape);
        for step in &tape.steps {
            match *step {
                Step::Read { input, to } => {
                    let symbol = tape.inputs[usize::from(input)].clone();
                    builder.read(symbol, Of::Itself, &[to]);
                }
                Step::SinCos {
                    joint,
                    sine,
                    cosine,
                } => {
                    let position = Symbol::Position(usize::from(joint));
                    builder.read(position, Of::SinCos, &[sine, cosine]);
                }
                Step::Compute { operation, to } => builder.compute(operation, to),
            }
        }
        if 2 * (builder.first + builder.steps.len()) > INDICES {
            return None;
        }
        let of_output = |output: &Output| builder.at(output.place).with_sign(output.negative);
        let outputs: Vec<Number> = tape.outputs.iter().map(of_output).collect();
        Some(builder.finish(&outputs, layout))
    }
}

/// A number, by its place among all, and whether its sign is changed.
#[derive(Clone, Copy, Debug, Default)]
struct Number {
    place: usize,
    negative: bool,
}

impl Number {
    fn new(place: usize) -> Self {
        Number {
            place,
            negative: false,
        }
    }

    /// With the other sign, if it changes.
    fn with_sign(self, changes: bool) -> Self {
        Number {
            negative: self.negative ^ changes,
            ..self
        }
    }

    fn opposite(self) -> Self {
        self.with_sign(true)
    }
}

/// A step, by its operands: x y + c, or x / y.
#[derive(Clone, Copy, Debug)]
enum Alike {
    Line([Number; 3]),
    Quotient([Number; 2]),
}

impl Alike {
    fn operands(&self) -> &[Number] {
        match self {
            Alike::Line(operands) => operands,
            Alike::Quotient(operands) => operands,
        }
    }
}

/// Steps that are being written.
struct Builder {
    reads: Vec<(Symbol, Of)>,
    /// The place of the next number that is read, after those that are shared, 1 and -0.
    next_read: usize,
    /// The place of the first result, after all that is read.
    first: usize,
    one: Number,
    zero: Number,
    /// The numbers in the slots of the tape, and the last result.
    slots: Vec<Number>,
    last: Number,
    steps: Vec<Alike>,
    /// The depth of each step.
    depths: Vec<usize>,
}

impl Builder {
    fn new(tape: &Tape) -> Self {
        let shared = tape.constants.len() + tape.parameters.len() + tape.shared.len();
        let read = tape.steps.iter().map(|step| match step {
            Step::Read { .. } => 1,
            Step::SinCos { .. } => 2,
            Step::Compute { .. } => 0,
        });
        let next_read = shared + 2;
        Builder {
            reads: Vec::new(),
            next_read,
            first: next_read + read.sum::<usize>(),
            one: Number::new(shared),
            zero: Number::new(shared + 1),
            slots: vec![Number::default(); tape.slots],
            last: Number::default(),
            steps: Vec::new(),
            depths: Vec::new(),
        }
    }

    fn read(&mut self, symbol: Symbol, of: Of, to: &[u16]) {
        self.reads.push((symbol, of));
        for slot in to {
            self.slots[usize::from(*slot)] = Number::new(self.next_read);
            self.next_read += 1;
        }
    }

    fn at(&self, place: Place) -> Number {
        match place {
            Place::Last => self.last,
            Place::Shared(index) => Number::new(index.into()),
            Place::Slot(slot) => self.slots[usize::from(slot)],
        }
    }

    fn compute(&mut self, operation: Operation, to: Option<u16>) {
        let at = |place| self.at(place);
        let (one, zero) = (self.one, self.zero);
        let step = match operation {
            Operation::Add(a, b) => Alike::Line([at(a), one, at(b)]),
            Operation::Sub(a, b) => Alike::Line([at(b).opposite(), one, at(a)]),
            Operation::Mul(a, b) => Alike::Line([at(a), at(b), zero]),
            Operation::Div(a, b) => Alike::Quotient([at(a), at(b)]),
            Operation::MulAdd(x, y, c) => Alike::Line([at(x), at(y), at(c)]),
            Operation::MulSub(x, y, c) => Alike::Line([at(x), at(y), at(c).opposite()]),
            Operation::NegMulAdd(x, y, c) => Alike::Line([at(x).opposite(), at(y), at(c)]),
            Operation::Sum(x, y, a, b) => {
                let (x, y, product) = (at(x), at(y), Alike::Line([at(a), at(b), zero]));
                Alike::Line([x, y, self.step(product)])
            }
            Operation::Difference(x, y, a, b) => {
                let (x, y, product) = (at(x).opposite(), at(y), Alike::Line([at(a), at(b), zero]));
                Alike::Line([x, y, self.step(product)])
            }
        };
        self.last = self.step(step);
        if let Some(to) = to {
            self.slots[usize::from(to)] = self.last;
        }
    }

    /// Adds a step, and returns its result.
    fn step(&mut self, step: Alike) -> Number {
        let depths = step.operands().iter().map(|operand| {
            let result = operand.place.checked_sub(self.first);
            result.map_or(0, |result| self.depths[result])
        });
        let own = match step {
            Alike::Line(_) => 1,
            Alike::Quotient(_) => DEPTH_OF_QUOTIENT,
        };
        self.depths.push(depths.max().unwrap_or(0) + own);
        self.steps.push(step);
        Number::new(self.first + self.steps.len() - 1)
    }

    /// The steps in the order of their depth, quotients after the lines of the same depth.
    fn finish(self, outputs: &[Number], layout: &Layout) -> Single {
        let is_quotient = |step: usize| matches!(self.steps[step], Alike::Quotient(_));
        let mut order: Vec<usize> = (0..self.steps.len()).collect();
        order.sort_by_key(|step| (self.depths[*step], is_quotient(*step)));
        // The place of each number in this order.
        let mut places: Vec<usize> = (0..self.first + order.len()).collect();
        for (place, step) in order.iter().enumerate() {
            places[self.first + step] = self.first + place;
        }
        let index = |number: Number| 2 * places[number.place] + usize::from(number.negative);
        let short = |number: Number| index(number) as u16;
        let mut parts = vec![Part::default()];
        for step in order {
            let part = parts.last_mut().expect("there is a part");
            match self.steps[step] {
                Alike::Quotient(operands) => {
                    let [x, y] = operands.map(short);
                    part.quotients.push(Quotient { x, y });
                }
                Alike::Line(operands) => {
                    let [x, y, c] = operands.map(short);
                    let line = Line { x, y, c };
                    if part.quotients.is_empty() {
                        part.lines.push(line);
                    } else {
                        parts.push(Part {
                            lines: vec![line],
                            quotients: Vec::new(),
                        });
                    }
                }
            }
        }
        let mut values = vec![0; layout.values.len()];
        for &(output, place) in &layout.values {
            values[place] = short(outputs[output]);
        }
        let by_rows = layout.by_rows.iter();
        let by_rows = by_rows.map(|(output, _)| short(outputs[*output]));
        let tests = layout.tests.iter().map(|test| Test {
            pivot: index(outputs[test.pivot]),
            diagonal: index(outputs[test.diagonal]),
            ..*test
        });
        Single {
            reads: self.reads,
            parts,
            values,
            by_rows: by_rows.collect(),
            tests: tests.collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dynamics_symbolic::function::{Function, Request};

    /// So many sums, each of which reads the one before.
    fn tape(sums: usize) -> Tape {
        let sum = |operand| Step::Compute {
            operation: Operation::Add(operand, Place::Shared(0)),
            to: Some(0),
        };
        let first = core::iter::once(sum(Place::Shared(0)));
        Tape {
            constants: vec![1.0],
            parameters: Vec::new(),
            shared: Vec::new(),
            inputs: Vec::new(),
            steps: first
                .chain((1..sums).map(|_| sum(Place::Slot(0))))
                .collect(),
            slots: 1,
            outputs: vec![Output {
                place: Place::Slot(0),
                negative: true,
            }],
        }
    }

    /// Beside the results stand the shared number, 1 and -0.
    #[test]
    fn tapes_have_as_many_numbers_as_indices_can_tell_apart() {
        let arm = arms::robot("two_link_saha");
        let request = Request::from(Function::KineticEnergy);
        let layout = Layout::new(&request, arm.freedoms(), 1);
        let most = INDICES / 2 - 3;
        assert!(Single::new(&tape(most + 1), &layout).is_none());
        let single = Single::new(&tape(most), &layout).expect("short enough");
        let prepared = single.prepare(&[1.0], &[], &[]);
        let values = single.values(&prepared, &[]).expect("no pivots");
        assert_eq!(values, [-(most as f64 + 1.0)]);
    }
}
