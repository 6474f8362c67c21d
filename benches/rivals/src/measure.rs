//! Values, errors and times of every candidate, printed as lines of words.

use measuring::Effort;
use robot_dynamics::nalgebra::{SMatrix, SVector};
use robot_dynamics::{DoubleDouble, NewtonEuler, State};

use crate::candidates::{Candidate, Dynibo, GENERATED, Lanes, Values};
use crate::errors::errors;
use crate::others::rounding_error;
use measured_arms::*;
use testkit::columns::Columns;
use testkit::five::{self, Five, NAMES};

/// Number of states: a function is evaluated at each in turn.
const STATES: usize = 64;

/// States spread over the joints' circles; positions of sliding joints within 3 m.
fn states<const N: usize>() -> Vec<State<N>> {
    let states = five::states(STATES).into_iter();
    states.map(|[q, qd, qdd]| State { q, qd, qdd }).collect()
}

/// The functions that only the generated code has, as the report groups them: those that are not
/// measured (below) have no line there.
pub(crate) const GROUPS: [(&str, &[&str]); 3] = [
    (
        "Derivatives and the regressor",
        &[
            "inverse_dynamics_derivatives",
            "forward_dynamics_derivatives",
            "regressor",
        ],
    ),
    (
        "Batches",
        &[
            "inverse_dynamics_batch",
            "mass_matrix_batch",
            "coriolis_vector_batch",
            "gravity_vector_batch",
            "forward_dynamics_batch",
        ],
    ),
    (
        "Other functions",
        &[
            "bias_force",
            "coriolis_matrix",
            "kinetic_energy",
            "potential_energy",
            "forward_kinematics",
            "jacobian",
        ],
    ),
];

/// Largest difference of two candidates' values, relative to the largest entry.
const AGREEMENT: f64 = 1e-9;

/// Prints `time ARM FUNCTION CANDIDATE NS` and `error ARM FUNCTION CANDIDATE LARGEST RMS`.
pub(crate) fn all() {
    macro_rules! measure {
        ($($file:ident: $arm:ident, $n:literal;)*) => {$(
            let file = stringify!($file);
            let mut measured = Measured { arm: &mut $arm, file, states: states::<$n>() };
            measured.rival(&mut $arm);
            measured.rival(&mut NewtonEuler::new(&$arm.table()));
            measured.rival(&mut Dynibo::new(file, &$arm.table()));
            #[cfg(feature = "symplex")]
            measured.rival(&mut crate::candidates::Symplex::new(&$arm));
            measured.batches(&mut Lanes($arm));
            others!(measured, $arm);
        )*};
    }
    for_each_arm!(measure);
}

/// The functions that only the generated code has, a line each.
macro_rules! others {
    ($measured:ident, $arm:ident) => {
        other!($measured, bias_force, |q, qd, _| $arm.bias_force(&q, &qd));
        other!($measured, coriolis_matrix, |q, qd, _| $arm
            .coriolis_matrix(&q, &qd));
        other!($measured, kinetic_energy, |q, qd, _| $arm
            .kinetic_energy(&q, &qd));
        other!($measured, potential_energy, |q, _, _| $arm
            .potential_energy(&q));
        other!($measured, forward_kinematics, |q, _, _| $arm
            .forward_kinematics(&q));
        other!($measured, jacobian, |q, _, _| $arm.jacobian(&q));
        other!($measured, inverse_dynamics_derivatives, |q, qd, qdd| $arm
            .inverse_dynamics_derivatives(&q, &qd, &qdd));
        other!($measured, forward_dynamics_derivatives, |q, qd, tau| $arm
            .forward_dynamics_derivatives(&q, &qd, &tau)
            .expect("M is positive definite"));
        other!($measured, regressor, |q, qd, qdd| $arm
            .regressor(&q, &qd, &qdd));
    };
}
use others;

/// The numbers of a vector, exactly.
fn exact<const N: usize>(x: &SVector<f64, N>) -> SVector<DoubleDouble, N> {
    x.map(DoubleDouble::from)
}

/// One function, timed in double precision and evaluated again with 31 digits.
macro_rules! other {
    ($measured:ident, $function:ident, |$q:pat_param, $qd:pat_param, $last:pat_param| $value:expr) => {{
        let name = stringify!($function);
        let value = |$q: &SVector<f64, _>, $qd: &SVector<f64, _>, $last: &SVector<f64, _>| $value;
        let errors = $measured.states.iter().map(|s| {
            let accurate = {
                let ($q, $qd, $last) = (exact(&s.q), exact(&s.qd), exact(&s.qdd));
                $value
            };
            rounding_error(&value(&s.q, &s.qd, &s.qdd), &accurate)
        });
        $measured.error(name, errors.collect());
        $measured.time(name, GENERATED, |s| value(&s.q, &s.qd, &s.qdd));
    }};
}
use other;

