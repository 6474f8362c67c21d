//! Files that are written.

use std::io::{ErrorKind, Write as _};
use std::path::{Path, PathBuf};

use dynamics_simulation::replace_files;

use crate::failure::Failure;

/// Refuses to write the files of `--out` and `--plot` over one that is read, whichever of its names is given.
pub(crate) fn not_over_what_is_read<'a>(
    read: impl IntoIterator<Item = &'a PathBuf> + Clone,
    [out, plot]: [&Option<PathBuf>; 2],
) -> Result<(), Failure> {
    for (option, path) in [("out", out), ("plot", plot)] {
        let written = path.as_deref().and_then(identity);
        let mut read = read.clone().into_iter();
        if let (Some(path), Some(_)) = (path, &written)
            && read.any(|path| identity(path) == written)
        {
            return Err(Failure::of_the_command_line(format!(
                "`--{option} {}` is a file that is read, and would be lost: write to another one",
                path.display()
            )));
        }
    }
    if out.is_some() && out == plot {
        let message = "`--out` and `--plot` are one file: give the figure another one";
        return Err(Failure::of_the_command_line(message));
    }
    Ok(())
}

/// Writes the text of a subcommand to the file of `--out`, or hands it back where there is none, or no text. Neither that
/// file nor the one of `--plot` is one that is read.
pub(crate) fn put_out<'a>(
    read: impl IntoIterator<Item = &'a PathBuf> + Clone,
    [out, plot]: [&Option<PathBuf>; 2],
    run: impl FnOnce() -> Result<String, Failure>,
) -> Result<String, Failure> {
    not_over_what_is_read(read, [out, plot])?;
    let put = |text: String| match out {
        Some(path) if !text.is_empty() => write(&[(path.clone(), text)]).map(|()| String::new()),
        _ => Ok(text),
    };
    match run() {
        Ok(text) => put(text),
        Err(failure) => {
            let rest = put(failure.output.clone())?;
            Err(failure.with_output(rest))
        }
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
