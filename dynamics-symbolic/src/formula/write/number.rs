//! Numbers as a person would write them.

use super::super::expression::Number;
use crate::exact::Rational;

/// Decimals of more digits are rounded to the nearest double.
const MOST_DIGITS: usize = 17;

/// A number above zero, in parts.
pub(super) enum Written {
    /// Digits with or without a decimal point, and a power of ten.
    Decimal(String, Option<i32>),
    /// Numerator and denominator.
    Fraction(String, String),
}

impl Written {
    pub(super) fn integer(n: usize) -> Self {
        Written::Decimal(n.to_string(), None)
    }

    /// Halves, quarters and eighths are fractions, and so is what has no finite decimals; others are
    /// decimals: 1/2 and 1/12, but 0.35.
    pub(super) fn new(number: &Number) -> Self {
        let exact = match number {
            Number::Rounded(x) => return double(*x),
            Number::Exact(exact) => exact,
        };
        let numerator = exact.numerator().to_string();
        let denominator = exact.denominator().to_string();
        if denominator == "1" && numerator.len() <= MOST_DIGITS {
            return Written::Decimal(numerator, None);
        }
        let is_plain = ["2", "4", "8"].contains(&denominator.as_str()) && numerator.len() <= 3;
        match decimals(exact) {
            _ if is_plain => Written::Fraction(numerator, denominator),
            Some(decimals) => decimals,
            None if numerator.len() <= 6 && denominator.len() <= 6 => {
                Written::Fraction(numerator, denominator)
            }
            None => double(exact.to_f64().value()),
        }
    }
}

/// The decimals of a number that has few.
fn decimals(x: &Rational) -> Option<Written> {
    let mut digits = x.clone();
    let mut exponent = 0;
    while !digits.is_int() {
        if exponent == 40 {
            return None;
        }
        digits *= Rational::from(10);
        exponent += 1;
    }
    let digits = digits.numerator().to_string();
    (digits.len() <= MOST_DIGITS).then(|| placed(&digits, -exponent))
}

/// The shortest decimals of a double.
fn double(x: f64) -> Written {
    let text = format!("{x:e}");
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let places = digits.split_once('.').map_or(0, |(_, places)| places.len());
    let exponent: i32 = exponent.parse().unwrap_or(0);
    placed(&digits.replace('.', ""), exponent - places as i32)
}

/// An integer times a power of ten, with a decimal point where it has a place among few zeros.
fn placed(digits: &str, exponent: i32) -> Written {
    let trimmed = digits.trim_end_matches('0');
    let exponent = exponent + (digits.len() - trimmed.len()) as i32;
    let count = trimmed.len() as i32;
    let point = count + exponent;
    let text = match point {
        _ if exponent >= 0 && point <= 7 => {
            format!("{trimmed}{}", "0".repeat(exponent as usize))
        }
        1.. if exponent < 0 => {
            let (whole, places) = trimmed.split_at(point as usize);
            format!("{whole}.{places}")
        }
        -3..=0 => format!("0.{}{trimmed}", "0".repeat(-point as usize)),
        _ => {
            let (first, places) = trimmed.split_at(1);
            let dot = if places.is_empty() { "" } else { "." };
            return Written::Decimal(format!("{first}{dot}{places}"), Some(point - 1));
        }
    };
    Written::Decimal(text, None)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(numerator: i64, denominator: u64) -> String {
        let exact = Rational::from_parts(numerator.into(), denominator.into());
        shown(&Written::new(&Number::Exact(exact)))
    }

    fn shown(written: &Written) -> String {
        match written {
            Written::Decimal(digits, None) => digits.clone(),
            Written::Decimal(digits, Some(exponent)) => format!("{digits}e{exponent}"),
            Written::Fraction(a, b) => format!("{a}/{b}"),
        }
    }

    #[test]
    fn numbers_as_a_person_would_write_them() {
        assert_eq!(text(1, 12), "1/12");
        assert_eq!(text(1, 2), "1/2");
        assert_eq!(text(7, 20), "0.35");
        assert_eq!(text(3, 1), "3");
        assert_eq!(text(981, 100), "9.81");
        assert_eq!(text(1_962, 100), "19.62");
        assert_eq!(text(1, 5_000), "0.0002");
        assert_eq!(text(1, 5_000_000), "2e-7");
        assert_eq!(text(123, 1_000_000_000), "1.23e-7");
        assert_eq!(text(1_000_000_000, 1), "1000000000");
        assert_eq!(text(1_234_567, 3_333_333), "0.3703701370370137");
        assert_eq!(shown(&double(0.1)), "0.1");
        assert_eq!(shown(&double(1.5e300)), "1.5e300");
        assert_eq!(shown(&double(271.828)), "271.828");
    }
}
