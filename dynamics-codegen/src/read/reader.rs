//! The parts of which a table is made: items with keys, names, values and words.

use std::collections::BTreeSet;

#[cfg(feature = "files")]
use dynamics_symbolic::robot::Value;

use super::unknown::{unknown, unknown_key};
use crate::description::{Allow, Expr, Given, Name, Part as Values};
use crate::diagnose::{Diagnostics, Reported};
use crate::keys::Part;
use crate::limits::MOST_LETTERS;
use crate::mistake::expected::{self, Expected};
use crate::mistake::{self, Mistake};
use crate::parse::expression::word_alone;
#[cfg(feature = "files")]
use crate::parse::{names, number, text};
use crate::place::Place;
use crate::tree::{Fault, Key, KeyKind, Kind, Language, Node};
use crate::words;

pub(super) struct Reader<'d> {
    /// The language that is read: messages are in its words.
    pub(super) language: Language,
    pub(super) diagnostics: &'d Diagnostics,
    pub(super) mentions: BTreeSet<String>,
}

pub(super) type Read<T> = Result<T, Reported>;

/// A value of a table.
pub(super) struct Item<'n> {
    /// The right word in front of it.
    pub(super) name: &'static str,
    /// The word that is written.
    pub(super) key: &'n Key,
    pub(super) node: &'n Node,
}

/// Puts what was read into its cell.
pub(super) fn put<T>(cell: &mut Given<T>, value: Read<T>) -> Read<()> {
    let (given, outcome) = match value {
        Ok(value) => (Given::As(value), Ok(())),
        Err(reported) => (Given::Unreadable, Err(reported)),
    };
    *cell = given;
    outcome
}

impl<'d> Reader<'d> {
    pub(super) fn is_call(&self) -> bool {
        self.language == Language::Call
    }

    pub(super) fn error(&self, at: impl Into<Place>, mistake: Mistake) -> Reported {
        self.diagnostics.error(at, mistake)
    }

    /// Reports the faults, and returns the last of them.
    pub(super) fn report(&self, faults: &[Fault]) -> Option<Reported> {
        let report = |_, (place, mistake): &Fault| Some(self.error(*place, mistake.clone()));
        faults.iter().fold(None, report)
    }

    /// Reports that something else stands there, or why the value could not be recognised at all.
    pub(super) fn instead_of(&self, what: &Expected, node: &Node) -> Reported {
        let otherwise = || {
            self.error(
                node.place,
                mistake::instead(what, node.found.shown().as_deref()),
            )
        };
        let is_absent = matches!(node.kind, Kind::Absent);
        let known = is_absent.then(|| self.report(&node.faults)).flatten();
        known.unwrap_or_else(otherwise)
    }

    /// A thing that was expected, in the words of a call or of a file.
    pub(super) fn either(&self, call: Expected, file: &str) -> Expected {
        if self.is_call() {
            call
        } else {
            expected::thing(file)
        }
    }

