//! A tape at one state, in `f64`, by steps that are all alike.
//!
//! Each step is x y + c, which is a sum as x 1 + c and a product as x y - 0, with the same digits and signs of zero. A loop
//! over them has no branch that depends on the step. Each number stands beside the same with the other sign, so that a
//! difference is a sum whose operand has another index. Steps are in the order of their depth, the number of steps before
//! them that wait for each other, so that a processor carries out several at once.

mod build;

use core::cell::RefCell;
use core::sync::atomic::{AtomicU64, Ordering};

use dynamics_runtime::{Scalar, SingularMassMatrix};
use dynamics_symbolic::function::Argument;
use dynamics_symbolic::robot::Symbol;

use crate::layout::Test;
use crate::read::{Axis, Source};

/// All indices: an index is always within the room, so that no step has to compare.
const INDICES: usize = 1 << 16;

type Numbers = [f64; INDICES];

thread_local! {
    /// Room for the numbers of a call.
    static ROOM: RefCell<Room> = RefCell::new(Room::new());
}

/// Room for the numbers of a call. Its shared numbers stay there for a next call of the same function.
struct Room {
    numbers: Box<Numbers>,
    /// The mark of the shared numbers.
    mark: u64,
}

impl Room {
    /// Zeros, which take no memory before they are written.
    fn new() -> Self {
        let zeros = vec![0.0; INDICES].into_boxed_slice();
        Room {
            numbers: zeros.try_into().expect("as many zeros as indices"),
            mark: 0,
        }
    }

    /// The room with these shared numbers at its beginning, which no call writes to.
    fn with_shared(&mut self, prepared: &Prepared) -> &mut Numbers {
        if self.mark != prepared.mark {
            self.numbers[..prepared.shared.len()].copy_from_slice(&prepared.shared);
            self.mark = prepared.mark;
        }
        &mut self.numbers
    }
}

/// The marks that were given to shared numbers, so that different ones have different marks.
static MARKS: AtomicU64 = AtomicU64::new(0);

/// x y + c
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Line {
    x: u16,
    y: u16,
    c: u16,
}

/// x / y
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Quotient {
    x: u16,
    y: u16,
}

/// Steps one after the other, the quotients last.
#[derive(Clone, Debug, Default)]
struct Part {
    lines: Vec<Line>,
    quotients: Vec<Quotient>,
}

/// A number that is read of a state, or the sine and the cosine of one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Of {
    Itself,
    SinCos,
}

/// A tape at one state. Its numbers are those that all states share, 1 and -0, those that are read, and the results.
#[derive(Clone, Debug)]
pub(crate) struct Single {
    reads: Vec<(Symbol, Of)>,
    parts: Vec<Part>,
    /// The values with matrices by columns, the same by rows, and the tests of pivots, whose outputs are indices here.
    values: Vec<u16>,
    by_rows: Vec<u16>,
    tests: Vec<Test>,
}

/// The numbers of a tape that depend on fields alone.
#[derive(Clone, Debug, Default)]
pub(crate) struct Prepared {
    /// The shared numbers with 1 and -0, each beside the same with the other sign.
    shared: Vec<f64>,
    /// The numbers that are read of a state: the number of the argument first.
    sources: Vec<(usize, Source<f64>, Of)>,
    mark: u64,
}

impl Single {
    /// The numbers that depend on fields: `shared` are those of the tape, `arguments` the function's.
    pub(crate) fn prepare(
        &self,
        shared: &[f64],
        axes: &[Axis<f64>],
        arguments: &[(Argument, usize)],
    ) -> Prepared {
        let source = |(symbol, of): &(Symbol, Of)| {
            let source = Source::new(symbol, axes)?;
            let mut known = arguments.iter();
            let argument = known.position(|(argument, _)| *argument == source.argument)?;
            Some((argument, source, *of))
        };
        let sources = self.reads.iter().map(source);
        let shared = shared.iter().copied().chain([1.0, -0.0]);
        Prepared {
            shared: shared.flat_map(|x| [x, -x]).collect(),
            sources: sources
                .collect::<Option<_>>()
                .expect("a program reads arguments of its function"),
            mark: MARKS.fetch_add(1, Ordering::Relaxed) + 1,
        }
    }

    /// The values at a state, whose arguments have their lengths.
    pub(crate) fn values(
        &self,
        prepared: &Prepared,
        arguments: &[&[f64]],
    ) -> Result<Vec<f64>, SingularMassMatrix> {
        let mut results = vec![0.0; self.values.len()];
        self.write(prepared, arguments, &self.values, &mut results)?;
        Ok(results)
    }

    /// The values at a state, matrices by rows, in room for so many.
    pub(crate) fn values_by_rows(
        &self,
        prepared: &Prepared,
        arguments: &[&[f64]],
        results: &mut [f64],
    ) -> Result<(), SingularMassMatrix> {
        self.write(prepared, arguments, &self.by_rows, results)
    }

    fn write(
        &self,
        prepared: &Prepared,
        arguments: &[&[f64]],
        values: &[u16],
        results: &mut [f64],
    ) -> Result<(), SingularMassMatrix> {
        ROOM.with_borrow_mut(|room| {
            let numbers = room.with_shared(prepared);
            self.carry_out(numbers, prepared, arguments);
            for test in &self.tests {
                test.result(|index| numbers[index])?;
            }
            for (result, index) in results.iter_mut().zip(values) {
                *result = numbers[usize::from(*index)];
            }
            Ok(())
        })
    }

    fn carry_out(&self, numbers: &mut Numbers, prepared: &Prepared, arguments: &[&[f64]]) {
        let mut next = prepared.shared.len();
        for (argument, source, of) in &prepared.sources {
            let x = source.value(arguments[*argument][source.entry]);
            match of {
                Of::Itself => put(numbers, &mut next, x),
                Of::SinCos => {
                    let (sine, cosine) = Scalar::sin_cos(x);
                    put(numbers, &mut next, sine);
                    put(numbers, &mut next, cosine);
                }
            }
        }
        for part in &self.parts {
            for &Line { x, y, c } in &part.lines {
                let at = |index: u16| numbers[usize::from(index)];
                let value = Scalar::mul_add(at(x), at(y), at(c));
                put(numbers, &mut next, value);
            }
            for &Quotient { x, y } in &part.quotients {
                let value = numbers[usize::from(x)] / numbers[usize::from(y)];
                put(numbers, &mut next, value);
            }
        }
    }
}

/// Writes a number beside the same with the other sign.
#[inline(always)]
fn put(numbers: &mut Numbers, next: &mut usize, x: f64) {
    // The builder has an index for each number: this is always so.
    if let Some([same, other]) = numbers.get_mut(*next..*next + 2) {
        (*same, *other) = (x, -x);
    }
    *next += 2;
}
