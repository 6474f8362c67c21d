//! The struct that a piece of generated code belongs to.

use dynamics_symbolic::Stubbed;
use dynamics_symbolic::function::Freedoms;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::ToTokens;

use crate::call::Structure;

/// The struct that items are written for.
pub(super) struct Target<'a> {
    pub(super) name: &'a Ident,
    /// `pub`, `pub(crate)`, ... or nothing.
    pub(super) visibility: &'a TokenStream,
    /// Attributes that switch the struct on and off: its impls go with it.
    pub(super) cfgs: &'a TokenStream,
    /// The degrees of freedom; no joints where an error left their number unknown.
    pub(super) freedoms: Freedoms,
    /// Whether the number of joints is known.
    pub(super) is_known: bool,
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
            is_known: true,
            path,
        }
    }

    /// The robot of stubs.
    pub(super) fn stubbed(&self) -> Stubbed {
        Stubbed {
            freedoms: self.freedoms,
            is_known: self.is_known,
        }
    }

    /// The numbers of joints and of degrees of freedom in impls, which are for all of them where an error left the number
    /// unknown.
    pub(super) fn sizes(&self) -> [TokenStream; 2] {
        if self.is_known {
            [self.n(), self.v()].map(ToTokens::into_token_stream)
        } else {
            self.stubbed().names()
        }
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
