//! Files that are written.

use std::io::{ErrorKind, Write as _};
use std::path::{Path, PathBuf};

use clap::ArgMatches;
use dynamics_runtime::replace_files;

use crate::failure::Failure;

/// Refuses to write over a file that is read, whichever of its names is given.
pub(crate) fn not_over_what_is_read(given: &ArgMatches) -> Result<(), Failure> {
    const READ: [&str; 3] = ["file", "against", "waypoints"];
    let named = |option: &str| given.try_get_one::<PathBuf>(option).ok().flatten();
    for option in ["out", "plot"] {
        let Some(out) = named(option) else {
            continue;
        };
        let written = identity(out);
        let mut read = READ.into_iter().filter_map(named);
        if written.is_some() && read.any(|path| identity(path) == written) {
            return Err(Failure::of_the_command_line(format!(
                "`--{option} {}` is a file that is read, and would be lost: write to another one",
                out.display()
            )));
        }
    }
    match (named("out"), named("plot")) {
        (Some(out), Some(plot)) if out == plot => Err(Failure::of_the_command_line(
            "`--out` and `--plot` are one file: give the figure another one",
        )),
        _ => Ok(()),
    }
}

/// The device and the number of a file, which all of its names share.
#[cfg(unix)]
fn identity(path: &Path) -> Option<(u64, u64)> {
    use std::os::unix::fs::MetadataExt as _;
    let file = path.metadata().ok()?;
    Some((file.dev(), file.ino()))
}

/// The path of a file without links.
#[cfg(not(unix))]
fn identity(path: &Path) -> Option<PathBuf> {
    path.canonicalize().ok()
}

/// Writes a text to the file that `--out` names; hands it back where it names none, or there is no text.
pub(crate) fn put_out(text: String, given: &ArgMatches) -> Result<String, Failure> {
    match given.get_one::<PathBuf>("out") {
        Some(path) if !text.is_empty() => write(&[(path.clone(), text)]).map(|()| String::new()),
        _ => Ok(text),
    }
}

/// Writes a text to standard output.
pub(crate) fn print(text: &str) -> Result<(), Failure> {
    let mut out = std::io::stdout();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        // Whoever reads the output may have read enough.
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(cannot(Path::new("standard output"), &error))
        }
        _ => Ok(()),
    }
}

/// Writes files: all of them, or none if one cannot be written.
pub(crate) fn write(files: &[(PathBuf, String)]) -> Result<(), Failure> {
    replace_files(files).map_err(|(path, error)| cannot(&path, &error))
}

/// Makes a folder, unless it is there.
pub(crate) fn make_folder(path: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(path).map_err(|error| cannot(path, &error))
}

fn cannot(path: &Path, error: &std::io::Error) -> Failure {
    let message = format!("{}: cannot be written: {error}", path.display());
    Failure::after(String::new(), message)
}
