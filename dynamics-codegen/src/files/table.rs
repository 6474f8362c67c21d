//! A table in the macro's own words, from a tree: what `parse` reads from tokens.

use std::collections::BTreeSet;

use dynamics_symbolic::Function;
use dynamics_symbolic::robot::{Convention, JointType};

use super::Format;
use super::signed::signed;
use super::tree::{Key, Kind, Node};
use crate::description::{
    Allow, Asked, Coulomb, Coupled, Entries, Entry, Expr, Friction, Given, Inertia, InertiaKind,
    Joints, Locked, Motor, Name, Placement, Row, Share, Spring, Stribeck, Table, Tensor, Tool,
};
use crate::diagnose::{Diagnostics, Reported};
use crate::limits::MOST_LETTERS;
use crate::mistake::{self, Mistake, file as wrong, size};
use crate::parse::allow;
use crate::parse::frames::{BASE, TOOL};
use crate::parse::functions::{DEFAULT, names as function_names};
use crate::parse::inertia::{ENTRIES, unknown_entry};
use crate::parse::number;
use crate::parse::row::{
    CELLS, DIRECTIONS, FRICTION, JOINT_TYPES, MOTOR, SPRING, STRIBECK, unknown_cell,
};
use crate::parse::text::{self, At};
use crate::parse::unknown::{Wrong, unknown};
use crate::place::Place;
use crate::words;

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

/// Cells of a published table that stand in parts of a row here.
const PUBLISHED: [&str; 4] = ["motor_inertia", "gear_ratio", "viscous", "coulomb"];

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

struct Reader<'d> {
    /// What it is read from: messages are in its words.
    format: Format,
    diagnostics: &'d Diagnostics,
    mentions: BTreeSet<String>,
}

/// The items of a table that could be told.
struct Items<'n> {
    read: Vec<Item<'n>>,
    /// Whether there were others.
    incomplete: bool,
}

/// `key = value`
struct Item<'n> {
    /// The right word.
    name: &'static str,
    place: Place,
    node: &'n Node,
    /// Whether another word stands there, which was reported.
    is_guess: bool,
}

type Read<T> = Result<T, Reported>;

/// What was read, in its cell.
fn given<T>(value: Read<T>) -> Given<T> {
    value.map_or(Given::Unreadable, Given::As)
}

