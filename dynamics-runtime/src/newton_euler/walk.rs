//! The ways over the links of an arm: outwards, inwards, and along the links that carry one.
//!
//! A link knows the link that carries it. Of a serial arm that is the one before it.

use core::fmt::Debug;
use core::ops::Add;

use super::NumericArm;
use super::link::Link;
use crate::size::Size;

impl<D: Size> NumericArm<D> {
    /// The links from the base outwards, each behind the one that carries it.
    #[inline(always)]
    pub(super) fn links(&self) -> impl DoubleEndedIterator<Item = (usize, &Link)> {
        (0..self.count).map(|k| (k, &self.links[k]))
    }

    /// A value for each link, which begin as the same.
    #[inline(always)]
    pub(super) fn per_link<X: Clone + Debug>(&self, value: X) -> D::Links<X> {
        self.size.links(self.count, value)
    }

    /// A value for each joint of q, made of its own link.
    pub(super) fn per_joint<X: Clone + Debug>(&self, value: impl FnMut(usize) -> X) -> D::Each<X> {
        let mut own = self.size.each(|_| 0);
        for (k, link) in self.links().filter(|(_, link)| !link.is_follower) {
            own.as_mut()[link.joint] = k;
        }
        let mut value = value;
        self.size.each(|joint| value(own.as_ref()[joint]))
    }

    /// From the base outwards: a value for each link, which `step` makes of that of the link that carries it.
    #[inline(always)]
    pub(super) fn outward<X: Clone + Debug>(
        &self,
        base: X,
        mut step: impl FnMut(usize, &Link, &X) -> X,
    ) -> D::Links<X> {
        let mut values = self.per_link(base.clone());
        for (k, link) in self.links() {
            let value = match link.carrier {
                Some(carrier) => step(k, link, &values[carrier]),
                None => step(k, link, &base),
            };
            values[k] = value;
        }
        values
    }

    /// From the tips inwards: `carry` makes of the sum that a link carries what the link that carries it gets besides
    /// its own value. The values become the sums.
    #[inline(always)]
    pub(super) fn inward<X: Copy + Add<Output = X>>(
        &self,
        values: &mut D::Links<X>,
        carry: impl Fn(usize, X) -> X,
    ) where
        X: Debug,
    {
        for (k, link) in self.links().rev() {
            if let Some(carrier) = link.carrier {
                values[carrier] = values[carrier] + carry(k, values[k]);
            }
        }
    }

    /// A link and those that carry it, from the link to the base.
    #[inline(always)]
    pub(super) fn carriers(&self, k: usize) -> impl Iterator<Item = (usize, &Link)> {
        let next = |(_, link): &(usize, &Link)| link.carrier;
        let mut here = Some((k, &self.links[k]));
        core::iter::from_fn(move || {
            let found = here?;
            here = next(&found).map(|carrier| (carrier, &self.links[carrier]));
            Some(found)
        })
    }
}
