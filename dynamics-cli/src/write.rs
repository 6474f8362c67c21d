//! Files that are written.

use std::path::{Path, PathBuf};

use clap::ArgMatches;

use crate::failure::Failure;

/// Writes a text to the file that `--out` names; hands it back where it names none.
pub(crate) fn put_out(text: String, given: &ArgMatches) -> Result<String, Failure> {
    match given.get_one::<PathBuf>("out") {
        None => Ok(text),
        Some(path) => write(path, &text).map(|()| String::new()),
    }
}

/// Writes a file.
pub(crate) fn write(path: &Path, text: &str) -> Result<(), Failure> {
    std::fs::write(path, text).map_err(|error| cannot(path, &error))
}

/// Makes a folder, unless it is there.
pub(crate) fn make_folder(path: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(path).map_err(|error| cannot(path, &error))
}

fn cannot(path: &Path, error: &std::io::Error) -> Failure {
    let message = format!("{}: cannot be written: {error}", path.display());
    Failure::after(String::new(), message)
}
