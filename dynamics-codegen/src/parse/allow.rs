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
            allow.note(&word);
        } else {
            let mistake = match Allow::WORDS.contains(&word.as_str()) {
                true => mistake::entry::allowed_for_the_table(&word),
                false => unknown("allowance", &word, known).mistake,
            };
            wrong = Some(cursor.error(&ident, mistake));
        }
        Ok(format!("`{word}`"))
    });
    wrong.map_or(end.map(|()| allow), Err)
}
