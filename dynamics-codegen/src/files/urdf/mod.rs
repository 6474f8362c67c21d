//! URDF: a chain of links out of a tree of them.

mod chain;
mod document;
mod follow;
mod prefixes;
mod rounding;

use super::Request;
use crate::description::Table;
use crate::diagnose::Diagnostics;
use crate::mistake::urdf as mistake;
use crate::place::Place;

/// Reads the requested chain from a text, and reports what is wrong. `used` gets the names of the
/// locked joints that are not on the chain.
pub(super) fn read(
    text: &str,
    request: &Request,
    used: &mut Vec<String>,
    diagnostics: &Diagnostics,
) -> Option<Table> {
    let tree = document::read(text, request, diagnostics)?;
    let start = Place::File { line: 1, column: 1 };
    if tree.joints.is_empty() {
        diagnostics.error(start, crate::mistake::joint::none());
        return None;
    }
    let Some(ends) = &request.chain else {
        let (first, last) = tree.ends();
        diagnostics.error(start, mistake::chain_missing(&first, &last));
        return None;
    };
    let entries = chain::entries(&tree, ends, request, used, diagnostics)?;
    Some(Table {
        entries,
        notes: tree.rounding.notes(),
        ..Table::default()
    })
}

/// The links of a text to which no joint leads, and those from which none does; `None` if it cannot be read.
pub(super) fn ends(text: &str, diagnostics: &Diagnostics) -> Option<[Vec<String>; 2]> {
    let tree = document::read(text, &Request::default(), diagnostics)?;
    let (first, last) = tree.ends();
    Some([first, last].map(|links| links.into_iter().map(str::to_owned).collect()))
}

/// The names of all joints in a text.
pub(super) fn joint_names(text: &str, diagnostics: &Diagnostics) -> Vec<String> {
    let tree = document::read(text, &Request::default(), diagnostics);
    let joints = tree.into_iter().flat_map(|tree| tree.joints);
    joints.map(|joint| joint.name).collect()
}
