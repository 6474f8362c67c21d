//! The lines of a program as it is carried out: products are written into the sums that alone read them.

use super::{Instruction, Operand, Program, Readers};

/// The operations of one line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Line {
    /// An instruction by itself.
    Single(Instruction),
    /// A sum with a product that nothing else reads, rounded once where the target multiplies and adds
    /// in one instruction.
    Fused {
        /// The factors of the product.
        product: (Operand, Operand),
        /// Whether the product is subtracted.
        is_subtracted: bool,
        /// The other term of the sum.
        rest: Rest,
    },
}

/// The term that a product is added to, or subtracted from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rest {
    /// The operand.
    Plus(Operand),
    /// Minus the operand.
    Minus(Operand),
    /// Another product that nothing else reads, which is rounded by itself.
    Product(Operand, Operand),
}

impl Line {
    /// The operands that the line reads.
    pub fn operands(&self) -> Vec<Operand> {
        match *self {
            Line::Single(instruction) => instruction.operands().to_vec(),
            Line::Fused {
                product: (x, y),
                rest,
                ..
            } => match rest {
                Rest::Plus(a) | Rest::Minus(a) => vec![x, y, a],
                Rest::Product(a, b) => vec![x, y, a, b],
            },
        }
    }
}

impl Program {
    /// The line of each instruction; `None` of a product that is written into a sum.
    pub fn lines(&self) -> Vec<Option<Line>> {
        let readers = self.readers();
        let is_read_once = |operand: Operand| matches!(operand, Operand::Result(i) if readers[i as usize] == Readers::OneSum);
        let product = |operand| self.product(operand).filter(|_| is_read_once(operand));
        let line = |(instruction, readers): (&Instruction, &Readers)| {
            let (a, b) = match (*instruction, readers) {
                (Instruction::Mul(..), Readers::OneSum) => return None,
                (Instruction::Add(a, b) | Instruction::Sub(a, b), _) => (a, b),
                (instruction, _) => return Some(Line::Single(instruction)),
            };
            let is_difference = matches!(instruction, Instruction::Sub(..));
            let signed = if is_difference {
                Rest::Minus
            } else {
                Rest::Plus
            };
            Some(match (product(a), product(b)) {
                (first, Some(product)) => Line::Fused {
                    product,
                    is_subtracted: is_difference,
                    rest: first.map_or(Rest::Plus(a), |(x, y)| Rest::Product(x, y)),
                },
                (Some(product), None) => Line::Fused {
                    product,
                    is_subtracted: false,
                    rest: signed(b),
                },
                (None, None) => Line::Single(*instruction),
            })
        };
        self.instructions.iter().zip(&readers).map(line).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::{ConstantPool, Output};
    use Instruction::{Add, Mul, Sub};

    /// x y and z w, and a sum or difference of what `of` makes of them.
    fn last_line(of: fn([Operand; 2]) -> Instruction) -> Option<Line> {
        let [x, y, z, w] = [0, 1, 2, 3].map(Operand::Input);
        let last = of([0, 1].map(Operand::Result));
        let program = Program {
            inputs: Vec::new(),
            constants: ConstantPool::default(),
            instructions: vec![Mul(x, y), Mul(z, w), last],
            outputs: vec![Output::positive(Operand::Result(2))],
            is_plain: false,
        };
        program.lines()[2]
    }

    #[test]
    fn products_are_written_into_sums() {
        let [x, y, z, w] = [0, 1, 2, 3].map(Operand::Input);
        let fused = |product, is_subtracted, rest| {
            Some(Line::Fused {
                product,
                is_subtracted,
                rest,
            })
        };
        let both = Rest::Product(x, y);
        assert_eq!(last_line(|[p, q]| Add(p, q)), fused((z, w), false, both));
        assert_eq!(last_line(|[p, q]| Sub(p, q)), fused((z, w), true, both));
        assert_eq!(
            last_line(|[p, _]| Sub(p, Operand::Input(4))),
            fused((x, y), false, Rest::Minus(Operand::Input(4)))
        );
        assert_eq!(
            last_line(|[p, _]| Sub(Operand::Input(4), p)),
            fused((x, y), true, Rest::Plus(Operand::Input(4)))
        );
        // Two readers, or one that is no sum: a line of its own.
        let squared = last_line(|[p, _]| Add(p, p));
        assert_eq!(
            squared,
            Some(Line::Single(Add(Operand::Result(0), Operand::Result(0))))
        );
        let multiplied = last_line(|[p, q]| Mul(p, q));
        assert!(matches!(multiplied, Some(Line::Single(Mul(..)))));
    }

    #[test]
    fn a_product_in_a_sum_has_no_line() {
        let x = Operand::Input(0);
        let program = Program {
            inputs: Vec::new(),
            constants: ConstantPool::default(),
            instructions: vec![Mul(x, x), Add(Operand::Result(0), x)],
            outputs: vec![Output::positive(Operand::Result(1))],
            is_plain: false,
        };
        assert_eq!(program.lines()[0], None);
        assert_eq!(
            program.lines()[1].map(|line| line.operands()),
            Some(vec![x, x, x])
        );
    }
}
