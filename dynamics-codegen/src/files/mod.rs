//! Files of robots: what the entry `file` of a call names, or another program reads.
//!
//! The formats are read by crates that keep the text and the place of every number. Decimals stay exact by that,
//! and mistakes are reported with line and column. The result is a [`Table`](crate::description::Table), as that of a
//! call.

#[cfg(feature = "files")]
mod beside;
#[cfg(feature = "files")]
mod fields;
#[cfg(feature = "files")]
pub(crate) mod json;
#[cfg(feature = "files")]
mod links;
#[cfg(feature = "files")]
mod load;
#[cfg(feature = "files")]
mod number;
#[cfg(feature = "files")]
mod reading;
mod request;
#[cfg(feature = "files")]
mod toml;
#[cfg(feature = "files")]
pub(crate) mod urdf;

use crate::call::Call;
use crate::description::Entry;
use crate::diagnose::Diagnostics;
#[cfg(feature = "files")]
pub use crate::limits::MOST_BYTES;
use crate::mistake::file as mistake;
#[cfg(feature = "files")]
use load::insert;
#[cfg(feature = "files")]
pub use number::number;
#[cfg(feature = "files")]
pub use reading::*;
pub use request::{Format, MovingBase, Request};

/// Entries that say something about a file, and mean nothing without one.
const ABOUT_FILES: [&str; 3] = ["chain", "ignore", "round_angles"];

/// Puts what the file of a call says beside what the call says.
pub(crate) fn load(call: &mut Call, diagnostics: &Diagnostics) {
    let file = call.table.entries.iter().find_map(|entry| match entry {
        Entry::File(file) => Some(file.clone()),
        _ => None,
    });
    match file {
        Some(Some(file)) => {
            insert(call, &file, diagnostics);
        }
        Some(None) => {}
        None => report_without_file(call, diagnostics),
    }
}

fn report_without_file(call: &Call, diagnostics: &Diagnostics) {
    for (key, place) in &call.table.keys {
        if ABOUT_FILES.contains(key) {
            diagnostics.error(*place, mistake::only_with_urdf(key));
        }
    }
}

#[cfg(not(feature = "files"))]
fn insert(
    _: &mut Call,
    file: &crate::description::FileName,
    diagnostics: &Diagnostics,
) -> Option<()> {
    diagnostics.error(file.place, mistake::switched_off());
    None
}
