//! MathML Core, which browsers show as it is.

use super::notation::{Notation, greek, signed_sum};
use super::number::Written;

pub(super) struct MathMl;

/// Between factors: a product without a sign.
const INVISIBLE_TIMES: &str = "<mo>&#x2062;</mo>";

/// Between a function and its argument.
const APPLY: &str = "<mo>&#x2061;</mo>";

impl Notation for MathMl {
    fn letter(&self, _text: &str, base: &str, dots: usize, subscript: &str) -> String {
        let base = format!("<mi>{}</mi>", greek(base).unwrap_or(base));
        let accent = ["", "&#x2D9;", "&#xA8;", "&#x20DB;", "&#x20DC;"][dots];
        let accented = match dots {
            0 => base,
            _ => format!("<mover accent=\"true\">{base}<mo>{accent}</mo></mover>"),
        };
        if subscript.is_empty() {
            return accented;
        }
        let is_number = subscript.bytes().all(|byte| byte.is_ascii_digit());
        let tag = if is_number { "mn" } else { "mtext" };
        format!("<msub>{accented}<{tag}>{subscript}</{tag}></msub>")
    }

    fn number(&self, number: &Written) -> String {
        match number {
            Written::Decimal(digits, None) => format!("<mn>{digits}</mn>"),
            Written::Decimal(digits, Some(exponent)) => {
                let power = format!("<msup><mn>10</mn><mn>{exponent}</mn></msup>");
                format!("<mn>{digits}</mn><mo>&#xB7;</mo>{power}")
            }
            Written::Fraction(numerator, denominator) => {
                format!("<mfrac><mn>{numerator}</mn><mn>{denominator}</mn></mfrac>")
            }
        }
    }

    fn power(&self, base: &str, exponent: u32) -> String {
        format!("<msup><mrow>{base}</mrow><mn>{exponent}</mn></msup>")
    }

    fn product(&self, factors: &[String]) -> String {
        factors.join(INVISIBLE_TIMES)
    }

    fn quotient(&self, dividend: &str, divisor: &str, _is_single: bool) -> String {
        format!("<mfrac><mrow>{dividend}</mrow><mrow>{divisor}</mrow></mfrac>")
    }

    fn sum(&self, terms: &[(bool, String)]) -> String {
        let minus = "<mo>&#x2212;</mo>";
        signed_sum(terms, ["<mo>+</mo>", minus, minus])
    }

    fn parentheses(&self, inner: &str) -> String {
        format!("<mrow><mo>(</mo>{inner}<mo>)</mo></mrow>")
    }

    fn call(&self, function: &str, argument: &str) -> String {
        format!("<mi>{function}</mi>{APPLY}{}", self.parentheses(argument))
    }

    fn equals(&self) -> &'static str {
        "<mo>=</mo>"
    }

    fn element(&self, inner: String) -> String {
        format!("<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mrow>{inner}</mrow></math>")
    }
}
