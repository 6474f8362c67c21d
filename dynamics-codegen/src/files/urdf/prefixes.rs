//! Prefixes of names, such as `sensor:` in `<sensor:camera>`, that a document does not declare.
//!
//! XML refuses them, but what a prefix marks is not read. So a document is parsed with declarations of them in its first
//! element, and places are those of the document as it was written.

use std::borrow::Cow;
use std::collections::BTreeSet;

use roxmltree::TextPos;

use crate::place::Place;
use crate::tree::Lines;

/// More of them are in no file that somebody wrote.
const MOST: usize = 64;

/// A document, perhaps with declarations of the prefixes that it does not declare itself.
pub(crate) struct Declared<'t> {
    lines: Lines<'t>,
    text: Cow<'t, str>,
    /// Where the declarations begin, and how many bytes they are.
    start: usize,
    length: usize,
}

impl<'t> Declared<'t> {
    /// The document as it was written.
    pub(super) fn as_written(source: &'t str) -> Declared<'t> {
        Declared {
            lines: Lines::new(source),
            text: Cow::Borrowed(source),
            start: 0,
            length: 0,
        }
    }

    /// The document with the declarations that it lacks.
    pub(super) fn with_prefixes(source: &'t str) -> Declared<'t> {
        let start = after_first_name(source).unwrap_or(0);
        let declare = |prefix: &str| format!(" xmlns:{prefix}=\"undeclared/{prefix}\"");
        let declarations: String = undeclared(source, start).map(declare).collect();
        let (before, behind) = source.split_at(start);
        Declared {
            lines: Lines::new(source),
            length: declarations.len(),
            text: Cow::Owned([before, &declarations, behind].concat()),
            start,
        }
    }

    pub(super) fn text(&self) -> &str {
        &self.text
    }

    /// The place in the document of the letter behind so many bytes of the text.
    pub(crate) fn place(&self, offset: usize) -> Place {
        let behind = offset.saturating_sub(self.start);
        self.lines.place(offset - behind.min(self.length))
    }

    /// The place in the document of a place in the text.
    pub(super) fn place_of(&self, at: TextPos) -> Place {
        let (row, column) = (at.row as usize, at.col as usize);
        let lines = self.text.split_inclusive('\n');
        let before: usize = lines.clone().take(row - 1).map(str::len).sum();
        let line = lines.clone().nth(row - 1).unwrap_or_default();
        let letters = line.chars().take(column - 1).map(char::len_utf8);
        self.place(before + letters.sum::<usize>())
    }
}

/// Words in front of a colon and a letter that the first element, whose name ends at `start`, does not declare.
fn undeclared(source: &str, start: usize) -> impl Iterator<Item = &str> {
    let declared = source[start..].split('>').next().unwrap_or_default();
    let is_part = |letter: char| letter.is_alphanumeric() || "_-.".contains(letter);
    let colons = source.match_indices(':').map(|(at, _)| source.split_at(at));
    let colons = colons.filter(|(_, behind)| behind[1..].starts_with(char::is_alphabetic));
    let words = colons.map(move |(before, _)| &before[before.trim_end_matches(is_part).len()..]);
    let words: BTreeSet<&str> = words.collect();
    let is_word = |word: &&str| word.starts_with(char::is_alphabetic) && !word.starts_with("xml");
    let words = words.into_iter().filter(is_word).take(MOST);
    words.filter(move |word| !declared.contains(&format!("xmlns:{word}=")))
}

/// The byte behind the name of the first element.
fn after_first_name(source: &str) -> Option<usize> {
    let mut at = 0;
    loop {
        at += source[at..].find('<')?;
        let rest = &source[at..];
        at += if rest.starts_with("<!--") {
            rest.find("-->")?
        } else if rest.starts_with("<?") {
            rest.find("?>")?
        } else {
            let ends = |letter: char| letter.is_whitespace() || "/>".contains(letter);
            return Some(at + rest.find(ends)?);
        };
    }
}

#[cfg(test)]
mod tests {
    use roxmltree::Document;

    use super::*;

    #[test]
    fn places_are_those_of_the_document() {
        let source = "<?xml version=\"1.0\"?>\n<!-- <robot> -->\n<robot name=\"x\"><a:b\n c:d=\"1\"/><e/>\
                      <f xmlns:a=\"of f\"/></robot>";
        let declared = Declared::with_prefixes(source);
        let document = Document::parse(declared.text()).expect("a document");
        let element = |name: &str| {
            let mut elements = document.descendants();
            elements.find(|element| element.tag_name().name() == name)
        };
        for (name, expected) in [("robot", (3, 1)), ("b", (3, 17)), ("e", (4, 11))] {
            let element = element(name).expect("the element");
            let place = declared.place(element.range().start);
            assert_eq!(place.position(), expected, "{name}");
            let at = document.text_pos_at(element.range().start);
            assert_eq!(declared.place_of(at).position(), expected, "{name}");
        }
        assert_eq!(
            element("b").and_then(|b| b.tag_name().namespace()),
            Some("undeclared/a")
        );
    }

    #[test]
    fn a_document_that_is_none_stays_so() {
        for source in [
            "",
            "<",
            "<!-- ",
            "<robot",
            "<a:b/>",
            "<?",
            "<robot><a:b></robot>",
        ] {
            let declared = Declared::with_prefixes(source);
            if let Err(error) = Document::parse(declared.text()) {
                let _ = declared.place_of(error.pos());
            }
        }
    }
}
