//! Arithmetics in which programs are evaluated: a prime field, high precision, doubles.

use crate::exact::Rational;
use crate::robot::Symbol;

/// An arithmetic, and the values of the symbols in it.
pub trait Arithmetic {
    /// The numbers.
    type Number: Clone;

    /// The image of an exact number.
    fn rational(&mut self, x: &Rational) -> Self::Number;
    /// The value of a symbol.
    fn symbol(&mut self, symbol: &Symbol) -> Self::Number;
    /// -a
    fn neg(&mut self, a: Self::Number) -> Self::Number;
    /// a + b
    fn add(&mut self, a: Self::Number, b: Self::Number) -> Self::Number;
    /// a * b
    fn mul(&mut self, a: Self::Number, b: Self::Number) -> Self::Number;
    /// a / b
    fn div(&mut self, a: Self::Number, b: Self::Number) -> Self::Number;
}

/// The operations of an arithmetic whose numbers have operators of their own.
macro_rules! by_operators {
    ($number:ty) => {
        fn neg(&mut self, a: $number) -> $number {
            -a
        }
        fn add(&mut self, a: $number, b: $number) -> $number {
            a + b
        }
        fn mul(&mut self, a: $number, b: $number) -> $number {
            a * b
        }
        fn div(&mut self, a: $number, b: $number) -> $number {
            a / b
        }
    };
}
pub(crate) use by_operators;
