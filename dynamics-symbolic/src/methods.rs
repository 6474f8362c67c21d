//! From a robot to its methods: derive, prove, emit.

use crate::bounds::{self, Rounding};
use crate::derive::derive_together;
use crate::emit;
use crate::formula::{Budget, Equation, Formulas, MOST_TERMS};
use crate::function::{Function, Masses, Part, Request};
use crate::inverse::{Plan, Unsolved, plan};
use crate::mechanism::Mechanism;
use crate::neglect::{STATES, largest_error};
use crate::program::{Operations, Program, Proven};
use crate::prove::{ProofFailure, prove_inverse, prove_together};
use crate::robot::Robot;
use core::fmt;
use proc_macro2::TokenStream;

/// A generated method.
pub struct Method {
    /// The function, or the functions, that it computes.
    pub request: Request,
    /// The documented item of the inherent implementation.
    pub tokens: TokenStream,
    /// The item of the runtime's trait for the function, where there is one: see
    /// [`Function::trait_name`].
    pub provided: Option<TokenStream>,
    /// The items of the runtime's trait `Function`, where the function has no trait of its own.
    pub function: Option<TokenStream>,
    /// Its operations.
    pub operations: Operations,
    /// The bounds of its rounding errors over the limits, in double and in single precision; infinite if there is none.
    pub rounding: [f64; 2],
    /// The joints whose position's sine or cosine it reads.
    pub angles: Vec<usize>,
    /// Its values as equations, if these are short enough to read.
    pub equations: Vec<Equation>,
}

/// Why a method cannot be generated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure {
    /// The request that failed.
    pub request: Request,
    /// The reason.
    pub reason: Reason,
}

/// Why a program is of no use.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reason {
    /// It is not equal to the textbook definition: a defect of this crate.
    Proof(ProofFailure),
    /// One of its constants, a product or a quotient of numbers in the table, is too large for
    /// a double.
    Overflow,
    /// The friction of this joint falls with the velocity, by an exponential of which there is no series
    /// here.
    NoSeries {
        /// The joint's name.
        joint: String,
    },
    /// It is written over Taylor series, and not as a program over numbers.
    OverSeries,
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = self.request.name();
        match (&self.reason, self.request.function()) {
            (Reason::Proof(failure), Some(_)) => failure.fmt(f),
            (Reason::Proof(failure), None) => write!(f, "`{name}`: {failure}"),
            (Reason::NoSeries { joint }, _) => write!(
                f,
                "`{name}` does not follow friction that falls with the velocity: request other functions, \
                 or leave out `stribeck` of `{joint}`"
            ),
            (Reason::OverSeries, _) => write!(
                f,
                "`{name}` is no program over numbers: only the macro `robot_dynamics!` generates it"
            ),
            (Reason::Overflow, _) => write!(
                f,
                "a constant in `{name}` is too large for a double-precision number: numbers of the table \
                 combine to more than 1.8e308, are the units right?",
            ),
        }
    }
}

impl std::error::Error for Failure {}

/// Finds the program of a function, or the one of several.
type Derivation = dyn Fn(&Robot, &[Part]) -> Program;

/// Derives, proves and emits the methods that are requested; `path` is the path of the runtime crate.
///
/// # Errors
///
/// Every method that cannot be generated, with the reason.
pub fn expand<R: Clone + Into<Request>>(
    robot: &Robot,
    requests: &[R],
    path: &TokenStream,
) -> Result<Vec<Method>, Vec<Failure>> {
    expand_with(robot, requests, path, &derive_together)
}

