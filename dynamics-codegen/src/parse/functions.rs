//! `functions: [default, jacobian, control_terms = (mass_matrix, gravity_vector)]`

use dynamics_symbolic::Function;
use proc_macro2::{Delimiter, Ident, TokenTree};

use super::cursor::Cursor;
use super::list::comma_separated;
use super::structure::name;
use super::unknown::unknown;
use crate::description::{Asked, Name};
use crate::diagnose::Reported;
use crate::mistake::{self, expected};
use crate::place::Place;

/// The word for the default set.
pub(crate) const DEFAULT: &str = "default";

/// Reads the list. What is wrong in it leaves the other entries as they are.
pub(super) fn functions(cursor: &mut Cursor) -> Result<Vec<Asked>, Reported> {
    let group = cursor.take_list(Delimiter::Bracket, expected::functions())?;
    let mut inside = cursor.inside(&group);
    if inside.at_end() {
        return Err(cursor.error(group.span(), mistake::entry::no_function()));
    }
    let mut asked = Vec::new();
    let end = comma_separated(&mut inside, at_item, |cursor| {
        let start = cursor.here();
        let (item, what) = item(cursor, start)?;
        asked.push(item.unwrap_or(Asked::Unreadable));
        Ok(what)
    });
    if end.is_err() {
        asked.push(Asked::Unreadable);
    }
    Ok(asked)
}

fn at_item(cursor: &Cursor) -> bool {
    cursor.peek_ident().is_some()
}

/// What one entry of the list asks for, and how a message names it. The outer error is that of what is
/// no entry at all.
fn item(cursor: &mut Cursor, start: Place) -> Result<(Result<Asked, Reported>, String), Reported> {
    if let Some(TokenTree::Group(group)) = cursor.peek()
        && group.delimiter() == Delimiter::Parenthesis
    {
        let shown = cursor.shown_until(&[',', ';']);
        cursor.take();
        let mistake = mistake::entry::tuple_without_name(&shown);
        return Ok((Err(cursor.error(start, mistake)), "the tuple".to_owned()));
    }
    if cursor.at_name_before('=') || cursor.at_key() {
        return fused(cursor);
    }
    let Some(word) = cursor.take_ident() else {
        return Err(cursor.expected(expected::function()));
    };
    let asked = match word == DEFAULT {
        true => Ok(Asked::Default((&word).into())),
        false => {
            let known: Vec<_> = core::iter::once(DEFAULT).chain(names()).collect();
            function(cursor, &word, &known).map(|function| Asked::One(function, (&word).into()))
        }
    };
    Ok((asked, format!("`{word}`")))
}

/// Reads `name = (mass_matrix, gravity_vector)`. What is wrong with the functions leaves the rest of the
/// list as it is.
fn fused(cursor: &mut Cursor) -> Result<(Result<Asked, Reported>, String), Reported> {
    let name = name(cursor, expected::name_of_tuple())?;
    let what = format!("`{name} = (...)`");
    let sign = cursor.here();
    let colon = cursor.take_char(':').is_some();
    if colon {
        cursor.error(sign, mistake::entry::tuple_by_colon(&name));
    } else {
        cursor.take_char('=');
    }
    let group = cursor.take_list(Delimiter::Parenthesis, expected::parts_of(&name))?;
    let mut inside = cursor.inside(&group);
    let mut parts = Vec::new();
    let mut wrong = None;
    let known: Vec<_> = names().collect();
    let end = comma_separated(&mut inside, at_item, |cursor| {
        let Some(word) = cursor.take_ident() else {
            return Err(cursor.expected(expected::function()));
        };
        let part = match word == DEFAULT {
            true => Err(cursor.error(&word, mistake::entry::default_in_tuple())),
            false => function(cursor, &word, &known),
        };
        match part {
            Ok(function) => parts.push((function, (&word).into())),
            Err(reported) => wrong = Some(reported),
        }
        Ok(format!("`{word}`"))
    });
    let asked = wrong.map_or(end, Err);
    let asked = asked.map(|()| Asked::Fused(Name::from(&name), parts));
    Ok((asked, what))
}

/// The names of all functions.
pub(crate) fn names() -> impl Iterator<Item = &'static str> {
    Function::ALL.into_iter().map(Function::name)
}

/// The function of that name; a message about another word lists those that are `known`.
fn function(cursor: &Cursor, name: &Ident, known: &[&'static str]) -> Result<Function, Reported> {
    let word = name.to_string();
    Function::from_name(&word).ok_or_else(|| {
        let wrong = unknown("function", &word, known);
        cursor.error(name, wrong.mistake)
    })
}
