//! The operations of a tape on blocks.
//!
//! Operands are of three kinds: a number at each state, one that all states share, or the result of the operation
//! before, which is still in registers.

use fearless_simd::{Simd, SimdBase, SimdFloat, SimdFrom, f64x8};

use super::Block;
use crate::tape::{Operation, Place};

/// A number at each of the states that are computed together, in registers.
type Registers<S, const GROUPS: usize> = [f64x8<S>; GROUPS];

/// The numbers that a kernel reads.
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
    ($($operation:ident $operands:tt = $value:expr => { $($kernel:ident $kinds:tt)* })*) => {
        /// An operation on operands of known kinds.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        enum Kernel {
            $($($kernel,)*)*
        }

        /// The kernel of an operation, and the numbers of its operands in their places.
        fn kernel_of(operation: Operation) -> (Kernel, [u16; 4]) {
            match operation {
                $($(kernels!(@pattern $operation $operands $kinds) => {
                    (Kernel::$kernel, kernels!(@indices $operands))
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
                        kernels!(@compute result $value; self sources $operands $kinds);
                    })*)*
                }
                result
            }
        }
    };
    (@pattern $operation:ident ($($operand:ident),*) ($($kind:ident),*)) => {
        Operation::$operation($($operand @ Place::$kind { .. }),*)
    };
    (@indices ($($operand:ident),*)) => {{
        let mut indices = [0; 4];
        for (index, place) in indices.iter_mut().zip([$($operand),*]) {
            *index = place.index();
        }
        indices
    }};
    (@compute $result:ident $value:expr; $bound:ident $sources:ident
     ($($operand:ident),*) ($($kind:ident),*)) => {
        let [$($operand,)* ..] = $bound.operands;
        $(let $operand = $kind::of($sources, $operand);)*
        for group in 0..GROUPS {
            $(let $operand = $operand.read($sources.simd, group);)*
            $result[group] = $value;
        }
    };
}

kernels! {
    Add(a, b) = a + b => {
        AddLS(Last, Shared) AddLV(Last, Slot) AddSV(Shared, Slot) AddVV(Slot, Slot)
    }
    Sub(a, b) = a - b => {
        SubLS(Last, Shared) SubLV(Last, Slot) SubSL(Shared, Last) SubSV(Shared, Slot)
        SubVL(Slot, Last) SubVS(Slot, Shared) SubVV(Slot, Slot)
    }
    Mul(a, b) = a * b => {
        MulLS(Last, Shared) MulLV(Last, Slot) MulSV(Shared, Slot) MulVV(Slot, Slot)
    }
    Div(a, b) = a / b => {
        DivLS(Last, Shared) DivLV(Last, Slot) DivSL(Shared, Last) DivSV(Shared, Slot)
        DivVL(Slot, Last) DivVS(Slot, Shared) DivVV(Slot, Slot)
    }
    MulAdd(x, y, c) = x.mul_add(y, c) => {
        MulAddLSS(Last, Shared, Shared) MulAddLSV(Last, Shared, Slot) MulAddLVS(Last, Slot, Shared)
        MulAddLVV(Last, Slot, Slot) MulAddSSL(Shared, Shared, Last) MulAddSSV(Shared, Shared, Slot)
        MulAddSVL(Shared, Slot, Last) MulAddSVS(Shared, Slot, Shared) MulAddSVV(Shared, Slot, Slot)
        MulAddVVL(Slot, Slot, Last) MulAddVVS(Slot, Slot, Shared) MulAddVVV(Slot, Slot, Slot)
    }
    MulSub(x, y, c) = x.mul_add(y, -c) => {
        MulSubLSS(Last, Shared, Shared) MulSubLSV(Last, Shared, Slot) MulSubLVS(Last, Slot, Shared)
        MulSubLVV(Last, Slot, Slot) MulSubSSL(Shared, Shared, Last) MulSubSSV(Shared, Shared, Slot)
        MulSubSVL(Shared, Slot, Last) MulSubSVS(Shared, Slot, Shared) MulSubSVV(Shared, Slot, Slot)
        MulSubVVL(Slot, Slot, Last) MulSubVVS(Slot, Slot, Shared) MulSubVVV(Slot, Slot, Slot)
    }
    NegMulAdd(x, y, c) = (-x).mul_add(y, c) => {
        NegMulAddLSS(Last, Shared, Shared) NegMulAddLSV(Last, Shared, Slot)
        NegMulAddLVS(Last, Slot, Shared) NegMulAddLVV(Last, Slot, Slot)
        NegMulAddSSL(Shared, Shared, Last) NegMulAddSSV(Shared, Shared, Slot)
        NegMulAddSVL(Shared, Slot, Last) NegMulAddSVS(Shared, Slot, Shared)
        NegMulAddSVV(Shared, Slot, Slot) NegMulAddVVL(Slot, Slot, Last)
        NegMulAddVVS(Slot, Slot, Shared) NegMulAddVVV(Slot, Slot, Slot)
    }
    Sum(x, y, a, b) = x.mul_add(y, a * b) => {
        SumLSSV(Last, Shared, Shared, Slot) SumLSVV(Last, Shared, Slot, Slot)
        SumLVSV(Last, Slot, Shared, Slot) SumLVVV(Last, Slot, Slot, Slot)
        SumSSLS(Shared, Shared, Last, Shared) SumSSLV(Shared, Shared, Last, Slot)
        SumSSSV(Shared, Shared, Shared, Slot) SumSSVV(Shared, Shared, Slot, Slot)
        SumSVLS(Shared, Slot, Last, Shared) SumSVLV(Shared, Slot, Last, Slot)
        SumSVSV(Shared, Slot, Shared, Slot) SumSVVV(Shared, Slot, Slot, Slot)
        SumVVLS(Slot, Slot, Last, Shared) SumVVLV(Slot, Slot, Last, Slot)
        SumVVSV(Slot, Slot, Shared, Slot) SumVVVV(Slot, Slot, Slot, Slot)
    }
    Difference(x, y, a, b) = (-x).mul_add(y, a * b) => {
        DifferenceLSSV(Last, Shared, Shared, Slot) DifferenceLSVV(Last, Shared, Slot, Slot)
        DifferenceLVSV(Last, Slot, Shared, Slot) DifferenceLVVV(Last, Slot, Slot, Slot)
        DifferenceSSLS(Shared, Shared, Last, Shared) DifferenceSSLV(Shared, Shared, Last, Slot)
        DifferenceSSSV(Shared, Shared, Shared, Slot) DifferenceSSVV(Shared, Shared, Slot, Slot)
        DifferenceSVLS(Shared, Slot, Last, Shared) DifferenceSVLV(Shared, Slot, Last, Slot)
        DifferenceSVSV(Shared, Slot, Shared, Slot) DifferenceSVVV(Shared, Slot, Slot, Slot)
        DifferenceVVLS(Slot, Slot, Last, Shared) DifferenceVVLV(Slot, Slot, Last, Slot)
        DifferenceVVSV(Slot, Slot, Shared, Slot) DifferenceVVVV(Slot, Slot, Slot, Slot)
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
