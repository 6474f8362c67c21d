//! What is wrong or doubtful in robot files.

use std::path::{Path, PathBuf};

use clap::ArgMatches;
use dynamics_codegen::description::Masses;
use dynamics_codegen::files::Format;
use dynamics_codegen::lint::{Finding, judged};
use dynamics_codegen::{Note, Severity};
use dynamics_evaluation::{FileError, FileMistake, ReadOptions, read_source, read_text};

use crate::convert::quoted;
use crate::excerpt::without_controls;
use crate::failure::Failure;
use crate::load::for_command;

/// A line of the output.
struct Row {
    file: PathBuf,
    line: usize,
    column: usize,
    rule: &'static str,
    severity: Severity,
    message: String,
    /// How to mend it; none if the message says that.
    remedy: Option<String>,
}

/// The text of `lint`.
pub(crate) fn run(given: &ArgMatches) -> Result<String, Failure> {
    let files = given.get_many::<PathBuf>("file").into_iter().flatten();
    let rows: Vec<Row> = files.clone().flat_map(|path| rows(path)).collect();
    let is_json = given
        .get_one::<String>("format")
        .is_some_and(|format| format == "json");
    let output = if is_json {
        json(&rows)
    } else {
        text(&rows, files.count())
    };
    match rows.iter().any(|row| row.severity == Severity::Error) {
        true => Err(Failure::told_by(output)),
        false => Ok(output),
    }
}

/// All that is found in a file, from its top to its end.
fn rows(path: &Path) -> Vec<Row> {
    let mut rows = rows_of_text(path).unwrap_or_else(|error| {
        let mistakes = error.mistakes().into_iter();
        mistakes.map(|mistake| mistaken(path, mistake)).collect()
    });
    rows.sort_by_key(|row| (row.file != path, row.line, row.column));
    rows
}

fn rows_of_text(path: &Path) -> Result<Vec<Row>, FileError> {
    let text = read_text(path)?;
    let format = Format::of(path).ok_or_else(|| FileError::UnknownFormat(path.to_owned()))?;
    let judged = judged(&text, format);
    let read = read_source(path, &text, &options(format, judged.moving_base));
    let mut rows: Vec<Row> = match read {
        Ok(model) => model
            .warnings
            .into_iter()
            .map(|note| noted(path, &note))
            .collect(),
        Err(error) => error
            .mistakes()
            .into_iter()
            .map(|mistake| mistaken(path, mistake))
            .collect(),
    };
    rows.extend(
        judged
            .findings
            .into_iter()
            .map(|finding| found(path, finding)),
    );
    Ok(rows)
}

/// Options by which a file is read as far as it is a robot by itself. The author of a table has its words, the reader of a
/// tree of links those of the command.
fn options(format: Format, moving_base: Option<Option<String>>) -> ReadOptions {
    let mut options = ReadOptions::new().masses(Masses::IfAny);
    if format != Format::Urdf {
        return options.names_are_fields();
    }
    options = options
        .entries("gravity = [0, 0, -9.81]")
        .for_command(Vec::new());
    if let Some(first) = moving_base {
        options = options.entries("base = \"floating\"").chain(first);
    }
    options
}

/// A mistake for which the file is refused. Limits of this program are no mistakes of the file.
fn mistaken(path: &Path, mistake: FileMistake) -> Row {
    Row {
        file: mistake.file.unwrap_or_else(|| path.to_owned()),
        line: mistake.line,
        column: mistake.column,
        rule: mistake.rule,
        severity: if mistake.rule.starts_with("size::") {
            Severity::Note
        } else {
            Severity::Error
        },
        message: mistake.message,
        remedy: None,
    }
}

fn noted(path: &Path, note: &Note) -> Row {
    let (line, column) = note.position;
    Row {
        file: path.to_owned(),
        line,
        column,
        rule: note.rule,
        severity: note.severity,
        message: for_command(&note.text),
        remedy: None,
    }
}

fn found(path: &Path, finding: Finding) -> Row {
    Row {
        file: path.to_owned(),
        line: finding.line,
        column: finding.column,
        rule: finding.rule,
        severity: finding.severity,
        message: finding.message,
        remedy: Some(finding.remedy),
    }
}

/// A line for each row, and a last one that counts them.
fn text(rows: &[Row], files: usize) -> String {
    let mut text = String::new();
    for Row {
        file,
        line,
        column,
        rule,
        severity,
        message,
        remedy,
    } in rows
    {
        let remedy = remedy
            .as_ref()
            .map_or(String::new(), |remedy| format!(": {remedy}"));
        let file = file.display();
        text += &without_controls(&format!(
            "{file}:{line}:{column}: {severity}: {message} [{rule}]{remedy}"
        ));
        text.push('\n');
    }
    let count = |severity| rows.iter().filter(|row| row.severity == severity).count();
    let [errors, warnings, notes] = [Severity::Error, Severity::Warning, Severity::Note].map(count);
    let files = counted(files, "file");
    text + &match rows {
        [] => format!("{files}: nothing found\n"),
        _ => format!(
            "{files}: {}, {}, {}\n",
            counted(errors, "error"),
            counted(warnings, "warning"),
            counted(notes, "note")
        ),
    }
}

fn counted(count: usize, what: &str) -> String {
    let end = if count == 1 { "" } else { "s" };
    format!("{count} {what}{end}")
}

/// A list of objects, each on a line.
fn json(rows: &[Row]) -> String {
    let object = |row: &Row| {
        let remedy = row.remedy.as_deref().map_or("null".to_owned(), quoted);
        format!(
            "  {{\"file\": {}, \"line\": {}, \"column\": {}, \"rule\": {}, \"severity\": \"{}\", \"message\": {}, \"remedy\": {remedy}}}",
            quoted(&row.file.to_string_lossy()),
            row.line,
            row.column,
            quoted(row.rule),
            row.severity,
            quoted(&row.message),
        )
    };
    let objects: Vec<_> = rows.iter().map(object).collect();
    match objects.is_empty() {
        true => "[]\n".to_owned(),
        false => format!("[\n{}\n]\n", objects.join(",\n")),
    }
}
