//! The names that a value may use, and what is allowed where it stands.

mod value;

use std::collections::BTreeMap;

use dynamics_symbolic::function::plain;
use dynamics_symbolic::robot::Value;

use super::measured::Measured;
use super::named::read_masses;
use crate::audience::{AT_THE_END, Audience};
use crate::description::{Allow, Entry, Expr, Given, Name, Row, Table};
use crate::diagnose::Diagnostics;
use crate::mistake::{Mistake, couple, value as mistake};
use crate::place::Place;
use crate::words;

/// A base that moves, as messages call what is read.
pub(super) const BASE: &str = "base";

/// The names that a value may use.
pub(super) struct Scope<'d> {
    diagnostics: &'d Diagnostics,
    names: BTreeMap<String, Binding>,
    /// Every name that the call binds by `let`, wherever.
    lets: Vec<String>,
    /// Whether each of the fields was used.
    used: Vec<bool>,
    /// Whether all fields are known; if not, any name may be one.
    complete: bool,
    /// The size of all values so far.
    total: Total,
    /// The allowances of the whole table.
    everywhere: Allow,
    /// The allowances of the row or tool that is read, and how messages call it.
    body: Option<(Allow, &'static str)>,
    /// The cell that is read, where the joint's variable is added to it.
    variable: Option<&'static str>,
    /// The joint that follows another one, where its position is read.
    follower: Option<String>,
    /// The names of all joints.
    joints: Vec<String>,
    /// Names that nothing binds, in the order in which they are read.
    free: Vec<String>,
    /// The fields that the file lists, where it does.
    listed: Option<Vec<String>>,
    /// Whether a name that nothing binds is reported once, and not where it is used again.
    once: bool,
}

/// The size of values.
#[derive(Default)]
struct Total {
    terms: usize,
    bits: usize,
}

enum Binding {
    Field(usize),
    /// `None`: the value is in error.
    Let(Option<Measured>),
}

impl<'d> Scope<'d> {
    /// The fields alone.
    pub(super) fn new(table: &Table, diagnostics: &'d Diagnostics) -> Scope<'d> {
        let joints = table.rows().iter().filter_map(|row| row.name.as_ref());
        let mut everywhere = table.allow();
        everywhere.unphysical_inertia |= !read_masses(table);
        let mut scope = Scope {
            diagnostics,
            names: BTreeMap::new(),
            lets: Vec::new(),
            used: Vec::new(),
            complete: table.has_all_fields,
            total: Total::default(),
            everywhere,
            body: None,
            variable: None,
            follower: None,
            joints: joints.map(|name| name.plain().to_owned()).collect(),
            free: Vec::new(),
            listed: table
                .listed_fields()
                .map(|names| names.iter().map(|name| name.plain().to_owned()).collect()),
            once: table.audience == Audience::Command,
        };
        for name in &table.fields {
            let index = scope.used.len();
            // One that cannot be bound can be used by no value.
            let bound = scope.insert(name, "field", Binding::Field(index));
            scope.used.push(!bound);
        }
        for entry in &table.entries {
            if let Entry::Let(name, _) = entry {
                scope.lets.push(name.plain().to_owned());
            }
        }
        scope
    }

    /// Reports an error.
    pub(super) fn error(&self, at: impl Into<Place>, mistake: Mistake) {
        self.diagnostics.error(at, mistake);
    }

    /// Reads a row, the tool or a frame, which `place` says, with what is allowed there.
    pub(super) fn within<T>(
        &mut self,
        allow: &Given<Allow>,
        place: &'static str,
        read: impl FnOnce(&mut Self) -> T,
    ) -> T {
        self.body = Some((self.with(allow), place));
        let value = read(self);
        self.body = None;
        value
    }

    /// The allowances of a row or tool, and of the whole table.
    pub(super) fn with(&self, allow: &Given<Allow>) -> Allow {
        self.everywhere.or(match allow {
            Given::Absent => Allow::default(),
            Given::Unreadable => Allow::EVERYTHING,
            Given::As(allow) => *allow,
        })
    }

    /// The allowances where the scope is now.
    pub(super) fn allowed(&self) -> Allow {
        self.body.map_or(self.everywhere, |(allow, _)| allow)
    }

    /// The row, the tool, the frame or the base that is read, as messages call it.
    pub(super) fn place(&self) -> &'static str {
        self.body.map_or("row", |(_, place)| place)
    }

    /// Whether it is a base that moves.
    pub(super) fn is_in_base(&self) -> bool {
        self.place() == BASE
    }

