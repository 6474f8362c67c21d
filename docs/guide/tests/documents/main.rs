//! The files and headings that the project's documents link to exist, and the examples, packages and tests that their
//! commands name. Their sentences are short, as those of comments and of help texts are.

mod commands;
mod comments;
mod counts;
mod document;
mod links;
mod packages;
mod prose;
mod sentences;

use std::path::{Path, PathBuf};

/// The folder of the whole project.
fn root() -> PathBuf {
    let mut above = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors();
    above.nth(2).expect("the guide is in `docs`").to_owned()
}

/// Folders of what is built, and of other people's code.
const LEFT_OUT: [&str; 4] = ["target", ".git", "node_modules", "book"];

/// All documents of a folder and of those in it, in the order of their names.
fn documents(folder: &Path) -> Vec<PathBuf> {
    files(folder, "md")
}

/// The files with an extension, of a folder and of those in it, in the order of their names.
fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("the folder can be read");
    let mut paths: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry").path())
        .collect();
    paths.sort();
    let mut found = Vec::new();
    for path in paths {
        let name = path.file_name().and_then(|name| name.to_str());
        if path.is_dir() {
            if !LEFT_OUT.iter().any(|left_out| name == Some(left_out)) {
                found.extend(files(&path, extension));
            }
        } else if path.extension().is_some_and(|found| found == extension) {
            found.push(path);
        }
    }
    found
}

/// Nothing is left to complain of, or a list of all complaints.
#[track_caller]
fn assert_none(complaints: Vec<String>) {
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}
