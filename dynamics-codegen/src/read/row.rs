//! The rows of a table and their cells.

use std::collections::BTreeSet;

use dynamics_symbolic::robot::JointType;

use super::reader::{Item, Read, Reader, put};
use super::unknown::unknown;
use crate::description::{
    Axis, Body, Coulomb, Friction, Given, Inertia, Joints, Limits, Name, Row, Solid, Tensor,
};
use crate::keys::{
    ALLOWANCES_OF_BODY, AT, BESIDE_A_FILE, DIRECTIONS, FRICTION, JOINT_TYPES, MOTOR, OF_A_FILE,
    Part, SPRING, STRIBECK, TENSOR, word_list,
};
use crate::mistake::expected::Expected;
use crate::mistake::{self, expected, file as wrong};
use crate::tree::{Key, KeyKind, Kind, Language, Node};

/// The solids and their arguments.
const SOLIDS: [(&str, Solid, &[&str]); 4] = [
    ("cuboid", Solid::Cuboid, &["x", "y", "z"]),
    ("cylinder", Solid::Cylinder(Axis::Z), &["radius", "length"]),
    ("rod", Solid::Rod(Axis::X), &["length"]),
    ("sphere", Solid::Sphere, &["radius"]),
];

/// Makes the words of a row and the readers of its cells, of the method that reads each. The second braces have cells of
/// the body. The compiler names a cell of the description that is not listed.
macro_rules! cells {
    ($(
        {$($cell:ident: $read:ident($($with:expr),*)),*}
        {$($of_body:ident: $read_body:ident($($with_body:expr),*)),*}
    )*) => {
        const WORDS: &[&str] = word_list![name type $($($cell)* $($of_body)*)*];

        impl Reader<'_> {
            fn cell(&mut self, item: &Item, row: &mut Row) -> Read<()> {
                let Row {
                    name: _, joint_type: _, places: _, mount: _, limits_of_file: _, body, $($($cell),*),*
                } = row;
                match item.name {
                    $($(stringify!($cell) => put($cell, self.$read(item.node, $($with),*)),)*)*
                    _ => self.cell_of_body(item, body),
                }
            }

            /// A cell of a row or of the tool.
            pub(super) fn cell_of_body(&mut self, item: &Item, body: &mut Body) -> Read<()> {
                let Body { $($($of_body),*),* } = body;
                match item.name {
                    $($(stringify!($of_body) => put($of_body, self.$read_body(item.node, $($with_body),*)),)*)*
                    _ => Ok(()),
                }
            }
        }
    };
}

cells! {
    {a: value(), alpha: value(), d: value(), theta: value(), on: link(), at: placement_by(&AT), gamma: value(), b: value()}
    {mass: value(), com: xyz(), inertia: inertia(), inertia_at_origin: tensor()}
    {motor: values(&MOTOR), friction: friction(), spring: values(&SPRING), limits: range(), torque_limit: value(),
     velocity_limit: value()}
    {allow: allow(ALLOWANCES_OF_BODY)}
}

/// A row of a file.
const ROW: Part = Part {
    name: "a joint",
    item: "cell",
    keys: WORDS,
    shape: "`{ ... }`",
};

/// The cells of a row in a call, behind its name and type.
const CELLS: Part = Part {
    keys: WORDS.split_at(2).1,
    ..ROW
};

// Each word of a row stands in a file alone, or beside it too.
const _: () = assert!(WORDS.len() == OF_A_FILE.len() + BESIDE_A_FILE.keys.len());

