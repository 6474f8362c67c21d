//! Which slots are free: so few that what is computed stays in the caches.

use std::collections::BTreeSet;

use dynamics_symbolic::program::Operand;

use super::lines::Lines;

/// A program has more numbers than places have names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct TooLong;

/// Slots that are taken and given back.
#[derive(Default)]
pub(super) struct Slots {
    free: BTreeSet<u16>,
    count: usize,
}

impl Slots {
    /// The free slot of the lowest number.
    pub(super) fn take(&mut self) -> Result<u16, TooLong> {
        if let Some(slot) = self.free.pop_first() {
            return Ok(slot);
        }
        let slot = u16::try_from(self.count).map_err(|_| TooLong)?;
        self.count += 1;
        Ok(slot)
    }

    /// The slot is free from now on.
    pub(super) fn give_back(&mut self, slot: u16) {
        self.free.insert(slot);
    }

    /// How many slots there are.
    pub(super) fn count(&self) -> usize {
        self.count
    }
}

/// When each input and each result is read for the last time: the place of a line in the order.
pub(super) struct LastReaders {
    pub(super) of_inputs: Vec<usize>,
    pub(super) of_results: Vec<usize>,
}

/// The last readers of lines in this order; outputs are read after all of them.
pub(super) fn last_readers(lines: &Lines<'_>, order: &[usize]) -> LastReaders {
    let mut last = LastReaders {
        of_inputs: vec![0; lines.program.inputs.len()],
        of_results: vec![0; lines.count()],
    };
    let mut note = |operand: Operand, time: usize| match operand {
        Operand::Constant(_) => {}
        Operand::Input(i) => last.of_inputs[i as usize] = time,
        Operand::Result(i) => last.of_results[i as usize] = time,
    };
    for (time, line) in order.iter().enumerate() {
        for operand in lines.operands(*line) {
            note(operand, time);
        }
    }
    for output in &lines.program.outputs {
        note(output.operand, usize::MAX);
    }
    last
}
