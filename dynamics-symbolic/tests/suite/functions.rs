//! The list of functions that macros read, which cannot ask the engine, is that of its table.

use std::fmt::Write;

use dynamics_symbolic::Function;
use expect_test::expect_file;

/// `UPDATE_EXPECT=1 cargo test -p dynamics-symbolic --test suite functions::` writes the list anew.
#[test]
fn the_list_for_macros_is_that_of_the_table() {
    let alone = |name: &str| name.to_owned();
    let with_batches = |name: &str| format!("{name} {name}_batch par_{name}_batch");
    let is_long = |function: &Function| *function == Function::InverseDynamicsSecondDerivatives;
    let others = list(EVERY, is_long, alone);
    let of_long_arms = list(OF_LONG_ARMS, |function| !is_long(function), alone);
    let batches = list(BATCHES, |_| true, with_batches);
    let file = format!("{HEAD}{others}{TAIL}{of_long_arms}{MORE}{TAIL}{batches}{TAIL}");
    expect_file!["../../../testkit/robots/src/functions.rs"].assert_eq(&file);
}

/// A macro over the functions that belong to it.
fn list(head: &str, belongs: impl Fn(&Function) -> bool, names: impl Fn(&str) -> String) -> String {
    let mut list = String::from(head);
    for function in Function::ALL.into_iter().filter(belongs) {
        let arguments = function.arguments().iter().map(|argument| argument.name());
        let arguments: Vec<_> = arguments.collect();
        let (names, arguments) = (names(function.name()), arguments.join(", "));
        writeln!(list, "            {names} [{arguments}]").expect("a string takes it");
    }
    list
}

const HEAD: &str = "\
//! The functions of the engine's table with their arguments, as tokens: written by its test `functions`.
";

const EVERY: &str = "
/// Hands every function to the macro `$then`, behind a context in braces: `name [argument, ...]`.
#[macro_export]
macro_rules! each_function {
    ($then:path { $($context:tt)* }) => {
        $crate::__functions_of_long_arms! {
            $then { $($context)* }
";

const OF_LONG_ARMS: &str = "
/// As `each_function`, without those that have as many values as the cube of the number of joints.
#[macro_export]
macro_rules! each_function_of_long_arms {
    ($then:path { $($context:tt)* }) => {
        $crate::__functions_of_long_arms! { $then { $($context)* } }
    };
}

/// And some more functions.
#[doc(hidden)]
#[macro_export]
macro_rules! __functions_of_long_arms {
    ($then:path { $($context:tt)* } $($more:tt)*) => {
        $then! {
            { $($context)* }
";

const MORE: &str = "            $($more)*
";

const BATCHES: &str = "
/// Every function with its batches: `name name_batch par_name_batch [argument, ...]`.
#[macro_export]
macro_rules! each_batch {
    ($then:path { $($context:tt)* }) => {
        $then! {
            { $($context)* }
";

const TAIL: &str = "        }
    };
}
";

/// Every function is explained where the notation is fixed, and listed on the macro's page.
#[test]
fn documents_name_every_function() {
    for document in ["../docs/NOTATION.md", "../src/robot_dynamics.md"] {
        let path = format!("{}/{document}", env!("CARGO_MANIFEST_DIR"));
        let text = std::fs::read_to_string(path).expect("the document can be read");
        for function in Function::ALL {
            let name = function.name();
            assert!(text.contains(&format!("`{name}")), "{name} in {document}");
        }
    }
}
