//! The order of the lines: such that few numbers are kept at once, and results are read at once.

use std::collections::BTreeSet;

use dynamics_symbolic::program::Operand;

use super::lines::Lines;

/// Longer programs stay in the order that they have: the search looks at all lines that could be next.
const LONGEST: usize = 20_000;

/// The lines whose values differ from state to state, in an order in which each reads earlier ones alone.
///
/// Of the lines that could be next it is one that alone reads the result of the line before, for that
/// needs no slot; then the one after which the fewest numbers are kept (its own result, inputs that it
/// is the first to read, less what nothing else reads), where one that reads the result of the line
/// before counts for one less; among equals the one that reads what was computed last.
pub(super) fn order(lines: &Lines<'_>) -> Vec<usize> {
    let count = lines.varying().count();
    if count > LONGEST {
        return lines.varying().collect();
    }
    let mut state = State::new(lines);
    let mut order = Vec::with_capacity(count);
    while let Some(line) = state.next(order.last().copied()) {
        state.carry_out(line, order.len());
        order.push(line);
    }
    order
}

struct State<'p> {
    /// What each line reads that differs from state to state, without repetitions.
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
    lines: &'p Lines<'p>,
}

impl<'p> State<'p> {
    fn new(lines: &'p Lines<'p>) -> Self {
        let reads = |line: usize| {
            let mut operands = lines.operands(line);
            operands.retain(|operand| !lines.is_shared(*operand));
            operands.sort();
            operands.dedup();
            operands
        };
        let count = lines.count();
        let mut state = State {
            reads: (0..count).map(reads).collect(),
            readers: vec![Vec::new(); count],
            input_uses: vec![0; lines.program.inputs.len()],
            result_uses: vec![0; count],
            is_loaded: vec![false; lines.program.inputs.len()],
            waits_for: vec![0; count],
            ready: BTreeSet::new(),
            computed: vec![0; count],
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
        for output in &lines.program.outputs {
            match output.operand {
                Operand::Input(i) => state.input_uses[i as usize] += 1,
                Operand::Result(i) => state.result_uses[i as usize] += 1,
                Operand::Constant(_) => {}
            }
        }
        state.ready = lines
            .varying()
            .filter(|line| state.waits_for[*line] == 0)
            .collect();
        state
    }

    /// The next line, after the one that is the last so far.
    fn next(&self, last: Option<usize>) -> Option<usize> {
        let latest = |line: usize| {
            let reads = self.reads[line].iter();
            let computed = reads.filter_map(|operand| match operand {
                Operand::Result(i) => Some(self.computed[*i as usize]),
                _ => None,
            });
            computed.max().unwrap_or(0)
        };
        let reads_last = |line: usize| last.is_some_and(|last| self.lines.reads_once(line, last));
        let has_one_reader = last.is_some_and(|last| self.result_uses[last] == 1);
        let goes_on = |line: usize| has_one_reader && reads_last(line);
        let key = |line: &&usize| {
            let line = **line;
            let kept = self.growth(line) - isize::from(reads_last(line));
            (!goes_on(line), kept, usize::MAX - latest(line), line)
        };
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
