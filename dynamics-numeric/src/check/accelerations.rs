//! Solutions with M, judged by the equations that they have to satisfy.

use dynamics_runtime::{MAX_TAYLOR_ORDER, SingularMassMatrix};
use nalgebra::{DMatrix, DVector, Vector6};

use super::at::At;
use super::deviation::{Deviation, Entry, Measured, amax, entries, of, of_vector};

/// Below this part of its diagonal entry a pivot of the numeric mass matrix counts as zero: its own
/// roundings then decide whether a factorisation succeeds.
const SINGULAR: f64 = 1e-10;

/// Below this part of the largest |M| a pivot, and with it the diagonal entry that bounds it, counts
/// as zero too.
///
/// If nothing resists a joint (point masses on its axis), the numeric entry is no 0. It is the roundings of terms as large
/// as those elsewhere in M, at most a few 1e-16 of them.
/// Measured against itself such an entry looks regular. No real arm comes near the bound: a finger of
/// 1e-6 kg m^2 on an arm of 1e4 kg m^2 is a hundred times above it.
const VANISHING: f64 = 1e-12;

/// A refusal to solve is right where the numeric mass matrix is singular too: there is nothing to
/// compare then. Where it is regular, nothing excuses the refusal.
pub(super) fn refused(
    function: &'static str,
    mass_matrix: &DMatrix<f64>,
    error: &SingularMassMatrix,
) -> Deviation {
    let largest = mass_matrix.amax();
    let regular = mass_matrix.clone().cholesky().is_some_and(|factor| {
        let factor = factor.l_dirty().diagonal();
        (0..mass_matrix.nrows()).all(|i| {
            let pivot = factor[i] * factor[i];
            pivot > SINGULAR * mass_matrix[(i, i)] && pivot > VANISHING * largest
        })
    });
    Deviation {
        function,
        error: regular.then_some(f64::INFINITY),
        rounding: 0.0,
        joint: Some(error.joint),
        overflows: false,
    }
}

/// The matrices of these numbers of rows and columns, one after the other; `None` where there are more numbers or fewer.
fn matrices<T: Measured, const K: usize>(
    mut numbers: &[T],
    shapes: [(usize, usize); K],
) -> Option<[DMatrix<T>; K]> {
    let mut found = Vec::with_capacity(K);
    for (rows, columns) in shapes {
        let own = numbers.split_off(..rows * columns)?;
        found.push(DMatrix::from_column_slice(rows, columns, own));
    }
    let matrices = found.try_into().ok()?;
    numbers.is_empty().then_some(matrices)
}

/// Another number of entries satisfies no equation.
fn unreadable() -> Option<Vec<Entry>> {
    Some(vec![Entry::new(None, f64::NAN, 1.0)])
}

/// The equations of motion as far as the accelerations do not satisfy them: M qdd + bias - tau = 0.
pub(super) fn accelerations<T: Measured>(at: &At<'_>, found: &[T]) -> Option<Vec<Entry>> {
    let Some([qdd]) = matrices(found, [(at.freedoms(), 1)]) else {
        return unreadable();
    };
    let bias = at.robot.bias_force(at.q, at.qd);
    let residual = of::<T>(&at.mass_matrix) * &qdd + of_vector(&bias) - of_vector(at.tau);
    let scale = at.scale.inverse_dynamics + at.scale.mass_matrix * amax(&qdd);
    Some(entries(residual, scale).collect())
}

