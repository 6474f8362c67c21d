//! Finished programs with bounds on the errors of their outputs.

use super::Bounded;
use super::constants::{Doubles, certain, constant};
use crate::program::Program;
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
        let evaluated = program.constants.evaluate(&mut Doubles(&constant));
        let constants = evaluated.into_iter().enumerate();
        let doubles = constants.map(|(index, constant)| match needed.get(index) {
            Some(true) => certain(constant),
            _ => Some(f64::NAN),
        });
        let certain: Option<Vec<_>> = doubles.collect();
        let doubles = certain.unwrap_or_else(|| program.rounded_constants());
        Rounded::with_constants(program, &doubles)
    }

    /// The program with these constants.
    pub fn with_constants(program: &'p Program, constants: &[f64]) -> Self {
        let constants = constants.iter().copied().map(Bounded::constant).collect();
        Rounded { program, constants }
    }

    /// The outputs where the symbols have these values.
    pub fn outputs(&self, point: &dyn Fn(&Symbol) -> Bounded) -> Vec<Bounded> {
        let constants = self.constants.clone();
        self.program.evaluate_with(constants, &mut Doubles(point))
    }
}
