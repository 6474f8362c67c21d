//! `docs/PERFORMANCE.md` and its charts, from the tables in `docs/performance` and `docs/contributing/goals`, which the
//! programs that measure write.
//!
//! ```text
//! cargo run -p performance
//! ```
//!
//! Nothing is measured here: each figure of the page is one of these tables, or is computed from some of them.

#![forbid(unsafe_code)]

mod appendix;
mod chart;
mod page;
mod purposes;
#[cfg(test)]
mod tests;

use std::path::{Path, PathBuf};
use std::{fs, io};

use appendix::Appendices;
use chart::Chart;

/// The folder of the whole project.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The page and its charts: where they stand in the project, and what they say.
fn files(appendices: &Appendices) -> Vec<(String, String)> {
    let purposes = purposes::all(appendices);
    let charts = purposes.iter().flat_map(|purpose| &purpose.chart);
    let chart = |chart: &Chart| (format!("docs/performance/{}.svg", chart.file), chart.svg());
    let mut files: Vec<_> = charts.map(chart).collect();
    files.push(("docs/PERFORMANCE.md".to_owned(), page::page(&purposes)));
    files
}

fn main() -> io::Result<()> {
    let root = root();
    for (path, text) in files(&Appendices::read(&root)) {
        fs::write(root.join(&path), text)?;
        println!("written: {path}");
    }
    Ok(())
}