/// The equations that the derivatives of forward dynamics satisfy, as far as they do not: M qdd_q + tau_q = 0,
/// M qdd_qd + tau_qd = 0, M qdd_tau = 1, with the derivatives of tau at the accelerations of the state.
///
/// The generated function solves for these accelerations, whose roundings M^-1 magnifies.
pub(super) fn acceleration_derivatives<T: Measured>(
    at: &At<'_>,
    found: &[T],
) -> Option<Vec<Entry>> {
    let n = at.freedoms();
    let Some([by_position, by_velocity, by_force]) = matrices(found, [(n, n); 3]) else {
        return unreadable();
    };
    let (scale, forces) = (
        &at.scale,
        at.robot.inverse_dynamics_derivatives(at.q, at.qd, at.qdd),
    );
    let condition = scale.mass_matrix * amax(&by_force);
    let residual = |derivative: &DMatrix<T>, forces: &DMatrix<f64>, size: f64| {
        let scale = size + scale.mass_matrix * amax(derivative);
        entries(of::<T>(&at.mass_matrix) * derivative + of(forces), scale)
    };
    let positions = scale.force_by_position + condition * scale.inverse_dynamics;
    let residuals = residual(&by_position, &forces.0, positions)
        .chain(residual(&by_velocity, &forces.1, scale.force_by_velocity))
        .chain(residual(&by_force, &-DMatrix::identity(n, n), 1.0));
    Some(residuals.collect())
}

/// J M^-1 J' beside a solution of M X = J'. A rounding e of M changes the product by X' e X, which is its natural error
/// however nearly singular M is.
pub(super) fn task_space<T: Measured>(at: &At<'_>, found: &[T]) -> Option<Vec<Entry>> {
    let Some([found]) = matrices(found, [(6, 6)]) else {
        return unreadable();
    };
    let jacobian = at.tip_jacobian();
    let x = at
        .mass_matrix
        .clone()
        .cholesky()?
        .solve(&jacobian.transpose());
    let expected = &jacobian * &x;
    let sizes = Vector6::from_fn(|i, _| x.column(i).lp_norm(1));
    let entry = |i: usize, j: usize| {
        let scale = at.scale.mass_matrix * sizes[i] * sizes[j] + x.amax() * jacobian.amax();
        Entry::new(None, found[(i, j)] - T::of(expected[(i, j)]), scale)
    };
    let places = (0..6).flat_map(|i| (0..6).map(move |j| (i, j)));
    Some(places.map(|(i, j)| entry(i, j)).collect())
}

/// The start of the motion, and the residuals of the equations of motion and of their first derivative by time. They
/// are M qdd + bias - tau = 0 with qdd = 2 q_2, and, since tau is constant, M jerk + tau_q qd + tau_qd qdd = 0 with
/// jerk = 6 q_3.
pub(super) fn series_residuals<T: Measured>(at: &At<'_>, found: &[T]) -> Option<Vec<Entry>> {
    if at.first() > 0 {
        // There are no series of a base that moves.
        return None;
    }
    let shapes = [(at.freedoms(), 1); MAX_TAYLOR_ORDER + 1];
    let Some([q, qd, second, third, ..]) = matrices(found, shapes) else {
        return unreadable();
    };
    let scale = &at.scale;
    let (qdd, jerk) = (second * T::of(2.0), third * T::of(6.0));
    let doubles = DVector::from_iterator(at.freedoms(), qdd.iter().map(|x| x.double()));
    let (by_position, by_velocity) = at.robot.inverse_dynamics_derivatives(at.q, at.qd, &doubles);
    let mass_matrix = of::<T>(&at.mass_matrix);
    let bias = of_vector(&at.robot.bias_force(at.q, at.qd));
    let force = &mass_matrix * &qdd + bias - of_vector(at.tau);
    let rate =
        mass_matrix * &jerk + of_vector(&(by_position * at.qd)) + of::<T>(&by_velocity) * &qdd;
    let inertial = scale.mass_matrix * amax(&qdd);
    let rates = scale.mass_matrix * amax(&jerk)
        + (scale.force_by_position + inertial) * at.qd.amax()
        + scale.force_by_velocity * amax(&qdd);
    let start = entries(q - of_vector(at.q), 0.0).chain(entries(qd - of_vector(at.qd), 0.0));
    let equations = entries(force, scale.inverse_dynamics + inertial).chain(entries(rate, rates));
    Some(start.chain(equations).collect())
}
