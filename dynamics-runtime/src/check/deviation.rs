//! The difference between generated and numeric values at one state.

use nalgebra::{Matrix4, SMatrix, SVector};

use super::scale::Scale;
use crate::{
    AccelerationDerivatives, Evaluation, JointType, NewtonEuler, SingularMassMatrix, State, Table,
    TaylorCoefficients,
};

/// Below this part of its diagonal entry a pivot of the numeric mass matrix counts as zero: its own
/// roundings then decide whether a factorisation succeeds.
const SINGULAR: f64 = 1e-10;

/// Below this part of the largest |M| a pivot, and with it the diagonal entry that bounds it, counts
/// as zero too.
///
/// Where nothing resists a joint at some state (point masses on its axis), the numeric entry is not
/// 0 but the roundings of terms as large as those elsewhere in M, at most a few 1e-16 of them.
/// Measured against itself such an entry looks regular. No real arm comes near the bound: a finger of
/// 1e-6 kg m^2 on an arm of 1e4 kg m^2 is a hundred times above it.
const VANISHING: f64 = 1e-12;

/// The largest relative error of one function at one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Deviation {
    pub(super) function: &'static str,
    /// Infinite where a value is not a number; `None` where there was nothing to compare.
    pub(super) error: Option<f64>,
    /// The joint of the worst entry, where entries belong to joints.
    pub(super) joint: Option<usize>,
}

