//! Plain text: `2 m2 l1 l2 c2 qd1 qd2`.

use super::notation::{Notation, signed_sum};
use super::number::Written;

pub(super) struct Text;

impl Notation for Text {
    fn letter(&self, text: &str, _base: &str, _dots: usize, _subscript: &str) -> String {
        text.to_owned()
    }

    fn number(&self, number: &Written) -> String {
        match number {
            Written::Decimal(digits, None) => digits.clone(),
            Written::Decimal(digits, Some(exponent)) => format!("{digits}e{exponent}"),
            Written::Fraction(numerator, denominator) => format!("{numerator}/{denominator}"),
        }
    }

    fn power(&self, base: &str, exponent: u32) -> String {
        format!("{base}^{exponent}")
    }

    fn product(&self, factors: &[String]) -> String {
        factors.join(" ")
    }

    fn quotient(&self, dividend: &str, divisor: &str, is_single: bool) -> String {
        if is_single {
            format!("{dividend} / {divisor}")
        } else {
            format!("{dividend} / ({divisor})")
        }
    }

    fn sum(&self, terms: &[(bool, String)]) -> String {
        signed_sum(terms, [" + ", " - ", "-"])
    }

    fn parentheses(&self, inner: &str) -> String {
        format!("({inner})")
    }

    fn call(&self, function: &str, argument: &str) -> String {
        format!("{function}({argument})")
    }
}
