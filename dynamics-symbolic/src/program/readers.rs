//! Who reads the results of a program.

use super::{Instruction, Operand, Program};

/// Who reads a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Readers {
    /// Nothing.
    None,
    /// One sum alone: what is computed may be written into it.
    OneSum,
    /// Anything else: an operation of another kind, an output, several of them.
    Others,
}

impl Program {
    /// The readers of each result.
    pub(crate) fn readers(&self) -> Vec<Readers> {
        let mut readers = vec![Readers::None; self.instructions.len()];
        for instruction in &self.instructions {
            let by_this = match instruction {
                Instruction::Add(..) | Instruction::Sub(..) => Readers::OneSum,
                Instruction::Mul(..) | Instruction::Div(..) => Readers::Others,
            };
            for operand in instruction.operands() {
                if let Operand::Result(index) = operand {
                    let readers = &mut readers[index as usize];
                    *readers = match readers {
                        Readers::None => by_this,
                        _ => Readers::Others,
                    };
                }
            }
        }
        for output in &self.outputs {
            if let Operand::Result(index) = output.operand {
                readers[index as usize] = Readers::Others;
            }
        }
        readers
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::{ConstantPool, Output};

    #[test]
    fn a_sum_that_reads_twice_is_no_sole_reader() {
        use Instruction::{Add, Mul};
        let (a, result) = (Operand::Input(0), Operand::Result);
        let program = Program {
            inputs: Vec::new(),
            constants: ConstantPool::default(),
            instructions: vec![
                Mul(a, a),
                Add(result(0), a),
                Add(result(1), result(1)),
                Mul(result(2), a),
                Add(result(3), a),
                Add(a, a),
            ],
            outputs: vec![Output::positive(result(4))],
            is_plain: false,
        };
        use Readers::{None, OneSum, Others};
        let expected = [OneSum, Others, Others, OneSum, Others, None];
        assert_eq!(program.readers(), expected);
    }
}
