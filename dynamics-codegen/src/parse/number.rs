//! Number literals, read as the exact decimals that they show.

use dynamics_symbolic::exact::Rational;
use proc_macro2::Literal;

use crate::limits::MOST_DIGITS;
use crate::mistake::{Mistake, number as mistake};

/// The exact value of a literal such as `1_000`, `9.81` or `200e-6`, all of which may
/// carry the suffix `f64`, and a sign where another macro made it. The error says what is wrong.
pub(super) fn number(literal: &Literal) -> Result<Rational, Mistake> {
    let text = literal.to_string();
    let Decimal {
        is_negative,
        mantissa,
        exponent,
        suffix,
    } = Decimal::new(&text);
    if mantissa == "0" && suffix.starts_with(['x', 'o', 'b']) {
        return Err(mistake::not_decimal());
    }
    if mantissa.is_empty() {
        return Err(mistake::other_literal(&text));
    }
    let [mantissa, exponent] = [mantissa, exponent].map(|digits| digits.replace('_', ""));
    no_suffix(&mantissa, suffix)?;
    value(is_negative, &mantissa, &exponent)
}

/// The exact value of a decimal in a file, such as `.5`, `-1.e-3` or `+1E05`. The error says what is wrong.
#[cfg(feature = "files")]
pub(crate) fn in_file(text: &str) -> Result<Rational, Mistake> {
    let decimal = Decimal::new(text);
    let (whole, fraction) = decimal
        .mantissa
        .split_once('.')
        .unwrap_or((decimal.mantissa, ""));
    let has_digits = !whole.is_empty() || !fraction.is_empty();
    if !has_digits || fraction.contains('.') || !decimal.suffix.is_empty() || text.contains('_') {
        return Err(mistake::other_literal(text));
    }
    value(decimal.is_negative, decimal.mantissa, decimal.exponent)
}

/// The parts of a number as it is written.
struct Decimal<'t> {
    is_negative: bool,
    /// Digits, `.` and `_`.
    mantissa: &'t str,
    exponent: &'t str,
    suffix: &'t str,
}

impl Decimal<'_> {
    fn new(text: &str) -> Decimal<'_> {
        let is_digit = |c: char| c.is_ascii_digit() || c == '_';
        let split = |text: &'_ str, is_inside: &dyn Fn(char) -> bool| {
            let end = text.find(|c| !is_inside(c));
            end.unwrap_or(text.len())
        };
        let unsigned = text.strip_prefix(['-', '+']).unwrap_or(text);
        let (mantissa, rest) = unsigned.split_at(split(unsigned, &|c| is_digit(c) || c == '.'));
        let power = rest.strip_prefix(['e', 'E']).unwrap_or("");
        let digits = power.trim_start_matches(['-', '+']);
        let sign = power.len() - digits.len();
        let (exponent, suffix) = if sign < 2 && digits.starts_with(is_digit) {
            power.split_at(sign + split(digits, &is_digit))
        } else {
            ("", rest)
        };
        Decimal {
            is_negative: text.starts_with('-'),
            mantissa,
            exponent,
            suffix,
        }
    }
}

/// The mantissa times ten to the power of the exponent, where a double can hold it.
fn value(is_negative: bool, mantissa: &str, exponent: &str) -> Result<Rational, Mistake> {
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{fraction}");
    let digits = digits.trim_start_matches('0');
    if digits.is_empty() {
        return Ok(Rational::ZERO);
    }
    if digits.len() > MOST_DIGITS {
        return Err(mistake::too_many_digits());
    }
    let scale = exponent_value(exponent).saturating_sub(fraction.len() as i64);
    let value = decimal(digits, scale)?;
    match value.to_f64().value() {
        infinite if infinite.is_infinite() => Err(mistake::too_large()),
        0.0 => Err(mistake::too_small()),
        _ => Ok(if is_negative { -value } else { value }),
    }
}

/// Refuses every suffix but `f64`.
fn no_suffix(mantissa: &str, suffix: &str) -> Result<(), Mistake> {
    match suffix {
        "" | "f64" => Ok(()),
        "deg" => Err(mistake::degrees(mantissa)),
        _ if suffix.starts_with(['f', 'i', 'u']) => Err(mistake::other_type(suffix)),
        _ => Err(mistake::unit(suffix)),
    }
}

/// The exponent; one that is too long for a machine word saturates.
fn exponent_value(text: &str) -> i64 {
    let is_negative = text.starts_with('-');
    match text.parse() {
        Ok(value) => value,
        Err(_) if text.is_empty() => 0,
        Err(_) if is_negative => i64::MIN,
        Err(_) => i64::MAX,
    }
}

/// `digits` times ten to the power of `scale`. A number out of the range of f64 is
/// refused before the power is computed.
fn decimal(digits: &str, scale: i64) -> Result<Rational, Mistake> {
    match scale.saturating_add(digits.len() as i64) {
        310.. => return Err(mistake::too_large()),
        ..=-324 => return Err(mistake::too_small()),
        _ => {}
    }
    let zeros = "0".repeat(scale.unsigned_abs() as usize);
    let text = match scale {
        0.. => format!("{digits}{zeros}"),
        _ => format!("{digits}/1{zeros}"),
    };
    text.parse().map_err(|_| mistake::no_number())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(literal: &str) -> Result<Rational, Mistake> {
        super::number(&literal.parse().expect("a literal"))
    }

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
            ("-2.5", "-5/2"),
            ("-3", "-3"),
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
        let refusal = |literal: &str| number(literal).unwrap_err().to_string();
        for literal in ["1e309", "1.8e308", "1e999999999", "1e99999999999999999999"] {
            assert!(refusal(literal).contains("largest"), "{literal}");
        }
        for literal in ["1e-400", "1e-999999999", "1e-99999999999999999999"] {
            assert!(refusal(literal).contains("smallest"), "{literal}");
        }
        for digits in ["1".repeat(101), "1".repeat(1_000_000), "1_".repeat(500_000)] {
            assert!(refusal(&digits).contains("digits"));
        }
    }

    #[cfg(feature = "files")]
    #[test]
    fn decimals_of_files_are_exact() {
        for (text, value) in [
            (".5", "1/2"),
            ("-1.e-3", "-1/1000"),
            ("+1E05", "100000"),
            ("0.0", "0"),
        ] {
            assert_eq!(in_file(text).unwrap(), exact(value), "{text}");
        }
        for text in [
            "", ".", "-", "1e", "1e+", "nan", "inf", "0x1", "1,5", "1 2", "--1", "1_0",
        ] {
            assert!(in_file(text).is_err(), "{text}");
        }
    }

    #[test]
    fn other_kinds_of_number_are_refused() {
        let refusal = |literal: &str| number(literal).unwrap_err().to_string();
        assert_eq!(refusal("1.5f32"), "every number is an `f64`: remove `f32`");
        assert_eq!(
            refusal("3usize"),
            "every number is an `f64`: remove `usize`"
        );
        assert_eq!(refusal("90deg"), "write `deg(90)` for an angle in degrees");
        assert_eq!(
            refusal("431.8mm"),
            "a number has no unit, found `mm`: lengths are in m, masses in kg, angles in rad"
        );
        for literal in ["0x10", "0b11", "0o7"] {
            assert_eq!(refusal(literal), "expected a decimal number");
        }
    }
}
