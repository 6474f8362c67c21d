//! Sums in the order in which their terms are ready.
//!
//! A processor executes several operations at a time, so that one call takes as long as its longest chain of dependent
//! operations. Terms that are ready first are added first, as a Huffman tree is built, and the end of a long chain last.
//! No operation is added, and sums keep the products that are fused into them.

use super::{
    Constant, ConstantId, ConstantPool, Instruction, Operand, Program, Readers, UpToSign, cycles,
};

impl Program {
    /// The same outputs from as many operations, in shorter chains.
    pub fn balanced(&self) -> Program {
        let mut balance = Balance {
            program: self,
            readers: self.readers(),
            put_out_negative: negative_outputs(self),
            places: vec![None; self.instructions.len()],
            constants: self.constants.clone(),
            instructions: Vec::with_capacity(self.instructions.len()),
        };
        for index in 0..self.instructions.len() {
            balance.places[index] = balance.place(index);
        }
        let outputs = self.outputs.iter().map(|output| {
            let place = balance.read(output.operand);
            place.at.negate_if(output.negative)
        });
        Program {
            outputs: outputs.collect(),
            inputs: self.inputs.clone(),
            constants: balance.constants,
            instructions: balance.instructions,
            is_plain: self.is_plain,
        }
    }
}

/// The place of a result in the new program, and the time at which it is ready.
#[derive(Clone, Copy)]
struct Scheduled {
    at: UpToSign,
    ready: u32,
}

/// A term of a sum, or minus that term.
#[derive(Clone, Copy)]
struct Term {
    value: Value,
    negative: bool,
    /// When it is ready, or its factors are.
    ready: u32,
}

#[derive(Clone, Copy)]
enum Value {
    Operand(Operand),
    /// A product that nothing but the sum reads: it is fused with one of the additions.
    Product(Operand, Operand),
}

impl From<Scheduled> for Term {
    fn from(place: Scheduled) -> Term {
        Term {
            value: Value::Operand(place.at.operand),
            negative: place.at.negative,
            ready: place.ready,
        }
    }
}

impl Term {
    fn is_product(&self) -> bool {
        matches!(self.value, Value::Product(..))
    }
}

/// Whether each result is an output with a changed sign.
fn negative_outputs(program: &Program) -> Vec<bool> {
    let mut negative = vec![false; program.instructions.len()];
    for output in program.outputs.iter().rev() {
        if let Operand::Result(index) = output.operand {
            negative[index as usize] = output.negative;
        }
    }
    negative
}

struct Balance<'p> {
    program: &'p Program,
    readers: Vec<Readers>,
    put_out_negative: Vec<bool>,
    places: Vec<Option<Scheduled>>,
    constants: ConstantPool,
    instructions: Vec<Instruction>,
}

