//! The search for multiples that cost less.

use super::Scaling;
use super::multiple::{Multiple, Ratio};
use super::terms::{Factor, TermId};

/// A multiple to try.
#[derive(Clone, Copy)]
enum Candidate {
    /// The sum itself.
    One,
    /// That which makes the coefficient of this term 1.
    Own(usize),
    /// That which makes the coefficient 1 in a reader, in this term of it.
    Reader(TermId),
}

impl<'g> Scaling<'_, 'g> {
    /// Descents from several starts: from the sums as they are, and from sums
    /// whose first coefficient is 1. The best multiples found are kept.
    pub(super) fn descend(&mut self) {
        let mut best = (self.total_cost(), self.multiples());
        for longest in [0, 1, usize::MAX] {
            self.start(longest);
            self.settle(&mut best);
            self.drift();
            self.settle(&mut best);
        }
        for (sum, multiple) in self.sums.iter_mut().zip(best.1) {
            sum.multiple = multiple;
        }
    }

    fn multiples(&self) -> Vec<Multiple<'g>> {
        self.sums.iter().map(|sum| sum.multiple).collect()
    }

    /// Sums of up to `longest` terms with a first coefficient of 1, the others as they are.
    fn start(&mut self, longest: usize) {
        for sum in 0..self.sums.len() {
            let is_short = self.sums[sum].terms.len() <= longest;
            let first = self.candidates(sum)[0];
            self.sums[sum].multiple = if is_short && self.ratio(sum, first).is_moderate() {
                self.exact(sum, first)
            } else {
                self.one
            };
        }
        self.settled.fill(false);
    }

    /// Improves multiples until none can be, and keeps them if they cost less than the best. It ends:
    /// every improvement is one of the total cost.
    fn settle(&mut self, best: &mut (usize, Vec<Multiple<'g>>)) {
        while self.settled.contains(&false) {
            for sum in 0..self.sums.len() {
                if !self.settled[sum] {
                    self.settled[sum] = true;
                    self.improve(sum, false);
                }
            }
        }
        let cost = self.total_cost();
        if cost < best.0 {
            *best = (cost, self.multiples());
        }
    }

    /// Moves that cost nothing carry multiples towards the readers, where they meet others.
    fn drift(&mut self) {
        for sum in 0..self.sums.len() {
            self.improve(sum, true);
        }
    }

    /// Takes a multiple: what it costs to change it, and the multiples that share
    /// a coefficient with it, is another question from now on.
    fn choose(&mut self, sum: usize, multiple: Multiple<'g>) {
        self.sums[sum].multiple = multiple;
        self.settled[sum] = false;
        let this = &self.sums[sum];
        for place in &this.readers {
            self.settled[place.sum] = false;
        }
        let reading = this
            .readers
            .iter()
            .map(|place| &self.sums[place.sum].terms[place.term]);
        let terms = this.terms.iter().chain(reading).map(|term| &term.factors);
        let products = this.products.iter().map(|&index| &self.products[index]);
        for factor in terms.chain(products).flatten() {
            self.settled[factor.sum] = false;
        }
    }

    /// Takes the best of the multiples that make one coefficient 1, or the sum
    /// itself; with `drift`, another one also where it is no better.
    fn improve(&mut self, sum: usize, drift: bool) {
        let old = self.sums[sum].multiple;
        let tally = self.tally(sum);
        let mut best = (self.local_cost(&tally, old.ratio), None);
        for candidate in self.candidates(sum) {
            let ratio = self.ratio(sum, candidate);
            if ratio.value == old.ratio.value || !ratio.is_moderate() {
                continue;
            }
            let cost = self.local_cost(&tally, ratio);
            if cost < best.0 || drift && cost == best.0 && best.1.is_none() {
                best = (cost, Some(candidate));
            }
        }
        if let Some(candidate) = best.1 {
            self.choose(sum, self.exact(sum, candidate));
        }
    }

    /// The multiples to try: at least one.
    fn candidates(&self, sum: usize) -> Vec<Candidate> {
        let terms = self.sums[sum].terms.iter().enumerate();
        let own = terms
            .filter(|(_, term)| term.node.is_some())
            .map(|(index, _)| Candidate::Own(index));
        let readers = self.sums[sum].readers.iter();
        let readers = readers
            .filter(|&&place| self.is_linear_reader(sum, place))
            .map(|&place| Candidate::Reader(place));
        own.chain(readers).chain([Candidate::One]).collect()
    }

    /// Whether the multiple of a sum enters a term once, and not as an inverse.
    fn is_linear_reader(&self, sum: usize, place: TermId) -> bool {
        let factors = &self.sums[place.sum].terms[place.term].factors;
        let mut powers = factors.iter().filter(|factor| factor.sum == sum);
        let inverted = false;
        powers.next() == Some(&Factor { sum, inverted }) && powers.next().is_none()
    }

    /// The multiple that a candidate stands for, as a fingerprint.
    fn ratio(&self, sum: usize, candidate: Candidate) -> Ratio {
        match candidate {
            Candidate::One => Ratio::ONE,
            Candidate::Own(term) => self.coefficient_ratio(TermId { sum, term }),
            Candidate::Reader(place) => {
                let (sum, reader) = (&self.sums[sum], &self.sums[place.sum]);
                sum.multiple
                    .ratio
                    .times(reader.multiple.ratio)
                    .over(self.coefficient_ratio(place))
            }
        }
    }

    /// The multiples that are tried for a sum.
    #[cfg(test)]
    pub(super) fn ratios(&self, sum: usize) -> Vec<Ratio> {
        let candidates = self.candidates(sum).into_iter();
        candidates
            .map(|candidate| self.ratio(sum, candidate))
            .collect()
    }

    /// The multiple that a candidate stands for.
    fn exact(&self, sum: usize, candidate: Candidate) -> Multiple<'g> {
        match candidate {
            Candidate::One => self.one,
            Candidate::Own(term) => self.exact_coefficient(TermId { sum, term }),
            Candidate::Reader(place) => {
                let coefficient = self.exact_coefficient(place);
                let (sum, reader) = (&self.sums[sum], &self.sums[place.sum]);
                sum.multiple.times(reader.multiple).over(coefficient)
            }
        }
    }

    /// The coefficient of a term in the sum itself, not in the multiple of it.
    pub(super) fn coefficient_ratio(&self, place: TermId) -> Ratio {
        let term = &self.sums[place.sum].terms[place.term];
        term.coefficient.ratio.times(self.product(&term.factors))
    }

    /// The multiple that a product of sums carries, as a fingerprint.
    pub(super) fn product(&self, factors: &[Factor]) -> Ratio {
        factors.iter().fold(Ratio::ONE, |product, factor| {
            let ratio = self.sums[factor.sum].multiple.ratio;
            if factor.inverted {
                product.over(ratio)
            } else {
                product.times(ratio)
            }
        })
    }

    /// As [`Scaling::coefficient_ratio`], exact.
    pub(super) fn exact_coefficient(&self, place: TermId) -> Multiple<'g> {
        let term = &self.sums[place.sum].terms[place.term];
        term.coefficient.times(self.exact_product(&term.factors))
    }

    /// The multiple that a product of sums carries, exact.
    pub(super) fn exact_product(&self, factors: &[Factor]) -> Multiple<'g> {
        factors.iter().fold(self.one, |product, factor| {
            let multiple = self.sums[factor.sum].multiple;
            if factor.inverted {
                product.over(multiple)
            } else {
                product.times(multiple)
            }
        })
    }
}