struct Measured<'a, A, const N: usize> {
    arm: &'a mut A,
    file: &'static str,
    states: Vec<State<N>>,
}

impl<A: Candidate<N>, const N: usize> Measured<'_, A, N> {
    fn rival<C: Candidate<N>>(&mut self, candidate: &mut C) {
        self.assert_agreement(candidate);
        let errors = errors(self.file, candidate);
        for (function, errors) in NAMES.iter().zip(&errors) {
            let (largest, rms) = (errors.largest, errors.rms());
            println!(
                "error {} {function} {} {largest:e} {rms:e}",
                self.file,
                C::NAME
            );
        }
        let c = candidate;
        self.time(NAMES[0], C::NAME, |s| {
            c.inverse_dynamics(&s.q, &s.qd, &s.qdd)
        });
        self.time(NAMES[1], C::NAME, |s| c.mass_matrix(&s.q));
        self.time(NAMES[2], C::NAME, |s| c.coriolis_vector(&s.q, &s.qd));
        self.time(NAMES[3], C::NAME, |s| c.gravity_vector(&s.q));
        self.time(NAMES[4], C::NAME, |s| {
            c.forward_dynamics(&s.q, &s.qd, &s.qdd)
        });
    }

    /// The batches, by columns: errors as for every candidate, times for one state of a batch.
    fn batches(&mut self, lanes: &mut Lanes<A>)
    where
        A: Five<N>,
    {
        self.assert_agreement(lanes);
        let mut columns = Columns::new(&five::states::<f64, N>(STATES));
        for (k, errors) in errors(self.file, lanes).iter().enumerate() {
            let (file, function) = (self.file, format!("{}_batch", NAMES[k]));
            let (largest, rms) = (errors.largest, errors.rms());
            println!("error {file} {function} {GENERATED} {largest:e} {rms:e}");
            let time =
                Effort::FULL.nanoseconds(&[()], |()| columns.evaluate(k, &lanes.0)) / STATES as f64;
            println!("time {file} {function} {GENERATED} {time:.2}");
        }
    }

    /// The errors of a function that only the generated code has, at all states.
    fn error(&self, function: &str, errors: Vec<f64>) {
        let largest = errors
            .iter()
            .fold(0.0, |x: f64, e| if *e <= x { x } else { *e });
        let squares: f64 = errors.iter().map(|e| e * e).sum();
        let rms = (squares / errors.len() as f64).sqrt();
        println!(
            "error {} {function} {GENERATED} {largest:e} {rms:e}",
            self.file
        );
    }

    fn time<R>(&self, function: &str, candidate: &str, value: impl FnMut(&State<N>) -> R) {
        let time = Effort::FULL.nanoseconds(&self.states, value);
        println!("time {} {function} {candidate} {time:.2}", self.file);
    }

    /// The candidate's values are those of the generated functions.
    fn assert_agreement<C: Candidate<N>>(&mut self, candidate: &mut C) {
        for state in &self.states {
            let tau = self.arm.inverse_dynamics(&state.q, &state.qd, &state.qdd);
            let (ours, theirs) = (self.arm.values(state, &tau), candidate.values(state, &tau));
            for (function, difference) in NAMES.iter().zip(differences(&ours, &theirs)) {
                let (file, name) = (self.file, C::NAME);
                let agree = difference < AGREEMENT;
                assert!(
                    agree,
                    "{file}, {function}, {name}: {difference:e} at {state:?}"
                );
            }
        }
    }
}

fn differences<const N: usize>(ours: &Values<N>, theirs: &Values<N>) -> [f64; 5] {
    let vector = |a: &SVector<f64, N>, b: &SVector<f64, N>| relative(a, b);
    [
        vector(&ours.inverse_dynamics, &theirs.inverse_dynamics),
        relative(&ours.mass_matrix, &theirs.mass_matrix),
        vector(&ours.coriolis_vector, &theirs.coriolis_vector),
        vector(&ours.gravity_vector, &theirs.gravity_vector),
        vector(&ours.forward_dynamics, &theirs.forward_dynamics),
    ]
}

fn relative<const R: usize, const C: usize>(
    ours: &SMatrix<f64, R, C>,
    theirs: &SMatrix<f64, R, C>,
) -> f64 {
    let error = ours - theirs;
    // Not amax, which leaves a NaN out.
    let largest = error.iter().fold(0.0, |largest: f64, x| {
        if x.is_nan() {
            f64::INFINITY
        } else {
            largest.max(x.abs())
        }
    });
    if largest == 0.0 {
        0.0
    } else {
        largest / ours.amax()
    }
}
