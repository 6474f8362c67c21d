//! JSON, as a tree with the words of TOML.
//!
//! The shape is that of published tables. They have `joints` with the cells `a`, `alpha`, `d`, `theta`,
//! `mass`, `com`, `inertia` (a list: xx, yy, zz, xy, yz, xz), `motor_inertia`, `gear_ratio`, `viscous`,
//! `coulomb`. They also have `tool`, `frames`, a `base` that moves, whose `inertia` is such a list too, and
//! notes such as `source`. The words of the macro are read as well.

use jsonc_parser::ast::{ObjectProp, Value};
use jsonc_parser::common::Ranged;
use jsonc_parser::{CollectOptions, ParseOptions, parse_to_ast};

use crate::diagnose::Diagnostics;
use crate::keys::{KEYS_OF_FILES as KEYS, KEYS_OF_PROJECTS, MOVING, TENSOR};
use crate::mistake::file as mistake;
use crate::place::Place;
use crate::tree::{Key, Kind, Lines, Node};
use crate::words;

/// JSON as RFC 8259 has it: without comments and the like.
const STRICT: ParseOptions = ParseOptions {
    allow_comments: false,
    allow_loose_object_property_names: false,
    allow_trailing_commas: false,
    allow_missing_commas: false,
    allow_single_quoted_strings: false,
    allow_hexadecimal_numbers: false,
    allow_unary_plus_numbers: false,
    allow_bare_decimal_point_numbers: false,
    allow_non_finite_numbers: false,
    allow_extended_string_escapes: false,
};

/// Reads a document; what is no JSON is reported. The mark at the start of a file, which editors of Windows write, says nothing.
pub(crate) fn document(text: &str, diagnostics: &Diagnostics) -> Option<Node> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let lines = Lines::new(text);
    match parse_to_ast(text, &CollectOptions::default(), &STRICT) {
        Ok(document) => {
            let mut root = match &document.value {
                Some(value) => node(value, &lines),
                None => Node::new(lines.place(0), Kind::Other("nothing")),
            };
            with_words_of_toml(&mut root);
            Some(root)
        }
        Err(error) => {
            let place = lines.place(error.range().start);
            diagnostics.error(place, mistake::syntax("JSON", &error.kind().to_string()));
            None
        }
    }
}

fn node(value: &Value, lines: &Lines) -> Node {
    let kind = match value {
        Value::StringLit(text) => Kind::Text(text.value.to_string()),
        Value::NumberLit(number) => Kind::Number(number.value.to_owned()),
        Value::BooleanLit(truth) => Kind::Truth(truth.value),
        Value::NullKeyword(_) => Kind::Other("`null`"),
        Value::Array(values) => {
            Kind::List(values.elements.iter().map(|v| node(v, lines)).collect())
        }
        Value::Object(object) => {
            let item = |item: &ObjectProp| {
                let place = lines.place(item.range.start);
                (
                    Key::new(item.name.as_str(), place),
                    node(&item.value, lines),
                )
            };
            Kind::Table(object.properties.iter().map(item).collect())
        }
    };
    Node::new(lines.place(value.range().start), kind)
}

/// Puts what a published table says in the words of the macro.
fn with_words_of_toml(root: &mut Node) {
    let Some(items) = root.items_mut() else {
        return;
    };
    let is_published = has(items, "source");
    // Beside joints, a file that is named is a remark.
    let is_list =
        |(key, value): &(Key, Node)| key.word == "joints" && matches!(value.kind, Kind::List(_));
    let names_file = has(items, "file") && !items.iter().any(is_list);
    let keys = if names_file { KEYS_OF_PROJECTS } else { KEYS };
    items.retain(|(key, _)| !is_note(&key.word, keys));
    for (key, value) in items {
        match key.word.as_str() {
            "joints" if !names_file => {
                key.word = "joint".to_owned();
                if let Kind::List(rows) = &mut value.kind {
                    for (index, row) in rows.iter_mut().enumerate() {
                        joint(row, index, is_published);
                    }
                }
            }
            "frame" | "frames" => {
                key.word = "frame".to_owned();
                for (_, frame) in value.items_mut().into_iter().flatten() {
                    let place = frame.place;
                    if let Some(cells) = frame.items_mut() {
                        body(cells, place, is_published);
                    }
                }
            }
            "tool" | "base" => {
                let (place, is_tool) = (value.place, key.word == "tool");
                if let Some(cells) = value.items_mut()
                    && (is_tool || has(cells, MOVING))
                {
                    body(cells, place, is_published);
                }
            }
            _ => {}
        }
    }
}

