//! The tree of links of a file, in whatever format: the part of it that is requested becomes rows, frames and bodies.
//!
//! A reader of a format makes a [`Tree`] of a text, and nothing else. The words in which messages name the parts of such a file
//! come with the tree.

mod asked;
mod assembly;
mod follow;
mod inertia;
mod rounding;
mod span;
mod tip;
mod tree;
mod walk;

pub(super) use rounding::Rounding;
pub(super) use tree::{Follows, Inertial, Joint, Kind, Link, Number, Tree, Words};

use super::Request;
use crate::description::Table;
use crate::diagnose::Diagnostics;
use crate::mistake::{joint, links};
use crate::place::Place;
use assembly::Assembly;

/// The requested part of a tree. `used` gets the names of the locked joints that are not on it.
pub(super) fn table(
    tree: Tree,
    request: &Request,
    used: &mut Vec<String>,
    diagnostics: &Diagnostics,
) -> Option<Table> {
    if let Some(body) = request.base.as_ref().and_then(|base| base.body) {
        diagnostics.error(body, links::body_beside());
        return None;
    }
    if tree.joints.is_empty() && request.base.is_none() {
        diagnostics.error(Place::START, joint::none());
        return None;
    }
    let mut assembly = Assembly::new(&tree, request, used, diagnostics);
    let names = assembly.report_names();
    assembly.find().and(names)?;
    assembly.walk();
    // A mistake in the rest of the rows is reported beside links without inertia.
    let is_readable = diagnostics.is_empty();
    assembly.report_without_inertia();
    assembly.place_tip();
    let entries = assembly.into_entries();
    is_readable.then(|| Table {
        entries,
        notes: tree.rounding.notes(),
        rounded: tree.rounding.rounded,
        warnings: tree.warnings,
        ..Table::default()
    })
}
