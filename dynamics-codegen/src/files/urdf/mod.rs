//! URDF: the whole tree of links, or a part of it.

mod assembly;
pub(crate) mod document;
mod follow;
mod loops;
pub(crate) mod prefixes;
mod rounding;
mod span;

use super::Request;
use crate::description::Table;
use crate::diagnose::Diagnostics;
use crate::mistake::{joint, urdf};

/// Reads the requested tree from a text, and reports what is wrong. `used` gets the names of the
/// locked joints that are not on it.
pub(super) fn read(
    text: &str,
    request: &Request,
    used: &mut Vec<String>,
    diagnostics: &Diagnostics,
) -> Option<Table> {
    let tree = document::read(text, request, diagnostics)?;
    if let Some(body) = request.base.as_ref().and_then(|base| base.body) {
        diagnostics.error(body, urdf::body_beside());
        return None;
    }
    if tree.joints.is_empty() && request.base.is_none() {
        diagnostics.error(assembly::START, joint::none());
        return None;
    }
    let entries = assembly::entries(&tree, request, used, diagnostics)?;
    Some(Table {
        entries,
        notes: tree.rounding.notes(),
        rounded: tree.rounding.rounded,
        warnings: tree.loops,
        ..Table::default()
    })
}

/// The names of all joints in a text.
pub(super) fn joint_names(text: &str, diagnostics: &Diagnostics) -> Vec<String> {
    let tree = document::read(text, &Request::default(), diagnostics);
    let joints = tree.into_iter().flat_map(|tree| tree.joints);
    joints.map(|joint| joint.name).collect()
}
