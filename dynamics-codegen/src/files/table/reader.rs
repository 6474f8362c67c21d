//! The parts of which a table in a file is made: items with keys, names, values and words.

use std::collections::BTreeSet;

use super::super::Format;
use super::super::signed::signed;
use super::super::tree::{Key, Kind, Node};
use crate::description::{Allow, Expr, Given, Name};
use crate::diagnose::{Diagnostics, Reported};
use crate::limits::MOST_LETTERS;
use crate::mistake::{self, Mistake, file as wrong, size};
use crate::parse::number;
use crate::parse::text::{self, At};
use crate::parse::unknown::{Wrong, unknown};
use crate::place::Place;
use crate::words;

pub(super) struct Reader<'d> {
    /// What it is read from: messages are in its words.
    pub(super) format: Format,
    pub(super) diagnostics: &'d Diagnostics,
    pub(super) mentions: BTreeSet<String>,
}

/// The items of a table that could be recognised.
pub(super) struct Items<'n> {
    pub(super) read: Vec<Item<'n>>,
    /// Whether there were others.
    pub(super) incomplete: bool,
}

/// `key = value`
pub(super) struct Item<'n> {
    /// The right word.
    pub(super) name: &'static str,
    pub(super) place: Place,
    pub(super) node: &'n Node,
    /// Whether another word stands there, which was reported.
    is_guess: bool,
}

pub(super) type Read<T> = Result<T, Reported>;

/// What was read, in its cell.
pub(super) fn given<T>(value: Read<T>) -> Given<T> {
    value.map_or(Given::Unreadable, Given::As)
}

impl Reader<'_> {
    pub(super) fn is_json(&self) -> bool {
        self.format == Format::Json
    }

    pub(super) fn error(&self, at: impl Into<Place>, mistake: Mistake) -> Reported {
        self.diagnostics.error(at, mistake)
    }

    pub(super) fn instead_of(&self, what: &str, node: &Node) -> Reported {
        self.error(node.place, wrong::other_kind(what, node.found()))
    }

    /// The items of a table with those words; `unknown` says what is wrong with another one.
    pub(super) fn items<'n>(
        &self,
        node: &'n Node,
        what: &str,
        known: &[&'static str],
        unknown: impl Fn(&str) -> Wrong,
    ) -> Read<Items<'n>> {
        let Kind::Table(items) = &node.kind else {
            let mistake = wrong::no_table(what, known, node.found());
            return Err(self.error(node.place, mistake));
        };
        let mut read: Vec<Item> = Vec::new();
        let mut incomplete = false;
        for (key, node) in items {
            let right = known.iter().find(|name| **name == key.word).copied();
            let name = right.or_else(|| {
                let wrong = unknown(&key.word);
                self.error(key.place, wrong.mistake);
                incomplete = true;
                wrong.meant
            });
            let Some(name) = name else {
                continue;
            };
            let item = Item {
                name,
                place: key.place,
                node,
                is_guess: right.is_none(),
            };
            match read.iter_mut().find(|item| item.name == name) {
                None => read.push(item),
                Some(_) if right.is_none() => {}
                Some(guess) if guess.is_guess => *guess = item,
                Some(_) => {
                    self.error(key.place, mistake::given_twice(&key.word));
                }
            }
        }
        Ok(Items { read, incomplete })
    }

    /// The items of the part of that name, of which no word is at home elsewhere.
    pub(super) fn part<'n>(
        &self,
        node: &'n Node,
        what: &str,
        known: &[&'static str],
    ) -> Read<Items<'n>> {
        let kind = format!("{what} entry");
        self.items(node, &format!("`{what}`"), known, |word| {
            unknown(&kind, word, known)
        })
    }

    /// A name that expressions or generated code have.
    pub(super) fn rust_name(&self, what: &str, key: &Key) -> Read<Name> {
        match words::is_name(&key.word) {
            true => self.name(&key.word, key.place),
            false => Err(self.error(key.place, wrong::no_name(what, &key.word))),
        }
    }

    pub(super) fn name(&self, word: &str, place: Place) -> Read<Name> {
        if word.chars().any(char::is_control) {
            return Err(self.error(place, wrong::control_in_name(word)));
        }
        match word.len() > MOST_LETTERS {
            true => Err(self.error(place, size::name(word))),
            false => Ok(Name::new(word, place)),
        }
    }

    pub(super) fn at(&mut self, place: Place) -> At<'_> {
        At {
            place,
            diagnostics: self.diagnostics,
            mentions: &mut self.mentions,
        }
    }

    /// A number, or a string with an expression.
    pub(super) fn value(&mut self, node: &Node) -> Read<Expr> {
        match &node.kind {
            Kind::Number(text) => {
                let value = number::in_file(text);
                let value = value.map_err(|mistake| self.error(node.place, mistake))?;
                Ok(signed(value, node.place))
            }
            Kind::Text(text) => text::value(text, &mut self.at(node.place)),
            _ => Err(self.instead_of("a number or a string with a value", node)),
        }
    }

    /// Values in brackets, of which `shown` is an example.
    pub(super) fn vector<const N: usize>(
        &mut self,
        node: &Node,
        shown: &str,
    ) -> Read<[Option<Expr>; N]> {
        let Kind::List(values) = &node.kind else {
            return Err(self.instead_of(&format!("`{shown}`"), node));
        };
        let values: Vec<_> = values.iter().map(|value| self.value(value).ok()).collect();
        let count = values.len();
        values
            .try_into()
            .map_err(|_| self.error(node.place, mistake::value::other_count(shown, count)))
    }

    pub(super) fn word<'n>(&self, node: &'n Node, what: &str) -> Read<&'n str> {
        match &node.kind {
            Kind::Text(text) => Ok(text),
            _ => Err(self.instead_of(what, node)),
        }
    }

    /// One of some words.
    pub(super) fn choice(
        &self,
        node: &Node,
        what: &str,
        known: &[&'static str],
    ) -> Read<&'static str> {
        let word = self.word(node, &words::either(known))?;
        let right = known.iter().find(|right| **right == word);
        right.copied().ok_or_else(|| {
            let wrong = unknown(what, word, known);
            self.error(node.place, wrong.mistake)
        })
    }

    pub(super) fn truth(&self, node: &Node) -> Read<bool> {
        match node.kind {
            Kind::Truth(truth) => Ok(truth),
            _ => Err(self.instead_of("`true` or `false`", node)),
        }
    }

    pub(super) fn allow(&self, node: &Node, known: &[&'static str]) -> Read<Allow> {
        let Kind::List(words) = &node.kind else {
            return Err(self.instead_of("`[\"odd_angle\"]`", node));
        };
        let mut allow = Allow::default();
        for word in words {
            allow.note(self.choice(word, "allowance", known)?);
        }
        Ok(allow)
    }

    /// Values for some words.
    pub(super) fn values<const N: usize>(
        &mut self,
        node: &Node,
        what: &str,
        known: [&'static str; N],
    ) -> Read<[Given<Expr>; N]> {
        let items = self.part(node, what, &known)?;
        let mut values = [(); N].map(|()| Given::Absent);
        for item in &items.read {
            let index = known.iter().position(|name| *name == item.name);
            values[index.unwrap_or(0)] = given(self.value(item.node));
        }
        if items.incomplete {
            values.iter_mut().for_each(Given::doubt);
        }
        Ok(values)
    }
}
