//! The tip of the robot.

use std::collections::BTreeSet;

use super::assembly::Assembly;

impl Assembly<'_> {
    /// Puts the tip where it is, if there is one: in the second of two links of `chain`, or else in the only end of the
    /// tree on the only link that moves and carries no other that moves.
    pub(super) fn place_tip(&mut self) {
        let tip = match self.tips() {
            [] => self.only_end(),
            [tip] => {
                (0..self.frames.len()).find(|&frame| self.frames[frame].1.word() == tip.plain())
            }
            _ => None,
        };
        let Some((row, frame)) = tip.map(|frame| &self.frames[frame]) else {
            return;
        };
        let mount = row.and_then(|row| self.moved[row].row.mount.as_mut());
        if let Some(mount) = mount {
            mount.tip = Some(frame.places.clone());
        }
    }

    fn only_end(&self) -> Option<usize> {
        let moving = (0..self.moved.len()).filter(|&row| !self.moved[row].is_locked);
        let carrying = moving
            .clone()
            .map(|row| self.moving(self.moved[row].parent));
        let carrying: BTreeSet<_> = carrying.collect();
        let last = only(moving.filter(|&row| !carrying.contains(&Some(row))))?;
        let is_last = |end: &usize| self.moving(self.frames[*end].0) == Some(last);
        only(self.ends.iter().copied().filter(is_last))
    }
}

/// The only one of some things.
fn only<T>(mut things: impl Iterator<Item = T>) -> Option<T> {
    let first = things.next();
    first.filter(|_| things.next().is_none())
}
