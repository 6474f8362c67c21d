//! The operations of a tape on blocks.
//!
//! Each is a kernel for what its operands are: a number at each state, or one that all states share.

use fearless_simd::{Simd, SimdBase, SimdFloat, SimdFrom, f64x8};

use super::{Block, GROUPS};
use crate::tape::{Operation, Place, Step};

/// A number at each state.
#[derive(Clone, Copy)]
struct Slot<S> {
    simd: S,
    index: usize,
}

impl<S: Simd> Slot<S> {
    #[inline(always)]
    fn new(simd: S, index: u16, _: &[f64]) -> Self {
        let index = usize::from(index);
        Slot { simd, index }
    }

    #[inline(always)]
    fn read(self, slots: &[Block], group: usize) -> f64x8<S> {
        f64x8::simd_from(self.simd, slots[self.index].0[group])
    }
}

/// A number that all states share.
#[derive(Clone, Copy)]
struct Shared<S: Simd>(f64x8<S>);

impl<S: Simd> Shared<S> {
    #[inline(always)]
    fn new(simd: S, index: u16, shared: &[f64]) -> Self {
        Shared(f64x8::splat(simd, shared[usize::from(index)]))
    }

    #[inline(always)]
    fn read(self, _: &[Block], _: usize) -> f64x8<S> {
        self.0
    }
}

