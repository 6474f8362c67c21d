//! Plots with logarithmic axes as SVG. Curves over time are drawn by the runtime.

mod logarithmic;

use std::{error::Error, fs, path::Path};

use plotters::style::RGBColor;

pub use logarithmic::{Mark, Plot, Series};

/// Colours that stay apart for colour-blind readers: Okabe and Ito, Color Universal Design (2008), and
/// some more where seven are too few.
const COLOURS: [RGBColor; 12] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(0, 0, 0),
    RGBColor(150, 110, 60),
    RGBColor(120, 120, 120),
    RGBColor(110, 60, 160),
    RGBColor(190, 190, 40),
    RGBColor(200, 30, 30),
];

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

/// Writes `examples/output/<name>.svg` and says so on standard output.
fn save(svg: &str, name: &str) -> Outcome {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/output");
    fs::create_dir_all(&folder)?;
    fs::write(folder.join(name).with_extension("svg"), svg)?;
    println!("plot: examples/output/{name}.svg");
    Ok(())
}
