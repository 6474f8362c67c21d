//! Robots with branches: the time of a state, one by one and in batches, as lines for `benches/trees.sh`.
//!
//! `cargo bench -p benches --bench trees` prints lines `time TREE FUNCTION CANDIDATE NS` and `error TREE FUNCTION
//! CANDIDATE LARGEST`, errors relative to the largest entry of a value. With `-- states` it prints the states and their
//! values in 31 digits, rounded, by which another program is compared.

use measuring::Effort;
use robot_dynamics::{DoubleDouble, robot_dynamics};
use testkit::columns::Columns;
use testkit::five::{Five, NAMES, calls, largest_error, states, values};

robot_dynamics! {
    /// Four legs on a trunk that stands still.
    struct Hyq;
    file: "../tests/data/urdf/trees/hyq_no_sensors.urdf",
    gravity: [0, 0, -9.81],
    allow: [unphysical_inertia],
}

robot_dynamics! {
    /// The same of another make.
    struct Anymal;
    file: "../tests/data/urdf/trees/anymal_erd.urdf",
    gravity: [0, 0, -9.81],
    allow: [unphysical_inertia],
}

robot_dynamics! {
    /// An arm with two fingers.
    struct PandaFree;
    file: "../tests/data/urdf/trees/panda_free.urdf",
    gravity: [0, 0, -9.81],
}

const STATES: usize = 64;
/// Inverse dynamics, the mass matrix, forward dynamics.
const MEASURED: [usize; 3] = [0, 1, 4];

fn print_lines<A: Five<N>, const N: usize>(name: &str, arm: &A) {
    let doubles = states::<f64, N>(STATES);
    let mut columns = Columns::new(&doubles);
    for function in MEASURED {
        let exact = values(arm, function, &states::<DoubleDouble, N>(STATES));
        let batch = |columns: &mut Columns<f64, N>| {
            columns.evaluate(function, arm);
            columns.values(function)
        };
        let all = |columns: &mut Columns<f64, N>| columns.evaluate(function, arm);
        let found = [values(arm, function, &doubles), batch(&mut columns)];
        let times = Effort::FULL.in_turns([&mut || calls(arm, function, &doubles), &mut || {
            all(&mut columns)
        }]);
        for (candidate, k) in [("generated", 0), ("generated,batch", 1)] {
            let (function, error) = (NAMES[function], largest_error(&found[k], &exact));
            println!("error {name} {function} {candidate} {error:e}");
            println!(
                "time {name} {function} {candidate} {:.2}",
                times[k] / STATES as f64
            );
        }
    }
}

/// A line `TREE N`, then for each state its numbers, tau, M and qdd.
fn print_states<A: Five<N>, const N: usize>(name: &str, arm: &A) {
    println!("{name} {N}");
    let exact = states::<DoubleDouble, N>(STATES);
    let values = MEASURED.map(|function| values(arm, function, &exact));
    for (k, state) in states::<f64, N>(STATES).iter().enumerate() {
        let numbers = state.iter().flatten().copied();
        let all = numbers.chain(values.iter().flat_map(|of| of[k].iter().copied()));
        let words: Vec<_> = all.map(|x| format!("{x:e}")).collect();
        println!("{}", words.join(" "));
    }
}

fn main() {
    if std::env::args().any(|argument| argument == "states") {
        print_states("hyq_no_sensors", &Hyq);
        print_states("anymal_erd", &Anymal);
        print_states("panda_free", &PandaFree);
    } else {
        print_lines("hyq_no_sensors", &Hyq);
        print_lines("anymal_erd", &Anymal);
        print_lines("panda_free", &PandaFree);
    }
}
