//! What the multiples cost: multiplications by constants.

use super::Scaling;
use super::terms::{Factor, Place};
use crate::expr::Fingerprint;

impl Scaling<'_, '_> {
    /// Multiplications by constants that depend on the multiple of a sum.
    pub(super) fn local_cost(&self, sum: usize) -> usize {
        let readers = self.sums[sum].readers.iter();
        let products = self.sums[sum].products.iter();
        self.own_cost(sum)
            + readers.filter(|&&place| self.is_multiplied(place)).count()
            + products
                .filter(|&&index| self.is_product_multiplied(index))
                .count()
    }

    /// All multiplications by constants.
    pub(super) fn total_cost(&self) -> usize {
        let products = 0..self.products.len();
        (0..self.sums.len())
            .map(|sum| self.own_cost(sum))
            .sum::<usize>()
            + products
                .filter(|&index| self.is_product_multiplied(index))
                .count()
    }

    /// Multiplications in the terms of a sum, and at the output that it may be.
    fn own_cost(&self, sum: usize) -> usize {
        let terms = (0..self.sums[sum].terms.len())
            .filter(|&term| self.is_multiplied(Place { sum, term }))
            .count();
        let is_corrected =
            self.sums[sum].is_output && !is_unit(self.sums[sum].multiple.ratio.value);
        terms + usize::from(is_corrected)
    }

    fn is_multiplied(&self, place: Place) -> bool {
        let sum = &self.sums[place.sum];
        let term = &sum.terms[place.term];
        let multiple = || self.value(&term.factors) * sum.multiple.ratio.inverse;
        term.node.is_some() && !is_unit(term.coefficient.ratio.value * multiple())
    }

    fn is_product_multiplied(&self, index: usize) -> bool {
        !is_unit(self.value(&self.products[index]))
    }

    /// The value of the multiple that a product of sums carries: what
    /// [`Scaling::product`] gives, without the inverse, for this is asked most.
    fn value(&self, factors: &[Factor]) -> Fingerprint {
        factors.iter().fold(Fingerprint::ONE, |product, factor| {
            let ratio = self.sums[factor.sum].multiple.ratio;
            product
                * if factor.inverted {
                    ratio.inverse
                } else {
                    ratio.value
                }
        })
    }
}

/// Whether a constant is 1 or -1, which cost nothing.
fn is_unit(value: Fingerprint) -> bool {
    value == Fingerprint::ONE || value == -Fingerprint::ONE
}
