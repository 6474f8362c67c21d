//! Each generated function beside what Newton-Euler says.

use nalgebra::{SMatrix, SVector};

use super::accelerations::{acceleration_derivatives, refused, series_residuals, task_space};
use super::coefficients::{centrifugal_coefficients as numeric_centrifugal, coriolis_entries};
use super::deviation::{Deviation, Entry, Measured, amax, entries, of};
use super::kinematics::{in_space, jacobian_entries, pose_entries, tip_entries};
use super::scale::Scale;
use crate::table::{AsArm as _, Moving};
use crate::{Evaluation, NewtonEuler, SecondDerivatives, State, Table};

/// The deviation of every generated function, in the order of the documentation. `datum` is the constant
/// that the regressor of the potential energy leaves open.
pub(super) fn deviations<T: Measured, const N: usize>(
    generated: &Evaluation<N, T>,
    numeric: &NewtonEuler<N>,
    table: &Table<N>,
    (state, tau): (&State<N>, &SVector<f64, N>),
    datum: f64,
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
        wrench_torques,
        tool_velocity,
        tool_acceleration,
        jacobian_rate,
        link_jacobians,
        center_of_mass,
        center_of_mass_jacobian,
        operational_inertia_inverse,
        generalized_momentum,
        momentum_bias,
        passivity_torque,
        passivity_regressor,
        passivity_regressor_forces,
        energy_regressors,
        energies_of_parameters,
        inverse_dynamics_rates,
        inverse_dynamics_second_derivatives,
    } = generated;
    let State { q, qd, qdd } = state;
    let m = numeric.mass_matrix(q);
    let v = numeric.coriolis_vector(q, qd);
    let scale = Scale::new(table, &m, state);
    let matrix = Deviation::of_matrix::<T, N, N>;
    let vector = Deviation::of_matrix::<T, N, 1>;
    let accelerations = |function, qdd: Result<SVector<T, N>, _>| match qdd {
        Ok(qdd) => {
            let residual = of::<T, N, N>(m) * qdd + of(numeric.bias_force(q, qd)) - of(*tau);
            let scale = scale.inverse_dynamics + scale.mass_matrix * amax(&qdd);
            vector(function, &residual, scale)
        }
        Err(error) => refused(function, &m, &error),
    };
    let found = [
        mass_matrix.map(|found| matrix("mass_matrix", &(found - of(m)), scale.mass_matrix)),
        coriolis_vector
            .map(|found| vector("coriolis_vector", &(found - of(v)), scale.coriolis_vector)),
        gravity_vector.map(|g| {
            let difference = g - of(numeric.gravity_vector(q));
            vector("gravity_vector", &difference, scale.gravity_vector)
        }),
        friction_vector.map(|f| {
            let difference = f - of(numeric.friction_vector(qd));
            vector("friction_vector", &difference, scale.friction_vector)
        }),
        spring_vector.map(|k| {
            let difference = k - of(numeric.spring_vector(q));
            vector("spring_vector", &difference, scale.spring_vector)
        }),
        inverse_dynamics
            .map(|t| vector("inverse_dynamics", &(t - of(*tau)), scale.inverse_dynamics)),
        forward_dynamics.map(|qdd| accelerations("forward_dynamics", qdd)),
        kinetic_energy.map(|t| {
            let difference = t - T::of(numeric.kinetic_energy(q, qd));
            Deviation::of_number("kinetic_energy", difference, scale.coriolis_vector)
        }),
        potential_energy.map(|u| {
            let difference = u - T::of(numeric.potential_energy(q));
            Deviation::of_number("potential_energy", difference, scale.potential_energy)
        }),
        bias_force.map(|b| {
            let difference = b - of(numeric.bias_force(q, qd));
            vector("bias_force", &difference, scale.bias_force)
        }),
        coriolis_matrix.map(|c| {
            let difference = c - of(numeric.coriolis_matrix(q, qd));
            matrix("coriolis_matrix", &difference, scale.coriolis_matrix)
        }),
        coriolis_coefficients.as_ref().map(|columns| {
            let entries = coriolis_entries(columns, numeric, q, scale.coefficients);
            Deviation::worst("coriolis_coefficients", entries)
        }),
        centrifugal_coefficients.map(|c| {
            let difference = c - of(numeric_centrifugal(numeric, q));
            let scale = scale.coefficients;
            matrix("centrifugal_coefficients", &difference, scale)
        }),
        configuration_space_coriolis.map(|found| {
            let difference = found - of(v);
            vector(
                "configuration_space_form",
                &difference,
                scale.coriolis_vector,
            )
        }),
        forward_kinematics.map(|pose| {
            let difference = pose - of(numeric.forward_kinematics(q));
            let entries = pose_entries(None, difference, scale.position);
            Deviation::worst("forward_kinematics", entries)
        }),
        link_poses.map(|poses| {
            let numeric = numeric.link_poses(q);
            let entries = (0..N)
                .flat_map(|i| pose_entries(Some(i), poses[i] - of(numeric[i]), scale.position));
            Deviation::worst("link_poses", entries)
        }),
        jacobian.map(|jacobian| {
            let difference = jacobian - of(numeric.jacobian(q));
            let entries = jacobian_entries(table, &difference, scale.position);
            Deviation::worst("jacobian", entries)
        }),
        regressor_forces.map(|forces| {
            let others = numeric.spring_vector(q) + numeric.friction_vector(qd);
            let difference = forces + of(others) - of(*tau);
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
        wrench_torques.map(|torques| {
            let wrench = State::<N>::wrench();
            let difference = torques - of(numeric.jacobian(q).transpose() * wrench);
            let scale = wrench.amax() * scale.position.max(1.0);
            vector("wrench_torques", &difference, scale)
        }),
        tool_velocity.map(|velocity| {
            let difference = velocity - of(numeric.jacobian(q) * qd);
            let entries = tip_entries(difference, qd.amax(), scale.position);
            Deviation::worst("tool_velocity", entries)
        }),
        tool_acceleration.map(|acceleration| {
            let expected = numeric.jacobian(q) * qdd + numeric.jacobian_rate(q, qd) * qd;
            let size = qdd.amax() + qd.amax() * qd.amax();
            let entries = tip_entries(acceleration - of(expected), size, scale.position);
            Deviation::worst("tool_acceleration", entries)
        }),
        jacobian_rate.map(|rate| {
            let difference = rate - of(numeric.jacobian_rate(q, qd));
            let entries = (0..N).flat_map(|j| {
                tip_entries(difference.column(j).into_owned(), qd.amax(), scale.position)
            });
            Deviation::worst("jacobian_rate", entries)
        }),
        link_jacobians.map(|jacobians| {
            let expected = numeric.link_jacobians(q);
            let entries = (0..N).flat_map(|i| {
                let difference = jacobians[i] - of(expected[i]);
                jacobian_entries(table, &difference, scale.position).collect::<Vec<_>>()
            });
            Deviation::worst("link_jacobians", entries)
        }),
        center_of_mass.map(|center| {
            let difference = center - of(numeric.center_of_mass(q));
            Deviation::worst("center_of_mass", in_space(difference, scale.position))
        }),
        center_of_mass_jacobian.map(|jacobian| {
            let difference = jacobian - of(numeric.center_of_mass_jacobian(q));
            let size = scale.position.max(1.0);
            Deviation::worst("center_of_mass_jacobian", in_space(difference, size))
        }),
        operational_inertia_inverse.map(|inverse| match inverse {
            Ok(inverse) => task_space(&inverse, &m, &numeric.jacobian(q)),
            Err(error) => refused("operational_inertia_inverse", &m, &error),
        }),
        generalized_momentum.map(|momentum| {
            let difference = momentum - of(m * qd);
            vector("generalized_momentum", &difference, scale.coriolis_matrix)
        }),
        momentum_bias.map(|bias| {
            let coriolis = numeric.coriolis_matrix(q, qd).transpose() * qd;
            let forces = numeric.gravity_vector(q) + own_forces(numeric, state);
            let difference = bias - of(coriolis - forces);
            vector("momentum_bias", &difference, scale.bias_force)
        }),
        passivity_torque.map(|torque| {
            let forces = passivity(numeric, &m, state) + own_forces(numeric, state);
            let difference = torque - of(forces);
            vector("passivity_torque", &difference, scale.passivity_torque)
        }),
        passivity_regressor_forces.map(|forces| {
            let difference = forces - of(passivity(numeric, &m, state));
            vector("passivity_form", &difference, scale.passivity_torque)
        }),
        energies_of_parameters.map(|(kinetic, potential)| {
            let kinetic = kinetic - T::of(numeric.kinetic_energy(q, qd));
            let potential = potential - T::of(gravity_energy(numeric, table, q) + datum);
            let entries = [
                Entry::new(None, kinetic, scale.coriolis_vector),
                Entry::new(None, potential, scale.potential_energy),
            ];
            Deviation::worst("energies_form", entries.into_iter())
        }),
        inverse_dynamics_rates.map(|(first, second)| {
            let [jerk, snap] = [state.jerk(), state.snap()];
            let expected = numeric.inverse_dynamics_rates(q, qd, qdd, &jerk, &snap);
            let [size, size_of_second] = scale.rates(state);
            let entries = entries(first - of(expected.0), size)
                .chain(entries(second - of(expected.1), size_of_second));
            Deviation::worst("inverse_dynamics_rates", entries)
        }),
        inverse_dynamics_second_derivatives
            .as_ref()
            .map(|derivatives| second_derivatives(derivatives, numeric, [q, qd, qdd], &scale)),
        alone(
            "passivity_regressor",
            passivity_regressor.is_some(),
            passivity_regressor_forces.is_some(),
        ),
        alone(
            "energy_regressors",
            energy_regressors.is_some(),
            energies_of_parameters.is_some(),
        ),
        alone("regressor", regressor.is_some(), regressor_forces.is_some()),
        alone(
            "base_parameters",
            base_parameters.is_some(),
            regressor_forces.is_some()
                || passivity_regressor_forces.is_some()
                || energies_of_parameters.is_some(),
        ),
    ];
    found.into_iter().flatten().collect()
}

/// U without what is in the springs.
pub(super) fn gravity_energy<const N: usize>(
    numeric: &NewtonEuler<N>,
    table: &Table<N>,
    q: &SVector<f64, N>,
) -> f64 {
    let energy = |moving: Moving<'_>| {
        let position = moving.factor * q[moving.joint] + moving.offset;
        moving.row.spring.energy(position)
    };
    let springs: f64 = table.arm().chain().map(energy).sum();
    numeric.potential_energy(q) - springs
}

