//! The functions in another language.

use std::path::{Path, PathBuf};

use clap::ArgMatches;
use dynamics_symbolic::emit::{c_source, javascript_module};
use dynamics_symbolic::{Function, Request};

use crate::csv::write;
use crate::failure::Failure;
use crate::load::{model, programs};

/// Writes the files, and says which.
pub(crate) fn run(given: &ArgMatches) -> Result<String, Failure> {
    let (robot, requests) = model(given)?;
    let series = Request::One(Function::TaylorSeries);
    let requests = requests.into_iter().filter(|request| *request != series);
    let programs = programs(&robot, requests)?;
    let source = c_source(&robot, &programs);
    let files = match given.get_one::<String>("lang").map(String::as_str) {
        Some("c") => vec![
            (format!("{}.h", source.name), source.header),
            (format!("{}.c", source.name), source.source),
        ],
        _ => vec![(
            format!("{}.mjs", source.name),
            javascript_module(&robot, &programs),
        )],
    };
    let folder = given
        .get_one::<PathBuf>("out")
        .map_or(Path::new("."), PathBuf::as_path);
    std::fs::create_dir_all(folder)?;
    let mut text = String::new();
    for (name, content) in files {
        let path = folder.join(name);
        write(&path, &content)?;
        text.push_str(&format!("{}\n", path.display()));
    }
    Ok(text)
}
