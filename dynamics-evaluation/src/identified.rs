//! From identified base parameters to a robot that has them.
//!
//! Torques show the base parameters b = K x of an arm alone, not all of the links' own parameters x. Of all
//! sets of links with the identified b, those are taken that are nearest to the table's:
//! `x = x0 + W (K W)^+ (b - K x0)`, with a weight in W that lets masses stay where first moments and tensors
//! can make the difference.

use core::fmt;

use dynamics_runtime::nalgebra::{DMatrix, DVector};
use dynamics_runtime::{Convention, JointType, StandardParameters, Table, base_parameter_map};
use dynamics_symbolic::robot::{Row, Value};

use crate::typed::Typed;
use crate::{BuildError, EvaluationError, RuntimeRobot};

/// Parameters of a link: its mass, first moments and tensor about the origin of its frame.
const OF_LINK: usize = 10;

/// How far a mass moves beside a first moment or an entry of a tensor.
const WEIGHT_OF_MASS: f64 = 1e-3;

/// Why there is no robot with the base parameters that were identified.
#[derive(Clone, Debug, PartialEq)]
pub enum IdentificationError {
    /// The robot has no regressor, there are more or fewer base parameters than it has, or one is not a number.
    Values(EvaluationError),
    /// A base parameter is not a finite number: its index.
    NotFinite(usize),
    /// A field of the robot has no value, or none that is finite: its name.
    Field(String),
    /// The columns of the regressor are dependent, as they may be for special values of fields, such as a factor
    /// of zero by which a joint follows another: no set of base parameters is the only one.
    Dependent,
    /// The link of this joint needs a positive mass for its centre of mass, and would have another one: give it
    /// a mass in the table.
    Mass {
        /// The joint's name.
        joint: String,
        /// The mass that it would have, kg.
        mass: f64,
    },
    /// The robot could not be made.
    Build(BuildError),
}

impl fmt::Display for IdentificationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            IdentificationError::Values(error) => error.fmt(f),
            IdentificationError::NotFinite(index) => {
                write!(
                    f,
                    "base parameter {index} is not finite: expected kg, kg m or kg m^2"
                )
            }
            IdentificationError::Field(name) => {
                write!(f, "field `{name}` has no finite value: give it one first")
            }
            IdentificationError::Dependent => write!(
                f,
                "the regressor's columns are dependent: no set of base parameters is the only one"
            ),
            IdentificationError::Mass { joint, mass } => write!(
                f,
                "the link of `{joint}` would have a mass of {mass} kg: give it one in the table that is near the real one"
            ),
            IdentificationError::Build(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for IdentificationError {}

impl From<EvaluationError> for IdentificationError {
    fn from(error: EvaluationError) -> Self {
        IdentificationError::Values(error)
    }
}

impl<const N: usize> Typed<'_, N> {
    /// The robot with these base parameters, as an identification finds them, in the order of
    /// `base_parameters`; its functions are those of this one, derived and proven anew, and its fields have
    /// their present values.
    ///
    /// Links are changed by as little as that takes, masses least of all. What no torque shows stays as the table
    /// has it, so that a link may well be none that a body can have, and yet move as the real one. Motors, springs
    /// and friction stay as they are.
    ///
    /// # Errors
    ///
    /// [`IdentificationError`]: `regressor` was not asked for, another number of values, a value or a field that is
    /// not finite, or a link without mass that would need one.
    pub fn identified(&self, base_parameters: &[f64]) -> Result<RuntimeRobot, IdentificationError> {
        let arm = self.arm;
        let expected = arm.entries("regressor")? / N;
        if base_parameters.len() != expected {
            return Err(IdentificationError::Values(EvaluationError::Length {
                argument: "base_parameters",
                found: base_parameters.len(),
                expected,
            }));
        }
        if let Some(index) = base_parameters.iter().position(|b| !b.is_finite()) {
            return Err(IdentificationError::NotFinite(index));
        }
        let mut fields = arm.field_names().iter().zip(arm.fields());
        if let Some((name, _)) = fields.find(|(_, value)| !value.is_finite()) {
            return Err(IdentificationError::Field(name.clone()));
        }
        let map = base_parameter_map(self).ok_or(IdentificationError::Dependent)?;
        let changes = changes(&map, &self.table, base_parameters);
        let mut robot = arm.robot().clone();
        let (joints, followers): (Vec<usize>, Vec<usize>) = (0..robot.rows.len())
            .filter(|&row| robot.rows[row].locked.is_none())
            .partition(|&row| robot.rows[row].is_free());
        for (link, row) in joints.into_iter().chain(followers).enumerate() {
            let change = changes.rows(OF_LINK * link, OF_LINK);
            change_link(&mut robot.rows[row], arm.fields(), change.as_slice())?;
        }
        let requests = arm
            .functions()
            .iter()
            .map(|function| function.request.clone());
        let mut identified =
            RuntimeRobot::new(robot, requests).map_err(IdentificationError::Build)?;
        identified.set_fields(arm.fields())?;
        Ok(identified)
    }
}

