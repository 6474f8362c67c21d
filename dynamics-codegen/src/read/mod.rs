//! The meaning of a tree, whatever language it is written in: the words of a table, the values that may stand behind
//! each of them, and the mistakes.

mod base;
mod frame;
mod functions;
mod reader;
mod row;
mod unknown;

use std::collections::BTreeSet;

use dynamics_symbolic::robot::{Bounds, Convention};

use crate::description::{Allow, Entry, FileName, Name, Positioned, Share, Table, Vector};
use crate::diagnose::Diagnostics;
use crate::keys::{CALL, ENTRIES_BESIDE_A_FILE, FILE, PROJECT};
use crate::mistake::{self, expected};
use crate::tree::{Key, KeyKind, Kind, Language, Node};
use crate::words;
use reader::{Item, Read, Reader};
use unknown::unknown;

/// The table of a tree, its entries in the order in which they are written.
pub(crate) fn table(root: &Node, language: Language, diagnostics: &Diagnostics) -> Table {
    let mut reader = Reader {
        language,
        diagnostics,
        mentions: BTreeSet::new(),
    };
    let mut table = Table::default();
    let part = match language {
        Language::Call => CALL,
        _ if names_file(root) => PROJECT,
        Language::Toml if has_cells_beside(root) => ENTRIES_BESIDE_A_FILE,
        Language::Toml | Language::Json => FILE,
    };
    let _ = reader.visit(root, |reader, root| {
        reader.table(root, &part, |reader, item| {
            if item.key.kind == KeyKind::Word {
                table.keys.push((item.name, item.key.place));
            }
            reader.entry(item, &mut table.entries)
        })
    });
    table.mentions = reader.mentions;
    table
}

/// A value that is written as a text in a file.
#[cfg(feature = "files")]
pub(crate) fn written_value(
    text: &str,
    place: crate::place::Place,
    diagnostics: &Diagnostics,
) -> Option<crate::description::Expr> {
    let mut reader = Reader {
        language: Language::Toml,
        diagnostics,
        mentions: BTreeSet::new(),
    };
    let node = Node::new(place, Kind::Text(text.to_owned()));
    reader.value(&node).ok()
}

/// Whether the tree has a table `joints` or `links`, with cells for those of another file.
fn has_cells_beside(root: &Node) -> bool {
    let is_table = |node: &Node| matches!(node.kind, Kind::Table(_));
    item(root, "joints").is_some_and(is_table) || item(root, "links").is_some()
}

/// Whether the tree names the file of its robot, or a word like that stands where there are no joints.
fn names_file(root: &Node) -> bool {
    let Kind::Table(items) = &root.kind else {
        return false;
    };
    let is_meant = |word: &str| {
        item(root, "joint").is_none()
            && !FILE.keys.contains(&word)
            && words::nearest(word, &["file"]).is_some()
    };
    let mut keys = items.iter().map(|(key, _)| key.word.as_str());
    keys.any(|word| word == "file" || is_meant(word))
}

/// The value of a key of the tree.
fn item<'a>(root: &'a Node, word: &str) -> Option<&'a Node> {
    let Kind::Table(items) = &root.kind else {
        return None;
    };
    let found = items.iter().find(|(key, _)| key.word == word);
    found.map(|(_, node)| node)
}

/// Adds an entry, which is without a value if that could not be read.
fn add<T>(
    entries: &mut Vec<Entry>,
    entry: impl FnOnce(Option<T>) -> Entry,
    value: Read<T>,
) -> Read<()> {
    let (value, outcome) = match value {
        Ok(value) => (Some(value), Ok(())),
        Err(reported) => (None, Err(reported)),
    };
    entries.push(entry(value));
    outcome
}

