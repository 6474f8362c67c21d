//! Robots and their functions as texts: in languages beside Rust, as a file of Rust, and as a page.
//!
//! [`files`] writes the files of a [`Language`]; the other functions write them one by one. All languages write the lines
//! of `Program::lines`, as the Rust method does (`body`): `syntax` has what differs between them, `arrangement` the shapes
//! of values, `comments` the documentation, and a module for each language the rest.
//!
//! C has the digits of a Rust build for the same processor. In the other languages products and sums are rounded one by
//! one, and values are those of a Rust build without fused instructions, except for sines and exponentials, which are
//! those of the language's library. Closed forms in JavaScript have sines of their own.
#![forbid(unsafe_code)]

mod arguments;
mod arrangement;
mod body;
mod c;
mod casadi;
pub mod cell;
mod closed_form;
mod comments;
mod files;
mod javascript;
mod language;
mod matlab;
mod names;
pub mod page;
pub mod poses;
mod python;
mod rust;
mod syntax;

pub use c::{CNumbers, CSource, c_project, c_source, c_source_in, c_source_without_batches};
pub use casadi::{CasadiSource, casadi_requests, casadi_source};
pub use closed_form::{inverse_in_c, inverse_in_javascript};
pub use comments::description;
pub use files::{Error, Options, files};
pub use javascript::javascript_module;
pub use language::Language;
pub use matlab::matlab_files;
pub use python::{python_module, python_module_name};
