//! Attributes, words and numbers of elements, each with its place.

use std::cell::Cell;

use dynamics_symbolic::exact::Rational;
use roxmltree::{Attribute, Node};

use super::prefixes::Declared;
use super::xml::{self, child, elements};
use crate::diagnose::{Diagnostics, Reported};
use crate::files::Request;
use crate::files::links::{Number, Rounding};
use crate::geometry::Vector;
use crate::limits::MOST_LETTERS;
use crate::mistake::{Mistake, file as text, size, urdf as mistake};
use crate::parse::number::in_file;
use crate::place::Place;
use crate::words;

pub(super) type Read<T> = Result<T, Reported>;

/// A document that is read.
pub(super) struct Reader<'a> {
    pub(super) text: &'a Declared<'a>,
    pub(super) diagnostics: &'a Diagnostics,
    pub(super) request: &'a Request,
    pub(super) rounding: Rounding,
    /// Whether something was found that xacro should have replaced: the rest of it goes with the first.
    pub(super) left_over: Cell<Option<Reported>>,
}

/// The known word that was meant by one that is none.
fn misspelled<'k>(word: &str, known: &[&'k str]) -> Option<&'k str> {
    if known.contains(&word) {
        None
    } else {
        words::nearest(word, known)
    }
}

impl Reader<'_> {
    pub(super) fn place(&self, node: Node) -> Place {
        self.text.place(node.range().start)
    }

    pub(super) fn error(&self, node: Node, mistake: Mistake) -> Reported {
        self.diagnostics.error(self.place(node), mistake)
    }

    /// Reports an element of xacro in one that is read, except those of some names.
    pub(super) fn require_expanded(&self, node: Node, harmless: &[&str]) {
        let is_left = |element: &Node| {
            let name = element.tag_name();
            let is_xacro = name
                .namespace()
                .is_some_and(|space| space.ends_with("/xacro"));
            is_xacro && !harmless.contains(&name.name())
        };
        let own = node.document().root_element().tag_name().namespace();
        let mut others = node
            .children()
            .filter(|child| child.tag_name().namespace() != own);
        if let Some(element) = others.find(is_left) {
            let what = format!("<xacro:{}>", element.tag_name().name());
            self.report_left_over(self.place(element), &what);
        }
    }

    fn report_left_over(&self, place: Place, what: &str) -> Reported {
        let report = || self.diagnostics.error(place, mistake::xacro(what));
        let reported = self.left_over.get().unwrap_or_else(report);
        self.left_over.set(Some(reported));
        reported
    }

    /// Reports words of an element in whose place one of those that are known was meant, and the second of two
    /// elements of which one counts. Other words mean something to other programs.
    pub(super) fn spelled(&self, node: Node, known: &[&str], attributes: &[&str]) {
        const REPEATABLE: [&str; 2] = ["visual", "collision"];
        let element = node.tag_name().name();
        self.require_expanded(node, &[]);
        for child in elements(node) {
            let word = child.tag_name().name();
            if let Some(right) = misspelled(word, known) {
                let mistake = mistake::misspelled(element, "element", word, right);
                self.error(child, mistake);
            }
            let counts = known.contains(&word) && !REPEATABLE.contains(&word);
            let first = counts.then(|| xml::child(node, word)).flatten();
            if let Some(first) = first.filter(|first| *first != child) {
                let mistake = mistake::repeated(element, word, self.place(first).position());
                self.error(child, mistake);
            }
        }
        let is_own = |attribute: &Attribute| attribute.namespace().is_none();
        for attribute in node.attributes().filter(is_own) {
            let word = attribute.name();
            if let Some(right) = misspelled(word, attributes) {
                let place = self.text.place(attribute.range().start);
                let mistake = mistake::misspelled(element, "attribute", word, right);
                self.diagnostics.error(place, mistake);
            }
        }
    }

    /// An attribute, unless it says something that xacro should have replaced.
    fn found<'a, 'i>(&self, node: Node<'a, 'i>, name: &str) -> Read<Option<Attribute<'a, 'i>>> {
        let attribute = node.attribute_node(name);
        let is_left = |text: &str| text.contains("${") || text.contains("$(");
        match attribute.filter(|attribute| is_left(attribute.value())) {
            Some(left) => {
                let place = self.text.place(left.range_value().start);
                Err(self.report_left_over(place, left.value()))
            }
            None => Ok(attribute),
        }
    }

    pub(super) fn attribute<'a, 'i>(
        &self,
        node: Node<'a, 'i>,
        name: &str,
    ) -> Read<Attribute<'a, 'i>> {
        let missing = || {
            let element = node.tag_name().name();
            self.error(node, mistake::attribute_missing(element, name))
        };
        self.found(node, name)?.ok_or_else(missing)
    }

    pub(super) fn name(&self, node: Node) -> Read<String> {
        let name = self.attribute(node, "name")?;
        let word = name.value();
        if word.chars().any(char::is_control) {
            Err(self.error(node, text::control_in_name(word)))
        } else if word.len() > MOST_LETTERS {
            Err(self.error(node, size::name(word)))
        } else {
            Ok(word.to_owned())
        }
    }

    /// An element that has to be there.
    pub(super) fn part<'a, 'i>(&self, node: Node<'a, 'i>, name: &str) -> Read<Node<'a, 'i>> {
        let missing = || {
            let element = node.tag_name().name();
            self.error(node, mistake::element_missing(element, name))
        };
        child(node, name).ok_or_else(missing)
    }

    fn number(&self, text: &str, place: Place) -> Read<Rational> {
        in_file(text).map_err(|mistake| self.diagnostics.error(place, mistake))
    }

    /// The number in an attribute, and where it is.
    fn value(&self, attribute: Attribute) -> Read<Number> {
        let place = self.text.place(attribute.range_value().start);
        Ok((self.number(attribute.value().trim(), place)?, place))
    }

    pub(super) fn required(&self, node: Node, name: &str) -> Read<Rational> {
        let attribute = self.attribute(node, name)?;
        self.value(attribute).map(|(value, _)| value)
    }

    pub(super) fn optional(&self, node: Option<Node>, name: &str) -> Read<Option<Number>> {
        let attribute = node.map(|node| self.found(node, name)).transpose()?;
        let attribute = attribute.flatten();
        attribute.map(|attribute| self.value(attribute)).transpose()
    }

    /// Three numbers, or what stands for them where they are left out.
    pub(super) fn vector(
        &self,
        node: Option<Node>,
        name: &str,
        default: [i8; 3],
    ) -> Read<(Vector, Place)> {
        let attribute = node.map(|node| self.found(node, name)).transpose()?;
        let Some(attribute) = attribute.flatten() else {
            let place = node.map_or(Place::START, |node| self.place(node));
            return Ok((default.map(Rational::from), place));
        };
        let start = attribute.range_value().start;
        let place = self.text.place(start);
        let numbers = attribute.value().split_whitespace();
        let numbers: Read<Vec<_>> = numbers.map(|number| self.number(number, place)).collect();
        let numbers = numbers?;
        let count = numbers.len();
        let vector = numbers.try_into();
        let vector = vector.map_err(|_| {
            self.diagnostics
                .error(place, mistake::three_numbers(name, count))
        })?;
        Ok((vector, place))
    }
}
