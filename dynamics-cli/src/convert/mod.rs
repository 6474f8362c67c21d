//! One kind of robot file as another: URDF as a Denavit-Hartenberg table, a table as URDF, and tables of one
//! convention as those of the other.
//!
//! `arm` puts the axes and bodies of a file in space, exactly where angles are quarter turns and in fifty digits where they
//! are not. `axes` finds the normals between them and `table` the rows, or `urdf` writes them as they are. A table that
//! stays in its convention keeps its rows. `document` says a table in the macro's words, `toml` and `json` write it, and
//! the macro's own reader reads it back.

mod angle;
mod arm;
mod axes;
mod cells;
mod document;
mod json;
mod node;
mod normal;
mod number;
mod parameters;
mod read_back;
mod string;
mod table;
mod toml;
mod urdf;
mod written;

use std::path::Path;

use dynamics_codegen::Model;
use dynamics_codegen::files::Format;
use dynamics_symbolic::robot::Robot;

use crate::arguments::{Convert, WITHOUT};
use crate::beside::has_links;
use crate::failure::Failure;
use crate::load::{for_command, read_with_links};
use arm::Arm;
use document::{Allowed, Document, frame_names};
use number::DIGITS;
use read_back::{refusals, refused_words};
pub(crate) use string::quoted;
use table::Table;

/// The text of the other file.
pub(crate) fn run(given: &Convert) -> Result<String, Failure> {
    let path = &given.robot.file.path;
    let target = target(given);
    let model = read_with_links(&given.robot, true)?;
    let Some(arm) = Arm::new(&model.robot) else {
        return Err(Failure::of_file(path, "expected numbers in every cell"));
    };
    let stem = path.file_stem().and_then(|stem| stem.to_str());
    let name = stem.unwrap_or("robot");
    match target {
        Format::Urdf => as_urdf(name, &arm, &model, given),
        format => as_table(name, &arm, &model, format, given),
    }
}

/// The format that is requested: by name, by that of the file that is written, or the other one.
fn target(given: &Convert) -> Format {
    let of_name = given.output.out.as_deref().and_then(Format::of);
    let other = if has_links(&given.robot.file.path) {
        Format::Toml
    } else {
        Format::Urdf
    };
    given.to.or(of_name).unwrap_or(other)
}

/// The comments at the head of the file.
fn remarks(path: &Path, is_rounded: bool, model: &Model) -> Vec<String> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let numbers = if is_rounded {
        format!("Numbers are exact, except those of {DIGITS} digits, which are rounded.")
    } else {
        "Numbers are exact.".to_owned()
    };
    let mut remarks = vec![
        format!("Converted from {name} by `robot-dynamics convert`. SI units, radians."),
        numbers,
    ];
    remarks.extend(model.remarks().map(|note| for_command(note)));
    if is_rounded {
        remarks.extend(kept(path, &model.robot));
    }
    remarks
}

/// Remarks on links, and on joints that are locked: unless all rows are kept, some names are lost.
fn kept(path: &Path, robot: &Robot) -> Vec<String> {
    let mut remarks = Vec::new();
    if has_links(path) {
        remarks.push(
            "Links of the file are frames here, with their names. Left out: the names of its fixed joints, and what it says \
             beside joints and inertia."
                .to_owned(),
        );
    }
    let locked = robot.rows.iter().filter(|row| row.locked.is_some());
    let locked: Vec<_> = locked.map(|row| format!("`{}`", row.name)).collect();
    if !locked.is_empty() {
        remarks.push(format!(
            "Left out: the joints that are locked, {}. Their links are parts of those that carry them.",
            locked.join(", ")
        ));
    }
    remarks
}

fn as_table(
    name: &str,
    arm: &Arm,
    model: &Model,
    format: Format,
    given: &Convert,
) -> Result<String, Failure> {
    let path = &given.robot.file.path;
    let convention = given.convention.unwrap_or(model.robot.convention);
    let impossible = || Failure::of_file(path, "no table was found that has the arm's geometry");
    let is_kept = convention == model.robot.convention
        && model.robot.rows.iter().all(|row| row.mount.is_none());
    let table = if is_kept {
        None
    } else {
        Some(Table::find(arm, convention).ok_or_else(impossible)?)
    };
    let mut remarks = remarks(path, !is_kept, model);
    let frames = model.robot.frames.iter();
    for (frame, name) in frames.zip(frame_names(&model.robot)) {
        if frame.name != name {
            remarks.push(format!("The link `{}` is the frame `{name}`.", frame.name));
        }
    }
    let mut rows = table.iter().flat_map(|table| &table.rows);
    if rows.any(|row| row.joint.is_none()) {
        remarks.push(
            "The joints `fixed_1` and so on are locked. They stand where one row cannot say what is there: between \
             axes that are nearly parallel, and where an angle is within 1e-9 of a quarter turn."
                .to_owned(),
        );
    }
    let mut allowed = Allowed::new();
    loop {
        let document = match &table {
            Some(table) => Document::of_table(table, &arm.gravity, model, &allowed),
            None => Document::as_written(model, &allowed),
        };
        let text = match format {
            Format::Json => json::text(name, &document, &remarks.join(" ")),
            _ => toml::text(&document, &remarks),
        };
        let refusals = refusals(name, &text, format);
        let Some(first) = refusals.first() else {
            return Ok(text);
        };
        // The oddities of the file that was read are meant.
        let mut is_new = false;
        for (joint, word) in refused_words(&text, format, &document, &refusals) {
            is_new |= allowed.entry(joint).or_default().insert(word);
        }
        if !is_new {
            let message = format!("no table can say this: {}", first.message);
            return Err(Failure::of_file(path, message));
        }
    }
}

fn as_urdf(name: &str, arm: &Arm, model: &Model, given: &Convert) -> Result<String, Failure> {
    let path = &given.robot.file.path;
    let without_words = urdf::without_words(arm);
    let is_missing = |word: &str| !given.without.iter().any(|known| known == word);
    let parts = without_words.iter().filter(|(word, _)| is_missing(word));
    let missing: Vec<_> = parts.map(|(_, what)| what.as_str()).collect();
    if !missing.is_empty() {
        let has = |word: &&str| without_words.iter().any(|(other, _)| other == word);
        let words: Vec<_> = WITHOUT.into_iter().filter(has).collect();
        let message = format!(
            "{}, which URDF has no words for: `--without {}` leaves it out",
            missing.join(", "),
            words.join(",")
        );
        return Err(Failure::of_file(path, message));
    }
    let mut remarks = remarks(path, true, model);
    let gravity = arm.gravity.each_ref().map(number::decimal).join(", ");
    remarks.push(format!(
        "{}; gravity, of which URDF does not tell, is [{gravity}] m/s^2.",
        urdf::extent(arm)
    ));
    remarks.extend(urdf::order(arm));
    for (_, what) in &without_words {
        remarks.push(format!("Left out: {what}."));
    }
    Ok(urdf::text(name, arm, &remarks))
}
