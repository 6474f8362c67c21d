//! Frames, the tool and where they are.

use super::reader::{Item, Read, Reader, put};
use crate::description::{Body, Frame, Link, Name, Placement, Tool, Vector};
use crate::keys::{FRAME, LINK_BESIDE_A_FILE, Part, TOOL};
use crate::mistake::{self, expected};
use crate::tree::{Key, KeyKind, Kind, Node};

impl Reader<'_> {
    /// A placement with the words of that part.
    pub(super) fn placement_by(&mut self, node: &Node, part: &Part) -> Read<Placement> {
        let mut placement = Placement::default();
        self.table(node, part, |reader, item| {
            reader.placement(item, &mut placement)
        })?;
        Ok(placement)
    }

    pub(super) fn placement(&mut self, item: &Item, placement: &mut Placement) -> Read<()> {
        match item.name {
            "xyz" => put(&mut placement.xyz, self.xyz(item.node)),
            _ => {
                let shown = "[roll, pitch, yaw]";
                let angles = self.vector(item.node, shown, &expected::array(shown));
                put(&mut placement.rpy, angles)
            }
        }
    }

    pub(super) fn xyz(&mut self, node: &Node) -> Read<Vector> {
        self.vector(node, "[x, y, z]", &expected::array("[x, y, z]"))
    }

    pub(super) fn tool(&mut self, node: &Node) -> Read<Tool> {
        let mut tool = Tool::default();
        let incomplete = self.table(node, &TOOL, |reader, item| match item.name {
            "xyz" | "rpy" => reader.placement(item, &mut tool.placement),
            _ => reader.cell_of_body(item, &mut tool.body),
        })?;
        if incomplete {
            tool.body.doubt();
        }
        Ok(tool)
    }

    /// `{ left_hand: { on: left_elbow, xyz: [0.3, 0, 0] } }`. A frame that cannot be read leaves its name, if it has one.
    pub(super) fn frames(&mut self, node: &Node) -> Read<Vec<Frame>> {
        let what = self.either(
            expected::frames(),
            "a table with a table for each frame, by its name",
        );
        let Kind::Table(items) = &node.kind else {
            return Err(self.instead_of(&what, node));
        };
        let items = self.until_full(items);
        let read = |(key, node): &(Key, Node)| {
            let name = if key.kind == KeyKind::Stray {
                Err(self.instead_of(&expected::frame(), node))
            } else if key.word.trim().is_empty() || key.word == "_" {
                Err(self.error(key.place, mistake::link::nameless_frame()))
            } else {
                self.name(&key.word, key.place)
            };
            match name {
                Ok(name) => self.frame(name, node),
                Err(_) => Frame::default(),
            }
        };
        Ok(items.map(read).collect())
    }

    /// `{ hand: { mass: load } }`, cells for the links of a file.
    pub(super) fn links(&mut self, node: &Node) -> Read<Vec<(Name, Body)>> {
        let (table, item) = (expected::links(), expected::link_of_file);
        self.named_cells(node, &table, item, |reader, name, node| {
            let mut body = Body::default();
            let incomplete = reader.table(node, &LINK_BESIDE_A_FILE, |reader, item| {
                reader.cell_of_body(item, &mut body)
            })?;
            if incomplete {
                body.doubt();
            }
            Ok((name, body))
        })
    }

    pub(super) fn frame(&mut self, name: Name, node: &Node) -> Frame {
        let mut frame = Frame {
            name: Some(name),
            ..Frame::default()
        };
        let incomplete = self.visit(node, |reader, node| {
            reader.table(node, &FRAME, |reader, item| match item.name {
                "on" => put(&mut frame.on, reader.link(item.node)),
                "xyz" | "rpy" => reader.placement(item, &mut frame.placement),
                _ => reader.cell_of_body(item, &mut frame.body),
            })
        });
        if incomplete.unwrap_or(true) {
            frame.on.doubt();
            frame.body.doubt();
        }
        frame
    }

    /// The link that carries a joint or a frame, by the joint's name.
    pub(super) fn link(&mut self, node: &Node) -> Read<Link> {
        self.name_of(node, &expected::link()).map(Link::Named)
    }
}
