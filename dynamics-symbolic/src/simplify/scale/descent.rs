//! The search for multiples that cost less.

use super::Scaling;
use super::multiple::{Multiple, Ratio, Scale};
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
            let is_moderate = self.multiple::<Ratio>(sum, first).is_moderate();
            self.sums[sum].multiple = if is_short && is_moderate {
                self.multiple(sum, first)
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
        let readers = this.readers.iter();
        let reading = readers.map(|place| &self.sums[place.sum].terms[place.term]);
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
        let mut best = (self.cost_with_multiple(&tally, old.ratio), None);
        for candidate in self.candidates(sum) {
            let ratio: Ratio = self.multiple(sum, candidate);
            if ratio.value == old.ratio.value || !ratio.is_moderate() {
                continue;
            }
            let cost = self.cost_with_multiple(&tally, ratio);
            if cost < best.0 || drift && cost == best.0 && best.1.is_none() {
                best = (cost, Some(candidate));
            }
        }
        if let Some(candidate) = best.1 {
            self.choose(sum, self.multiple(sum, candidate));
        }
    }

    /// The multiples to try: at least one.
    fn candidates(&self, sum: usize) -> Vec<Candidate> {
        let terms = self.sums[sum].terms.iter().enumerate();
        let own = terms
            .filter(|(_, term)| term.node.is_some())
            .map(|(index, _)| Candidate::Own(index));
        let places = self.sums[sum].readers.iter();
        let readers = places
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

    /// The multiple that a candidate stands for.
    fn multiple<M: Scale<'g>>(&self, sum: usize, candidate: Candidate) -> M {
        match candidate {
            Candidate::One => M::new(self.one),
            Candidate::Own(term) => self.coefficient(TermId { sum, term }),
            Candidate::Reader(place) => {
                let [sum, reader] = [sum, place.sum].map(|sum| M::new(self.sums[sum].multiple));
                sum.times(reader).over(self.coefficient(place))
            }
        }
    }

    /// The multiples that are tried for a sum.
    #[cfg(test)]
    pub(super) fn ratios(&self, sum: usize) -> Vec<Ratio> {
        let candidates = self.candidates(sum).into_iter();
        candidates
            .map(|candidate| self.multiple(sum, candidate))
            .collect()
    }

    /// The coefficient of a term in the sum itself, not in the multiple of it.
    pub(super) fn coefficient<M: Scale<'g>>(&self, place: TermId) -> M {
        let term = &self.sums[place.sum].terms[place.term];
        M::new(term.coefficient).times(self.product(&term.factors))
    }

    /// The multiple that a product of sums carries.
    pub(super) fn product<M: Scale<'g>>(&self, factors: &[Factor]) -> M {
        let one = M::new(self.one);
        factors.iter().fold(one, |product, factor| {
            let multiple = M::new(self.sums[factor.sum].multiple);
            if factor.inverted {
                product.over(multiple)
            } else {
                product.times(multiple)
            }
        })
    }
}
