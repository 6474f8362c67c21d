//! What the compiler makes of mistakes in a call of the macro: it shows each error at the token that is
//! wrong, in the tokens of another macro too, and nothing else in the file is one (the methods that
//! `main` calls still exist).
//!
//! The mistakes themselves, nearly all of them, are tests of `dynamics-codegen` (`tests/mistakes`),
//! which need no compiler.

mod accepted;

use std::process::Command;

/// The compiler whose way of showing errors the `.stderr` files hold.
const WRITTEN_FOR: &str = "rustc 1.95.";

#[test]
fn the_compiler_shows_mistakes_where_they_are() {
    let compiler = compiler();
    if !compiler.starts_with(WRITTEN_FOR) {
        println!("skipped: {compiler} shows errors in its own way, not in that of {WRITTEN_FOR}*");
        return;
    }
    trybuild::TestCases::new().compile_fail("cases/*.rs");
}

/// The version of the compiler that the cases would be compiled by.
fn compiler() -> String {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let output = Command::new(rustc).arg("--version").output();
    let output = output.expect("the compiler says its version").stdout;
    String::from_utf8_lossy(&output).trim().to_owned()
}
