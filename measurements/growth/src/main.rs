//! The growth with the number of joints of expansion time, program length, rustc time and time of a call, for generic
//! chains with full tensors.
//!
//! ```text
//! cargo run --release -p growth
//! taskset -c 1 cargo run --release -p growth -- --full
//! taskset -c 1 cargo run --release -p growth -- --tree
//! ```
//!
//! The first is a look at a few chains, in which one of 30 axes expands and compiles. The second
//! measures up to 30 joints, in an unoptimised engine as well, and writes `docs/contributing/GROWTH.md`. Both
//! write plots to `examples/output/`. The third prints the section about a tree alone.

mod chain;
mod compile;
mod document;
mod fit;
mod measure;
mod plot;
mod series;
mod source;
mod unoptimised;

use chain::Outcome;
use document::{document, section};
use measure::{measure, measure_tree};
use plot::plots;

fn main() -> Outcome<()> {
    let effort = match std::env::args().nth(1).as_deref() {
        None => Effort::QUICK,
        Some("--full") => Effort::FULL,
        Some("--tree") => {
            println!("{}", section(&measure_tree()?));
            return Ok(());
        }
        Some(other) => {
            return Err(format!("`{other}` is not known: --full, --tree, or nothing").into());
        }
    };
    let chains = measure(effort.joints, effort.is_full)?;
    plots(&chains)?;
    let document = document(&chains)? + &section(&measure_tree()?);
    println!("{document}");
    if effort.is_full {
        let path = concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/../../docs/contributing/GROWTH.md"
        );
        std::fs::write(path, document)?;
        println!("written: docs/contributing/GROWTH.md");
    }
    Ok(())
}

/// How many chains are measured.
struct Effort {
    /// Numbers of joints.
    joints: &'static [usize],
    /// Whether the unoptimised engine is measured too, and the results become `docs/contributing/GROWTH.md`.
    is_full: bool,
}

impl Effort {
    /// Well under a minute.
    const QUICK: Effort = Effort {
        joints: &[3, 6, 12, 30],
        is_full: false,
    };
    /// Some minutes.
    const FULL: Effort = Effort {
        joints: &[
            1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 18, 20, 22, 24, 27, 30,
        ],
        is_full: true,
    };
}
