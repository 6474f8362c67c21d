//! Rules of robot files alone: what is doubtful in a file that is a robot, and what other programs refuse in it.
//!
//! Reasons why a file is no robot are reported where it is read, here as for all other commands. [`judged`] has the rest: it
//! reads what no model needs (geometry, effort, lengths of axes) by itself, and says nothing of what it cannot read.

mod body;
mod rule;
mod sides;
mod space;
mod table;
mod urdf;

pub use rule::{RULES, Rule};

use crate::diagnose::Diagnostics;
use crate::files::urdf::xml::parsed;
use crate::files::{Format, alone};
use crate::finding::Finding;

/// Findings in a text.
#[derive(Debug, Default)]
pub struct Judged {
    /// All of it, in no order.
    pub findings: Vec<Finding>,
    /// The link at which a robot begins whose base moves, or none of a robot that is a whole file: other commands read it
    /// with `--base floating`.
    pub moving_base: Option<Option<String>>,
}

/// Judges the text of a file.
pub fn judged(text: &str, format: Format) -> Judged {
    match format {
        Format::Urdf => {
            let judged =
                Diagnostics::without(|diagnostics| parsed(text, diagnostics, urdf::judged));
            judged.unwrap_or_default()
        }
        Format::Toml | Format::Json => Judged {
            findings: alone(text, format).map_or(Vec::new(), |(table, model)| {
                table::findings(&table, &model.robot)
            }),
            moving_base: None,
        },
    }
}
