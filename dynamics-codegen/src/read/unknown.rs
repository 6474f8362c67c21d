//! Words that mean nothing where they stand, and those that were probably meant.

use crate::keys::{
    BASE, BESIDE_A_FILE, FLOATING, FLOATING_IN_FILE, FRICTION, KEYS_OF_FILES, MOTOR, OF_A_FILE,
    Part, SPRING, TENSOR,
};
use crate::mistake::{self, Mistake, base, file as wrong};
use crate::tree::Language;
use crate::words;

/// The mistake of an unknown word, and the word that was probably meant.
pub(super) struct Unknown {
    pub(super) mistake: Mistake,
    pub(super) meant: Option<&'static str>,
}

/// A word that is not in `known`: the message names the nearest known word if one is near, otherwise all of them.
pub(super) fn unknown(what: &str, word: &str, known: &[&'static str]) -> Unknown {
    let meant = words::meant(word, known);
    Unknown {
        mistake: mistake::unknown(what, word, meant, known),
        meant,
    }
}

/// The mistake of a key that a part does not have.
pub(super) fn unknown_key(part: &Part, word: &str, language: Language) -> Unknown {
    match part.item {
        "cell" => unknown_cell(part, word, language),
        item if item == TENSOR.item => unknown_entry(word),
        item if item == BASE.item => unknown_of_base(part, word),
        item => unknown(item, word, part.keys),
    }
}

/// The mistake of a word that is no entry of the base: one that moves has no place, one that stands has no body.
fn unknown_of_base(part: &Part, word: &str) -> Unknown {
    let means = |known: &[&'static str]| words::meant(word, known).is_some();
    let mistake = if means(part.keys) {
        None
    } else if !part.keys.contains(&"xyz") {
        means(BASE.keys).then(|| base::placed(word))
    } else if means(FLOATING.keys) {
        Some(base::body_of_standing(word))
    } else {
        means(FLOATING_IN_FILE.keys).then(base::word_in_braces)
    };
    match mistake {
        Some(mistake) => Unknown {
            mistake,
            meant: None,
        },
        None => unknown(part.item, word, part.keys),
    }
}

/// Cells of a published table that stand in parts of a row here.
const PUBLISHED: [&str; 4] = ["motor_inertia", "gear_ratio", "viscous", "coulomb"];

/// The mistake of a key that is no cell of a row. Published tables have keys of their own.
fn unknown_cell(part: &Part, word: &str, language: Language) -> Unknown {
    let certain = |mistake| Unknown {
        mistake,
        meant: None,
    };
    let is_json = language == Language::Json;
    let is_beside = part.name == BESIDE_A_FILE.name;
    if is_beside && OF_A_FILE.contains(&word) {
        return certain(wrong::said_by_the_file(word, part.keys));
    }
    if language != Language::Call && KEYS_OF_FILES.contains(&word) {
        return certain(wrong::of_the_whole_table(word, is_json, is_beside));
    }
    let published = unknown("cell", word, &PUBLISHED);
    if is_json && published.meant.is_some() {
        return certain(published.mistake);
    }
    let parts = [
        ("motor", &MOTOR),
        ("friction", &FRICTION),
        ("spring", &SPRING),
        ("inertia", &TENSOR),
    ];
    let is_home = |(_, part): &&(&str, &Part)| part.keys.contains(&word);
    match parts.iter().find(is_home) {
        Some((cell, _)) => certain(mistake::joint::cell_elsewhere(word, cell)),
        // The name and the type of a row in a file are no cells.
        None => unknown(
            "cell",
            word,
            part.keys
                .strip_prefix(&["name", "type"])
                .unwrap_or(part.keys),
        ),
    }
}

/// The mistake of a word that is no entry of a tensor: `Ixx` and the like, below the diagonal, or a slip.
fn unknown_entry(word: &str) -> Unknown {
    let lower = word.to_lowercase();
    let axes = lower.trim_start_matches('i').trim_start_matches('_');
    let meant = |meant: &'static str, mistake| Unknown {
        mistake,
        meant: Some(meant),
    };
    if let Some(entry) = TENSOR.keys.iter().find(|entry| **entry == axes) {
        let mistake = mistake::unknown(TENSOR.item, word, Some(entry), TENSOR.keys);
        return meant(entry, mistake);
    }
    let mirrored = |entry: &&&str| entry.chars().rev().eq(axes.chars());
    match TENSOR.keys.iter().find(mirrored) {
        Some(entry) => meant(entry, mistake::joint::mirrored_entry(word, entry)),
        None => unknown(TENSOR.item, word, TENSOR.keys),
    }
}
