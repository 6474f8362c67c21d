//! The table by which each function is compared with Newton-Euler.

use dynamics_runtime::internal::flat;
use dynamics_runtime::{Evaluation, State};

use super::accelerations::{
    acceleration_derivatives, accelerations, refused, series_residuals, task_space,
};
use super::at::{At, Unit};
use super::deviation::{Deviation, Entry, Measured};

/// A row of the table: a function, or a form that two functions make together, and its comparison.
pub(super) struct Row<T> {
    pub(super) name: &'static str,
    pub(super) rule: Rule<T>,
}

/// How the value of a function is compared. Values are lists of numbers, matrices by columns.
pub(super) enum Rule<T> {
    /// With a numeric value, entry by entry: the unit of each entry is what its error is relative to.
    Beside(fn(&At<'_>) -> Vec<f64>, fn(&At<'_>, usize) -> Unit),
    /// By the equations that it satisfies, as far as it does not. `None` if M cannot be solved with.
    Solves(fn(&At<'_>, &[T]) -> Option<Vec<Entry>>),
    /// As one factor of these forms alone. Without the other factor, which is named, it is not compared.
    FactorOf(&'static [&'static str], &'static str),
}

/// Writes the table: `at` is the state, `k` the number of an entry.
macro_rules! table {
    ($at:ident, $k:ident; $($name:ident: $rule:ident($($columns:tt)*),)*) => {
        #[allow(unused_variables, reason = "some units are the same for all entries")]
        impl<T: Measured> Row<T> {
            /// Every function, in the order of the documentation.
            pub(super) const ALL: &'static [Row<T>] = &[$(Row {
                name: stringify!($name),
                rule: table!(@$rule $at $k $($columns)*),
            }),*];
        }
    };
    (@beside $at:ident $k:ident $numeric:expr, $unit:expr) => {
        Rule::Beside(|$at| flat(&$numeric), |$at, $k| $unit)
    };
    (@solves $at:ident $k:ident $residuals:ident) => {
        Rule::Solves($residuals)
    };
    (@factor_of $at:ident $k:ident $($form:ident)*, without $other:ident) => {
        Rule::FactorOf(&[$(stringify!($form)),*], stringify!($other))
    };
}

table! { at, k;
    mass_matrix: beside(at.mass_matrix.clone(), at.joint(k, at.scale.mass_matrix)),
    coriolis_vector: beside(at.robot.coriolis_vector(at.q, at.qd), at.joint(k, at.scale.coriolis_vector)),
    gravity_vector: beside(at.robot.gravity_vector(at.q), at.joint(k, at.scale.gravity_vector)),
    friction_vector: beside(at.robot.friction_vector(at.qd), at.joint(k, at.scale.friction_vector)),
    spring_vector: beside(at.robot.spring_vector(at.q), at.joint(k, at.scale.spring_vector)),
    inverse_dynamics: beside(at.tau.clone(), at.joint(k, at.scale.inverse_dynamics)),
    forward_dynamics: solves(accelerations),
    kinetic_energy: beside(at.robot.kinetic_energy(at.q, at.qd), (at.scale.coriolis_vector, None)),
    potential_energy: beside(at.robot.potential_energy(at.q), (at.scale.potential_energy, None)),
    bias_force: beside(at.robot.bias_force(at.q, at.qd), at.joint(k, at.scale.bias_force)),
    coriolis_matrix: beside(at.robot.coriolis_matrix(at.q, at.qd), at.joint(k, at.scale.coriolis_matrix)),
    coriolis_coefficients: beside(at.coriolis_coefficients(), at.joint(k, at.scale.mass_matrix)),
    centrifugal_coefficients: beside(at.centrifugal_coefficients(), at.joint(k, at.scale.mass_matrix)),
    configuration_space_form: beside(
        at.robot.coriolis_vector(at.q, at.qd), at.joint(k, at.scale.coriolis_vector)
    ),
    forward_kinematics: beside(at.tip_pose(), (at.pose(k), None)),
    link_poses: beside(at.robot.link_poses(at.q), at.each_joint(k, 16, at.pose(k))),
    jacobian: beside(at.tip_jacobian(), at.column(k)),
    regressor_form: beside(at.tau - at.joint_forces(), at.joint(k, at.scale.inverse_dynamics)),
    inverse_dynamics_derivatives: beside(
        at.robot.inverse_dynamics_derivatives(at.q, at.qd, at.qdd),
        at.joint(k, if k < at.freedoms() * at.freedoms() { at.scale.force_by_position } else { at.scale.force_by_velocity })
    ),
    forward_dynamics_derivatives: solves(acceleration_derivatives),
    forward_dynamics_aba: solves(accelerations),
    taylor_series: solves(series_residuals),
    wrench_torques: beside(
        at.tip_jacobian().transpose() * State::<0>::wrench(),
        at.joint(k, State::<0>::wrench().amax() * at.scale.position.max(1.0))
    ),
    tool_velocity: beside(at.tip_jacobian() * at.qd, at.tip(k, at.qd.amax())),
    tool_acceleration: beside(
        at.tip_jacobian() * at.qdd + at.tip_jacobian_rate() * at.qd,
        at.tip(k, at.qdd.amax() + at.qd.amax() * at.qd.amax())
    ),
    jacobian_rate: beside(at.tip_jacobian_rate(), at.tip(k, at.qd.amax())),
    link_jacobians: beside(at.robot.link_jacobians(at.q), at.column(k)),
    center_of_mass: beside(at.robot.center_of_mass(at.q), (at.scale.position, None)),
    center_of_mass_jacobian: beside(
        at.robot.center_of_mass_jacobian(at.q), (at.scale.position.max(1.0), None)
    ),
    centroidal_momentum_matrix: beside(at.robot.centroidal_momentum_matrix(at.q), at.momentum(k)),
    centroidal_momentum_bias: beside(at.robot.centroidal_momentum_bias(at.q, at.qd), at.momentum_rate(k)),
    operational_inertia_inverse: solves(task_space),
    generalized_momentum: beside(&at.mass_matrix * at.qd, at.joint(k, at.scale.coriolis_matrix)),
    momentum_bias: beside(
        at.robot.coriolis_matrix(at.q, at.qd).transpose() * at.qd
            - (at.robot.gravity_vector(at.q) + at.joint_forces()),
        at.joint(k, at.scale.bias_force)
    ),
    passivity_torque: beside(at.passivity() + at.joint_forces(), at.joint(k, at.scale.passivity_torque)),
    passivity_form: beside(at.passivity(), at.joint(k, at.scale.passivity_torque)),
    energies_form: beside(
        (at.robot.kinetic_energy(at.q, at.qd), at.gravity_energy() + at.datum),
        (if k == 0 { at.scale.coriolis_vector } else { at.scale.potential_energy }, None)
    ),
    inverse_dynamics_rates: beside(
        at.rates(),
        at.joint(k, at.scale.rates(at.state)[usize::from(k >= at.freedoms())])
    ),
    inverse_dynamics_second_derivatives: beside(
        at.robot.inverse_dynamics_second_derivatives(at.q, at.qd, at.qdd),
        (at.scale.second_derivatives()[k / at.freedoms().pow(3) % 4], Some(k / at.freedoms().pow(2) % at.freedoms()))
    ),
    passivity_regressor: factor_of(passivity_form, without base_parameters),
    energy_regressors: factor_of(energies_form, without base_parameters),
    regressor: factor_of(regressor_form, without base_parameters),
    base_parameters: factor_of(regressor_form passivity_form energies_form, without regressor),
}

