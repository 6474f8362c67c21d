//! The tree that a call or a file becomes before its words have a meaning: words, values and groups of them, and where
//! each stands.

use proc_macro2::TokenTree;

use crate::description::{Expr, Name, Share};
use crate::mistake::Mistake;
use crate::place::Place;
use crate::words::shortened;

/// A language in which robots are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(not(feature = "files"), allow(dead_code))]
pub(crate) enum Language {
    /// A call of the macro.
    Call,
    Toml,
    Json,
}

/// A mistake, and where it is.
pub(crate) type Fault = (Place, Mistake);

/// A value.
#[derive(Clone, Debug)]
pub(crate) struct Node {
    pub(crate) place: Place,
    pub(crate) kind: Kind,
    pub(crate) found: Found,
    /// Mistakes in front of it and in its delimiters.
    pub(crate) faults: Vec<Fault>,
    /// Mistakes between it and the next item. A value that cannot be read is mistake enough.
    pub(crate) behind: Vec<Fault>,
}

/// The thing that a message says is there.
#[derive(Clone, Debug)]
pub(crate) enum Found {
    /// The first word or number of a value in a call.
    Token(TokenTree),
    /// The first sign, or the kind of a value in a file.
    Sign(&'static str),
    /// Nothing: the tokens of a call end.
    Nothing,
}

impl Found {
    /// As a message shows it.
    pub(crate) fn shown(&self) -> Option<String> {
        match self {
            Found::Token(token) => Some(format!("`{}`", shortened(&token.to_string()))),
            Found::Sign(sign) => Some((*sign).to_owned()),
            Found::Nothing => None,
        }
    }
}

/// The kinds of value.
#[derive(Clone, Debug)]
#[cfg_attr(not(feature = "files"), allow(dead_code))]
pub(crate) enum Kind {
    Table(Vec<(Key, Node)>),
    List(Vec<Node>),
    /// Letters in quotes.
    Text(String),
    /// A number of a file as it is written, without the `_` between its digits.
    Number(String),
    /// A truth value of a file.
    Truth(bool),
    /// A value of a file that says nothing about a robot, as a message names it.
    Other(&'static str),
    /// A word of a call.
    Word(Name),
    /// A value of a call that is more than a word.
    Value(Expr),
    /// `1%`
    Share(Share),
    /// `name(arguments)` where the name is that of no function of numbers, and the mistakes of it as a value.
    Applied(Name, Box<Node>, Vec<Fault>),
    /// `name = value` in a list.
    Pair(Key, Box<Node>),
    /// The rows of a call, and whether all of them could be recognised.
    Rows(Vec<Node>, bool),
    /// A row of a call: its name, its type and its cells.
    Row(Option<Name>, Option<Box<Node>>, Box<Node>),
    /// Tokens that make no value, and why.
    Unreadable(Vec<Fault>),
    /// No value at all: `faults` say why.
    Absent,
}

/// The word in front of a value.
#[derive(Clone, Debug)]
pub(crate) struct Key {
    /// The word; of what is none, how a message shows it.
    pub(crate) word: String,
    pub(crate) place: Place,
    pub(crate) kind: KeyKind,
}

/// The kinds of thing in front of a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum KeyKind {
    Word,
    /// A name behind `let` in a call.
    Let,
    /// Something else where a word should be.
    Stray,
}

impl Key {
    /// A word that stands for the one that is written at that place.
    pub(crate) fn new(word: impl Into<String>, place: Place) -> Key {
        Key {
            word: word.into(),
            place,
            kind: KeyKind::Word,
        }
    }
}

impl Node {
    /// A value of a file.
    #[cfg(feature = "files")]
    pub(crate) fn new(place: Place, kind: Kind) -> Node {
        let found = match kind {
            Kind::Table(_) => "a table",
            Kind::List(_) => "an array",
            Kind::Text(_) => "a string",
            Kind::Number(_) => "a number",
            Kind::Truth(_) => "a truth value",
            Kind::Other(what) => what,
            _ => "a value",
        };
        Node::found(place, Found::Sign(found), kind)
    }

