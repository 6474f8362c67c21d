//! The text of functions in other languages: readable, and the same each time. That their values are
//! those of Rust is a test of `dynamics-evaluation`.

use dynamics_symbolic::emit::{c_source, javascript_module};
use dynamics_symbolic::{Function, Request, proven_program};
use expect_test::expect_file;

use super::formulas::two_link_craig;

#[test]
fn two_link_arm_in_c_and_javascript() {
    let robot = two_link_craig();
    let functions = Function::default_set(false).into_iter().map(Request::from);
    let program = |request: Request| {
        let program = proven_program(&robot, &request).expect("proven");
        (request, program)
    };
    let programs: Vec<_> = functions.map(program).collect();
    let files = c_source(&robot, &programs);
    expect_file!["../golden/two_link_craig.h"].assert_eq(&files.header);
    expect_file!["../golden/two_link_craig.c"].assert_eq(&files.source);
    expect_file!["../golden/two_link_craig.mjs"].assert_eq(&javascript_module(&robot, &programs));
}