/// Calls `found` for the deviation of every value, in the order of the table: first those of the whole robot and of its
/// tip, then those of each frame, with its name.
pub(super) fn for_deviations<T: Measured>(
    evaluation: &Evaluation<T>,
    at: &mut At<'_>,
    mut found: impl FnMut(Option<&str>, Deviation),
) {
    let whole = core::iter::once((None, None, evaluation));
    let frames = evaluation.at_frames();
    let frames = frames.map(|(name, frame, values)| (Some(name), Some(frame), values));
    for (name, frame, values) in whole.chain(frames) {
        at.frame = frame;
        for deviation in deviations(values, at) {
            found(name, deviation);
        }
    }
    at.frame = None;
}

/// The deviation of every value, in the order of the table.
pub(super) fn deviations<T: Measured>(evaluation: &Evaluation<T>, at: &At<'_>) -> Vec<Deviation> {
    let rows = Row::ALL.iter();
    rows.filter_map(|row| row.deviation(evaluation, at))
        .collect()
}

/// Why a function could be compared at no state.
pub(super) fn reason(function: &str) -> String {
    let mut rows = Row::<f64>::ALL.iter();
    match rows.find(|row| row.name == function) {
        Some(Row {
            rule: Rule::FactorOf(_, other),
            ..
        }) => format!("that takes `{other}` too"),
        Some(Row {
            rule: Rule::Beside(..),
            ..
        }) => "the table in numbers has no such frame".to_owned(),
        _ => "the mass matrix is singular".to_owned(),
    }
}

impl<T: Measured> Row<T> {
    /// The deviation; `None` if there is no value.
    pub(super) fn deviation(&self, evaluation: &Evaluation<T>, at: &At<'_>) -> Option<Deviation> {
        let found = match evaluation.entries(self.name)? {
            Ok(_) if !at.has_frame() => return Some(Deviation::not_compared(self.name)),
            Ok(found) => found,
            Err(error) => return Some(refused(self.name, &at.mass_matrix, error)),
        };
        let is_compared = |form: &&str| evaluation.entries(form).is_some();
        let entries = match self.rule {
            Rule::Beside(numeric, unit) => Some(differences(found, &numeric(at), |k| unit(at, k))),
            Rule::Solves(residuals) => residuals(at, found),
            Rule::FactorOf(forms, _) if forms.iter().any(is_compared) => return None,
            Rule::FactorOf(..) => None,
        };
        Some(match entries {
            Some(entries) => Deviation::worst(self.name, entries.into_iter()),
            None => Deviation::not_compared(self.name),
        })
    }
}

/// The entries of a difference. An entry that is missing or too many is not a number.
fn differences<T: Measured>(
    found: &[T],
    expected: &[f64],
    unit: impl Fn(usize) -> Unit,
) -> Vec<Entry> {
    let number = |x: Option<T>| x.unwrap_or(T::of(f64::NAN));
    let entry = |k: usize| {
        let expected = expected.get(k).map(|x| T::of(*x));
        let difference = number(found.get(k).copied()) - number(expected);
        let (scale, joint) = unit(k);
        Entry::new(joint, difference, scale)
    };
    (0..found.len().max(expected.len())).map(entry).collect()
}
