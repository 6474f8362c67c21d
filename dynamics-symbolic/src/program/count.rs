//! Counting operations.

use super::{Instruction, Program};
use crate::robot::Symbol;
use core::fmt;

/// The operations of a program. Negation is free; sines and cosines come in pairs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Multiplications.
    pub multiplications: u32,
    /// Additions and subtractions.
    pub additions: u32,
    /// Divisions.
    pub divisions: u32,
    /// Evaluations of sine and cosine of one angle.
    pub sin_cos: u32,
}

impl Operations {
    /// Multiplications, additions and divisions.
    pub fn total(&self) -> u32 {
        self.multiplications + self.additions + self.divisions
    }
}

impl fmt::Display for Operations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} multiplications, {} additions",
            self.multiplications, self.additions
        )?;
        if self.divisions > 0 {
            write!(f, ", {} divisions", self.divisions)?;
        }
        match self.sin_cos {
            0 => {}
            1 => write!(f, ", sine and cosine of one angle")?,
            angles => write!(f, ", sines and cosines of {angles} angles")?,
        }
        Ok(())
    }
}

impl Program {
    /// What the program costs.
    pub fn operations(&self) -> Operations {
        let mut operations = Operations::default();
        for instruction in &self.instructions {
            match instruction {
                Instruction::Add(..) | Instruction::Sub(..) => operations.additions += 1,
                Instruction::Mul(..) => operations.multiplications += 1,
                Instruction::Div(..) => operations.divisions += 1,
            }
        }
        operations.sin_cos = self.angles().len() as u32;
        operations
    }

    /// The symbols whose sine or cosine the program reads, one for each angle.
    pub fn angles(&self) -> Vec<&Symbol> {
        let mut angles: Vec<&Symbol> = Vec::new();
        for input in &self.inputs {
            let same = |other: &&Symbol| match (input, other) {
                (Symbol::Sine(i) | Symbol::Cosine(i), Symbol::Sine(j) | Symbol::Cosine(j)) => {
                    i == j
                }
                (
                    Symbol::AngleSine(a) | Symbol::AngleCosine(a),
                    Symbol::AngleSine(b) | Symbol::AngleCosine(b),
                ) => a == b,
                _ => false,
            };
            let is_angle = matches!(
                input,
                Symbol::Sine(_) | Symbol::Cosine(_) | Symbol::AngleSine(_) | Symbol::AngleCosine(_)
            );
            if is_angle && !angles.iter().any(same) {
                angles.push(input);
            }
        }
        angles
    }
}
