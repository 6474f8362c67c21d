//! The functions as source code.

use std::path::Path;

use dynamics_codegen::Model;
use dynamics_export::{CNumbers, Error, Language, Options, files};

use crate::arguments::{FileOptions, Generate};
use crate::failure::Failure;
use crate::load::{programs, read_with_names, requests};
use crate::progress::Progress;
use crate::write::{make_folder, not_over_what_is_read, write};

/// Writes the files, and says which.
pub(crate) fn run(given: &Generate) -> Result<String, Failure> {
    let FileOptions { path, name, .. } = &given.robot.file;
    not_over_what_is_read([path], [&Some(given.out.clone()), &None])?;
    let options = Options {
        of: &path.file_name().unwrap_or_default().to_string_lossy(),
        struct_name: name.as_deref(),
        numbers: c_numbers(given)?,
        is_project: given.project,
        leaves_out_batches: given.no_batches,
    };
    let mut model = read_with_names(&given.robot)?;
    if given.lang != Language::Rust {
        leave_out(given.lang, &mut model)?;
    }
    let files = written(given.lang, path, model, &options)?;
    make_folder(&given.out)?;
    let contents = files.into_iter();
    let placed: Vec<_> = contents
        .map(|(name, text)| (given.out.join(name), text))
        .collect();
    write(&placed)?;
    let names = placed
        .iter()
        .map(|(path, _)| format!("{}\n", path.display()));
    Ok(names.collect())
}

/// Names and texts of the files.
fn written(
    language: Language,
    path: &Path,
    model: Model,
    options: &Options<'_>,
) -> Result<Vec<(String, String)>, Failure> {
    // The expansion of the macro derives all functions at once.
    let progress = (language == Language::Rust).then(|| Progress::new(1));
    if let Some(progress) = &progress {
        progress.doing("deriving and proving the functions");
    }
    let files = files(language, model, options, |robot, requests| {
        programs(path, robot, requests)
    });
    drop(progress);
    files.map_err(|error| match error {
        Error::Programs(failure) => failure,
        Error::Unwritten(messages) => Failure::of_file(path, messages),
    })
}

/// Leaves out of a model what is no program over numbers, and inverse kinematics unless the language has it. Remarks say so.
fn leave_out(language: Language, model: &mut Model) -> Result<(), Failure> {
    let written = match language.has_closed_forms() {
        true => core::mem::take(&mut model.inverses),
        false => Vec::new(),
    };
    // A file of inverse kinematics alone.
    if written.is_empty() || !model.requests.is_empty() {
        let kept = requests(model)?.into_iter();
        model.requests = kept.map(|request| (request, None)).collect();
    }
    model.inverses = written;
    Ok(())
}

/// The numbers of C. `--scalar`, `--sines`, `--project` and `--no-batches` are of no other language.
fn c_numbers(given: &Generate) -> Result<CNumbers, Failure> {
    let (scalar, sines) = (&given.scalar, &given.sines);
    let is_c = given.lang == Language::C;
    for (option, word) in [("scalar", scalar), ("sines", sines)] {
        if let (Some(word), false) = (word, is_c) {
            return Err(Failure::of_the_command_line(format!(
                "`--{option} {word}` is about `--lang c`: Rust's functions take any scalar, and numbers of the other \
                 languages are doubles"
            )));
        }
    }
    for (is_given, option, what) in [
        (given.project, "project", "writes what C++ and CMake need"),
        (
            given.no_batches,
            "no-batches",
            "leaves out functions over columns of states",
        ),
    ] {
        if is_given && !is_c {
            return Err(Failure::of_the_command_line(format!(
                "`--{option}` is about `--lang c`: it {what}"
            )));
        }
    }
    Ok(CNumbers::new(
        scalar.as_deref() == Some("float"),
        sines.is_some(),
    ))
}
