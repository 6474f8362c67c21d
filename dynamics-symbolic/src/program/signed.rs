//! Values up to sign: signs pass through sums, products and quotients for nothing.

use super::{Instruction, Operand};

/// An operand, or minus the operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UpToSign {
    /// The operand.
    pub operand: Operand,
    /// Whether its sign is changed.
    pub negative: bool,
}

impl UpToSign {
    /// The operand itself.
    pub fn positive(operand: Operand) -> Self {
        UpToSign {
            operand,
            negative: false,
        }
    }

    /// Minus that where `negate` holds.
    pub fn negate_if(self, negate: bool) -> Self {
        UpToSign {
            negative: self.negative != negate,
            ..self
        }
    }

    /// The instruction that gives a + b up to sign, and whether that is minus the sum. A difference may be a - b or b - a:
    /// it is minus the sum if `prefer_negative` holds.
    pub(super) fn sum(a: Self, b: Self, prefer_negative: bool) -> (Instruction, bool) {
        let (minuend, subtrahend) = match (a.negative, b.negative) {
            (false, false) => return (Instruction::Add(a.operand, b.operand), false),
            (true, true) => return (Instruction::Add(a.operand, b.operand), true),
            (false, true) => (a.operand, b.operand),
            (true, false) => (b.operand, a.operand),
        };
        if prefer_negative {
            (Instruction::Sub(subtrahend, minuend), true)
        } else {
            (Instruction::Sub(minuend, subtrahend), false)
        }
    }

    /// As [`UpToSign::sum`], a b.
    pub(super) fn product(a: Self, b: Self) -> (Instruction, bool) {
        let instruction = Instruction::Mul(a.operand, b.operand);
        (instruction, a.negative != b.negative)
    }

    /// As [`UpToSign::sum`], a / b.
    pub(super) fn quotient(a: Self, b: Self) -> (Instruction, bool) {
        let instruction = Instruction::Div(a.operand, b.operand);
        (instruction, a.negative != b.negative)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// With a = 5 and b = 2.
    fn value(instruction: Instruction) -> i32 {
        let read = |operand| match operand {
            Operand::Input(0) => 5,
            _ => 2,
        };
        match instruction {
            Instruction::Add(x, y) => read(x) + read(y),
            Instruction::Sub(x, y) => read(x) - read(y),
            Instruction::Mul(x, y) => read(x) * read(y),
            Instruction::Div(x, y) => read(x) / read(y),
        }
    }

    #[test]
    fn signs_of_operands_and_results_agree() {
        let [a, b] = [0, 1].map(|index| UpToSign::positive(Operand::Input(index)));
        let sign = |negative: bool| if negative { -1 } else { 1 };
        for (first, second, prefer) in (0..8).map(|k| (k & 1 > 0, k & 2 > 0, k & 4 > 0)) {
            let (p, q) = (a.negate_if(first), b.negate_if(second));
            let (x, y) = (5 * sign(first), 2 * sign(second));
            let (sum, negative) = UpToSign::sum(p, q, prefer);
            assert_eq!(value(sum) * sign(negative), x + y);
            assert!(first == second || negative == prefer);
            let (product, negative) = UpToSign::product(p, q);
            assert_eq!(value(product) * sign(negative), x * y);
            let (quotient, negative) = UpToSign::quotient(p, q);
            assert_eq!(value(quotient) * sign(negative), x / y);
        }
    }
}