/// The deviation of every generated function, in the order of the documentation.
pub(super) fn deviations<const N: usize>(
    generated: &Evaluation<N>,
    numeric: &NewtonEuler<N>,
    table: &Table<N>,
    state: &State<N>,
    tau: &SVector<f64, N>,
) -> Vec<Deviation> {
    let State { q, qd, .. } = state;
    let mass_matrix = numeric.mass_matrix(q);
    let scale = Scale::new(table, &mass_matrix, state);
    let coriolis_vector = numeric.coriolis_vector(q, qd);
    let matrix = Deviation::of_matrix::<N, N>;
    let vector = Deviation::of_matrix::<N, 1>;
    let accelerations = |function, qdd: Result<SVector<f64, N>, _>| match qdd {
        Ok(qdd) => {
            let residual = mass_matrix * qdd + numeric.bias_force(q, qd) - tau;
            let scale = scale.inverse_dynamics + scale.mass_matrix * qdd.amax();
            vector(function, &residual, scale)
        }
        Err(error) => refused(function, &mass_matrix, &error),
    };
    let found = [
        generated
            .mass_matrix
            .map(|m| matrix("mass_matrix", &(m - mass_matrix), scale.mass_matrix)),
        generated.coriolis_vector.map(|v| {
            vector(
                "coriolis_vector",
                &(v - coriolis_vector),
                scale.coriolis_vector,
            )
        }),
        generated.gravity_vector.map(|g| {
            let difference = g - numeric.gravity_vector(q);
            vector("gravity_vector", &difference, scale.gravity_vector)
        }),
        generated.friction_vector.map(|f| {
            let difference = f - numeric.friction_vector(qd);
            vector("friction_vector", &difference, scale.friction_vector)
        }),
        generated
            .inverse_dynamics
            .map(|t| vector("inverse_dynamics", &(t - tau), scale.inverse_dynamics)),
        generated
            .forward_dynamics
            .map(|qdd| accelerations("forward_dynamics", qdd)),
        generated.kinetic_energy.map(|t| {
            let difference = t - numeric.kinetic_energy(q, qd);
            Deviation::of_number("kinetic_energy", difference, scale.coriolis_vector)
        }),
        generated.potential_energy.map(|u| {
            let difference = u - numeric.potential_energy(q);
            Deviation::of_number("potential_energy", difference, scale.potential_energy)
        }),
        generated.bias_force.map(|b| {
            let difference = b - numeric.bias_force(q, qd);
            vector("bias_force", &difference, scale.bias_force)
        }),
        generated.coriolis_matrix.map(|c| {
            let difference = c - numeric.coriolis_matrix(q, qd);
            matrix("coriolis_matrix", &difference, scale.coriolis_matrix)
        }),
        generated.coriolis_coefficients.as_ref().map(|columns| {
            let entries = coriolis_entries(columns, numeric, q, scale.coefficients);
            Deviation::worst("coriolis_coefficients", entries)
        }),
        generated.centrifugal_coefficients.map(|c| {
            let difference = c - centrifugal_coefficients(numeric, q);
            let scale = scale.coefficients;
            matrix("centrifugal_coefficients", &difference, scale)
        }),
        generated.configuration_space_coriolis.map(|v| {
            let difference = v - coriolis_vector;
            vector(
                "configuration_space_form",
                &difference,
                scale.coriolis_vector,
            )
        }),
        generated.forward_kinematics.map(|pose| {
            let difference = pose - numeric.forward_kinematics(q);
            let entries = pose_entries(None, difference, scale.position);
            Deviation::worst("forward_kinematics", entries)
        }),
        generated.link_poses.map(|poses| {
            let numeric = numeric.link_poses(q);
            let entries =
                (0..N).flat_map(|i| pose_entries(Some(i), poses[i] - numeric[i], scale.position));
            Deviation::worst("link_poses", entries)
        }),
        generated.jacobian.map(|jacobian| {
            let difference = jacobian - numeric.jacobian(q);
            let entries = jacobian_entries(table, &difference, scale.position);
            Deviation::worst("jacobian", entries)
        }),
        generated.regressor_forces.map(|forces| {
            let difference = forces + numeric.friction_vector(qd) - tau;
            vector("regressor_form", &difference, scale.inverse_dynamics)
        }),
        generated.inverse_dynamics_derivatives.map(|generated| {
            let expected = numeric.inverse_dynamics_derivatives(q, qd, &state.qdd);
            force_derivatives(&generated, &expected, &scale)
        }),
        generated
            .forward_dynamics_derivatives
            .map(|derivatives| match derivatives {
                Ok(derivatives) => {
                    let forces = numeric.inverse_dynamics_derivatives(q, qd, &state.qdd);
                    acceleration_derivatives(&derivatives, &mass_matrix, &forces, &scale)
                }
                Err(error) => refused("forward_dynamics_derivatives", &mass_matrix, &error),
            }),
        generated
            .forward_dynamics_aba
            .map(|qdd| accelerations("forward_dynamics_aba", qdd)),
        generated.taylor_series.map(|series| match series {
            Ok(series) => taylor_series(&series, numeric, &scale, state, tau),
            Err(error) => refused("taylor_series", &mass_matrix, &error),
        }),
        alone("regressor", generated.regressor.is_some(), generated),
        alone(
            "base_parameters",
            generated.base_parameters.is_some(),
            generated,
        ),
    ];
    found.into_iter().flatten().collect()
}

/// A refusal to solve is right where the numeric mass matrix is singular too: there is nothing to
/// compare then. Where it is regular, nothing excuses the refusal.
pub(super) fn refused<const N: usize>(
    function: &'static str,
    mass_matrix: &SMatrix<f64, N, N>,
    error: &SingularMassMatrix,
) -> Deviation {
    let largest = mass_matrix.amax();
    let regular = mass_matrix.cholesky().is_some_and(|factor| {
        let factor = factor.l_dirty().diagonal();
        (0..N).all(|i| {
            let pivot = factor[i] * factor[i];
            pivot > SINGULAR * mass_matrix[(i, i)] && pivot > VANISHING * largest
        })
    });
    Deviation {
        function,
        error: regular.then_some(f64::INFINITY),
        joint: Some(error.joint),
    }
}

/// What is compared as a product, of a function that was generated without the other factor.
fn alone<const N: usize>(
    function: &'static str,
    is_generated: bool,
    generated: &Evaluation<N>,
) -> Option<Deviation> {
    (is_generated && generated.regressor_forces.is_none()).then_some(Deviation {
        function,
        error: None,
        joint: None,
    })
}

