//! Slots, few enough to stay in the caches.

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

    /// The number of slots.
    pub(super) fn count(&self) -> usize {
        self.count
    }
}

/// The place in this order of the line that reads each input and each result last; outputs are read after all lines.
pub(super) fn last_readers(lines: &Lines<'_>, order: &[usize]) -> Vec<usize> {
    let mut last = vec![0; lines.numbers()];
    let mut note = |operand: Operand, time: usize| {
        if let Some(number) = lines.number(operand) {
            last[number] = time;
        }
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
