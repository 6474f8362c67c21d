//! The sine alone, or the cosine alone.
//!
//! In a batch, one part of an angle's pair is one polynomial instead of two: the cosine of what is left of the angle
//! is 1 - 2 sin^2 of its half, so that all lanes evaluate the same sine. A single angle takes a branch between the
//! two polynomials, because its digits have to be those of the pair, which a `SharedSines` looks up.

use super::lanes::Reduced;
#[cfg(feature = "std")]
use super::{Kernel as _, sin_cos};
use super::{Lanes, Sines};

/// The part of the sine and the cosine of an angle that a generated function reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Both of them.
    Both,
    /// The sine.
    Sine,
    /// The cosine.
    Cosine,
}

impl Part {
    #[inline(always)]
    fn of<L>(self, (sine, cosine): (L, L)) -> L {
        if self == Part::Cosine { cosine } else { sine }
    }

    /// The value for the angle that is left of a quarter turn, with the sign that it has after n of them.
    #[inline(always)]
    fn signed<L: Lanes>(self, value: L, n: L) -> L {
        match self {
            Part::Cosine => value.turned_by_lowest_bits(n),
            _ => value.turned_by_bit::<1>(n),
        }
    }
}

/// Sine or cosine of one angle, with the digits that it has beside the other.
///
/// The choice of the polynomial is a branch that a processor predicts: angles stay in their quarter turn for many calls.
#[inline]
pub(super) fn one<F: Sines>(x: F, part: Part) -> F {
    if !x.all_within(F::LARGEST) {
        return part.of(x.sin_cos_of_large());
    }
    let Reduced { n, rest, excess } = F::reduce(x);
    // The compiler leaves out of each branch the polynomial of the other one.
    let value = if n.is_odd() == (part == Part::Cosine) {
        F::sin_cos_reduced(rest, excess).0
    } else {
        F::sin_cos_reduced(rest, excess).1
    };
    part.signed(value, n)
}

/// Sine or cosine of angles in the lanes of a batch, of magnitude up to [`Kernel::LARGEST`](super::Kernel::LARGEST),
/// by one polynomial. Lanes that are to have the cosine of what is left of the angle take cos x = 1 - 2 sin^2 (x/2).
///
/// The error of the sine is at most 0.55 units in the last place where |x/2| < pi/8. Four times as many of its units
/// are 0.42 of those of the cosine, which is rounded once where products are fused: its error is below 0.95 units.
/// Elsewhere it would be above one unit, and both polynomials are evaluated.
#[cfg(feature = "std")]
#[inline(always)]
pub(crate) fn part_in_lanes<L: Lanes>(x: L, part: Part) -> L {
    if !x.fuses() {
        return part.of(sin_cos(x));
    }
    let (half, unit) = (x.constant(L::Number::HALF), x.constant(L::Number::ONE));
    let Reduced { n, rest, excess } = L::Number::reduce(x);
    // One parity of n needs the sine, the other the cosine.
    let choose = |sine: L, cosine: L| match part {
        Part::Cosine => n.select_by_lowest_bit(sine, cosine),
        _ => n.select_by_lowest_bit(cosine, sine),
    };
    let share = choose(unit, half);
    let sine = L::Number::sine_reduced(rest * share, excess * share);
    part.signed(choose(sine, sine.product_from(sine + sine, unit)), n)
}
