//! Mistakes and doubtful things in robot files.

use std::path::{Path, PathBuf};

use dynamics_codegen::description::Masses;
use dynamics_codegen::files::Format;
use dynamics_codegen::lint::judged;
use dynamics_codegen::{Finding, Severity};
use dynamics_evaluation::{FileError, FileMistake, ReadOptions, read_source, read_text};

use crate::arguments::Lint;
use crate::convert::quoted;
use crate::excerpt::without_controls;
use crate::failure::Failure;
use crate::load::for_command;

/// A line of the output.
struct Row {
    file: PathBuf,
    found: Finding,
}

/// The text of `lint`.
pub(crate) fn run(given: &Lint) -> Result<String, Failure> {
    let rows: Vec<Row> = given.file.iter().flat_map(|path| rows(path)).collect();
    let output = match given.format.as_str() {
        "json" => json(&rows),
        _ => text(&rows, given.file.len()),
    };
    match rows.iter().any(|row| row.found.severity == Severity::Error) {
        true => Err(Failure::within(output)),
        false => Ok(output),
    }
}

/// All that is found in a file, from its top to its end.
fn rows(path: &Path) -> Vec<Row> {
    let mut rows = rows_of_text(path).unwrap_or_else(|error| mistaken(path, &error));
    rows.sort_by_key(|row| (row.file != path, row.found.line, row.found.column));
    rows
}

fn rows_of_text(path: &Path) -> Result<Vec<Row>, FileError> {
    let text = read_text(path)?;
    let format = Format::of(path).ok_or_else(|| FileError::UnknownFormat(path.to_owned()))?;
    let mut judged = judged(&text, format);
    let read = read_source(path, &text, &options(format, judged.moving_base));
    let mut rows = Vec::new();
    match read {
        Ok(model) => judged.findings.extend(model.warnings),
        Err(error) => {
            rows.extend(mistaken(path, &error));
            // Notes are of robots.
            judged
                .findings
                .retain(|found| found.severity != Severity::Note);
        }
    }
    rows.extend(judged.findings.into_iter().map(|found| Row {
        file: path.to_owned(),
        found: Finding {
            message: for_command(&found.message),
            ..found
        },
    }));
    Ok(rows)
}

/// Options by which a file is read as far as it is a robot by itself. The author of a table has its words, the reader of a
/// tree of links those of the command. Masses in other units are doubtful here, by a rule of files.
fn options(format: Format, moving_base: Option<Option<String>>) -> ReadOptions {
    let mut options = ReadOptions::new().masses(Masses::IfAny);
    if format != Format::Urdf {
        return options.names_are_fields();
    }
    options = options
        .entries("gravity = [0, 0, -9.81]\nallow = [\"odd_mass\"]")
        .for_command(Vec::new());
    if let Some(first) = moving_base {
        options = options.entries("base = \"floating\"");
        if let Some(first) = first {
            options = options.chain([first]);
        }
    }
    options
}

/// The mistakes for which a file is refused. Limits of this program are no mistakes of the file, and mistakes in options are
/// those of the whole file.
fn mistaken(path: &Path, error: &FileError) -> Vec<Row> {
    let row = |mistake: FileMistake| {
        let is_limit = mistake.rule.starts_with("size::");
        let place = mistake
            .file
            .as_ref()
            .map(|_| (mistake.line, mistake.column));
        let (line, column) = place.unwrap_or((1, 1));
        Row {
            file: mistake.file.unwrap_or_else(|| path.to_owned()),
            found: Finding {
                line,
                column,
                rule: mistake.rule,
                severity: if is_limit {
                    Severity::Note
                } else {
                    Severity::Error
                },
                message: mistake.message,
                remedy: None,
            },
        }
    };
    error.mistakes().into_iter().map(row).collect()
}

/// A line for each row, and a last one that counts them.
fn text(rows: &[Row], files: usize) -> String {
    let line = |Row { file, found }: &Row| {
        let line = format!("{}:{found}", file.display());
        without_controls(&line) + "\n"
    };
    let text: String = rows.iter().map(line).collect();
    let count = |severity| {
        rows.iter()
            .filter(|row| row.found.severity == severity)
            .count()
    };
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

/// The advice of a mistake: it stands behind the first `: ` that is not between backticks, as words of a file are.
fn advice(message: &str) -> Option<&str> {
    let mut is_word = false;
    let end = message.char_indices().find_map(|(at, letter)| {
        is_word ^= letter == '`';
        let rest = message[at..].strip_prefix(": ");
        rest.filter(|_| !is_word)
    });
    end.filter(|advice| !advice.is_empty())
}

/// A list of objects, each on a line.
fn json(rows: &[Row]) -> String {
    let object = |Row { file, found }: &Row| {
        let remedy = found.remedy.as_deref().or_else(|| advice(&found.message));
        let remedy = remedy.map(quoted);
        let members = [
            ("file", quoted(&file.to_string_lossy())),
            ("line", found.line.to_string()),
            ("column", found.column.to_string()),
            ("rule", quoted(found.rule)),
            ("severity", quoted(&found.severity.to_string())),
            ("message", quoted(&found.message)),
            ("remedy", remedy.unwrap_or_else(|| "null".to_owned())),
        ];
        let members = members.map(|(key, value)| format!("{}: {value}", quoted(key)));
        format!("  {{{}}}", members.join(", "))
    };
    let objects: Vec<_> = rows.iter().map(object).collect();
    match objects.is_empty() {
        true => "[]\n".to_owned(),
        false => format!("[\n{}\n]\n", objects.join(",\n")),
    }
}
