//! The ways over the links of an arm: outwards, inwards, and along the links that carry one.
//!
//! A link knows the link that carries it. In a serial arm this is the one before it.

use core::fmt::Debug;
use core::ops::{Add, Index, IndexMut};

use dynamics_runtime::Size;

use super::NumericArm;
use super::link::Link;

/// A link on the way, and how its joint moves: at so many times the position of a joint of q.
#[derive(Clone, Copy)]
pub(super) struct Place<'a> {
    /// Links are counted from 0, each behind the one that carries it.
    pub(super) k: usize,
    pub(super) link: &'a Link,
    /// The link that carries it; none for a link on the base.
    pub(super) carrier: Option<usize>,
    /// The place of the joint among the velocities.
    pub(super) joint: usize,
    pub(super) factor: f64,
    /// How many velocities there are before those of the joints.
    first: usize,
}

impl Place<'_> {
    /// The rate of the joint, from all velocities or their rates.
    #[inline(always)]
    pub(super) fn of(&self, velocities: &impl Index<usize, Output = f64>) -> f64 {
        self.factor * velocities[self.joint]
    }

    /// The position of the joint, from those of the joints of q.
    #[inline(always)]
    pub(super) fn position(&self, q: &impl Index<usize, Output = f64>) -> f64 {
        self.factor * q[self.joint_of_q()]
    }

    /// The place of the joint among those of q.
    #[inline(always)]
    pub(super) fn joint_of_q(&self) -> usize {
        self.joint - self.first
    }

    /// Adds a force at this joint to those at the joints of q, times the factor by which this joint moves.
    #[inline(always)]
    pub(super) fn add(&self, forces: &mut impl IndexMut<usize, Output = f64>, force: f64) {
        forces[self.joint] += self.factor * force;
    }

    /// The value that the link hands on to the one that carries it, or to a base that moves; none on a base that stands.
    #[inline(always)]
    pub(super) fn hand_on<X>(&self, value: impl FnOnce() -> X) -> Option<X> {
        (self.carrier.is_some() || self.first > 0).then(value)
    }

    /// Adds a column that belongs to this joint to those of the joints of q.
    #[inline(always)]
    pub(super) fn add_column(
        &self,
        columns: &mut impl IndexMut<(usize, usize), Output = f64>,
        rows: usize,
        entry: impl Fn(usize) -> f64,
    ) {
        for row in 0..rows {
            columns[(row, self.joint)] += self.factor * entry(row);
        }
    }
}

impl<D: Size, V: Size> NumericArm<D, V> {
    #[inline(always)]
    pub(super) fn place(&self, k: usize) -> Place<'_> {
        let link = &self.links[k];
        Place {
            k,
            link,
            carrier: link.carrier,
            joint: link.joint,
            factor: link.factor,
            first: self.first(),
        }
    }

    /// From the base outwards: each link behind the one that carries it.
    #[inline(always)]
    pub(super) fn walk_outward(&self, mut visit: impl FnMut(Place<'_>)) {
        for k in 0..self.count {
            visit(self.place(k));
        }
    }

    /// From the tips inwards: each link before the one that carries it.
    #[inline(always)]
    pub(super) fn walk_inward(&self, mut visit: impl FnMut(Place<'_>)) {
        for k in (0..self.count).rev() {
            visit(self.place(k));
        }
    }

    /// Over the links that carry link k, from there to the base. Link k itself is none of them.
    #[inline(always)]
    pub(super) fn walk_carriers(&self, k: usize, visit: impl FnMut(Place<'_>)) {
        self.walk_from(self.links[k].carrier, visit);
    }

    /// As [`walk_carriers`](Self::walk_carriers), beginning with link k.
    #[inline(always)]
    pub(super) fn walk_to_base(&self, k: usize, visit: impl FnMut(Place<'_>)) {
        self.walk_from(Some(k), visit);
    }

    /// As [`walk_carriers`](Self::walk_carriers), beginning with this link; no link is the base.
    #[inline(always)]
    pub(super) fn walk_from(&self, mut here: Option<usize>, mut visit: impl FnMut(Place<'_>)) {
        while let Some(k) = here {
            let place = self.place(k);
            visit(place);
            here = place.carrier;
        }
    }

    /// A value for each link, which begin as the same.
    #[inline(always)]
    pub(super) fn per_link<X: Copy + Debug>(&self, value: X) -> D::Links<X> {
        self.size.links(self.count, value)
    }

    /// A value for each joint of q, made of its own link.
    pub(super) fn per_joint<X: Clone + Debug>(
        &self,
        mut value: impl FnMut(usize) -> X,
    ) -> D::Each<X> {
        let mut own = self.size.each(|_| 0);
        self.walk_outward(|place| {
            if !place.link.is_follower {
                own[place.joint_of_q()] = place.k;
            }
        });
        self.size.each(|joint| value(own[joint]))
    }

    /// From the base outwards: `step` makes the value of a link of that of the link that carries it.
    ///
    /// Along a row of links the value stays in registers: only that of a link with branches is read again.
    #[inline(always)]
    pub(super) fn outward<X: Copy + Debug>(
        &self,
        base: X,
        mut step: impl FnMut(Place<'_>, &X) -> X,
    ) {
        let mut kept = self.has_branches.then(|| self.per_link(base));
        let mut last = base;
        self.walk_outward(
            #[inline(always)]
            |place| {
                if let Some(kept) = &kept {
                    last = place.carrier.map_or(base, |carrier| kept[carrier]);
                }
                last = step(place, &last);
                if let Some(kept) = &mut kept {
                    kept[place.k] = last;
                }
            },
        );
    }

    /// From the tips inwards: `step` is given the sum of a link's `own` value and of the values handed on to it by the links
    /// that it carries. It returns the value that this link hands on, if a link carries it or the base moves.
    ///
    /// Returned is the sum of the values that are handed on to the base; none if it stands, or if it carries nothing.
    #[inline(always)]
    pub(super) fn inward<X: Copy + Debug + Add<Output = X>>(
        &self,
        own: impl Fn(Place<'_>) -> X,
        mut step: impl FnMut(Place<'_>, X) -> Option<X>,
    ) -> Option<X> {
        let mut kept = self.has_branches.then(|| self.per_link(None::<X>));
        let mut handed_on = None;
        let mut to_base: Option<X> = None;
        self.walk_inward(
            #[inline(always)]
            |place| {
                if let Some(kept) = &kept {
                    handed_on = kept[place.k];
                }
                let sum = match handed_on {
                    Some(value) => own(place) + value,
                    None => own(place),
                };
                handed_on = step(place, sum);
                if let (Some(kept), Some(value), Some(carrier)) =
                    (&mut kept, handed_on, place.carrier)
                {
                    kept[carrier] = Some(kept[carrier].map_or(value, |sum| sum + value));
                }
                if let (true, None, Some(value)) = (self.floats(), place.carrier, handed_on) {
                    to_base = Some(to_base.map_or(value, |sum| sum + value));
                }
            },
        );
        to_base
    }
}
