//! What grows with the number of joints, and how fast: expansion time, program length, rustc time
//! and time of a call, for generic chains with full tensors.
//!
//! ```text
//! cargo run --release --example growth
//! taskset -c 1 cargo run --release --example growth -- --full
//! ```
//!
//! The first is a look at a few chains, in which one of 30 axes expands and compiles. The second
//! measures up to 30 joints, in an unoptimised engine as well, and writes `docs/GROWTH.md`. Both
//! write plots to `examples/output/`.

use std::error::Error;

mod growing;

use growing::{Effort, document, measure, plots};

fn main() -> Result<(), Box<dyn Error>> {
    let effort = match std::env::args().nth(1).as_deref() {
        None => Effort::QUICK,
        Some("--full") => Effort::FULL,
        Some(other) => return Err(format!("`{other}` is not known: --full, or nothing").into()),
    };
    let chains = measure(&effort)?;
    plots(&chains)?;
    let document = document(&chains)?;
    println!("{document}");
    if effort.is_full {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/GROWTH.md");
        std::fs::write(path, document)?;
        println!("written: docs/GROWTH.md");
    }
    Ok(())
}