/// Whether the key is a remark, which says nothing about the robot: it is not a known key, nor similar to one.
fn is_note(word: &str, keys: &[&str]) -> bool {
    !["joints", "frames"].contains(&word)
        && !keys.contains(&word)
        && words::nearest(word, keys).is_none()
}

fn joint(row: &mut Node, index: usize, is_published: bool) {
    let place = row.place;
    let Some(cells) = row.items_mut() else {
        return;
    };
    if !has(cells, "name") {
        let name = text(format!("joint{}", index + 1), place);
        cells.push((Key::new("name", place), name));
    }
    body(cells, place, is_published);
    // A motor without inertia is none.
    let motor = take(
        cells,
        &[("motor_inertia", "inertia"), ("gear_ratio", "gear_ratio")],
    );
    let is_motor = motor
        .iter()
        .any(|(key, value)| key.word == "inertia" && !is_zero(value));
    if is_motor || !has(&motor, "inertia") {
        put(cells, "motor", motor);
    }
    let friction = take(cells, &[("viscous", "viscous"), ("coulomb", "coulomb")]);
    put(cells, "friction", friction);
}

/// Cells of a body, whose tensor is a list.
fn body(cells: &mut Vec<(Key, Node)>, place: Place, is_published: bool) {
    for (key, value) in cells.iter_mut() {
        if let ("inertia" | "inertia_at_origin", Kind::List(entries)) =
            (key.word.as_str(), &mut value.kind)
            && entries.len() == TENSOR.keys.len()
        {
            let entries = TENSOR.keys.iter().zip(entries.drain(..));
            let entry = |(word, entry): (&&str, Node)| (Key::new(*word, entry.place), entry);
            value.kind = Kind::Table(entries.map(entry).collect());
        }
    }
    // Published tensors may be those of no body. Who names the source means them as they are.
    if is_published && !has(cells, "allow") {
        let allowed = text("unphysical_inertia".to_owned(), place);
        let list = Node::new(place, Kind::List(vec![allowed]));
        cells.push((Key::new("allow", place), list));
    }
}

fn text(text: String, place: Place) -> Node {
    Node::new(place, Kind::Text(text))
}

fn has(cells: &[(Key, Node)], word: &str) -> bool {
    cells.iter().any(|(key, _)| key.word == word)
}

fn is_zero(value: &Node) -> bool {
    match &value.kind {
        Kind::Number(text) => text.parse::<f64>().is_ok_and(|x| x == 0.0),
        _ => false,
    }
}

/// Takes the cells of those words out, and gives them the other ones.
fn take(cells: &mut Vec<(Key, Node)>, words: &[(&str, &str)]) -> Vec<(Key, Node)> {
    let renamed = |key: &Key| words.iter().find(|(word, _)| *word == key.word);
    let (taken, left): (Vec<_>, Vec<_>) = core::mem::take(cells)
        .into_iter()
        .partition(|(key, _)| renamed(key).is_some());
    *cells = left;
    let rename = |(mut key, value): (Key, Node)| {
        if let Some((_, word)) = renamed(&key) {
            key.word = (*word).to_owned();
        }
        (key, value)
    };
    taken.into_iter().map(rename).collect()
}

/// Puts the parts in a table of their own.
fn put(cells: &mut Vec<(Key, Node)>, word: &str, parts: Vec<(Key, Node)>) {
    if let Some((first, _)) = parts.first() {
        let place = first.place;
        let table = Node::new(place, Kind::Table(parts));
        cells.push((Key::new(word, place), table));
    }
}
