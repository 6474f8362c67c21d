//! Bodies: those that move together, and links of which nothing is said.

use std::collections::BTreeSet;

use dynamics_symbolic::exact::Rational;

use super::assembly::{Assembly, Moved};
use super::tree::Inertial;
use crate::mistake::links as mistake;
use crate::validate::refusal;

impl Assembly<'_> {
    /// The nearest row that moves, of the one that carries something: what stands still is a part of its link, or of the
    /// base.
    pub(super) fn moving(&self, mut row: Option<usize>) -> Option<usize> {
        while let Some(moved) = row.map(|row| &self.moved[row])
            && moved.is_locked
        {
            row = moved.parent;
        }
        row
    }

    /// Reports the links that move without anything being said of their inertia, all of them.
    pub(super) fn report_without_inertia(&self) {
        if self.request.no_inertia {
            return;
        }
        let rows = 0..self.moved.len();
        let said = rows
            .clone()
            .filter(|&row| self.moved[row].carried.is_some());
        let said: BTreeSet<_> = said.map(|row| self.moving(Some(row))).collect();
        let base_is_known = self.base.is_some() || said.contains(&None);
        let mut links = Vec::new();
        if self.request.base.is_some() && !base_is_known {
            links.push((self.first, self.place_of(self.first)));
        }
        let known: BTreeSet<usize> = said.into_iter().flatten().collect();
        if self.request.may_be_geometry && self.request.base.is_none() && known.is_empty() {
            return;
        }
        // The rows that carry one whose inertia is known.
        let mut carrying = BTreeSet::new();
        for &row in &known {
            let mut row = Some(row);
            while let Some(at) = row.filter(|at| carrying.insert(*at)) {
                row = self.moved[at].parent;
            }
        }
        let mut joints = Vec::new();
        for row in rows {
            let Moved { joint, place, .. } = self.moved[row];
            if self.moved[row].is_locked || known.contains(&row) {
                continue;
            }
            links.push((&joint.child, place));
            // A joint that others follow may carry theirs.
            if self.coupled.is_empty() && !carrying.contains(&row) {
                joints.push(joint.name.as_str());
            }
        }
        let names: Vec<&str> = links.iter().map(|(name, _)| *name).collect();
        if let Some((_, place)) = links.first() {
            let mistake = mistake::no_inertial(&names, &joints, self.tree.words.body);
            self.error(*place, mistake);
        }
    }

    pub(super) fn judge(&self, inertial: &Inertial, carrier: Option<&str>) {
        if inertial.mass < Rational::ZERO {
            self.error(inertial.place, mistake::negative_mass());
        }
        let tensor = inertial.tensor.each_ref().map(|entry| Some(entry.clone()));
        let is_allowed = self.request.allowed(carrier).unphysical_inertia;
        if let Some(reason) = refusal(&tensor).filter(|_| !is_allowed) {
            self.error(inertial.place, mistake::no_body(reason));
        }
    }
}
