//! `sqrt`, `sin` and `cos` of numbers.
//!
//! Values are exact rationals, and so is what comes out: a root of a square, a sine of a multiple of 30
//! degrees that is 0, 1/2 or 1. Any other result is irrational; in its place stands a rational that
//! differs from it by less than 1e-60 of its size (of 1 for sines). The functions are proven for that
//! rational, and the double to which it is rounded is the one nearest to the irrational number: only one
//! within 1e-60 of the middle between two doubles could be rounded otherwise.

use dynamics_symbolic::exact::{Rational, square_root};
use dynamics_symbolic::program::sine_and_cosine;
use dynamics_symbolic::robot::Value;

use crate::description::Elementary;
use crate::mistake::{Mistake, value as mistake};

/// The value of the function, or what is wrong with its argument.
pub(super) fn value(function: Elementary, x: &Value) -> Result<Rational, Mistake> {
    let name = match function {
        Elementary::Sqrt => "sqrt",
        Elementary::Sin => "sin",
        Elementary::Cos => "cos",
    };
    if !x.is_number() {
        return Err(mistake::function_of_field(name));
    }
    if function == Elementary::Sqrt {
        let x = x.as_rational().ok_or_else(mistake::root_of_pi)?;
        return square_root(x).ok_or_else(mistake::root_of_negative);
    }
    let [sine, cosine] = sine_and_cosine(x).ok_or_else(mistake::sine_unknown)?;
    Ok(match function {
        Elementary::Sin => sine,
        _ => cosine,
    })
}
