//! Motions as figures.

use std::path::Path;

use dynamics_runtime::plot::Figure;

use crate::failure::Failure;
use crate::write::write;

/// Writes the figure to the file that `--plot` names, if it names one.
pub(crate) fn put(path: Option<&Path>, figure: impl FnOnce() -> Figure) -> Result<(), Failure> {
    let Some(path) = path else {
        return Ok(());
    };
    let svg = figure().svg();
    let svg = svg.map_err(|error| Failure::after(String::new(), format!("`--plot`: {error}")))?;
    write(&[(path.to_owned(), svg)])
}
