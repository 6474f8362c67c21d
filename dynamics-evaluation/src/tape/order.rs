//! An order of the lines in which few numbers are kept at once, and results are read at once.

use std::collections::BTreeSet;

use super::lines::Lines;

/// Longer programs stay in the order that they have: the search looks at all lines that could be next.
const LONGEST: usize = 20_000;

/// The lines whose values differ from state to state, in an order in which each reads earlier ones alone.
///
/// The next line is one that alone reads the result of the line before, because that needs no slot. If there is none, it
/// is the line after which the fewest numbers are kept: its own result, and inputs that it is the first to read, less the
/// numbers that no other line reads. A line that reads the result of the line before counts for one less. Among equals it
/// is the one that reads the latest result.
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
    lines: &'p Lines<'p>,
    /// The numbers that each line reads of inputs and results that differ from state to state, without repetitions.
    reads: Vec<Vec<usize>>,
    /// The lines that read each number.
    readers: Vec<Vec<usize>>,
    /// How many lines, and outputs, are still to read each number.
    uses: Vec<usize>,
    /// Whether a number is in a slot once it is read: all but inputs that no line has read.
    is_loaded: Vec<bool>,
    /// When each result was computed; 0 for inputs.
    computed: Vec<usize>,
    /// How many results a line still waits for.
    waits_for: Vec<usize>,
    ready: BTreeSet<usize>,
}

impl<'p> State<'p> {
    fn new(lines: &'p Lines<'p>) -> Self {
        let reads = |line: usize| {
            let operands = lines.operands(line).into_iter();
            let varying = operands.filter(|operand| !lines.is_shared(*operand));
            let mut numbers: Vec<usize> = varying.filter_map(|x| lines.number(x)).collect();
            numbers.sort();
            numbers.dedup();
            numbers
        };
        let (count, numbers, inputs) = (lines.count(), lines.numbers(), lines.result(0));
        let mut state = State {
            lines,
            reads: (0..count).map(reads).collect(),
            readers: vec![Vec::new(); numbers],
            uses: vec![0; numbers],
            is_loaded: (0..numbers).map(|number| number >= inputs).collect(),
            computed: vec![0; numbers],
            waits_for: vec![0; count],
            ready: BTreeSet::new(),
        };
        for (line, reads) in state.reads.iter().enumerate() {
            for &number in reads {
                state.uses[number] += 1;
                state.readers[number].push(line);
                state.waits_for[line] += usize::from(number >= inputs);
            }
        }
        let outputs = lines.program.outputs.iter();
        for number in outputs.filter_map(|output| lines.number(output.operand)) {
            state.uses[number] += 1;
        }
        let is_ready = |line: &usize| state.waits_for[*line] == 0;
        state.ready = lines.varying().filter(is_ready).collect();
        state
    }

    /// The next line, after the one that is the last so far.
    fn next(&self, last: Option<usize>) -> Option<usize> {
        let latest = |line: usize| {
            let reads = self.reads[line].iter();
            reads
                .map(|number| self.computed[*number])
                .max()
                .unwrap_or(0)
        };
        let reads_last = |line: usize| last.is_some_and(|last| self.lines.reads_once(line, last));
        let has_one_reader = last.is_some_and(|last| self.uses[self.lines.result(last)] == 1);
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
        let of_number = |number: &usize| {
            isize::from(!self.is_loaded[*number]) - isize::from(self.uses[*number] == 1)
        };
        1 + self.reads[line].iter().map(of_number).sum::<isize>()
    }

    fn carry_out(&mut self, line: usize, time: usize) {
        self.ready.remove(&line);
        for &number in &self.reads[line] {
            self.is_loaded[number] = true;
            self.uses[number] -= 1;
        }
        let result = self.lines.result(line);
        self.computed[result] = time;
        for &reader in &self.readers[result] {
            self.waits_for[reader] -= 1;
            if self.waits_for[reader] == 0 {
                self.ready.insert(reader);
            }
        }
    }
}
