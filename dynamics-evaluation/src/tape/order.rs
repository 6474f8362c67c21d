//! The order of the lines: such that few numbers are kept at once.

use std::collections::BTreeSet;

use dynamics_symbolic::program::{Line, Operand, Program};

/// Longer programs stay in the order that they have: the search looks at all lines that could be next.
const LONGEST: usize = 20_000;

/// The lines of a program in an order in which each reads earlier ones alone.
///
/// Of the lines that could be next it is the one after which the fewest numbers are kept (its own
/// result, inputs that it is the first to read, less what nothing else reads), among equals the one
/// that reads what was computed last.
pub(super) fn order(program: &Program, lines: &[Option<Line>]) -> Vec<usize> {
    let count = lines.iter().flatten().count();
    if count > LONGEST {
        return (0..lines.len())
            .filter(|line| lines[*line].is_some())
            .collect();
    }
    let mut state = State::new(program, lines);
    let mut order = Vec::with_capacity(count);
    while let Some(line) = state.next() {
        state.carry_out(line, order.len());
        order.push(line);
    }
    order
}

struct State<'p> {
    /// What each line reads, without constants and repetitions.
    reads: Vec<Vec<Operand>>,
    /// The lines that read each result.
    readers: Vec<Vec<usize>>,
    /// How many lines, and outputs, are still to read each input and each result.
    input_uses: Vec<usize>,
    result_uses: Vec<usize>,
    is_loaded: Vec<bool>,
    /// How many results a line still waits for.
    waits_for: Vec<usize>,
    ready: BTreeSet<usize>,
    /// When each result was computed.
    computed: Vec<usize>,
    lines: &'p [Option<Line>],
}

impl<'p> State<'p> {
    fn new(program: &Program, lines: &'p [Option<Line>]) -> Self {
        let reads = |line: &Option<Line>| {
            let mut operands = line.map_or(Vec::new(), |line| line.operands());
            operands.retain(|operand| !matches!(operand, Operand::Constant(_)));
            operands.sort();
            operands.dedup();
            operands
        };
        let mut state = State {
            reads: lines.iter().map(reads).collect(),
            readers: vec![Vec::new(); lines.len()],
            input_uses: vec![0; program.inputs.len()],
            result_uses: vec![0; lines.len()],
            is_loaded: vec![false; program.inputs.len()],
            waits_for: vec![0; lines.len()],
            ready: BTreeSet::new(),
            computed: vec![0; lines.len()],
            lines,
        };
        for (line, reads) in state.reads.iter().enumerate() {
            for operand in reads {
                match *operand {
                    Operand::Input(i) => state.input_uses[i as usize] += 1,
                    Operand::Result(i) => {
                        state.result_uses[i as usize] += 1;
                        state.readers[i as usize].push(line);
                        state.waits_for[line] += 1;
                    }
                    Operand::Constant(_) => {}
                }
            }
        }
        for output in &program.outputs {
            match output.operand {
                Operand::Input(i) => state.input_uses[i as usize] += 1,
                Operand::Result(i) => state.result_uses[i as usize] += 1,
                Operand::Constant(_) => {}
            }
        }
        let is_ready = |line: &usize| lines[*line].is_some() && state.waits_for[*line] == 0;
        state.ready = (0..lines.len()).filter(is_ready).collect();
        state
    }

    /// The next line.
    fn next(&self) -> Option<usize> {
        let latest = |line: usize| {
            let reads = self.reads[line].iter();
            let computed = reads.filter_map(|operand| match operand {
                Operand::Result(i) => Some(self.computed[*i as usize]),
                _ => None,
            });
            computed.max().unwrap_or(0)
        };
        let key = |line: &&usize| (self.growth(**line), usize::MAX - latest(**line), **line);
        self.ready.iter().min_by_key(key).copied()
    }

    /// How many more numbers are kept after a line.
    fn growth(&self, line: usize) -> isize {
        let of_operand = |operand: &Operand| match *operand {
            Operand::Input(i) => {
                let i = i as usize;
                isize::from(!self.is_loaded[i]) - isize::from(self.input_uses[i] == 1)
            }
            Operand::Result(i) => -isize::from(self.result_uses[i as usize] == 1),
            Operand::Constant(_) => 0,
        };
        1 + self.reads[line].iter().map(of_operand).sum::<isize>()
    }

    fn carry_out(&mut self, line: usize, time: usize) {
        debug_assert!(self.lines[line].is_some());
        self.ready.remove(&line);
        self.computed[line] = time;
        for operand in &self.reads[line] {
            match *operand {
                Operand::Input(i) => {
                    self.is_loaded[i as usize] = true;
                    self.input_uses[i as usize] -= 1;
                }
                Operand::Result(i) => self.result_uses[i as usize] -= 1,
                Operand::Constant(_) => {}
            }
        }
        for &reader in &self.readers[line] {
            self.waits_for[reader] -= 1;
            if self.waits_for[reader] == 0 {
                self.ready.insert(reader);
            }
        }
    }
}
