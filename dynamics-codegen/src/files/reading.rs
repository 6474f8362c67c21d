//! The text of a file, the request to it, and the robot that it describes.

use std::collections::BTreeSet;
use std::io::Read as _;
use std::path::Path;

use dynamics_symbolic::exact::Rational;

use super::request::{Format, MovingBase, Request};
use super::{beside, fields, json, links, toml, urdf};
use crate::audience::Audience;
use crate::description::{Entry, Expr, FileName, Masses, Name, Place, Positioned, Row, Table};
use crate::diagnose::{Diagnostics, Error};
use crate::mistake::{Mistake, file as mistake};
use crate::tree::Language;
use crate::validate::{self, Model, constant, named::read_masses};

/// The bytes of a file that has at most so many.
///
/// # Errors
///
/// The system's error for a file that cannot be read; [`InvalidInput`](std::io::ErrorKind::InvalidInput) if it is
/// longer, or a folder, a pipe or a device, of which no end may ever be read.
pub fn bytes(path: &Path, most: usize) -> std::io::Result<Vec<u8>> {
    // To open a pipe waits for somebody who writes into it.
    let kind = std::fs::metadata(path)?;
    if kind.is_dir() {
        return Err(unread("it is a folder, expected a file".to_owned()));
    }
    if !kind.is_file() {
        return Err(unread(format!(
            "it is a pipe or a device and may be longer than {most} bytes, expected a file"
        )));
    }
    bytes_of_any(path, most)
}

/// As [`bytes`], of a pipe or a device too: only so many are read of it.
///
/// # Errors
///
/// The system's error; [`InvalidInput`](std::io::ErrorKind::InvalidInput) if there are more.
pub fn bytes_of_any(path: &Path, most: usize) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let file = std::fs::File::open(path)?;
    match file.take(most as u64 + 1).read_to_end(&mut bytes)? {
        read if read > most => Err(unread(format!("it is longer than {most} bytes"))),
        _ => Ok(bytes),
    }
}

/// The error of a file that is not read, or not whole.
fn unread(reason: String) -> std::io::Error {
    std::io::Error::new(std::io::ErrorKind::InvalidInput, reason)
}

/// The text of a file's bytes.
///
/// # Errors
///
/// The first of them that is none of a text in UTF-8.
pub fn text(bytes: Vec<u8>) -> Result<String, Error> {
    decoded(bytes).map_err(|(place, mistake)| Error::new(place, &mistake, Audience::default()))
}

pub(super) fn decoded(bytes: Vec<u8>) -> Result<String, (Place, Mistake)> {
    let is_utf_16 = match bytes[..] {
        // The mark at its start; without one, a letter of which a byte is zero.
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => true,
        [first, second, ..] => (first == 0) != (second == 0),
        _ => false,
    };
    if is_utf_16 {
        return Err((Place::START, mistake::utf_16()));
    }
    String::from_utf8(bytes).map_err(|error| {
        let (good, rest) = error.as_bytes().split_at(error.utf8_error().valid_up_to());
        let good = String::from_utf8_lossy(good);
        let last = good.rsplit('\n').next().unwrap_or_default();
        let place = Place::File {
            line: 1 + good.matches('\n').count(),
            column: 1 + last.chars().count(),
        };
        (
            place,
            mistake::no_text(rest.first().copied().unwrap_or_default()),
        )
    })
}

/// Reads the text of a file: what it says of the robot `name`, or all that cannot be read. The table is judged by
/// [`check`](crate::check); it need not have everything that a robot needs.
pub fn table(
    name: &str,
    text: &str,
    format: Format,
    request: &Request,
) -> Result<Table, Vec<Error>> {
    let diagnostics = Diagnostics::new();
    let used = &mut Vec::new();
    let mut table = read(text, format, request, used, &diagnostics).unwrap_or_default();
    put_name(name, Place::START, &mut table);
    if diagnostics.is_empty() {
        Ok(table)
    } else {
        Err(diagnostics.shown_to(table.audience))
    }
}

/// Entries that are missing are reported at the place of the name.
fn put_name(name: &str, place: Place, table: &mut Table) {
    table.name = Some(Name::new(name, place));
    table.has_all_fields = true;
}

/// The model of a text with the entries of `beside`, as they stand in a call of the macro, or all mistakes: in what cannot
/// be read, and in the rest of the robot.
///
/// Joints that are locked or coupled,
/// frames and what is allowed add to the file's, and cells of `joints` replace those of its rows. Every other entry replaces the file's (a `let` replaces that of the same name);
/// `convention` and `joint` are mistakes. `chain`, `ignore` and `round_angles` say what is wanted of a URDF file, and are
/// passed over for a table. `base: floating` alone says that the base moves with the body that the file has. Cells of the file may use the fields of `beside`, whose audience is the reader of messages.
pub fn model_beside(
    name: &str,
    text: &str,
    format: Format,
    beside: Table,
) -> Result<Model, Vec<Error>> {
    let diagnostics = Diagnostics::new();
    let start = beside.name.as_ref().map_or(Place::START, Place::from);
    let mut table = put_beside(text, format, beside, &diagnostics);
    put_name(name, start, &mut table);
    let model = validate::model(&table, &diagnostics);
    let errors = diagnostics.shown_to(table.audience);
    model.ok_or(errors)
}

