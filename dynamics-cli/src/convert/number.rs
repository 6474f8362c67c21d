//! Numbers as text: exact where they are short.

use dynamics_symbolic::exact::Rational;

use super::angle::Angle;

/// Digits of a number that has more.
pub(super) const DIGITS: usize = 25;

/// Places behind the point that numbers found in fifty digits have; they are zero behind these.
const PLACES: usize = 34;

/// Letters of the longest fraction that is written as one.
const FRACTION: usize = 40;

/// A number as a decimal: exactly where it has at most [`DIGITS`] digits, or else rounded to as many.
pub(super) fn decimal(x: &Rational) -> String {
    let scale = Rational::from(10).pow(PLACES as isize);
    let whole = (x * scale).round();
    scaled(&whole.to_string(), -(PLACES as isize), DIGITS)
}

/// A whole number times a power of ten, rounded to at most so many digits, without zeros at the end.
pub(super) fn scaled(whole: &str, mut exponent: isize, most_digits: usize) -> String {
    let unsigned = whole.strip_prefix('-');
    let sign = if unsigned.is_some() { "-" } else { "" };
    let mut digits = unsigned.unwrap_or(whole).to_owned();
    if digits.len() > most_digits {
        let (kept, left) = digits.split_at(most_digits);
        exponent += left.len() as isize;
        let up = left.as_bytes()[0] >= b'5';
        digits = match (up, kept.parse::<u128>()) {
            (true, Ok(kept)) => (kept + 1).to_string(),
            _ => kept.to_owned(),
        };
    }
    let kept = digits.trim_end_matches('0');
    exponent += (digits.len() - kept.len()) as isize;
    if kept.is_empty() {
        return "0".to_owned();
    }
    format!("{sign}{}", placed(kept, exponent))
}

/// A decimal with its point, or with an exponent where that is shorter to read.
fn placed(digits: &str, exponent: isize) -> String {
    let count = digits.len() as isize;
    // The place of the point, counted from the first digit.
    let point = count + exponent;
    match point {
        _ if exponent >= 0 && point <= 15 => {
            format!("{digits}{}", "0".repeat(exponent.unsigned_abs()))
        }
        -4..=0 => format!("0.{}{digits}", "0".repeat(point.unsigned_abs())),
        1..=15 => {
            let (whole, behind) = digits.split_at(point.unsigned_abs());
            format!("{whole}.{behind}")
        }
        _ => {
            let (first, others) = digits.split_at(1);
            let behind = match others {
                "" => String::new(),
                others => format!(".{others}"),
            };
            format!("{first}{behind}e{}", point - 1)
        }
    }
}

/// A number that is no decimal, as a fraction, where that is short.
pub(super) fn fraction(x: &Rational) -> Option<String> {
    let is_decimal = (x * Rational::from(10).pow(PLACES as isize)).is_int();
    let text = format!("{} / {}", x.numerator(), x.denominator());
    (!is_decimal && text.len() <= FRACTION).then_some(text)
}

/// An angle as a decimal.
pub(super) fn radians(angle: &Angle) -> String {
    match angle {
        Angle::Quarters(count) => (f64::from(*count) * core::f64::consts::FRAC_PI_2).to_string(),
        Angle::Radians(angle) => decimal(angle),
    }
}

/// An angle in the words of a table: none where it is no multiple of a quarter turn.
pub(super) fn turns(angle: &Angle) -> Option<&'static str> {
    match angle {
        Angle::Quarters(1) => Some("PI/2"),
        Angle::Quarters(-1) => Some("-PI/2"),
        Angle::Quarters(2) => Some("PI"),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_exact_where_they_are_short() {
        for text in [
            "0", "1", "-1", "0.333", "-0.0825", "1234.5", "0.00012", "1e-7", "-2.5e-9", "120000",
        ] {
            let number: Rational = match text.split_once('e') {
                None => parsed(text),
                Some((mantissa, power)) => {
                    let power: isize = power.parse().expect("a power");
                    parsed(mantissa) / Rational::from(10).pow(-power)
                }
            };
            assert_eq!(decimal(&number), text);
        }
    }

    fn parsed(text: &str) -> Rational {
        let (whole, behind) = text.split_once('.').unwrap_or((text, ""));
        let digits: Rational = format!("{whole}{behind}").parse().expect("digits");
        digits / Rational::from(10).pow(behind.len() as isize)
    }

    #[test]
    fn other_numbers_are_rounded() {
        let third = Rational::ONE / Rational::from(3);
        assert_eq!(decimal(&third), "0.3333333333333333333333333");
        assert_eq!(fraction(&third).as_deref(), Some("1 / 3"));
        assert_eq!(fraction(&parsed("0.25")), None);
        let two_thirds = Rational::from(2) * &third;
        assert_eq!(decimal(&-two_thirds), "-0.6666666666666666666666667");
        let nines = "9".repeat(30);
        assert_eq!(decimal(&parsed(&format!("0.{nines}"))), "1");
        assert_eq!(decimal(&(third / Rational::from(10).pow(45))), "0");
    }
}
