//! A robot whose functions are programs that are evaluated step by step.

use core::f64::consts::PI;

use dynamics_runtime::nalgebra::{Matrix4, SMatrix, SVector};
use dynamics_runtime::{
    AccelerationDerivatives, Convention, Evaluate, Evaluation, JointType, Model, Row, Scalar,
    SingularMassMatrix, State, Table, turned,
};
use dynamics_symbolic::Function;
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::program::{Arithmetic, Program, rounded_angle};
use dynamics_symbolic::robot::{self, Angle, Robot, Symbol, Value};

/// A robot, values of its fields, and its programs.
pub(crate) struct Interpreted<'a, const N: usize> {
    robot: &'a Robot,
    fields: &'a [f64],
    programs: &'a [(Function, Program)],
}

impl<'a, const N: usize> Interpreted<'a, N> {
    /// The robot has `N` joints.
    pub(crate) fn new(
        robot: &'a Robot,
        fields: &'a [f64],
        programs: &'a [(Function, Program)],
    ) -> Self {
        Interpreted {
            robot,
            fields,
            programs,
        }
    }

    fn number(&self, value: &Value) -> f64 {
        value.to_f64(self.fields)
    }

    /// An angle, as a generated table has it.
    fn angle(&self, value: &Value) -> f64 {
        if value.is_number() {
            return rounded_angle(value);
        }
        let parts = Angle::new(value);
        let rest = parts.rest.as_ref().map_or(0.0, |rest| self.number(rest));
        turned(rest, f64::from(parts.signed_quarter_turns()))
    }

    fn row(&self, row: &robot::Row) -> Row {
        let joint_type = match row.joint_type {
            robot::JointType::Revolute => JointType::Revolute,
            robot::JointType::Prismatic => JointType::Prismatic,
        };
        Row {
            a: self.number(&row.a),
            alpha: self.angle(&row.alpha),
            d: self.number(&row.d),
            theta: self.angle(&row.theta),
            mass: self.number(&row.mass),
            com: row.com.each_ref().map(|x| self.number(x)),
            inertia: row.inertia.each_ref().map(|x| self.number(x)),
            motor_inertia: self.number(&row.motor_inertia),
            gear_ratio: self.number(&row.gear_ratio),
            viscous: self.number(&row.viscous),
            coulomb: self.number(&row.coulomb),
            ..Row::new(joint_type)
        }
    }
}

impl<const N: usize> Model<N> for Interpreted<'_, N> {
    const JOINT_NAMES: [&'static str; N] = ["joint"; N];

    fn table(&self) -> Table<N> {
        Table {
            convention: match self.robot.convention {
                robot::Convention::Standard => Convention::Standard,
                robot::Convention::Modified => Convention::Modified,
            },
            gravity: self.robot.gravity.each_ref().map(|x| self.number(x)),
            rows: core::array::from_fn(|i| self.row(&self.robot.rows[i])),
        }
    }
}

/// Double precision at a state.
struct At<'a, const N: usize> {
    fields: &'a [f64],
    state: &'a State<N>,
    tau: &'a SVector<f64, N>,
}

impl<const N: usize> Arithmetic for At<'_, N> {
    type Number = f64;

    fn rational(&mut self, x: &Rational) -> f64 {
        x.to_f64().value()
    }

    fn symbol(&mut self, symbol: &Symbol) -> f64 {
        let State { q, qd, qdd } = self.state;
        match symbol {
            Symbol::Pi => PI,
            Symbol::Field(i) => self.fields[*i],
            Symbol::AngleSine(angle) => angle.to_f64(self.fields).sin(),
            Symbol::AngleCosine(angle) => angle.to_f64(self.fields).cos(),
            Symbol::Sine(i) => q[*i].sin(),
            Symbol::Cosine(i) => q[*i].cos(),
            Symbol::Position(i) => q[*i],
            Symbol::Velocity(i) => qd[*i],
            Symbol::Acceleration(i) => qdd[*i],
            Symbol::Force(i) => self.tau[*i],
            Symbol::VelocitySign(i) => Scalar::sign(qd[*i]),
        }
    }

    fn neg(&mut self, a: f64) -> f64 {
        -a
    }

    fn add(&mut self, a: f64, b: f64) -> f64 {
        a + b
    }

    fn mul(&mut self, a: f64, b: f64) -> f64 {
        a * b
    }

    fn div(&mut self, a: f64, b: f64) -> f64 {
        a / b
    }
}

