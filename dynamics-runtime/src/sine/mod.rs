//! Sine and cosine of several angles at once.
//!
//! Sines take most of the time of a short program. The kernels, one for each precision, have no branches, so that
//! several angles are evaluated in the lanes of a vector register. No operation of theirs rounds otherwise where it is
//! fused: every processor and every number of lanes gives the same digits. Angles beyond [`Kernel::LARGEST`] are
//! reduced exactly, one by one.

mod columns;
mod double;
mod lanes;
mod part;
mod single;
#[cfg(test)]
pub(crate) mod tests;
mod vectors;

pub use columns::sin_cos_column;
use fearless_simd::Level;
use lanes::Reduced;
pub(crate) use lanes::{Kernel, Lanes};
pub use part::Part;
#[cfg(feature = "std")]
pub(crate) use part::part_in_lanes;
pub(crate) use vectors::level;
use vectors::{Pair, eight, eight_singles, four, four_singles, two, two_singles};

/// A precision whose sines of several angles are evaluated at once.
pub(crate) trait Sines: Lanes<Number = Self> + Kernel {
    /// Sine and cosine of every angle, rad.
    ///
    /// Error below one unit in the last place. Not a number, and infinities, give NaN.
    fn of_array<const K: usize>(x: [Self; K]) -> [(Self, Self); K];

    /// Whether the lowest bit is set.
    fn is_odd(self) -> bool;

    /// The parts of the sine and the cosine of every angle, with the digits of [`of_array`](Sines::of_array);
    /// the rest is any number.
    #[inline(always)]
    fn parts_of_array<const K: usize>(x: [Self; K], parts: [Part; K]) -> [(Self, Self); K] {
        match parts.first() {
            Some(part) if K == 1 && *part != Part::Both => {
                let value = part::one(x[0], *part);
                [(value, value); K]
            }
            // In the lanes of a vector the other part costs nothing.
            _ => Self::of_array(x),
        }
    }
}

// Inlined always, as is all that takes angles or gives sines in arrays. A function that is called has its arrays in
// memory, and the angles that the caller writes one by one would be read as one vector. A processor does that only
// when all of them have arrived there.
macro_rules! impl_sines {
    ($($float:ident: $two:ident, $four:ident, $eight:ident;)*) => {$(
        impl Sines for $float {
            #[inline(always)]
            fn is_odd(self) -> bool {
                self.to_bits() & 1 == 1
            }

            #[inline(always)]
            fn of_array<const K: usize>(x: [$float; K]) -> [($float, $float); K] {
                let mut values = [(0.0, 1.0); K];
                match K {
                    0 => {}
                    1 => values[0] = one(x[0]),
                    _ if Level::baseline().is_fallback() => each(&x, &mut values),
                    2 => store($two(level(), x[0], x[1]), &mut values),
                    3 => store($four(level(), x[0], x[1], x[2], 0.0), &mut values),
                    4 => store($four(level(), x[0], x[1], x[2], x[3]), &mut values),
                    5..=8 => {
                        let [a, b, c, d, e] = [x[0], x[1], x[2], x[3], x[4]];
                        let [f, g, h] = [at(&x, 5), at(&x, 6), at(&x, 7)];
                        store($eight(level(), a, b, c, d, e, f, g, h), &mut values);
                    }
                    _ => {
                        for (x, values) in x.chunks(8).zip(values.chunks_mut(8)) {
                            let [a, b, c, d, e, f, g, h] = filled(x);
                            store($eight(level(), a, b, c, d, e, f, g, h), values);
                        }
                    }
                }
                values
            }
        }
    )*};
}

impl_sines! {
    f64: two, four, eight;
    f32: two_singles, four_singles, eight_singles;
}

/// An angle, or zero where there are fewer. The index is known to the compiler: the angles need no memory.
#[inline(always)]
fn at<F: Copy + Default, const K: usize>(x: &[F; K], i: usize) -> F {
    if i < K { x[i] } else { F::default() }
}

/// Up to eight angles, and zeros.
#[inline(always)]
fn filled<F: Copy + Default>(x: &[F]) -> [F; 8] {
    core::array::from_fn(|i| if i < x.len() { x[i] } else { F::default() })
}

/// The first lanes, as many as there are places for them.
#[inline(always)]
fn store<F, const W: usize>((sines, cosines): Pair<F, W>, values: &mut [(F, F)]) {
    for (value, pair) in values.iter_mut().zip(sines.into_iter().zip(cosines)) {
        *value = pair;
    }
}

/// Where the target has no vectors.
#[inline(always)]
fn each<F: Sines>(x: &[F], values: &mut [(F, F)]) {
    for (value, x) in values.iter_mut().zip(x) {
        *value = one(*x);
    }
}

/// Sine and cosine of one angle.
#[inline]
pub(crate) fn one<F: Sines>(x: F) -> (F, F) {
    if x.all_within(F::LARGEST) {
        sin_cos(x)
    } else {
        x.sin_cos_of_large()
    }
}

/// Sine and cosine of angles of magnitude up to [`Kernel::LARGEST`].
#[inline(always)]
pub(crate) fn sin_cos<L: Lanes>(x: L) -> (L, L) {
    of_reduced(L::Number::reduce(x))
}

/// Sine and cosine of n pi/2 + rest - excess.
#[inline(always)]
fn of_reduced<L: Lanes>(Reduced { n, rest, excess }: Reduced<L>) -> (L, L) {
    let (s, c) = L::Number::sin_cos_reduced(rest, excess);
    // A quarter turn: (s, c) -> (c, -s).
    let sine = n.select_by_lowest_bit(c, s).turned_by_bit::<1>(n);
    let cosine = n.select_by_lowest_bit(s, c).turned_by_lowest_bits(n);
    (sine, cosine)
}
