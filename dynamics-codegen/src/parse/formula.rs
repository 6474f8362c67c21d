//! Formulas that are written as elsewhere, in the text of a file: `l1^2`, `2 l1`, `rod(0.5`.

use crate::mistake::{Mistake, number, value as mistake};

/// Units behind numbers; those of the table come first.
const UNITS: [&str; 23] = [
    "m", "kg", "rad", "mm", "cm", "dm", "km", "um", "in", "inch", "ft", "g", "mg", "t", "lb",
    "lbs", "mrad", "N", "Nm", "s", "ms", "Hz", "rpm",
];

/// The number of units of [`UNITS`] that the table has.
const OURS: usize = 3;

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Number,
    Word,
    Open,
    Close,
    Sign,
}

/// A part of a text, behind so many letters.
#[derive(Clone, Copy)]
struct Piece<'t> {
    at: usize,
    kind: Kind,
    text: &'t str,
}

/// The first mistake of a text, and how many letters stand in front of it.
pub(super) fn mistake_in(text: &str) -> Option<(usize, Mistake)> {
    let pieces = pieces(text);
    let mut open = Vec::new();
    for (index, piece) in pieces.iter().enumerate() {
        let before = index.checked_sub(1).map(|before| pieces[before]);
        if let Some(mistake) = before.and_then(|before| side_by_side(before, *piece)) {
            return Some((piece.at, mistake));
        }
        match piece.kind {
            Kind::Open => open.push(piece.at),
            Kind::Close if open.pop().is_none() => {
                return Some((piece.at, mistake::parenthesis_too_many()));
            }
            Kind::Sign if piece.text == "^" => {
                return Some((piece.at, power(before)));
            }
            _ => {}
        }
    }
    let closed = format!("{}{}", text.trim(), ")".repeat(open.len()));
    open.first()
        .map(|at| (*at, mistake::parenthesis_missing(&closed)))
}

/// The mistake of two parts with no sign between them.
fn side_by_side(before: Piece, piece: Piece) -> Option<Mistake> {
    use Kind::{Close, Number, Open, Word};
    let (first, second) = (before.text, piece.text);
    match (before.kind, piece.kind) {
        (Number, Word) if UNITS[..OURS].contains(&second) => {
            Some(number::unit_of_table(second, first))
        }
        (Number, Word) if UNITS.contains(&second) => Some(number::unit(second)),
        // Two numbers are rather two values.
        (Number | Word | Close, Word) | (Word | Close, Number) | (Number | Close, Open) => {
            Some(mistake::sign_missing(first, second))
        }
        _ => None,
    }
}

/// The mistake of `^` behind a part.
fn power(base: Option<Piece>) -> Mistake {
    let named = base.filter(|base| matches!(base.kind, Kind::Word | Kind::Number));
    let base = named.map_or("x", |base| base.text);
    mistake::power("^", base)
}

/// The parts of a text.
fn pieces(text: &str) -> Vec<Piece<'_>> {
    let (mut pieces, mut rest, mut at) = (Vec::new(), text, 0);
    while let Some(first) = rest.chars().next() {
        let (kind, length) = match first {
            '(' => (Kind::Open, 1),
            ')' => (Kind::Close, 1),
            '0'..='9' => (Kind::Number, length_of_number(rest)),
            c if is_of_word(c) => (
                Kind::Word,
                rest.find(|c| !is_of_word(c)).unwrap_or(rest.len()),
            ),
            c => (Kind::Sign, c.len_utf8()),
        };
        let (text, behind) = rest.split_at(length);
        if first != ' ' {
            pieces.push(Piece { at, kind, text });
        }
        at += text.chars().count();
        rest = behind;
    }
    pieces
}

fn is_of_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// The length of the digits at the start of a text, with their exponent.
fn length_of_number(text: &str) -> usize {
    let is_digit = |c: char| c.is_ascii_digit() || c == '.' || c == '_';
    let digits = text.find(|c| !is_digit(c)).unwrap_or(text.len());
    let word = text[digits..].find(|c| !is_of_word(c));
    let word = &text[digits..word.map_or(text.len(), |length| digits + length)];
    let is_exponent = word
        .strip_prefix(['e', 'E'])
        .is_some_and(|exponent| exponent.chars().all(|c| c.is_ascii_digit()));
    digits + if is_exponent { word.len() } else { 0 }
}
