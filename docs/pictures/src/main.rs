//! The pictures of the guide and of the documents, for light and dark screens, and their alternative texts.
//!
//! ```text
//! cargo run -p pictures
//! ```
//!
//! Nothing is measured here: figures are those of the tables in `docs/accuracy`, and the compiler's message is the one
//! that `tests/compile-fail` holds.

#![forbid(unsafe_code)]

mod frames;
mod mistake;
mod neglect;
mod pipeline;
mod placement;
mod row;
mod table;
#[cfg(test)]
mod tests;
mod work_precision;

use std::path::{Path, PathBuf};
use std::{fs, io};

use measuring::drawing::Drawing;

/// The folder of the pictures.
const FOLDER: &str = "docs/guide/src/pictures";

struct Picture {
    /// The name of its file, without its end.
    name: &'static str,
    drawing: Drawing,
    /// All that it shows, in words. Documents have it beside the picture.
    alternative: String,
    /// The documents that show it.
    documents: &'static [&'static str],
}

/// The folder of the whole project.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn pictures(root: &Path) -> Vec<Picture> {
    vec![
        mistake::picture(root),
        pipeline::picture(),
        row::picture(),
        frames::picture(),
        placement::picture(),
        work_precision::picture(root),
        neglect::picture(root),
    ]
}

/// A file that pictures are made of.
fn read(root: &Path, path: &str) -> String {
    fs::read_to_string(root.join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// The document with this alternative text in front of the picture's address.
///
/// # Panics
///
/// Where the document has no such picture.
fn with_alternative(document: &str, name: &str, alternative: &str) -> String {
    let end = format!("pictures/{name}.svg)");
    let place = document.find(&end);
    let place = place.unwrap_or_else(|| panic!("no picture `{end}`"));
    let bracket = document[..place].rfind("](").expect("a link");
    let begin = document[..bracket].rfind("![").expect("a picture") + 2;
    format!(
        "{}{alternative}{}",
        &document[..begin],
        &document[bracket..]
    )
}

fn main() -> io::Result<()> {
    let root = root();
    for picture in pictures(&root) {
        let path = format!("{FOLDER}/{}.svg", picture.name);
        fs::write(root.join(&path), picture.drawing.svg())?;
        println!("written: {path}");
        for document in picture.documents {
            let text = with_alternative(&read(&root, document), picture.name, &picture.alternative);
            fs::write(root.join(document), text)?;
        }
    }
    Ok(())
}
