//! Finished programs with bounds on the errors of their outputs.

use super::Bounded;
use super::constants::{Doubles, certain};
use crate::exact::Rational;
use crate::program::{Arithmetic, Program, by_operators};
use crate::robot::Symbol;

/// A program with its constants as they are emitted.
pub struct Rounded<'p> {
    program: &'p Program,
    constants: Vec<Bounded>,
}

impl<'p> Rounded<'p> {
    /// The program with its constants rounded.
    pub fn new(program: &'p Program) -> Self {
        let needed = program.needed_constants();
        let evaluated = program.constants.evaluate(&mut Doubles);
        let doubles = evaluated.into_iter().enumerate().map(|(index, constant)| {
            match needed.get(index).copied().unwrap_or(false) {
                true => certain(constant),
                false => Some(f64::NAN),
            }
        });
        let doubles = doubles.collect::<Option<Vec<_>>>();
        let doubles = doubles.unwrap_or_else(|| program.rounded_constants());
        Rounded::with_constants(program, &doubles)
    }

    /// The program with these constants.
    pub fn with_constants(program: &'p Program, constants: &[f64]) -> Self {
        let constants = constants.iter().copied().map(Bounded::constant).collect();
        Rounded { program, constants }
    }

    /// The outputs where the symbols have these values.
    pub fn outputs(&self, point: &dyn Fn(&Symbol) -> Bounded) -> Vec<Bounded> {
        self.program
            .evaluate_with(self.constants.clone(), &mut At { point })
    }
}

/// Arithmetic at one point.
struct At<'a> {
    point: &'a dyn Fn(&Symbol) -> Bounded,
}

impl Arithmetic for At<'_> {
    type Number = Bounded;

    fn rational(&mut self, x: &Rational) -> Bounded {
        Bounded::constant(x.to_f64().value())
    }

    fn symbol(&mut self, symbol: &Symbol) -> Bounded {
        (self.point)(symbol)
    }

    by_operators!(Bounded);
}
