//! From identified base parameters to a robot that has them.
//!
//! Torques show the base parameters b = K x of an arm alone, not all of the links' own parameters x. The links with the
//! identified b that are nearest to the table's are `x = x0 + W (K W)^+ (b - K x0)`. By the weights W first moments
//! and tensors change rather than masses and motors. If no bodies have these x, the nearest that bodies have are searched
//! for ([`crate::possible`]; C. D. Sousa, R. Cortesao, Int. J. Robotics Research 33 (2014), 931-944).

use core::fmt;
use core::ops::Range;

use dynamics_numeric::check::base_parameter_map_any;
use dynamics_runtime::nalgebra::{DMatrix, DVector, Matrix3};
use dynamics_runtime::{
    StandardParameters,
    table::{Convention, JointType, Row, RuntimeTable},
};
use dynamics_symbolic::exact::SplitMix64;
use dynamics_symbolic::robot::{Robot, Value};

use crate::compiled::check_length;
use crate::possible::{OF_LINK, Part, Search};
use crate::{BuildError, EvaluationError, RuntimeRobot};

/// The distance that a mass or a motor moves beside a first moment or an entry of a tensor.
const WEIGHT_OF_MASS: f64 = 1e-3;

/// The rounding of a moment of inertia, relative to those about the origin.
const ROUNDING: f64 = 1e-9;

/// Why there is no robot with the base parameters that were identified.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum IdentificationError {
    /// The robot has no regressor, there are more or fewer base parameters than it has, or one is not a number.
    Values(EvaluationError),
    /// A base parameter is not a finite number: its index.
    NotFinite(usize),
    /// A field of the robot has no value, or none that is finite: its name.
    Field(String),
    /// The columns of the regressor are dependent: no set of base parameters is the only one. Special values of fields may
    /// do that, such as a factor of zero by which a joint follows another.
    Dependent,
    /// No bodies have these base parameters, however their masses are distributed, or they are too large for numbers:
    /// the links that would be none of bodies if the table's were changed by the least.
    /// [`RuntimeRobot::nearest_possible`] has the nearest base parameters that bodies have.
    Impossible(Vec<ImpossibleLink>),
    /// A coefficient of friction of the joint of this name is negative or not finite.
    Friction(String, f64),
    /// The robot could not be made.
    Build(BuildError),
}

/// A link that no body is: its pseudo-inertia matrix is not positive semidefinite. Its mass is negative, or a principal
/// moment of its inertia is negative or greater than the sum of the other two.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ImpossibleLink {
    /// The name of the link's joint.
    pub joint: String,
    /// The mass, kg.
    pub mass: f64,
    /// The principal moments of inertia about the centre of mass, kg m^2, the least first.
    pub moments: [f64; 3],
}

impl fmt::Display for ImpossibleLink {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (joint, [a, b, c]) = (&self.joint, self.moments);
        write!(f, "the link of `{joint}` would have ")?;
        if self.mass < 0.0 {
            return write!(f, "a mass of {:.3e} kg", self.mass);
        }
        let moments = "principal moments of inertia of";
        write!(f, "{moments} {a:.3e}, {b:.3e} and {c:.3e} kg m^2")
    }
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
            IdentificationError::Impossible(links) => {
                let links: Vec<_> = links.iter().map(ImpossibleLink::to_string).collect();
                write!(
                    f,
                    "no bodies have these base parameters: {} (masses are positive, and no principal moment is negative \
                     or greater than the sum of the other two). `nearest_possible` has the nearest that bodies have",
                    links.join("; ")
                )
            }
            IdentificationError::Friction(joint, coefficient) => write!(
                f,
                "the friction of `{joint}` has the coefficient {coefficient}: expected a finite number, 0 or above"
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

/// The friction of a joint as it was identified: `viscous qd + coulomb sign(qd)`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct JointFriction {
    /// The viscous coefficient, N m s or N s/m.
    pub viscous: f64,
    /// Coulomb friction of positive velocities and of negative ones, N m or N, neither below zero.
    pub coulomb: [f64; 2],
}