impl Balance<'_> {
    /// The place of a result in the new program; a term of one sum comes with that sum.
    fn place(&mut self, index: usize) -> Option<Scheduled> {
        let instruction = self.program.instructions[index];
        let [a, b] = instruction.operands();
        match instruction {
            Instruction::Div(..) => Some(self.quotient(a, b)),
            _ if self.is_term_of_one_sum(index) => None,
            Instruction::Mul(..) => Some(self.product(a, b)),
            Instruction::Add(..) | Instruction::Sub(..) => Some(self.sum(index)),
        }
    }

    fn read(&self, operand: Operand) -> Scheduled {
        let ready = match operand {
            Operand::Constant(_) => 0,
            Operand::Input(index) => cycles::of_input(&self.program.inputs[index as usize]),
            Operand::Result(index) => {
                return self.places[index as usize].expect("operands are placed first");
            }
        };
        let at = UpToSign::positive(operand);
        Scheduled { at, ready }
    }

    /// Whether a result is a term of one sum and nothing else. A double stays together: c + c is
    /// exact, (a + c) + c is not.
    fn is_term_of_one_sum(&self, index: usize) -> bool {
        let instruction = self.program.instructions[index];
        let is_doubled = matches!(instruction, Instruction::Add(a, b) if a == b);
        self.readers[index] == Readers::OneSum && !is_doubled
    }

    fn push(&mut self, (instruction, negative): (Instruction, bool), ready: u32) -> Scheduled {
        self.instructions.push(instruction);
        let operand = Operand::Result(self.instructions.len() as u32 - 1);
        let at = UpToSign { operand, negative };
        Scheduled { at, ready }
    }

    fn product(&mut self, a: Operand, b: Operand) -> Scheduled {
        let (a, b) = (self.read(a), self.read(b));
        let ready = a.ready.max(b.ready) + cycles::MULTIPLY;
        self.push(UpToSign::product(a.at, b.at), ready)
    }

    fn quotient(&mut self, a: Operand, b: Operand) -> Scheduled {
        let (a, b) = (self.read(a), self.read(b));
        let ready = a.ready.max(b.ready) + cycles::DIVIDE;
        self.push(UpToSign::quotient(a.at, b.at), ready)
    }

    fn sum(&mut self, index: usize) -> Scheduled {
        let mut terms = self.terms(index);
        terms.sort_by_key(|term| term.ready);
        loop {
            let (first, second) = take_earliest(&mut terms);
            let prefer_negative = terms.is_empty() && self.put_out_negative[index];
            let sum = self.add(first, second, prefer_negative);
            if terms.is_empty() {
                return sum;
            }
            let at = terms.partition_point(|term| term.ready <= sum.ready);
            terms.insert(at, sum.into());
        }
    }

    /// The terms of a sum, those of the sums that nothing else reads among them.
    fn terms(&self, index: usize) -> Vec<Term> {
        let mut terms = Vec::new();
        let mut stack = Vec::new();
        let open = |instruction: Instruction, negative: bool, stack: &mut Vec<_>| {
            let [a, b] = instruction.operands();
            let is_difference = matches!(instruction, Instruction::Sub(..));
            stack.extend([(b, negative != is_difference), (a, negative)]);
        };
        open(self.program.instructions[index], false, &mut stack);
        while let Some((operand, negative)) = stack.pop() {
            match self.sole_term(operand) {
                Some(Instruction::Mul(a, b)) => terms.push(self.product_term(a, b, negative)),
                Some(instruction) => open(instruction, negative, &mut stack),
                None => {
                    let mut term = Term::from(self.read(operand));
                    term.negative ^= negative;
                    terms.push(term);
                }
            }
        }
        terms
    }

    /// The operation of a result that comes with its sum.
    fn sole_term(&self, operand: Operand) -> Option<Instruction> {
        let Operand::Result(index) = operand else {
            return None;
        };
        let is_open = self.places[index as usize].is_none();
        is_open.then(|| self.program.instructions[index as usize])
    }

    fn product_term(&self, a: Operand, b: Operand, negative: bool) -> Term {
        let (a, b) = (self.read(a), self.read(b));
        Term {
            value: Value::Product(a.at.operand, b.at.operand),
            negative: negative ^ a.at.negative ^ b.at.negative,
            ready: a.ready.max(b.ready),
        }
    }

    fn add(&mut self, first: Term, second: Term, prefer_negative: bool) -> Scheduled {
        if let (Value::Operand(Operand::Constant(a)), Value::Operand(Operand::Constant(b))) =
            (first.value, second.value)
        {
            return self.constant_sum((a, first.negative), (b, second.negative));
        }
        let ready = match (first.is_product(), second.is_product()) {
            (false, false) => first.ready.max(second.ready) + cycles::ADD,
            (true, true) => (first.ready + cycles::MULTIPLY).max(second.ready) + cycles::FUSED,
            _ => first.ready.max(second.ready) + cycles::FUSED,
        };
        let (a, b) = (self.written(first), self.written(second));
        self.push(UpToSign::sum(a, b, prefer_negative), ready)
    }

    fn written(&mut self, term: Term) -> UpToSign {
        let at = match term.value {
            Value::Operand(operand) => UpToSign::positive(operand),
            Value::Product(a, b) => self.push((Instruction::Mul(a, b), false), 0).at,
        };
        at.negate_if(term.negative)
    }

    /// Numbers are added exactly, at expansion.
    fn constant_sum(&mut self, a: (ConstantId, bool), b: (ConstantId, bool)) -> Scheduled {
        let [a, b] = [a, b].map(|(id, negative)| {
            let opposite = negative.then_some(Constant::Neg(id));
            opposite.map_or(id, |opposite| self.constants.push(opposite))
        });
        let sum = Operand::Constant(self.constants.push(Constant::Add(a, b)));
        self.read(sum)
    }
}

