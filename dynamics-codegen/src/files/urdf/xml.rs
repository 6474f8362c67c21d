//! XML: the text of a document, and the elements in it.

use std::borrow::Cow;

use roxmltree::{Document, Error, Node};

use super::prefixes::Declared;
use crate::diagnose::Diagnostics;
use crate::mistake::file as mistake;

/// Takes what is needed from a document and the places in it; a text that is none is reported.
pub(crate) fn parsed<T>(
    source: &str,
    diagnostics: &Diagnostics,
    take: impl FnOnce(&Declared, &Document) -> T,
) -> Option<T> {
    let source = &*with_declaration_in_front(source);
    let mut declared = Declared::as_written(source);
    let mut document = Document::parse(source);
    if let Err(Error::UnknownNamespace(..)) = document {
        declared = Declared::with_prefixes(source);
        document = Document::parse(declared.text());
    }
    let document = document.map_err(|error| {
        let place = declared.place_of(error.pos());
        diagnostics.error(place, mistake::syntax("XML", &reason(&error)))
    });
    Some(take(&declared, &document.ok()?))
}

/// The document, in which a declaration behind blank lines is blank too, as other readers take it. XML has it in front alone.
fn with_declaration_in_front(source: &str) -> Cow<'_, str> {
    let blank = source.len() - source.trim_start().len();
    let is_late = blank > 0 && source[blank..].starts_with("<?xml");
    let Some(end) = source.find("?>").filter(|_| is_late) else {
        return Cow::Borrowed(source);
    };
    let (declaration, rest) = source.split_at(end + 2);
    // As many bytes, in as many lines.
    let kept = |byte| if byte == b'\n' { '\n' } else { ' ' };
    Cow::Owned(declaration.bytes().map(kept).collect::<String>() + rest)
}

/// The mistake without its place, which the message has behind "at".
fn reason(error: &roxmltree::Error) -> String {
    let shown = error.to_string();
    let end = shown.rfind(" at ").unwrap_or(shown.len());
    shown[..end].to_owned()
}

/// The elements in another one that a reader of URDF knows. A prefix marks those of other programs.
pub(crate) fn elements<'a, 'i>(node: Node<'a, 'i>) -> impl Iterator<Item = Node<'a, 'i>> {
    let space = |node: Node<'a, 'i>| node.tag_name().namespace();
    let own = space(node.document().root_element());
    let elements = node.children().filter(Node::is_element);
    elements.filter(move |element| space(*element) == own)
}

pub(crate) fn is_named(element: Node, name: &str) -> bool {
    element.tag_name().name() == name
}

/// The element of that name in another one.
pub(crate) fn child<'a, 'i>(node: Node<'a, 'i>, name: &str) -> Option<Node<'a, 'i>> {
    elements(node).find(|element| is_named(*element, name))
}
