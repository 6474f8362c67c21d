//! A table in the macro's own words, from a tree: what `parse` reads from tokens.

mod reader;
mod row;

use std::collections::BTreeSet;

use dynamics_symbolic::Function;
use dynamics_symbolic::robot::Convention;

use super::Format;
use super::tree::{Key, Kind, Node};
use crate::description::{Allow, Asked, Coupled, Entry, Locked, Placement, Share, Table, Tool};
use crate::diagnose::Diagnostics;
use crate::mistake;
use crate::parse::allow;
use crate::parse::frames::{BASE, TOOL};
use crate::parse::functions::{DEFAULT, names as function_names};
use crate::parse::text;
use crate::parse::unknown::unknown;
use crate::place::Place;
use reader::{Item, Read, Reader, given};

/// The keys of a file.
pub(super) const KEYS: [&str; 12] = [
    "convention",
    "gravity",
    "base",
    "joint",
    "couple",
    "tool",
    "functions",
    "lock",
    "neglect",
    "tests",
    "allow",
    "let",
];

/// What a file says of the robot, in the order in which it stands there.
pub(super) fn table(root: &Node, format: Format, diagnostics: &Diagnostics) -> Table {
    let mut reader = Reader {
        format,
        diagnostics,
        mentions: BTreeSet::new(),
    };
    let mut table = Table::default();
    if let Ok(items) = reader.items(root, "a robot", &KEYS, |word| unknown("key", word, &KEYS)) {
        for item in items.read {
            table.keys.push((item.name, item.place));
            reader.entry(&item, &mut table.entries);
        }
    }
    table.mentions = reader.mentions;
    table
}

