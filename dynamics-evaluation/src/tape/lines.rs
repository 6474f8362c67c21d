//! The lines of a program, and which of them have one value at all states.

use dynamics_symbolic::program::{Line, Operand, Program};
use dynamics_symbolic::robot::Symbol;

/// The lines of a program.
pub(super) struct Lines<'p> {
    pub(super) program: &'p Program,
    /// A line for each instruction that is not written into another one.
    lines: Vec<Option<Line>>,
    /// Which lines depend on constants and fields alone.
    are_shared: Vec<bool>,
}

/// Whether a symbol has the same value at all states.
pub(crate) fn is_shared_symbol(symbol: &Symbol) -> bool {
    matches!(
        symbol,
        Symbol::Pi | Symbol::Field(_) | Symbol::AngleSine(_) | Symbol::AngleCosine(_)
    )
}

impl<'p> Lines<'p> {
    pub(super) fn new(program: &'p Program) -> Self {
        let mut lines = Lines {
            program,
            lines: program.lines(),
            are_shared: Vec::new(),
        };
        for index in 0..lines.lines.len() {
            let is_shared = lines
                .operands(index)
                .iter()
                .all(|operand| lines.is_shared(*operand));
            lines.are_shared.push(is_shared);
        }
        lines
    }

    /// The number of places of lines.
    pub(super) fn count(&self) -> usize {
        self.lines.len()
    }

    /// The number of inputs and results together.
    pub(super) fn numbers(&self) -> usize {
        self.result(self.count())
    }

    /// The number of the result of a line among inputs and results, the inputs first.
    pub(super) fn result(&self, line: usize) -> usize {
        self.program.inputs.len() + line
    }

    /// The number of an operand among inputs and results; constants have none.
    pub(super) fn number(&self, operand: Operand) -> Option<usize> {
        match operand {
            Operand::Constant(_) => None,
            Operand::Input(input) => Some(input as usize),
            Operand::Result(line) => Some(self.result(line as usize)),
        }
    }

    /// The line of that index, where there is one.
    pub(super) fn line(&self, index: usize) -> Option<&Line> {
        self.lines[index].as_ref()
    }

    /// The operands of the line of that index.
    pub(super) fn operands(&self, index: usize) -> Vec<Operand> {
        self.line(index).map_or(Vec::new(), Line::operands)
    }

    /// Whether an operand has the same value at all states.
    pub(super) fn is_shared(&self, operand: Operand) -> bool {
        match operand {
            Operand::Constant(_) => true,
            Operand::Input(i) => is_shared_symbol(&self.program.inputs[i as usize]),
            Operand::Result(i) => self.are_shared[i as usize],
        }
    }

    /// The lines whose values all states share, each after those that it reads.
    pub(super) fn shared(&self) -> impl Iterator<Item = usize> {
        self.written().filter(|line| self.are_shared[*line])
    }

    /// The lines whose values differ from state to state, each after those that it reads.
    pub(super) fn varying(&self) -> impl Iterator<Item = usize> {
        self.written().filter(|line| !self.are_shared[*line])
    }

    fn written(&self) -> impl Iterator<Item = usize> {
        (0..self.lines.len()).filter(|line| self.lines[*line].is_some())
    }

    /// Whether a line reads the result of another one, and once: the one operand of it that is not in
    /// a slot.
    pub(super) fn reads_once(&self, line: usize, result: usize) -> bool {
        let operands = self.operands(line);
        let of_result = |operand: &&Operand| **operand == Operand::Result(result as u32);
        operands.iter().filter(of_result).count() == 1
    }
}
