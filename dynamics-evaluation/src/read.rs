//! The numbers that programs read: arguments, fields, and functions of both.

use core::f64::consts::PI;

use dynamics_runtime::Scalar;
use dynamics_symbolic::function::Argument;
use dynamics_symbolic::robot::{Robot, Row, Symbol, Value};

/// A cell of the table over the fields, in the arithmetic of the numbers that `constant` makes.
pub(crate) fn cell<T: Scalar>(value: &Value, fields: &[f64], constant: &impl Fn(f64) -> T) -> T {
    let cell = |value: &Value| cell(value, fields, constant);
    match value {
        Value::Rational(_) | Value::Pi => constant(value.to_f64(&[])),
        Value::Field(i) => constant(fields[*i]),
        Value::Neg(a) => -cell(a),
        Value::Add(a, b) => cell(a) + cell(b),
        Value::Mul(a, b) => cell(a) * cell(b),
        Value::Div(a, b) => cell(a) / cell(b),
    }
}

/// A parameter of a tape: a field, or a function of an angle made of fields.
pub(crate) fn parameter<T: Scalar>(
    symbol: &Symbol,
    fields: &[f64],
    constant: &impl Fn(f64) -> T,
) -> T {
    match symbol {
        Symbol::Field(i) => constant(fields[*i]),
        Symbol::AngleSine(angle) => cell(angle, fields, constant).sin_cos().0,
        Symbol::AngleCosine(angle) => cell(angle, fields, constant).sin_cos().1,
        _ => constant(PI),
    }
}

/// The joint of an index of [`Symbol`], which moves by itself or follows another one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Axis<T> {
    /// The degree of freedom by which it moves.
    freedom: usize,
    /// The entry of q: none of the degrees of freedom of a base.
    position: usize,
    /// The factor of a follower's positions and velocities; none if the joint moves by itself.
    factor: Option<T>,
    /// Stribeck's velocity; 1 where the joint has none, which nothing reads.
    stribeck: T,
}

/// The degrees of freedom, then the followers, in the order of the indices of [`Symbol`].
pub(crate) fn axes<T: Scalar>(
    robot: &Robot,
    fields: &[f64],
    constant: &impl Fn(f64) -> T,
) -> Vec<Axis<T>> {
    let cell = |value: &Value| cell(value, fields, constant);
    let base = robot.freedoms().base;
    let of_base = (0..base).map(|freedom| Axis {
        freedom,
        position: 0,
        factor: None,
        stribeck: constant(1.0),
    });
    let axis = |row: &Row, freedom: usize, factor: Option<&Value>| Axis {
        freedom,
        position: freedom - base,
        factor: factor.map(cell),
        stribeck: match &row.stribeck {
            Some(stribeck) => cell(&stribeck.velocity),
            None => constant(1.0),
        },
    };
    let rows = robot.joints().enumerate();
    let joints = rows.map(|(joint, row)| axis(row, base + joint, None));
    let followers = robot.followers().map(|(row, coupling)| {
        let leader = robot.joint_of(coupling.leader);
        axis(row, leader, Some(&coupling.factor))
    });
    of_base.chain(joints).chain(followers).collect()
}

/// The entry of an argument that a symbol is read of, for a follower times the factor.
#[derive(Clone, Debug)]
pub(crate) struct Source<T> {
    pub(crate) argument: Argument,
    pub(crate) entry: usize,
    factor: Option<T>,
    read: Read<T>,
}

/// The function of that number that is read.
#[derive(Clone, Debug)]
enum Read<T> {
    Itself,
    Sign,
    /// exp(-(qd/v)^2) with this v.
    Exponential(T),
}

impl<T: Scalar> Source<T> {
    pub(crate) fn new(symbol: &Symbol, axes: &[Axis<T>]) -> Option<Self> {
        let (argument, axis, read) = match *symbol {
            Symbol::Position(i) => (Argument::Position, i, Read::Itself),
            Symbol::Velocity(i) => (Argument::Velocity, i, Read::Itself),
            Symbol::VelocitySign(i) => (Argument::Velocity, i, Read::Sign),
            Symbol::Stribeck(i) => {
                let read = Read::Exponential(axes[i].stribeck);
                (Argument::Velocity, i, read)
            }
            Symbol::Acceleration(i) => (Argument::Acceleration, i, Read::Itself),
            Symbol::Force(i) => (Argument::Force, i, Read::Itself),
            Symbol::Entry(argument, entry) => {
                return Some(Source {
                    argument,
                    entry,
                    factor: None,
                    read: Read::Itself,
                });
            }
            _ => return None,
        };
        let Axis {
            freedom,
            position,
            factor,
            ..
        } = axes[axis];
        let entry = match argument {
            Argument::Position => position,
            _ => freedom,
        };
        Some(Source {
            argument,
            entry,
            factor,
            read,
        })
    }

