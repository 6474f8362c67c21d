//! The meaning of cells in a ring.

use super::{Angle, Value};
use crate::exact::Rational;
use crate::linear::Ring;

/// The rotation by rows, and the position of a base that moves.
pub type PoseOfBase<R> = ([[R; 3]; 3], [R; 3]);

/// A ring in which the cells of a table can be read: expressions on a graph,
/// or numbers of a prime field.
pub trait Interpretation {
    /// The numbers of the ring.
    type Number: Ring;

    /// Where a base that moves is in the world; `None` of a robot whose base stands.
    fn pose_of_base(&mut self) -> Option<PoseOfBase<Self::Number>> {
        None
    }

    /// The image of an exact number.
    fn rational(&mut self, x: &Rational) -> Self::Number;

    /// The image of pi.
    fn pi(&mut self) -> Self::Number;

    /// The image of a symbolic parameter.
    fn field(&mut self, index: usize) -> Self::Number;

    /// The image of a quotient.
    fn quotient(&mut self, a: Self::Number, b: Self::Number) -> Self::Number;

    /// Sine and cosine of an angle that is no multiple of a quarter turn.
    fn circle(&mut self, angle: &Value) -> (Self::Number, Self::Number);

    /// The image of a cell.
    fn value(&mut self, value: &Value) -> Self::Number {
        match value {
            Value::Rational(x) => self.rational(x),
            Value::Pi => self.pi(),
            Value::Field(index) => self.field(*index),
            Value::Neg(a) => -self.value(a),
            Value::Add(a, b) => self.value(a) + self.value(b),
            Value::Mul(a, b) => self.value(a) * self.value(b),
            Value::Div(a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                self.quotient(a, b)
            }
        }
    }

    /// Sine and cosine of an angle of the table.
    fn sin_cos(&mut self, angle: &Value) -> (Self::Number, Self::Number) {
        let angle = Angle::new(angle);
        let (s, c) = match &angle.rest {
            Some(rest) => self.circle(rest),
            None => (
                self.rational(&Rational::ZERO),
                self.rational(&Rational::ONE),
            ),
        };
        match angle.quarter_turns {
            0 => (s, c),
            1 => (c, -s),
            2 => (-s, -c),
            _ => (-c, s),
        }
    }
}
