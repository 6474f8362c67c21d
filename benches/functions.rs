//! Time of the generated functions beside the numeric algorithms of the runtime for the same work.
//! `benches/rivals` has other crates, errors, and the report of them all.
//!
//! Each run evaluates a function at 64 states; divan's item rate is states per second:
//! `taskset -c 0 cargo bench -p benches --bench functions`. For the machine's own instructions set
//! `RUSTFLAGS="-C target-cpu=native"`.

use divan::{Bencher, black_box, counter::ItemsCount};
use robot_dynamics::NewtonEuler;
use robot_dynamics::nalgebra::SVector;

use robots::{Elbow3r, Panda, Puma560, Stanford, TwoLinkSaha, Ur5};

const STATES: usize = 64;

/// States spread over the joints' circles.
fn states<const N: usize>(phase: f64) -> [SVector<f64, N>; STATES] {
    std::array::from_fn(|state| {
        SVector::from_fn(|joint, _| (phase + 1.7 * state as f64 + 2.3 * joint as f64).sin() * 3.0)
    })
}

macro_rules! bench_robots {
    ($($module:ident: $robot:ident, $n:literal;)*) => {$(
        mod $module {
            use super::*;

            fn each<R>(bencher: Bencher, function: impl Fn(&SVector<f64, $n>, &SVector<f64, $n>, &SVector<f64, $n>) -> R) {
                let (q, qd, qdd) = (states::<$n>(0.1), states::<$n>(0.7), states::<$n>(1.9));
                bencher.counter(ItemsCount::new(STATES)).bench_local(|| {
                    for i in 0..STATES {
                        black_box(function(black_box(&q[i]), black_box(&qd[i]), black_box(&qdd[i])));
                    }
                });
            }

            #[divan::bench]
            fn mass_matrix(bencher: Bencher) {
                each(bencher, |q, _, _| $robot.mass_matrix(q));
            }

            #[divan::bench]
            fn coriolis_vector(bencher: Bencher) {
                each(bencher, |q, qd, _| $robot.coriolis_vector(q, qd));
            }

            #[divan::bench]
            fn gravity_vector(bencher: Bencher) {
                each(bencher, |q, _, _| $robot.gravity_vector(q));
            }

            #[divan::bench]
            fn inverse_dynamics(bencher: Bencher) {
                each(bencher, |q, qd, qdd| $robot.inverse_dynamics(q, qd, qdd));
            }

            #[divan::bench]
            fn forward_dynamics(bencher: Bencher) {
                each(bencher, |q, qd, tau| $robot.forward_dynamics(q, qd, tau));
            }

            #[divan::bench]
            fn inverse_dynamics_derivatives(bencher: Bencher) {
                each(bencher, |q, qd, qdd| $robot.inverse_dynamics_derivatives(q, qd, qdd));
            }

            #[divan::bench]
            fn forward_dynamics_derivatives(bencher: Bencher) {
                each(bencher, |q, qd, tau| $robot.forward_dynamics_derivatives(q, qd, tau));
            }

            #[divan::bench]
            fn numeric_inverse_dynamics(bencher: Bencher) {
                let numeric = NewtonEuler::new(&$robot.table());
                each(bencher, |q, qd, qdd| numeric.inverse_dynamics(q, qd, qdd));
            }

            #[divan::bench]
            fn numeric_mass_matrix(bencher: Bencher) {
                let numeric = NewtonEuler::new(&$robot.table());
                each(bencher, |q, _, _| numeric.mass_matrix(q));
            }

            #[divan::bench]
            fn numeric_coriolis_vector(bencher: Bencher) {
                let numeric = NewtonEuler::new(&$robot.table());
                each(bencher, |q, qd, _| numeric.coriolis_vector(q, qd));
            }

            #[divan::bench]
            fn numeric_gravity_vector(bencher: Bencher) {
                let numeric = NewtonEuler::new(&$robot.table());
                each(bencher, |q, _, _| numeric.gravity_vector(q));
            }

            #[divan::bench]
            fn numeric_forward_dynamics(bencher: Bencher) {
                let numeric = NewtonEuler::new(&$robot.table());
                each(bencher, |q, qd, tau| numeric.forward_dynamics(q, qd, tau));
            }
        }
    )*};
}

bench_robots! {
    two_link_saha: TwoLinkSaha, 2;
    elbow_3r: Elbow3r, 3;
    stanford: Stanford, 6;
    puma560: Puma560, 6;
    ur5: Ur5, 6;
    panda: Panda, 7;
}

fn main() {
    divan::main();
}
