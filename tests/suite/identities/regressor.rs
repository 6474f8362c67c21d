//! The regressor and the base inertial parameters.

use robot_dynamics::nalgebra::{DMatrix, DVector, SVector};
use robot_dynamics::{
    NewtonEuler, State,
    table::{Spring, Table},
};
use testkit::random::Random;

use super::any_arm::AnyArm;
use super::axes::{axes, with_axes};
use super::samples::{Magnitude, assert_small, states};

/// Y base_parameters + K + F = tau.
pub(super) fn base_parameters_give_the_torque_without_springs_and_friction<
    const N: usize,
    const P: usize,
>(
    robot: &dyn AnyArm<N, P>,
) {
    for state in states() {
        let found = robot.evaluate(&state, &SVector::zeros());
        let own = robot.spring_vector(&state.q) + robot.friction_vector(&state.qd);
        let forces: SVector<f64, N> = found.get("regressor_form").expect("asked for");
        let torque = forces + own;
        let expected = robot.inverse_dynamics(&state.q, &state.qd, &state.qdd);
        assert_small(&(torque - expected), Magnitude::at(robot, &state).torque, N);
    }
}

/// Random states: three equations for each base parameter, and some.
fn samples<const N: usize, const P: usize>(robot: &dyn AnyArm<N, P>) -> Vec<State<N>> {
    let mut random = Random::seeded(1_990);
    let mut state = || State {
        q: random.vector(std::f64::consts::PI),
        qd: random.vector(3.0),
        qdd: random.vector(10.0),
    };
    let first = state();
    let columns = columns(robot, &first).len();
    let count = 8 + 3 * columns / N;
    (0..count).map(|_| state()).collect()
}

fn columns<const N: usize, const P: usize>(
    robot: &dyn AnyArm<N, P>,
    state: &State<N>,
) -> Vec<SVector<f64, N>> {
    let found = robot.evaluate(state, &SVector::zeros());
    found.get("regressor").expect("asked for")
}

/// The regressors of all states, one below the other, and the norm of each column, by which it is
/// divided.
fn stacked<const N: usize, const P: usize>(
    robot: &dyn AnyArm<N, P>,
    states: &[State<N>],
) -> (DMatrix<f64>, DVector<f64>) {
    let regressors: Vec<_> = states.iter().map(|state| columns(robot, state)).collect();
    let mut matrix = DMatrix::from_fn(N * states.len(), regressors[0].len(), |row, column| {
        regressors[row / N][column][row % N]
    });
    // Columns of a coupled arm may vanish.
    let norm = |norm: f64| if norm > 0.0 { norm } else { 1.0 };
    let norms = matrix.column_iter().map(|column| norm(column.norm()));
    let norms = DVector::from_iterator(matrix.ncols(), norms);
    for (mut column, norm) in matrix.column_iter_mut().zip(norms.iter()) {
        column /= *norm;
    }
    (matrix, norms)
}

/// None of the columns is a combination of the others, by a wide margin: the set is minimal.
pub(super) fn columns_of_the_regressor_are_independent<const N: usize, const P: usize>(
    robot: &dyn AnyArm<N, P>,
) {
    if !robot.table().followers.is_empty() {
        // They are those of the arm in which followers move by themselves.
        return;
    }
    let (matrix, _) = stacked(robot, &samples(robot));
    let values = matrix.singular_values();
    assert!(
        values.min() > 1e-3 * values.max(),
        "{}",
        values.min() / values.max()
    );
}

/// The same geometry with other links, springs and friction left out.
fn with_other_links<const N: usize>(table: &Table<N>, random: &mut Random) -> Table<N> {
    let mut axes = axes(table);
    for row in axes.iter_mut().map(|axis| &mut axis.row) {
        row.mass = random.between(0.5, 5.0);
        row.com = [(); 3].map(|()| random.between(-0.3, 0.3));
        let diagonal = [(); 3].map(|()| random.between(0.1, 0.15));
        let products = [(); 3].map(|()| random.between(-0.02, 0.02));
        row.inertia = [diagonal, products].concat().try_into().expect("six");
        if row.motor_inertia != 0.0 {
            let reflected = random.between(0.1, 2.0);
            row.motor_inertia = reflected / (row.gear_ratio * row.gear_ratio);
        }
        (row.viscous, row.coulomb, row.stribeck) = (0.0, [0.0; 2], None);
        row.spring = Spring::NONE;
    }
    with_axes(table, &axes)
}

/// Identification: base parameters by least squares from the torques of an arm of the same geometry,
/// whose links nobody knows, give its torques in every other motion. The torques come from the
/// numeric Newton-Euler algorithm.
pub(super) fn torques_of_any_inertia_are_combinations_of_the_columns<
    const N: usize,
    const P: usize,
>(
    robot: &dyn AnyArm<N, P>,
) {
    let states = samples(robot);
    let (matrix, norms) = stacked(robot, &states);
    let factors = matrix.svd(true, true);
    let mut random = Random::seeded(7);
    for _ in 0..3 {
        let table = with_other_links(&robot.table(), &mut random);
        let unknown = NewtonEuler::new(&table);
        let torque = |state: &State<N>| unknown.inverse_dynamics(&state.q, &state.qd, &state.qdd);
        let measured = states.iter().flat_map(|state| torque(state).data.0[0]);
        let measured = DVector::from_iterator(N * states.len(), measured);
        let least = 1e-9 * factors.singular_values.max();
        let scaled = factors.solve(&measured, least).expect("both factors");
        let identified = scaled.component_div(&norms);
        for state in super::samples::states() {
            let columns = columns(robot, &state);
            let terms = columns.iter().zip(identified.iter());
            let predicted: SVector<f64, N> = terms.map(|(column, b)| column * *b).sum();
            let error = (predicted - torque(&state)).amax();
            assert!(
                error <= 1e-11 * measured.amax(),
                "{error:e} of {:e}",
                measured.amax()
            );
        }
    }
}
