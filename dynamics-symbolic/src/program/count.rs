//! Counting operations.

use super::{Instruction, Program};
use crate::robot::{Symbol, Value};
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
    /// Evaluations of the exponential function.
    pub exponentials: u32,
}

impl Operations {
    /// Multiplications, additions and divisions.
    pub fn total(&self) -> u32 {
        self.multiplications + self.additions + self.divisions
    }

    /// Roughly all of them, a sine and its cosine as forty, an exponential as sixty: a measure of the time.
    pub fn with_sines(&self) -> u32 {
        self.total() + 40 * self.sin_cos + 60 * self.exponentials
    }
}

impl fmt::Display for Operations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let several = |count: u32, word: &str| match count {
            1 => format!("1 {word}"),
            _ => format!("{count} {word}s"),
        };
        let products = several(self.multiplications, "multiplication");
        write!(f, "{products}, {}", several(self.additions, "addition"))?;
        if self.divisions > 0 {
            write!(f, ", {}", several(self.divisions, "division"))?;
        }
        match self.sin_cos {
            0 => {}
            1 => write!(f, ", sine and cosine of one angle")?,
            angles => write!(f, ", sines and cosines of {angles} angles")?,
        }
        if self.exponentials > 0 {
            write!(f, ", {}", several(self.exponentials, "exponential"))?;
        }
        Ok(())
    }
}

/// The joint, or the constant angle, whose sine or cosine a symbol is.
fn angle(symbol: &Symbol) -> (Option<usize>, Option<&Value>) {
    match symbol {
        Symbol::Sine(i) | Symbol::Cosine(i) => (Some(*i), None),
        Symbol::AngleSine(angle) | Symbol::AngleCosine(angle) => (None, Some(angle)),
        _ => (None, None),
    }
}

impl Program {
    /// The operations of the program.
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
        let is_exponential = |input: &&Symbol| matches!(input, Symbol::Stribeck(_));
        operations.exponentials = self.inputs.iter().filter(is_exponential).count() as u32;
        operations
    }

    /// The joints whose position's sine or cosine the program reads.
    pub fn joint_angles(&self) -> Vec<usize> {
        let angles = self.angles().into_iter();
        angles.filter_map(|symbol| angle(symbol).0).collect()
    }

    /// The symbols whose sine or cosine the program reads, one for each angle.
    pub fn angles(&self) -> Vec<&Symbol> {
        let mut angles: Vec<&Symbol> = Vec::new();
        for input in &self.inputs {
            let own = angle(input);
            if own != (None, None) && angles.iter().all(|other| angle(other) != own) {
                angles.push(input);
            }
        }
        angles
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::{ConstantPool, Operand, Output};
    use crate::robot::Value;

    fn program(inputs: Vec<Symbol>, instructions: Vec<Instruction>) -> Program {
        Program {
            inputs,
            constants: ConstantPool::default(),
            instructions,
            outputs: Vec::new(),
            is_plain: false,
        }
    }

    #[test]
    fn operations_are_counted_by_kind_and_negation_is_free() {
        let (a, b) = (Operand::Input(0), Operand::Input(1));
        let instructions = vec![
            Instruction::Add(a, b),
            Instruction::Sub(a, b),
            Instruction::Mul(a, b),
            Instruction::Div(a, b),
        ];
        let mut program = program(vec![Symbol::Position(0), Symbol::Position(1)], instructions);
        program.outputs.push(Output {
            operand: Operand::Result(0),
            negative: true,
        });
        let operations = program.operations();
        let expected = Operations {
            multiplications: 1,
            additions: 2,
            divisions: 1,
            sin_cos: 0,
            exponentials: 0,
        };
        assert_eq!(operations, expected);
        assert_eq!(operations.total(), 4);
    }

    #[test]
    fn an_angle_is_counted_once() {
        let (one, two) = (Value::integer(1), Value::integer(2));
        let inputs = vec![
            Symbol::Cosine(1),
            Symbol::Position(0),
            Symbol::Sine(1),
            Symbol::Sine(0),
            Symbol::AngleSine(one.clone()),
            Symbol::AngleCosine(one.clone()),
            Symbol::AngleCosine(two.clone()),
        ];
        let program = program(inputs, Vec::new());
        let angles = [
            Symbol::Cosine(1),
            Symbol::Sine(0),
            Symbol::AngleSine(one),
            Symbol::AngleCosine(two),
        ];
        assert_eq!(program.angles(), angles.each_ref());
        assert_eq!(program.operations().sin_cos, 4);
    }

    #[test]
    fn exponentials_are_counted_by_joint() {
        let inputs = vec![
            Symbol::Stribeck(1),
            Symbol::Velocity(1),
            Symbol::Stribeck(0),
        ];
        assert_eq!(program(inputs, Vec::new()).operations().exponentials, 2);
    }

    #[test]
    fn counts_as_text() {
        let mut operations = Operations {
            multiplications: 3,
            additions: 2,
            ..Operations::default()
        };
        assert_eq!(operations.to_string(), "3 multiplications, 2 additions");
        operations.divisions = 1;
        operations.sin_cos = 1;
        assert_eq!(
            operations.to_string(),
            "3 multiplications, 2 additions, 1 division, sine and cosine of one angle"
        );
        operations.sin_cos = 2;
        assert!(
            operations
                .to_string()
                .ends_with(", sines and cosines of 2 angles")
        );
        operations.exponentials = 1;
        assert!(operations.to_string().ends_with(" angles, 1 exponential"));
    }
}
