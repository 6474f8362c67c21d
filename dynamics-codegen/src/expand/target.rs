//! The struct that a piece of generated code belongs to.

use proc_macro2::{Ident, Literal, TokenStream};

use crate::call::Structure;

/// The struct that items are written for.
pub(super) struct Target<'a> {
    pub(super) name: &'a Ident,
    /// Attributes that switch the struct on and off: its impls go with it.
    pub(super) cfgs: &'a TokenStream,
    /// Number of joints; zero where an error left it unknown.
    pub(super) dof: usize,
    /// Path of the runtime crate.
    pub(super) path: &'a TokenStream,
}

impl<'a> Target<'a> {
    pub(super) fn new(structure: &'a Structure, dof: usize, path: &'a TokenStream) -> Target<'a> {
        Target {
            name: &structure.name,
            cfgs: &structure.cfgs,
            dof,
            path,
        }
    }

    /// The number of joints as a literal.
    pub(super) fn n(&self) -> Literal {
        Literal::usize_unsuffixed(self.dof)
    }
}
