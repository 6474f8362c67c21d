//! A table as JSON, in the shape in which tables are published: all cells, the tensor as a list, motor and
//! friction beside the other cells.

use super::cells::TENSOR;
use super::document::Document;
use super::node::{Entries, Language, Node};
use super::number::{decimal, radians};
use super::string::quoted;

/// The text of a document; `remark` says where it is from.
pub(super) fn text(name: &str, document: &Document, remark: &str) -> String {
    let named = |word: &str, text: &str| (word.to_owned(), Node::Text(text.to_owned()));
    let mut text = "{\n".to_owned();
    let head = [named("name", name), named("remark", remark)];
    for entry in head.iter().chain(&document.entries) {
        text.push_str(&format!("  {},\n", JSON.entry(entry)));
    }
    if !document.frames.is_empty() {
        let frame = |entry| format!("    {}", JSON.entry(entry));
        let frames: Vec<_> = document.frames.iter().map(frame).collect();
        text.push_str(&format!(
            "  \"frames\": {{\n{}\n  }},\n",
            frames.join(",\n")
        ));
    }
    let joints: Vec<_> = document.joints.iter().map(joint).collect();
    let joints = joints.join(",\n");
    text + &format!("  \"joints\": [\n{joints}\n  ]\n}}\n")
}

const JSON: Language = Language {
    number: decimal,
    angle: radians,
    key: quoted,
    is: ": ",
};

/// The cells of a row, each on a line.
fn joint(cells: &Entries) -> String {
    let lines: Vec<_> = published(cells)
        .into_iter()
        .map(|(word, text)| format!("      {}: {text}", quoted(&word)))
        .collect();
    format!("    {{\n{}\n    }}", lines.join(",\n"))
}

/// The cells that every published row has, and then the others.
fn published(cells: &Entries) -> Vec<(String, String)> {
    let find = |entries: &'_ Entries, word: &str| {
        let found = entries.iter().find(|(known, _)| known == word);
        found.map(|(_, node)| JSON.value(node))
    };
    let or_zero = |text: Option<String>| text.unwrap_or_else(|| "0".to_owned());
    let mut row: Vec<(String, String)> = Vec::new();
    let mut put = |word: &str, text: String| row.push((word.to_owned(), text));
    for word in ["name", "type"] {
        put(word, find(cells, word).unwrap_or_default());
    }
    for word in ["a", "alpha", "d", "theta", "mass"] {
        put(word, or_zero(find(cells, word)));
    }
    let com = find(cells, "com");
    put("com", com.unwrap_or_else(|| "[0, 0, 0]".to_owned()));
    let part = |word: &str, entry: &str| match cells.iter().find(|(known, _)| known == word) {
        Some((_, Node::Table(entries))) => find(entries, entry),
        _ => None,
    };
    let tensor = TENSOR.map(|entry| or_zero(part("inertia", entry)));
    put("inertia", format!("[{}]", tensor.join(", ")));
    put("motor_inertia", or_zero(part("motor", "inertia")));
    put("gear_ratio", or_zero(part("motor", "gear_ratio")));
    // Friction that falls with the velocity has a table of its own.
    let stribeck = part("friction", "stribeck");
    if stribeck.is_none() {
        put("viscous", or_zero(part("friction", "viscous")));
        put("coulomb", or_zero(part("friction", "coulomb")));
    }
    for (word, node) in cells {
        let is_other = match word.as_str() {
            "friction" => stribeck.is_some(),
            word => [
                "on",
                "at",
                "gamma",
                "b",
                "spring",
                "limits",
                "torque_limit",
                "velocity_limit",
                "allow",
            ]
            .contains(&word),
        };
        if is_other {
            put(word, JSON.value(node));
        }
    }
    row
}
