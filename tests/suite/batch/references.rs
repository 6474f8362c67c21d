//! Batches against 25 digits: the states of `tests/data/reference`, angles of 1e6 rad among them.

use robot_dynamics::nalgebra::SVector;
use robots::{Puma560, Scara};
use serde::Deserialize;
use testkit::references::{Decimal, read};

use super::values::{Arm, States, Values};

/// The largest error, relative to the natural magnitude, in units of the number of joints: that of
/// the single functions.
const BOUND: f64 = 4e-15;

#[derive(Deserialize)]
struct File {
    states: Vec<State>,
}

#[derive(Deserialize)]
#[allow(non_snake_case, reason = "the names in the files")]
struct State {
    q: Vec<f64>,
    qd: Vec<f64>,
    qdd: Vec<f64>,
    M: Vec<Vec<Decimal>>,
    V: Vec<Decimal>,
    G: Vec<Decimal>,
    tau: Vec<Decimal>,
    friction: Vec<Decimal>,
    scale: Scale,
}

#[derive(Deserialize)]
#[allow(non_snake_case, reason = "the names in the files")]
struct Scale {
    M: f64,
    V: f64,
    G: f64,
    tau: f64,
}

/// The largest error of a number over the scale.
fn error(found: &[f64], exact: &[Decimal], scale: f64) -> f64 {
    assert_eq!(found.len(), exact.len());
    let errors = found
        .iter()
        .zip(exact)
        .map(|(x, exact)| exact.error_of(*x).abs());
    errors.fold(0.0, |worst, error| match error {
        0.0 => worst,
        _ if error.is_nan() => f64::INFINITY,
        _ => worst.max(error / scale),
    })
}

/// The largest errors of M, V, G and tau of the batch and of single calls.
fn errors<const N: usize>(values: &Values<N>, file: &File) -> [f64; 4] {
    let mut worst = [0.0_f64; 4];
    for (i, state) in file.states.iter().enumerate() {
        // Symmetric: by rows or by columns is the same.
        let exact = [state.M.concat(), state.V.clone(), state.G.clone()];
        let applied = state.tau.iter().zip(&state.friction);
        let tau: Vec<Decimal> = applied.map(|(tau, friction)| *tau + *friction).collect();
        let [m, v, g] = exact;
        let errors = [
            error(values.mass_matrix[i].as_slice(), &m, state.scale.M),
            error(values.coriolis_vector[i].as_slice(), &v, state.scale.V),
            error(values.gravity_vector[i].as_slice(), &g, state.scale.G),
            error(values.inverse_dynamics[i].as_slice(), &tau, state.scale.tau),
        ];
        worst = std::array::from_fn(|k| worst[k].max(errors[k]));
    }
    worst
}

fn against_references<const N: usize>(name: &str, arm: &impl Arm<N>) {
    let file: File = read("reference", name);
    let column = |numbers: fn(&State) -> &[f64]| {
        let states = file.states.iter();
        states
            .map(|state| SVector::from_row_slice(numbers(state)))
            .collect()
    };
    let states = States {
        q: column(|state| &state.q),
        qd: column(|state| &state.qd),
        x: column(|state| &state.qdd),
    };
    let batch = errors(&Values::by_rows(arm, &states), &file);
    let single = errors(&Values::single(arm, &states), &file);
    let text = |errors: [f64; 4]| errors.map(|error| format!("{error:.1e}")).join(" ");
    println!(
        "{name:10} M V G tau: {}; single calls {}",
        text(batch),
        text(single)
    );
    let bound = BOUND * N as f64;
    assert!(
        batch.iter().all(|error| *error <= bound),
        "{name}: {}",
        text(batch)
    );
}

#[test]
fn batches_are_as_exact_as_single_calls() {
    against_references("puma560", &Puma560);
    against_references("scara", &Scara);
}