/// K + F at a state.
fn own_forces<const N: usize>(numeric: &NewtonEuler<N>, state: &State<N>) -> SVector<f64, N> {
    numeric.spring_vector(&state.q) + numeric.friction_vector(&state.qd)
}

/// M qdd_r + C qd_r + G for the reference motion of a state.
fn passivity<const N: usize>(
    numeric: &NewtonEuler<N>,
    mass_matrix: &SMatrix<f64, N, N>,
    state: &State<N>,
) -> SVector<f64, N> {
    let State { q, qd, .. } = state;
    let coriolis = numeric.coriolis_matrix(q, qd) * state.reference_velocity();
    mass_matrix * state.reference_acceleration() + coriolis + numeric.gravity_vector(q)
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
        rounding: 0.0,
        joint: None,
    })
}

/// Second derivatives of tau beside those of the numeric recursion. Never a part of its caller, whose
/// frame they would fill for arms that have none.
#[inline(never)]
fn second_derivatives<T: Measured, const N: usize>(
    generated: &SecondDerivatives<T, N>,
    numeric: &NewtonEuler<N>,
    [q, qd, qdd]: [&SVector<f64, N>; 3],
    scale: &Scale,
) -> Deviation {
    let expected = &numeric.inverse_dynamics_second_derivatives(q, qd, qdd);
    let expected = [expected.0, expected.1, expected.2, expected.3];
    let generated = [generated.0, generated.1, generated.2, generated.3];
    let pairs = generated.into_iter().zip(expected);
    let differences = pairs.zip(scale.second_derivatives());
    let of_joint = |(i, difference): (usize, SMatrix<T, N, N>), scale| {
        let entries = entries(difference, scale);
        entries.map(move |entry| entry.of_joint(i))
    };
    let entries = differences.flat_map(|((generated, expected), scale)| {
        let matrices = generated.into_iter().zip(expected).enumerate();
        matrices.flat_map(move |(i, (a, b))| of_joint((i, a - of(b)), scale))
    });
    Deviation::worst("inverse_dynamics_second_derivatives", entries)
}

/// d tau/dq and d tau/dqd beside those of the numeric recursion.
fn force_derivatives<T: Measured, const N: usize>(
    generated: &(SMatrix<T, N, N>, SMatrix<T, N, N>),
    expected: &(SMatrix<f64, N, N>, SMatrix<f64, N, N>),
    scale: &Scale,
) -> Deviation {
    let by_position = entries(generated.0 - of(expected.0), scale.force_by_position);
    let by_velocity = entries(generated.1 - of(expected.1), scale.force_by_velocity);
    Deviation::worst(
        "inverse_dynamics_derivatives",
        by_position.chain(by_velocity),
    )
}
