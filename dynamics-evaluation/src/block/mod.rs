//! Many states at once: each step for a block of states, in the lanes of vector registers. The slots of a block are few
//! enough to stay in the caches next to the processor.
//!
//! A step is looked up once for a block. Its kernel is chosen when the tape is made, for its operands: a slot, a number
//! that all states share, or the result of the step before. A product and a sum, or two products and a sum, are one
//! kernel. The result of a step stays in registers, eight of AVX2 or four of AVX-512 for 32 states. The
//! next step reads it there, and it is written to its slot only if another one reads it too. The loop over steps is
//! compiled for each instruction set. `cargo run --release -p dynamics-evaluation --example time` measures it.

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