/// As [`expand`], with programs from another derivation: they must pass the same proof.
///
/// # Errors
///
/// Every method that cannot be generated, with the reason.
pub fn expand_with<R: Clone + Into<Request>>(
    robot: &Robot,
    requests: &[R],
    path: &TokenStream,
    derive: &Derivation,
) -> Result<Vec<Method>, Vec<Failure>> {
    let mut methods: Vec<Method> = Vec::with_capacity(requests.len());
    let mut failures = Vec::new();
    for (index, request) in requests.iter().enumerate() {
        let request = robot.request(request.clone().into());
        let program = derive(robot, request.parts());
        let mut notes = neglected(robot, &request, &program, derive);
        notes.extend(plain(&program));
        notes.extend(factored(robot, &request));
        if request.is_tuple() {
            notes.push(beside_single_calls(
                robot, &request, &program, &methods, derive,
            ));
        }
        let method = match request.function() {
            Some(Function::TaylorSeries) => taylor_series(robot, program, &notes, path, derive),
            _ => method(robot, (&request, index), program, notes, path),
        };
        match method {
            Ok(method) => methods.push(method),
            Err(reason) => failures.push(Failure { request, reason }),
        }
    }
    if failures.is_empty() {
        Ok(methods)
    } else {
        Err(failures)
    }
}

/// The sentence about one program for several functions, beside a program for each of them. A program of the methods
/// before is not derived again.
fn beside_single_calls(
    robot: &Robot,
    fused: &Request,
    program: &Program,
    methods: &[Method],
    derive: &Derivation,
) -> String {
    let alone = |part: &Part| {
        let method = |m: &&Method| !m.request.is_tuple() && m.request.parts() == [*part];
        let known = methods.iter().find(method).map(|method| method.operations);
        known.unwrap_or_else(|| derive(robot, &[*part]).operations())
    };
    let alone: Vec<Operations> = fused.parts().iter().map(alone).collect();
    let total: u32 = alone.iter().map(Operations::total).sum();
    let angles: u32 = alone.iter().map(|operations| operations.sin_cos).sum();
    let apart = format!(
        "A call of each function takes {total} multiplications, additions and divisions in all, and sines and \
         cosines {angles} times"
    );
    let together = program.operations();
    match total.saturating_sub(together.total()) {
        0 if together.sin_cos == angles => format!(" {apart}: nothing is saved here."),
        0 => format!(" {apart}: nothing but sines and cosines is saved here."),
        saved => format!(" {apart}; {saved} operations are saved here."),
    }
}

/// The sentence about a program that no search has shortened.
fn plain(program: &Program) -> Option<String> {
    program.is_plain.then(|| {
        " Written as the recursion of the equations of motion is: every shorter program that was found \
         would cost digits."
            .to_owned()
    })
}

/// The sentence about forward dynamics by articulated bodies if joints follow others.
fn factored(robot: &Robot, request: &Request) -> Option<String> {
    let is_by_bodies = |function| function == Function::ForwardDynamicsAba;
    let is_factored = robot.is_coupled() && request.functions().any(is_by_bodies);
    is_factored.then(|| {
        " Joints of this arm follow others, for which there are no articulated bodies: M(q) is factored, as in \
         `forward_dynamics`, and the digits are those of that function."
            .to_owned()
    })
}

