//! Times and errors, a line each: `time ARM FUNCTION CANDIDATE NS`, `error ARM FUNCTION CANDIDATE LARGEST RMS`,
//! and `ratio ARM FUNCTION CANDIDATE X`.

use measuring::Effort;
use robot_dynamics::nalgebra::{SMatrix, SVector};
use robot_dynamics::{Batch, DoubleDouble};

use measured_arms::*;
use testkit::columns::{Columns, zeros};
use testkit::five::{Five, NAMES, Numbers, calls, states, values};

/// The states at which a function is evaluated in turn, and those of a batch: all fit into the first cache.
pub(crate) const STATES: usize = 64;

/// The states of a batch of derivatives.
const MANY: usize = 1024;

/// The measurements on one core.
pub(crate) fn on_one_core() {
    macro_rules! measure {
        ($($file:ident: $arm:ident, $n:literal;)*) => {$(
            precisions::<_, $n>(stringify!($file), &$arm);
        )*};
    }
    for_each_arm!(measure);
    derivatives();
}

/// The five functions, one state at a time and in batches, in `f64` and in `f32`, in turns.
fn precisions<A: Five<N>, const N: usize>(file: &str, arm: &A) {
    let (doubles, singles) = (states::<f64, N>(STATES), states::<f32, N>(STATES));
    let mut columns = (Columns::new(&doubles), Columns::new(&singles));
    for (k, function) in NAMES.iter().enumerate() {
        let times = Effort::FULL.in_turns([
            &mut || calls(arm, k, &doubles),
            &mut || calls(arm, k, &singles),
            &mut || columns.0.evaluate(k, arm),
            &mut || columns.1.evaluate(k, arm),
        ]);
        let names = ["", "_f32", "_batch", "_batch_f32"];
        for (name, time) in names.iter().zip(times) {
            let time = time / STATES as f64;
            println!("time {file} {function}{name} generated {time:.3}");
        }
        let [single, batch] = [times[1] / times[0], times[3] / times[2]];
        println!("ratio {file} {function}_f32 generated {single:.4}");
        println!("ratio {file} {function}_batch_f32 generated {batch:.4}");
        let exact = values(arm, k, &states::<DoubleDouble, N>(STATES));
        let found = [
            values(arm, k, &doubles),
            values(arm, k, &singles),
            columns.0.values(k),
            columns.1.values(k),
        ];
        for (name, found) in names.iter().zip(found) {
            let [largest, rms] = errors(arm, k, &doubles, &found, &exact);
            println!("error {file} {function}{name} generated {largest:e} {rms:e}");
        }
    }
}

/// The largest error, over the largest value of the function at any of the states, and the root of the mean
/// square. Accelerations are judged by the torques that they need beyond those that were applied, over
/// max |M| max |qdd|.
fn errors<A: Five<N>, const N: usize>(
    arm: &A,
    function: usize,
    states: &[Numbers<f64, N>],
    found: &[Vec<f64>],
    exact: &[Vec<f64>],
) -> [f64; 2] {
    let of_state = |i: usize| -> (Vec<f64>, Vec<f64>) {
        let apart = found[i].iter().zip(&exact[i]).map(|(x, exact)| x - exact);
        if function < 4 {
            return (apart.collect(), exact[i].clone());
        }
        let [q, _, tau] = &states[i];
        let m = arm.mass_matrix(q);
        let needed = m * SVector::<f64, N>::from_iterator(apart);
        let inertial = m.amax() * largest_of(exact[i].iter());
        (needed.iter().copied().collect(), vec![inertial, tau.amax()])
    };
    let (errors, values): (Vec<_>, Vec<_>) = (0..states.len()).map(of_state).unzip();
    let scale = largest_of(values.iter().flatten());
    relative(errors.iter().flatten(), scale)
}

/// The largest magnitude; NaN is the largest of all.
fn largest_of<'a>(numbers: impl Iterator<Item = &'a f64>) -> f64 {
    numbers.fold(
        0.0,
        |largest, x| {
            if x.abs() <= largest { largest } else { x.abs() }
        },
    )
}

/// The largest of the errors, and the root of the mean square, over a scale.
pub(crate) fn relative<'a>(errors: impl Iterator<Item = &'a f64> + Clone, scale: f64) -> [f64; 2] {
    let squares: f64 = errors.clone().map(|e| e * e).sum();
    let count = errors.clone().count() as f64;
    match scale {
        0.0 => [0.0; 2],
        scale => [largest_of(errors), (squares / count).sqrt()].map(|e| e / scale),
    }
}

