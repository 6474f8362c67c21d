//! The entries of a call: `key: value,` and `let name = value;`.

use dynamics_symbolic::robot::Convention;
use proc_macro2::{Delimiter, Ident};

use super::allow::allow;
use super::assignments::{Texts, assignments};
use super::cursor::Cursor;
use super::expression::{expression, share};
use super::files;
use super::frames;
use super::functions::functions;
use super::list::{Key, colon, end_item, key, skip_docs};
use super::row::joints;
use super::unknown::unknown;
use super::vector::gravity;
use crate::description::{Allow, Coupled, Entry, Joints, Locked, Name};
use crate::diagnose::Reported;
use crate::mistake::{self, Mistake, expected};
use crate::place::Place;
use crate::words;

/// The keys of the table.
const KEYS: [&str; 15] = [
    "file",
    "chain",
    "ignore",
    "round_angles",
    "convention",
    "gravity",
    "base",
    "joints",
    "couple",
    "tool",
    "functions",
    "lock",
    "neglect",
    "tests",
    "allow",
];

/// Keys, and where they stand.
type Keys = Vec<(&'static str, Place)>;

/// Reads all entries; the keys that stand in front of them too.
pub(super) fn entries(cursor: &mut Cursor) -> (Vec<Entry>, Keys) {
    let mut entries = Vec::new();
    let mut seen = Vec::new();
    while !cursor.at_end() {
        let start = cursor.taken();
        let docs = skip_docs(cursor);
        if at_struct(cursor) {
            second_struct(cursor);
            break;
        }
        let end = docs.and_then(|()| match cursor.take_word("let") {
            Some(_) => binding(cursor, &mut entries).map(|what| (';', what)),
            None if at_constant(cursor) => constant(cursor, &mut entries).map(|what| (';', what)),
            None if at_bare_binding(cursor) => {
                cursor.expected(expected::let_in_front());
                binding(cursor, &mut entries).map(|what| (';', what))
            }
            None => keyed(cursor, &mut seen, &mut entries).map(|what| (',', what)),
        });
        match end {
            Ok((separator, what)) => end_item(cursor, separator, &what, at_entry),
            Err(_) => cursor.recover(start),
        }
    }
    (entries, seen)
}

/// Whether another struct comes next.
fn at_struct(cursor: &Cursor) -> bool {
    ["pub", "struct"].iter().any(|word| cursor.at_word(word)) && !cursor.at_key()
}

/// Reports another struct and skips it with its table.
fn second_struct(cursor: &mut Cursor) {
    cursor.error(cursor.here(), mistake::structure::second());
    while cursor.take().is_some() {}
}

/// Skips what stands in front of the first entry.
pub(super) fn skip_to_entry(cursor: &mut Cursor) {
    while !cursor.at_end() && !at_entry(cursor) {
        cursor.take();
    }
}

/// Whether `name = ` comes next, where the name is not one of the keys.
fn at_bare_binding(cursor: &Cursor) -> bool {
    let is_key = |word: Ident| words::nearest(&word.to_string(), &KEYS).is_some();
    cursor.at_name_before('=') && !cursor.peek_ident().is_some_and(is_key)
}

/// Whether a Rust constant comes next.
fn at_constant(cursor: &Cursor) -> bool {
    let is_constant = |word: Ident| word == "const" || word == "static";
    cursor.peek_ident().is_some_and(is_constant) && !cursor.at_key()
}

fn at_entry(cursor: &Cursor) -> bool {
    cursor.at_key() || cursor.at_word("let") || at_constant(cursor)
}

/// Reads `const NAME: type = value`, which is refused, as the `let` that was meant.
fn constant(cursor: &mut Cursor, entries: &mut Vec<Entry>) -> Result<String, Reported> {
    let start = cursor.here();
    cursor.take();
    cursor.take_word("mut");
    let Some(name) = cursor.take_ident() else {
        return Err(cursor.expected(expected::name_of_constant()));
    };
    let place = start.to(&name);
    if cursor.at(':') {
        cursor.take_until(&['=', ';', ',']);
    }
    let has_value = cursor.take_char('=').is_some();
    let shown = has_value.then(|| cursor.shown_until(&[';', ',']));
    let reported = cursor.error(place, mistake::value::constant(&name, shown.as_deref()));
    let value = has_value.then(|| expression(cursor).ok()).flatten();
    entries.push(Entry::Let(Name::from(&name), value));
    Err(reported)
}

/// Reads `name = value`, behind `let`.
fn binding(cursor: &mut Cursor, entries: &mut Vec<Entry>) -> Result<String, Reported> {
    if let Some(word) = cursor.take_word("mut") {
        cursor.error(&word, mistake::value::let_mut());
    }
    let Some(name) = cursor.take_ident() else {
        return Err(cursor.expected(expected::name_after_let()));
    };
    let what = format!("`let {name} = ...`");
    let value = match cursor.take_char('=') {
        Some(_) => expression(cursor),
        None => Err(cursor.expected(expected::equals_after_let(&name))),
    };
    match value {
        Ok(value) => {
            entries.push(Entry::Let(Name::from(&name), Some(value)));
            Ok(what)
        }
        Err(reported) => {
            // The name is known from here on, though not its value.
            entries.push(Entry::Let(Name::from(&name), None));
            Err(reported)
        }
    }
}

/// Reads `key: value`. The second entry with one key is read for its errors, then
/// dropped.
fn keyed(
    cursor: &mut Cursor,
    seen: &mut Keys,
    entries: &mut Vec<Entry>,
) -> Result<String, Reported> {
    let unknown = |word: &str| unknown("key", word, &KEYS);
    let key = key(cursor, "key", &KEYS, unknown)?;
    let twice = seen.iter().any(|(name, _)| *name == key.name);
    if twice {
        key.twice(cursor);
    }
    seen.push((key.name, Place::from(&key.ident)));
    let (entry, end) = value(cursor, &key);
    if !twice {
        entries.push(entry);
    }
    end.map(|()| format!("`{}`", key.ident))
}

/// Reads `: value` of that key; what cannot be read leaves an entry without value.
fn value(cursor: &mut Cursor, key: &Key) -> (Entry, Result<(), Reported>) {
    let colon = colon(cursor, &key.ident.to_string());
    let start = cursor.here();
    match key.name {
        "convention" => split(colon.and_then(|()| convention(cursor)), Entry::Convention),
        "gravity" => split(colon.and_then(|()| gravity(cursor)), Entry::Gravity),
        "base" => split(colon.and_then(|()| frames::base(cursor)), |base| {
            Entry::Base(base.map(Box::new))
        }),
        "joints" => split(colon.and_then(|()| table(cursor)), |joints| {
            Entry::Joints(start, joints)
        }),
        "tool" => split(colon.and_then(|()| frames::tool(cursor)), |tool| {
            Entry::Tool(tool.map(Box::new))
        }),
        "functions" => split(colon.and_then(|()| functions(cursor)), Entry::Functions),
        "lock" => split(colon.and_then(|()| lock(cursor)), Entry::Lock),
        "file" => split(colon.and_then(|()| files::name(cursor)), Entry::File),
        "chain" => split(colon.and_then(|()| files::chain(cursor)), Entry::Chain),
        "ignore" => split(colon.and_then(|()| files::ignored(cursor)), Entry::Ignore),
        "round_angles" => split(colon.and_then(|()| expression(cursor)), Entry::RoundAngles),
        "couple" => split(colon.and_then(|()| couple(cursor)), Entry::Couple),
        "neglect" => split(colon.and_then(|()| share(cursor)), Entry::Neglect),
        "allow" => split(
            colon.and_then(|()| allow(cursor, &Allow::WORDS)),
            Entry::Allow,
        ),
        _ => split(colon.and_then(|()| truth(cursor)), |truth| {
            Entry::Tests(start, truth)
        }),
    }
}

fn table(cursor: &mut Cursor) -> Result<Joints, Reported> {
    let group = cursor.take_list(Delimiter::Bracket, expected::rows())?;
    Ok(joints(cursor.inside(&group)))
}

fn split<T>(
    value: Result<T, Reported>,
    entry: impl FnOnce(Option<T>) -> Entry,
) -> (Entry, Result<(), Reported>) {
    match value {
        Ok(value) => (entry(Some(value)), Ok(())),
        Err(reported) => (entry(None), Err(reported)),
    }
}

fn convention(cursor: &mut Cursor) -> Result<Convention, Reported> {
    const KNOWN: [&str; 2] = ["standard", "modified"];
    let unknown = |word: &str| match words::meant(word, &KNOWN) {
        None => mistake::entry::unknown_convention(word),
        Some(_) => unknown("convention", word, &KNOWN).mistake,
    };
    Ok(match choice(cursor, &KNOWN, unknown)? == "standard" {
        true => Convention::Standard,
        false => Convention::Modified,
    })
}

fn truth(cursor: &mut Cursor) -> Result<bool, Reported> {
    const KNOWN: [&str; 2] = ["true", "false"];
    let unknown = |word: &str| unknown("value", word, &KNOWN).mistake;
    Ok(choice(cursor, &KNOWN, unknown)? == "true")
}

/// Takes one of the words; `unknown` is what to say of another one.
fn choice(
    cursor: &mut Cursor,
    known: &[&str],
    unknown: impl Fn(&str) -> Mistake,
) -> Result<Ident, Reported> {
    let Some(ident) = cursor.take_ident() else {
        return Err(cursor.expected(expected::one_of(known)));
    };
    if known.iter().any(|word| ident == word) {
        return Ok(ident);
    }
    let mistake = unknown(&ident.to_string());
    Err(cursor.error(&ident, mistake))
}

/// Reads `[elbow = 0.3, ...]`. A position that cannot be read leaves the joint locked all the same.
fn lock(cursor: &mut Cursor) -> Result<Vec<Locked>, Reported> {
    let texts = Texts {
        list: expected::locks,
        joint: expected::locked_joint,
        value: expected::position_after,
        none: mistake::entry::no_lock,
        by_colon: mistake::entry::lock_by_colon,
    };
    let locked = assignments(cursor, &texts)?.into_iter();
    let locked = locked.map(|(name, position)| Locked { name, position });
    Ok(locked.collect())
}

/// Reads `[finger_2 = -finger_1 + 0.02, ...]`.
fn couple(cursor: &mut Cursor) -> Result<Vec<Coupled>, Reported> {
    let texts = Texts {
        list: expected::couplings,
        joint: expected::follower,
        value: expected::leader_after,
        none: mistake::couple::none,
        by_colon: mistake::couple::by_colon,
    };
    let coupled = assignments(cursor, &texts)?.into_iter();
    let coupled = coupled.map(|(follower, position)| Coupled { follower, position });
    Ok(coupled.collect())
}
