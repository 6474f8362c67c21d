//! Time per state of the batches beside single calls in a loop.
//!
//! divan's item rate is states per second: `taskset -c 0 cargo bench -p benches --bench batch`. The lanes are
//! chosen at run time; for a build for the machine's own instructions set
//! `RUSTFLAGS="-C target-cpu=native"`. With `--features rayon`, and not pinned, all cores are there
//! too.

use divan::{Bencher, black_box, counter::ItemsCount};
use robot_dynamics::Batch;
use robot_dynamics::nalgebra::{SMatrix, SVector};
use robots::{Panda, Puma560, Ur5};

/// One group's memory fits into the first cache, the other's into the second.
const STATES: [usize; 2] = [64, 4096];

/// States spread over the joints' circles.
fn states<const N: usize>(count: usize, phase: f64) -> Vec<SVector<f64, N>> {
    let number = |state, joint| (phase + 1.7 * state as f64 + 2.3 * joint as f64).sin() * 3.0;
    let state = |state| SVector::from_fn(|joint, _| number(state, joint));
    (0..count).map(state).collect()
}

/// A column for each joint.
fn columns<const N: usize>(states: &[SVector<f64, N>]) -> [Vec<f64>; N] {
    std::array::from_fn(|joint| states.iter().map(|state| state[joint]).collect())
}

fn views<const N: usize>(columns: &[Vec<f64>; N]) -> [&[f64]; N] {
    columns.each_ref().map(|column| &column[..])
}

fn views_mut<const N: usize>(columns: &mut [Vec<f64>; N]) -> [&mut [f64]; N] {
    columns.each_mut().map(|column| &mut column[..])
}

