//! Mistakes in number literals.

use std::fmt::Display;

use super::Mistake;
use crate::limits::MOST_DIGITS;
use crate::words::shortened;

pub(crate) fn no_number() -> Mistake {
    Mistake::new("expected a number")
}

/// A string or a letter.
pub(crate) fn other_literal(found: &str) -> Mistake {
    Mistake::new(format!("expected a number, found `{}`", shortened(found)))
}

pub(crate) fn not_decimal() -> Mistake {
    Mistake::new("expected a decimal number")
}

pub(crate) fn too_many_digits() -> Mistake {
    Mistake::new(format!("more than {MOST_DIGITS} digits"))
}

pub(crate) fn degrees(mantissa: &str) -> Mistake {
    Mistake::new(format!("write `deg({mantissa})` for an angle in degrees"))
}

/// `0,4`
pub(crate) fn decimal_comma(whole: &impl Display, fraction: &impl Display) -> Mistake {
    Mistake::new(format!(
        "decimals are written with a point: `{whole}.{fraction}`"
    ))
}

/// `.5`
pub(crate) fn leading_point(fraction: &impl Display) -> Mistake {
    Mistake::new(format!("decimals begin with a digit: `0.{fraction}`"))
}

pub(crate) fn other_type(suffix: &str) -> Mistake {
    Mistake::new(format!("every number is an `f64`: remove `{suffix}`"))
}

pub(crate) fn unit(suffix: &str) -> Mistake {
    Mistake::new(format!(
        "a number has no unit, found `{}`: lengths are in m, masses in kg, angles in rad",
        shortened(suffix)
    ))
}

pub(crate) fn too_large() -> Mistake {
    Mistake::new("this number is larger than the largest `f64`")
}

pub(crate) fn too_small() -> Mistake {
    Mistake::new("this number is smaller than the smallest `f64`, but not zero")
}
