//! A tape at one state, in the arithmetic of any scalar.

use dynamics_runtime::Scalar;
use dynamics_symbolic::robot::Symbol;

use crate::read::parameter;
use crate::tape::{Operation, Place, Step, Tape};

impl Tape {
    /// The numbers that all states share, for these values of the fields.
    pub(crate) fn shared<T: Scalar>(&self, fields: &[f64], constant: &impl Fn(f64) -> T) -> Vec<T> {
        let constants = self.constants.iter().map(|x| constant(*x));
        let mut shared: Vec<T> = constants.collect();
        let parameters = self.parameters.iter();
        shared.extend(parameters.map(|symbol| parameter(symbol, fields, constant)));
        for operation in &self.shared {
            let value = operation.value(&|place: Place| shared[usize::from(place.index())]);
            shared.push(value);
        }
        shared
    }

    /// The outputs at a state, where `read` gives the symbols their values.
    pub(crate) fn at<T: Scalar>(&self, shared: &[T], read: &impl Fn(&Symbol) -> T) -> Vec<T> {
        let mut slots: Vec<Option<T>> = vec![None; self.slots];
        let mut last = None;
        let at = |slots: &[Option<T>], last: Option<T>, place: Place| {
            let known = match place {
                Place::Last => last,
                Place::Shared(index) => Some(shared[usize::from(index)]),
                Place::Slot(index) => slots[usize::from(index)],
            };
            known.expect("written before it is read")
        };
        for step in &self.steps {
            match *step {
                Step::Read { input, to } => {
                    slots[usize::from(to)] = Some(read(&self.inputs[usize::from(input)]));
                }
                Step::SinCos {
                    joint,
                    sine,
                    cosine,
                } => {
                    let (s, c) = read(&Symbol::Position(usize::from(joint))).sin_cos();
                    slots[usize::from(sine)] = Some(s);
                    slots[usize::from(cosine)] = Some(c);
                }
                Step::Compute { operation, to } => {
                    last = Some(operation.value(&|place| at(&slots, last, place)));
                    if let Some(to) = to {
                        slots[usize::from(to)] = last;
                    }
                }
            }
        }
        let outputs = self.outputs.iter().map(|output| {
            let value = at(&slots, last, output.place);
            if output.negative { -value } else { value }
        });
        outputs.collect()
    }
}

impl Operation {
    /// Its value, where operands have the values that `at` gives them: by the operations that are
    /// generated for the line.
    pub(crate) fn value<T: Scalar>(&self, at: &impl Fn(Place) -> T) -> T {
        match *self {
            Operation::Add(a, b) => at(a) + at(b),
            Operation::Sub(a, b) => at(a) - at(b),
            Operation::Mul(a, b) => at(a) * at(b),
            Operation::Div(a, b) => at(a) / at(b),
            Operation::MulAdd(x, y, c) => at(x).mul_add(at(y), at(c)),
            Operation::MulSub(x, y, c) => at(x).mul_add(at(y), -at(c)),
            Operation::NegMulAdd(x, y, c) => (-at(x)).mul_add(at(y), at(c)),
            Operation::Sum(x, y, a, b) => at(x).mul_add(at(y), at(a) * at(b)),
            Operation::Difference(x, y, a, b) => (-at(x)).mul_add(at(y), at(a) * at(b)),
        }
    }
}
