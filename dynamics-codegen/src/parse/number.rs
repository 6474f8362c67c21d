//! Number literals, read as the exact decimals that they show.

use dynamics_symbolic::exact::Rational;

use crate::limits::MOST_DIGITS;
use crate::words::shortened;

/// The exact value of a literal such as `1_000`, `9.81` or `200e-6`, all of which may
/// carry the suffix `f64`. The error says what is wrong.
pub(super) fn number(literal: &str) -> Result<Rational, String> {
    let text = literal.replace('_', "");
    if ["0x", "0o", "0b"]
        .iter()
        .any(|radix| text.starts_with(radix))
    {
        return Err("expected a decimal number".to_owned());
    }
    let (mantissa, exponent) = split(&text)?;
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{fraction}");
    let digits = digits.trim_start_matches('0');
    if digits.is_empty() {
        return Ok(Rational::ZERO);
    }
    if digits.len() > MOST_DIGITS {
        return Err(format!("more than {MOST_DIGITS} digits"));
    }
    let scale = exponent.saturating_sub(fraction.len() as i64);
    let value = decimal(digits, scale)?;
    match value.to_f64().value() {
        infinite if infinite.is_infinite() => Err(overflow()),
        0.0 => Err(underflow()),
        _ => Ok(value),
    }
}

/// The literal's mantissa and exponent.
fn split(text: &str) -> Result<(&str, i64), String> {
    let end = text
        .find(|c: char| !c.is_ascii_digit() && c != '.')
        .unwrap_or(text.len());
    let (mantissa, rest) = text.split_at(end);
    let (exponent, suffix) = match rest.strip_prefix(['e', 'E']) {
        Some(rest) => {
            let end = rest
                .find(|c: char| !c.is_ascii_digit() && c != '-' && c != '+')
                .unwrap_or(rest.len());
            rest.split_at(end)
        }
        None => ("", rest),
    };
    match suffix {
        "" | "f64" => Ok((mantissa, exponent_value(exponent))),
        "deg" => Err(format!("write `deg({mantissa})` for an angle in degrees")),
        _ if suffix.starts_with(['f', 'i', 'u']) => {
            Err(format!("every number is an `f64`: remove `{suffix}`"))
        }
        _ => Err(format!(
            "a number has no unit, found `{}`: lengths are in m, masses in kg, angles in rad",
            shortened(suffix)
        )),
    }
}

/// The exponent; one that is too long for a machine word saturates.
fn exponent_value(text: &str) -> i64 {
    let (negative, digits) = match text.strip_prefix('-') {
        Some(digits) => (true, digits),
        None => (false, text.trim_start_matches('+')),
    };
    if digits.is_empty() {
        return 0;
    }
    match (digits.parse(), negative) {
        (Ok(value), false) => value,
        (Ok(value), true) => -value,
        (Err(_), false) => i64::MAX,
        (Err(_), true) => i64::MIN,
    }
}

/// `digits` times ten to the power of `scale`. What is out of the range of f64 is
/// refused before the power is computed.
fn decimal(digits: &str, scale: i64) -> Result<Rational, String> {
    match scale.saturating_add(digits.len() as i64) {
        310.. => return Err(overflow()),
        ..=-324 => return Err(underflow()),
        _ => {}
    }
    let zeros = "0".repeat(scale.unsigned_abs() as usize);
    let text = match scale {
        0.. => format!("{digits}{zeros}"),
        _ => format!("{digits}/1{zeros}"),
    };
    text.parse().map_err(|_| "expected a number".to_owned())
}

fn overflow() -> String {
    "this number is larger than the largest `f64`".to_owned()
}

fn underflow() -> String {
    "this number is smaller than the smallest `f64`, but not zero".to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exact(text: &str) -> Rational {
        text.parse().unwrap()
    }

    #[test]
    fn decimals_are_exact() {
        for (literal, value) in [
            ("0", "0"),
            ("0.0e7", "0"),
            ("0e999999999999999999999", "0"),
            ("1_000", "1000"),
            ("9.81", "981/100"),
            ("200e-6", "1/5000"),
            ("2.5E+3", "2500"),
            ("1.", "1"),
            ("007.50", "15/2"),
            ("3f64", "3"),
            ("3e1_f64", "30"),
            ("0.1", "1/10"),
        ] {
            assert_eq!(number(literal).unwrap(), exact(value), "{literal}");
        }
    }

    #[test]
    fn a_decimal_rounds_to_the_double_that_rust_reads() {
        for literal in [
            "0.1",
            "9.81",
            "5.80182176795",
            "1.7976931348623157e308",
            "2.2250738585072011e-308",
            "4.9e-324",
            "6.02214076e23",
            "123456789012345678901234567890",
            "0.30000000000000004",
            "9007199254740993",
        ] {
            let rounded = number(literal).unwrap().to_f64().value();
            assert_eq!(rounded, literal.parse::<f64>().unwrap(), "{literal}");
        }
    }

    #[test]
    fn what_no_double_can_hold_is_refused_at_once() {
        for literal in ["1e309", "1.8e308", "1e999999999", "1e99999999999999999999"] {
            assert!(
                number(literal).unwrap_err().contains("largest"),
                "{literal}"
            );
        }
        for literal in ["1e-400", "1e-999999999", "1e-99999999999999999999"] {
            assert!(
                number(literal).unwrap_err().contains("smallest"),
                "{literal}"
            );
        }
        assert!(number(&"1".repeat(101)).unwrap_err().contains("digits"));
    }

    #[test]
    fn other_kinds_of_number_are_refused() {
        assert_eq!(
            number("1.5f32").unwrap_err(),
            "every number is an `f64`: remove `f32`"
        );
        assert_eq!(
            number("3usize").unwrap_err(),
            "every number is an `f64`: remove `usize`"
        );
        assert_eq!(
            number("90deg").unwrap_err(),
            "write `deg(90)` for an angle in degrees"
        );
        assert_eq!(
            number("431.8mm").unwrap_err(),
            "a number has no unit, found `mm`: lengths are in m, masses in kg, angles in rad"
        );
        for literal in ["0x10", "0b11", "0o7"] {
            assert_eq!(number(literal).unwrap_err(), "expected a decimal number");
        }
    }
}
