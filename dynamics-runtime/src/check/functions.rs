//! Each generated function beside what Newton-Euler says.

use nalgebra::{SMatrix, SVector};

use super::accelerations::{acceleration_derivatives, refused, series_residuals};
use super::coefficients::{centrifugal_coefficients as numeric_centrifugal, coriolis_entries};
use super::deviation::{Deviation, entries};
use super::kinematics::{jacobian_entries, pose_entries};
use super::scale::Scale;
use crate::{Evaluation, NewtonEuler, State, Table};

/// The deviation of every generated function, in the order of the documentation.
pub(super) fn deviations<const N: usize>(
    generated: &Evaluation<N>,
    numeric: &NewtonEuler<N>,
    table: &Table<N>,
    state: &State<N>,
    tau: &SVector<f64, N>,
) -> Vec<Deviation> {
    // A function that this list forgets is an error here.
    let Evaluation {
        mass_matrix,
        coriolis_vector,
        gravity_vector,
        friction_vector,
        spring_vector,
        inverse_dynamics,
        forward_dynamics,
        kinetic_energy,
        potential_energy,
        bias_force,
        coriolis_matrix,
        coriolis_coefficients,
        centrifugal_coefficients,
        configuration_space_coriolis,
        forward_kinematics,
        link_poses,
        jacobian,
        regressor,
        base_parameters,
        regressor_forces,
        inverse_dynamics_derivatives,
        forward_dynamics_derivatives,
        forward_dynamics_aba,
        taylor_series,
    } = generated;
    let State { q, qd, qdd } = state;
    let m = numeric.mass_matrix(q);
    let v = numeric.coriolis_vector(q, qd);
    let scale = Scale::new(table, &m, state);
    let matrix = Deviation::of_matrix::<N, N>;
    let vector = Deviation::of_matrix::<N, 1>;
    let accelerations = |function, qdd: Result<SVector<f64, N>, _>| match qdd {
        Ok(qdd) => {
            let residual = m * qdd + numeric.bias_force(q, qd) - tau;
            let scale = scale.inverse_dynamics + scale.mass_matrix * qdd.amax();
            vector(function, &residual, scale)
        }
        Err(error) => refused(function, &m, &error),
    };
    let found = [
        mass_matrix.map(|found| matrix("mass_matrix", &(found - m), scale.mass_matrix)),
        coriolis_vector.map(|found| vector("coriolis_vector", &(found - v), scale.coriolis_vector)),
        gravity_vector.map(|g| {
            let difference = g - numeric.gravity_vector(q);
            vector("gravity_vector", &difference, scale.gravity_vector)
        }),
        friction_vector.map(|f| {
            let difference = f - numeric.friction_vector(qd);
            vector("friction_vector", &difference, scale.friction_vector)
        }),
        spring_vector.map(|k| {
            let difference = k - numeric.spring_vector(q);
            vector("spring_vector", &difference, scale.spring_vector)
        }),
        inverse_dynamics.map(|t| vector("inverse_dynamics", &(t - tau), scale.inverse_dynamics)),
        forward_dynamics.map(|qdd| accelerations("forward_dynamics", qdd)),
        kinetic_energy.map(|t| {
            let difference = t - numeric.kinetic_energy(q, qd);
            Deviation::of_number("kinetic_energy", difference, scale.coriolis_vector)
        }),
        potential_energy.map(|u| {
            let difference = u - numeric.potential_energy(q);
            Deviation::of_number("potential_energy", difference, scale.potential_energy)
        }),
        bias_force.map(|b| {
            let difference = b - numeric.bias_force(q, qd);
            vector("bias_force", &difference, scale.bias_force)
        }),
        coriolis_matrix.map(|c| {
            let difference = c - numeric.coriolis_matrix(q, qd);
            matrix("coriolis_matrix", &difference, scale.coriolis_matrix)
        }),
        coriolis_coefficients.as_ref().map(|columns| {
            let entries = coriolis_entries(columns, numeric, q, scale.coefficients);
            Deviation::worst("coriolis_coefficients", entries)
        }),
        centrifugal_coefficients.map(|c| {
            let difference = c - numeric_centrifugal(numeric, q);
            let scale = scale.coefficients;
            matrix("centrifugal_coefficients", &difference, scale)
        }),
        configuration_space_coriolis.map(|found| {
            let difference = found - v;
            vector(
                "configuration_space_form",
                &difference,
                scale.coriolis_vector,
            )
        }),
        forward_kinematics.map(|pose| {
            let difference = pose - numeric.forward_kinematics(q);
            let entries = pose_entries(None, difference, scale.position);
            Deviation::worst("forward_kinematics", entries)
        }),
        link_poses.map(|poses| {
            let numeric = numeric.link_poses(q);
            let entries =
                (0..N).flat_map(|i| pose_entries(Some(i), poses[i] - numeric[i], scale.position));
            Deviation::worst("link_poses", entries)
        }),
        jacobian.map(|jacobian| {
            let difference = jacobian - numeric.jacobian(q);
            let entries = jacobian_entries(table, &difference, scale.position);
            Deviation::worst("jacobian", entries)
        }),
        regressor_forces.map(|forces| {
            let others = numeric.spring_vector(q) + numeric.friction_vector(qd);
            let difference = forces + others - tau;
            vector("regressor_form", &difference, scale.inverse_dynamics)
        }),
        inverse_dynamics_derivatives.map(|derivatives| {
            let expected = numeric.inverse_dynamics_derivatives(q, qd, qdd);
            force_derivatives(&derivatives, &expected, &scale)
        }),
        forward_dynamics_derivatives.map(|derivatives| match derivatives {
            Ok(derivatives) => {
                let forces = numeric.inverse_dynamics_derivatives(q, qd, qdd);
                acceleration_derivatives(&derivatives, &m, &forces, &scale)
            }
            Err(error) => refused("forward_dynamics_derivatives", &m, &error),
        }),
        forward_dynamics_aba.map(|qdd| accelerations("forward_dynamics_aba", qdd)),
        taylor_series.map(|series| match series {
            Ok(series) => series_residuals(&series, numeric, &scale, state, tau),
            Err(error) => refused("taylor_series", &m, &error),
        }),
        alone("regressor", regressor.is_some(), regressor_forces.is_some()),
        alone(
            "base_parameters",
            base_parameters.is_some(),
            regressor_forces.is_some(),
        ),
    ];
    found.into_iter().flatten().collect()
}

/// What is compared as a product, of a function that was generated without the other factor.
fn alone(
    function: &'static str,
    is_generated: bool,
    product_is_compared: bool,
) -> Option<Deviation> {
    (is_generated && !product_is_compared).then_some(Deviation {
        function,
        error: None,
        joint: None,
    })
}

/// d tau/dq and d tau/dqd beside those of the numeric recursion.
fn force_derivatives<const N: usize>(
    generated: &(SMatrix<f64, N, N>, SMatrix<f64, N, N>),
    expected: &(SMatrix<f64, N, N>, SMatrix<f64, N, N>),
    scale: &Scale,
) -> Deviation {
    let by_position = entries(generated.0 - expected.0, scale.force_by_position);
    let by_velocity = entries(generated.1 - expected.1, scale.force_by_velocity);
    Deviation::worst(
        "inverse_dynamics_derivatives",
        by_position.chain(by_velocity),
    )
}