/// The sentence about a function of an abbreviated model, beside the complete one.
fn neglected(
    robot: &Robot,
    request: &Request,
    program: &Program,
    derive: &Derivation,
) -> Vec<String> {
    let parts = request.parts();
    let mut parts_read = request.functions().map(|function| function.row().masses);
    let reads_inertia = parts_read.any(|masses| masses == Masses::Inertia);
    let Some(neglected) = robot.neglected.as_ref().filter(|_| reads_inertia) else {
        return Vec::new();
    };
    let complete = Robot {
        neglected: None,
        ..robot.clone()
    };
    let whole = derive(&complete, parts);
    let error = largest_error(&complete, parts, &whole, program);
    let definite = if neglected.is_definite {
        ""
    } else {
        " That the mass matrix is positive definite at all positions was not shown."
    };
    vec![format!(
        " The model is abbreviated: what stays below {} % is neglected. The largest error at {STATES} sampled \
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

/// The sentence about rounding errors.
fn rounding_note(rounding: &Rounding) -> String {
    let line = rounding.line();
    match rounding.largest()[0].is_finite() {
        true => format!(" {line}"),
        false => format!(" {line} `Certified` bounds it at a state."),
    }
}

/// Proves a program, rounds its constants and emits it.
fn method(
    robot: &Robot,
    (request, index): (&Request, usize),
    program: Program,
    mut notes: Vec<String>,
    path: &TokenStream,
) -> Result<Method, Reason> {
    let proven = proven(robot, request, program)?;
    let program = &proven.program;
    let rounding = bounds::rounding(robot, request, &proven);
    notes.extend(rounding.as_ref().map(rounding_note));
    let formulas = Formulas::of_short_arm(robot, request.parts(), program, Budget::UNASKED);
    let emitted = emit::method(
        robot,
        (request, index),
        &proven,
        formulas.as_ref(),
        &notes,
        path,
    );
    let equations = formulas.map_or(Vec::new(), |formulas| formulas.equations(MOST_TERMS));
    Ok(Method {
        equations,
        rounding: rounding.map_or([f64::INFINITY; 2], |rounding| rounding.largest()),
        ..method_of(request.clone(), emitted, &[program])
    })
}

/// The program of what is requested, which the macro writes down, and others evaluate or write down in
/// another language.
///
/// # Errors
///
/// As [`expand`]; besides where `taylor_series` is requested, which is no program over numbers.
pub fn proven_program(robot: &Robot, request: &Request) -> Result<Proven, Failure> {
    let failure = |reason| Failure {
        request: request.clone(),
        reason,
    };
    if request.function() == Some(Function::TaylorSeries) {
        return Err(failure(Reason::OverSeries));
    }
    let program = derive_together(robot, request.parts());
    proven(robot, request, program).map_err(failure)
}

/// Proves a program and rounds its constants.
fn proven(robot: &Robot, request: &Request, program: Program) -> Result<Proven, Reason> {
    prove_together(robot, request.parts(), &program).map_err(Reason::Proof)?;
    let proven = Proven::rounding(program);
    if proven.overflows() {
        return Err(Reason::Overflow);
    }
    Ok(proven)
}

/// Proves and emits the two programs of Taylor series: the equations of motion, and the mass
/// matrix, by which the accelerations follow from them.
fn taylor_series(
    robot: &Robot,
    equations: Program,
    notes: &[String],
    path: &TokenStream,
    derive: &Derivation,
) -> Result<Method, Reason> {
    let arm = Mechanism::from(robot);
    let mut joints = arm.joints.iter();
    if let Some(joint) = joints.find(|joint| joint.forces.stribeck.is_some()) {
        let joint = joint.name.clone();
        return Err(Reason::NoSeries { joint });
    }
    let [request, matrix] = [Function::TaylorSeries, Function::MassMatrix].map(Request::from);
    let equations = proven(robot, &request, equations)?;
    let program = derive(robot, matrix.parts());
    let matrix = proven(robot, &matrix, program)?;
    let emitted = emit::taylor_series(robot, [&equations, &matrix], notes, path);
    let programs = [&equations.program, &matrix.program];
    Ok(method_of(request, emitted, &programs))
}

/// A method as it was emitted, the operations of its first program, the angles of all.
fn method_of(request: Request, emitted: emit::Emitted, programs: &[&Program]) -> Method {
    let angles = programs.iter().flat_map(|program| program.joint_angles());
    Method {
        request,
        tokens: emitted.inherent,
        provided: emitted.provided,
        function: emitted.function,
        operations: programs[0].operations(),
        rounding: [f64::INFINITY; 2],
        angles: angles.collect(),
        equations: Vec::new(),
    }
}

/// The proven plan of inverse kinematics for a frame among the robot's `frames`, or for its tip.
///
/// # Errors
///
/// Why the arm has no closed form.
pub fn proven_plan(robot: &Robot, frame: Option<usize>) -> Result<Plan, Unsolved> {
    let plan = plan(robot, frame, &|plan| prove_inverse(robot, frame, plan))?;
    if plan.proven().overflows() {
        return Err(Unsolved::Overflow);
    }
    Ok(plan)
}

/// The method of inverse kinematics, for a frame among the robot's `frames`, or for its tip; `path` is that of the runtime.
///
/// # Errors
///
/// Why the arm has no closed form.
pub fn inverse_kinematics(
    robot: &Robot,
    frame: Option<usize>,
    path: &TokenStream,
) -> Result<TokenStream, Unsolved> {
    let plan = proven_plan(robot, frame)?;
    let name = frame.map(|frame| robot.frames[frame].name.as_str());
    Ok(emit::inverse_kinematics(robot, name, &plan, path))
}
