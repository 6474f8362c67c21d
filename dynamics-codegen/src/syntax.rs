//! What a macro call says, before it is known to make sense: a tree with places.

use dynamics_symbolic::Function;
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{Convention, JointType};
use proc_macro2::{Ident, TokenStream};

use crate::diagnose::Place;

/// A call of the macro.
pub(crate) struct Call {
    /// Path of the runtime crate, by which the generated code names everything.
    pub(crate) path: TokenStream,
    /// The struct item, where one could be read.
    pub(crate) structure: Option<Structure>,
    /// The entries after it, in the order in which they were written.
    pub(crate) entries: Vec<Entry>,
    /// All tokens after the struct item.
    pub(crate) table: TokenStream,
    /// Whether it was too much to be read: that has been reported.
    pub(crate) is_refused: bool,
}

/// The struct item.
pub(crate) struct Structure {
    /// Attributes, doc comments among them.
    pub(crate) attributes: TokenStream,
    /// Those of the attributes that switch the item on and off.
    pub(crate) cfgs: TokenStream,
    /// Whether one of the attributes is a `derive`.
    pub(crate) has_derive: bool,
    /// `pub`, `pub(crate)`, ... or nothing.
    pub(crate) visibility: TokenStream,
    /// Name of the struct.
    pub(crate) name: Ident,
    /// What follows the name.
    pub(crate) shape: Shape,
    /// The fields that could be read.
    pub(crate) fields: Vec<Field>,
    /// Whether these are all.
    pub(crate) complete: bool,
}

/// What follows a struct's name.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Shape {
    /// `;`
    Unit,
    /// `{ name: f64, ... }`
    Named,
    /// `(f64, ...);`, which is refused.
    Tuple,
}

/// A field of the struct: a symbolic parameter.
pub(crate) struct Field {
    /// Attributes, doc comments among them.
    pub(crate) attributes: TokenStream,
    /// `pub`, `pub(crate)`, ... or nothing.
    pub(crate) visibility: TokenStream,
    /// Name; a field of a tuple struct has none.
    pub(crate) name: Option<Ident>,
    /// The type as written.
    pub(crate) written: TokenStream,
}

/// An entry of the macro call. `None` stands for what could not be read: the error
/// has been reported.
pub(crate) enum Entry {
    /// `let name = value;`
    Let(Ident, Option<Expr>),
    /// `convention: modified`
    Convention(Option<Convention>),
    /// `gravity: [0, 0, -9.81]`
    Gravity(Option<Vector>),
    /// `joints: [...]`
    Joints(Place, Option<Joints>),
    /// `functions: [...]`
    Functions(Option<Vec<(Function, Place)>>),
    /// `lock: [elbow = 0.3]`
    Lock(Option<Vec<Locked>>),
    /// `neglect: 1%`
    Neglect(Option<Share>),
    /// `tests: true`
    Tests(Place, Option<bool>),
}

/// `elbow = 0.3`
pub(crate) struct Locked {
    pub(crate) name: Ident,
    pub(crate) position: Option<Expr>,
}

/// `1%`, or a number without `%`.
pub(crate) struct Share {
    pub(crate) number: Expr,
    pub(crate) percent: bool,
    pub(crate) place: Place,
}

/// `[x, y, z]`
pub(crate) type Vector = [Option<Expr>; 3];

/// A thing that may be left out.
#[derive(Default)]
pub(crate) enum Given<T> {
    /// Left out.
    #[default]
    Absent,
    /// Written, but it could not be read: the error has been reported.
    Unreadable,
    /// Written.
    As(T),
}

impl<T> Given<T> {
    /// What was left out may be what could not be read next to it: then it is unreadable.
    pub(crate) fn doubt(&mut self) {
        if self.is_absent() {
            *self = Given::Unreadable;
        }
    }

    /// Whether nothing was written.
    pub(crate) fn is_absent(&self) -> bool {
        matches!(self, Given::Absent)
    }

    /// What was written, where it could be read.
    pub(crate) fn value(&self) -> Option<&T> {
        match self {
            Given::As(value) => Some(value),
            Given::Absent | Given::Unreadable => None,
        }
    }
}

/// `[name: revolute { cells }, ...]`
pub(crate) struct Joints {
    /// The rows that could be told apart as rows.
    pub(crate) rows: Vec<Row>,
    /// Whether these are all.
    pub(crate) complete: bool,
}

/// `name: revolute { cells }`
#[derive(Default)]
pub(crate) struct Row {
    pub(crate) name: Option<Ident>,
    pub(crate) joint_type: Option<JointType>,
    pub(crate) a: Given<Expr>,
    pub(crate) alpha: Given<Expr>,
    pub(crate) d: Given<Expr>,
    pub(crate) theta: Given<Expr>,
    pub(crate) mass: Given<Expr>,
    pub(crate) com: Given<Vector>,
    pub(crate) inertia: Given<Inertia>,
    pub(crate) motor: Given<Motor>,
    pub(crate) friction: Given<Friction>,
    pub(crate) limits: Given<Limits>,
    pub(crate) allow: Given<Allow>,
}

/// The value of the cell `inertia`.
pub(crate) struct Inertia {
    pub(crate) place: Place,
    pub(crate) kind: InertiaKind,
}

/// How an inertia is written.
pub(crate) enum InertiaKind {
    /// `{ xx, yy, zz, xy, yz, xz }`, in this order.
    Tensor(Box<[Given<Expr>; 6]>),
    /// `cuboid(x, y, z)` and the like.
    Solid(Solid, Vec<Option<Expr>>),
}

/// A homogeneous solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Solid {
    /// Edges x, y, z.
    Cuboid,
    /// Radius and length, along z.
    Cylinder,
    /// Length, along x; slender.
    Rod,
    /// Radius.
    Sphere,
}

/// `motor: { inertia, gear_ratio }`
pub(crate) struct Motor {
    pub(crate) place: Place,
    pub(crate) inertia: Given<Expr>,
    pub(crate) gear_ratio: Given<Expr>,
}

/// `friction: { viscous, coulomb }`
#[derive(Default)]
pub(crate) struct Friction {
    pub(crate) viscous: Given<Expr>,
    pub(crate) coulomb: Given<Expr>,
}

/// `limits: [lower, upper]`
pub(crate) type Limits = [Option<Expr>; 2];

/// `allow: [unphysical_inertia]`
#[derive(Default)]
pub(crate) struct Allow {
    pub(crate) unphysical_inertia: bool,
}

/// A constant expression.
#[derive(Debug)]
pub(crate) struct Expr {
    pub(crate) kind: ExprKind,
    pub(crate) place: Place,
}

/// The kinds of constant expression.
#[derive(Debug)]
pub(crate) enum ExprKind {
    /// A number literal.
    Number(Rational),
    /// `PI`, a field or a `let`.
    Name(String),
    /// `deg(x)`
    Degrees(Box<Expr>),
    /// `-x`
    Minus(Box<Expr>),
    /// `x + y` and the like.
    Binary(Operator, Box<Expr>, Box<Expr>),
}

/// The operators of two values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Operator {
    Add,
    Sub,
    Mul,
    Div,
}
