//! URDF: a chain of links out of a tree of them.

mod chain;
mod document;
mod follow;

use super::Request;
use crate::description::Table;
use crate::diagnose::Diagnostics;
use crate::mistake::urdf as mistake;
use crate::place::Place;

/// What a text says of the chain that is asked for; what is wrong is reported. `used` gets the names of the
/// locked joints that are none of the chain's.
pub(super) fn read(
    text: &str,
    request: &Request,
    used: &mut Vec<String>,
    diagnostics: &Diagnostics,
) -> Option<Table> {
    let tree = document::read(text, request.round_angles.as_ref(), diagnostics)?;
    let Some(ends) = &request.chain else {
        let start = Place::File { line: 1, column: 1 };
        let first = tree.links.first().map_or("base_link", |link| &link.name);
        diagnostics.error(start, mistake::chain_missing(first));
        return None;
    };
    let entries = chain::entries(&tree, ends, request, used, diagnostics)?;
    Some(Table {
        entries,
        notes: notes(tree.nearly_right),
        ..Table::default()
    })
}

/// The names of all joints in a text.
pub(super) fn joint_names(text: &str, diagnostics: &Diagnostics) -> Vec<String> {
    let tree = document::read(text, None, diagnostics);
    let joints = tree.into_iter().flat_map(|tree| tree.joints);
    joints.map(|joint| joint.name).collect()
}

/// What the struct's documentation says of angles that were perhaps meant as quarter turns.
fn notes(nearly_right: usize) -> Vec<String> {
    match nearly_right {
        0 => Vec::new(),
        1 => vec![nearly("One angle of the file is", "it", "a quarter turn")],
        n => vec![nearly(
            &format!("{n} angles of the file are"),
            "them",
            "quarter turns",
        )],
    }
}

fn nearly(which: &str, them: &str, turns: &str) -> String {
    format!(
        " {which} within 0.01 rad of a quarter turn, and taken as written: every vector that passes such an angle costs \
         four multiplications and two additions. `round_angles: 1e-4` takes {them} as {turns} where they are as near as that."
    )
}
