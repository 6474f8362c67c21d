//! Many states at once: each step for a block of states, in the lanes of vector registers. The slots of a block are few
//! enough to stay in the caches next to the processor.

mod kernel;
mod run;

pub(crate) use run::{Batch, Stage, run, stages};

/// Lanes that are computed together: a register of AVX-512, two of AVX2.
pub(crate) const LANES: usize = 8;

/// Groups of lanes in a block: a number at all 32 states fits into eight registers of AVX2 or four of AVX-512.
pub(crate) const GROUPS: usize = 4;

/// States in a block.
pub(crate) const STATES: usize = GROUPS * LANES;

/// A number at each state of a block.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub(crate) struct Block(pub(crate) [[f64; LANES]; GROUPS]);

impl Block {
    pub(crate) const ZERO: Block = Block([[0.0; LANES]; GROUPS]);
}