/// Keys of entries that add to the same entries of a file.
pub(super) const ADDING: [&str; 3] = ["lock", "couple", "allow"];

/// Whether an entry has one of these keys.
fn adds(entry: &Entry) -> bool {
    matches!(
        entry,
        Entry::Lock(_) | Entry::Couple(_) | Entry::Frames(..) | Entry::Allow(_)
    )
}

/// The table of a text with entries beside it. Where the text cannot be read, the entry for the file stands in place of
/// its entries.
fn put_beside(text: &str, format: Format, mut beside: Table, diagnostics: &Diagnostics) -> Table {
    let request = self::request(&beside, diagnostics).unwrap_or_default();
    let used = &mut Vec::new();
    let unread = || Table {
        entries: vec![Entry::File(None)],
        ..Table::default()
    };
    let mut table = read(text, format, &request, used, diagnostics).unwrap_or_else(unread);
    forget_locks(&mut beside.entries, used);
    if let Some((_, place, rows)) = beside::take(&mut beside.entries) {
        let all = || joint_names(text, format);
        beside::put((place, rows), &mut table.entries, all, diagnostics);
    }
    if let Some((_, place, links)) = beside::take_links(&mut beside.entries) {
        beside::put_links((place, links), &mut table.entries, format, diagnostics);
    }
    for (key, place) in &beside.keys {
        if ["convention", "joint"].contains(key) {
            diagnostics.error(*place, mistake::beside_a_file(key));
        }
    }
    beside.entries.retain(|entry| {
        !matches!(
            entry,
            Entry::Chain(_)
                | Entry::Ignore(_)
                | Entry::RoundAngles(_)
                | Entry::Convention(_)
                | Entry::Joints(..)
        )
    });
    let names_are_fields = beside.names_are_fields;
    if format == Format::Urdf {
        // A URDF file has no names: those beside it are the robot's own.
        table.mentions.append(&mut beside.mentions);
    }
    add(&mut table, beside);
    fields::complete(&mut table, names_are_fields);
    table
}

/// The entries of a table that names the file of its robot, with others beside it, as both stand beside that file. An
/// entry that is missing is reported where the file is named.
pub fn joined(mut table: Table, mut beside: Table) -> Table {
    for entry in &table.entries {
        if let (Entry::File(Some(file)), Some(name)) = (entry, &mut table.name) {
            *name = Name::new(name.plain(), file.place);
        }
    }
    table
        .entries
        .retain(|entry| !matches!(entry, Entry::File(_)));
    if let Some((_, place, rows)) = beside::take(&mut beside.entries) {
        let cells = table.entries.iter_mut().find_map(|entry| match entry {
            Entry::Beside(_, cells) => cells.as_mut(),
            _ => None,
        });
        match cells {
            Some(cells) => cells.extend(rows),
            None => table.entries.push(Entry::Beside(place, Some(rows))),
        }
    }
    if let Some((_, place, links)) = beside::take_links(&mut beside.entries) {
        let cells = table.entries.iter_mut().find_map(|entry| match entry {
            Entry::Links(_, cells) => cells.as_mut(),
            _ => None,
        });
        match cells {
            Some(cells) => cells.extend(links),
            None => table.entries.push(Entry::Links(place, Some(links))),
        }
    }
    table.names_are_fields = beside.names_are_fields;
    add(&mut table, beside);
    table
}

/// Adds the entries beside a table to it, or puts them in place of its own.
fn add(table: &mut Table, beside: Table) {
    let (names, entries): (Vec<_>, Vec<_>) = beside
        .entries
        .into_iter()
        .partition(|entry| matches!(entry, Entry::Let(..)));
    bind_first(&mut table.entries, names);
    for entry in entries {
        // The file has the body of a base of which nothing else is said here.
        if is_bare_base(&entry) && table.floating().is_some() {
            continue;
        }
        let same =
            |other: &Entry| core::mem::discriminant(other) == core::mem::discriminant(&entry);
        table.entries.retain(|other| adds(&entry) || !same(other));
        table.entries.push(entry);
    }
    table.keys.extend(beside.keys);
    table.fields.extend(beside.fields);
    table.audience = beside.audience;
    table.needed = beside.needed;
    table.keeps_links = beside.keeps_links;
    table.masses = beside.masses;
}

/// Whether an entry says that the base moves, and nothing of its body.
pub(super) fn is_bare_base(entry: &Entry) -> bool {
    match entry {
        Entry::Base(Some(base)) => base.floating().is_some_and(|(_, body)| !body.is_written()),
        _ => false,
    }
}