    /// The items, until no further error is shown.
    pub(super) fn until_full<'n, T>(
        &self,
        items: &'n [T],
    ) -> impl Iterator<Item = &'n T> + use<'n, 'd, T> {
        let diagnostics = self.diagnostics;
        items.iter().take_while(move |_| !diagnostics.is_full())
    }

    /// Reads a value, and reports the mistakes around it.
    pub(super) fn visit<T>(
        &mut self,
        node: &Node,
        read: impl FnOnce(&mut Self, &Node) -> Read<T>,
    ) -> Read<T> {
        if !matches!(node.kind, Kind::Absent) {
            self.report(&node.faults);
        }
        let value = read(self, node)?;
        self.report(&node.behind);
        Ok(value)
    }

    /// Reads each value of a table with the keys of that part. Returns whether there were others: then what is
    /// left out may be what they mean.
    pub(super) fn table(
        &mut self,
        node: &Node,
        part: &Part,
        mut read: impl FnMut(&mut Self, &Item) -> Read<()>,
    ) -> Read<bool> {
        let Kind::Table(items) = &node.kind else {
            let file = format!("a table for {}, of {}", part.name, words::either(part.keys));
            let what = self.either(expected::thing(part.shape), &file);
            return Err(self.instead_of(&what, node));
        };
        let mut seen = BTreeSet::new();
        let mut incomplete = false;
        for (key, node) in self.until_full(items) {
            let Some(name) = self.key(key, node, part) else {
                incomplete = true;
                continue;
            };
            let is_guess = name != key.word && key.kind == KeyKind::Word;
            incomplete |= is_guess;
            // The key that was meant stands elsewhere.
            if is_guess && items.iter().any(|(other, _)| other.word == name) {
                continue;
            }
            if key.kind == KeyKind::Word && !seen.insert(name) {
                if !is_guess {
                    self.error(key.place, mistake::given_twice(&key.word));
                }
                continue;
            }
            let outcome = self.visit(node, |reader, node| read(reader, &Item { name, key, node }));
            incomplete |= outcome.is_err() && self.is_call();
        }
        Ok(incomplete)
    }

    /// The key that stands there, or was meant.
    fn key(&self, key: &Key, node: &Node, part: &Part) -> Option<&'static str> {
        match key.kind {
            KeyKind::Let => return Some("let"),
            KeyKind::Stray => {
                self.report(&node.faults).unwrap_or_else(|| {
                    let what = expected::key(part.item, part.keys);
                    self.error(key.place, mistake::instead(&what, Some(&key.word)))
                });
                return None;
            }
            KeyKind::Word => {}
        }
        let right = part.keys.iter().find(|name| **name == key.word);
        right.copied().or_else(|| {
            let unknown = unknown_key(part, &key.word, self.language);
            self.error(key.place, unknown.mistake);
            unknown.meant
        })
    }

    /// The values for the keys of a part, in their order.
    pub(super) fn values<const N: usize>(&mut self, node: &Node, part: &Part) -> Read<Values<N>> {
        let mut values = [(); N].map(|()| Given::Absent);
        let incomplete = self.table(node, part, |reader, item| {
            let index = part.keys.iter().position(|key| *key == item.name);
            put(&mut values[index.unwrap_or(0)], reader.value(item.node))
        })?;
        if incomplete {
            values.iter_mut().for_each(Given::doubt);
        }
        Ok(Values {
            place: node.place,
            values,
        })
    }

    /// A name that expressions or generated code have.
    pub(super) fn rust_name(&self, what: &str, key: &Key) -> Read<Name> {
        if self.is_call() || words::is_name(&key.word) {
            self.name(&key.word, key.place)
        } else {
            Err(self.error(key.place, mistake::file::no_name(what, &key.word)))
        }
    }

    /// A name of a value, which may be a keyword of Rust in a file.
    pub(super) fn name_of_value(&self, what: &str, key: &Key) -> Read<Name> {
        if words::is_raw_name(&key.word) {
            self.name(&key.word, key.place)
        } else {
            self.rust_name(what, key)
        }
    }

    pub(super) fn name(&self, word: &str, place: Place) -> Read<Name> {
        if word.chars().any(char::is_control) {
            return Err(self.error(place, mistake::file::control_in_name(word)));
        }
        if word.len() > MOST_LETTERS {
            return Err(self.error(place, mistake::size::name(word)));
        }
        Ok(Name::new(word, place))
    }

    /// Reads a text of a file in the words of a call; anything else as it is.
    pub(super) fn read_text<T>(
        &mut self,
        node: &Node,
        read: impl FnOnce(&mut Self, &Node) -> Read<T>,
    ) -> Read<T> {
        #[cfg(feature = "files")]
        if let (Kind::Text(text), false) = (&node.kind, self.is_call()) {
            let (node, tokens) = text::read(text, node.place)
                .map_err(|(place, mistake)| self.error(place, mistake))?;
            self.mentions.extend(names(tokens));
            let value = read(self, &node)?;
            return self.report(&node.behind).map_or(Ok(value), Err);
        }
        read(self, node)
    }

    /// A value; in a file a number, or a string with an expression.
    pub(super) fn value(&mut self, node: &Node) -> Read<Expr> {
        self.read_text(node, Reader::written_value)
    }

    fn written_value(&mut self, node: &Node) -> Read<Expr> {
        match &node.kind {
            #[cfg(feature = "files")]
            Kind::Number(text) => {
                let value = number::in_file(text);
                let value = value.map_err(|mistake| self.error(node.place, mistake))?;
                Ok(Expr::known(Value::Rational(value), node.place))
            }
            Kind::Value(value) => Ok(value.clone()),
            Kind::Word(name) => word_alone(&name.to_string(), node.place)
                .map_err(|mistake| self.error(node.place, mistake)),
            Kind::Share(share) => {
                let mistake = mistake::value::foreign("`%`");
                Err(self.error(share.place.end(), mistake))
            }
            Kind::Unreadable(faults) | Kind::Applied(_, _, faults) => {
                let reported = self.report(faults);
                Err(reported.unwrap_or_else(|| self.instead_of(&expected::value(), node)))
            }
            Kind::Text(_) => Err(self.instead_of(&expected::number(), node)),
            _ => {
                let file = "a number or a string with a value";
                Err(self.instead_of(&self.either(expected::value(), file), node))
            }
        }
    }

    /// Values in brackets, of which `shown` is an example, where `what` is expected.
    pub(super) fn vector<const N: usize>(
        &mut self,
        node: &Node,
        shown: &str,
        what: &Expected,
    ) -> Read<[Option<Expr>; N]> {
        let Kind::List(values) = &node.kind else {
            return Err(self.instead_of(what, node));
        };
        let values = self.values_between(values.iter(), N, shown, node.place)?;
        let mut values = values.into_iter();
        Ok(std::array::from_fn(|_| values.next().flatten()))
    }

    /// So many values between delimiters, of which `shown` is an example; none for what could not be read.
    pub(super) fn values_between<'n>(
        &mut self,
        nodes: impl Iterator<Item = &'n Node>,
        count: usize,
        shown: &str,
        place: Place,
    ) -> Read<Vec<Option<Expr>>> {
        let values: Vec<_> = nodes.map(|node| self.visit(node, Reader::value)).collect();
        if values.len() == count {
            return Ok(values.into_iter().map(Result::ok).collect());
        }
        // A value that could not be read may be a part of another one.
        let unreadable = values.iter().find_map(|value| value.as_ref().err());
        match unreadable.filter(|_| self.is_call()) {
            Some(reported) => Err(*reported),
            None => Err(self.error(place, mistake::value::other_count(shown, values.len()))),
        }
    }

    pub(super) fn word<'n>(&self, node: &'n Node, what: &Expected) -> Read<&'n str> {
        match &node.kind {
            Kind::Word(name) => Ok(name.plain()),
            Kind::Text(text) if !self.is_call() => Ok(text),
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
        self.choice_but(node, known, |word| unknown(what, word, known).mistake)
    }

    /// The same; `unknown` says what is wrong with another word.
    pub(super) fn choice_but(
        &self,
        node: &Node,
        known: &[&'static str],
        unknown: impl Fn(&str) -> Mistake,
    ) -> Read<&'static str> {
        let word = self.word(node, &expected::one_of(known))?;
        let right = known.iter().find(|right| **right == word);
        right
            .copied()
            .ok_or_else(|| self.error(node.place, unknown(word)))
    }

    pub(super) fn truth(&self, node: &Node) -> Read<bool> {
        const KNOWN: [&str; 2] = ["true", "false"];
        match node.kind {
            Kind::Truth(truth) => Ok(truth),
            Kind::Text(_) => Err(self.instead_of(&expected::one_of(&KNOWN), node)),
            _ => self
                .choice(node, "value", &KNOWN)
                .map(|word| word == "true"),
        }
    }

    /// `[odd_angle, ...]`, words of those known. A wrong word leaves it unknown what was to be allowed.
    pub(super) fn allow(&mut self, node: &Node, known: &[&'static str]) -> Read<Allow> {
        let what = self.either(expected::allowances(known), "`[\"odd_angle\"]`");
        let mut allow = Allow::default();
        let unknown = |word: &str| {
            if Allow::WORDS.contains(&word) {
                mistake::entry::allowed_for_the_table(word)
            } else {
                unknown("allowance", word, known).mistake
            }
        };
        self.list(node, &what, |reader, node| {
            allow.note(reader.choice_but(node, known, unknown)?);
            Ok(())
        })?;
        Ok(allow)
    }

    /// Reads each item of a list, where `what` is expected. All of them are read, for there may be mistakes in more
    /// than one.
    pub(super) fn list<T>(
        &mut self,
        node: &Node,
        what: &Expected,
        mut read: impl FnMut(&mut Self, &Node) -> Read<T>,
    ) -> Read<Vec<T>> {
        let Kind::List(items) = &node.kind else {
            return Err(self.instead_of(what, node));
        };
        let items = self
            .until_full(items)
            .map(|item| self.visit(item, &mut read));
        let items: Vec<_> = items.collect();
        items.into_iter().collect()
    }
}
