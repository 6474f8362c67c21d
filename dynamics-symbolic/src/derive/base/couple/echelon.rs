//! Elimination over the prime field: which columns are combinations of which.

use super::arm::{Arm, State, less};
use crate::exact::SplitMix64;
use crate::expr::Fingerprint;

/// Equations in reduced form.
pub(super) struct Echelon {
    /// The columns in the order in which they are chosen.
    order: Vec<usize>,
    /// The place of the first entry in that order, which is 1, and the row.
    rows: Vec<(usize, Vec<Fingerprint>)>,
}

impl Echelon {
    pub(super) fn new(order: Vec<usize>) -> Self {
        Echelon {
            order,
            rows: Vec::new(),
        }
    }

    /// The energies at random states: as many as there are until one adds nothing. Then no state does, for
    /// that one might have been any (Schwartz 1980, Zippel 1979).
    pub(super) fn of(arm: &Arm<Fingerprint>, order: Vec<usize>) -> Self {
        let mut random = SplitMix64::new(0x636f_7570_6c65);
        let mut echelon = Echelon::new(order);
        let [_, reference] = arm.energies(&State::random(arm, &mut random));
        loop {
            let [kinetic, potential] = arm.energies(&State::random(arm, &mut random));
            let added = [kinetic, less(potential, &reference)].map(|row| echelon.add(row));
            if !added.contains(&true) {
                return echelon.reduced();
            }
        }
    }

    /// Adds a row; `false` where it is a combination of those that there are.
    pub(super) fn add(&mut self, mut row: Vec<Fingerprint>) -> bool {
        for (place, known) in &self.rows {
            subtract(&mut row, self.order[*place], known);
        }
        let first = (0..self.order.len()).find(|&place| !row[self.order[place]].is_zero());
        let Some(first) = first else {
            return false;
        };
        let inverse = row[self.order[first]]
            .inverse()
            .expect("a pivot is not zero");
        for x in &mut row {
            *x = *x * inverse;
        }
        let at = self.rows.partition_point(|(place, _)| *place < first);
        self.rows.insert(at, (first, row));
        true
    }

    pub(super) fn rank(&self) -> usize {
        self.rows.len()
    }

    /// With nothing but one entry in the column of each pivot.
    fn reduced(mut self) -> Self {
        for i in (0..self.rows.len()).rev() {
            let (place, pivot) = self.rows[i].clone();
            for (_, row) in &mut self.rows[..i] {
                subtract(row, self.order[place], &pivot);
            }
        }
        self
    }

    /// The columns that are not combinations of those before them.
    pub(super) fn pivots(&self) -> Vec<usize> {
        let places = self.rows.iter().map(|(place, _)| self.order[*place]);
        places.collect()
    }

    /// The other columns, and the pivots of which each of them is a combination.
    pub(super) fn combinations(&self) -> Vec<(usize, Vec<usize>)> {
        let pivots = self.pivots();
        let others = self.order.iter().filter(|column| !pivots.contains(column));
        let combination = |&column: &usize| {
            let rows = self.rows.iter().zip(&pivots);
            let terms = rows.filter(|((_, row), _)| !row[column].is_zero());
            (column, terms.map(|(_, &pivot)| pivot).collect())
        };
        others.map(combination).collect()
    }
}

/// Takes out of a row what it has of a pivot's.
fn subtract(row: &mut [Fingerprint], column: usize, pivot: &[Fingerprint]) {
    let factor = row[column];
    if !factor.is_zero() {
        for (x, &p) in row.iter_mut().zip(pivot) {
            *x = *x - factor * p;
        }
    }
}
