//! The file of a call: found, read, and put in place of the entry that names it.

use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use super::beside;
use super::reading::{
    ADDING, bytes, decoded, forget_locks, is_bare_base, joint_names, read, request,
};
use super::report_without_file;
use super::request::Format;
use crate::audience::Audience;
use crate::call::Call;
use crate::description::{Entry, FileName, Joints};
use crate::diagnose::Diagnostics;
use crate::limits::MOST_BYTES;
use crate::mistake::file as mistake;
use crate::place::Place;

/// Entries in place of which a file stands.
const INSTEAD: [&str; 2] = ["convention", "joints"];

/// Reads the file and puts its entries where the call names it; `None` if that was not possible.
pub(super) fn insert(call: &mut Call, file: &FileName, diagnostics: &Diagnostics) -> Option<()> {
    // A call says what a URDF file leaves open.
    let audience = match Format::of(Path::new(&file.path)) {
        Some(Format::Urdf) => Audience::Call,
        _ => Audience::File,
    };
    diagnostics.reading(file, audience);
    let is_beside = |entry: &Entry| matches!(entry, Entry::Beside(..));
    let has_cells = call.table.entries.iter().any(is_beside);
    for (key, place) in &call.table.keys {
        if INSTEAD.contains(key) && !(has_cells && *key == "joints") {
            diagnostics.error(*place, mistake::instead_of(key, &file.path));
        }
    }
    let format = format(file, diagnostics)?;
    let text = text(&mut call.tracked, file, diagnostics)?;
    if format != Format::Urdf {
        report_without_file(call, diagnostics);
    }
    let request = request(&call.table, diagnostics)?;
    let used = &mut Vec::new();
    let mut read = read(&text, format, &request, used, diagnostics)?;
    for entry in &read.entries {
        if let Entry::File(Some(other)) = entry {
            diagnostics.error(other.place, mistake::file_of_a_file(&other.path));
            return None;
        }
    }
    for (key, place) in &call.table.keys {
        let is_in_file = read.keys.iter().any(|(other, _)| other == key);
        if is_in_file && !INSTEAD.contains(key) && !ADDING.contains(key) {
            diagnostics.error(*place, mistake::in_file_too(key, &file.path));
        }
    }
    let table = &mut call.table;
    forget_locks(&mut table.entries, used);
    if format == Format::Urdf {
        // It has become that of the file.
        table.entries.retain(|entry| !is_bare_base(entry));
    }
    table.notes.extend(read.notes);
    table.rounded = read.rounded;
    table.warnings = read.warnings;
    let cells = beside::take(&mut table.entries);
    let links = beside::take_links(&mut table.entries);
    let in_front = beside::in_front(
        cells.as_ref().map(|(at, ..)| *at),
        links.as_ref().map(|(at, ..)| *at),
    );
    if let Some((_, place, rows)) = cells {
        let all = || joint_names(&text, format);
        beside::put((place, rows), &mut read.entries, all, diagnostics);
    }
    if let Some((_, place, links)) = links {
        beside::put_links((place, links), &mut read.entries, format, diagnostics);
    }
    let is_file = |entry: &Entry| matches!(entry, Entry::File(_));
    let at = table.entries.iter().position(is_file).unwrap_or(0);
    let behind = at + read.entries.len() + in_front.saturating_sub(at + 1);
    table.entries.splice(at..=at, read.entries);
    let is_joints = |entry: &Entry| matches!(entry, Entry::Joints(..));
    if table.floating().is_some() && !table.entries.iter().any(is_joints) {
        // A file of a body that moves alone says nothing of joints, as a call does by `joints: []`.
        let complete = true;
        let rows = Vec::new();
        let none = Joints { rows, complete };
        table.entries.push(Entry::Joints(Place::START, Some(none)));
    }
    if in_front > at {
        beside::move_cells(&mut table.entries, behind);
    }
    table.mentions.extend(read.mentions);
    Some(())
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
    let unreadable = |error: std::io::Error| match error.kind() {
        ErrorKind::NotFound => mistake::not_found(&file.path),
        _ => mistake::unreadable(&file.path, &error),
    };
    let bytes = bytes(&path, MOST_BYTES);
    let bytes = bytes.map_err(|error| diagnostics.error(file.place, unreadable(error)));
    let bytes = bytes.ok()?;
    *tracked = path.to_str().map(str::to_owned);
    decoded(bytes)
        .map_err(|(place, mistake)| diagnostics.error(place, mistake))
        .ok()
}
