//! The expansion of `robot_dynamics!`, as an ordinary library: `dynamics-macros` hands it the tokens
//! that the compiler gives, fuzzing and tests those that they make.
//!
//! A call passes through these modules:
//!
//! 1. `parse` reads the tokens: the struct item (`call`) and the entries, as a `tree` of words and values;
//!    `files` makes such a tree of a file, where the call names one, and puts what it says beside the rest;
//! 2. `read` knows what the words of a tree mean (`keys` lists them) and makes a [`description`] of it, plain data with
//!    places;
//! 3. `validate` makes a `dynamics_symbolic::robot::Robot` of the table, or reports every reason why
//!    there is none. It knows no tokens: [`check`] does the same for a table that was read elsewhere;
//! 4. `dynamics_symbolic` derives the functions and proves them;
//! 5. `expand` writes the struct and its methods. That cannot fail; after an error
//!    it writes the same items with empty methods, so that the code around the call
//!    still passes the type check.
//!
//! `diagnose` collects the errors of a call, which are reported together, each at its `place`. `mistake` has all their
//! texts, each in the words of its `audience`; `lint` finds what is doubtful in files besides. `words` finds the word that was meant; `limits` says how much a call may
//! need.
#![forbid(unsafe_code)]

extern crate proc_macro;

mod audience;
mod call;
mod degrees;
pub mod description;
mod diagnose;
mod expand;
pub mod files;
mod finding;
#[cfg(feature = "files")]
pub mod geometry;
mod keys;
mod limits;
#[cfg(feature = "files")]
pub mod lint;
mod mistake;
mod parse;
mod place;
mod read;
mod rounded;
mod tree;
mod validate;
mod words;

pub use audience::Audience;
pub use degrees::{angle_in_degrees, positions_in_degrees};
pub use diagnose::Error;
pub use finding::{Finding, Severity};
pub use validate::Model;
pub use words::{nearest, visible};

use diagnose::Diagnostics;
use dynamics_symbolic::function::Part;
use dynamics_symbolic::program::Program;
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Method, expand_with};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;
use tree::Language;

/// The items of a call of the macro, and a `compile_error!` for each mistake in it.
pub fn generate(call: TokenStream) -> TokenStream {
    generate_by(call, &dynamics_symbolic::derive::derive_together)
}

/// The same; `say` is told what is derived, before it is.
pub fn generate_told(call: TokenStream, say: impl Fn(&str) + 'static) -> TokenStream {
    generate_by(call, &move |robot, parts| {
        let names: Vec<_> = parts.iter().map(|part| robot.name_of(*part)).collect();
        say(&format!("`{}` of `{}`", names.join("`, `"), robot.name));
        dynamics_symbolic::derive::derive_together(robot, parts)
    })
}

/// The items of a call without the engine: the struct, its table and its traits, with no method derived and
/// nothing neglected.
pub fn outline(call: TokenStream) -> TokenStream {
    let diagnostics = Diagnostics::new();
    let call = read_call(call, &diagnostics);
    let model = model(&call, &diagnostics);
    let generated = model.map(Generated::outline);
    items(&call, generated, diagnostics)
}

/// Finds the program of a function, or the one of several.
type Derivation = dyn Fn(&Robot, &[Part]) -> Program;

/// [`generate`] with an engine of one's own, which a test damages.
fn generate_by(call: TokenStream, derivation: &Derivation) -> TokenStream {
    let diagnostics = Diagnostics::new();
    let call = read_call(call, &diagnostics);
    let generated = model(&call, &diagnostics).and_then(|model| {
        let model = abbreviated(model, &diagnostics)?;
        Generated::new(model, &call, derivation, &diagnostics)
    });
    items(&call, generated, diagnostics)
}

/// A call and the file that it names.
fn read_call(call: TokenStream, diagnostics: &Diagnostics) -> call::Call {
    let (mut call, root) = parse::call(call, diagnostics);
    if let Some(root) = root {
        let read = read::table(&root, Language::Call, diagnostics);
        call.table.entries = read.entries;
        call.table.keys = read.keys;
    }
    files::load(&mut call, diagnostics);
    call
}

/// The model of a call; of one that is too long to be read there is none.
fn model(call: &call::Call, diagnostics: &Diagnostics) -> Option<Model> {
    (!call.is_refused).then(|| validate::model(&call.table, diagnostics))?
}

/// The robot of a table, wherever it was read, and the functions that are requested; or every reason why there is
/// no such robot, from the top to the end.
pub fn check(table: &description::Table) -> Result<Model, Vec<Error>> {
    let diagnostics = Diagnostics::new();
    let model = validate::model(table, &diagnostics);
    let errors = diagnostics.shown_to(table.audience);
    model.ok_or(errors)
}

