//! Files of robots: what the entry `file` of a call names, or another program reads.
//!
//! The formats are read by crates that keep the text and the place of every number: decimals stay exact,
//! and a mistake is told with its line and column. What comes out is a [`Table`], as from a call.

mod load;

#[cfg(feature = "files")]
mod json;
#[cfg(feature = "files")]
mod table;
#[cfg(feature = "files")]
mod toml;
#[cfg(feature = "files")]
mod tree;

pub(crate) use load::load;

use std::path::Path;

#[cfg(feature = "files")]
use crate::Error;
#[cfg(feature = "files")]
use crate::description::{Name, Place, Table};
#[cfg(feature = "files")]
use crate::diagnose::Diagnostics;

/// A kind of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// A table in the macro's words: `[[joint]]`, `a = 0.3`, `inertia = { yy = 0.35 }`.
    Toml,
    /// A table as it is published: `joints` with the cells `a`, `alpha`, `d`, `theta`, `mass`, `com`, `inertia`
    /// (xx, yy, zz, xy, yz, xz), `motor_inertia`, `gear_ratio`, `viscous`, `coulomb`. Where the file names its
    /// `source`, tensors that no body can have are taken as they are.
    Json,
}

impl Format {
    /// The format that the end of the name tells.
    pub fn of(path: &Path) -> Option<Format> {
        match path.extension()?.to_str()?.to_lowercase().as_str() {
            "toml" => Some(Format::Toml),
            "json" => Some(Format::Json),
            _ => None,
        }
    }
}

/// Reads the text of a file: what it says of the robot `name`, or all that cannot be read. What a table
/// says is judged by [`check`](crate::check); it need not have everything that a robot needs.
#[cfg(feature = "files")]
pub fn table(name: &str, text: &str, format: Format) -> Result<Table, Vec<Error>> {
    let diagnostics = Diagnostics::new();
    let mut table = read(text, format, &diagnostics).unwrap_or_default();
    let start = Place::File { line: 1, column: 1 };
    table.name = Some(Name::new(name, start));
    table.has_all_fields = true;
    match diagnostics.is_empty() {
        true => Ok(table),
        false => Err(crate::errors(diagnostics)),
    }
}

/// The entries of a text; what cannot be read is reported. None of a text of another format.
#[cfg(feature = "files")]
fn read(text: &str, format: Format, diagnostics: &Diagnostics) -> Option<Table> {
    let root = match format {
        Format::Toml => toml::document(text, diagnostics),
        Format::Json => json::document(text, diagnostics),
    };
    root.map(|root| table::table(&root, diagnostics))
}
