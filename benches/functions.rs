//! Time of the generated functions beside the numeric algorithms of the runtime for the same work.
//! `benches/rivals` has other crates, errors, and the report of them all.
//!
//! Each run evaluates a function at 64 states; divan's item rate is states per second:
//! `taskset -c 0 cargo bench -p benches --bench functions`. For the machine's own instructions set
//! `RUSTFLAGS="-C target-cpu=native"`.

use divan::{Bencher, black_box, counter::ItemsCount};
use robot_dynamics::NewtonEuler;
use robot_dynamics::nalgebra::{SVector, Vector6};
use robots::{Arguments, Elbow3r, Panda, Puma560, Stanford, TwoLinkSaha, Ur5, each_function};

const STATES: usize = 64;

/// States spread over the joints' circles.
fn states<const N: usize>(phase: f64) -> [SVector<f64, N>; STATES] {
    std::array::from_fn(|state| {
        SVector::from_fn(|joint, _| (phase + 1.7 * state as f64 + 2.3 * joint as f64).sin() * 3.0)
    })
}

/// A benchmark of every function.
macro_rules! bench_functions {
    ({ $robot:ident } $($name:ident [$($argument:ident),*])*) => {$(
        #[divan::bench]
        fn $name(bencher: Bencher) {
            each(bencher, |at| {
                // Not every function has arguments.
                let _ = &at;
                $robot.$name::<f64>($(at.$argument),*)
            });
        }
    )*};
}

macro_rules! bench_robots {
    ($($module:ident: $robot:ident, $n:literal;)*) => {$(
        mod $module {
            use super::*;

            fn each<R>(bencher: Bencher, function: impl Fn(Arguments<f64, $n>) -> R) {
                let (q, qd, qdd) = (states::<$n>(0.1), states::<$n>(0.7), states::<$n>(1.9));
                let wrench = Vector6::new(5.0, -3.0, 8.0, 2.0, -1.0, 0.5);
                bencher.counter(ItemsCount::new(STATES)).bench_local(|| {
                    for i in 0..STATES {
                        let at = Arguments {
                            q: &q[i],
                            qd: &qd[i],
                            qdd: &qdd[i],
                            tau: &qdd[i],
                            qd_r: &qd[STATES - 1 - i],
                            qdd_r: &qdd[STATES - 1 - i],
                            jerk: &qd[i],
                            snap: &qdd[i],
                            wrench: &wrench,
                            order: 10,
                        };
                        black_box(&function(black_box(at)));
                    }
                });
            }

            each_function! { bench_functions { $robot } }

            #[divan::bench]
            fn numeric_inverse_dynamics(bencher: Bencher) {
                let numeric = NewtonEuler::new(&$robot.table());
                each(bencher, |at| numeric.inverse_dynamics(at.q, at.qd, at.qdd));
            }

            #[divan::bench]
            fn numeric_mass_matrix(bencher: Bencher) {
                let numeric = NewtonEuler::new(&$robot.table());
                each(bencher, |at| numeric.mass_matrix(at.q));
            }

            #[divan::bench]
            fn numeric_coriolis_vector(bencher: Bencher) {
                let numeric = NewtonEuler::new(&$robot.table());
                each(bencher, |at| numeric.coriolis_vector(at.q, at.qd));
            }

            #[divan::bench]
            fn numeric_gravity_vector(bencher: Bencher) {
                let numeric = NewtonEuler::new(&$robot.table());
                each(bencher, |at| numeric.gravity_vector(at.q));
            }

            #[divan::bench]
            fn numeric_forward_dynamics(bencher: Bencher) {
                let numeric = NewtonEuler::new(&$robot.table());
                each(bencher, |at| numeric.forward_dynamics(at.q, at.qd, at.tau));
            }
        }
    )*};
}

measured_arms::for_each_arm!(bench_robots);

fn main() {
    divan::main();
}