/// What is added to the parameters of all links.
fn changes<const N: usize>(
    map: &DMatrix<f64>,
    table: &Table<N>,
    base_parameters: &[f64],
) -> DVector<f64> {
    let links = table.standard_parameters().into_iter();
    let links = links.chain(table.standard_parameters_of_followers());
    let mut x: Vec<f64> = links.flat_map(|link| link.as_slice().to_vec()).collect();
    let of_links = x.len();
    x.extend(table.rows.iter().map(|row| row.reflected_inertia()));
    x.extend(
        table
            .followers
            .iter()
            .map(|follower| follower.row.reflected_inertia()),
    );
    let missing = DVector::from_column_slice(base_parameters) - map * DVector::from(x);
    let weight = |parameter: usize| match parameter % OF_LINK {
        0 => WEIGHT_OF_MASS,
        _ => 1.0,
    };
    let mut weighted = map.columns(0, of_links).into_owned();
    for (parameter, mut column) in weighted.column_iter_mut().enumerate() {
        column *= weight(parameter);
    }
    let shown: Vec<bool> = weighted
        .column_iter()
        .map(|column| column.amax() > 0.0)
        .collect();
    let inverse = weighted
        .pseudo_inverse(1e-12)
        .unwrap_or_else(|_| DMatrix::zeros(of_links, map.nrows()));
    let steps = inverse * missing;
    DVector::from_fn(of_links, |parameter, _| match shown[parameter] {
        true => weight(parameter) * steps[parameter],
        false => 0.0,
    })
}

/// Adds a change to the parameters of a row's link. The change has the tensor J about the origin of the link frame, the
/// row has I about the centre of mass: `J = I + m (c.c 1 - c c^T)`.
fn change_link(row: &mut Row, fields: &[f64], change: &[f64]) -> Result<(), IdentificationError> {
    if change.iter().all(|&x| x == 0.0) {
        return Ok(());
    }
    let number = |value: &Value| value.to_f64(fields);
    let old_mass = number(&row.mass);
    let old_com = row.com.each_ref().map(number);
    let mass = old_mass + change[0];
    let moment = [0, 1, 2].map(|k| old_mass * old_com[k] + change[1 + k]);
    let is_placed = moment.iter().any(|&h| h != 0.0);
    if mass < 0.0 || (is_placed && mass == 0.0) {
        let joint = row.name.clone();
        return Err(IdentificationError::Mass { joint, mass });
    }
    let com = moment.map(|h| if is_placed { h / mass } else { 0.0 });
    let old_inertia = row.inertia.each_ref().map(number);
    let about_origin = parameters(old_mass, old_com, old_inertia);
    let of_point = parameters(mass, com, [0.0; 6]);
    let inertia: [f64; 6] =
        core::array::from_fn(|k| about_origin[4 + k] + change[4 + k] - of_point[4 + k]);
    let not_finite = || IdentificationError::Mass {
        joint: row.name.clone(),
        mass,
    };
    let value = |x: f64| Value::from_f64(x).ok_or_else(not_finite);
    let [x, y, z] = com;
    let com = [value(x)?, value(y)?, value(z)?];
    let [a, b, c, d, e, f] = inertia;
    let inertia = [
        value(a)?,
        value(b)?,
        value(c)?,
        value(d)?,
        value(e)?,
        value(f)?,
    ];
    (row.mass, row.com, row.inertia) = (value(mass)?, com, inertia);
    Ok(())
}

/// The standard parameters of a link.
fn parameters(mass: f64, com: [f64; 3], inertia: [f64; 6]) -> StandardParameters {
    let row = dynamics_runtime::Row {
        mass,
        com,
        inertia,
        ..dynamics_runtime::Row::new(JointType::Revolute)
    };
    let [parameters] = Table::new(Convention::Modified, [0.0; 3], [row]).standard_parameters();
    parameters
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_moment_needs_a_mass() {
        let mut row = arms::robot("one_link").rows.remove(0);
        (row.mass, row.com) = (Value::zero(), [(); 3].map(|()| Value::zero()));
        let mut change = [0.0; OF_LINK];
        change[4] = 0.25;
        assert_eq!(change_link(&mut row, &[], &change), Ok(()));
        for mass in [0.0, -1.0] {
            (change[0], change[1]) = (mass, 0.5);
            let joint = row.name.clone();
            let error = IdentificationError::Mass { joint, mass };
            assert_eq!(change_link(&mut row, &[], &change), Err(error));
        }
    }
}
