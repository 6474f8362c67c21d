//! LaTeX for math mode, with the commands of amsmath.

use super::notation::{Notation, greek};
use super::number::Written;

pub(super) struct Latex;

impl Notation for Latex {
    fn letter(&self, _text: &str, base: &str, dots: usize, subscript: &str) -> String {
        let base = match base {
            name if greek(name).is_some() => format!("\\{name}"),
            word if word.chars().count() > 1 => format!("\\mathrm{{{word}}}"),
            letter => letter.to_owned(),
        };
        let accent = ["", "\\dot", "\\ddot", "\\dddot", "\\ddddot"][dots];
        let accented = match dots {
            0 => base,
            _ => format!("{accent}{{{base}}}"),
        };
        let is_word = subscript.chars().any(char::is_alphabetic) && subscript.len() > 1;
        match (subscript.is_empty(), is_word) {
            (true, _) => accented,
            (false, true) => format!("{accented}_{{\\mathrm{{{subscript}}}}}"),
            (false, false) => format!("{accented}_{{{subscript}}}"),
        }
    }

    fn number(&self, number: &Written) -> String {
        match number {
            Written::Decimal(digits, None) => digits.clone(),
            Written::Decimal(digits, Some(exponent)) => {
                format!("{digits} \\cdot 10^{{{exponent}}}")
            }
            Written::Fraction(numerator, denominator) => {
                format!("\\tfrac{{{numerator}}}{{{denominator}}}")
            }
        }
    }

    fn power(&self, base: &str, exponent: u32) -> String {
        format!("{base}^{{{exponent}}}")
    }

    fn product(&self, factors: &[String]) -> String {
        factors.join(" \\, ")
    }

    fn quotient(&self, dividend: &str, divisor: &str, _is_single: bool) -> String {
        format!("\\frac{{{dividend}}}{{{divisor}}}")
    }

    fn parentheses(&self, inner: &str) -> String {
        format!("\\left({inner}\\right)")
    }

    fn call(&self, function: &str, argument: &str) -> String {
        let name = match function {
            "sin" | "cos" | "exp" => format!("\\{function}"),
            other => format!("\\operatorname{{{other}}}"),
        };
        format!("{name}{}", self.parentheses(argument))
    }
}
