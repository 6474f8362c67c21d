//! Mistakes in a call of the macro: each is reported at the token that is wrong, all of one call
//! at once, and nothing else in the file is (the methods that `main` calls still exist).

#[path = "compile-fail/accepted/mod.rs"]
mod accepted;

#[test]
fn mistakes_are_reported_where_they_are() {
    trybuild::TestCases::new().compile_fail("tests/compile-fail/*.rs");
}
