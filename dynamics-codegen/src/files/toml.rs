//! TOML, as a tree.

use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

use crate::diagnose::Diagnostics;
use crate::mistake::file as mistake;
use crate::tree::{Key, Kind, Lines, Node};

/// Reads a document; what is no TOML is reported. Errors behind the first one follow from it, most of them.
pub(super) fn document(text: &str, diagnostics: &Diagnostics) -> Option<Node> {
    let lines = Lines::new(text);
    let (document, errors) = DeTable::parse_recoverable(text);
    let start = |error: &toml::de::Error| error.span().map_or(0, |span| span.start);
    if let Some(error) = errors.iter().min_by_key(|error| start(error)) {
        let start = start(error);
        let mistake = if is_single_joint(text, start) {
            mistake::single_brackets()
        } else {
            mistake::syntax("TOML", error.message())
        };
        diagnostics.error(lines.place(start), mistake);
    }
    errors
        .is_empty()
        .then(|| Node::new(lines.place(0), table(document.get_ref(), &lines)))
}

/// Whether what begins behind so many bytes is the word of a line `[joint]`.
fn is_single_joint(text: &str, start: usize) -> bool {
    let (Some(before), Some(behind)) = (text.get(..start), text.get(start..)) else {
        return false;
    };
    let line = before.lines().next_back().unwrap_or_default();
    line.trim() == "[" && behind.starts_with("joint]")
}

/// The items in the order in which they were written.
fn table(table: &DeTable, lines: &Lines) -> Kind {
    let mut items: Vec<_> = table.iter().collect();
    items.sort_by_key(|(key, _)| key.span().start);
    let item = |(key, value): (&Spanned<DeString>, &Spanned<DeValue>)| {
        let place = lines.place(key.span().start);
        (Key::new(key.get_ref().as_ref(), place), node(value, lines))
    };
    Kind::Table(items.into_iter().map(item).collect())
}

fn node(value: &Spanned<DeValue>, lines: &Lines) -> Node {
    let kind = match value.get_ref() {
        DeValue::String(text) => Kind::Text(text.to_string()),
        DeValue::Integer(number) if number.radix() == 10 => {
            Kind::Number(number.as_str().to_owned())
        }
        DeValue::Integer(_) => Kind::Other("a number that is not decimal"),
        DeValue::Float(number) => Kind::Number(number.as_str().to_owned()),
        DeValue::Boolean(truth) => Kind::Truth(*truth),
        DeValue::Datetime(_) => Kind::Other("a date"),
        DeValue::Array(values) => {
            Kind::List(values.iter().map(|value| node(value, lines)).collect())
        }
        DeValue::Table(items) => table(items, lines),
    };
    Node::new(lines.place(value.span().start), kind)
}