impl Reader<'_> {
    fn is_json(&self) -> bool {
        self.language == Language::Json
    }

    pub(super) fn joints(&mut self, node: &Node) -> Read<Joints> {
        let (rows, mut complete) = match &node.kind {
            Kind::Rows(rows, complete) => (rows, *complete),
            Kind::List(rows) if !self.is_call() => (rows, true),
            Kind::Unreadable(faults) => {
                let reported = self.report(faults);
                return Err(reported.unwrap_or_else(|| self.instead_of(&expected::rows(), node)));
            }
            _ => {
                let what = self.either(expected::rows(), wrong::joints(self.is_json()));
                return Err(self.instead_of(&what, node));
            }
        };
        let mut read = Vec::new();
        for row in self.until_full(rows) {
            match self.visit(row, Reader::row) {
                Ok(row) => read.push(row),
                Err(_) => complete &= self.is_call(),
            }
        }
        Ok(Joints {
            rows: read,
            complete,
        })
    }

    fn row(&mut self, node: &Node) -> Read<Row> {
        let mut row = Row::default();
        let (cells, part) = match &node.kind {
            Kind::Row(name, joint_type, cells) => {
                row.name.clone_from(name);
                let read = |node: &Node| self.joint_type(node, name.as_ref()).ok();
                row.joint_type = joint_type.as_deref().and_then(read);
                if matches!(cells.kind, Kind::Absent) {
                    return Ok(row);
                }
                (&**cells, CELLS)
            }
            _ => (node, ROW),
        };
        let (mut has_name, mut has_type) = (self.is_call(), self.is_call());
        let incomplete = self.table(cells, &part, |reader, item| {
            has_name |= item.name == "name";
            has_type |= item.name == "type";
            match item.name {
                "name" => reader
                    .joint_name(item.node)
                    .map(|name| row.name = Some(name)),
                "type" => {
                    let joint_type = reader.joint_type(item.node, row.name.as_ref());
                    joint_type.map(|joint_type| row.joint_type = Some(joint_type))
                }
                _ => reader.cell(item, &mut row),
            }
        })?;
        if !has_name {
            self.error(node.place, wrong::nameless_joint());
        }
        if !has_type {
            self.error(node.place, wrong::typeless_joint(self.is_json()));
        }
        if incomplete {
            row.body.doubt();
        }
        Ok(row)
    }

    /// `{ joint: { friction: { ... } }, ... }`, cells for the joints of a file.
    pub(super) fn joints_beside(&mut self, node: &Node) -> Read<Vec<Row>> {
        let (table, item) = (expected::rows(), expected::joint_of_file);
        self.named_cells(node, &table, item, Reader::cells_beside)
    }

    /// `{ name: { ... }, ... }`, cells for each of some names, which stand there once.
    pub(super) fn named_cells<T>(
        &mut self,
        node: &Node,
        table: &Expected,
        item: fn() -> Expected,
        cells: impl Fn(&mut Self, Name, &Node) -> Read<T>,
    ) -> Read<Vec<T>> {
        let Kind::Table(items) = &node.kind else {
            return Err(self.instead_of(table, node));
        };
        let (mut names, mut read) = (BTreeSet::new(), Vec::new());
        for (key, node) in self.until_full(items) {
            if key.kind == KeyKind::Stray {
                self.instead_of(&item(), node);
                continue;
            }
            let Ok(name) = self.name(&key.word, key.place) else {
                continue;
            };
            if !names.insert(name.plain().to_owned()) {
                self.error(key.place, mistake::given_twice(&key.word));
                continue;
            }
            read.extend(self.visit(node, |reader, node| cells(reader, name, node)));
        }
        Ok(read)
    }

    fn cells_beside(&mut self, name: Name, node: &Node) -> Read<Row> {
        if let (Kind::Table(items), Language::Toml) = (&node.kind, self.language)
            && let Some((part, cells)) = items.first()
            && matches!(cells.kind, Kind::Table(_))
            && part.word.starts_with(|c: char| c.is_ascii_digit())
        {
            let mistake = wrong::dotted_joint(name.plain(), &part.word);
            return Err(self.error(&name, mistake));
        }
        let mut row = Row {
            name: Some(name),
            ..Row::default()
        };
        self.table(node, &BESIDE_A_FILE, |reader, item| {
            reader.cell(item, &mut row)
        })?;
        Ok(row)
    }

    /// `[lower, upper]`
    fn range(&mut self, node: &Node) -> Read<Limits> {
        let shown = "[lower, upper]";
        self.vector(node, shown, &expected::array(shown))
    }

    fn joint_name(&self, node: &Node) -> Read<Name> {
        if let Kind::Number(number) = &node.kind {
            return Err(self.error(node.place, wrong::number_as_name(number)));
        }
        let word = self.word(node, &expected::thing("the joint's name"))?;
        if word.trim().is_empty() || word == "_" {
            return Err(self.error(node.place, wrong::nameless_joint()));
        }
        self.name(word, node.place)
    }

    fn joint_type(&self, node: &Node, joint: Option<&Name>) -> Read<JointType> {
        if node.word() == Some("fixed") {
            let joint = joint.map_or("joint", Name::plain);
            return Err(self.error(node.place, mistake::joint::fixed(&joint)));
        }
        let word = self.choice(node, "joint type", JOINT_TYPES)?;
        Ok(match word {
            "revolute" => JointType::Revolute,
            _ => JointType::Prismatic,
        })
    }

    /// A table of tensor entries, or a solid.
    fn inertia(&mut self, node: &Node) -> Read<Inertia> {
        self.read_text(node, |reader, node| match &node.kind {
            Kind::Table(_) => reader.tensor(node).map(Inertia::Tensor),
            Kind::Applied(name, arguments, _) => reader.solid(node, name.plain(), arguments),
            Kind::List(entries) if reader.is_json() => {
                let shown = "[xx, yy, zz, xy, yz, xz]";
                let mistake = mistake::value::other_count(shown, entries.len());
                Err(reader.error(node.place, mistake))
            }
            _ => Err(reader.instead_of(&expected::inertia(), node)),
        })
    }

    /// A table of entries of a tensor.
    fn tensor(&mut self, node: &Node) -> Read<Tensor> {
        self.values(node, &TENSOR).map(Box::new)
    }

    /// `cuboid(x, y, z)` and the like.
    fn solid(&mut self, node: &Node, word: &str, arguments: &Node) -> Read<Inertia> {
        let known = SOLIDS.iter().find(|(solid, ..)| *solid == word);
        let Kind::List(values) = &arguments.kind else {
            return Err(match known {
                Some(solid) => self.instead_of(&expected::array(&shown(solid)), arguments),
                None => self.instead_of(&expected::inertia(), node),
            });
        };
        let Some((name, solid, sizes)) = known else {
            let unknown = unknown("solid", word, &SOLIDS.map(|(name, ..)| name));
            return Err(self.error(node.place, unknown.mistake));
        };
        let mut solid = *solid;
        let mut outcome = Ok(());
        for value in values {
            if let Kind::Pair(key, axis) = &value.kind {
                let along = self.visit(value, |reader, _| reader.along(name, solid, key, axis));
                solid = along.unwrap_or(solid);
                outcome = along.map(|_| ()).and(outcome);
            }
        }
        let is_size = |value: &&Node| !matches!(value.kind, Kind::Pair(..));
        let written = values.iter().filter(is_size);
        let shown = shown(&(name, solid, sizes));
        if written.clone().count() != sizes.len() {
            outcome?;
        }
        let values = self.values_between(written, sizes.len(), &shown, arguments.place)?;
        let place = node.place.to(arguments.place);
        Ok(Inertia::Solid(place, solid, values))
    }

    /// The solid along the axis that `axis = z` names.
    fn along(&self, name: &str, solid: Solid, key: &Key, axis: &Node) -> Read<Solid> {
        let along: fn(Axis) -> Solid = match solid {
            _ if key.word != "axis" => {
                let mistake = mistake::joint::named_size(name, &key.word);
                return Err(self.error(key.place, mistake));
            }
            Solid::Cylinder(_) => Solid::Cylinder,
            Solid::Rod(_) => Solid::Rod,
            Solid::Cuboid | Solid::Sphere => {
                return Err(self.error(key.place, mistake::joint::without_axis(name)));
            }
        };
        match axis.word() {
            Some("x") => Ok(along(Axis::X)),
            Some("y") => Ok(along(Axis::Y)),
            Some("z") => Ok(along(Axis::Z)),
            _ => Err(self.instead_of(&expected::axis(), axis)),
        }
    }

    fn friction(&mut self, node: &Node) -> Read<Friction> {
        let mut friction = Friction::default();
        // A coefficient that is left out is zero, whatever else could not be read.
        self.table(node, &FRICTION, |reader, item| match item.name {
            "viscous" => put(&mut friction.viscous, reader.value(item.node)),
            "coulomb" => put(&mut friction.coulomb, reader.coulomb(item.node)),
            _ => put(&mut friction.stribeck, reader.values(item.node, &STRIBECK)),
        })?;
        Ok(friction)
    }

    /// A value, or `{ positive, negative }`.
    fn coulomb(&mut self, node: &Node) -> Read<Coulomb> {
        if !matches!(node.kind, Kind::Table(_)) {
            let value = self.value(node);
            return value.map(|value| Coulomb::Both(Given::As(value)));
        }
        self.values(node, &DIRECTIONS).map(Coulomb::ByDirection)
    }
}

/// A solid with its arguments, as a message shows it.
fn shown((name, _, arguments): &(&str, Solid, &[&str])) -> String {
    format!("{name}({})", arguments.join(", "))
}
