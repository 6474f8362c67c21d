//! The base: where it stands, or the body with which it moves.

use super::reader::{Item, Read, Reader};
use super::unknown::unknown;
use crate::description::{Base, Body};
use crate::keys::{BASE, FLOATING, FLOATING_IN_FILE, MOVING, Part};
use crate::mistake::{base as mistake, expected};
use crate::place::Place;
use crate::tree::{Key, Kind, Node};
use crate::words;

impl Reader<'_> {
    pub(super) fn base(&mut self, node: &Node) -> Read<Base> {
        match &node.kind {
            Kind::Applied(word, cells, _) => {
                let moves = self.moves(word.plain(), word.into());
                let body = self.visit(cells, |reader, cells| {
                    reader.body_of_base(cells, &FLOATING, |_, _| Ok(()))
                });
                if !is_meant(word.plain()) {
                    moves?;
                }
                Ok(Base::Floating(word.into(), body?))
            }
            Kind::Word(_) | Kind::Text(_) => {
                let word = node.word().unwrap_or_default();
                if self.is_call() && matches!(node.kind, Kind::Text(_)) && is_meant(word) {
                    return Err(self.error(node.place, mistake::in_quotes(MOVING)));
                }
                let moves = self.moves(word, node.place);
                if !is_meant(word) {
                    moves?;
                }
                Ok(Base::Floating(node.place, Body::default()))
            }
            Kind::Table(items) => match items.iter().find(|(key, _)| is_meant(&key.word)) {
                Some((key, _)) if !self.is_call() => self.floating_in_file(key, node),
                _ => self.placement_by(node, &BASE).map(Base::Standing),
            },
            _ => {
                let file = "a table with `xyz` and `rpy`, or with `floating = true`";
                Err(self.instead_of(&self.either(expected::base(), file), node))
            }
        }
    }

    /// Reports a word that does not say that the base moves.
    fn moves(&self, word: &str, place: Place) -> Read<()> {
        if word == MOVING {
            return Ok(());
        }
        let mistake = if ["fixed", "static", "standing", "none"].contains(&word) {
            mistake::stands(word)
        } else {
            unknown("base", word, &[MOVING]).mistake
        };
        Err(self.error(place, mistake))
    }

    /// `{ floating = true, mass = 3 }`, where that key says that the base moves.
    fn floating_in_file(&mut self, key: &Key, node: &Node) -> Read<Base> {
        let body = self.body_of_base(node, &FLOATING_IN_FILE, |reader, item| {
            match reader.truth(item.node)? {
                true => Ok(()),
                false => Err(reader.error(item.node.place, mistake::not_floating())),
            }
        })?;
        Ok(Base::Floating(key.place, body))
    }

    /// The cells of a body, and the word by which it is one.
    fn body_of_base(
        &mut self,
        node: &Node,
        part: &Part,
        mut word: impl FnMut(&mut Self, &Item) -> Read<()>,
    ) -> Read<Body> {
        let mut body = Body::default();
        let incomplete = self.table(node, part, |reader, item| match item.name {
            MOVING => word(reader, item),
            _ => reader.cell_of_body(item, &mut body),
        })?;
        if incomplete {
            body.doubt();
            body.inertia.doubt();
        }
        Ok(body)
    }
}

/// Whether a key says that the base moves.
fn is_meant(word: &str) -> bool {
    words::meant(word, &[MOVING]).is_some()
}
