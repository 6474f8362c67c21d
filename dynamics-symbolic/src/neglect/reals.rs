//! The cells of a table as doubles.

pub(super) use crate::exact::sin_cos;

use crate::exact::Rational;
use crate::robot::{Interpretation, Value};
use core::f64::consts::PI;

/// Reads a table without symbolic parameters.
pub(super) struct Reals;

impl Interpretation for Reals {
    type Number = f64;

    fn rational(&mut self, x: &Rational) -> f64 {
        x.to_f64().value()
    }

    fn pi(&mut self) -> f64 {
        PI
    }

    /// The macro requires numbers before.
    fn field(&mut self, _: usize) -> f64 {
        f64::NAN
    }

    fn quotient(&mut self, a: f64, b: f64) -> f64 {
        a / b
    }

    fn circle(&mut self, angle: &Value) -> (f64, f64) {
        sin_cos(angle.to_f64(&[]))
    }
}
