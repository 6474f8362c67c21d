//! Mistakes in a call of the macro: each is reported at the token that is wrong, all of one call at
//! once, and what the rest of the user's file needs exists all the same.
//!
//! `mistakes/NAME.rs` holds one call or more. `mistakes/NAME.errors` holds what is said about them, a
//! line for each error: its line, the columns of its first letter and behind its last one, and the
//! message; then the items that stand for the robot. `UPDATE_EXPECT=1 cargo test -p dynamics-codegen
//! --test mistakes` writes these files anew.
//!
//! The compile-fail tests of the root package show how the compiler prints the errors, and that no others follow from
//! them.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use expect_test::expect_file;
use proc_macro2::{LineColumn, TokenStream, TokenTree};
use syn::{Expr, ImplItem, Item, MacroDelimiter, Stmt, spanned::Spanned};

#[test]
fn mistakes_are_reported_where_they_are() {
    let cases = cases();
    assert!(cases.len() > 80, "{} cases", cases.len());
    for case in cases {
        let source = std::fs::read_to_string(&case).expect("a case can be read");
        expect_file![case.with_extension("errors")].assert_eq(&report(&source));
    }
}

/// The files with calls, in the order of their names.
fn cases() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/mistakes");
    let entries = std::fs::read_dir(folder).expect("the folder can be read");
    let files = entries.map(|entry| entry.expect("an entry of the folder").path());
    let mut cases: Vec<PathBuf> = files
        .filter(|path| path.extension().is_some_and(|extension| extension == "rs"))
        .collect();
    cases.sort();
    cases
}

/// The messages about all calls of a file.
fn report(source: &str) -> String {
    let tokens: TokenStream = source.parse().expect("the case lexes");
    let mut report = String::new();
    for token in tokens {
        if let TokenTree::Group(call) = token {
            let items = dynamics_codegen::generate(call.stream());
            let file: syn::File = syn::parse2(items).expect("the expansion is Rust");
            report += &errors(&file);
            report += &robot(&file);
        }
    }
    report
}

/// The errors, from the top of the call to its end.
fn errors(file: &syn::File) -> String {
    let mut errors: Vec<(LineColumn, LineColumn, String)> =
        file.items.iter().filter_map(error).collect();
    errors.sort();
    let mut text = String::new();
    for (start, end, message) in errors {
        let (line, first) = (start.line, start.column + 1);
        let end = match end.line == line {
            true => format!("{}", end.column + 1),
            false => format!("{}:{}", end.line, end.column + 1),
        };
        writeln!(text, "{line}:{first}-{end}: {message}").expect("a string takes it");
    }
    text
}

/// The start, end and message of the item where it is an error.
fn error(item: &Item) -> Option<(LineColumn, LineColumn, String)> {
    let Item::Macro(item) = item else { return None };
    let is_error = item.mac.path.segments.last()?.ident == "compile_error";
    let MacroDelimiter::Brace(braces) = &item.mac.delimiter else {
        return None;
    };
    let message: syn::LitStr = item.mac.parse_body().ok()?;
    let start = item.mac.path.span().start();
    let end = braces.span.join().end();
    is_error.then(|| (start, end, message.value()))
}

/// The struct, and the number of its joints and methods: those of the table, as far as it could be read.
fn robot(file: &syn::File) -> String {
    let mut text = String::new();
    for item in file.items.iter().flat_map(within) {
        match item {
            Item::Struct(item) => text += &format!("struct {}", item.ident),
            Item::Impl(item) if item.trait_.is_none() => {
                let methods = item.items.iter().filter(|item| is_method(item)).count();
                let joints = item.items.iter().find_map(degrees_of_freedom);
                let joints = joints.expect("the constant DOF");
                writeln!(text, ": joints {joints}, methods {methods}").expect("a string takes it");
            }
            _ => {}
        }
    }
    text
}

/// The item, or what stands in the scope that it makes.
fn within(item: &Item) -> Vec<&Item> {
    let Item::Const(constant) = item else {
        return vec![item];
    };
    let Expr::Block(block) = &*constant.expr else {
        return Vec::new();
    };
    let statements = block.block.stmts.iter();
    let items = statements.filter_map(|statement| match statement {
        Stmt::Item(item) => Some(item),
        _ => None,
    });
    items.collect()
}

fn is_method(item: &ImplItem) -> bool {
    matches!(item, ImplItem::Fn(method) if method.sig.ident != "table" && method.sig.ident != "formulas")
}

fn degrees_of_freedom(item: &ImplItem) -> Option<String> {
    match item {
        ImplItem::Const(item) if item.ident == "DOF" => {
            let value = &item.expr;
            Some(quote::quote!(#value).to_string())
        }
        _ => None,
    }
}
