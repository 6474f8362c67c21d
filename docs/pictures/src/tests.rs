//! The pictures in the repository, and whether they can be read.

use std::fs;

use measuring::drawing::{RULES, Written};

use crate::table::Table;
use crate::{FOLDER, pictures, read, root, with_alternative};

#[test]
fn the_files_are_what_the_program_writes() {
    let root = root();
    let mut files = fs::read_dir(root.join(FOLDER)).expect("pictures").count();
    for picture in pictures(&root) {
        let path = format!("{FOLDER}/{}.svg", picture.name);
        let there = fs::read_to_string(root.join(&path)).unwrap_or_default();
        assert!(
            there == picture.drawing.svg(),
            "{path}: run `cargo run -p pictures`"
        );
        files -= 1;
    }
    assert_eq!(files, 0, "{FOLDER} has other files");
}

#[test]
fn documents_say_what_the_pictures_show() {
    let root = root();
    for picture in pictures(&root) {
        for document in picture.documents {
            let there = read(&root, document);
            let text = with_alternative(&there, picture.name, &picture.alternative);
            assert!(text == there, "{document}: run `cargo run -p pictures`");
        }
    }
}

#[test]
fn words_stay_apart_and_within() {
    for picture in pictures(&root()) {
        let [width, height] = picture.drawing.size();
        let written = picture.drawing.written();
        for (number, one) in written.iter().enumerate() {
            let [left, top, right, bottom] = one.within;
            assert!(
                left >= 4.0 && top >= 4.0 && right <= width - 4.0 && bottom <= height - 4.0,
                "{}: {one:?} leaves the picture",
                picture.name
            );
            for other in &written[..number] {
                assert!(!overlap(one, other), "{}: {one:?}, {other:?}", picture.name);
            }
        }
    }
}

fn overlap(one: &Written, other: &Written) -> bool {
    let [left, top, right, bottom] = one.within;
    let [other_left, other_top, other_right, other_bottom] = other.within;
    left < other_right && other_left < right && top < other_bottom && other_top < bottom
}

#[test]
fn words_that_overlap_are_found() {
    let at = |left: f64, top: f64| Written {
        words: String::new(),
        within: [left, top, left + 10.0, top + 10.0],
    };
    assert!(overlap(&at(0.0, 0.0), &at(9.0, 9.0)));
    assert!(!overlap(&at(0.0, 0.0), &at(11.0, 0.0)));
    assert!(!overlap(&at(0.0, 0.0), &at(0.0, 11.0)));
}

/// The colour of a class in the light or the dark theme.
fn colour(selector: &str, property: &str, theme: usize) -> &'static str {
    let rule = RULES
        .iter()
        .find(|rule| rule.0 == selector && rule.1 == property);
    rule.unwrap_or_else(|| panic!("{selector} has no {property}"))
        .2[theme]
}

/// The relative luminance of `#rrggbb` (Web Content Accessibility Guidelines 2.2).
fn luminance(colour: &str) -> f64 {
    let part = |k: usize| {
        let value = u8::from_str_radix(&colour[k..k + 2], 16).expect("two digits");
        match f64::from(value) / 255.0 {
            value if value <= 0.04045 => value / 12.92,
            value => ((value + 0.055) / 1.055).powf(2.4),
        }
    };
    0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5)
}

fn contrast(one: &str, other: &str) -> f64 {
    let (one, other) = (luminance(one), luminance(other));
    (one.max(other) + 0.05) / (one.min(other) + 0.05)
}

/// Words have a contrast of 4.5 on all that they are written on; lines and marks of 3 on the ground, as
/// the guidelines have it.
#[test]
fn colours_can_be_told_from_the_ground() {
    assert!((contrast("#000000", "#ffffff") - 21.0).abs() < 1e-9);
    assert!((contrast("#777777", "#ffffff") - 4.48).abs() < 0.01);
    for theme in [0, 1] {
        for ink in ["text", ".faint", ".red", ".green", ".blue"] {
            for ground in [".ground", ".band", ".box"] {
                let contrast = contrast(colour(ink, "fill", theme), colour(ground, "fill", theme));
                assert!(contrast >= 4.5, "{ink} on {ground}: {contrast:.2}");
            }
        }
        let ground = colour(".ground", "fill", theme);
        let marks = ["0", "1", "2", "3", "4", "5"].map(|number| format!(".m{number}"));
        for mark in marks
            .iter()
            .map(String::as_str)
            .chain([".bar-a", ".bar-b", ".bar-c"])
        {
            let contrast = contrast(colour(mark, "fill", theme), ground);
            assert!(contrast >= 3.0, "{mark}: {contrast:.2}");
        }
    }
}

/// An element of a class without a rule would be black, or not be seen.
#[test]
fn every_class_has_a_colour() {
    for picture in pictures(&root()) {
        let svg = picture.drawing.svg();
        for part in svg.split("class=\"").skip(1) {
            let class = part.split('"').next().unwrap_or_default();
            let is_known = RULES
                .iter()
                .any(|rule| rule.0.strip_prefix('.') == Some(class));
            assert!(is_known, "{}: {class}", picture.name);
        }
    }
}

#[test]
fn tables_are_read_below_their_titles() {
    let document = "\nfirst:\n\n| a | b |\n|---|--:|\n| x | 1 |\n\nsecond:\n\n| a | b |\n|---|--:|\n| x | 2 |\n";
    assert_eq!(Table::below(document, "first").cell("x", "b"), "1");
    assert_eq!(Table::below(document, "second").cell("x", "b"), "2");
}

#[test]
#[should_panic = "no cell `y`, `b`"]
fn a_row_is_not_missed() {
    let document = "\nfirst:\n\n| a | b |\n|---|--:|\n| x | 1 |\n";
    Table::below(document, "first").cell("y", "b");
}

#[test]
fn alternative_texts_are_replaced() {
    let document = "[a](b) ![old](../pictures/row.svg) ![other](pictures/frames.svg)";
    let expected = "[a](b) ![new](../pictures/row.svg) ![other](pictures/frames.svg)";
    assert_eq!(with_alternative(document, "row", "new"), expected);
}
