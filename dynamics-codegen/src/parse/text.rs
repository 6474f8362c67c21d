//! Values that are written as text in a file, in the macro's own words.

use std::collections::BTreeSet;

use proc_macro2::{Span, TokenStream};
use syn::buffer::TokenBuffer;

use super::cursor::Cursor;
use super::{expression, inertia, names, size};
use crate::description::{Expr, ExprKind, Given, Inertia, InertiaKind, Share};
use crate::diagnose::{Diagnostics, Reported};
use crate::limits::{DEEPEST_DELIMITERS, MOST_TOKENS};
use crate::mistake::{Mistake, expected, file as mistake, number};
use crate::place::Place;

/// Reads a value such as `PI/2`, at `place` for whatever is said about it.
pub(crate) fn value(text: &str, at: &mut At) -> Result<Expr, Reported> {
    at.read(text, expression::expression)
}

/// Reads `sphere(0.1)` and the like.
pub(crate) fn solid(text: &str, at: &mut At) -> Result<Inertia, Reported> {
    at.read(text, inertia::inertia)
}

/// Reads `1%`.
pub(crate) fn share(text: &str, at: &mut At) -> Result<Share, Reported> {
    at.read(text, expression::share)
}

/// Where a text stands, who is told of its mistakes, and what it mentions.
pub(crate) struct At<'a> {
    pub(crate) place: Place,
    pub(crate) diagnostics: &'a Diagnostics,
    pub(crate) mentions: &'a mut BTreeSet<String>,
}

impl At<'_> {
    fn read<T: Placed>(
        &mut self,
        text: &str,
        read: impl FnOnce(&mut Cursor) -> Result<T, Reported>,
    ) -> Result<T, Reported> {
        let no_value = || {
            let mistake = otherwise(text).unwrap_or_else(|| mistake::no_value(text));
            self.diagnostics.error(self.place, mistake)
        };
        if otherwise(text).is_some() {
            return Err(no_value());
        }
        if !lexes(text) {
            return Err(no_value());
        }
        let tokens: TokenStream = text.parse().map_err(|_| no_value())?;
        self.mentions.extend(names(tokens.clone()));
        // The tokens have no place of their own: what is said about them is said of the text.
        let found = Diagnostics::new();
        let value = match size::check(&tokens, &found) {
            Err((_, reported)) => Err(reported),
            Ok(()) => {
                let buffer = TokenBuffer::new2(tokens);
                let mut cursor = Cursor::new(&buffer, Span::call_site(), &found);
                read(&mut cursor).and_then(|value| match cursor.at_end() {
                    true => Ok(value),
                    false => Err(cursor.expected(expected::end_of_text())),
                })
            }
        };
        for (_, mistake) in found.into_errors() {
            self.diagnostics.error(self.place, mistake);
        }
        let mut value = value?;
        value.put(self.place);
        Ok(value)
    }
}

/// What is wrong with a number that is written as it is elsewhere: `100mm`, `30°`, `0,5`.
fn otherwise(text: &str) -> Option<Mistake> {
    let text = text.trim();
    let number = text.trim_start_matches(['-', '+']).trim_start();
    let is_digits = |text: &str| !text.is_empty() && text.chars().all(|c| c.is_ascii_digit());
    if let Some((whole, fraction)) = number.split_once(',') {
        let is_number = is_digits(whole) && is_digits(fraction);
        return is_number.then(|| number::decimal_comma(&whole, &fraction));
    }
    let end = number.find(|c: char| !(c.is_ascii_digit() || c == '.'))?;
    let unit = number[end..].trim_start();
    let is_unit = unit.chars().all(|c| c.is_alphabetic() || c == '°');
    let is_number = number[..end].starts_with(|c: char| c.is_ascii_digit());
    let sign = &text[..text.len() - number.len()];
    match unit {
        _ if !is_unit || !is_number => None,
        "deg" | "degrees" | "°" => Some(number::degrees(&format!("{sign}{}", &number[..end]))),
        "" | "e" | "E" => None,
        _ => Some(number::unit(unit)),
    }
}

/// What has a place.
trait Placed {
    /// Gives it another one.
    fn put(&mut self, place: Place);
}

impl Placed for Expr {
    fn put(&mut self, place: Place) {
        self.place = place;
        match &mut self.kind {
            ExprKind::Number(_) | ExprKind::Name(_) => {}
            ExprKind::Degrees(value) | ExprKind::Function(_, value) | ExprKind::Minus(value) => {
                value.put(place)
            }
            ExprKind::Binary(_, left, right) => {
                left.put(place);
                right.put(place);
            }
        }
    }
}