impl Reader<'_> {
    fn entry(&mut self, item: &Item, entries: &mut Vec<Entry>) {
        let node = item.node;
        entries.push(match item.name {
            "convention" => Entry::Convention(self.convention(node).ok()),
            "gravity" => Entry::Gravity(self.vector(node, "[x, y, z]").ok()),
            "base" => Entry::Base(self.base(node).ok().map(Box::new)),
            "joint" => Entry::Joints(item.place, self.joints(node).ok()),
            "tool" => Entry::Tool(self.tool(node).ok().map(Box::new)),
            "functions" => Entry::Functions(self.functions(node).ok()),
            "lock" => Entry::Lock(self.lock(node).ok()),
            "couple" => Entry::Couple(self.couple(node).ok()),
            "neglect" => Entry::Neglect(self.share(node).ok()),
            "tests" => Entry::Tests(item.place, self.truth(node).ok()),
            "allow" => Entry::Allow(self.allow(node, &Allow::WORDS).ok()),
            _ => return self.lets(node, entries),
        });
    }

    /// `[let]` with a value for each name.
    fn lets(&mut self, node: &Node, entries: &mut Vec<Entry>) {
        let Kind::Table(items) = &node.kind else {
            self.instead_of("a table of names and values", node);
            return;
        };
        for (key, node) in items {
            let Ok(name) = self.rust_name("a name", key) else {
                continue;
            };
            entries.push(Entry::Let(name, self.value(node).ok()));
        }
    }

    fn convention(&self, node: &Node) -> Read<Convention> {
        let word = self.choice(node, "convention", &["standard", "modified"])?;
        Ok(match word {
            "standard" => Convention::Standard,
            _ => Convention::Modified,
        })
    }

    /// `"1%"`, or a number.
    fn share(&mut self, node: &Node) -> Read<Share> {
        if let Kind::Text(text) = &node.kind {
            return text::share(text, &mut self.at(node.place));
        }
        Ok(Share {
            number: self.value(node)?,
            percent: false,
            place: node.place,
        })
    }

    fn lock(&mut self, node: &Node) -> Read<Vec<Locked>> {
        let Kind::Table(items) = &node.kind else {
            return Err(self.instead_of("a table of joints and positions", node));
        };
        if items.is_empty() {
            return Err(self.error(node.place, mistake::entry::no_lock()));
        }
        let mut locked = Vec::new();
        for (key, node) in items {
            if let (Kind::Table(parts), false) = (&node.kind, self.is_json())
                && let Some((part, _)) = parts.first()
            {
                let mistake = mistake::file::dotted_name(&key.word, &part.word);
                return Err(self.error(key.place, mistake));
            }
            locked.push(Locked {
                name: self.name(&key.word, key.place)?,
                position: self.value(node).ok(),
            });
        }
        Ok(locked)
    }

    fn couple(&mut self, node: &Node) -> Read<Vec<Coupled>> {
        let Kind::Table(items) = &node.kind else {
            return Err(self.instead_of("a table of joints and those that they follow", node));
        };
        if items.is_empty() {
            return Err(self.error(node.place, mistake::couple::none()));
        }
        let mut coupled = Vec::new();
        for (key, node) in items {
            coupled.push(Coupled {
                follower: self.name(&key.word, key.place)?,
                position: self.value(node).ok(),
            });
        }
        Ok(coupled)
    }

    fn functions(&self, node: &Node) -> Read<Vec<Asked>> {
        let Kind::List(items) = &node.kind else {
            return Err(self.instead_of("an array of names of functions", node));
        };
        if items.is_empty() {
            return Err(self.error(node.place, mistake::entry::no_function()));
        }
        let mut asked = Vec::new();
        for item in items {
            match &item.kind {
                Kind::Table(tuples) => {
                    for (key, parts) in tuples {
                        asked.push(self.fused(key, parts).unwrap_or(Asked::Unreadable));
                    }
                }
                _ => asked.push(self.function(item).unwrap_or(Asked::Unreadable)),
            }
        }
        Ok(asked)
    }

    /// A function, or the default set.
    fn function(&self, node: &Node) -> Read<Asked> {
        let word = self.word(node, "the name of a function")?;
        if word == DEFAULT {
            return Ok(Asked::Default(node.place));
        }
        let known: Vec<_> = core::iter::once(DEFAULT).chain(function_names()).collect();
        let function = self.function_of_name(word, node.place, &known)?;
        Ok(Asked::One(function, node.place))
    }

    fn function_of_name(&self, word: &str, place: Place, known: &[&'static str]) -> Read<Function> {
        Function::from_name(word).ok_or_else(|| {
            let wrong = unknown("function", word, known);
            self.error(place, wrong.mistake)
        })
    }

    /// `control_terms = ["mass_matrix", "gravity_vector"]`
    fn fused(&self, key: &Key, parts: &Node) -> Read<Asked> {
        let name = self.rust_name("the name of a tuple", key)?;
        let Kind::List(parts) = &parts.kind else {
            return Err(self.instead_of("an array of names of functions", parts));
        };
        let known: Vec<_> = function_names().collect();
        let part = |node: &Node| {
            let word = self.word(node, "the name of a function")?;
            if word == DEFAULT {
                return Err(self.error(node.place, mistake::entry::default_in_tuple()));
            }
            Ok((self.function_of_name(word, node.place, &known)?, node.place))
        };
        // All of them are read, for there may be errors in more than one.
        let parts: Vec<Read<_>> = parts.iter().map(part).collect();
        let parts: Read<Vec<_>> = parts.into_iter().collect();
        Ok(Asked::Fused(name, parts?))
    }

    fn base(&mut self, node: &Node) -> Read<Placement> {
        let items = self.part(node, "base", &BASE)?;
        let mut base = Placement::default();
        for item in items.read {
            self.placement(&item, &mut base);
        }
        Ok(base)
    }

    fn placement(&mut self, item: &Item, placement: &mut Placement) {
        match item.name {
            "xyz" => placement.xyz = given(self.vector(item.node, "[x, y, z]")),
            _ => placement.rpy = given(self.vector(item.node, "[roll, pitch, yaw]")),
        }
    }

    fn tool(&mut self, node: &Node) -> Read<Tool> {
        let items = self.part(node, "tool", &TOOL)?;
        let mut tool = Tool::default();
        for item in items.read {
            match item.name {
                "mass" => tool.mass = given(self.value(item.node)),
                "com" => tool.com = given(self.vector(item.node, "[x, y, z]")),
                "inertia" => tool.inertia = given(self.inertia(item.node)),
                "inertia_at_origin" => {
                    tool.inertia_at_origin = given(self.inertia_at_origin(item.node));
                }
                "allow" => tool.allow = given(self.allow(item.node, &allow::OF_BODY)),
                _ => self.placement(&item, &mut tool.placement),
            }
        }
        if items.incomplete {
            tool.mass.doubt();
            tool.com.doubt();
        }
        Ok(tool)
    }
}
