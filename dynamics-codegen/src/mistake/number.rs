//! Mistakes in number literals.

use std::fmt::Display;

use super::Mistake;
use crate::limits::MOST_DIGITS;
use crate::words::shortened;

mistakes! {
    no_number() "expected a number";
    /// A string or a letter.
    other_literal(found: &str => shortened) "expected a number, found `{found}`";
    not_decimal() "expected a decimal number";
    too_many_digits() "more than {MOST_DIGITS} digits";
    degrees(mantissa: &str) "write `deg({mantissa})` for an angle in degrees";
    /// `0,4`
    decimal_comma(whole: &impl Display, fraction: &impl Display)
        "decimals are written with a point: `{whole}.{fraction}`";
    /// `.5`
    leading_point(fraction: &impl Display) "decimals begin with a digit: `0.{fraction}`";
    other_type(suffix: &str) "every number is an `f64`: remove `{suffix}`";
    unit(suffix: &str => shortened)
        "a number has no unit, found `{suffix}`: lengths are in m, masses in kg, angles in rad";
    /// A unit in which the table has its numbers.
    #[cfg(feature = "files")]
    unit_of_table(suffix: &str, number: &str)
        "a number has no unit, found `{suffix}`: write `{number}`, for lengths are in m, masses in kg, angles in rad";
    too_large() "this number is larger than the largest `f64`";
    too_small() "this number is smaller than the smallest `f64`, but not zero";
}