impl JointFriction {
    /// Friction with these coefficients: viscous, then Coulomb's of positive and of negative velocities.
    pub const fn new(viscous: f64, coulomb: [f64; 2]) -> Self {
        JointFriction { viscous, coulomb }
    }
}

/// Base parameters that bodies have: see [`RuntimeRobot::nearest_possible`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct NearestPossible {
    /// The base parameters, in the order of `base_parameters`.
    pub base_parameters: Vec<f64>,
    /// Their distance from the given ones: the root mean square of the difference in torque, N m or N.
    pub torque: f64,
}

/// The equations `K (p - own) = missing` for the parameters p of links and motors.
struct Equations {
    map: DMatrix<f64>,
    /// The rows of the table of all links, and, in the same order, of all motors.
    rows: Vec<usize>,
    /// The parameters in the rows: locked links and the tool, which are fixed to some, do not change.
    own: DVector<f64>,
    missing: DVector<f64>,
}

impl RuntimeRobot {
    /// The robot with these base parameters, as an identification finds them, in the order of
    /// `base_parameters`; its functions are those of this one, derived and proven anew, and its fields have
    /// their present values.
    ///
    /// Links are changed by as little as that takes, masses and motors least of all. If one would be no body's, the nearest
    /// links and motors of bodies with these base parameters are taken. Their distance from the table's is the entropic
    /// divergence of pseudo-inertia matrices (Lee, Wensing, Park 2020). A table with such links of its own is
    /// changed by the least in any case. Springs and friction stay as they are.
    ///
    /// # Errors
    ///
    /// [`IdentificationError`]: `regressor` was not requested, another number of values, a value or a field that is
    /// not finite, or base parameters that no bodies have.
    pub fn identified(&self, base_parameters: &[f64]) -> Result<RuntimeRobot, IdentificationError> {
        self.with_parameters(base_parameters, |_| Ok(()))
    }

    /// [`identified`](RuntimeRobot::identified), with an identified friction in place of all friction of the table, that of
    /// Stribeck and of joints that follow others, too.
    ///
    /// # Errors
    ///
    /// The errors of [`identified`](RuntimeRobot::identified), also if `friction` has not one entry for each joint that
    /// moves. [`IdentificationError::Friction`] for a coefficient that is below zero, as noise may make it, or not finite.
    pub fn identified_with_friction(
        &self,
        base_parameters: &[f64],
        friction: &[JointFriction],
    ) -> Result<RuntimeRobot, IdentificationError> {
        check_length("friction", friction.len(), self.dof())?;
        self.with_parameters(base_parameters, |robot| {
            let mut given = friction.iter();
            for row in robot.rows.iter_mut().filter(|row| row.locked.is_none()) {
                let own = row.is_free().then(|| given.next()).flatten();
                let JointFriction { viscous, coulomb } = own.copied().unwrap_or_default();
                let value = |x: f64| {
                    let value = Value::from_f64(x).filter(|_| x >= 0.0);
                    value.ok_or_else(|| IdentificationError::Friction(row.name.clone(), x))
                };
                (row.viscous, row.stribeck) = (value(viscous)?, None);
                row.coulomb = [value(coulomb[0])?, value(coulomb[1])?];
            }
            Ok(())
        })
    }

    /// The base parameters nearest to these that bodies can have; these themselves where bodies can have them. Hand them
    /// to [`identified`](RuntimeRobot::identified).
    ///
    /// The distance is the root mean square of the difference in torque over all joints and 100 random states: positions
    /// within pi, velocities within 3, accelerations within 10. It is within 5 % of the least one. The residual r of least
    /// squares over a motion as fast as that grows to at most about `sqrt(r^2 + distance^2)`.
    ///
    /// # Errors
    ///
    /// The errors of [`identified`](RuntimeRobot::identified), but impossible base parameters are errors only where they are too
    /// large for numbers.
    pub fn nearest_possible(
        &self,
        base_parameters: &[f64],
    ) -> Result<NearestPossible, IdentificationError> {
        let equations = self.equations(base_parameters)?;
        let (parameters, residual) = self.links(&equations, &equations.least_change())?;
        let given = DVector::from_column_slice(base_parameters);
        let moved = &equations.map * (parameters - &equations.own) - &equations.missing;
        let torque = residual.norm();
        let nearest = if torque > 0.0 { given + moved } else { given };
        Ok(NearestPossible {
            base_parameters: nearest.as_slice().to_vec(),
            torque,
        })
    }

