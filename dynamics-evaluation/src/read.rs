//! What programs read: arguments, fields, and functions of both.

use core::f64::consts::PI;

use dynamics_runtime::Scalar;
use dynamics_symbolic::function::Argument;
use dynamics_symbolic::robot::{Robot, Symbol, Value};

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

/// Stribeck's velocity of each joint that moves; 1 where the joint has none, which nothing reads.
pub(crate) fn stribeck_velocities(robot: &Robot, fields: &[f64]) -> Vec<f64> {
    let velocity = |row: &dynamics_symbolic::robot::Row| {
        let stribeck = row.stribeck.as_ref();
        stribeck.map_or(1.0, |stribeck| cell(&stribeck.velocity, fields, &|x| x))
    };
    robot.joints().map(velocity).collect()
}

/// exp(-(qd/v)^2)
fn stribeck<T: Scalar>(qd: T, v: T) -> T {
    let x = qd / v;
    (-(x * x)).exp()
}

/// The argument that a symbol is an entry of, and which one.
fn entry(symbol: &Symbol) -> Option<(Argument, usize)> {
    Some(match *symbol {
        Symbol::Position(i) => (Argument::Position, i),
        Symbol::Velocity(i) | Symbol::VelocitySign(i) | Symbol::Stribeck(i) => {
            (Argument::Velocity, i)
        }
        Symbol::Acceleration(i) => (Argument::Acceleration, i),
        Symbol::Force(i) => (Argument::Force, i),
        Symbol::Entry(argument, i) => (argument, i),
        _ => return None,
    })
}

/// What a symbol is at one state: `argument` are the entries of the arguments there.
pub(crate) fn at_state<T: Scalar>(
    symbol: &Symbol,
    argument: &impl Fn(Argument, usize) -> T,
    velocity: impl Fn(usize) -> T,
) -> Option<T> {
    let (of, i) = entry(symbol)?;
    let x = argument(of, i);
    Some(match symbol {
        Symbol::VelocitySign(_) => x.sign(),
        Symbol::Stribeck(joint) => stribeck(x, velocity(*joint)),
        _ => x,
    })
}

/// The arguments of many states, one state after the other.
pub(crate) struct Reader<'a> {
    /// Each argument with its entries of all states and how many of them a state has.
    pub(crate) arguments: Vec<(Argument, &'a [f64], usize)>,
    /// Stribeck's velocity of each joint.
    pub(crate) velocities: &'a [f64],
}

impl Reader<'_> {
    /// A symbol at the states from `first` on, as many as there is room for.
    pub(crate) fn column(&self, symbol: &Symbol, first: usize, column: &mut [f64]) {
        let Some((argument, i)) = entry(symbol) else {
            return;
        };
        let mut arguments = self.arguments.iter();
        let Some((_, entries, width)) = arguments.find(|(known, ..)| *known == argument) else {
            return;
        };
        gather(&entries[first * width..], *width, i, column);
        match symbol {
            Symbol::VelocitySign(_) => column.iter_mut().for_each(|x| *x = Scalar::sign(*x)),
            Symbol::Stribeck(_) => {
                let velocity = self.velocities[i];
                column.iter_mut().for_each(|x| *x = stribeck(*x, velocity));
            }
            _ => {}
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