/// The start of the motion, and the equations of motion with their first derivative by time as far
/// as the series does not satisfy them: M qdd + bias - tau = 0 with qdd = 2 q_2, and, since tau is
/// constant, M jerk + tau_q qd + tau_qd qdd = 0 with jerk = 6 q_3.
fn taylor_series<const N: usize>(
    [q, qd, second, third, ..]: &TaylorCoefficients<f64, N>,
    numeric: &NewtonEuler<N>,
    scale: &Scale,
    state: &State<N>,
    tau: &SVector<f64, N>,
) -> Deviation {
    let (qdd, jerk) = (second * 2.0, third * 6.0);
    let mass_matrix = numeric.mass_matrix(&state.q);
    let (by_position, by_velocity) =
        numeric.inverse_dynamics_derivatives(&state.q, &state.qd, &qdd);
    let force = mass_matrix * qdd + numeric.bias_force(&state.q, &state.qd) - tau;
    let rate = mass_matrix * jerk + by_position * state.qd + by_velocity * qdd;
    let inertial = scale.mass_matrix * qdd.amax();
    let rates = scale.mass_matrix * jerk.amax()
        + (scale.force_by_position + inertial) * state.qd.amax()
        + scale.force_by_velocity * qdd.amax();
    let start = entries(q - state.q, 0.0).chain(entries(qd - state.qd, 0.0));
    let equations = entries(force, scale.inverse_dynamics + inertial).chain(entries(rate, rates));
    Deviation::worst("taylor_series", start.chain(equations))
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

/// The equations that the derivatives of forward dynamics satisfy, as far as they do not: M qdd_q + tau_q = 0,
/// M qdd_qd + tau_qd = 0, M qdd_tau = 1, with the derivatives of tau at the accelerations of the state.
///
/// The generated function solves for these accelerations, whose roundings M^-1 magnifies.
fn acceleration_derivatives<const N: usize>(
    generated: &AccelerationDerivatives<f64, N>,
    mass_matrix: &SMatrix<f64, N, N>,
    forces: &(SMatrix<f64, N, N>, SMatrix<f64, N, N>),
    scale: &Scale,
) -> Deviation {
    let (by_position, by_velocity, by_force) = generated;
    let condition = scale.mass_matrix * by_force.amax();
    let residual = |derivative: &SMatrix<f64, N, N>, of: SMatrix<f64, N, N>, size: f64| {
        let scale = size + scale.mass_matrix * derivative.amax();
        entries(mass_matrix * derivative + of, scale)
    };
    let positions = scale.force_by_position + condition * scale.inverse_dynamics;
    let residuals = residual(by_position, forces.0, positions)
        .chain(residual(by_velocity, forces.1, scale.force_by_velocity))
        .chain(residual(by_force, -SMatrix::identity(), 1.0));
    Deviation::worst("forward_dynamics_derivatives", residuals)
}

/// Entries of the difference of B(q): V is quadratic in qd, so that its polarisation
/// `V(e_j + e_k) - V(e_j) - V(e_k)` is the column of the pair (j, k).
///
/// A column that is missing or too many is not a number.
fn coriolis_entries<const N: usize>(
    columns: &[SVector<f64, N>],
    numeric: &NewtonEuler<N>,
    q: &SVector<f64, N>,
    scale: f64,
) -> impl Iterator<Item = Entry> {
    let squares = centrifugal_coefficients(numeric, q);
    let pairs = (0..N).flat_map(|j| (j + 1..N).map(move |k| (j, k)));
    let expected: Vec<SVector<f64, N>> = pairs
        .map(|(j, k)| {
            let both = numeric.coriolis_vector(q, &(unit(j) + unit(k)));
            both - squares.column(j) - squares.column(k)
        })
        .collect();
    let missing = SVector::repeat(f64::NAN);
    let column =
        move |of: &[SVector<f64, N>], pair: usize| of.get(pair).copied().unwrap_or(missing);
    (0..columns.len().max(expected.len())).flat_map(move |pair| {
        let difference = column(columns, pair) - column(&expected, pair);
        (0..N).map(move |joint| Entry {
            joint: Some(joint),
            difference: difference[joint],
            scale,
        })
    })
}

/// C(q): column j is V at the unit velocity of joint j.
fn centrifugal_coefficients<const N: usize>(
    numeric: &NewtonEuler<N>,
    q: &SVector<f64, N>,
) -> SMatrix<f64, N, N> {
    let mut coefficients = SMatrix::<f64, N, N>::zeros();
    for j in 0..N {
        coefficients.set_column(j, &numeric.coriolis_vector(q, &unit(j)));
    }
    coefficients
}

fn unit<const N: usize>(joint: usize) -> SVector<f64, N> {
    SVector::from_fn(|i, _| if i == joint { 1.0 } else { 0.0 })
}

/// Entries of a transform's difference: those of the rotation are of size 1.
fn pose_entries(
    joint: Option<usize>,
    difference: Matrix4<f64>,
    position: f64,
) -> impl Iterator<Item = Entry> {
    (0..4).flat_map(move |row| {
        (0..4).map(move |column| Entry {
            joint,
            difference: difference[(row, column)],
            scale: if row < 3 && column == 3 {
                position
            } else {
                1.0
            },
        })
    })
}

/// Entries of a Jacobian's difference: axes are of size 1, velocities of revolute joints as large
/// as the distance from their axis.
fn jacobian_entries<const N: usize>(
    table: &Table<N>,
    difference: &SMatrix<f64, 6, N>,
    position: f64,
) -> impl Iterator<Item = Entry> {
    (0..N).flat_map(move |joint| {
        let revolute = table.rows[joint].joint_type == JointType::Revolute;
        (0..6).map(move |row| Entry {
            joint: Some(joint),
            difference: difference[(row, joint)],
            scale: if row < 3 && revolute { position } else { 1.0 },
        })
    })
}

/// Entries of a matrix whose row i belongs to joint i.
fn entries<const R: usize, const C: usize>(
    difference: SMatrix<f64, R, C>,
    scale: f64,
) -> impl Iterator<Item = Entry> {
    (0..R).flat_map(move |row| {
        (0..C).map(move |column| Entry {
            joint: Some(row),
            difference: difference[(row, column)],
            scale,
        })
    })
}

/// One entry of a difference, and the magnitude that the entry could have.
struct Entry {
    joint: Option<usize>,
    difference: f64,
    scale: f64,
}

impl Entry {
    /// Where the scale is zero nothing but an exact agreement will do.
    fn relative(&self) -> f64 {
        if self.difference == 0.0 {
            return 0.0;
        }
        let relative = self.difference.abs() / self.scale;
        if relative.is_nan() {
            f64::INFINITY
        } else {
            relative
        }
    }
}

impl Deviation {
    fn worst(function: &'static str, entries: impl Iterator<Item = Entry>) -> Self {
        let mut worst = (0.0, None);
        for entry in entries {
            let error = entry.relative();
            if error > worst.0 {
                worst = (error, entry.joint);
            }
        }
        Deviation {
            function,
            error: Some(worst.0),
            joint: worst.1,
        }
    }

    /// Row i belongs to joint i.
    fn of_matrix<const R: usize, const C: usize>(
        function: &'static str,
        difference: &SMatrix<f64, R, C>,
        scale: f64,
    ) -> Self {
        Deviation::worst(function, entries(*difference, scale))
    }

    fn of_number(function: &'static str, difference: f64, scale: f64) -> Self {
        let entry = Entry {
            joint: None,
            difference,
            scale,
        };
        Deviation::worst(function, core::iter::once(entry))
    }
}