    /// The robot with these base parameters and another change.
    fn with_parameters(
        &self,
        base_parameters: &[f64],
        change: impl FnOnce(&mut Robot) -> Result<(), IdentificationError>,
    ) -> Result<RuntimeRobot, IdentificationError> {
        let mut robot = self.robot().clone();
        let equations = self.equations(base_parameters)?;
        let least = equations.least_change();
        let (parameters, residual) = self.links(&equations, &least)?;
        let impossible = || IdentificationError::Impossible(equations.impossible(&robot, &least));
        if residual.amax() > 0.0 {
            return Err(impossible());
        }
        let written = equations.robot_with(&robot, self.fields(), &parameters);
        robot = written.ok_or_else(impossible)?;
        change(&mut robot)?;
        let functions = self.functions().iter();
        let requests = functions.map(|function| function.request.clone());
        let identified = RuntimeRobot::new(robot, requests);
        let mut identified = identified.map_err(IdentificationError::Build)?;
        identified.set_fields(self.fields())?;
        Ok(identified)
    }

    /// The equations of these base parameters.
    fn equations(&self, base_parameters: &[f64]) -> Result<Equations, IdentificationError> {
        let expected = self.entries("regressor")? / self.dof();
        check_length("base_parameters", base_parameters.len(), expected)?;
        if let Some(index) = base_parameters.iter().position(|b| !b.is_finite()) {
            return Err(IdentificationError::NotFinite(index));
        }
        let mut fields = self.field_names().iter().zip(self.fields());
        if let Some((name, _)) = fields.find(|(_, value)| !value.is_finite()) {
            return Err(IdentificationError::Field(name.clone()));
        }
        let map = base_parameter_map_any(self).ok_or(IdentificationError::Dependent)?;
        let of_robot = &self.robot().rows;
        let (mut rows, followers): (Vec<usize>, Vec<usize>) = (0..of_robot.len())
            .filter(|&row| of_robot[row].locked.is_none())
            .partition(|&row| of_robot[row].is_free());
        rows.extend(followers);
        let mut own = parameters_of_table(&self.table());
        let missing = DVector::from_column_slice(base_parameters) - &map * &own;
        for (k, &row) in rows.iter().enumerate() {
            let number = |value: &Value| value.to_f64(self.fields());
            let row = &of_robot[row];
            let com = row.com.each_ref().map(number);
            let link = parameters(number(&row.mass), com, row.inertia.each_ref().map(number));
            own.rows_mut(OF_LINK * k, OF_LINK).copy_from(&link);
        }
        Ok(Equations {
            map,
            rows,
            own,
            missing,
        })
    }

    /// The links and motors, nearest to the table's, and by how much they miss the base parameters: `least` where these
    /// are bodies, or where the table's are none.
    fn links(
        &self,
        equations: &Equations,
        least: &DVector<f64>,
    ) -> Result<(DVector<f64>, DVector<f64>), IdentificationError> {
        let impossible = |parameters| equations.impossible(self.robot(), parameters);
        if impossible(least).is_empty() || !impossible(&equations.own).is_empty() {
            return Ok((least.clone(), DVector::zeros(1)));
        }
        let nearest = equations.nearest(&self.torques()?);
        nearest.ok_or_else(|| IdentificationError::Impossible(impossible(least)))
    }

    /// The matrix R with `|R b|^2` the mean square of the torques `Y b` over random states and all joints.
    fn torques(&self) -> Result<DMatrix<f64>, IdentificationError> {
        const STATES: usize = 100;
        let joints = self.dof();
        let mut random = SplitMix64::new(1);
        let [q, qd, qdd] = [core::f64::consts::PI, 3.0, 10.0].map(|largest| {
            let numbers = (0..STATES * joints).map(|_| largest * (2.0 * random.unit() - 1.0));
            numbers.collect::<Vec<f64>>()
        });
        let entries = self.entries("regressor")?;
        let mut values = vec![0.0; STATES * entries];
        self.batch("regressor", &[&q, &qd, &qdd], &mut values)?;
        let share = 1.0 / ((STATES * joints) as f64).sqrt();
        let y = DMatrix::from_fn(STATES * joints, entries / joints, |row, column| {
            share * values[row / joints * entries + column * joints + row % joints]
        });
        Ok(y.qr().r())
    }
}

