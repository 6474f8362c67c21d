//! The rows of the table: `[name: revolute { cells }, ...]`.

use std::cell::Cell;

use proc_macro2::{Delimiter, Ident};

use super::assigned::{at_cells, named_tables};
use super::cursor::Cursor;
use super::list::{colon, comma_separated};
use super::value::{absent, table};
use crate::description::Name;
use crate::diagnose::Reported;
use crate::keys::JOINT_TYPES;
use crate::mistake::{self, expected};
use crate::place::Place;
use crate::tree::{Kind, Node};

/// Reads the rows. One that holds a mistake is returned all the same: it counts, unless
/// it cannot be told where it ends. Braces hold cells for the joints of a file.
pub(super) fn rows(cursor: &mut Cursor) -> Node {
    let start = absent(cursor);
    if at_cells(cursor) {
        return named_tables(cursor, expected::joint_of_file);
    }
    let errors = cursor.errors();
    let Ok(group) = cursor.take_list(Delimiter::Bracket, expected::rows()) else {
        let kind = Kind::Unreadable(cursor.take_errors(errors));
        return Node { kind, ..start };
    };
    let faults = cursor.take_errors(errors);
    let complete = Cell::new(true);
    // Tokens behind a missing comma that are no row are skipped.
    let at_row = |cursor: &Cursor| {
        let at_row = cursor.at_key();
        complete.set(complete.get() && at_row);
        at_row
    };
    let rows = comma_separated(cursor.inside(&group), at_row, |cursor| {
        let start = absent(cursor);
        if cursor.at(',') {
            cursor.expected(expected::joint());
            return (start, String::new());
        }
        let mut row = Row {
            name: None,
            joint_type: None,
            cells: absent(cursor),
        };
        let end = row.read(cursor);
        let at_end = cursor.at_end() || cursor.at(',');
        complete.set(complete.get() && (end.is_ok() || at_end));
        let kind = Kind::Row(row.name, row.joint_type.map(Box::new), Box::new(row.cells));
        (Node { kind, ..start }, end.unwrap_or_default())
    });
    Node {
        kind: Kind::Rows(rows, complete.get()),
        faults,
        ..start
    }
}

struct Row {
    name: Option<Name>,
    joint_type: Option<Node>,
    cells: Node,
}

impl Row {
    /// Reads `name: revolute { cells }`. Returns how a message names the row.
    fn read(&mut self, cursor: &mut Cursor) -> Result<String, Reported> {
        let Some(name) = cursor.take_ident() else {
            return Err(cursor.expected(expected::joint()));
        };
        if let Some(group) = cursor.take_group(Delimiter::Parenthesis) {
            let place = Place::from(&name).to(group.span);
            return Err(cursor.error(place, mistake::joint::in_parentheses()));
        }
        let name = behind_extra_word(cursor, name);
        if name == "_" {
            cursor.error(&name, mistake::joint::unnamed());
        }
        let label = format!("joint `{name}`");
        let cells = cursor.take_group(Delimiter::Brace);
        let is_type = cells.is_some() && JOINT_TYPES.iter().any(|word| name == word);
        if name != "_" && !is_type {
            self.name = Some(Name::from(&name));
        }
        let cells = match cells {
            Some(cells) if is_type => {
                cursor.error(&name, mistake::joint::without_name(&name));
                cells
            }
            Some(cells) => {
                cursor.error(&name, mistake::joint::without_type(&name));
                cells
            }
            None => {
                colon(cursor, &name.to_string())?;
                self.read_type(cursor, &name);
                cursor.take_list(Delimiter::Brace, expected::cells(&label))?
            }
        };
        self.cells.kind = Kind::Table(table(cursor.inside(&cells), "the cell "));
        Ok(label)
    }

    /// Reads the joint's type. Without one, reading goes on at the cells.
    fn read_type(&mut self, cursor: &mut Cursor, name: &Ident) {
        let start = absent(cursor);
        match cursor.take_ident() {
            Some(word) => {
                let kind = Kind::Word(Name::from(&word));
                self.joint_type = Some(Node { kind, ..start });
            }
            None => {
                cursor.expected(expected::joint_type(name, JOINT_TYPES));
            }
        }
    }
}

/// Reports a word in front of a row's name. Returns the name.
fn behind_extra_word(cursor: &mut Cursor, word: Ident) -> Ident {
    match cursor.at_key().then(|| cursor.take_ident()).flatten() {
        Some(name) => {
            cursor.error(&word, mistake::joint::extra_word(&name));
            name
        }
        None => word,
    }
}