    /// Where it is allowed, as a message says it.
    pub(super) fn place_of_allow(&self) -> &'static str {
        match self.body {
            Some((_, "tool")) => "on the tool",
            Some((_, "frame")) => "on the frame",
            Some((_, BASE)) => "on the base",
            Some(_) => "on the row",
            None => AT_THE_END,
        }
    }

    /// Binds the name to the value.
    pub(super) fn bind(&mut self, name: &Name, value: Option<&Expr>) {
        let value = value.and_then(|value| self.counted(value));
        self.insert(name, "`let`", Binding::Let(value));
    }

    /// Returns whether the name was free.
    fn insert(&mut self, name: &Name, what: &str, binding: Binding) -> bool {
        let word = name.plain().to_owned();
        if word == "PI" || word == "deg" {
            self.error(name, mistake::reserved(what, &word));
            return false;
        }
        let mistake = match self.names.get(&word) {
            None => {
                self.names.insert(word, binding);
                return true;
            }
            Some(Binding::Field(_)) => mistake::field_twice(&word),
            Some(Binding::Let(_)) => mistake::let_twice(&word),
        };
        self.error(name, mistake);
        false
    }

    /// Whether no error was reported.
    pub(super) fn is_good(&self) -> bool {
        self.diagnostics.is_empty()
    }

    /// Whether the field of that index was used in a value.
    pub(super) fn is_used(&self, field: usize) -> bool {
        self.used.get(field).copied().unwrap_or(true)
    }

    /// Reads the cell of that name, to which the joint's variable is added.
    pub(super) fn beside_variable<T>(
        &mut self,
        cell: Option<&'static str>,
        read: impl FnOnce(&mut Self) -> T,
    ) -> T {
        self.variable = cell;
        let value = read(self);
        self.variable = None;
        value
    }

    /// The row of the joint of that name; reports that there is none.
    pub(super) fn row_of(&self, name: &Name, rows: &[Row]) -> Option<usize> {
        let row = rows.iter().position(|row| row.word() == name.plain());
        if row.is_none() {
            let known: Vec<&str> = self.joints.iter().map(String::as_str).collect();
            let meant = words::nearest(name.plain(), &known);
            self.error(
                name,
                crate::mistake::unknown("joint", name.plain(), meant, &known),
            );
        }
        row
    }

    /// Reports why there is no value.
    pub(super) fn refused<T>(&self, place: Place, mistake: Mistake) -> Option<T> {
        self.error(place, mistake);
        None
    }

    fn lookup(&mut self, name: &str, place: Place) -> Option<Measured> {
        let word = plain(name);
        if self.follower.is_some() && self.joints.iter().any(|joint| joint == word) {
            return Some(Measured::position_of(word, place));
        }
        if name == "PI" {
            return Some(Measured::new(Value::Pi));
        }
        match self.names.get(word) {
            Some(Binding::Field(index)) => {
                self.used[*index] = true;
                Some(Measured::new(Value::field(*index)))
            }
            Some(Binding::Let(value)) => value.clone(),
            None if self.complete && !self.diagnostics.is_full() => {
                if self.once && self.free.iter().any(|known| known == word) {
                    return None;
                }
                self.free.push(word.to_owned());
                let mistake = self.unknown(name);
                self.refused(place, mistake)
            }
            None => {
                self.note_free(word);
                None
            }
        }
    }

    /// Notes a name that may be that of a field.
    fn note_free(&mut self, name: &str) {
        // The leader of a follower was meant to be a joint.
        let is_leader = self.follower.is_some()
            && words::nearest(
                name,
                &self.joints.iter().map(String::as_str).collect::<Vec<_>>(),
            )
            .is_some();
        let is_bound = self.lets.iter().any(|bound| bound == name);
        let is_known = self.free.iter().any(|known| known == name);
        if !(is_leader || is_bound || is_known) && mistake::may_be_a_field(name) {
            self.free.push(name.to_owned());
        }
    }

    /// The names that were noted.
    #[cfg(feature = "files")]
    pub(super) fn into_free_names(self) -> Vec<String> {
        self.free
    }

    /// The mistake of a name that is not in scope. A field that was meant is used.
    fn unknown(&mut self, name: &str) -> Mistake {
        if self.lets.iter().any(|bound| bound == name) {
            return mistake::bound_below(name);
        }
        let names: Vec<&str> = self.names.keys().map(String::as_str).collect();
        if let Some(follower) = &self.follower {
            let joints: Vec<&str> = self.joints.iter().map(String::as_str).collect();
            let others = joints.iter().filter(|joint| *joint != follower);
            let known: Vec<&str> = others.chain(&names).copied().collect();
            return couple::unknown_leader(name, words::nearest(name, &known), &joints);
        }
        if let Some(ours) = words::constant_of_std(name) {
            return mistake::constant_of_std(name, ours);
        }
        let meant = words::nearest(name, &[names.as_slice(), &["PI"]].concat());
        if let Some(Binding::Field(index)) = meant.and_then(|meant| self.names.get(meant)) {
            self.used[*index] = true;
        }
        let is_unlisted = |listed: &Vec<String>| listed.iter().all(|known| known != name);
        let is_unlisted = self.listed.as_ref().is_some_and(is_unlisted);
        if meant.is_none() && is_unlisted && mistake::may_be_a_field(name) {
            return mistake::unlisted_name(name);
        }
        mistake::unknown_name(name, meant, &names, self.variable)
    }
}
