//! Lists of joints with values: `[joint = value, ...]`.

use proc_macro2::Delimiter;

use super::cursor::Cursor;
use super::expression::expression;
use super::files;
use super::list::comma_separated;
use crate::description::{Expr, Name};
use crate::diagnose::Reported;
use crate::mistake::Mistake;
use crate::mistake::expected::Expected;

/// What is said where such a list is wrong.
pub(super) struct Texts {
    /// A list was expected.
    pub(super) list: fn() -> Expected,
    /// A joint's name was expected.
    pub(super) joint: fn() -> Expected,
    /// `=` and a value were expected behind that name.
    pub(super) value: fn(&Name) -> Expected,
    /// The list is empty.
    pub(super) none: fn() -> Mistake,
    /// `joint: value`
    pub(super) by_colon: fn(&Name) -> Mistake,
}

/// Reads such a list. A value that cannot be read leaves its joint in the list.
pub(super) fn assignments(
    cursor: &mut Cursor,
    texts: &Texts,
) -> Result<Vec<(Name, Option<Expr>)>, Reported> {
    let group = cursor.take_list(Delimiter::Bracket, (texts.list)())?;
    let mut inside = cursor.inside(&group);
    if inside.at_end() {
        return Err(cursor.error(group.span(), (texts.none)()));
    }
    let mut read = Vec::new();
    let mut unnamed = None;
    let _ = comma_separated(&mut inside, files::at_name, |cursor| {
        let Some(name) = files::take_name(cursor) else {
            let reported = files::no_name(cursor, (texts.joint)());
            unnamed = Some(reported);
            return Err(reported);
        };
        let what = format!("`{name} = ...`");
        let start = cursor.here();
        let value = match cursor.take_char('=').is_some() {
            true => expression(cursor),
            false if cursor.take_char(':').is_some() => {
                Err(cursor.error(start, (texts.by_colon)(&name)))
            }
            false => Err(cursor.expected((texts.value)(&name))),
        };
        let end = value.as_ref().err().copied();
        read.push((name, value.ok()));
        end.map_or(Ok(what), Err)
    });
    unnamed.map_or(Ok(read), Err)
}