/// The items of a model that was read elsewhere, as a call of the macro with that table expands to them: a
/// struct with the fields of the model, its methods and its traits, for a file of their own. `path` is the path of the runtime
/// crate.
///
/// # Errors
///
/// Each function that cannot be generated.
pub fn items_of(
    model: Model,
    name: Ident,
    documentation: &[String],
    path: TokenStream,
) -> Result<TokenStream, Vec<Error>> {
    let diagnostics = Diagnostics::new();
    let fields: Vec<_> = model.robot.fields.iter().map(|name| field(name)).collect();
    let structure = call::Structure {
        attributes: quote!(#(#[doc = #documentation])*),
        visibility: quote!(pub),
        shape: if fields.is_empty() {
            call::Shape::Unit
        } else {
            call::Shape::Named
        },
        fields,
        complete: true,
        is_alone: true,
        ..call::Structure::new(name)
    };
    let call = call::Call {
        structure: Some(structure),
        ..call::Call::new(path)
    };
    let derivation = &dynamics_symbolic::derive::derive_together;
    match Generated::new(model, &call, derivation, &diagnostics) {
        Some(generated) => Ok(items(&call, Some(generated), diagnostics)),
        None => Err(diagnostics.shown_to(Audience::default())),
    }
}

/// A public field for a symbolic parameter, whose name is an identifier.
fn field(name: &str) -> call::Field {
    call::Field {
        attributes: quote!(#[doc = " A symbolic parameter of the table."]),
        visibility: quote!(pub),
        name: Some(dynamics_symbolic::emit::field(name)),
        written: quote!(f64),
    }
}

/// The errors and the items: stubs where there is no model.
fn items(call: &call::Call, generated: Option<Generated>, diagnostics: Diagnostics) -> TokenStream {
    assert_eq!(generated.is_none(), !diagnostics.is_empty());
    let items = match (&call.structure, &generated) {
        (Some(structure), Some(generated)) => {
            let Generated {
                model,
                methods,
                inverses,
            } = generated;
            expand::robot(structure, model, methods, inverses, &call.path)
        }
        (Some(structure), None) => expand::stubs(structure, &call.table, &call.path),
        (None, _) => TokenStream::new(),
    };
    let errors = diagnostics.into_compile_errors();
    // The compiler expands the call again when a file that it includes has changed.
    let tracked = call.tracked.as_ref();
    let tracked = tracked.map(|path| {
        quote!(
            const _: &[::core::primitive::u8] = ::core::include_bytes!(#path);
        )
    });
    quote!(#errors #tracked #items)
}

/// The model without what is to be neglected, or `None` where that is too much: that is reported.
fn abbreviated(mut model: Model, diagnostics: &Diagnostics) -> Option<Model> {
    if let Some((share, place)) = &model.neglect {
        match dynamics_symbolic::neglect::neglect(&model.robot, share.to_f64(&[])) {
            Ok(robot) => model.robot = robot,
            Err(refused) => {
                diagnostics.error(*place, mistake::neglected_too_much(&refused));
                return None;
            }
        }
    }
    Some(model)
}

/// A model with its methods.
struct Generated {
    model: Model,
    methods: Vec<Method>,
    /// Methods of inverse kinematics.
    inverses: Vec<TokenStream>,
}

impl Generated {
    /// The model without methods.
    fn outline(model: Model) -> Self {
        Generated {
            model,
            methods: Vec::new(),
            inverses: Vec::new(),
        }
    }

    /// `None` where a method cannot be generated: that is reported.
    fn new(
        model: Model,
        call: &call::Call,
        derivation: &Derivation,
        diagnostics: &Diagnostics,
    ) -> Option<Self> {
        let inverses = inverses(&model, call, diagnostics);
        let methods = methods(&model, call, derivation, diagnostics);
        Some(Generated {
            inverses: inverses?,
            methods: methods?,
            model,
        })
    }
}

/// The methods of inverse kinematics, or `None` where the arm has no closed form: that is reported where it is
/// requested.
fn inverses(
    model: &Model,
    call: &call::Call,
    diagnostics: &Diagnostics,
) -> Option<Vec<TokenStream>> {
    let mut methods = Vec::new();
    for (frame, place) in &model.inverses {
        match dynamics_symbolic::inverse_kinematics(&model.robot, *frame, &call.path) {
            Ok(method) => methods.push(method),
            Err(why) => {
                diagnostics.error(*place, mistake::entry::no_closed_form(&why));
            }
        }
    }
    (methods.len() == model.inverses.len()).then_some(methods)
}

/// The methods, or `None` where the engine could not prove one of them: that is
/// reported at the function's name in the call.
fn methods(
    model: &Model,
    call: &call::Call,
    derivation: &Derivation,
    diagnostics: &Diagnostics,
) -> Option<Vec<Method>> {
    let requests: Vec<_> = model.requests.iter().map(|(r, _)| r.clone()).collect();
    let failures = match expand_with(&model.robot, &requests, &call.path, derivation) {
        Ok(methods) => return Some(methods),
        Err(failures) => failures,
    };
    let name = call.structure.as_ref().map(|structure| &structure.name);
    for failure in failures {
        let mut requests = model.requests.iter();
        let asked = requests.find(|(request, _)| *request == failure.request);
        let place = asked.and_then(|(_, place)| *place);
        let place = place.or(name.map(Into::into));
        let place = place.unwrap_or_else(|| Span::call_site().into());
        diagnostics.error(place, mistake::not_proven(&failure));
    }
    None
}

#[cfg(test)]
mod tests;
