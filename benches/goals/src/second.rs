//! Second derivatives of the Panda's torques, one call.

use measuring::Effort;
use robot_dynamics::DoubleDouble;
use robot_dynamics::nalgebra::SMatrix;

use testkit::five::{Numbers, states};

use crate::measure::{STATES, relative};

robot_dynamics::robot_dynamics! {
    /// The Panda with this function alone.
    struct Panda;
    file: "../../tests/data/robots/panda.json",
    functions: [inverse_dynamics_second_derivatives],
}

const N: usize = 7;

/// Prints the time of a call, and the errors relative to the largest entry of a derivative at that state.
pub(crate) fn derivatives() {
    let doubles = states::<f64, N>(STATES);
    let call =
        |[q, qd, qdd]: &Numbers<f64, N>| Panda.inverse_dynamics_second_derivatives(q, qd, qdd);
    let time = Effort::FULL.nanoseconds(&doubles, call);
    let exact = states::<DoubleDouble, N>(STATES);
    let of_state = |(state, [q, qd, qdd]): (&Numbers<f64, N>, &Numbers<DoubleDouble, N>)| {
        let (a, b, c, d) = call(state);
        let (e, f, g, h) = Panda.inverse_dynamics_second_derivatives(q, qd, qdd);
        [
            errors(&a, &e),
            errors(&b, &f),
            errors(&c, &g),
            errors(&d, &h),
        ]
        .concat()
    };
    let errors: Vec<f64> = doubles.iter().zip(&exact).flat_map(of_state).collect();
    let [largest, rms] = relative(errors.iter(), 1.0);
    println!("time panda inverse_dynamics_second_derivatives generated {time:.3}");
    println!("error panda inverse_dynamics_second_derivatives generated {largest:e} {rms:e}");
}

type Matrices<T> = [SMatrix<T, N, N>; N];

/// Errors of all entries, over the largest of them.
fn errors(found: &Matrices<f64>, exact: &Matrices<DoubleDouble>) -> Vec<f64> {
    let sizes = exact.iter().map(|matrix| matrix.map(|x| x.high()).amax());
    let scale = sizes.fold(0.0, f64::max);
    let entries = found.iter().flatten().zip(exact.iter().flatten());
    entries
        .map(|(x, exact)| (*exact - DoubleDouble::from(*x)).high() / scale)
        .collect()
}