    /// The number that is read where the entry is x.
    pub(crate) fn value(&self, x: T) -> T {
        let x = self.factor.map_or(x, |factor| factor * x);
        match self.read {
            Read::Itself => x,
            Read::Sign => x.sign(),
            Read::Exponential(velocity) => {
                let ratio = x / velocity;
                (-(ratio * ratio)).exp()
            }
        }
    }
}

/// The value of a symbol at one state: `argument` are the entries of the arguments there.
pub(crate) fn at_state<T: Scalar>(
    symbol: &Symbol,
    argument: &impl Fn(Argument, usize) -> T,
    axes: &[Axis<T>],
) -> Option<T> {
    let source = Source::new(symbol, axes)?;
    Some(source.value(argument(source.argument, source.entry)))
}

/// The arguments of many states, one state after the other.
pub(crate) struct Reader<'a> {
    /// Each argument with its entries of all states and how many of them a state has.
    pub(crate) arguments: Vec<(Argument, &'a [f64], usize)>,
    /// The joints of the indices of symbols.
    pub(crate) axes: &'a [Axis<f64>],
}

/// A symbol at many states.
pub(crate) struct Column<'a> {
    source: Source<f64>,
    /// The entries of the argument that it is read of, and how many of them a state has.
    entries: &'a [f64],
    width: usize,
}

impl<'a> Reader<'a> {
    /// A symbol at all states.
    pub(crate) fn column(&self, symbol: &Symbol) -> Option<Column<'a>> {
        let source = Source::new(symbol, self.axes)?;
        let mut arguments = self.arguments.iter();
        let of_source = |(known, ..): &&(Argument, &[f64], usize)| *known == source.argument;
        let &(_, entries, width) = arguments.find(of_source)?;
        Some(Column {
            source,
            entries,
            width,
        })
    }
}

impl Column<'_> {
    /// The numbers at the states from `first` on, as many as there is room for.
    pub(crate) fn read(&self, first: usize, lanes: &mut [f64]) {
        let (source, width) = (&self.source, self.width);
        gather(&self.entries[first * width..], width, source.entry, lanes);
        if !matches!((&source.factor, &source.read), (None, Read::Itself)) {
            lanes.iter_mut().for_each(|x| *x = source.value(*x));
        }
    }
}

/// Entry `i` of rows of so many entries, one after the other.
fn gather(rows: &[f64], width: usize, i: usize, column: &mut [f64]) {
    macro_rules! gather {
        ($($known:literal)*) => {
            match width {
                // The compiler knows the length of a row: it takes half the time.
                $($known => {
                    let (rows, _) = rows.as_chunks::<$known>();
                    let i = i.min($known - 1);
                    for (lane, row) in column.iter_mut().zip(rows) {
                        *lane = row[i];
                    }
                })*
                _ => {
                    for (lane, row) in column.iter_mut().zip(rows.chunks_exact(width)) {
                        *lane = row[i];
                    }
                }
            }
        };
    }
    gather!(1 2 3 4 5 6 7 8)
}

/// The opposite: puts a column into rows of so many entries.
#[inline(always)]
pub(crate) fn scatter(column: impl Iterator<Item = f64>, rows: &mut [f64], width: usize, i: usize) {
    macro_rules! scatter {
        ($($known:literal)*) => {
            match width {
                $($known => {
                    let (rows, _) = rows.as_chunks_mut::<$known>();
                    let i = i.min($known - 1);
                    for (row, value) in rows.iter_mut().zip(column) {
                        row[i] = value;
                    }
                })*
                _ => {
                    for (row, value) in rows.chunks_exact_mut(width).zip(column) {
                        row[i] = value;
                    }
                }
            }
        };
    }
    scatter!(1 2 3 4 5 6 7 8)
}
