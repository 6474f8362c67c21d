//! The regressor and the base inertial parameters.

use robot_dynamics::nalgebra::{DMatrix, DVector, Dyn};
use robot_dynamics::{
    NumericArm,
    table::{RuntimeTable, Spring},
};
use testkit::random::Random;

use super::any_robot::AnyRobot;
use super::axes::{axes, with_axes};
use super::place::State;
use super::samples::{Magnitude, assert_small, state, states};

/// Y base_parameters + K + F = tau.
pub(super) fn base_parameters_give_the_torque_without_springs_and_friction(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    for state in states(robot) {
        let found = robot.evaluate(&state, &DVector::zeros(n));
        let own = robot.spring_vector(&state.q) + robot.friction_vector(&state.qd);
        let forces: Vec<f64> = found.get("regressor_form").expect("asked for");
        let torque = DVector::from(forces) + own;
        let expected = robot.inverse_dynamics(&state.q, &state.qd, &state.qdd);
        assert_small(&(torque - expected), Magnitude::at(robot, &state).torque, n);
    }
}

/// Random states: three equations for each base parameter, and some.
fn samples(robot: &dyn AnyRobot) -> Vec<State> {
    let mut random = Random::seeded(1_990);
    let n = robot.freedoms();
    let mut state = || state(&mut random, robot.table().rows.len(), n);
    let columns = regressor(robot, &state()).ncols();
    let count = 8 + 3 * columns / n;
    (0..count).map(|_| state()).collect()
}

fn regressor(robot: &dyn AnyRobot, state: &State) -> DMatrix<f64> {
    let n = robot.freedoms();
    let found = robot.evaluate(state, &DVector::zeros(n));
    let columns: Vec<f64> = found.get("regressor").expect("asked for");
    DMatrix::from_column_slice(n, columns.len() / n, &columns)
}

/// The regressors of all states, one below the other, and the norm of each column, by which it is
/// divided.
fn stacked(robot: &dyn AnyRobot, states: &[State]) -> (DMatrix<f64>, DVector<f64>) {
    let n = robot.freedoms();
    let regressors: Vec<_> = states.iter().map(|state| regressor(robot, state)).collect();
    let mut matrix = DMatrix::from_fn(n * states.len(), regressors[0].ncols(), |row, column| {
        regressors[row / n][(row % n, column)]
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
pub(super) fn columns_of_the_regressor_are_independent(robot: &dyn AnyRobot) {
    if robot.table().followers().next().is_some() {
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
fn with_other_links(table: &RuntimeTable, random: &mut Random) -> RuntimeTable {
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
pub(super) fn torques_of_any_inertia_are_combinations_of_the_columns(robot: &dyn AnyRobot) {
    let states = samples(robot);
    let (matrix, norms) = stacked(robot, &states);
    let factors = matrix.svd(true, true);
    let mut random = Random::seeded(7);
    for _ in 0..3 {
        let table = with_other_links(&robot.table(), &mut random);
        let unknown = NumericArm::<Dyn>::new(&table);
        let torque = |state: &State| unknown.inverse_dynamics(&state.q.q, &state.qd, &state.qdd);
        let measured: Vec<f64> = (states.iter().map(torque))
            .flat_map(|torque| torque.data.as_vec().clone())
            .collect();
        let measured = DVector::from(measured);
        let least = 1e-9 * factors.singular_values.max();
        let scaled = factors.solve(&measured, least).expect("both factors");
        let identified = scaled.component_div(&norms);
        for state in super::samples::states(robot) {
            let predicted = regressor(robot, &state) * &identified;
            let error = (predicted - torque(&state)).amax();
            assert!(
                error <= 1e-11 * measured.amax(),
                "{error:e} of {:e}",
                measured.amax()
            );
        }
    }
}
