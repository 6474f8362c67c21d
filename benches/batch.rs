//! Time of a state in batches beside single calls in a loop, a table for each arm.
//!
//! `taskset -c 0 cargo bench -p benches --bench batch`. The lanes are chosen at run time; for a build for the machine's
//! own instructions set `RUSTFLAGS="-C target-cpu=native"`.

use measuring::Effort;
use measuring::table::{Table, nanoseconds};
use robot_dynamics::Batch;
use robot_dynamics::nalgebra::{SMatrix, SVector};
use robots::{Panda, Puma560, Ur5};
use testkit::columns::Columns;
use testkit::five::{Five, NAMES, Numbers, calls, states};

/// One group's memory fits into the first cache, the other's into the second.
const STATES: [usize; 2] = [64, 4096];

/// A vector for each state, in and out.
struct Rows<const N: usize> {
    arguments: [Vec<SVector<f64, N>>; 3],
    vectors: Vec<SVector<f64, N>>,
    matrices: Vec<SMatrix<f64, N, N>>,
}

impl<const N: usize> Rows<N> {
    fn new(states: &[Numbers<f64, N>]) -> Self {
        let arguments = [0, 1, 2].map(|k| states.iter().map(|state| state[k]).collect());
        Rows {
            arguments,
            vectors: vec![SVector::zeros(); states.len()],
            matrices: vec![SMatrix::zeros(); states.len()],
        }
    }

    /// Evaluates the function of that place in [`NAMES`] at all states.
    fn evaluate(&mut self, function: usize, arm: &impl Five<N>) {
        let ([q, qd, last], vectors) = (&self.arguments, &mut self.vectors);
        let written = match function {
            0 => arm.inverse_dynamics_batch(q, qd, last, vectors),
            1 => arm.mass_matrix_batch(q, &mut self.matrices),
            2 => arm.coriolis_vector_batch(q, qd, vectors),
            3 => arm.gravity_vector_batch(q, vectors),
            _ => {
                let written = arm.forward_dynamics_batch(q, qd, last, vectors);
                written.expect("M is positive definite");
                Ok(())
            }
        };
        written.expect("vectors of one length");
    }
}

fn table<const N: usize>(name: &str, arm: &impl Five<N>) -> Table {
    let heads = ["function", "states", "one by one", "rows", "columns"];
    let mut table = Table::new(format!("{name}, ns a state"), &heads);
    for (function, name) in NAMES.iter().enumerate() {
        for count in STATES {
            let states = states::<f64, N>(count);
            let (mut rows, mut columns) = (Rows::new(&states), Columns::new(&states));
            let times = Effort::FULL.in_turns([
                &mut || calls(arm, function, &states),
                &mut || rows.evaluate(function, arm),
                &mut || columns.evaluate(function, arm),
            ]);
            let times = times.map(|time| nanoseconds(time / count as f64));
            let names = [(*name).to_owned(), count.to_string()];
            table.row(names.into_iter().chain(times));
        }
    }
    table
}

fn main() {
    println!("{}", table("puma560", &Puma560).text());
    println!("{}", table("ur5", &Ur5).text());
    println!("{}", table("panda", &Panda).text());
}
