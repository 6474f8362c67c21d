//! A table as TOML.

use super::document::{Document, Entries, Node};
use super::number::{decimal, fraction, radians, turns};
use super::string::quoted;
use super::written::written;

/// The text of a document.
pub(super) fn text(document: &Document, remarks: &[String]) -> String {
    let mut text: String = remarks.iter().map(|line| format!("# {line}\n")).collect();
    // Tables with a head of their own come behind all others.
    let (tables, lines): (Vec<_>, Vec<_>) = document
        .entries
        .iter()
        .partition(|(word, _)| matches!(word.as_str(), "base" | "tool"));
    for (word, node) in lines {
        text.push_str(&format!("{} = {}\n", key(word), value(node)));
    }
    for (word, node) in tables {
        text.push_str(&format!("\n[{}]\n", key(word)));
        if let Node::Table(entries) = node {
            text.push_str(&each_on_a_line(entries));
        }
    }
    for joint in &document.joints {
        text.push_str("\n[[joint]]\n");
        text.push_str(&each_on_a_line(joint));
    }
    text
}

fn each_on_a_line(entries: &Entries) -> String {
    let line = |(word, node): &(String, Node)| format!("{} = {}\n", key(word), value(node));
    entries.iter().map(line).collect()
}

fn value(node: &Node) -> String {
    match node {
        Node::Number(x) => match fraction(x) {
            Some(fraction) => quoted(&fraction),
            None => decimal(x),
        },
        Node::Written(value) => written(value),
        Node::Angle(angle) => turns(angle).map_or_else(|| radians(angle), quoted),
        Node::Text(text) => quoted(text),
        Node::List(values) => {
            let values: Vec<_> = values.iter().map(value).collect();
            format!("[{}]", values.join(", "))
        }
        Node::Table(entries) => {
            let entry = |(word, node): &(String, Node)| format!("{} = {}", key(word), value(node));
            let entries: Vec<_> = entries.iter().map(entry).collect();
            format!("{{ {} }}", entries.join(", "))
        }
    }
}

/// A key, in quotes where it needs them.
fn key(word: &str) -> String {
    let is_bare = |letter: char| letter.is_ascii_alphanumeric() || "_-".contains(letter);
    match !word.is_empty() && word.chars().all(is_bare) {
        true => word.to_owned(),
        false => quoted(word),
    }
}
