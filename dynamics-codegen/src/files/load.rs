//! The file of a call: found, read, and put in place of the entry that names it.

use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use dynamics_symbolic::exact::Rational;

use super::reading::{ADDING, bytes, decoded, read};
use super::{Format, Request, report_without_file};
use crate::audience::Audience;
use crate::call::Call;
use crate::description::{Entry, Expr, FileName, Positioned, Table};
use crate::diagnose::Diagnostics;
use crate::limits::MOST_BYTES;
use crate::mistake::file as mistake;
use crate::validate::{constant, functions::read_masses};

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
    for (key, place) in &call.table.keys {
        if INSTEAD.contains(key) {
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
    let read = read(&text, format, &request, used, diagnostics)?;
    for (key, place) in &call.table.keys {
        let is_in_file = read.keys.iter().any(|(other, _)| other == key);
        if is_in_file && !INSTEAD.contains(key) && !ADDING.contains(key) {
            diagnostics.error(*place, mistake::in_file_too(key, &file.path));
        }
    }
    let table = &mut call.table;
    forget_locks(&mut table.entries, used);
    table.notes.extend(read.notes);
    let is_file = |entry: &Entry| matches!(entry, Entry::File(_));
    let at = table.entries.iter().position(is_file).unwrap_or(0);
    table.entries.splice(at..=at, read.entries);
    table.mentions.extend(read.mentions);
    Some(())
}

/// The request of a call to its file; none where that could not be read.
pub(crate) fn request(table: &Table, diagnostics: &Diagnostics) -> Option<Request> {
    let mut request = Request {
        unphysical_inertia: table.allow().unphysical_inertia,
        no_inertia: table.allow().no_inertia || !read_masses(table),
        odd_angle: table.allow().odd_angle,
        ..Request::default()
    };
    for entry in &table.entries {
        match entry {
            Entry::Chain(chain) => request.chain = Some(chain.clone()?),
            Entry::Ignore(ignore) => request.ignore.clone_from(ignore.as_ref()?),
            Entry::RoundAngles(angle) => {
                let within = rounded_within(angle.as_ref()?, diagnostics)?;
                request.round_angles = Some(within);
            }
            Entry::Lock(locked) => {
                let locked = locked.as_ref()?.iter();
                let lock = |locked: &Positioned| {
                    let position = locked.position.as_ref().and_then(constant);
                    (locked.name.clone(), position)
                };
                request.lock = locked.map(lock).collect();
            }
            _ => {}
        }
    }
    Some(request)
}

fn rounded_within(angle: &Expr, diagnostics: &Diagnostics) -> Option<Rational> {
    let good = 0.0..=0.1;
    let value = constant(angle).filter(|value| good.contains(&value.to_f64(&[])));
    let value = value.and_then(|value| value.as_rational().cloned());
    if value.is_none() {
        diagnostics.error(angle.place, crate::mistake::urdf::round_angles());
    }
    value
}

/// Removes the joints `used`, which are not part of the arm, from the list of locked joints.
pub(crate) fn forget_locks(entries: &mut Vec<Entry>, used: &[String]) {
    for entry in entries.iter_mut() {
        if let Entry::Lock(Some(locked)) = entry {
            locked.retain(|locked| !used.iter().any(|name| name == locked.name.plain()));
        }
    }
    entries.retain(|entry| !matches!(entry, Entry::Lock(Some(locked)) if locked.is_empty()));
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
