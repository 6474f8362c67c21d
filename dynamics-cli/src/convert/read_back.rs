//! The answer of the macro's own reader to a table that was written.

use dynamics_codegen::description::{Allow, Place};
use dynamics_codegen::files::{Format, Request, table};
use dynamics_codegen::{Error, check};

use super::document::Document;

/// Why the table cannot be read; nothing where it can.
pub(super) fn refusals(name: &str, text: &str, format: Format) -> Vec<Error> {
    let read = table(name, text, format, &Request::default());
    match read.and_then(|table| check(&table)) {
        Ok(_) => Vec::new(),
        Err(errors) => errors,
    }
}

/// The words by which a table accepts what was refused, as the refusals name them, each with the joint or frame whose
/// entries it goes into; without one it is for the whole table.
pub(super) fn refused_words(
    text: &str,
    format: Format,
    document: &Document,
    refusals: &[Error],
) -> Vec<(Option<String>, &'static str)> {
    let is_head = |line: &&str| match format {
        Format::Json => *line == "    {" || line.starts_with("    \""),
        _ => *line == "[[joint]]" || line.starts_with("[frame."),
    };
    let word_of = |error: &Error| {
        let word = Allow::WORDS
            .into_iter()
            .find(|word| error.message.contains(word))?;
        // A word of the whole table belongs in no row, wherever the number stands that it accepts.
        let is_of_table = error.message.contains("at the top of the file");
        let Place::File { line, .. } = error.place else {
            return Some((None, word));
        };
        let parts = text.lines().take(line).filter(is_head).count();
        let part = parts
            .checked_sub(1)
            .and_then(|part| document.parts().nth(part));
        Some((part.filter(|_| !is_of_table).cloned(), word))
    };
    refusals.iter().filter_map(word_of).collect()
}
