//! What a file holds, whatever its format: words, numbers as they are written, and where all of it stands.

use crate::place::Place;

/// A value of a file.
#[derive(Clone, Debug)]
pub(super) struct Node {
    pub(super) place: Place,
    pub(super) kind: Kind,
}

/// The kinds of value.
#[derive(Clone, Debug)]
pub(super) enum Kind {
    Table(Vec<(Key, Node)>),
    List(Vec<Node>),
    Text(String),
    /// A number as it is written, without the `_` between its digits.
    Number(String),
    Truth(bool),
    /// Something that says nothing about a robot, as a message names it.
    Other(&'static str),
}

/// The word in front of a value.
#[derive(Clone, Debug)]
pub(super) struct Key {
    pub(super) word: String,
    pub(super) place: Place,
}

impl Key {
    /// A word that stands for the one that is written at that place.
    pub(super) fn new(word: impl Into<String>, place: Place) -> Key {
        Key {
            word: word.into(),
            place,
        }
    }
}

impl Node {
    /// The value as a message names it.
    pub(super) fn found(&self) -> &'static str {
        match self.kind {
            Kind::Table(_) => "a table",
            Kind::List(_) => "an array",
            Kind::Text(_) => "a string",
            Kind::Number(_) => "a number",
            Kind::Truth(_) => "a truth value",
            Kind::Other(what) => what,
        }
    }

    /// The items of a table.
    pub(super) fn items_mut(&mut self) -> Option<&mut Vec<(Key, Node)>> {
        match &mut self.kind {
            Kind::Table(items) => Some(items),
            _ => None,
        }
    }
}

/// The lines of a text.
pub(super) struct Lines<'t> {
    text: &'t str,
    starts: Vec<usize>,
}

impl<'t> Lines<'t> {
    pub(super) fn new(text: &'t str) -> Lines<'t> {
        let breaks = text.match_indices('\n').map(|(at, _)| at + 1);
        Lines {
            text,
            starts: core::iter::once(0).chain(breaks).collect(),
        }
    }

    /// The place of the letter behind so many bytes.
    pub(super) fn place(&self, offset: usize) -> Place {
        let offset = offset.min(self.text.len());
        let line = self.starts.partition_point(|start| *start <= offset);
        let start = self.starts[line - 1];
        let before = self.text.as_bytes()[start..offset].iter();
        // A letter of several bytes is one column: the bytes behind its first one start with the bits 10.
        let column = 1 + before.filter(|byte| *byte & 0xc0 != 0x80).count();
        Place::File { line, column }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_are_counted_in_their_line() {
        let lines = Lines::new("a\nbü = 1\n");
        for (offset, expected) in [(0, (1, 1)), (2, (2, 1)), (5, (2, 3)), (99, (3, 1))] {
            assert_eq!(lines.place(offset).position(), expected, "{offset}");
        }
    }
}
