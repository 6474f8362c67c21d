//! `[x, y, z]` and the arguments of a solid.

use proc_macro2::Delimiter;

use super::cursor::{Cursor, Group};
use super::expression::{at_value, expression};
use super::list::comma_separated;
use crate::description::{Expr, Limits, Vector};
use crate::diagnose::Reported;
use crate::mistake;
use crate::mistake::expected::{self, Expected};

/// Reads `[x, y, z]`.
pub(super) fn vector(cursor: &mut Cursor) -> Result<Vector, Reported> {
    array(cursor, XYZ, expected::array(XYZ))
}

/// Reads `[x, y, z]` of gravity.
pub(super) fn gravity(cursor: &mut Cursor) -> Result<Vector, Reported> {
    array(cursor, XYZ, expected::gravity(XYZ))
}

/// How a message shows the components of a vector.
const XYZ: &str = "[x, y, z]";

/// Reads `[roll, pitch, yaw]`.
pub(super) fn angles(cursor: &mut Cursor) -> Result<Vector, Reported> {
    let shown = "[roll, pitch, yaw]";
    array(cursor, shown, expected::array(shown))
}

/// Reads `[lower, upper]`.
pub(super) fn limits(cursor: &mut Cursor) -> Result<Limits, Reported> {
    let shown = "[lower, upper]";
    array(cursor, shown, expected::array(shown))
}

/// Reads N values in brackets, of which `shown` is an example, where `what` is expected.
fn array<const N: usize>(
    cursor: &mut Cursor,
    shown: &str,
    what: Expected,
) -> Result<[Option<Expr>; N], Reported> {
    let group = cursor
        .take_group(Delimiter::Bracket)
        .ok_or_else(|| cursor.expected(what))?;
    let mut values = values(cursor, &group, N, shown)?.into_iter();
    Ok(std::array::from_fn(|_| values.next().flatten()))
}

/// Reads that many values between commas; `None` stands for one that could not be
/// read. `shown` is how a message shows the list.
fn values<'t>(
    cursor: &Cursor<'t>,
    group: &Group<'t>,
    number: usize,
    shown: &str,
) -> Result<Vec<Option<Expr>>, Reported> {
    values_and(cursor, group, number, shown, |_| None)
}

/// Likewise, between items that are no values: `other` reads them.
pub(super) fn values_and<'t>(
    cursor: &Cursor<'t>,
    group: &Group<'t>,
    number: usize,
    shown: &str,
    mut other: impl FnMut(&mut Cursor<'t>) -> Option<Result<String, Reported>>,
) -> Result<Vec<Option<Expr>>, Reported> {
    let mut values = Vec::new();
    let outcome = comma_separated(&mut cursor.inside(group), at_value, |cursor| {
        if let Some(item) = other(cursor) {
            return item;
        }
        let value = expression(cursor);
        let end = value.as_ref().err().copied();
        values.push(value.ok());
        end.map_or(Ok("this value".to_owned()), Err)
    });
    if values.len() == number {
        return Ok(values);
    }
    outcome?;
    let mistake = mistake::value::other_count(shown, values.len());
    Err(cursor.error(group.span(), mistake))
}
