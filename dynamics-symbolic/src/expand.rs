//! From a robot to its methods: derive, prove, emit.

use crate::derive::derive;
use crate::emit;
use crate::function::Function;
use crate::program::{Operations, Program};
use crate::prove::{ProofFailure, prove};
use crate::robot::Robot;
use proc_macro2::TokenStream;

/// A generated method.
pub struct Method {
    /// The function that it computes.
    pub function: Function,
    /// The documented item of the inherent implementation.
    pub tokens: TokenStream,
    /// What it costs.
    pub operations: Operations,
}

/// Derives, proves and emits the functions of a robot; `path` is the path of the runtime crate.
///
/// # Errors
///
/// The functions whose program is not equal to the textbook definition: a defect of this crate.
pub fn expand(
    robot: &Robot,
    functions: &[Function],
    path: &TokenStream,
) -> Result<Vec<Method>, Vec<ProofFailure>> {
    expand_with(robot, functions, path, &derive)
}

/// As [`expand`], with programs from another derivation: they must pass the same proof.
///
/// # Errors
///
/// The functions whose program is not equal to the textbook definition.
pub fn expand_with(
    robot: &Robot,
    functions: &[Function],
    path: &TokenStream,
    derive: &dyn Fn(&Robot, Function) -> Program,
) -> Result<Vec<Method>, Vec<ProofFailure>> {
    let mut methods = Vec::with_capacity(functions.len());
    let mut failures = Vec::new();
    for &function in functions {
        let program = derive(robot, function);
        match prove(robot, function, &program) {
            Ok(()) => methods.push(Method {
                function,
                tokens: emit::method(robot, function, &program, path),
                operations: program.operations(),
            }),
            Err(failure) => failures.push(failure),
        }
    }
    if failures.is_empty() {
        Ok(methods)
    } else {
        Err(failures)
    }
}