/// Takes the two terms that are ready first; for a product rather a partner that is none, if one
/// is ready by the time that a second product is: then both are one fused operation.
fn take_earliest(terms: &mut Vec<Term>) -> (Term, Term) {
    let first = terms.remove(0);
    let both_products = first.is_product() && terms[0].is_product();
    let by_then = terms[0].ready.max(first.ready + cycles::MULTIPLY);
    let is_partner = |term: &Term| !term.is_product() && term.ready <= by_then;
    let partner = terms.iter().position(is_partner);
    (
        first,
        terms.remove(partner.filter(|_| both_products).unwrap_or(0)),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::Output;
    use crate::robot::Symbol;

    const SINE: Operand = Operand::Input(0);
    const A: Operand = Operand::Input(1);
    const B: Operand = Operand::Input(2);
    const C: Operand = Operand::Input(3);

    fn program(instructions: Vec<Instruction>, negative: bool) -> Program {
        let last = instructions.len() as u32 - 1;
        Program {
            inputs: vec![
                Symbol::Sine(0),
                Symbol::Velocity(0),
                Symbol::Velocity(1),
                Symbol::Velocity(2),
            ],
            constants: ConstantPool::default(),
            instructions,
            outputs: vec![Output {
                operand: Operand::Result(last),
                negative,
            }],
            is_plain: false,
        }
    }

    fn result(index: u32) -> Operand {
        Operand::Result(index)
    }

    #[test]
    fn what_is_ready_last_is_added_last() {
        use Instruction::{Add, Sub};
        let chain = vec![Sub(SINE, A), Add(result(0), B), Sub(result(1), C)];
        let balanced = program(chain, false).balanced();
        assert_eq!(
            balanced.instructions,
            [Sub(B, A), Sub(result(0), C), Add(result(1), SINE)]
        );
        assert!(!balanced.outputs[0].negative);
    }

    /// a b + c d + e: e goes with one of the products, so that two operations do.
    #[test]
    fn products_find_a_partner_to_be_fused_with() {
        use Instruction::{Add, Mul};
        let chain = vec![
            Mul(A, B),
            Mul(B, C),
            Add(result(0), result(1)),
            Add(result(2), C),
        ];
        let balanced = program(chain, false).balanced();
        assert_eq!(
            balanced.instructions,
            [
                Mul(A, B),
                Add(result(0), C),
                Mul(B, C),
                Add(result(2), result(1))
            ]
        );
    }

    /// c + c is exact, (A + c) + c is not.
    #[test]
    fn a_double_stays_together() {
        use Instruction::Add;
        let chain = vec![Add(SINE, SINE), Add(result(0), A)];
        let balanced = program(chain.clone(), false).balanced();
        assert_eq!(balanced.instructions[0], chain[0]);
    }

    /// The output -(s - a - b) is written as a + b - s: no sign is left to change.
    #[test]
    fn the_last_difference_is_taken_the_way_that_the_output_wants() {
        use Instruction::{Add, Sub};
        let chain = vec![Sub(SINE, A), Sub(result(0), B)];
        let balanced = program(chain, true).balanced();
        assert_eq!(balanced.instructions, [Add(A, B), Sub(result(0), SINE)]);
        assert!(!balanced.outputs[0].negative);
    }

    #[test]
    fn numbers_are_added_at_expansion() {
        use Instruction::Add;
        let mut constants = ConstantPool::default();
        let [one, two] = [1, 2].map(|x| {
            let id = constants.push(Constant::Rational(x.into()));
            Operand::Constant(id)
        });
        let chain = vec![Add(SINE, one), Add(result(0), two)];
        let balanced = Program {
            constants,
            ..program(chain, false)
        }
        .balanced();
        assert_eq!(balanced.instructions.len(), 1);
        assert!(balanced.rounded_constants().contains(&3.0));
    }
}
