//! From the parameters of links to those that a motion shows.

use nalgebra::{DMatrix, SVector};

use crate::check::random::SplitMix64;
use crate::{Evaluate, NewtonEuler, State};

/// K of `b = K x`: how the base parameters b of [`base_parameters`] and `regressor` are combined of the
/// standard ones. `None` where the arm's functions lack `regressor`.
///
/// x holds the ten [standard parameters](crate::Table::standard_parameters) of the first link, of the second,
/// ..., then the reflected inertia of each motor, `gear_ratio^2 inertia`. K is P x 11 N and depends on the
/// geometry alone. What lies in its null space moves no joint: two sets of links with the same K x
/// cannot be told from each other by torques.
///
/// It is found from the two regressors, Y(b) K = Y(x), by least squares over random states: the generated one
/// and the numeric one of the table, so that an entry has an error of some 1e-13 of the largest. Entries that
/// are smaller than 1e-11 of it are zero.
///
/// ```
/// use dynamics_runtime::{base_parameter_map, robot_dynamics};
///
/// robot_dynamics! {
///     /// A rod: its torque shows the moment m c_x and the inertia J_zz with that of the motor.
///     struct Rod;
///     convention: modified,
///     gravity: [0, -9.81, 0],
///     joints: [
///         pivot: revolute {
///             mass: 3, com: [1, 0, 0], inertia: rod(2), motor: { inertia: 1e-4, gear_ratio: 50 },
///         },
///     ],
///     functions: [regressor, base_parameters],
/// }
///
/// let map = base_parameter_map(&Rod).unwrap();
/// let table = Rod.table();
/// let mut x = table.standard_parameters()[0].as_slice().to_vec();
/// x.push(table.rows[0].reflected_inertia());
/// let b = map * dynamics_runtime::nalgebra::DVector::from(x);
/// assert!((b - Rod.base_parameters::<f64>()).amax() < 1e-12);
/// ```
///
/// [`base_parameters`]: crate::Evaluation::base_parameters
pub fn base_parameter_map<R: Evaluate<N>, const N: usize>(robot: &R) -> Option<DMatrix<f64>> {
    let numeric = NewtonEuler::new(&robot.table());
    let mut random = SplitMix64(1);
    let width = 11 * N;
    let state = |random: &mut SplitMix64| {
        let mut vector = |size: f64| SVector::from_fn(|_, _| random.within(&(-size..=size)));
        State {
            q: vector(2.0),
            qd: vector(2.0),
            qdd: vector(2.0),
        }
    };
    let first = state(&mut random);
    let count = robot.evaluate(&first, &SVector::zeros()).regressor?.len();
    // Four times as many equations as the least.
    let states = 4 * count.div_ceil(N.max(1)) + 4;
    let mut base = DMatrix::zeros(states * N, count);
    let mut standard = DMatrix::zeros(states * N, width);
    for k in 0..states {
        let state = state(&mut random);
        let columns = robot.evaluate(&state, &SVector::zeros()).regressor?;
        for (j, column) in columns.iter().enumerate() {
            base.fixed_view_mut::<N, 1>(k * N, j).copy_from(column);
        }
        let State { q, qd, qdd } = &state;
        for (link, block) in numeric.standard_regressor(q, qd, qdd).iter().enumerate() {
            standard
                .fixed_view_mut::<N, 10>(k * N, 10 * link)
                .copy_from(block);
            standard[(k * N + link, 10 * N + link)] = qdd[link];
        }
    }
    let factors = base.qr();
    let right = factors.q().tr_mul(&standard);
    let mut map = factors.r().solve_upper_triangular(&right)?;
    let nothing = 1e-11 * map.amax();
    map.iter_mut()
        .filter(|entry| entry.abs() < nothing)
        .for_each(|entry| *entry = 0.0);
    Some(map)
}
