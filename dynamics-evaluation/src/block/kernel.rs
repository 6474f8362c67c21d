//! The operations of a tape on blocks.
//!
//! Each is a kernel for what its operands are: a number at each state, one that all states share, or the
//! result of the operation before, which is still in registers.

use fearless_simd::{Simd, SimdBase, SimdFloat, SimdFrom, f64x8};

use super::Block;
use crate::tape::{Operation, Place};

/// A number at each of the states that are computed together, in registers.
type Registers<S, const GROUPS: usize> = [f64x8<S>; GROUPS];

/// What a kernel reads.
struct Sources<'a, S: Simd, const GROUPS: usize> {
    simd: S,
    shared: &'a [f64],
    slots: &'a [Block],
    last: Registers<S, GROUPS>,
}

/// The result of the operation before.
struct Last<S: Simd, const GROUPS: usize>(Registers<S, GROUPS>);

impl<S: Simd, const GROUPS: usize> Last<S, GROUPS> {
    #[inline(always)]
    fn of(sources: &Sources<'_, S, GROUPS>, _: u16) -> Self {
        Last(sources.last)
    }

    #[inline(always)]
    fn read(&self, _: S, group: usize) -> f64x8<S> {
        self.0[group]
    }
}

/// A number that all states share.
struct Shared<S: Simd>(f64x8<S>);

impl<S: Simd> Shared<S> {
    #[inline(always)]
    fn of<const GROUPS: usize>(sources: &Sources<'_, S, GROUPS>, index: u16) -> Self {
        Shared(f64x8::splat(
            sources.simd,
            sources.shared[usize::from(index)],
        ))
    }

    #[inline(always)]
    fn read(&self, _: S, _: usize) -> f64x8<S> {
        self.0
    }
}

/// A number at each state.
struct Slot<'a>(&'a Block);

impl<'a> Slot<'a> {
    #[inline(always)]
    fn of<S: Simd, const GROUPS: usize>(sources: &Sources<'a, S, GROUPS>, index: u16) -> Self {
        Slot(&sources.slots[usize::from(index)])
    }

    #[inline(always)]
    fn read<S: Simd>(&self, simd: S, group: usize) -> f64x8<S> {
        f64x8::simd_from(simd, self.0.0[group])
    }
}

/// An operation of a tape with its kernel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bound {
    kernel: Kernel,
    operands: [u16; 4],
    /// The slot of the result; none where the next operation alone reads it.
    to: Option<u16>,
}

impl Bound {
    /// The operation of a step.
    pub(crate) fn new(operation: Operation, to: Option<u16>) -> Self {
        let (kernel, operands) = kernel_of(operation);
        Bound {
            kernel,
            operands,
            to,
        }
    }
}

/// Carries out operations, one after the other, on the first groups of lanes of all slots.
///
/// The result of each is handed to the next one in registers.
#[inline(always)]
pub(super) fn carry_out<S: Simd, const GROUPS: usize>(
    simd: S,
    operations: &[Bound],
    shared: &[f64],
    slots: &mut [Block],
) {
    let mut last = [f64x8::splat(simd, 0.0); GROUPS];
    for operation in operations {
        let sources = Sources {
            simd,
            shared,
            slots,
            last,
        };
        last = operation.value(&sources);
        if let Some(to) = operation.to {
            let to = &mut slots[usize::from(to)];
            for group in 0..GROUPS {
                to.0[group] = last[group].into();
            }
        }
    }
}

macro_rules! kernels {
    ($($operation:ident = $value:expr => {
        $($kernel:ident($($operand:ident: $kind:ident),*))*
    })*) => {
        /// An operation on operands of known kinds.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        enum Kernel {
            $($($kernel,)*)*
        }

        /// The kernel of an operation, and the numbers of its operands in their places.
        fn kernel_of(operation: Operation) -> (Kernel, [u16; 4]) {
            match operation {
                $($(Operation::$operation($($operand @ Place::$kind { .. }),*) => {
                    let mut operands = [0; 4];
                    let places = [$($operand),*];
                    for (operand, place) in operands.iter_mut().zip(places) {
                        *operand = place.index();
                    }
                    (Kernel::$kernel, operands)
                })*)*
                _ => unreachable!("no tape has {operation:?}"),
            }
        }

        impl Bound {
            #[inline(always)]
            fn value<S: Simd, const GROUPS: usize>(
                &self,
                sources: &Sources<'_, S, GROUPS>,
            ) -> Registers<S, GROUPS> {
                let mut result = sources.last;
                match self.kernel {
                    $($(Kernel::$kernel => {
                        let [$($operand,)* ..] = self.operands;
                        $(let $operand = $kind::of(sources, $operand);)*
                        for group in 0..GROUPS {
                            $(let $operand = $operand.read(sources.simd, group);)*
                            result[group] = $value;
                        }
                    })*)*
                }
                result
            }
        }
    };
}