impl Placed for Share {
    fn put(&mut self, place: Place) {
        self.place = place;
        self.number.put(place);
    }
}

impl Placed for Inertia {
    fn put(&mut self, place: Place) {
        self.place = place;
        match &mut self.kind {
            InertiaKind::Tensor(entries) => {
                for entry in entries.iter_mut() {
                    if let Given::As(entry) = entry {
                        entry.put(place);
                    }
                }
            }
            InertiaKind::Solid(_, sizes) => {
                for size in sizes.iter_mut().flatten() {
                    size.put(place);
                }
            }
        }
    }
}

/// Whether the compiler's own lexer reads the text, which reports by itself what it does not: names and
/// numbers between the signs that values have, parentheses closed, no comment.
fn lexes(text: &str) -> bool {
    let is_sign = |c: char| "+-*/%(),.=:".contains(c);
    let is_of_word = |c: char| c.is_alphanumeric() || c == '_';
    let good = |c: char| is_of_word(c) || is_sign(c) || c == ' ';
    let is_comment = text.contains("//") || text.contains("/*");
    if text.len() > MOST_TOKENS || is_comment || !text.chars().all(good) {
        return false;
    }
    let mut depth: usize = 0;
    for c in text.chars() {
        match (c, depth) {
            ('(', DEEPEST_DELIMITERS..) | (')', 0) => return false,
            ('(', _) => depth += 1,
            (')', _) => depth -= 1,
            _ => {}
        }
    }
    let mut words = text.split(|c| !is_of_word(c));
    let mut rest = text;
    depth == 0
        && words.all(|word| {
            rest = &rest[rest.find(word).map_or(0, |at| at + word.len())..];
            is_word(word, rest)
        })
}

/// Whether that is a name, or digits that may have an exponent: `0x`, `1e` and the like are neither. The sign
/// of an exponent is in `behind`.
fn is_word(word: &str, behind: &str) -> bool {
    let is_digits = |text: &str| text.chars().all(|c| c.is_ascii_digit() || c == '_');
    let starts_with_digit = |text: &str| text.starts_with(|c: char| c.is_ascii_digit());
    if !starts_with_digit(word) {
        return word
            .chars()
            .all(|c| c.is_alphabetic() || c.is_ascii_digit() || c == '_');
    }
    match word.split_once(['e', 'E']) {
        None => is_digits(word),
        Some((mantissa, "")) => {
            let exponent = behind.strip_prefix(['+', '-']);
            is_digits(mantissa) && exponent.is_some_and(starts_with_digit)
        }
        Some((mantissa, exponent)) => {
            is_digits(mantissa) && is_digits(exponent) && starts_with_digit(exponent)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str) -> Result<(), Vec<String>> {
        let diagnostics = Diagnostics::new();
        let mut at = At {
            place: Place::File { line: 2, column: 3 },
            diagnostics: &diagnostics,
            mentions: &mut BTreeSet::new(),
        };
        let value = super::value(text, &mut at);
        let errors = diagnostics.into_errors();
        assert_eq!(value.is_err(), !errors.is_empty());
        let positions = errors.iter().map(|(place, _)| place.position());
        assert!(positions.into_iter().all(|position| position == (2, 3)));
        match value {
            Ok(value) => {
                assert_eq!(value.place.position(), (2, 3));
                Ok(())
            }
            Err(_) => Err(errors.into_iter().map(|(_, m)| m.to_string()).collect()),
        }
    }

    #[test]
    fn values_are_those_of_the_macro() {
        for text in [
            "PI/2",
            "-deg(90)",
            "2*(m1 + 1e-3)",
            " 1_000.5 ",
            "1.5e+3",
            "l1",
        ] {
            assert_eq!(value(text), Ok(()), "{text}");
        }
    }

    #[test]
    fn what_is_no_value_is_said() {
        for text in [
            "",
            "1 2",
            "(1",
            "1)",
            "\"",
            "'a",
            "0x1f",
            "1e",
            "1ee2",
            "//",
            "/*",
            "{1}",
            "1;",
            "a.b()",
            "\\",
            "1\u{2212}2",
            "x\ny",
            "2mm",
            "²",
            "b'",
            "r#\"",
        ] {
            let messages = value(text).unwrap_err();
            assert_eq!(messages.len(), 1, "{text}: {messages:?}");
        }
        for deep in [
            "(".repeat(100_000),
            "-".repeat(100_000),
            "1+".repeat(40_000),
        ] {
            assert_eq!(value(&deep).unwrap_err().len(), 1);
        }
    }
}
