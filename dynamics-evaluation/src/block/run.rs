//! The loop over the blocks of a batch.

use dynamics_runtime::{SingularMassMatrix, sin_cos_column};
use dynamics_symbolic::robot::Symbol;
use fearless_simd::{Level, Simd, SimdBase, SimdFrom, SimdMask, dispatch, f64x8};

use super::kernel::{Bound, carry_out};
use super::{Block, GROUPS, LANES, STATES};
use crate::layout::{Layout, Test};
use crate::read::{Column, Reader, scatter};
use crate::tape::{Output, Place, Step, Tape};

/// A part of the work at the states of a block.
#[derive(Clone, Debug)]
pub(crate) enum Stage {
    /// Reads a symbol into a slot.
    Read(Symbol, u16),
    /// Sine and cosine of a position, into two slots.
    SinCos(Symbol, [u16; 2]),
    /// Operations.
    Compute(Vec<Bound>),
}

/// The stages of a tape.
pub(crate) fn stages(tape: &Tape) -> Vec<Stage> {
    let mut stages = Vec::new();
    for step in &tape.steps {
        match *step {
            Step::Read { input, to } => {
                let symbol = tape.inputs[usize::from(input)].clone();
                stages.push(Stage::Read(symbol, to));
            }
            Step::SinCos {
                joint,
                sine,
                cosine,
            } => {
                let position = Symbol::Position(usize::from(joint));
                stages.push(Stage::SinCos(position, [sine, cosine]));
            }
            Step::Compute { operation, to } => {
                let bound = Bound::new(operation, to);
                match stages.last_mut() {
                    Some(Stage::Compute(operations)) => operations.push(bound),
                    _ => stages.push(Stage::Compute(vec![bound])),
                }
            }
        }
    }
    stages
}

/// A function at many states.
pub(crate) struct Batch<'a> {
    pub(crate) tape: &'a Tape,
    pub(crate) stages: &'a [Stage],
    /// The numbers that all states share.
    pub(crate) shared: &'a [f64],
    pub(crate) layout: &'a Layout,
    /// The outputs that are values, each with its place among those of a state.
    pub(crate) values: &'a [(usize, usize)],
    pub(crate) states: usize,
}

/// A state at which M is singular, and why.
pub(crate) type Failure = Option<(usize, SingularMassMatrix)>;

const KEPT: &str = "outputs are kept";

/// The values at all states, one state after the other, with the instructions of a level; the first
/// state that is refused. The values of states that are refused are NaN.
pub(crate) fn run(
    level: Level,
    batch: &Batch<'_>,
    read: &Reader<'_>,
    slots: &mut [Block],
    results: &mut [f64],
) -> Failure {
    let columns = batch.stages.iter().map(|stage| match stage {
        Stage::Read(symbol, _) | Stage::SinCos(symbol, _) => read.column(symbol),
        Stage::Compute(_) => None,
    });
    let columns: Vec<Option<Column<'_>>> = columns.collect();
    let mut failure = None;
    let mut first = 0;
    while first < batch.states {
        let rest = batch.states - first;
        // A rest of more than two groups is computed as a whole block.
        let is_whole = rest > 2 * LANES;
        let count = rest.min(if is_whole { STATES } else { LANES });
        let entries = batch.layout.entries();
        let results = &mut results[first * entries..(first + count) * entries];
        let all_regular = dispatch!(level, simd => {
            if is_whole {
                steps::<_, GROUPS>(simd, level, batch, &columns, slots, (first, count));
            } else {
                steps::<_, 1>(simd, level, batch, &columns, slots, (first, count));
            }
            write(batch, slots, results);
            are_regular(simd, batch, slots, count)
        });
        if !all_regular {
            let found = refused(batch, slots, count, results);
            failure = failure.or(found.map(|(state, error)| (first + state, error)));
        }
        first += count;
    }
    failure
}

/// All stages on the states of so many groups.
#[inline(always)]
fn steps<S: Simd, const GROUPS: usize>(
    simd: S,
    level: Level,
    batch: &Batch<'_>,
    columns: &[Option<Column<'_>>],
    slots: &mut [Block],
    states: (usize, usize),
) {
    for (stage, column) in batch.stages.iter().zip(columns) {
        match stage {
            Stage::Read(_, to) => {
                let lanes = &mut slots[usize::from(*to)].0[..GROUPS];
                fill(lanes, column, states);
            }
            Stage::SinCos(_, places) => {
                let mut angles = [[0.0; LANES]; GROUPS];
                fill(&mut angles, column, states);
                let places = places.map(usize::from);
                if let Ok([sines, cosines]) = slots.get_disjoint_mut(places) {
                    sin_cos_column(level, &angles, &mut sines.0, &mut cosines.0);
                }
            }
            Stage::Compute(operations) => {
                carry_out::<_, GROUPS>(simd, operations, batch.shared, slots);
            }
        }
    }
}

/// A column at the states of a block. Lanes without a state are at the last one: zeros may be singular.
fn fill(groups: &mut [[f64; LANES]], column: &Option<Column<'_>>, (first, count): (usize, usize)) {
    let lanes = groups.as_flattened_mut();
    if let Some(column) = column {
        column.read(first, &mut lanes[..count]);
    }
    let last = lanes[count - 1];
    lanes[count..].fill(last);
}

/// The values of the block's states, one state after the other.
#[inline(always)]
fn write(batch: &Batch<'_>, slots: &[Block], results: &mut [f64]) {
    let entries = batch.layout.entries();
    for &(output, place) in batch.values {
        let output = &batch.tape.outputs[output];
        match (output.place, output.negative) {
            (Place::Shared(index), _) => {
                let value = signed(batch.shared[usize::from(index)], output);
                scatter(core::iter::repeat(value), results, entries, place);
            }
            (Place::Slot(slot), negative) => {
                let lanes = slots[usize::from(slot)].0.as_flattened().iter();
                if negative {
                    scatter(lanes.map(|lane| -lane), results, entries, place);
                } else {
                    scatter(lanes.copied(), results, entries, place);
                }
            }
            (Place::Last, _) => unreachable!("{KEPT}"),
        }
    }
}

fn signed(value: f64, output: &Output) -> f64 {
    if output.negative { -value } else { value }
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
                    Place::Last => unreachable!("{KEPT}"),
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
                Place::Last => unreachable!("{KEPT}"),
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
