//! Sums of many small steps, without the rounding of the sum.

use dynamics_runtime::Size;
use dynamics_runtime::internal::two_sums;

use super::Point;

/// Positions and momenta, and what the rounding of their sums has left out of them (W. Kahan 1965;
/// D. E. Knuth, *The Art of Computer Programming* 2, theorem 4.2.2 B).
#[derive(Clone, Debug)]
pub(super) struct Compensated<D: Size> {
    pub(super) value: Point<D>,
    remainder: Point<D>,
}

impl<D: Size> Compensated<D> {
    pub(super) fn new(value: Point<D>) -> Self {
        let remainder = Point::zeros(D::of(&value.q));
        Compensated { value, remainder }
    }

    /// `self + factor * rate`, rounded.
    #[inline(always)]
    pub(super) fn plus(&self, factor: f64, rate: &Point<D>) -> Point<D> {
        self.value.plus(1.0, &self.remainder.plus(factor, rate))
    }

    /// Adds `factor * rate`.
    pub(super) fn add(&mut self, factor: f64, rate: &Point<D>) {
        let step = self.remainder.plus(factor, rate);
        (self.value.q, self.remainder.q) = two_sums(&self.value.q, &step.q);
        (self.value.p, self.remainder.p) = two_sums(&self.value.p, &step.p);
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Const, Vector1};

    use super::Compensated;
    use crate::integrate::Point;

    #[test]
    fn small_steps_are_not_lost() {
        let vector = |x: f64| Vector1::new(x);
        let start = Point::<Const<1>> {
            q: vector(1.0),
            p: vector(-1e6),
        };
        let step = Point {
            q: vector(1e-17),
            p: vector(1e-11),
        };
        let mut sum = Compensated::new(start);
        for _ in 0..100_000 {
            sum.add(1.0, &step);
        }
        assert!((sum.value.q[0] - (1.0 + 1e-12)).abs() < 3e-16);
        assert!((sum.value.p[0] - (1e-6 - 1e6)).abs() < 2e-10);
        let plain = (0..100_000).fold(1.0, |sum, _| sum + 1e-17);
        assert_eq!(plain, 1.0);
    }
}
