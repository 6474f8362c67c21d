//! Sines of several angles, each of which is in lanes.

use crate::operators::impl_operators;
use crate::sine::{self, Lanes};
use crate::unrolled::for_each_index;

/// Several vectors on which each operation is done before the next one is.
///
/// The operations of a sine wait for each other, and a processor looks ahead no further than some two sines. On a Zen 4
/// four angles one after the other take a tenth longer.
#[derive(Clone, Copy)]
struct Abreast<L: Lanes, const W: usize>([L; W]);

/// Sines and cosines, of up to four angles at a time: more do not fit into the registers.
#[inline(always)]
pub(super) fn sin_cos_of_each<L: Lanes, const K: usize>(angles: &[L; K], values: &mut [(L, L); K]) {
    macro_rules! abreast {
        ($($first:literal: $width:literal),*) => {
            { $(sin_cos_of_some::<L, $width, K>(angles, $first, values);)* }
        };
    }
    match K {
        2 => abreast!(0: 2),
        3 => abreast!(0: 3),
        4 => abreast!(0: 4),
        5 => abreast!(0: 3, 3: 2),
        6 => abreast!(0: 3, 3: 3),
        7 => abreast!(0: 4, 4: 3),
        8 => abreast!(0: 4, 4: 4),
        _ => {
            for_each_index!(K, i => values[i] = sine::sin_cos(angles[i]));
        }
    }
}

#[inline(always)]
fn sin_cos_of_some<L: Lanes, const W: usize, const K: usize>(
    angles: &[L; K],
    first: usize,
    values: &mut [(L, L); K],
) {
    let mut some = Abreast([angles[first]; W]);
    for_each_index!(W, i => some.0[i] = angles[first + i]);
    let (sines, cosines) = sine::sin_cos(some);
    for_each_index!(W, i => values[first + i] = (sines.0[i], cosines.0[i]));
}

impl<L: Lanes, const W: usize> Abreast<L, W> {
    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(L, L) -> L) -> Self {
        let mut result = self;
        for_each_index!(W, i => result.0[i] = f(self.0[i], other.0[i]));
        result
    }

    #[inline(always)]
    fn zip3(self, a: Self, b: Self, f: impl Fn(L, L, L) -> L) -> Self {
        let mut result = self;
        for_each_index!(W, i => result.0[i] = f(self.0[i], a.0[i], b.0[i]));
        result
    }
}

impl_operators! {
    impl [L: Lanes, const W: usize] for Abreast<L, W>;
    Add add |a, b| a.zip(b, #[inline(always)] |a, b| a + b);
    Sub sub |a, b| a.zip(b, #[inline(always)] |a, b| a - b);
    Mul mul |a, b| a.zip(b, #[inline(always)] |a, b| a * b);
}

impl<L: Lanes, const W: usize> Lanes for Abreast<L, W> {
    type Number = L::Number;

    const OF_A_BATCH: bool = L::OF_A_BATCH;

    #[inline(always)]
    fn constant(self, x: L::Number) -> Self {
        Abreast([self.0[0].constant(x); W])
    }

    #[inline(always)]
    fn product_from(self, b: Self, a: Self) -> Self {
        self.zip3(b, a, L::product_from)
    }

    #[inline(always)]
    fn fuses(self) -> bool {
        self.0[0].fuses()
    }

    #[inline(always)]
    fn product_plus(self, a: Self, b: Self) -> Self {
        self.zip3(a, b, L::product_plus)
    }

    #[inline(always)]
    fn product_minus(self, a: Self, b: Self) -> Self {
        self.zip3(a, b, L::product_minus)
    }

    #[inline(always)]
    fn select_by_lowest_bit(self, odd: Self, even: Self) -> Self {
        self.zip3(odd, even, L::select_by_lowest_bit)
    }

    #[inline(always)]
    fn turned_by_bit<const BIT: u32>(self, of: Self) -> Self {
        self.zip(of, L::turned_by_bit::<BIT>)
    }

    #[inline(always)]
    fn all_within(self, limit: L::Number) -> bool {
        let mut all = true;
        for_each_index!(W, i => all &= self.0[i].all_within(limit));
        all
    }
}
