//! The file of a call: found, read, and put in place of the entry that names it.

use crate::call::Call;
use crate::description::{Entry, FileName};
use crate::diagnose::Diagnostics;
use crate::mistake::file as mistake;

/// Entries that say something about a file, and mean nothing without one.
const ABOUT_FILES: [&str; 3] = ["chain", "ignore", "round_angles"];

/// Puts what the file of a call says beside what the call says.
pub(crate) fn load(call: &mut Call, diagnostics: &Diagnostics) {
    let file = call.table.entries.iter().find_map(|entry| match entry {
        Entry::File(file) => Some(file.clone()),
        _ => None,
    });
    match file {
        Some(Some(file)) => insert(call, &file, diagnostics),
        Some(None) => {}
        None => report_without_file(call, diagnostics),
    }
}

fn report_without_file(call: &Call, diagnostics: &Diagnostics) {
    for (key, place) in &call.table.keys {
        if ABOUT_FILES.contains(key) {
            diagnostics.error(*place, mistake::only_with_urdf(key));
        }
    }
}

#[cfg(not(feature = "files"))]
fn insert(_: &mut Call, file: &FileName, diagnostics: &Diagnostics) {
    diagnostics.error(file.place, mistake::switched_off());
}

#[cfg(feature = "files")]
use reading::insert;

#[cfg(feature = "files")]
mod reading {
    use std::io::ErrorKind;
    use std::path::{Path, PathBuf};

    use super::*;
    use crate::files::{self, Format};
    use crate::limits::MOST_BYTES;
    use crate::place::Place;

    /// Entries in place of which a file stands.
    const INSTEAD: [&str; 2] = ["convention", "joints"];

    /// Reads the file and puts its entries where the call names it.
    pub(super) fn insert(call: &mut Call, file: &FileName, diagnostics: &Diagnostics) {
        diagnostics.reading(file);
        for (key, place) in &call.table.keys {
            if INSTEAD.contains(key) {
                diagnostics.error(*place, mistake::instead_of(key, &file.path));
            }
        }
        let Some(format) = format(file, diagnostics) else {
            return;
        };
        let Some(text) = text(&mut call.tracked, file, diagnostics) else {
            return;
        };
        for (key, place) in &call.table.keys {
            if ABOUT_FILES.contains(key) {
                diagnostics.error(*place, mistake::only_with_urdf(key));
            }
        }
        let Some(read) = files::read(&text, format, diagnostics) else {
            return;
        };
        for (key, place) in &call.table.keys {
            let is_in_file = read.keys.iter().any(|(other, _)| other == key);
            if is_in_file && !INSTEAD.contains(key) {
                diagnostics.error(*place, mistake::in_file_too(key, &file.path));
            }
        }
        let table = &mut call.table;
        let is_file = |entry: &Entry| matches!(entry, Entry::File(_));
        let at = table.entries.iter().position(is_file).unwrap_or(0);
        table.entries.splice(at..=at, read.entries);
        table.mentions.extend(read.mentions);
    }

    fn format(file: &FileName, diagnostics: &Diagnostics) -> Option<Format> {
        let format = Format::of(Path::new(&file.path));
        if format.is_none() {
            diagnostics.error(file.place, mistake::unknown_format(&file.path));
        }
        format
    }

    /// The file's text. A path starts at the folder of the crate's Cargo.toml.
    fn text(
        tracked: &mut Option<String>,
        file: &FileName,
        diagnostics: &Diagnostics,
    ) -> Option<String> {
        let folder = std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from);
        let path = folder.unwrap_or_default().join(&file.path);
        let bytes = match std::fs::read(&path) {
            Ok(bytes) => bytes,
            Err(error) => {
                let mistake = match error.kind() {
                    ErrorKind::NotFound => mistake::not_found(&file.path),
                    _ => mistake::unreadable(&file.path, &error),
                };
                diagnostics.error(file.place, mistake);
                return None;
            }
        };
        *tracked = path.to_str().map(str::to_owned);
        if bytes.len() > MOST_BYTES {
            diagnostics.error(file.place, mistake::too_long(&file.path, MOST_BYTES));
            return None;
        }
        String::from_utf8(bytes)
            .map_err(|error| {
                let good = &error.as_bytes()[..error.utf8_error().valid_up_to()];
                let line = 1 + good.iter().filter(|byte| **byte == b'\n').count();
                let place = Place::File { line, column: 1 };
                diagnostics.error(place, mistake::no_text(line));
            })
            .ok()
    }
}