impl Equations {
    /// The columns of each link, then of each motor.
    fn columns(&self) -> impl Iterator<Item = Range<usize>> {
        let links = self.rows.len();
        let link = |k: usize| OF_LINK * k..OF_LINK * (k + 1);
        let motor = move |k: usize| OF_LINK * links + k..OF_LINK * links + k + 1;
        (0..links).map(link).chain((0..links).map(motor))
    }

    /// The links and motors with the base parameters by the least change of the table's.
    fn least_change(&self) -> DVector<f64> {
        let links = OF_LINK * self.rows.len();
        let weights = DVector::from_fn(self.own.len(), |k, _| match k < links {
            true if !k.is_multiple_of(OF_LINK) => 1.0,
            // An arm without a motor gets none.
            false if self.own[k] == 0.0 => 0.0,
            _ => WEIGHT_OF_MASS,
        });
        let mut weighted = self.map.clone();
        for (mut column, weight) in weighted.column_iter_mut().zip(&weights) {
            column *= *weight;
        }
        let inverse = weighted.clone().pseudo_inverse(1e-12);
        let steps = inverse.map_or_else(|_| &self.own * 0.0, |inverse| inverse * &self.missing);
        let change = |k: usize| {
            let is_shown = weighted.column(k).amax() > 0.0;
            if is_shown { weights[k] * steps[k] } else { 0.0 }
        };
        DVector::from_fn(self.own.len(), |k, _| self.own[k] + change(k))
    }

    /// The links that no bodies are.
    fn impossible(&self, robot: &Robot, parameters: &DVector<f64>) -> Vec<ImpossibleLink> {
        let link = |(&row, columns): (&usize, Range<usize>)| {
            let (mass, moments) = impossible(&parameters.as_slice()[columns])?;
            let joint = robot.rows[row].name.clone();
            Some(ImpossibleLink {
                joint,
                mass,
                moments,
            })
        };
        let links = self.rows.iter().zip(self.columns());
        links.filter_map(link).collect()
    }

    /// The links and motors of bodies with the base parameters, or nearest to them in torque, and the residual.
    fn nearest(&self, torques: &DMatrix<f64>) -> Option<(DVector<f64>, DVector<f64>)> {
        let own = self.own.as_slice();
        let links = &own[..OF_LINK * self.rows.len()];
        let sum = |k: usize| links.iter().skip(k).step_by(OF_LINK).sum::<f64>();
        let (mass, second) = (sum(0), 0.5 * (sum(4) + sum(5) + sum(6)));
        let typical = if mass > 0.0 && second > 0.0 {
            (mass / self.rows.len() as f64, (second / mass).sqrt())
        } else {
            (1.0, 0.1)
        };
        let is_shown = |columns: &Range<usize>| {
            self.map.columns_range(columns.clone()).amax() > 0.0
                && (columns.len() > 1 || own[columns.start] > 0.0)
        };
        let shown: Vec<_> = self.columns().filter(is_shown).collect();
        let parts = shown
            .iter()
            .map(|columns| Part::new(&own[columns.clone()], typical));
        let columns: Vec<usize> = shown.iter().cloned().flatten().collect();
        let search = Search {
            parts: parts.collect::<Option<_>>()?,
            map: torques * self.map.select_columns(&columns),
            start: self.own.select_rows(&columns),
            missing: torques * &self.missing,
        };
        let (found, residual) = search.nearest()?;
        let mut parameters = self.own.clone();
        for (column, value) in columns.iter().zip(&found) {
            parameters[*column] = *value;
        }
        Some((parameters, residual))
    }