kernels! {
    Add = a + b => {
        AddLS(a: Last, b: Shared)
        AddLV(a: Last, b: Slot)
        AddSV(a: Shared, b: Slot)
        AddVV(a: Slot, b: Slot)
    }
    Sub = a - b => {
        SubLS(a: Last, b: Shared)
        SubLV(a: Last, b: Slot)
        SubSL(a: Shared, b: Last)
        SubSV(a: Shared, b: Slot)
        SubVL(a: Slot, b: Last)
        SubVS(a: Slot, b: Shared)
        SubVV(a: Slot, b: Slot)
    }
    Mul = a * b => {
        MulLS(a: Last, b: Shared)
        MulLV(a: Last, b: Slot)
        MulSV(a: Shared, b: Slot)
        MulVV(a: Slot, b: Slot)
    }
    Div = a / b => {
        DivLS(a: Last, b: Shared)
        DivLV(a: Last, b: Slot)
        DivSL(a: Shared, b: Last)
        DivSV(a: Shared, b: Slot)
        DivVL(a: Slot, b: Last)
        DivVS(a: Slot, b: Shared)
        DivVV(a: Slot, b: Slot)
    }
    MulAdd = x.mul_add(y, c) => {
        MulAddLSS(x: Last, y: Shared, c: Shared)
        MulAddLSV(x: Last, y: Shared, c: Slot)
        MulAddLVS(x: Last, y: Slot, c: Shared)
        MulAddLVV(x: Last, y: Slot, c: Slot)
        MulAddSSL(x: Shared, y: Shared, c: Last)
        MulAddSSV(x: Shared, y: Shared, c: Slot)
        MulAddSVL(x: Shared, y: Slot, c: Last)
        MulAddSVS(x: Shared, y: Slot, c: Shared)
        MulAddSVV(x: Shared, y: Slot, c: Slot)
        MulAddVVL(x: Slot, y: Slot, c: Last)
        MulAddVVS(x: Slot, y: Slot, c: Shared)
        MulAddVVV(x: Slot, y: Slot, c: Slot)
    }
    MulSub = x.mul_add(y, -c) => {
        MulSubLSS(x: Last, y: Shared, c: Shared)
        MulSubLSV(x: Last, y: Shared, c: Slot)
        MulSubLVS(x: Last, y: Slot, c: Shared)
        MulSubLVV(x: Last, y: Slot, c: Slot)
        MulSubSSL(x: Shared, y: Shared, c: Last)
        MulSubSSV(x: Shared, y: Shared, c: Slot)
        MulSubSVL(x: Shared, y: Slot, c: Last)
        MulSubSVS(x: Shared, y: Slot, c: Shared)
        MulSubSVV(x: Shared, y: Slot, c: Slot)
        MulSubVVL(x: Slot, y: Slot, c: Last)
        MulSubVVS(x: Slot, y: Slot, c: Shared)
        MulSubVVV(x: Slot, y: Slot, c: Slot)
    }
    NegMulAdd = (-x).mul_add(y, c) => {
        NegMulAddLSS(x: Last, y: Shared, c: Shared)
        NegMulAddLSV(x: Last, y: Shared, c: Slot)
        NegMulAddLVS(x: Last, y: Slot, c: Shared)
        NegMulAddLVV(x: Last, y: Slot, c: Slot)
        NegMulAddSSL(x: Shared, y: Shared, c: Last)
        NegMulAddSSV(x: Shared, y: Shared, c: Slot)
        NegMulAddSVL(x: Shared, y: Slot, c: Last)
        NegMulAddSVS(x: Shared, y: Slot, c: Shared)
        NegMulAddSVV(x: Shared, y: Slot, c: Slot)
        NegMulAddVVL(x: Slot, y: Slot, c: Last)
        NegMulAddVVS(x: Slot, y: Slot, c: Shared)
        NegMulAddVVV(x: Slot, y: Slot, c: Slot)
    }
    Sum = x.mul_add(y, a * b) => {
        SumLSSV(x: Last, y: Shared, a: Shared, b: Slot)
        SumLSVV(x: Last, y: Shared, a: Slot, b: Slot)
        SumLVSV(x: Last, y: Slot, a: Shared, b: Slot)
        SumLVVV(x: Last, y: Slot, a: Slot, b: Slot)
        SumSSLS(x: Shared, y: Shared, a: Last, b: Shared)
        SumSSLV(x: Shared, y: Shared, a: Last, b: Slot)
        SumSSSV(x: Shared, y: Shared, a: Shared, b: Slot)
        SumSSVV(x: Shared, y: Shared, a: Slot, b: Slot)
        SumSVLS(x: Shared, y: Slot, a: Last, b: Shared)
        SumSVLV(x: Shared, y: Slot, a: Last, b: Slot)
        SumSVSV(x: Shared, y: Slot, a: Shared, b: Slot)
        SumSVVV(x: Shared, y: Slot, a: Slot, b: Slot)
        SumVVLS(x: Slot, y: Slot, a: Last, b: Shared)
        SumVVLV(x: Slot, y: Slot, a: Last, b: Slot)
        SumVVSV(x: Slot, y: Slot, a: Shared, b: Slot)
        SumVVVV(x: Slot, y: Slot, a: Slot, b: Slot)
    }
    Difference = (-x).mul_add(y, a * b) => {
        DifferenceLSSV(x: Last, y: Shared, a: Shared, b: Slot)
        DifferenceLSVV(x: Last, y: Shared, a: Slot, b: Slot)
        DifferenceLVSV(x: Last, y: Slot, a: Shared, b: Slot)
        DifferenceLVVV(x: Last, y: Slot, a: Slot, b: Slot)
        DifferenceSSLS(x: Shared, y: Shared, a: Last, b: Shared)
        DifferenceSSLV(x: Shared, y: Shared, a: Last, b: Slot)
        DifferenceSSSV(x: Shared, y: Shared, a: Shared, b: Slot)
        DifferenceSSVV(x: Shared, y: Shared, a: Slot, b: Slot)
        DifferenceSVLS(x: Shared, y: Slot, a: Last, b: Shared)
        DifferenceSVLV(x: Shared, y: Slot, a: Last, b: Slot)
        DifferenceSVSV(x: Shared, y: Slot, a: Shared, b: Slot)
        DifferenceSVVV(x: Shared, y: Slot, a: Slot, b: Slot)
        DifferenceVVLS(x: Slot, y: Slot, a: Last, b: Shared)
        DifferenceVVLV(x: Slot, y: Slot, a: Last, b: Slot)
        DifferenceVVSV(x: Slot, y: Slot, a: Shared, b: Slot)
        DifferenceVVVV(x: Slot, y: Slot, a: Slot, b: Slot)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const KINDS: [Place; 3] = [Place::Last, Place::Shared(1), Place::Slot(2)];

    /// All places of so many operands that a tape may have: one is the last result at most, and one
    /// is not shared.
    fn places(count: u32) -> impl Iterator<Item = [Place; 4]> {
        let chosen = (0..3_usize.pow(count)).map(|i| [i % 3, i / 3 % 3, i / 9 % 3, i / 27 % 3]);
        let places = chosen.map(|chosen| chosen.map(|kind| KINDS[kind]));
        places.filter(move |places| {
            let places = &places[..count as usize];
            let of_kind = |kind: Place| places.iter().filter(|place| **place == kind).count();
            of_kind(KINDS[0]) <= 1 && of_kind(KINDS[1]) < places.len()
        })
    }

    /// Operations that no kernel knows would panic when a tape is made.
    #[test]
    fn every_operation_has_a_kernel() {
        let sorted = |a: Place, b: Place| a <= b;
        for [a, b, ..] in places(2) {
            kernel_of(Operation::Sub(a, b));
            kernel_of(Operation::Div(a, b));
            if sorted(a, b) {
                kernel_of(Operation::Add(a, b));
                kernel_of(Operation::Mul(a, b));
            }
        }
        for [x, y, c, _] in places(3).filter(|places| sorted(places[0], places[1])) {
            kernel_of(Operation::MulAdd(x, y, c));
            kernel_of(Operation::MulSub(x, y, c));
            kernel_of(Operation::NegMulAdd(x, y, c));
        }
        let is_sorted = |places: &[Place; 4]| {
            sorted(places[0], places[1])
                && sorted(places[2], places[3])
                && places[2..] != [KINDS[1]; 2]
        };
        for [x, y, a, b] in places(4).filter(is_sorted) {
            kernel_of(Operation::Sum(x, y, a, b));
            kernel_of(Operation::Difference(x, y, a, b));
        }
    }

    #[test]
    fn operands_keep_their_order() {
        let operation = Operation::Sum(
            Place::Last,
            Place::Shared(3),
            Place::Slot(7),
            Place::Slot(5),
        );
        assert_eq!(kernel_of(operation), (Kernel::SumLSVV, [0, 3, 7, 5]));
    }
}