impl Reader<'_> {
    fn is_json(&self) -> bool {
        self.format == Format::Json
    }

    fn error(&self, at: impl Into<Place>, mistake: Mistake) -> Reported {
        self.diagnostics.error(at, mistake)
    }

    fn instead_of(&self, what: &str, node: &Node) -> Reported {
        self.error(node.place, wrong::other_kind(what, node.found()))
    }

    /// The items of a table with those words; `unknown` says what is wrong with another one.
    fn items<'n>(
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
    fn part<'n>(&self, node: &'n Node, what: &str, known: &[&'static str]) -> Read<Items<'n>> {
        let kind = format!("{what} entry");
        self.items(node, &format!("`{what}`"), known, |word| {
            unknown(&kind, word, known)
        })
    }

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
            "allow" => Entry::Allow(self.allow(node, &allow::OF_TABLE).ok()),
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

    /// A name that expressions or generated code have.
    fn rust_name(&self, what: &str, key: &Key) -> Read<Name> {
        match words::is_name(&key.word) {
            true => self.name(&key.word, key.place),
            false => Err(self.error(key.place, wrong::no_name(what, &key.word))),
        }
    }

    fn name(&self, word: &str, place: Place) -> Read<Name> {
        if word.chars().any(char::is_control) {
            return Err(self.error(place, wrong::control_in_name(word)));
        }
        match word.len() > MOST_LETTERS {
            true => Err(self.error(place, size::name(word))),
            false => Ok(Name::new(word, place)),
        }
    }

    fn at(&mut self, place: Place) -> At<'_> {
        At {
            place,
            diagnostics: self.diagnostics,
            mentions: &mut self.mentions,
        }
    }

    /// A number, or a string with an expression.
    fn value(&mut self, node: &Node) -> Read<Expr> {
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
    fn vector<const N: usize>(&mut self, node: &Node, shown: &str) -> Read<[Option<Expr>; N]> {
        let Kind::List(values) = &node.kind else {
            return Err(self.instead_of(&format!("`{shown}`"), node));
        };
        let values: Vec<_> = values.iter().map(|value| self.value(value).ok()).collect();
        let count = values.len();
        values
            .try_into()
            .map_err(|_| self.error(node.place, mistake::value::other_count(shown, count)))
    }

    fn word<'n>(&self, node: &'n Node, what: &str) -> Read<&'n str> {
        match &node.kind {
            Kind::Text(text) => Ok(text),
            _ => Err(self.instead_of(what, node)),
        }
    }

    /// One of some words.
    fn choice(&self, node: &Node, what: &str, known: &[&'static str]) -> Read<&'static str> {
        let word = self.word(node, &words::either(known))?;
        let right = known.iter().find(|right| **right == word);
        right.copied().ok_or_else(|| {
            let wrong = unknown(what, word, known);
            self.error(node.place, wrong.mistake)
        })
    }

    fn convention(&self, node: &Node) -> Read<Convention> {
        let word = self.choice(node, "convention", &["standard", "modified"])?;
        Ok(match word {
            "standard" => Convention::Standard,
            _ => Convention::Modified,
        })
    }

    fn truth(&self, node: &Node) -> Read<bool> {
        match node.kind {
            Kind::Truth(truth) => Ok(truth),
            _ => Err(self.instead_of("`true` or `false`", node)),
        }
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

    fn joints(&mut self, node: &Node) -> Read<Joints> {
        let Kind::List(rows) = &node.kind else {
            return Err(self.instead_of(wrong::joints(self.is_json()), node));
        };
        let mut joints = Joints {
            rows: Vec::new(),
            complete: true,
            tip: Vec::new(),
        };
        for row in rows {
            match self.row(row) {
                Ok(row) => joints.rows.push(row),
                Err(_) => joints.complete = false,
            }
        }
        Ok(joints)
    }

    fn row(&mut self, node: &Node) -> Read<Row> {
        let known = [&["name", "type"], CELLS.as_slice()].concat();
        let items = self.items(node, "a joint", &known, |word| self.unknown_cell(word))?;
        let mut row = Row::default();
        for item in &items.read {
            self.cell(item, &mut row);
        }
        let has = |name| items.read.iter().any(|item| item.name == name);
        if !has("name") {
            self.error(node.place, wrong::nameless_joint());
        }
        if !has("type") {
            self.error(node.place, wrong::typeless_joint(self.is_json()));
        }
        if items.incomplete {
            row.mass.doubt();
            row.com.doubt();
        }
        Ok(row)
    }

    /// The mistake of a key that is no cell of a row. Published tables have keys of their own.
    fn unknown_cell(&self, word: &str) -> Wrong {
        if KEYS.contains(&word) {
            return Wrong {
                mistake: wrong::of_the_whole_table(word, self.is_json()),
                meant: None,
            };
        }
        let published = unknown("cell", word, &PUBLISHED);
        match published.meant {
            Some(_) if self.is_json() => Wrong {
                meant: None,
                ..published
            },
            _ => unknown_cell(word),
        }
    }

    fn cell(&mut self, item: &Item, row: &mut Row) {
        let node = item.node;
        match item.name {
            "name" => row.name = self.joint_name(node).ok(),
            "type" => row.joint_type = self.joint_type(node, row.name.as_ref()).ok(),
            "a" => row.a = given(self.value(node)),
            "alpha" => row.alpha = given(self.value(node)),
            "d" => row.d = given(self.value(node)),
            "theta" => row.theta = given(self.value(node)),
            "mass" => row.mass = given(self.value(node)),
            "com" => row.com = given(self.vector(node, "[x, y, z]")),
            "inertia" => row.inertia = given(self.inertia(node)),
            "inertia_at_origin" => row.inertia_at_origin = given(self.inertia_at_origin(node)),
            "motor" => row.motor = given(self.motor(node)),
            "friction" => row.friction = given(self.friction(node)),
            "spring" => row.spring = given(self.spring(node)),
            "limits" => row.limits = given(self.vector(node, "[lower, upper]")),
            _ => row.allow = given(self.allow(node, &allow::OF_BODY)),
        }
    }

    fn joint_name(&self, node: &Node) -> Read<Name> {
        let word = self.word(node, "the joint's name")?;
        match word.trim().is_empty() || word == "_" {
            true => Err(self.error(node.place, wrong::nameless_joint())),
            false => self.name(word, node.place),
        }
    }

    fn joint_type(&self, node: &Node, joint: Option<&Name>) -> Read<JointType> {
        if matches!(&node.kind, Kind::Text(word) if word == "fixed") {
            let joint = joint.map_or("joint", Name::plain);
            return Err(self.error(node.place, mistake::joint::fixed(&joint)));
        }
        let word = self.choice(node, "joint type", &JOINT_TYPES)?;
        Ok(match word {
            "revolute" => JointType::Revolute,
            _ => JointType::Prismatic,
        })
    }

    /// A table of tensor entries, or a string with a solid.
    fn inertia(&mut self, node: &Node) -> Read<Inertia> {
        if let Kind::Text(text) = &node.kind {
            return text::solid(text, &mut self.at(node.place));
        }
        if let Kind::List(entries) = &node.kind
            && self.is_json()
        {
            let mistake = mistake::value::other_count("[xx, yy, zz, xy, yz, xz]", entries.len());
            return Err(self.error(node.place, mistake));
        }
        if !matches!(node.kind, Kind::Table(_)) {
            let what = mistake::expected::inertia().to_string();
            return Err(self.instead_of(&what, node));
        }
        Ok(Inertia {
            place: node.place,
            kind: InertiaKind::Tensor(self.tensor(node)?),
        })
    }

    /// A table of entries of a tensor about the origin of the frame.
    fn inertia_at_origin(&mut self, node: &Node) -> Read<Tensor> {
        Ok(Tensor {
            place: node.place,
            entries: self.tensor(node)?,
        })
    }

    fn tensor(&mut self, node: &Node) -> Read<Entries> {
        let items = self.items(node, "an inertia", &ENTRIES, unknown_entry)?;
        let mut entries = Entries::default();
        for item in &items.read {
            let index = ENTRIES.iter().position(|entry| *entry == item.name);
            entries[index.unwrap_or(0)] = given(self.value(item.node));
        }
        if items.incomplete {
            entries.iter_mut().for_each(Given::doubt);
        }
        Ok(entries)
    }

    /// Values for some words.
    fn values<const N: usize>(
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

    fn motor(&mut self, node: &Node) -> Read<Motor> {
        let [inertia, gear_ratio] = self.values(node, "motor", MOTOR)?;
        Ok(Motor {
            place: node.place,
            inertia,
            gear_ratio,
        })
    }

    fn friction(&mut self, node: &Node) -> Read<Friction> {
        let items = self.part(node, "friction", &FRICTION)?;
        let mut friction = Friction::default();
        for item in items.read {
            match item.name {
                "viscous" => friction.viscous = given(self.value(item.node)),
                "coulomb" => friction.coulomb = given(self.coulomb(item.node)),
                _ => friction.stribeck = given(self.stribeck(item.node)),
            }
        }
        Ok(friction)
    }

    fn coulomb(&mut self, node: &Node) -> Read<Coulomb> {
        if !matches!(node.kind, Kind::Table(_)) {
            return self
                .value(node)
                .map(|value| Coulomb::Both(Given::As(value)));
        }
        let [positive, negative] = self.values(node, "coulomb", DIRECTIONS)?;
        Ok(Coulomb::ByDirection {
            place: node.place,
            positive,
            negative,
        })
    }

    fn stribeck(&mut self, node: &Node) -> Read<Stribeck> {
        let [friction, velocity] = self.values(node, "stribeck", STRIBECK)?;
        Ok(Stribeck {
            place: node.place,
            friction,
            velocity,
        })
    }

    fn spring(&mut self, node: &Node) -> Read<Spring> {
        let [stiffness, rest] = self.values(node, "spring", SPRING)?;
        Ok(Spring {
            place: node.place,
            stiffness,
            rest,
        })
    }

    fn allow(&self, node: &Node, known: &[&'static str]) -> Read<Allow> {
        let Kind::List(words) = &node.kind else {
            return Err(self.instead_of("`[\"odd_angle\"]`", node));
        };
        let mut allow = Allow::default();
        for word in words {
            allow::note(&mut allow, self.choice(word, "allowance", known)?);
        }
        Ok(allow)
    }
}
