//! The rows of a table in a file.

use dynamics_symbolic::robot::JointType;

use super::super::tree::{Kind, Node};
use super::KEYS;
use super::reader::{Item, Read, Reader, given};
use crate::description::{
    Coulomb, Entries, Friction, Given, Inertia, InertiaKind, Joints, Motor, Name, Row, Spring,
    Stribeck, Tensor,
};
use crate::mistake::{self, file as wrong};
use crate::parse::allow;
use crate::parse::inertia::{ENTRIES, unknown_entry};
use crate::parse::row::{
    CELLS, DIRECTIONS, FRICTION, JOINT_TYPES, MOTOR, SPRING, STRIBECK, unknown_cell,
};
use crate::parse::text;
use crate::parse::unknown::{Wrong, unknown};

/// Cells of a published table that stand in parts of a row here.
const PUBLISHED: [&str; 4] = ["motor_inertia", "gear_ratio", "viscous", "coulomb"];

impl Reader<'_> {
    pub(super) fn joints(&mut self, node: &Node) -> Read<Joints> {
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
        if let Kind::Number(number) = &node.kind {
            return Err(self.error(node.place, wrong::number_as_name(number)));
        }
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
    pub(super) fn inertia(&mut self, node: &Node) -> Read<Inertia> {
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
    pub(super) fn inertia_at_origin(&mut self, node: &Node) -> Read<Tensor> {
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
}
