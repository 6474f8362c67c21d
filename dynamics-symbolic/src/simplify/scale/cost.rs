//! The cost of the multiples: multiplications by constants.

use super::Scaling;
use super::multiple::{Ratio, Scale};
use super::terms::{Factor, TermId};
use crate::exact::negate_if;
use crate::expr::Fingerprint;

/// The multiplications that depend on the multiple of one sum, the multiples of all others given.
///
/// A coefficient with the multiple x in it, as c x or c / x, is 1 or -1 for one x up to sign, and these x are known
/// beforehand: the cost of many x takes one look at each coefficient, however many terms read the sum.
pub(super) struct Tally {
    sum: usize,
    /// The multiples, up to sign, for which a multiplication is saved: sorted, once for each.
    units: Vec<u64>,
    /// Terms and products where x enters in another power.
    others: Vec<TermId>,
    other_products: Vec<usize>,
}

impl Scaling<'_, '_> {
    /// The multiplications by constants that depend on the multiple of a sum.
    pub(super) fn tally(&self, sum: usize) -> Tally {
        let this = &self.sums[sum];
        let mut tally = Tally {
            sum,
            units: Vec::with_capacity(this.terms.len() + this.readers.len() + 1),
            others: Vec::new(),
            other_products: Vec::new(),
        };
        let terms = this.terms.iter().enumerate();
        for (term, _) in terms.filter(|(_, term)| term.node.is_some()) {
            // The coefficient over x.
            let ratio: Ratio = self.coefficient(TermId { sum, term });
            tally.units.push(magnitude(ratio.value));
        }
        if this.is_output {
            tally.units.push(magnitude(Fingerprint::ONE));
        }
        for &place in &this.readers {
            let (reader, x) = (&self.sums[place.sum], this.multiple.ratio);
            let term = &reader.terms[place.term];
            let coefficient = || self.coefficient::<Ratio>(place).over(reader.multiple.ratio);
            match power(&term.factors, sum) {
                1 => tally.units.push(magnitude(x.over(coefficient()).value)),
                -1 => tally.units.push(magnitude(x.times(coefficient()).value)),
                _ => tally.others.push(place),
            }
        }
        for &index in &this.products {
            let product: Ratio = self.product(&self.products[index]);
            let x = this.multiple.ratio;
            match power(&self.products[index], sum) {
                1 => tally.units.push(magnitude(x.over(product).value)),
                -1 => tally.units.push(magnitude(x.times(product).value)),
                _ => tally.other_products.push(index),
            }
        }
        tally.units.sort_unstable();
        tally
    }

    /// The multiplications by constants that a tally counts, if its sum were computed as `x` times itself.
    pub(super) fn cost_with_multiple(&mut self, tally: &Tally, x: Ratio) -> usize {
        let unit = magnitude(x.value);
        let first = tally.units.partition_point(|&other| other < unit);
        let same = tally.units[first..].iter();
        let saved = same.take_while(|&&other| other == unit).count();
        let ratio = &mut self.sums[tally.sum].multiple.ratio;
        let old = std::mem::replace(ratio, x);
        let others = tally.others.iter();
        let terms = others.filter(|&&place| self.is_multiplied(place));
        let others = tally.other_products.iter();
        let products = others.filter(|&&index| self.is_product_multiplied(index));
        let cost = tally.units.len() - saved + terms.count() + products.count();
        self.sums[tally.sum].multiple.ratio = old;
        cost
    }

    /// All multiplications by constants.
    pub(super) fn total_cost(&self) -> usize {
        let sums = (0..self.sums.len()).map(|sum| self.own_cost(sum));
        let indices = 0..self.products.len();
        let products = indices.filter(|&index| self.is_product_multiplied(index));
        sums.sum::<usize>() + products.count()
    }

    /// Multiplications in the terms of a sum, and at the output that it may be.
    fn own_cost(&self, sum: usize) -> usize {
        let this = &self.sums[sum];
        let indices = 0..this.terms.len();
        let terms = indices.filter(|&term| self.is_multiplied(TermId { sum, term }));
        let is_corrected = this.is_output && !is_unit(this.multiple.ratio.value);
        terms.count() + usize::from(is_corrected)
    }

    fn is_multiplied(&self, place: TermId) -> bool {
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
            let Ratio { value, inverse, .. } = self.sums[factor.sum].multiple.ratio;
            product * if factor.inverted { inverse } else { value }
        })
    }
}

/// The power in which the multiple of a sum is in a product.
fn power(factors: &[Factor], sum: usize) -> i32 {
    let own = factors.iter().filter(|factor| factor.sum == sum);
    own.map(|factor| negate_if(1, factor.inverted)).sum()
}

/// The same number for a value and its opposite.
fn magnitude(value: Fingerprint) -> u64 {
    value.get().min((-value).get())
}

/// Whether a constant is 1 or -1, which cost nothing.
fn is_unit(value: Fingerprint) -> bool {
    value == Fingerprint::ONE || value == -Fingerprint::ONE
}

#[cfg(test)]
mod tests {
    use super::super::{Judge, Network, Scaling};
    use crate::exact::Rational;
    use crate::expr::{Expr, Graph, Level};
    use crate::robot::Symbol;
    use crate::rounding::{Bounded, POINTS, Running};

    /// Sums that read one another once, squared, as a quotient and at outputs.
    fn outputs(graph: &Graph) -> Vec<Expr<'_>> {
        let [x, y, z, w] = [(); 4].map(|()| graph.symbol(Level::Variable));
        let number = |n: i64| graph.rational(&Rational::from(n));
        let inner = number(2) * x + number(3) * y;
        let other = number(5) * z + number(7) * w;
        vec![
            number(3) * (inner * z) + number(4) * w,
            number(5) * (inner * inner) + number(2) * other,
            number(7) * (other / inner) + x,
            inner * other,
            inner * inner * w,
            inner,
        ]
    }

    /// A tally differs between two multiples as the total cost does.
    #[test]
    fn a_tally_counts_what_the_total_counts() {
        let graph = Graph::new();
        let edges: Vec<_> = outputs(&graph).iter().map(|e| e.edge()).collect();
        let network = Network::new(&graph, &edges);
        let meanings: Vec<_> = (0..4).map(Symbol::Position).collect();
        let running = Running::new(&graph, &meanings, |_, _| Bounded::exact(0.5));
        let allowed = vec![[f64::INFINITY; POINTS]; edges.len()];
        let mut judge = Judge::new(&network, running, allowed);
        let order = network.order();
        let mut scaling = Scaling::new(&network, &order, &mut judge).expect("inverses");
        assert!(scaling.sums.len() >= 5);
        for sum in 0..scaling.sums.len() {
            let (tally, old) = (scaling.tally(sum), scaling.sums[sum].multiple.ratio);
            let rest = scaling.total_cost() - scaling.cost_with_multiple(&tally, old);
            for ratio in scaling.ratios(sum) {
                let local = scaling.cost_with_multiple(&tally, ratio);
                scaling.sums[sum].multiple.ratio = ratio;
                assert_eq!(scaling.total_cost(), rest + local);
                scaling.sums[sum].multiple.ratio = old;
            }
            let last = scaling.ratios(sum)[0];
            scaling.sums[sum].multiple.ratio = last;
        }
    }
}
