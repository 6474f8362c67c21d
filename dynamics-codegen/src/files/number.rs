//! Numbers in the macro's words.

use crate::description::Place;
use crate::diagnose::Diagnostics;
use crate::{read, validate};

/// The number of a value in the macro's words, such as `PI/2`, `deg(90)` or `-1.5e-3`, which no name is part of.
///
/// # Errors
///
/// The mistake in the text.
pub fn number(text: &str) -> Result<f64, String> {
    if let Some(number) = text.trim().parse().ok().filter(|x: &f64| x.is_finite()) {
        return Ok(number);
    }
    let diagnostics = Diagnostics::new();
    let place = Place::START;
    let expr = read::written_value(text, place, &diagnostics);
    let value = expr.and_then(|expr| validate::value(&expr, &diagnostics));
    let errors = diagnostics.into_errors();
    match (value, errors.into_iter().next()) {
        (Some(value), None) => Ok(value.to_f64(&[])),
        (_, Some((_, mistake))) => Err(mistake.to_string()),
        (None, None) => Err("`PI` is the only name that stands for a number here".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::number;
    use core::f64::consts::{FRAC_PI_2, FRAC_PI_6};

    #[test]
    fn values_are_numbers() {
        for (text, expected) in [
            ("PI/2", FRAC_PI_2),
            ("-deg(90)", -FRAC_PI_2),
            (" deg(30) ", FRAC_PI_6),
            ("1/4 - 1", -0.75),
            ("sqrt(4)", 2.0),
            ("1e-300", 1e-300),
            ("+0.5", 0.5),
        ] {
            let found = number(text).expect(text);
            let rounding = 2.0 * f64::EPSILON * expected.abs();
            assert!((found - expected).abs() <= rounding, "{text}: {found}");
        }
    }

    #[test]
    fn what_is_no_number_is_told() {
        for (text, expected) in [
            ("", "expected a value"),
            ("inf", "the only name"),
            ("nan", "the only name"),
            ("90°", "deg(90)"),
            ("0,5", "0.5"),
            ("l1", "`PI` is the only name"),
            ("1/0", "division by zero"),
            ("2 3", "found `3`"),
            ("pi/2", "`PI` is the only name"),
        ] {
            let message = number(text).expect_err(text);
            assert!(message.contains(expected), "{text}: {message}");
        }
    }
}
