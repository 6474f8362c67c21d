//! CasADi: a C file of the functions that `casadi.external` looks for, with their derivatives.
//!
//! CasADi differentiates an external function `f` by `jac_f`, whose inputs are those of `f` and a place for each output,
//! and whose outputs are a block for each output and input. Second derivatives are `jac_jac_f` by the same rule. Where there
//! are some, `adj1_f` is the reverse mode and `jac_adj1_f` its derivatives, of which CasADi makes Hessians. Forward dynamics
//! has these two alone (`solved`).
//!
//! `derivatives` says which programs have the derivatives of a function, `blocks` puts their values where CasADi
//! expects them and sums them with weights, and `calls` says where these sums read them. `pose` makes derivatives by the
//! pose of a base of those that programs have. `function` writes one function of the file, `text` what stands around all,
//! and `interface` names, patterns of entries in compressed columns, and room.
//!
//! Outputs that are the constant zero are no part of a pattern. A block of derivatives that no program has, by symbolic
//! parameters, is full of NaN and not left out: CasADi would take what is left out as zero. `casadi_requests` names the
//! programs that must be derived besides.

mod blocks;
mod calls;
mod derivatives;
mod function;
mod interface;
mod pose;
mod solved;
mod text;

use crate::body::Body;
use crate::c::WORDS;
use crate::c::precision::{CNumbers, Precision};
use crate::comments::lines as documentation;
use crate::names::{free_name, snake_case};
use blocks::Blocks;
use calls::Calls;
use derivatives::{Second, derivatives};
use dynamics_symbolic::function::{Request, plain};
use dynamics_symbolic::program::Proven;
use dynamics_symbolic::robot::Robot;
use interface::{Input, Output, Patterns};

/// The functions of a robot for CasADi.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CasadiSource {
    /// The name of the file: `panda_casadi.c`.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// The input that has the symbolic parameters of the robot.
const FIELDS: &str = "arm";

/// The numbers that are read where an input is not there.
const ZEROS: &str = "robot_dynamics_zeros";

const REFUSAL: &str = "Fails where M(q) is not positive definite to working precision or not finite: returns the number \
                       of the joint whose pivot failed, counted from 1, and writes nothing.";

/// Second derivatives of inverse dynamics are derived for forward dynamics alone up to so many degrees of freedom: those of a
/// humanoid take minutes.
const MOST_SOLVED: usize = 18;

/// The methods whose programs the file of some methods has: each of these, then its derivatives.
pub fn casadi_requests(robot: &Robot, requests: &[Request]) -> Vec<Request> {
    let mut needed: Vec<Request> = requests.to_vec();
    for request in requests {
        let Some(derivatives) = derivatives(request) else {
            continue;
        };
        let is_short = robot.freedoms().all() <= MOST_SOLVED;
        let second = derivatives.second();
        let second = second.filter(|_| derivatives.second == Some(Second::Same) || is_short);
        let of_request = [Some(derivatives.first(robot)), second];
        for request in of_request.into_iter().flatten() {
            if !needed.iter().any(|known| known.parts() == request.parts()) {
                needed.push(request);
            }
        }
    }
    needed
}

/// Some methods of a robot as functions of CasADi. `programs` has those of [`casadi_requests`].
///
/// A function has the name of the method. Its inputs are the arguments, its outputs matrices without the entries that are
/// zero always. The symbolic parameters of the robot are the first input, `arm`, in their order. Derivatives by it are not
/// known: they are NaN.
pub fn casadi_source(
    robot: &Robot,
    requests: &[Request],
    programs: &[(Request, Proven)],
) -> CasadiSource {
    let mut file = File {
        robot,
        precision: CNumbers::Double.precision(),
        patterns: Patterns::default(),
        longest: 1,
    };
    let programs = programs.iter();
    let programs: Vec<_> = programs
        .map(|(request, proven)| (request.clone(), proven.ordered()))
        .collect();
    let functions: String = requests
        .iter()
        .filter_map(|request| file.with_derivatives(request, &programs))
        .collect();
    CasadiSource {
        name: format!("{}_casadi.c", snake_case(&robot.name)),
        text: file.text(&functions),
    }
}

/// A program of a request.
type Of<'a> = &'a (Request, Proven);

/// The file that is being written.
struct File<'a> {
    robot: &'a Robot,
    precision: &'static Precision,
    patterns: Patterns,
    /// The most entries of an input.
    longest: usize,
}

