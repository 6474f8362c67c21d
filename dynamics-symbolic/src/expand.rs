//! From a robot to its methods: derive, prove, emit.

use crate::derive::derive;
use crate::emit;
use crate::function::{Function, Shape};
use crate::neglect::{STATES, largest_error};
use crate::program::{Operations, Program};
use crate::prove::{ProofFailure, prove};
use crate::robot::Robot;
use core::fmt;
use proc_macro2::TokenStream;

/// A generated method.
pub struct Method {
    /// The function that it computes.
    pub function: Function,
    /// The documented item of the inherent implementation.
    pub tokens: TokenStream,
    /// The item of the runtime's trait for the function, where there is one: see
    /// [`Function::trait_name`].
    pub provided: Option<TokenStream>,
    /// What it costs.
    pub operations: Operations,
    /// The joints whose position's sine or cosine it reads.
    pub angles: Vec<usize>,
}

/// Why a function cannot be generated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Failure {
    /// Its program is not equal to the textbook definition: a defect of this crate.
    Proof(ProofFailure),
    /// A constant of its program, a product or a quotient of numbers in the table, is too large for
    /// a double.
    Overflow(Function),
}

impl Failure {
    /// The function.
    pub fn function(&self) -> Function {
        match self {
            Failure::Proof(failure) => failure.function,
            Failure::Overflow(function) => *function,
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Failure::Proof(failure) => failure.fmt(f),
            Failure::Overflow(function) => write!(
                f,
                "a constant in `{}` is too large for a double-precision number: numbers of the table \
                 combine to more than 1.8e308, are the units right?",
                function.name()
            ),
        }
    }
}

impl std::error::Error for Failure {}

/// Derives, proves and emits the functions of a robot; `path` is the path of the runtime crate.
///
/// # Errors
///
/// Every function that cannot be generated, with the reason.
pub fn expand(
    robot: &Robot,
    functions: &[Function],
    path: &TokenStream,
) -> Result<Vec<Method>, Vec<Failure>> {
    expand_with(robot, functions, path, &derive)
}

/// As [`expand`], with programs from another derivation: they must pass the same proof.
///
/// # Errors
///
/// Every function that cannot be generated, with the reason.
pub fn expand_with(
    robot: &Robot,
    functions: &[Function],
    path: &TokenStream,
    derive: &dyn Fn(&Robot, Function) -> Program,
) -> Result<Vec<Method>, Vec<Failure>> {
    let mut methods = Vec::with_capacity(functions.len());
    let mut failures = Vec::new();
    for &function in functions {
        let program = derive(robot, function);
        let mut notes = neglected(robot, function, &program, derive);
        notes.extend(plain(&program));
        let method = match function.shape() {
            Shape::Series => taylor_series(robot, program, &notes, path, derive),
            _ => method(robot, function, program, &notes, path),
        };
        match method {
            Ok(method) => methods.push(method),
            Err(failure) => failures.push(failure),
        }
    }
    if failures.is_empty() {
        Ok(methods)
    } else {
        Err(failures)
    }
}

/// What the documentation says of a program that no search has shortened.
fn plain(program: &Program) -> Option<String> {
    program.is_plain.then(|| {
        " Written as the recursion of the equations of motion is: every shorter program that was found \
         would cost digits."
            .to_owned()
    })
}

/// What the documentation says of a function of an abbreviated model, beside the complete one.
fn neglected(
    robot: &Robot,
    function: Function,
    program: &Program,
    derive: &dyn Fn(&Robot, Function) -> Program,
) -> Vec<String> {
    let Some(neglected) = robot
        .neglected
        .as_ref()
        .filter(|_| function.row().reads_inertia)
    else {
        return Vec::new();
    };
    let complete = Robot {
        neglected: None,
        ..robot.clone()
    };
    let whole = derive(&complete, function);
    let error = largest_error(&complete, function, &whole, program);
    let definite = match neglected.is_definite {
        true => "",
        false => " That the mass matrix is positive definite at all positions was not shown.",
    };
    vec![format!(
        " Of the abbreviated model: what stays below {} % is neglected. The largest error at {STATES} sampled \
         states is {:.1e} of the largest value of the complete function, which takes {} operations, {} more.{definite}",
        percent(neglected.share),
        error.relative,
        error.complete,
        error.saved,
    )]
}

/// A share in percent, without the noise of a product of doubles.
pub fn percent(share: f64) -> String {
    let digits = format!("{:.6}", 100.0 * share);
    digits
        .trim_end_matches('0')
        .trim_end_matches('.')
        .to_owned()
}

/// Proves a program, rounds its constants and emits it.
fn method(
    robot: &Robot,
    function: Function,
    program: Program,
    notes: &[String],
    path: &TokenStream,
) -> Result<Method, Failure> {
    prove(robot, function, &program).map_err(Failure::Proof)?;
    let constants = program.rounded_constants();
    if constants.iter().any(|x| x.is_infinite()) {
        return Err(Failure::Overflow(function));
    }
    let emitted = emit::method(robot, function, &program, &constants, notes, path);
    Ok(of(function, emitted, &[&program]))
}

/// Proves and emits the two programs of Taylor series: the equations of motion, and the mass
/// matrix, by which the accelerations follow from them.
fn taylor_series(
    robot: &Robot,
    equations: Program,
    notes: &[String],
    path: &TokenStream,
    derive: &dyn Fn(&Robot, Function) -> Program,
) -> Result<Method, Failure> {
    let function = Function::TaylorSeries;
    let part = Function::MassMatrix;
    let programs = [(function, equations), (part, derive(robot, part))];
    let mut rounded = Vec::with_capacity(programs.len());
    for (part, program) in &programs {
        prove(robot, *part, program).map_err(Failure::Proof)?;
        let constants = program.rounded_constants();
        if constants.iter().any(|x| x.is_infinite()) {
            return Err(Failure::Overflow(function));
        }
        rounded.push(constants);
    }
    let [(_, equations), (_, matrix)] = &programs;
    let parts = [
        (equations, rounded[0].as_slice()),
        (matrix, rounded[1].as_slice()),
    ];
    let emitted = emit::taylor_series(robot, parts, notes, path);
    Ok(of(function, emitted, &[equations, matrix]))
}

/// A method as it was emitted, the operations of its first program, the angles of all.
fn of(function: Function, emitted: emit::Emitted, programs: &[&Program]) -> Method {
    let angles = programs.iter().flat_map(|program| program.joint_angles());
    Method {
        function,
        tokens: emitted.inherent,
        provided: emitted.provided,
        operations: programs[0].operations(),
        angles: angles.collect(),
    }
}