/// Batches of derivatives, a column for each entry.
fn derivatives() {
    macro_rules! measure {
        ($($file:ident: $arm:ident, $n:literal;)*) => {$(
            let columns = Columns::new(&states::<f64, $n>(MANY));
            let [q, qd, x] = columns.arguments();
            let matrix = || -> [[Vec<f64>; $n]; $n] { std::array::from_fn(|_| zeros(MANY)) };
            let [mut a, mut b, mut c] = [matrix(), matrix(), matrix()];
            let inverse = &mut || {
                let written = $arm.inverse_dynamics_derivatives_batch(q, qd, x, (&mut a, &mut b));
                written.expect("one length");
            };
            let [inverse] = Effort::FULL.in_turns([inverse]);
            let forward = &mut || {
                let values = (&mut a, &mut b, &mut c);
                let written = $arm.forward_dynamics_derivatives_batch(q, qd, x, values);
                written.expect("M is regular");
            };
            let [forward] = Effort::FULL.in_turns([forward]);
            let all = states::<f64, $n>(STATES);
            let [q, qd, x] = [0, 1, 2].map(|k| all.iter().map(|state| state[k]).collect::<Vec<_>>());
            let exact = states::<DoubleDouble, $n>(STATES);
            let zero = SMatrix::<f64, $n, $n>::zeros();
            let mut found = vec![(zero, zero); STATES];
            $arm.inverse_dynamics_derivatives_batch(&q, &qd, &x, &mut found).expect("one length");
            let pairs = found.iter().zip(&exact).flat_map(|((a, b), [q, qd, x])| {
                let (c, d) = $arm.inverse_dynamics_derivatives(q, qd, x);
                [(*a, c), (*b, d)]
            });
            print(stringify!($file), "inverse_dynamics_derivatives_batch", inverse, pairs);
            let mut found = vec![(zero, zero, zero); STATES];
            $arm.forward_dynamics_derivatives_batch(&q, &qd, &x, &mut found).expect("M is regular");
            let pairs = found.iter().zip(&exact).flat_map(|((a, b, c), [q, qd, x])| {
                let exact = $arm.forward_dynamics_derivatives(q, qd, x);
                let (d, e, f) = exact.expect("M is regular");
                [(*a, d), (*b, e), (*c, f)]
            });
            print(stringify!($file), "forward_dynamics_derivatives_batch", forward, pairs);
        )*};
    }
    measure! {
        puma560: Puma560, 6;
        panda: Panda, 7;
    }
}

/// The time of a batch of derivatives, and its errors: matrices and what they are exactly, each relative to its
/// largest entry.
fn print<const N: usize>(
    file: &str,
    function: &str,
    time: f64,
    pairs: impl Iterator<Item = (SMatrix<f64, N, N>, SMatrix<DoubleDouble, N, N>)>,
) {
    let errors: Vec<f64> = pairs
        .flat_map(|(found, exact)| {
            let scale = exact.map(|x| x.high()).amax();
            let apart = found.zip_map(&exact, |x, exact| (exact - DoubleDouble::from(x)).high());
            apart.iter().map(|e| e / scale).collect::<Vec<_>>()
        })
        .collect();
    let [largest, rms] = relative(errors.iter(), 1.0);
    println!("time {file} {function} generated {:.3}", time / MANY as f64);
    println!("error {file} {function} generated {largest:e} {rms:e}");
}

/// How many times as fast all cores are as one: at many states of a cheap function, and at a few hundred of
/// expensive ones.
pub(crate) fn on_all_cores() {
    const N: usize = 7;
    type Vector = SVector<f64, N>;
    type Matrix = SMatrix<f64, N, N>;
    macro_rules! print {
        ($count:literal, $batch:ident, $par_batch:ident, $value:ty) => {{
            let all = states::<f64, N>($count);
            let [q, qd, x] =
                [0, 1, 2].map(|k| all.iter().map(|state| state[k]).collect::<Vec<_>>());
            let [mut one, mut other] = [(); 2].map(|()| vec![<$value>::default(); $count]);
            let [one, all] = Effort::FULL.in_turns([
                &mut || Panda.$batch(&q, &qd, &x, &mut one).expect("M is regular"),
                &mut || {
                    let written = Panda.$par_batch(&q, &qd, &x, &mut other);
                    written.expect("M is regular");
                },
            ]);
            let name = format!("{} of {}", stringify!($par_batch), $count).replace(' ', "_");
            println!("ratio panda {name} generated {:.4}", one / all);
        }};
    }
    print!(
        65536,
        inverse_dynamics_batch, par_inverse_dynamics_batch, Vector
    );
    print!(
        4096,
        forward_dynamics_batch, par_forward_dynamics_batch, Vector
    );
    print!(
        512,
        inverse_dynamics_derivatives_batch,
        par_inverse_dynamics_derivatives_batch,
        (Matrix, Matrix)
    );
    print!(
        256,
        forward_dynamics_derivatives_batch,
        par_forward_dynamics_derivatives_batch,
        (Matrix, Matrix, Matrix)
    );
}
