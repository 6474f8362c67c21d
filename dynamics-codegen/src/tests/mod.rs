//! The whole path from tokens to items. Places of errors, and that no others follow from them, are
//! shown by `tests/mistakes.rs`.

mod accepted;
#[cfg(feature = "files")]
mod beside;
mod damage;
mod expansion;
#[cfg(feature = "files")]
mod floating;
mod fragments;
mod hard_cases;
mod hostile;
mod limits;
mod messages;
mod names;
#[cfg(feature = "files")]
mod nearly;
mod table;
#[cfg(feature = "files")]
mod trees;
mod units;

use proc_macro2::TokenStream;

use crate::diagnose::Diagnostics;
use crate::validate::Model;

/// The model of a call and the messages about it.
fn read(tokens: TokenStream) -> (Option<Model>, Vec<String>) {
    let diagnostics = Diagnostics::new();
    let call = crate::read_call(tokens, &diagnostics);
    let model = crate::model(&call, &diagnostics);
    (model, diagnostics.into_messages())
}

/// The messages about a call.
fn messages(source: &str) -> Vec<String> {
    let (model, messages) = read(source.parse().expect("the source lexes"));
    assert_eq!(model.is_none(), !messages.is_empty());
    messages
}

/// The only message about a call.
fn message(source: &str) -> String {
    let messages = messages(source);
    assert_eq!(messages.len(), 1, "{messages:#?}");
    messages.concat()
}

/// The model of a call without errors.
fn model(source: &str) -> Model {
    let (model, messages) = read(source.parse().expect("the source lexes"));
    model.unwrap_or_else(|| panic!("{messages:#?}"))
}

/// A call with those rows and otherwise nothing wrong: what is read and judged is more than masses.
fn with_rows(rows: &str) -> String {
    format!(
        "struct Arm; convention: standard, gravity: [0, 0, -9.81], joints: [{rows}], allow: [no_inertia, odd_length, odd_mass],"
    )
}

/// A call with those cells and otherwise nothing wrong.
fn with_cells(cells: &str) -> String {
    with_rows(&format!("joint: revolute {{ {cells} }}"))
}