/// Puts bindings of names before the entries, in the place of those that bind the same names.
fn bind_first(entries: &mut Vec<Entry>, bindings: Vec<Entry>) {
    let name_of = |entry: &Entry| match entry {
        Entry::Let(name, _) => Some(name.plain().to_owned()),
        _ => None,
    };
    let bound: Vec<_> = bindings.iter().map(name_of).collect();
    entries.retain(|entry| name_of(entry).is_none() || !bound.contains(&name_of(entry)));
    entries.splice(0..0, bindings);
}

/// The request of a call to its file; none where that could not be read.
pub(super) fn request(table: &Table, diagnostics: &Diagnostics) -> Option<Request> {
    let reads_masses = read_masses(table);
    let mut request = Request {
        unphysical_inertia: table.allow().unphysical_inertia || !reads_masses,
        no_inertia: table.allow().no_inertia || !reads_masses,
        may_be_geometry: table.masses == Masses::IfAny,
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
            Entry::Base(Some(base)) => {
                request.base = base.floating().map(|(_, body)| MovingBase {
                    body: body.place(),
                    allow: body.allow.value().copied().unwrap_or_default(),
                });
            }
            Entry::Beside(_, rows) => {
                let allowed = |row: &Row| Some((row.name.clone()?, *row.body.allow.value()?));
                request.allow = rows.iter().flatten().filter_map(allowed).collect();
            }
            Entry::Links(_, links) => {
                let names = links.iter().flatten().map(|(name, _)| name.clone());
                request.links = names.collect();
            }
            Entry::Lock(locked) => {
                let locked = locked.as_ref()?.iter();
                let lock = |locked: &Positioned| {
                    let position = locked.position.as_ref().and_then(constant);
                    (locked.name.clone(), position)
                };
                request.lock.extend(locked.map(lock));
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
pub(super) fn forget_locks(entries: &mut Vec<Entry>, used: &[String]) {
    for entry in entries.iter_mut() {
        if let Entry::Lock(Some(locked)) = entry {
            locked.retain(|locked| !used.iter().any(|name| name == locked.name.plain()));
        }
    }
    entries.retain(|entry| !matches!(entry, Entry::Lock(Some(locked)) if locked.is_empty()));
}

/// The names of all joints in the text of a file, including those that are not part of the arm; empty if it cannot
/// be read.
pub fn joint_names(text: &str, format: Format) -> Vec<String> {
    if format == Format::Urdf {
        let request = Request::default();
        let tree = Diagnostics::without(|diagnostics| urdf::read(text, &request, diagnostics));
        let joints = tree.into_iter().flat_map(|tree| tree.joints);
        return joints.map(|joint| joint.name).collect();
    }
    let table = unjudged(text, format).unwrap_or_default();
    let names = table.rows().iter().filter_map(|row| row.name.as_ref());
    names.map(|name| name.plain().to_owned()).collect()
}

/// The file that a table names as that of its robot.
pub fn file_named(text: &str, format: Format) -> Option<FileName> {
    let table = match format {
        Format::Urdf => None,
        _ => unjudged(text, format),
    };
    table?.entries.into_iter().find_map(|entry| match entry {
        Entry::File(file) => file,
        _ => None,
    })
}

/// The names in the values of the text of a table.
pub fn names_in_values(text: &str, format: Format) -> BTreeSet<String> {
    unjudged(text, format).map_or(BTreeSet::new(), |table| table.mentions)
}

/// The table of a text and its model, if it is a robot by itself: names without a value are fields, and masses may be
/// missing. A file that names another one is none.
pub(crate) fn alone(text: &str, format: Format) -> Option<(Table, Model)> {
    let mut table = unjudged(text, format)?;
    put_name("robot", Place::START, &mut table);
    table.masses = Masses::IfAny;
    fields::complete(&mut table, true);
    let model = Diagnostics::without(|diagnostics| validate::model(&table, diagnostics))?;
    Some((table, model))
}

/// The entries of a text, whatever mistakes are in it.
fn unjudged(text: &str, format: Format) -> Option<Table> {
    let (request, used) = (Request::default(), &mut Vec::new());
    Diagnostics::without(|diagnostics| read(text, format, &request, used, diagnostics))
}

/// The entries of a text; what cannot be read is reported. None of a text of another format.
pub(super) fn read(
    text: &str,
    format: Format,
    request: &Request,
    used: &mut Vec<String>,
    diagnostics: &Diagnostics,
) -> Option<Table> {
    let (root, language) = match format {
        Format::Toml => (toml::document(text, diagnostics), Language::Toml),
        Format::Json => (json::document(text, diagnostics), Language::Json),
        Format::Urdf => {
            let tree = urdf::read(text, request, diagnostics)?;
            return links::table(tree, request, used, diagnostics);
        }
    };
    root.map(|root| crate::read::table(&root, language, diagnostics))
}