/// Reads outputs one after the other, matrices by rows.
struct Outputs(std::vec::IntoIter<f64>);

impl Outputs {
    fn number(&mut self) -> f64 {
        self.0.next().expect("an output")
    }

    fn matrix<const R: usize, const C: usize>(&mut self) -> SMatrix<f64, R, C> {
        let mut matrix = SMatrix::zeros();
        for i in 0..R {
            for j in 0..C {
                matrix[(i, j)] = self.number();
            }
        }
        matrix
    }

    /// The columns of a matrix of `N` rows whose width is only known here.
    fn columns<const N: usize>(self) -> Vec<SVector<f64, N>> {
        let values: Vec<f64> = self.0.collect();
        let width = values.len() / N;
        (0..width)
            .map(|j| SVector::from_fn(|i, _| values[i * width + j]))
            .collect()
    }

    /// Pivots and the diagonal of M behind a value, which is none where a pivot fails.
    fn tested<T, const N: usize>(&mut self, value: T) -> Result<T, SingularMassMatrix> {
        let (pivots, diagonal) = (self.matrix::<N, 1>(), self.matrix::<N, 1>());
        for joint in (0..N).rev() {
            SingularMassMatrix::test(joint, pivots[joint], diagonal[joint])?;
        }
        Ok(value)
    }
}

impl<const N: usize> Evaluate<N> for Interpreted<'_, N> {
    fn evaluate(&self, state: &State<N>, tau: &SVector<f64, N>) -> Evaluation<N> {
        let mut values = Evaluation::default();
        for (function, program) in self.programs {
            let mut at = At {
                fields: self.fields,
                state,
                tau,
            };
            let mut outputs = Outputs(program.evaluate(&mut at).into_iter());
            match function {
                Function::MassMatrix => values.mass_matrix = Some(outputs.matrix()),
                Function::CoriolisVector => values.coriolis_vector = Some(outputs.matrix()),
                Function::GravityVector => values.gravity_vector = Some(outputs.matrix()),
                Function::FrictionVector => values.friction_vector = Some(outputs.matrix()),
                Function::InverseDynamics => values.inverse_dynamics = Some(outputs.matrix()),
                Function::ForwardDynamics => {
                    let qdd = outputs.matrix::<N, 1>();
                    values.forward_dynamics = Some(outputs.tested::<_, N>(qdd));
                }
                Function::ForwardDynamicsAba => {
                    let qdd = outputs.matrix::<N, 1>();
                    values.forward_dynamics_aba = Some(outputs.tested::<_, N>(qdd));
                }
                // The recurrences of a series are no straight-line program: they have tests of their own.
                Function::TaylorSeries => {}
                Function::KineticEnergy => values.kinetic_energy = Some(outputs.number()),
                Function::PotentialEnergy => values.potential_energy = Some(outputs.number()),
                Function::BiasForce => values.bias_force = Some(outputs.matrix()),
                Function::CoriolisMatrix => values.coriolis_matrix = Some(outputs.matrix()),
                Function::CoriolisCoefficients => {
                    values.coriolis_coefficients = Some(outputs.columns());
                }
                Function::CentrifugalCoefficients => {
                    values.centrifugal_coefficients = Some(outputs.matrix());
                }
                Function::ForwardKinematics => {
                    values.forward_kinematics = Some(outputs.matrix::<4, 4>());
                }
                Function::LinkPoses => {
                    let pose = |_| -> Matrix4<f64> { outputs.matrix::<4, 4>() };
                    values.link_poses = Some([(); N].map(pose));
                }
                Function::Jacobian => values.jacobian = Some(outputs.matrix::<6, N>()),
                Function::InverseDynamicsDerivatives => {
                    let derivatives = (outputs.matrix(), outputs.matrix());
                    values.inverse_dynamics_derivatives = Some(derivatives);
                }
                Function::ForwardDynamicsDerivatives => {
                    let derivatives: AccelerationDerivatives<f64, N> =
                        (outputs.matrix(), outputs.matrix(), outputs.matrix());
                    let derivatives = outputs.tested::<_, N>(derivatives);
                    values.forward_dynamics_derivatives = Some(derivatives);
                }
                Function::Regressor => values.regressor = Some(outputs.columns()),
                Function::BaseParameters => values.base_parameters = Some(outputs.0.collect()),
            }
        }
        values.combined(state)
    }
}
