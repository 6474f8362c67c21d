//! A call of the macro: the table, and the tokens around it that pass into the generated code.

use proc_macro2::{Ident, TokenStream};

use crate::description::Table;

/// A call of the macro.
pub(crate) struct Call {
    /// Path of the runtime crate, by which the generated code names everything.
    pub(crate) path: TokenStream,
    /// The struct item, where one could be read.
    pub(crate) structure: Option<Structure>,
    /// The robot as the call describes it.
    pub(crate) table: Table,
    /// Whether it was too much to be read: that has been reported.
    pub(crate) is_refused: bool,
    /// The file that was read: the call is expanded again when it has changed.
    pub(crate) tracked: Option<String>,
}

impl Call {
    /// A call of which nothing is known yet but the path of the runtime.
    pub(crate) fn new(path: TokenStream) -> Call {
        Call {
            path,
            structure: None,
            table: Table::default(),
            is_refused: false,
            tracked: None,
        }
    }
}

/// The struct item.
pub(crate) struct Structure {
    /// Attributes, doc comments among them.
    pub(crate) attributes: TokenStream,
    /// Attributes that switch the item on and off.
    pub(crate) cfgs: TokenStream,
    /// Whether one of the attributes is a `derive`.
    pub(crate) has_derive: bool,
    /// `pub`, `pub(crate)`, ... or nothing.
    pub(crate) visibility: TokenStream,
    /// Name of the struct.
    pub(crate) name: Ident,
    /// The form of its body.
    pub(crate) shape: Shape,
    /// The fields that could be read.
    pub(crate) fields: Vec<Field>,
    /// Whether these are all.
    pub(crate) complete: bool,
    /// Whether it has a file for itself, in which there are no other names.
    pub(crate) is_alone: bool,
}

impl Structure {
    /// A struct without fields, which are not known yet.
    pub(crate) fn new(name: Ident) -> Structure {
        Structure {
            attributes: TokenStream::new(),
            cfgs: TokenStream::new(),
            has_derive: false,
            visibility: TokenStream::new(),
            name,
            shape: Shape::Unit,
            fields: Vec::new(),
            complete: false,
            is_alone: false,
        }
    }
}

/// The form of a struct's body.
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