macro_rules! kernels {
    ($($(#[$meaning:meta])* $kernel:ident($($operand:ident: $kind:ident),*) = $value:expr;)*) => {
        /// An operation on operands of known kinds.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        enum Kernel {
            $($(#[$meaning])* $kernel,)*
        }

        impl Kernels {
            /// Carries out a step on the first groups of a block.
            #[inline(always)]
            pub(super) fn carry_out<S: Simd>(
                &self,
                simd: S,
                shared: &[f64],
                slots: &mut [Block],
                groups: usize,
            ) {
                let (groups, to) = (groups.min(GROUPS), usize::from(self.to));
                match self.kernel {
                    $(Kernel::$kernel => {
                        let [$($operand,)* ..] = self.operands;
                        $(let $operand = $kind::new(simd, $operand, shared);)*
                        for group in 0..groups {
                            $(let $operand = $operand.read(slots, group);)*
                            slots[to].0[group] = ($value).into();
                        }
                    })*
                }
            }
        }
    };
}

/// An operation of a tape with its kernel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Kernels {
    kernel: Kernel,
    to: u16,
    operands: [u16; 4],
}

kernels! {
    AddVV(a: Slot, b: Slot) = a + b;
    AddVS(a: Slot, b: Shared) = a + b;
    SubVV(a: Slot, b: Slot) = a - b;
    SubVS(a: Slot, b: Shared) = a - b;
    SubSV(a: Shared, b: Slot) = a - b;
    MulVV(a: Slot, b: Slot) = a * b;
    MulVS(a: Slot, b: Shared) = a * b;
    DivVV(a: Slot, b: Slot) = a / b;
    DivVS(a: Slot, b: Shared) = a / b;
    DivSV(a: Shared, b: Slot) = a / b;
    MulAddVVV(x: Slot, y: Slot, c: Slot) = x.mul_add(y, c);
    MulAddVVS(x: Slot, y: Slot, c: Shared) = x.mul_add(y, c);
    MulAddSVV(x: Shared, y: Slot, c: Slot) = x.mul_add(y, c);
    MulAddSVS(x: Shared, y: Slot, c: Shared) = x.mul_add(y, c);
    MulSubVVV(x: Slot, y: Slot, c: Slot) = x.mul_add(y, -c);
    MulSubVVS(x: Slot, y: Slot, c: Shared) = x.mul_add(y, -c);
    MulSubSVV(x: Shared, y: Slot, c: Slot) = x.mul_add(y, -c);
    MulSubSVS(x: Shared, y: Slot, c: Shared) = x.mul_add(y, -c);
    NegMulAddVVV(x: Slot, y: Slot, c: Slot) = (-x).mul_add(y, c);
    NegMulAddVVS(x: Slot, y: Slot, c: Shared) = (-x).mul_add(y, c);
    NegMulAddSVV(x: Shared, y: Slot, c: Slot) = (-x).mul_add(y, c);
    NegMulAddSVS(x: Shared, y: Slot, c: Shared) = (-x).mul_add(y, c);
    SumVVVV(x: Slot, y: Slot, a: Slot, b: Slot) = x.mul_add(y, a * b);
    SumSVVV(x: Shared, y: Slot, a: Slot, b: Slot) = x.mul_add(y, a * b);
    SumVVSV(x: Slot, y: Slot, a: Shared, b: Slot) = x.mul_add(y, a * b);
    SumSVSV(x: Shared, y: Slot, a: Shared, b: Slot) = x.mul_add(y, a * b);
    DifferenceVVVV(x: Slot, y: Slot, a: Slot, b: Slot) = (-x).mul_add(y, a * b);
    DifferenceSVVV(x: Shared, y: Slot, a: Slot, b: Slot) = (-x).mul_add(y, a * b);
    DifferenceVVSV(x: Slot, y: Slot, a: Shared, b: Slot) = (-x).mul_add(y, a * b);
    DifferenceSVSV(x: Shared, y: Slot, a: Shared, b: Slot) = (-x).mul_add(y, a * b);
    CopyS(a: Shared) = a;
    CopyV(a: Slot) = a;
}

impl Kernels {
    /// The kernel of a step that computes.
    pub(crate) fn of(step: &Step) -> Option<Self> {
        let Step::Compute { operation, to } = *step else {
            return None;
        };
        let (kernel, operands) = kernel_of(operation);
        Some(Kernels {
            kernel,
            to,
            operands,
        })
    }
}

/// The two factors of a product: a shared one first.
fn factors([x, y]: [Place; 2]) -> (bool, [u16; 2]) {
    match (x, y) {
        (Place::Slot(x), Place::Slot(y)) => (false, [x, y]),
        (Place::Shared(x), Place::Slot(y)) | (Place::Slot(y), Place::Shared(x)) => (true, [x, y]),
        (Place::Shared(_), Place::Shared(_)) => {
            unreachable!("a tape has one factor of a product in a slot")
        }
    }
}

fn kernel_of(operation: Operation) -> (Kernel, [u16; 4]) {
    use Place::{Shared, Slot};
    let two = |kernel, a, b| (kernel, [a, b, 0, 0]);
    match operation {
        Operation::Add(Slot(a), Slot(b)) => two(Kernel::AddVV, a, b),
        Operation::Add(Slot(a), Shared(b)) | Operation::Add(Shared(b), Slot(a)) => {
            two(Kernel::AddVS, a, b)
        }
        Operation::Sub(Slot(a), Slot(b)) => two(Kernel::SubVV, a, b),
        Operation::Sub(Slot(a), Shared(b)) => two(Kernel::SubVS, a, b),
        Operation::Sub(Shared(a), Slot(b)) => two(Kernel::SubSV, a, b),
        Operation::Mul(Slot(a), Slot(b)) => two(Kernel::MulVV, a, b),
        Operation::Mul(Slot(a), Shared(b)) | Operation::Mul(Shared(b), Slot(a)) => {
            two(Kernel::MulVS, a, b)
        }
        Operation::Div(Slot(a), Slot(b)) => two(Kernel::DivVV, a, b),
        Operation::Div(Slot(a), Shared(b)) => two(Kernel::DivVS, a, b),
        Operation::Div(Shared(a), Slot(b)) => two(Kernel::DivSV, a, b),
        Operation::Add(Shared(_), Shared(_))
        | Operation::Sub(Shared(_), Shared(_))
        | Operation::Mul(Shared(_), Shared(_))
        | Operation::Div(Shared(_), Shared(_)) => {
            unreachable!("what all states share is computed once")
        }
        Operation::MulAdd(product, c) => {
            use Kernel::{MulAddSVS, MulAddSVV, MulAddVVS, MulAddVVV};
            fused(product, c, [MulAddVVV, MulAddVVS, MulAddSVV, MulAddSVS])
        }
        Operation::MulSub(product, c) => {
            use Kernel::{MulSubSVS, MulSubSVV, MulSubVVS, MulSubVVV};
            fused(product, c, [MulSubVVV, MulSubVVS, MulSubSVV, MulSubSVS])
        }
        Operation::NegMulAdd(product, c) => {
            use Kernel::{NegMulAddSVS, NegMulAddSVV, NegMulAddVVS, NegMulAddVVV};
            let kernels = [NegMulAddVVV, NegMulAddVVS, NegMulAddSVV, NegMulAddSVS];
            fused(product, c, kernels)
        }
        Operation::Sum(product, other) => {
            use Kernel::{SumSVSV, SumSVVV, SumVVSV, SumVVVV};
            products(product, other, [SumVVVV, SumVVSV, SumSVVV, SumSVSV])
        }
        Operation::Difference(product, other) => {
            use Kernel::{DifferenceSVSV, DifferenceSVVV, DifferenceVVSV, DifferenceVVVV};
            let kernels = [
                DifferenceVVVV,
                DifferenceVVSV,
                DifferenceSVVV,
                DifferenceSVSV,
            ];
            products(product, other, kernels)
        }
        Operation::Copy(Shared(a)) => two(Kernel::CopyS, a, 0),
        Operation::Copy(Slot(a)) => two(Kernel::CopyV, a, 0),
    }
}

/// A product and a number: kernels for `VVV`, `VVS`, `SVV` and `SVS`.
fn fused(product: [Place; 2], c: Place, kernels: [Kernel; 4]) -> (Kernel, [u16; 4]) {
    let (has_shared_factor, [x, y]) = factors(product);
    let (is_shared, c) = match c {
        Place::Slot(c) => (false, c),
        Place::Shared(c) => (true, c),
    };
    let kernel = kernels[2 * usize::from(has_shared_factor) + usize::from(is_shared)];
    (kernel, [x, y, c, 0])
}

/// Two products: kernels for `VVVV`, `VVSV`, `SVVV` and `SVSV`.
fn products(product: [Place; 2], other: [Place; 2], kernels: [Kernel; 4]) -> (Kernel, [u16; 4]) {
    let ((first, [x, y]), (second, [a, b])) = (factors(product), factors(other));
    (
        kernels[2 * usize::from(first) + usize::from(second)],
        [x, y, a, b],
    )
}
