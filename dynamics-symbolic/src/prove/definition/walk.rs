//! The walk over the rows of a robot. A row knows the one that carries it: in a serial arm that is the one above.

use super::Definition;

impl Definition {
    /// A value for each row, from the base outwards. The step is handed the row and the value of the row that
    /// carries it, which is none for a row on the base.
    pub(super) fn outward<T>(&self, step: impl Fn(usize, Option<&T>) -> T) -> Vec<T> {
        let mut values = Vec::with_capacity(self.rows.len());
        for (i, row) in self.rows.iter().enumerate() {
            let value = step(i, row.parent.map(|parent| &values[parent]));
            values.push(value);
        }
        values
    }

    /// The rows that carry a row, from its own towards the base.
    pub(super) fn carriers(&self, row: usize) -> impl Iterator<Item = usize> {
        core::iter::successors(Some(row), |&row| self.rows[row].parent)
    }
}