impl Reader<'_> {
    fn entry(&mut self, item: &Item, to: &mut Vec<Entry>) -> Read<()> {
        let node = item.node;
        let place = if self.is_call() {
            node.place
        } else {
            item.key.place
        };
        match item.name {
            "convention" => add(to, Entry::Convention, self.convention(node)),
            "gravity" => add(to, Entry::Gravity, self.gravity(node)),
            "base" => add(to, Entry::Base, self.base(node).map(Box::new)),
            "joints" if matches!(node.kind, Kind::Table(_)) => {
                let rows = self.joints_beside(node);
                add(to, |rows| Entry::Beside(place, rows), rows)
            }
            "joint" | "joints" => add(to, |rows| Entry::Joints(place, rows), self.joints(node)),
            "links" => {
                let links = self.links(node);
                add(to, |links| Entry::Links(place, links), links)
            }
            "tool" => {
                let tool = self.tool(node).map(Box::new);
                add(to, |tool| Entry::Tool(place, tool), tool)
            }
            "frame" | "frames" => add(to, |frames| Entry::Frames(place, frames), self.frames(node)),
            "functions" => add(to, Entry::Functions, self.functions(node)),
            "lock" => add(to, Entry::Lock, self.lock(node)),
            "couple" => add(to, Entry::Couple, self.couple(node)),
            "neglect" => add(to, Entry::Neglect, self.share(node)),
            "bounds" => add(to, Entry::Bounds, self.bounds(node)),
            "tests" => add(to, |tests| Entry::Tests(place, tests), self.truth(node)),
            "fields" => add(to, Entry::Fields, self.fields(node)),
            "allow" => add(to, Entry::Allow, self.allow(node, &Allow::WORDS)),
            "file" => add(to, Entry::File, self.file(node)),
            "chain" => add(to, Entry::Chain, self.chain(node)),
            "ignore" => add(to, Entry::Ignore, self.ignored(node)),
            "round_angles" => add(to, Entry::RoundAngles, self.value(node)),
            _ if item.key.kind == KeyKind::Let => self.binding(item.key, node, to),
            _ => self.lets(node, to),
        }
    }

    /// `[let]` with a value for each name.
    fn lets(&mut self, node: &Node, entries: &mut Vec<Entry>) -> Read<()> {
        let Kind::Table(items) = &node.kind else {
            let what = expected::thing("a table of names and values");
            return Err(self.instead_of(&what, node));
        };
        for (key, node) in items {
            let _ = self.binding(key, node, entries);
        }
        Ok(())
    }

    fn binding(&mut self, key: &Key, node: &Node, entries: &mut Vec<Entry>) -> Read<()> {
        let name = self.name_of_value("a name", key)?;
        add(entries, |value| Entry::Let(name, value), self.value(node))
    }

    /// `["m1", "l1"]`, names of symbolic parameters.
    fn fields(&mut self, node: &Node) -> Read<Vec<Name>> {
        let what = expected::thing("an array of names, such as [\"m1\", \"l1\"]");
        self.list(node, &what, |reader, node| {
            let name = reader.name_of(node, &what)?;
            let key = Key::new(name.plain(), node.place);
            reader.name_of_value("a field", &key)
        })
    }

    fn convention(&self, node: &Node) -> Read<Convention> {
        const KNOWN: [&str; 2] = ["standard", "modified"];
        let word = self.choice_but(node, &KNOWN, |word| match words::meant(word, &KNOWN) {
            None => mistake::entry::unknown_convention(word),
            Some(_) => unknown("convention", word, &KNOWN).mistake,
        })?;
        Ok(match word {
            "standard" => Convention::Standard,
            _ => Convention::Modified,
        })
    }

    /// How bounds of rounding are found.
    fn bounds(&self, node: &Node) -> Read<Bounds> {
        const KNOWN: [&str; 1] = ["tight"];
        self.choice_but(node, &KNOWN, |word| unknown("bounds", word, &KNOWN).mistake)?;
        Ok(Bounds::Tight)
    }

    fn gravity(&mut self, node: &Node) -> Read<Vector> {
        self.vector(node, "[x, y, z]", &expected::gravity("[x, y, z]"))
    }

    /// `1%`, or a number.
    fn share(&mut self, node: &Node) -> Read<Share> {
        self.read_text(node, |reader, node| match &node.kind {
            Kind::Share(share) => Ok(share.clone()),
            _ => reader.value(node).map(|number| Share {
                place: number.place,
                number,
                percent: false,
            }),
        })
    }

    fn file(&self, node: &Node) -> Read<FileName> {
        match &node.kind {
            Kind::Text(path) => Ok(FileName {
                path: path.clone(),
                place: node.place,
            }),
            _ => {
                let what = "the path of a URDF file, from the folder of this one on: \"arm.urdf\"";
                Err(self.instead_of(&self.either(expected::file_name(), what), node))
            }
        }
    }

    /// `["base_link", "tool0"]`
    fn chain(&mut self, node: &Node) -> Read<Vec<Name>> {
        let names = self.list(node, &expected::chain(), |reader, node| {
            reader.name_of(node, &expected::chain())
        })?;
        if names.is_empty() {
            return Err(self.error(node.place, mistake::file::no_links()));
        }
        Ok(names)
    }

    /// `[finger_1, "finger-2"]`, or `rest`.
    fn ignored(&mut self, node: &Node) -> Read<Vec<Name>> {
        if let Kind::Word(word) = &node.kind
            && word.plain() == "rest"
        {
            return Ok(vec![word.clone()]);
        }
        self.list(node, &expected::ignored(), |reader, node| {
            reader.name_of(node, &expected::ignored_joint())
        })
    }

    /// A joint or a link, in quotes where its name is no word.
    fn name_of(&self, node: &Node, what: &expected::Expected) -> Read<Name> {
        let found = node.found.shown().unwrap_or_default();
        let found = found.trim_matches('`');
        match &node.kind {
            Kind::Word(name) => Ok(name.clone()),
            Kind::Text(text) => self.name(text, node.place),
            Kind::Value(_) if found.starts_with(|c: char| c.is_ascii_digit()) => {
                Err(self.error(node.place, mistake::file::number_as_name(found)))
            }
            Kind::Number(number) => {
                Err(self.error(node.place, mistake::file::number_as_name(number)))
            }
            _ => Err(self.instead_of(what, node)),
        }
    }

    /// The joints of a table with a value for each. A value that cannot be read leaves its joint in it.
    fn positions(
        &mut self,
        node: &Node,
        what: &expected::Expected,
        none: mistake::Mistake,
    ) -> Read<Vec<Positioned>> {
        let Kind::Table(items) = &node.kind else {
            return Err(self.instead_of(what, node));
        };
        if items.is_empty() {
            return Err(self.error(node.place, none));
        }
        let items = items.iter().map(|(key, node)| {
            if key.kind == KeyKind::Stray {
                return Err(self.instead_of(what, node));
            }
            if let (Kind::Table(parts), Language::Toml) = (&node.kind, self.language)
                && let Some((part, _)) = parts.first()
            {
                let mistake = mistake::file::dotted_name(&key.word, &part.word);
                return Err(self.error(key.place, mistake));
            }
            Ok(Positioned {
                name: self.name(&key.word, key.place)?,
                position: self.visit(node, Reader::value).ok(),
            })
        });
        let items: Vec<_> = items.collect();
        items.into_iter().collect()
    }

    fn lock(&mut self, node: &Node) -> Read<Vec<Positioned>> {
        let what = self.either(expected::joints(false), "a table of joints and positions");
        self.positions(node, &what, mistake::entry::no_lock())
    }

    fn couple(&mut self, node: &Node) -> Read<Vec<Positioned>> {
        let file = "a table of joints and those that they follow";
        let what = self.either(expected::joints(true), file);
        self.positions(node, &what, mistake::couple::none())
    }
}
