//! URDF: the elements of a document become a tree of links.

mod document;
mod loops;
pub(crate) mod prefixes;
mod reader;
pub(crate) mod xml;

pub(super) use document::read;
