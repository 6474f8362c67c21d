//! Arithmetic of bounds, every result rounded up.
//!
//! A computed result is off by half a unit in the last place at most, so that the next larger number is a bound.

use core::ops::{Add, Div, Mul};

use super::rounded::Magnitude;

/// The greatest size of an error: zero or more; infinite where nothing is known. Never NaN.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub(super) struct Bound<F>(F);

impl<F: Magnitude> Bound<F> {
    pub(super) const NONE: Self = Bound(F::ZERO);
    pub(super) const UNKNOWN: Self = Bound(F::INFINITY);

    /// The bound `x`, which is exact; infinity for a negative `x` and for NaN.
    pub(super) fn new(x: F) -> Self {
        if x >= F::ZERO {
            // 0 for -0, which is not less.
            Bound(x + F::ZERO)
        } else {
            Bound::UNKNOWN
        }
    }

    pub(super) fn get(self) -> F {
        self.0
    }

    /// A result of operations on bounds, rounded to nearest.
    fn rounded_up(x: F) -> Self {
        Bound::new(x.above())
    }

    pub(super) fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }

    pub(super) fn max(self, other: Self) -> Self {
        if other > self { other } else { self }
    }

    fn is_known(self) -> bool {
        self.0 < F::INFINITY
    }

    /// `self - other` rounded down; `None` where that is not greater than zero.
    pub(super) fn beyond(self, other: Self) -> Option<Self> {
        let difference = self.0 - other.0;
        // A difference with zero is exact.
        let is_exact = other == Bound::NONE;
        let rest = if is_exact {
            difference
        } else {
            difference.below()
        };
        (rest > F::ZERO).then_some(Bound(rest))
    }
}

impl<F: Magnitude> Add for Bound<F> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        if self == Bound::NONE {
            other
        } else if other == Bound::NONE {
            self
        } else {
            Bound::rounded_up(self.0 + other.0)
        }
    }
}

impl<F: Magnitude> Mul for Bound<F> {
    type Output = Self;

    /// An unknown bound stays unknown, times zero too.
    fn mul(self, other: Self) -> Self {
        if !(self.is_known() && other.is_known()) {
            Bound::UNKNOWN
        } else if self == Bound::NONE || other == Bound::NONE {
            Bound::NONE
        } else {
            Bound::rounded_up(self.0 * other.0)
        }
    }
}

impl<F: Magnitude> Div for Bound<F> {
    type Output = Self;

    /// By a number that is at least `other`, which is greater than zero.
    fn div(self, other: Self) -> Self {
        if self == Bound::NONE || !self.is_known() {
            self
        } else {
            Bound::rounded_up(self.0 / other.0)
        }
    }
}
