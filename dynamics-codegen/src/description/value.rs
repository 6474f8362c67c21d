//! Names and values, and things that may be left out.

use std::fmt;

use dynamics_symbolic::function::plain;
use dynamics_symbolic::robot::Value;

use crate::place::Place;

/// A name, and where it stands.
#[derive(Clone, Debug)]
pub struct Name {
    written: String,
    place: Place,
}

impl Name {
    /// A name as it is written, the `r#` of a raw identifier included.
    pub fn new(written: impl Into<String>, place: Place) -> Name {
        Name {
            written: written.into(),
            place,
        }
    }

    /// The name without the `r#` of a raw one.
    pub fn plain(&self) -> &str {
        plain(&self.written)
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.written)
    }
}

impl From<&Name> for Place {
    fn from(name: &Name) -> Place {
        name.place
    }
}

/// `[x, y, z]`
pub type Vector = [Option<Expr>; 3];

/// A thing that may be left out.
#[derive(Debug, Default)]
pub enum Given<T> {
    /// Left out.
    #[default]
    Absent,
    /// Written, but it could not be read: the error has been reported.
    Unreadable,
    /// Written.
    As(T),
}

impl<T> Given<T> {
    /// Makes a thing that was left out unreadable: what could not be read next to it may be this one.
    pub fn doubt(&mut self) {
        if self.is_absent() {
            *self = Given::Unreadable;
        }
    }

    /// Whether nothing was written.
    pub fn is_absent(&self) -> bool {
        matches!(self, Given::Absent)
    }

    /// The result of `read`, or `absent` if it was left out.
    pub(crate) fn read<U>(&self, absent: U, read: impl FnOnce(&T) -> Option<U>) -> Option<U> {
        match self {
            Given::Absent => Some(absent),
            Given::Unreadable => None,
            Given::As(value) => read(value),
        }
    }

    /// The value, if one was written that could be read.
    pub fn value(&self) -> Option<&T> {
        match self {
            Given::As(value) => Some(value),
            Given::Absent | Given::Unreadable => None,
        }
    }
}

/// Values for some words: `{ stiffness: 200, rest: 0.1 }`.
#[derive(Debug)]
pub struct Part<const N: usize> {
    /// Where they stand.
    pub place: Place,
    /// The values, in the order in which messages list their words.
    pub values: [Given<Expr>; N],
}

/// A constant expression.
#[derive(Clone, Debug)]
pub struct Expr {
    /// Its kind.
    pub kind: ExprKind,
    /// Where it stands.
    pub place: Place,
}

impl Expr {
    /// A value that is known, without fields.
    pub fn known(value: Value, place: Place) -> Expr {
        let kind = ExprKind::Value(value);
        Expr { kind, place }
    }

    /// Puts all of it at one place.
    #[cfg(feature = "files")]
    pub(crate) fn put(&mut self, place: Place) {
        self.place = place;
        match &mut self.kind {
            ExprKind::Value(_) | ExprKind::Name(_) => {}
            ExprKind::Degrees(value) | ExprKind::Function(_, value) | ExprKind::Minus(value) => {
                value.put(place);
            }
            ExprKind::Binary(_, left, right) => {
                left.put(place);
                right.put(place);
            }
        }
    }
}

/// The kinds of constant expression.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// A number literal, or what a file is known to say.
    Value(Value),
    /// `PI`, a field or a `let`.
    Name(String),
    /// `deg(x)`
    Degrees(Box<Expr>),
    /// `sqrt(x)` and the like.
    Function(Elementary, Box<Expr>),
    /// `-x`
    Minus(Box<Expr>),
    /// `x + y` and the like.
    Binary(Operator, Box<Expr>, Box<Expr>),
}

/// The functions of a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Elementary {
    /// The square root.
    Sqrt,
    /// The sine.
    Sin,
    /// The cosine.
    Cos,
}

/// The operators of two values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operator {
    /// `+`
    Add,
    /// `-`
    Sub,
    /// `*`
    Mul,
    /// `/`
    Div,
}
