//! Plots with logarithmic axes as SVG. Curves over time are drawn by the runtime.

mod logarithmic;

use std::{error::Error, fs, path::Path};

pub use logarithmic::{Mark, Plot, Series};

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

/// Writes `examples/output/<name>.svg` and says so on standard output.
fn save(svg: &str, name: &str) -> Outcome {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/output");
    fs::create_dir_all(&folder)?;
    fs::write(folder.join(name).with_extension("svg"), svg)?;
    println!("plot: examples/output/{name}.svg");
    Ok(())
}
