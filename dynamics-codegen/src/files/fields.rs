//! The symbolic parameters of a file: the names that it lists, or those in its values that nothing binds.

use crate::description::{Entry, Name, Place, Table};
use crate::validate::free_names;
use crate::words;

/// Adds the names that the file lists, except for those that have a value; if it lists none, and they are
/// to be fields, the names that nothing binds.
pub(super) fn complete(table: &mut Table, names_are_fields: bool) {
    match table.listed_fields().map(<[Name]>::to_vec) {
        Some(names) => {
            let names = names.into_iter();
            let free = names.filter(|name| !has_meaning(table, name));
            let free =
                free.map(|name| Name::new(&*as_identifier(name.plain()), Place::from(&name)));
            let free: Vec<_> = free.collect();
            table.fields.extend(free);
        }
        None if names_are_fields => {
            let place = Place::START;
            let names = free_names(table).into_iter();
            // A name beside the file is meant for one of the file's.
            let names = names.filter(|name| table.mentions.contains(name));
            let names = names.map(|name| Name::new(&*as_identifier(&name), place));
            let names: Vec<_> = names.collect();
            table.fields.extend(names);
        }
        None => {}
    }
}

/// Whether the name is that of a field or has a value already.
fn has_meaning(table: &Table, name: &Name) -> bool {
    let is_same = |other: &Name| other.plain() == name.plain();
    let is_bound = |entry: &Entry| matches!(entry, Entry::Let(other, _) if is_same(other));
    table.fields.iter().any(is_same) || table.entries.iter().any(is_bound)
}

/// The name as an identifier of Rust: `type` as `r#type`.
fn as_identifier(name: &str) -> String {
    if words::is_name(name) {
        name.to_owned()
    } else {
        format!("r#{name}")
    }
}
