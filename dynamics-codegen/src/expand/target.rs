//! The struct that a piece of generated code belongs to.

use dynamics_symbolic::function::Freedoms;
use proc_macro2::{Ident, Literal, TokenStream};

use crate::call::Structure;

/// The struct that items are written for.
pub(super) struct Target<'a> {
    pub(super) name: &'a Ident,
    /// `pub`, `pub(crate)`, ... or nothing.
    pub(super) visibility: &'a TokenStream,
    /// Attributes that switch the struct on and off: its impls go with it.
    pub(super) cfgs: &'a TokenStream,
    /// The degrees of freedom; none where an error left the number of joints unknown.
    pub(super) freedoms: Freedoms,
    /// Path of the runtime crate.
    pub(super) path: &'a TokenStream,
}

impl<'a> Target<'a> {
    pub(super) fn new(
        structure: &'a Structure,
        freedoms: impl Into<Freedoms>,
        path: &'a TokenStream,
    ) -> Target<'a> {
        Target {
            name: &structure.name,
            visibility: &structure.visibility,
            cfgs: &structure.cfgs,
            freedoms: freedoms.into(),
            path,
        }
    }

    /// Whether the number of joints is known.
    pub(super) fn is_known(&self) -> bool {
        self.freedoms.all() > 0
    }

    /// The number of joints as a literal.
    pub(super) fn n(&self) -> Literal {
        Literal::usize_unsuffixed(self.freedoms.joints)
    }

    /// The number of degrees of freedom as a literal.
    pub(super) fn v(&self) -> Literal {
        Literal::usize_unsuffixed(self.freedoms.all())
    }
}
