//! The loop over the blocks of a batch.

use dynamics_runtime::{SingularMassMatrix, sin_cos_column};
use dynamics_symbolic::robot::Symbol;
use fearless_simd::{Level, Simd, SimdBase, SimdFrom, SimdMask, dispatch, f64x8};

use super::{Block, GROUPS, Kernels, LANES, STATES};
use crate::layout::{Layout, Test};
use crate::read::{Reader, scatter};
use crate::tape::{Output, Place, Step, Tape};

/// A function at many states.
pub(crate) struct Batch<'a> {
    /// Its tape.
    pub(crate) tape: &'a Tape,
    /// The kernels of the tape's steps; `None` of those that read.
    pub(crate) kernels: &'a [Option<Kernels>],
    /// The numbers that all states share.
    pub(crate) shared: &'a [f64],
    /// What its outputs are.
    pub(crate) layout: &'a Layout,
    /// The number of states.
    pub(crate) states: usize,
}

/// A state at which M is singular, and why.
pub(crate) type Failure = Option<(usize, SingularMassMatrix)>;

/// The values at all states, one state after the other, with the instructions of a level; the first
/// state that is refused. The values of states that are refused are NaN.
pub(crate) fn run(
    level: Level,
    batch: &Batch<'_>,
    read: &Reader<'_>,
    slots: &mut [Block],
    results: &mut [f64],
) -> Failure {
    let mut failure = None;
    for first in (0..batch.states).step_by(STATES) {
        let count = (batch.states - first).min(STATES);
        let entries = batch.layout.entries();
        let results = &mut results[first * entries..(first + count) * entries];
        let all_regular = dispatch!(level, simd => {
            steps(simd, level, batch, read, slots, (first, count));
            write(batch, slots, results);
            are_regular(simd, batch, slots, count)
        });
        if !all_regular {
            let found = refused(batch, slots, count, results);
            failure = failure.or(found.map(|(state, error)| (first + state, error)));
        }
    }
    failure
}

/// All steps on the states of a block.
#[inline(always)]
fn steps<S: Simd>(
    simd: S,
    level: Level,
    batch: &Batch<'_>,
    read: &Reader<'_>,
    slots: &mut [Block],
    (first, count): (usize, usize),
) {
    let groups = count.div_ceil(LANES).min(GROUPS);
    for (step, kernel) in batch.tape.steps.iter().zip(batch.kernels) {
        match (kernel, *step) {
            (Some(kernel), _) => kernel.carry_out(simd, batch.shared, slots, groups),
            (None, Step::Read { input, to }) => {
                let symbol = &batch.tape.inputs[usize::from(input)];
                fill(&mut slots[usize::from(to)], symbol, read, (first, count));
            }
            (
                None,
                Step::SinCos {
                    joint,
                    sine,
                    cosine,
                },
            ) => {
                let mut angles = Block::ZERO;
                let position = Symbol::Position(usize::from(joint));
                fill(&mut angles, &position, read, (first, count));
                let places = [sine, cosine].map(usize::from);
                if let Ok([sines, cosines]) = slots.get_disjoint_mut(places) {
                    let angles = &angles.0[..groups];
                    sin_cos_column(level, angles, &mut sines.0, &mut cosines.0);
                }
            }
            (None, Step::Compute { .. }) => {}
        }
    }
}

/// An input at the states of a block. Lanes without a state are at the last one: zeros may be singular.
fn fill(block: &mut Block, symbol: &Symbol, read: &Reader<'_>, (first, count): (usize, usize)) {
    let lanes = block.0.as_flattened_mut();
    read.column(symbol, first, &mut lanes[..count]);
    let (last, end) = (lanes[count - 1], count.next_multiple_of(LANES));
    lanes[count..end].fill(last);
}

/// The values of the block's states, one state after the other.
#[inline(always)]
fn write(batch: &Batch<'_>, slots: &[Block], results: &mut [f64]) {
    let entries = batch.layout.entries();
    for &(output, place) in &batch.layout.values {
        let output = &batch.tape.outputs[output];
        match (output.place, output.negative) {
            (Place::Shared(index), _) => {
                let value = signed(batch.shared[usize::from(index)], output);
                scatter(core::iter::repeat(value), results, entries, place);
            }
            (Place::Slot(slot), negative) => {
                let lanes = slots[usize::from(slot)].0.as_flattened().iter();
                match negative {
                    true => scatter(lanes.map(|lane| -lane), results, entries, place),
                    false => scatter(lanes.copied(), results, entries, place),
                }
            }
        }
    }
}

fn signed(value: f64, output: &Output) -> f64 {
    match output.negative {
        true => -value,
        false => value,
    }
}

/// Whether all tests of pivots pass at all states of a block.
#[inline(always)]
fn are_regular<S: Simd>(simd: S, batch: &Batch<'_>, slots: &[Block], count: usize) -> bool {
    let groups = count.div_ceil(LANES).min(GROUPS);
    let mut all = true;
    for test in &batch.layout.tests {
        let [pivot, diagonal] =
            [test.pivot, test.diagonal].map(|output| &batch.tape.outputs[output]);
        for group in 0..groups {
            let lanes = |output: &Output| {
                let lanes = match output.place {
                    Place::Shared(index) => f64x8::splat(simd, batch.shared[usize::from(index)]),
                    Place::Slot(slot) => f64x8::simd_from(simd, slots[usize::from(slot)].0[group]),
                };
                if output.negative { -lanes } else { lanes }
            };
            let (pivot, diagonal) = (lanes(pivot), lanes(diagonal));
            // `Scalar::exceeds_rounding_of`
            let rounding = diagonal * f64x8::splat(simd, 8.0 * f64::EPSILON);
            let zero = f64x8::splat(simd, 0.0);
            all &= (pivot - rounding).simd_gt(zero).all_true();
            all &= (pivot + rounding).simd_gt(zero).all_true();
        }
    }
    all
}

/// The first state of a block at which a pivot fails. The values of all such states become NaN.
#[cold]
fn refused(batch: &Batch<'_>, slots: &[Block], count: usize, results: &mut [f64]) -> Failure {
    let mut first = None;
    for state in 0..count {
        let of = |output: usize| {
            let output = &batch.tape.outputs[output];
            match output.place {
                Place::Shared(index) => signed(batch.shared[usize::from(index)], output),
                Place::Slot(slot) => {
                    signed(slots[usize::from(slot)].0.as_flattened()[state], output)
                }
            }
        };
        let error = |test: &Test| test.result(of).err();
        if let Some(error) = batch.layout.tests.iter().find_map(error) {
            first = first.or(Some((state, error)));
            let entries = batch.layout.entries();
            results[state * entries..(state + 1) * entries].fill(f64::NAN);
        }
    }
    first
}