    /// A value without mistakes around it.
    pub(crate) fn found(place: Place, found: Found, kind: Kind) -> Node {
        Node {
            place,
            kind,
            found,
            faults: Vec::new(),
            behind: Vec::new(),
        }
    }

    /// The items of a table.
    #[cfg(feature = "files")]
    pub(crate) fn items_mut(&mut self) -> Option<&mut Vec<(Key, Node)>> {
        match &mut self.kind {
            Kind::Table(items) => Some(items),
            _ => None,
        }
    }

    /// The word that it is, be it in quotes.
    pub(crate) fn word(&self) -> Option<&str> {
        match &self.kind {
            Kind::Word(name) => Some(name.plain()),
            Kind::Text(text) => Some(text),
            _ => None,
        }
    }

    /// Whether it is known where the value ends.
    pub(crate) fn has_end(&self) -> bool {
        match &self.kind {
            Kind::Pair(_, value) | Kind::Row(_, _, value) => value.has_end(),
            Kind::Unreadable(_) | Kind::Absent => false,
            _ => true,
        }
    }

    /// Puts all of it at one place, that of the text that it was read from.
    #[cfg(feature = "files")]
    pub(crate) fn put(&mut self, place: Place) {
        self.place = place;
        let faults = self.faults.iter_mut().chain(&mut self.behind);
        faults.for_each(|(at, _)| *at = place);
        match &mut self.kind {
            Kind::List(items) => items.iter_mut().for_each(|item| item.put(place)),
            Kind::Word(name) => *name = Name::new(name.to_string(), place),
            Kind::Value(value) => value.put(place),
            Kind::Share(share) => {
                share.place = place;
                share.number.put(place);
            }
            Kind::Applied(name, sizes, faults) => {
                *name = Name::new(name.to_string(), place);
                sizes.put(place);
                faults.iter_mut().for_each(|(at, _)| *at = place);
            }
            Kind::Pair(key, value) => {
                key.place = place;
                value.put(place);
            }
            Kind::Unreadable(faults) => faults.iter_mut().for_each(|(at, _)| *at = place),
            _ => {}
        }
    }
}

/// The lines of a text.
#[cfg(feature = "files")]
pub(crate) struct Lines<'t> {
    text: &'t str,
    starts: Vec<usize>,
    /// Whether each letter is a byte: columns of a file that is one long line are not counted then.
    is_ascii: bool,
}

#[cfg(feature = "files")]
impl<'t> Lines<'t> {
    pub(crate) fn new(text: &'t str) -> Lines<'t> {
        let breaks = text.match_indices('\n').map(|(at, _)| at + 1);
        Lines {
            text,
            starts: core::iter::once(0).chain(breaks).collect(),
            is_ascii: text.is_ascii(),
        }
    }

    /// The place of the letter behind so many bytes.
    pub(crate) fn place(&self, offset: usize) -> Place {
        let offset = offset.min(self.text.len());
        let line = self.starts.partition_point(|start| *start <= offset);
        let start = self.starts[line - 1];
        let before = self.text.as_bytes()[start..offset].iter();
        // A letter of several bytes is one column: the bytes behind its first one start with the bits 10.
        let letters = match self.is_ascii {
            true => before.len(),
            false => before.filter(|byte| *byte & 0xc0 != 0x80).count(),
        };
        Place::File {
            line,
            column: 1 + letters,
        }
    }
}

#[cfg(all(test, feature = "files"))]
mod tests {
    use super::*;

    #[test]
    fn letters_are_counted_in_their_line() {
        let lines = Lines::new("a\nbü = 1\n");
        for (offset, expected) in [(0, (1, 1)), (2, (2, 1)), (5, (2, 3)), (99, (3, 1))] {
            assert_eq!(lines.place(offset).position(), expected, "{offset}");
        }
        let lines = Lines::new("a\nbu = 1\n");
        for (offset, expected) in [(0, (1, 1)), (2, (2, 1)), (5, (2, 4)), (99, (3, 1))] {
            assert_eq!(lines.place(offset).position(), expected, "{offset}");
        }
    }
}
