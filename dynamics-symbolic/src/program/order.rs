//! The order of a program's lines: results are computed a little before they are read.
//!
//! A processor looks a few hundred instructions ahead, and a result that waits for its readers takes a register. Few
//! compilers reorder a long function: gcc spills what the order of its text keeps alive. Lines are therefore chosen from
//! the last one to the first, each among those whose readers are all placed (list scheduling from the outputs back,
//! Goodman and Hsu 1988): by preference the line whose operands are ready latest, as long as it makes few more results wait.
//! No digit depends on it.

use super::cycles::ready_times;
use super::{Line, Operand, Program, UpToSign};
use core::cmp::Reverse;
use std::collections::BinaryHeap;

/// How many cycles earlier a line may be ready for each result that it lets wait less. Counted on six arms compiled by
/// gcc: from 8 to 32 the times are the same within one in a hundred.
const CYCLES_OF_A_REGISTER: i64 = 24;

impl Program {
    /// The same program, its lines in the order in which they are best carried out.
    pub fn ordered(&self) -> Program {
        let lines = self.lines();
        let order = Order::new(self, &lines).backwards();
        let mut places = vec![None; self.instructions.len()];
        let mut instructions = Vec::with_capacity(self.instructions.len());
        for index in order.into_iter().rev() {
            let products = fused_products(self, &lines, index);
            for index in products.into_iter().chain([index]) {
                places[index as usize] = Some(instructions.len() as u32);
                instructions.push(self.instructions[index as usize]);
            }
        }
        let moved = |operand: Operand| {
            let place = operand.result().map(|index| places[index as usize]);
            place.map_or(operand, |place| Operand::Result(place.expect("a line")))
        };
        for instruction in &mut instructions {
            *instruction = instruction.map(moved);
        }
        let outputs = self.outputs.iter().map(|output| UpToSign {
            operand: moved(output.operand),
            ..*output
        });
        Program {
            inputs: self.inputs.clone(),
            constants: self.constants.clone(),
            instructions,
            outputs: outputs.collect(),
            is_plain: self.is_plain,
        }
    }
}

/// The products that are written into a line.
fn fused_products(program: &Program, lines: &[Option<Line>], index: u32) -> Vec<u32> {
    let operands = program.instructions[index as usize].operands().into_iter();
    let results = operands.filter_map(Operand::result);
    results.filter(|at| lines[*at as usize].is_none()).collect()
}

struct Order {
    /// The results that each line reads, each once.
    reads: Vec<Vec<u32>>,
    /// The lines that read each result.
    readers: Vec<Vec<u32>>,
    /// How many of them are not placed yet.
    open: Vec<usize>,
    /// Whether a result is read by a line that is placed.
    waits: Vec<bool>,
    is_placed: Vec<bool>,
    ready: Vec<u32>,
    /// The lines whose readers are all placed, by their costs; those of former costs too.
    next: BinaryHeap<(Reverse<i64>, u32)>,
}

impl Order {
    fn new(program: &Program, lines: &[Option<Line>]) -> Self {
        let results = |line: &Option<Line>| {
            let operands = line.iter().flat_map(Line::operands);
            let mut results: Vec<_> = operands.filter_map(Operand::result).collect();
            results.sort_unstable();
            results.dedup();
            results
        };
        let reads: Vec<_> = lines.iter().map(results).collect();
        let mut readers = vec![Vec::new(); lines.len()];
        for (line, reads) in (0..).zip(&reads) {
            for &read in reads {
                readers[read as usize].push(line);
            }
        }
        let mut order = Order {
            open: readers.iter().map(Vec::len).collect(),
            reads,
            readers,
            waits: vec![false; lines.len()],
            is_placed: vec![false; lines.len()],
            ready: ready_times(program, lines),
            next: BinaryHeap::new(),
        };
        for (index, line) in (0..).zip(lines) {
            if line.is_some() && order.open[index as usize] == 0 {
                order.offer(index);
            }
        }
        order
    }

    /// The cost of placing a line next, from the last one back.
    fn cost(&self, line: u32) -> i64 {
        let at = line as usize;
        let begins = |read: &&u32| !self.waits[**read as usize];
        let more = self.reads[at].iter().filter(begins).count() as i64 - i64::from(self.waits[at]);
        CYCLES_OF_A_REGISTER * more - i64::from(self.ready[at])
    }

    fn offer(&mut self, line: u32) {
        self.next.push((Reverse(self.cost(line)), line));
    }

    /// All lines, the last one first.
    fn backwards(mut self) -> Vec<u32> {
        let mut order = Vec::with_capacity(self.reads.len());
        while let Some((Reverse(cost), line)) = self.next.pop() {
            if self.is_placed[line as usize] || cost != self.cost(line) {
                continue;
            }
            self.is_placed[line as usize] = true;
            order.push(line);
            self.place(line);
        }
        order
    }

    /// Lets the results wait that a line reads, and offers the lines of which it was the last reader to be placed.
    fn place(&mut self, line: u32) {
        for read in core::mem::take(&mut self.reads[line as usize]) {
            let at = read as usize;
            self.open[at] -= 1;
            let begins = !core::mem::replace(&mut self.waits[at], true);
            if self.open[at] == 0 {
                self.offer(read);
            }
            if begins {
                for reader in self.readers[at].clone() {
                    if self.open[reader as usize] == 0 && !self.is_placed[reader as usize] {
                        self.offer(reader);
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::{ConstantPool, Instruction};
    use crate::robot::Symbol;
    use Instruction::{Add, Mul, Sub};

    const A: Operand = Operand::Input(0);
    const B: Operand = Operand::Input(1);

    fn program(instructions: Vec<Instruction>) -> Program {
        let last = Operand::Result(instructions.len() as u32 - 1);
        Program {
            inputs: [0, 1].map(Symbol::Velocity).to_vec(),
            constants: ConstantPool::default(),
            instructions,
            outputs: vec![UpToSign::positive(last)],
            is_plain: false,
        }
    }

    fn result(index: u32) -> Operand {
        Operand::Result(index)
    }

    #[test]
    fn a_result_is_computed_a_little_before_it_is_read() {
        let early = vec![
            Sub(A, B),
            Add(A, B),
            Add(result(1), A),
            Add(result(2), B),
            Sub(result(3), result(0)),
        ];
        let late = [
            Add(A, B),
            Add(result(0), A),
            Add(result(1), B),
            Sub(A, B),
            Sub(result(2), result(3)),
        ];
        assert_eq!(program(early).ordered().instructions, late);
    }

    #[test]
    fn products_stay_with_their_sums() {
        let apart = vec![
            Mul(A, B),
            Add(A, B),
            Mul(result(1), result(1)),
            Add(result(0), A),
            Mul(result(2), result(3)),
        ];
        let together = [
            Add(A, B),
            Mul(result(0), result(0)),
            Mul(A, B),
            Add(result(2), A),
            Mul(result(1), result(3)),
        ];
        let ordered = program(apart).ordered();
        assert_eq!(ordered.instructions, together);
        let lines = ordered.lines();
        assert_eq!(lines.iter().filter(|line| line.is_none()).count(), 1);
    }
}
