//! Time of the generated functions beside the numeric algorithms of the runtime for the same work, a table for each arm.
//! `benches/rivals` has other crates, errors, and the report of them all.
//!
//! `taskset -c 0 cargo bench -p benches --bench functions`. For the machine's own instructions set
//! `RUSTFLAGS="-C target-cpu=native"`.

use measuring::Effort;
use measuring::table::{Table, nanoseconds};
use robot_dynamics::NewtonEuler;
use robot_dynamics::nalgebra::Vector6;
use robots::{Arguments, Elbow3r, Panda, Puma560, Stanford, TwoLinkSaha, Ur5, each_function};
use testkit::five::{Numbers, states};

/// Median time of a function, ns a state, over all states in turn; its other arguments are those of another state.
fn time<R, const N: usize>(
    states: &[Numbers<f64, N>],
    function: impl Fn(Arguments<f64, N>) -> R,
) -> String {
    let wrench = Vector6::new(5.0, -3.0, 8.0, 2.0, -1.0, 0.5);
    let places: Vec<usize> = (0..states.len()).collect();
    let time = Effort::FULL.nanoseconds(&places, |&i| {
        let ([q, qd, qdd], [_, qd_r, qdd_r]) = (&states[i], &states[states.len() - 1 - i]);
        function(Arguments {
            q,
            qd,
            qdd,
            tau: qdd,
            qd_r,
            qdd_r,
            jerk: qd,
            snap: qdd,
            wrench: &wrench,
            order: 10,
        })
    });
    nanoseconds(time)
}

/// A row for every function.
macro_rules! functions {
    ({ $table:ident $states:ident $arm:ident } $($name:ident [$($argument:ident),*])*) => {$(
        let cell = time(&$states, |at| {
            // Not every function has arguments.
            let _ = &at;
            $arm.$name::<f64>($(at.$argument),*)
        });
        $table.row([stringify!($name).to_owned(), cell]);
    )*};
}

macro_rules! arms {
    ($($file:ident: $arm:ident, $n:literal;)*) => {$({
        let states = states::<f64, $n>(64);
        let mut table = Table::new(stringify!($file), &["function", "ns"]);
        each_function! { functions { table states $arm } }
        let numeric = NewtonEuler::new(&$arm.table());
        let mut row = |name: &str, time| table.row([format!("numeric {name}"), time]);
        row("inverse_dynamics", time(&states, |at| numeric.inverse_dynamics(at.q, at.qd, at.qdd)));
        row("mass_matrix", time(&states, |at| numeric.mass_matrix(at.q)));
        row("coriolis_vector", time(&states, |at| numeric.coriolis_vector(at.q, at.qd)));
        row("gravity_vector", time(&states, |at| numeric.gravity_vector(at.q)));
        row("forward_dynamics", time(&states, |at| numeric.forward_dynamics(at.q, at.qd, at.tau)));
        println!("{}", table.text());
    })*};
}

fn main() {
    measured_arms::for_each_arm!(arms);
}
