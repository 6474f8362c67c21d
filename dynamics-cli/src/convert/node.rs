//! Values and entries of a table, and how a language writes them on one line.

use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::Value;

use super::angle::Angle;
use super::number::decimal;
use super::string::quoted;
use super::written::written;

/// A value.
#[derive(Clone)]
pub(super) enum Node {
    Number(Rational),
    /// As it was written in the file that was read.
    Written(Value),
    Angle(Angle),
    Text(String),
    /// `true`
    Yes,
    List(Vec<Node>),
    Table(Entries),
}

macro_rules! impl_from {
    ($($variant:ident($given:ty))*) => {$(
        impl From<$given> for Node {
            fn from(given: $given) -> Node {
                Node::$variant(given.to_owned())
            }
        }
    )*};
}

impl_from!(Number(&Rational) Written(&Value) Angle(&Angle) Text(&str) Table(Entries));

impl Node {
    /// Whether all of its numbers are zero, so that a cell need not be written.
    pub(super) fn is_zero(&self) -> bool {
        match self {
            Node::Number(x) => decimal(x) == "0",
            Node::Written(value) => value.is_zero(),
            Node::Angle(angle) => angle.is_zero(),
            Node::List(nodes) => nodes.iter().all(Node::is_zero),
            Node::Text(_) | Node::Yes | Node::Table(_) => false,
        }
    }
}

/// The words and signs of a language in which values stand on one line.
pub(super) struct Language {
    pub(super) number: fn(&Rational) -> String,
    pub(super) angle: fn(&Angle) -> String,
    pub(super) key: fn(&str) -> String,
    /// The sign between a key and its value.
    pub(super) is: &'static str,
}

impl Language {
    pub(super) fn value(&self, node: &Node) -> String {
        match node {
            Node::Number(x) => (self.number)(x),
            Node::Written(value) => written(value),
            Node::Angle(angle) => (self.angle)(angle),
            Node::Text(text) => quoted(text),
            Node::Yes => "true".to_owned(),
            Node::List(nodes) => {
                let values: Vec<_> = nodes.iter().map(|node| self.value(node)).collect();
                format!("[{}]", values.join(", "))
            }
            Node::Table(entries) => {
                let entries: Vec<_> = entries.iter().map(|entry| self.entry(entry)).collect();
                format!("{{ {} }}", entries.join(", "))
            }
        }
    }

    pub(super) fn entry(&self, (word, node): &(String, Node)) -> String {
        format!("{}{}{}", (self.key)(word), self.is, self.value(node))
    }
}

/// Words with their values, in their order.
pub(super) type Entries = Vec<(String, Node)>;

pub(super) fn entry(word: &str, node: impl Into<Node>) -> (String, Node) {
    (word.to_owned(), node.into())
}

pub(super) fn unless_zero(word: &str, node: Node) -> Option<(String, Node)> {
    (!node.is_zero()).then(|| entry(word, node))
}

pub(super) fn without_zeros<const K: usize>(words: [&str; K], nodes: [Node; K]) -> Entries {
    let entries = words.into_iter().zip(nodes);
    entries
        .filter_map(|(word, x)| unless_zero(word, x))
        .collect()
}

pub(super) fn unless_empty(word: &str, entries: Entries) -> Option<(String, Node)> {
    (!entries.is_empty()).then(|| entry(word, entries))
}

pub(super) fn nodes<'n, X>(values: &'n [X; 3]) -> [Node; 3]
where
    Node: From<&'n X>,
{
    values.each_ref().map(Node::from)
}

pub(super) fn list<'n, X>(values: &'n [X]) -> Node
where
    Node: From<&'n X>,
{
    Node::List(values.iter().map(Node::from).collect())
}
