//! A table as TOML.

use super::document::Document;
use super::node::{Entries, Language, Node};
use super::number::{decimal, fraction, radians, turns};
use super::string::quoted;

/// The text of a document.
pub(super) fn text(document: &Document, remarks: &[String]) -> String {
    let mut text: String = remarks.iter().map(|line| format!("# {line}\n")).collect();
    // Tables with a head of their own come behind all others.
    let (tables, lines): (Vec<_>, Vec<_>) = document
        .entries
        .iter()
        .partition(|(word, _)| matches!(word.as_str(), "base" | "tool"));
    for line in lines {
        text.push_str(&format!("{}\n", TOML.entry(line)));
    }
    let tables = tables.into_iter().map(|(word, node)| (key(word), node));
    let frames = document.frames.iter();
    let frames = frames.map(|(name, node)| (format!("frame.{}", key(name)), node));
    for (head, node) in tables.chain(frames) {
        text.push_str(&format!("\n[{head}]\n"));
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

const TOML: Language = Language {
    number: |x| fraction(x).map_or_else(|| decimal(x), |fraction| quoted(&fraction)),
    angle: |angle| turns(angle).map_or_else(|| radians(angle), quoted),
    key,
    is: " = ",
};

fn each_on_a_line(entries: &Entries) -> String {
    let line = |entry| format!("{}\n", TOML.entry(entry));
    entries.iter().map(line).collect()
}

/// A key, in quotes where it needs them.
fn key(word: &str) -> String {
    let is_bare = |letter: char| letter.is_ascii_alphanumeric() || "_-".contains(letter);
    if !word.is_empty() && word.chars().all(is_bare) {
        word.to_owned()
    } else {
        quoted(word)
    }
}