impl File<'_> {
    /// A function and those of its derivatives; `None` without its program.
    fn with_derivatives(
        &mut self,
        request: &Request,
        programs: &[(Request, Proven)],
    ) -> Option<String> {
        let program = |request: &Request| {
            let mut programs = programs.iter();
            programs.find(|(known, _)| known.parts() == request.parts())
        };
        let function = program(request)?;
        let name = name(request.name());
        let body = self.body(function);
        let blocks = Blocks::new(self.robot, function, &body);
        let comment = documentation(self.robot, &function.0, &function.1, REFUSAL);
        let outputs = blocks.outputs(&body.entries(&function.0));
        let mut text = self.function(&name, &comment, function, &blocks.inputs(), &outputs);
        let Some(derivatives) = derivatives(request) else {
            return Some(text);
        };
        let Some(first) = program(&derivatives.first(self.robot)) else {
            return Some(text);
        };
        let of_first = blocks.first(&self.body(first).entries(&first.0));
        let comment = [format!("First derivatives of `{name}`.")];
        let jac = format!("jac_{name}");
        text += &self.function(&jac, &comment, first, &blocks.inputs_of_first(), &of_first);
        let Some(second) = derivatives.second().as_ref().and_then(program) else {
            return Some(text);
        };
        let values = self.body(second).entries(&second.0);
        if derivatives.second == Some(Second::Solved) {
            text += &self.adjoint(&name, &blocks, &of_first);
            text += &self.derived_adjoint_of_solved(&name, &blocks, &outputs, &of_first, second);
            return Some(text);
        }
        let of_second = blocks.second(&values);
        let comment = [format!("Second derivatives of `{name}`.")];
        let jac = format!("jac_jac_{name}");
        text += &self.function(
            &jac,
            &comment,
            second,
            &blocks.inputs_of_second(),
            &of_second,
        );
        text += &self.adjoint(&name, &blocks, &of_first);
        text += &self.derived_adjoint(&name, &blocks, &of_first, &of_second);
        Some(text)
    }

    fn body<'a>(&'a self, (_, proven): Of<'a>) -> Body<'a> {
        Body::new(self.robot, proven, &self.precision.syntax)
    }

    /// The reverse mode of a function with these blocks of first derivatives.
    fn adjoint(&mut self, of: &str, blocks: &Blocks, first: &[Output]) -> String {
        let calls = Calls::default().add(&format!("jac_{of}"), first);
        let comment = format!("First derivatives of `{of}`, transposed, times `adj_..`.");
        let (inputs, outputs) = (blocks.inputs_of_adjoint(), blocks.adjoint(first));
        self.calling(&format!("adj1_{of}"), comment, calls, &inputs, &outputs)
    }

    /// Its derivatives, of blocks of second derivatives.
    fn derived_adjoint(
        &mut self,
        of: &str,
        blocks: &Blocks,
        first: &[Output],
        second: &[Output],
    ) -> String {
        let calls = Calls::default().add(&format!("jac_{of}"), first);
        let calls = calls.add(&format!("jac_jac_{of}"), second);
        let comment = format!("First derivatives of `adj1_{of}`.");
        let inputs = blocks.inputs_of_derived_adjoint();
        let outputs = blocks.derived_adjoint(first, second);
        self.calling(&format!("jac_adj1_{of}"), comment, calls, &inputs, &outputs)
    }

    /// The same of accelerations that solve the equation of inverse dynamics, whose second derivatives a program has.
    fn derived_adjoint_of_solved(
        &mut self,
        of: &str,
        blocks: &Blocks,
        values: &[Output],
        first: &[Output],
        second: Of<'_>,
    ) -> String {
        let calls = Calls::default().add(of, values);
        let calls = calls.add(&format!("jac_{of}"), first);
        let body = self.body(second);
        let mut statements = body.statements(&second.0);
        let (sums, outputs) = blocks.solved(first, &body.entries(&second.0));
        statements.extend(sums);
        let inputs = blocks.inputs_of_derived_adjoint();
        let mut lines = self.weights(&inputs);
        lines.extend(self.reads(second, &inputs, &statements, &calls));
        let lines = [calls.statements, lines, statements].concat();
        let comment = [format!("First derivatives of `adj1_{of}`.")];
        let name = format!("jac_adj1_{of}");
        self.defined(&name, &comment, lines, &inputs, &outputs, calls.room)
    }

    /// A function of that name that calls others.
    fn calling(
        &mut self,
        name: &str,
        documentation: String,
        calls: Calls,
        inputs: &[Input],
        outputs: &[Output],
    ) -> String {
        let mut lines = calls.statements;
        lines.extend(self.weights(inputs));
        lines.push("(void)res;".to_owned());
        self.defined(name, &[documentation], lines, inputs, outputs, calls.room)
    }
}

/// Names that CasADi gives to no function.
const NAMES_OF_CASADI: &str = "null jac hess";

/// A name as CasADi takes it: letters and digits of ASCII, and underscores one by one between them. Other letters are
/// written by their numbers.
fn name(name: &str) -> String {
    let mut ascii = String::new();
    for letter in plain(name).chars() {
        match letter {
            _ if letter.is_ascii_alphanumeric() => ascii.push(letter),
            _ if letter.is_alphanumeric() => ascii += &format!("u{:x}", u32::from(letter)),
            _ => ascii.push('_'),
        }
    }
    let words: Vec<_> = ascii.split('_').filter(|word| !word.is_empty()).collect();
    free_name(&words.join("_"), &[WORDS, NAMES_OF_CASADI].concat())
}

#[cfg(test)]
mod tests {
    use super::name;

    #[test]
    fn names_are_those_of_casadi() {
        for (given, expected) in [
            ("jacobian_left_hand", "jacobian_left_hand"),
            ("r#double", "double_"),
            ("hess", "hess_"),
            ("_a__b_", "a_b"),
            ("jacobian_\u{e9}", "jacobian_ue9"),
        ] {
            assert_eq!(name(given), expected);
        }
    }
}
