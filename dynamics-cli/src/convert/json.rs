//! A table as JSON, in the shape in which tables are published: all cells, the tensor as a list, motor and
//! friction beside the other cells.

use dynamics_symbolic::exact::Rational;

use super::document::{Document, Entries, Node};
use super::number::{decimal, radians};
use super::string::quoted;
use super::written::written;

/// The text of a document; `remark` says where it is from.
pub(super) fn text(name: &str, document: &Document, remark: &str) -> String {
    let named = |word: &str, text: &str| (word.to_owned(), Node::Text(text.to_owned()));
    let mut text = "{\n".to_owned();
    for (word, node) in [named("name", name), named("remark", remark)]
        .iter()
        .chain(&document.entries)
    {
        text.push_str(&format!("  {}: {},\n", quoted(word), value(node)));
    }
    let joints: Vec<_> = document.joints.iter().map(joint).collect();
    text.push_str(&format!(
        "  \"joints\": [\n{}\n  ]\n}}\n",
        joints.join(",\n")
    ));
    text
}

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
        found.map(|(_, node)| value(node))
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
    let zeros = |count| Node::List((0..count).map(|_| Node::Number(Rational::ZERO)).collect());
    put(
        "com",
        find(cells, "com").unwrap_or_else(|| value(&zeros(3))),
    );
    let part = |word: &str, entry: &str| match cells.iter().find(|(known, _)| known == word) {
        Some((_, Node::Table(entries))) => find(entries, entry),
        _ => None,
    };
    let tensor = ["xx", "yy", "zz", "xy", "yz", "xz"].map(|entry| or_zero(part("inertia", entry)));
    put("inertia", format!("[{}]", tensor.join(", ")));
    put("motor_inertia", or_zero(part("motor", "inertia")));
    put("gear_ratio", or_zero(part("motor", "gear_ratio")));
    // What depends on the velocity has a table of its own.
    let stribeck = part("friction", "stribeck");
    if stribeck.is_none() {
        put("viscous", or_zero(part("friction", "viscous")));
        put("coulomb", or_zero(part("friction", "coulomb")));
    }
    for (word, node) in cells {
        let is_other = match word.as_str() {
            "friction" => stribeck.is_some(),
            word => ["spring", "limits", "allow"].contains(&word),
        };
        if is_other {
            put(word, value(node));
        }
    }
    row
}

fn value(node: &Node) -> String {
    match node {
        Node::Number(x) => decimal(x),
        Node::Written(value) => written(value),
        Node::Angle(angle) => radians(angle),
        Node::Text(text) => quoted(text),
        Node::List(values) => {
            let values: Vec<_> = values.iter().map(value).collect();
            format!("[{}]", values.join(", "))
        }
        Node::Table(entries) => {
            let entry =
                |(word, node): &(String, Node)| format!("{}: {}", quoted(word), value(node));
            let entries: Vec<_> = entries.iter().map(entry).collect();
            format!("{{ {} }}", entries.join(", "))
        }
    }
}
