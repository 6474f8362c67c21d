//! Motions as figures.

use std::path::PathBuf;

use clap::ArgMatches;
use dynamics_runtime::plot::Figure;

use crate::failure::Failure;
use crate::write::write;

/// Writes the figure to the file that `--plot` names, if it names one.
pub(crate) fn put(given: &ArgMatches, figure: impl FnOnce() -> Figure) -> Result<(), Failure> {
    let Some(path) = given.get_one::<PathBuf>("plot") else {
        return Ok(());
    };
    let svg = figure().svg();
    let svg = svg.map_err(|error| Failure::after(String::new(), format!("`--plot`: {error}")))?;
    write(&[(path.clone(), svg)])
}