macro_rules! bench_robots {
    ($($module:ident: $robot:ident, $n:literal;)*) => {$(
        mod $module {
            use super::*;

            type Vector = SVector<f64, $n>;
            type Square = SMatrix<f64, $n, $n>;

            /// A vector for each state, in and out.
            mod rows {
                use super::*;

                fn arguments(count: usize) -> [Vec<Vector>; 4] {
                    let zeros = vec![Vector::zeros(); count];
                    [states(count, 0.1), states(count, 0.7), states(count, 1.9), zeros]
                }

                #[divan::bench(args = STATES)]
                fn inverse_dynamics(bencher: Bencher, count: usize) {
                    let [q, qd, qdd, mut tau] = arguments(count);
                    bencher.counter(ItemsCount::new(count)).bench_local(|| {
                        $robot.inverse_dynamics_batch(black_box(&q), &qd, &qdd, black_box(&mut tau))
                    });
                }

                #[divan::bench(args = STATES)]
                fn forward_dynamics(bencher: Bencher, count: usize) {
                    let [q, qd, tau, mut qdd] = arguments(count);
                    bencher.counter(ItemsCount::new(count)).bench_local(|| {
                        $robot.forward_dynamics_batch(black_box(&q), &qd, &tau, black_box(&mut qdd))
                    });
                }

                #[divan::bench(args = STATES)]
                fn coriolis_vector(bencher: Bencher, count: usize) {
                    let [q, qd, _, mut v] = arguments(count);
                    bencher.counter(ItemsCount::new(count)).bench_local(|| {
                        $robot.coriolis_vector_batch(black_box(&q), &qd, black_box(&mut v))
                    });
                }

                #[divan::bench(args = STATES)]
                fn gravity_vector(bencher: Bencher, count: usize) {
                    let [q, _, _, mut g] = arguments(count);
                    bencher.counter(ItemsCount::new(count)).bench_local(|| {
                        $robot.gravity_vector_batch(black_box(&q), black_box(&mut g))
                    });
                }

                #[divan::bench(args = STATES)]
                fn mass_matrix(bencher: Bencher, count: usize) {
                    let [q, ..] = arguments(count);
                    let mut m = vec![Square::zeros(); count];
                    bencher.counter(ItemsCount::new(count)).bench_local(|| {
                        $robot.mass_matrix_batch(black_box(&q), black_box(&mut m))
                    });
                }
            }

            /// A column for each joint, in and out.
            mod columns {
                use super::*;

                fn arguments(count: usize) -> [[Vec<f64>; $n]; 4] {
                    let zeros = vec![Vector::zeros(); count];
                    [states(count, 0.1), states(count, 0.7), states(count, 1.9), zeros]
                        .map(|states| columns(&states))
                }

                #[divan::bench(args = STATES)]
                fn inverse_dynamics(bencher: Bencher, count: usize) {
                    let [q, qd, qdd, mut tau] = arguments(count);
                    bencher.counter(ItemsCount::new(count)).bench_local(|| {
                        let tau = views_mut(black_box(&mut tau));
                        $robot.inverse_dynamics_batch(views(black_box(&q)), views(&qd), views(&qdd), tau)
                    });
                }

                #[divan::bench(args = STATES)]
                fn forward_dynamics(bencher: Bencher, count: usize) {
                    let [q, qd, tau, mut qdd] = arguments(count);
                    bencher.counter(ItemsCount::new(count)).bench_local(|| {
                        let qdd = views_mut(black_box(&mut qdd));
                        $robot.forward_dynamics_batch(views(black_box(&q)), views(&qd), views(&tau), qdd)
                    });
                }

                #[divan::bench(args = STATES)]
                fn coriolis_vector(bencher: Bencher, count: usize) {
                    let [q, qd, _, mut v] = arguments(count);
                    bencher.counter(ItemsCount::new(count)).bench_local(|| {
                        let v = views_mut(black_box(&mut v));
                        $robot.coriolis_vector_batch(views(black_box(&q)), views(&qd), v)
                    });
                }

                #[divan::bench(args = STATES)]
                fn gravity_vector(bencher: Bencher, count: usize) {
                    let [q, _, _, mut g] = arguments(count);
                    bencher.counter(ItemsCount::new(count)).bench_local(|| {
                        $robot.gravity_vector_batch(views(black_box(&q)), views_mut(black_box(&mut g)))
                    });
                }

                #[divan::bench(args = STATES)]
                fn mass_matrix(bencher: Bencher, count: usize) {
                    let [q, ..] = arguments(count);
                    let mut m: [[Vec<f64>; $n]; $n] =
                        std::array::from_fn(|_| std::array::from_fn(|_| vec![0.0; count]));
                    bencher.counter(ItemsCount::new(count)).bench_local(|| {
                        let m = black_box(&mut m).each_mut().map(views_mut);
                        $robot.mass_matrix_batch(views(black_box(&q)), m)
                    });
                }
            }

            /// All cores.
            #[cfg(feature = "rayon")]
            mod cores {
                use super::*;

                #[divan::bench(args = [1024, 4096, 65_536])]
                fn inverse_dynamics(bencher: Bencher, count: usize) {
                    let (q, qd, qdd) = (states(count, 0.1), states(count, 0.7), states(count, 1.9));
                    let mut tau = vec![Vector::zeros(); count];
                    bencher.counter(ItemsCount::new(count)).bench_local(|| {
                        $robot.par_inverse_dynamics_batch(black_box(&q), &qd, &qdd, black_box(&mut tau))
                    });
                }
            }

            /// Single calls.
            mod single {
                use super::*;

                fn each<R>(
                    bencher: Bencher,
                    count: usize,
                    zero: R,
                    function: impl Fn(&Vector, &Vector, &Vector) -> R,
                ) where
                    R: Clone,
                {
                    let (q, qd, qdd) = (states(count, 0.1), states(count, 0.7), states(count, 1.9));
                    let mut values = vec![zero; count];
                    bencher.counter(ItemsCount::new(count)).bench_local(|| {
                        for (i, value) in black_box(&mut values).iter_mut().enumerate() {
                            *value = function(&q[i], &qd[i], &qdd[i]);
                        }
                    });
                }

                #[divan::bench(args = STATES)]
                fn inverse_dynamics(bencher: Bencher, count: usize) {
                    each(bencher, count, Vector::zeros(), |q, qd, qdd| $robot.inverse_dynamics(q, qd, qdd));
                }

                #[divan::bench(args = STATES)]
                fn forward_dynamics(bencher: Bencher, count: usize) {
                    each(bencher, count, Ok(Vector::zeros()), |q, qd, tau| $robot.forward_dynamics(q, qd, tau));
                }

                #[divan::bench(args = STATES)]
                fn coriolis_vector(bencher: Bencher, count: usize) {
                    each(bencher, count, Vector::zeros(), |q, qd, _| $robot.coriolis_vector(q, qd));
                }

                #[divan::bench(args = STATES)]
                fn gravity_vector(bencher: Bencher, count: usize) {
                    each(bencher, count, Vector::zeros(), |q, _, _| $robot.gravity_vector(q));
                }

                #[divan::bench(args = STATES)]
                fn mass_matrix(bencher: Bencher, count: usize) {
                    each(bencher, count, Square::zeros(), |q, _, _| $robot.mass_matrix(q));
                }
            }
        }
    )*};
}

bench_robots! {
    puma560: Puma560, 6;
    ur5: Ur5, 6;
    panda: Panda, 7;
}

fn main() {
    divan::main();
}
