//! `[odd_angle, ...]`: what is accepted, odd as it is.

use proc_macro2::Delimiter;

use super::cursor::Cursor;
use super::list::comma_separated;
use super::unknown::unknown;
use crate::description::Allow;
use crate::diagnose::Reported;
use crate::mistake::{self, expected};

/// What a row or the tool may allow.
pub(crate) const OF_BODY: [&str; 4] = ["odd_angle", "odd_com", "odd_mass", "unphysical_inertia"];

/// What `allow` of the whole table may hold.
pub const OF_TABLE: [&str; 7] = [
    "no_inertia",
    "odd_angle",
    "odd_com",
    "odd_gravity",
    "odd_limits",
    "odd_mass",
    "unphysical_inertia",
];

/// Reads `[odd_angle, ...]`, words of those known. A wrong word leaves it unknown what was to be allowed.
pub(super) fn allow(cursor: &mut Cursor, known: &[&'static str]) -> Result<Allow, Reported> {
    let group = cursor.take_list(Delimiter::Bracket, expected::allowances(known))?;
    let mut allow = Allow::default();
    let mut wrong = None;
    let at_word = |cursor: &Cursor| cursor.peek_ident().is_some();
    let end = comma_separated(&mut cursor.inside(&group), at_word, |cursor| {
        let Some(ident) = cursor.take_ident() else {
            return Err(cursor.expected(expected::one_of(known)));
        };
        let word = ident.to_string();
        if known.contains(&word.as_str()) {
            note(&mut allow, &word);
        } else {
            let mistake = match OF_TABLE.contains(&word.as_str()) {
                true => mistake::entry::allowed_for_the_table(&word),
                false => unknown("allowance", &word, known).mistake,
            };
            wrong = Some(cursor.error(&ident, mistake));
        }
        Ok(format!("`{word}`"))
    });
    wrong.map_or(end.map(|()| allow), Err)
}

/// Notes a word of [`OF_TABLE`].
pub(crate) fn note(allow: &mut Allow, word: &str) {
    match word {
        "no_inertia" => allow.no_inertia = true,
        "odd_angle" => allow.odd_angle = true,
        "odd_com" => allow.odd_com = true,
        "odd_gravity" => allow.odd_gravity = true,
        "odd_limits" => allow.odd_limits = true,
        "odd_mass" => allow.odd_mass = true,
        _ => allow.unphysical_inertia = true,
    }
}
