//! The plain recursions of functions: what the rounding of other programs is measured by.
//!
//! The plain recursion in the plain gauge, nothing simplified, adds what the equations of motion add.
//! Its rounding is that of the quantities themselves, and every other way of writing them is judged
//! beside it: while it is searched for, at some states, and once it is found, at others.
//!
//! The finished program, its sums in their final order, is measured at eight states of its own. Up to 16 times the
//! error of the plain recursion is accepted. If it has more, the search is made again in the plain gauge. If that
//! does not help, the plain recursion is emitted, and the documentation of the method says so. Articulated bodies are
//! compared with themselves in the plain gauge, because for quotients of quotients the bound of another form says
//! little.

use super::functions::Part;
use super::states::{State, states};
use super::symbols::Symbols;
use super::units::groups;
use super::{plain_recursion, unsimplified};
use crate::mechanism::Mechanism;
use crate::program::Program;
use crate::rounding::{POINTS, Rounded, Running};
use crate::simplify::{Judge, Network};

/// How many times the plain recursion's error a definition may lead to, in the search.
const ALLOWED: f64 = 8.0;

/// How many times the plain recursion's error a program may have in the end. Its states are others,
/// and its sums are added in another order than when it was searched for.
const ACCEPTED: f64 = 16.0;

/// The search sees errors at [`POINTS`] states, in pairs.
const SEED: u64 = 0x0072_6f75_6e64;

/// The finished program is measured at states of its own.
const SEED_OF_MEASURE: u64 = 0x6d65_6173_7572;

/// How many pairs those are.
const PAIRS_OF_MEASURE: usize = 4;

/// Errors by output, at one state each.
type Errors = Vec<f64>;

/// The plain recursions of some functions, each on its own: what they share with one another
/// when they are one program does not matter.
pub(super) struct Recursion {
    parts: Vec<Own>,
}

/// The plain recursion of one function.
struct Own {
    program: Program,
    /// For each output its group: see [`groups`].
    groups: Vec<usize>,
}

impl Recursion {
    /// The recursions beside which the programs of some parts are measured.
    pub(super) fn of(arm: &Mechanism, parts: &[Part]) -> Self {
        let joints = arm.free().skip(arm.freedoms().base);
        let joints: Vec<_> = joints.map(|i| arm.joints[i].axis_motion).collect();
        let own = |part: &Part| {
            let program = unsimplified(arm, &[plain_recursion(arm, &[*part])]);
            Own {
                groups: groups(
                    arm.freedoms(),
                    &joints,
                    part.function,
                    program.outputs.len(),
                ),
                program,
            }
        };
        Recursion {
            parts: parts.iter().map(own).collect(),
        }
    }

    /// The judge of another network of the functions.
    pub(super) fn judge<'g>(
        &self,
        arm: &Mechanism,
        symbols: &Symbols<'g>,
        network: &Network<'g>,
    ) -> Judge<'g> {
        let states = states(arm, SEED, POINTS / 2);
        let plain = self.natural_errors(&states);
        let of_output = |output: usize| core::array::from_fn(|k| ALLOWED * plain[k][output]);
        let outputs = self.parts.iter().map(|own| own.groups.len()).sum();
        let allowed = (0..outputs).map(of_output).collect();
        let meanings = symbols.meanings();
        let running = Running::new(symbols.graph(), meanings, |k, symbol| {
            states[k / 2][k % 2].symbol(symbol)
        });
        Judge::new(network, running, allowed)
    }

    /// Whether the errors of a program at states of its own are those of the plain recursions except for a
    /// small factor.
    pub(super) fn accepts(&self, arm: &Mechanism, program: &Program) -> bool {
        let states = states(arm, SEED_OF_MEASURE, PAIRS_OF_MEASURE);
        let natural = self.natural_errors(&states);
        let rounded = Rounded::new(program);
        states
            .iter()
            .flatten()
            .zip(natural)
            .all(|(state, natural)| {
                let errors = errors(&rounded, state);
                let mut pairs = errors.iter().zip(&natural);
                pairs.all(|(error, natural)| *error <= ACCEPTED * natural)
            })
    }

    /// The errors of the outputs of the plain recursions at some states.
    fn natural_errors(&self, states: &[[State; 2]]) -> Vec<Errors> {
        let mut of_all = vec![Errors::new(); 2 * states.len()];
        for own in &self.parts {
            let of_own = own.natural_errors(states);
            for (errors, of_own) in of_all.iter_mut().zip(of_own) {
                errors.extend(of_own);
            }
        }
        of_all
    }
}

impl Own {
    /// The errors of the outputs at some states: the largest in the group of
    /// the output, and of both states of a pair, so that none is small by chance.
    fn natural_errors(&self, states: &[[State; 2]]) -> Vec<Errors> {
        let rounded = Rounded::new(&self.program);
        let of_pair = |pair: &[State; 2]| {
            let [mut first, second] = pair.each_ref().map(|state| errors(&rounded, state));
            for (error, other) in first.iter_mut().zip(second) {
                *error = error.max(other);
            }
            let first = self.largest_of_groups(&first);
            [first.clone(), first]
        };
        states.iter().flat_map(of_pair).collect()
    }

    fn largest_of_groups(&self, errors: &Errors) -> Errors {
        let count = self.groups.iter().max().map_or(0, |group| group + 1);
        let mut largest = vec![0.0_f64; count];
        for (&group, &error) in self.groups.iter().zip(errors) {
            largest[group] = largest[group].max(error);
        }
        self.groups.iter().map(|&group| largest[group]).collect()
    }
}

fn errors(program: &Rounded<'_>, state: &State) -> Errors {
    let outputs = program.outputs(&|symbol| state.symbol(symbol));
    outputs.into_iter().map(|output| output.error).collect()
}
