//! Values that are known.

use dynamics_symbolic::exact::{Residue, SplitMix64};
use dynamics_symbolic::robot::Value;

/// The value, where it is a known number.
pub(super) fn number(value: &Value) -> Option<f64> {
    value.is_number().then(|| value.to_f64(&[]))
}

/// The length of a vector, where its components are known numbers.
pub(super) fn norm(vector: &[Value; 3]) -> Option<f64> {
    let [x, y, z] = vector.each_ref().map(number);
    Some(x?.hypot(y?).hypot(z?))
}

/// The values, where all of them are known.
pub(super) fn all<const N: usize>(values: [Option<Value>; N]) -> Option<[Value; N]> {
    let values: Option<Vec<Value>> = values.into_iter().collect();
    values?.try_into().ok()
}

/// Whether the value is zero whatever the fields are.
///
/// A value is a rational function of the fields and of pi, which is transcendental:
/// where it vanishes at one point chosen at random, it is zero (Schwartz 1980,
/// J. ACM 27(4), 701-717). The point is one of a prime field, where no number gets longer than others.
pub(super) fn is_identically_zero(value: &Value) -> bool {
    at_random_point(value).is_some_and(Number::is_zero)
}

/// A number of the field.
type Number = Residue<{ (1 << 61) - 1 }>;

/// The value at one fixed point, `None` at a pole and where a number has no image in the field.
fn at_random_point(value: &Value) -> Option<Number> {
    Some(match value {
        Value::Rational(r) => Number::from_rational(r)?,
        Value::Pi => coordinate(0),
        Value::Field(index) => coordinate(*index as u64 + 1),
        Value::Neg(a) => -at_random_point(a)?,
        Value::Add(a, b) => at_random_point(a)? + at_random_point(b)?,
        Value::Mul(a, b) => at_random_point(a)? * at_random_point(b)?,
        Value::Div(a, b) => at_random_point(a)? * at_random_point(b)?.inverse()?,
    })
}

/// The coordinate of that index of the fixed point.
fn coordinate(index: u64) -> Number {
    Number::new(SplitMix64::number(0, index))
}