    /// The robot with these links and motors, where their numbers are finite.
    fn robot_with(
        &self,
        robot: &Robot,
        fields: &[f64],
        parameters: &DVector<f64>,
    ) -> Option<Robot> {
        let mut robot = robot.clone();
        for (columns, &row) in self.columns().zip(self.rows.iter().chain(&self.rows)) {
            let p = &parameters.as_slice()[columns.clone()];
            let row = &mut robot.rows[row];
            if *p == self.own.as_slice()[columns] {
                continue;
            }
            if let [reflected] = p {
                let ratio = row.gear_ratio.to_f64(fields);
                row.motor_inertia = Value::from_f64(reflected / (ratio * ratio))?;
                continue;
            }
            let (com, inertia) = about_center(p);
            row.mass = Value::from_f64(p[0])?;
            row.com = values(com)?;
            row.inertia = values(inertia)?;
        }
        Some(robot)
    }
}

fn values<const K: usize>(numbers: [f64; K]) -> Option<[Value; K]> {
    let values: Option<Vec<Value>> = numbers.into_iter().map(Value::from_f64).collect();
    values?.try_into().ok()
}

/// The parameters of the table: links, then motors, of joints and then of followers.
fn parameters_of_table(table: &RuntimeTable) -> DVector<f64> {
    let links = table.standard_parameters();
    let mut x: Vec<f64> = links.iter().flatten().copied().collect();
    let followers = table.followers().map(|follower| &follower.row);
    x.extend(
        table
            .rows
            .iter()
            .chain(followers)
            .map(Row::reflected_inertia),
    );
    DVector::from(x)
}

/// The centre of mass of a link and the tensor I about it, from the tensor J about the origin of the link frame:
/// `J = I + m (c.c 1 - c c^T)`.
fn about_center(p: &[f64]) -> ([f64; 3], [f64; 6]) {
    let com = [1, 2, 3].map(|k| if p[k] == 0.0 { 0.0 } else { p[k] / p[0] });
    let of_point = parameters(p[0], com, [0.0; 6]);
    (com, core::array::from_fn(|k| p[4 + k] - of_point[4 + k]))
}

/// The mass and the principal moments of a link that no body is.
fn impossible(p: &[f64]) -> Option<(f64, [f64; 3])> {
    let (_, [xx, yy, zz, xy, yz, xz]) = about_center(p);
    let mut moments = [f64::NEG_INFINITY; 3];
    if p[0] > 0.0 || p[1..4] == [0.0; 3] {
        let tensor = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        moments = tensor.symmetric_eigenvalues().into();
    }
    moments.sort_by(f64::total_cmp);
    let [a, b, c] = moments;
    let rounding = ROUNDING * (p[4] + p[5] + p[6]).abs();
    let is_possible = p[0] >= 0.0 && a.min(a + b - c) >= -rounding;
    (!is_possible).then_some((p[0], moments))
}

/// The standard parameters of a link.
fn parameters(mass: f64, com: [f64; 3], inertia: [f64; 6]) -> StandardParameters {
    let row = Row {
        mass,
        com,
        inertia,
        ..Row::new(JointType::Revolute)
    };
    RuntimeTable::new(Convention::Modified, [0.0; 3], vec![row]).standard_parameters()[0]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_moment_needs_a_mass() {
        let mut link = [0.0; OF_LINK];
        assert_eq!(impossible(&link), None);
        (link[4], link[5], link[6]) = (0.25, 0.25, 0.25);
        assert_eq!(impossible(&link), None);
        for mass in [0.0, -1.0] {
            (link[0], link[1]) = (mass, 0.5);
            assert_eq!(impossible(&link).expect("no body").0, mass);
        }
    }

    #[test]
    fn a_principal_moment_is_no_greater_than_the_sum_of_the_others() {
        let link = |zz: f64| parameters(2.0, [0.3, -0.1, 0.2], [0.1, 0.2, zz, 0.0, 0.0, 0.0]);
        for zz in [0.1, 0.2, 0.3] {
            assert_eq!(impossible(link(zz).as_slice()), None, "{zz}");
        }
        for zz in [-0.01, 0.09, 0.31] {
            let (mass, moments) = impossible(link(zz).as_slice()).expect("no body");
            let mut expected = [0.1, 0.2, zz];
            expected.sort_by(f64::total_cmp);
            assert!(mass == 2.0 && (0..3).all(|k| (moments[k] - expected[k]).abs() < 1e-14));
        }
    }
}
