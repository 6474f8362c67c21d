//! Values that are written as text in a file, in the macro's own words.

use proc_macro2::{Span, TokenStream};
use syn::buffer::TokenBuffer;

use super::cursor::Cursor;
use super::formula::mistake_in;
use super::size;
use super::value::value;
use crate::diagnose::Diagnostics;
use crate::limits::{DEEPEST_DELIMITERS, MOST_TOKENS};
use crate::mistake::{Mistake, expected, file as mistake, number};
use crate::place::Place;
use crate::tree::{Fault, Kind, Node};

/// The value that a text is, such as `PI/2`, `sphere(0.1)` or `1%`, at that place, and its tokens.
pub(crate) fn read(text: &str, place: Place) -> Result<(Node, TokenStream), Fault> {
    if let Some(mistake) = otherwise(text) {
        return Err((place, mistake));
    }
    if text.len() <= MOST_TOKENS
        && let Some((before, mistake)) = mistake_in(text)
    {
        return Err((place.inside(before), mistake));
    }
    let no_value = || (place, mistake::no_value(text));
    if !lexes(text) {
        return Err(no_value());
    }
    let tokens: TokenStream = text.parse().map_err(|_| no_value())?;
    let errors = Diagnostics::new();
    let is_short = size::check(&tokens, &errors).is_ok();
    let buffer = TokenBuffer::new2(tokens.clone());
    let mut cursor = Cursor::new(&buffer, Span::call_site(), &errors);
    let mut node = if is_short {
        value(&mut cursor)
    } else {
        Node::new(place, Kind::Unreadable(errors.take_behind(0)))
    };
    if is_short && node.has_end() && !cursor.at_end() {
        cursor.expected(expected::end_of_text());
        node.behind = errors.take_behind(0);
    }
    // The tokens have no place of their own: what is said about them is said of the text.
    node.put(place);
    Ok((node, tokens))
}

/// The mistake of a number that is written as it is elsewhere: `100mm`, `30°`, `0,5`.
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
        _ => None,
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
        let at = Place::File { line: 2, column: 3 };
        let (node, _) = read(text, at).map_err(|(_, mistake)| vec![mistake.to_string()])?;
        assert_eq!(node.place.position(), (2, 3));
        let faults = match node.kind {
            Kind::Value(_) | Kind::Word(_) => node.behind,
            Kind::Unreadable(faults) | Kind::Applied(_, _, faults) => faults,
            Kind::Table(_) | Kind::List(_) => vec![(at, mistake::no_value(text))],
            kind => panic!("{kind:?}"),
        };
        assert!(faults.iter().all(|(place, _)| place.position() == (2, 3)));
        if faults.is_empty() {
            Ok(())
        } else {
            Err(faults.into_iter().map(|(_, m)| m.to_string()).collect())
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
