//! An arm of the engine's whose programs are run and not compiled: the same operations on the same
//! doubles as the functions that are emitted.

#![forbid(unsafe_code)]

mod rounded;

pub use rounded::{AllDigits, Inputs, Rounded, is_refused};

use dynamics_runtime::nalgebra::{SMatrix, SVector};
use dynamics_runtime::{
    Convention, Evaluate, Evaluation, Frame, JointType, Model, Row, SingularMassMatrix, Spring,
    State, Stribeck, Table, Tool, turned,
};
use dynamics_symbolic::Function;
use dynamics_symbolic::program::{Program, rounded_angle};
use dynamics_symbolic::robot::{self, Angle, Placement, Robot, Value};

/// An arm of N joints with values for its fields, and the programs of some of its functions.
pub struct Interpreted<'a, const N: usize> {
    robot: &'a Robot,
    fields: &'a [f64],
    programs: Vec<(Function, Rounded<'a>)>,
}

impl<'a, const N: usize> Interpreted<'a, N> {
    /// The arm `robot`, whose programs are `programs`.
    ///
    /// # Panics
    ///
    /// Where the arm has not N joints, or not as many fields as there are values.
    pub fn new(robot: &'a Robot, fields: &'a [f64], programs: &'a [(Function, Program)]) -> Self {
        assert_eq!((robot.rows.len(), robot.fields.len()), (N, fields.len()));
        let rounded = programs.iter();
        let rounded = rounded.map(|(function, program)| (*function, Rounded::new(program)));
        Interpreted {
            robot,
            fields,
            programs: rounded.collect(),
        }
    }

    fn cell(&self, value: &Value) -> f64 {
        value.to_f64(self.fields)
    }

    /// An angle, as a generated table has it.
    fn angle(&self, value: &Value) -> f64 {
        if value.is_number() {
            return rounded_angle(value);
        }
        let parts = Angle::new(value);
        let rest = parts.rest.as_ref().map_or(0.0, |rest| self.cell(rest));
        turned(rest, f64::from(parts.signed_quarter_turns()))
    }

    fn frame(&self, placement: Option<&Placement>) -> Frame {
        placement.map_or(Frame::IDENTITY, |placement| Frame {
            xyz: placement.xyz.each_ref().map(|x| self.cell(x)),
            rpy: placement.rpy.each_ref().map(|angle| self.angle(angle)),
        })
    }

    fn row(&self, row: &robot::Row) -> Row {
        let joint_type = match row.joint_type {
            robot::JointType::Revolute => JointType::Revolute,
            robot::JointType::Prismatic => JointType::Prismatic,
        };
        Row {
            a: self.cell(&row.a),
            alpha: self.angle(&row.alpha),
            d: self.cell(&row.d),
            theta: self.angle(&row.theta),
            mass: self.cell(&row.mass),
            com: row.com.each_ref().map(|x| self.cell(x)),
            inertia: row.inertia.each_ref().map(|x| self.cell(x)),
            motor_inertia: self.cell(&row.motor_inertia),
            gear_ratio: self.cell(&row.gear_ratio),
            viscous: self.cell(&row.viscous),
            coulomb: row.coulomb.each_ref().map(|x| self.cell(x)),
            stribeck: row.stribeck.as_ref().map(|stribeck| Stribeck {
                friction: self.cell(&stribeck.friction),
                velocity: self.cell(&stribeck.velocity),
            }),
            spring: row.spring.as_ref().map_or(Spring::NONE, |spring| Spring {
                stiffness: self.cell(&spring.stiffness),
                rest: self.cell(&spring.rest),
            }),
            ..Row::new(joint_type)
        }
    }
}

impl<const N: usize> Model<N> for Interpreted<'_, N> {
    const JOINT_NAMES: [&'static str; N] = ["joint"; N];

    fn table(&self) -> Table<N> {
        let robot = self.robot;
        Table {
            convention: match robot.convention {
                robot::Convention::Standard => Convention::Standard,
                robot::Convention::Modified => Convention::Modified,
            },
            gravity: robot.gravity.each_ref().map(|value| self.cell(value)),
            base: self.frame(robot.base.as_ref()),
            rows: std::array::from_fn(|i| self.row(&robot.rows[i])),
            tool: robot.tool.as_ref().map_or(Tool::NONE, |tool| Tool {
                frame: self.frame(Some(&tool.placement)),
                mass: self.cell(&tool.mass),
                com: tool.com.each_ref().map(|x| self.cell(x)),
                inertia: tool.inertia.each_ref().map(|x| self.cell(x)),
            }),
        }
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
        let velocity = |row: &robot::Row| {
            let stribeck = row.stribeck.as_ref();
            stribeck.map_or(1.0, |stribeck| self.cell(&stribeck.velocity))
        };
        let stribeck: Vec<f64> = self.robot.joints().map(velocity).collect();
        let [qd_r, qdd_r] = [state.reference_velocity(), state.reference_acceleration()];
        let ([jerk, snap], wrench) = ([state.jerk(), state.snap()], State::<N>::wrench());
        let inputs = Inputs {
            fields: self.fields,
            q: state.q.as_slice(),
            qd: state.qd.as_slice(),
            qdd: state.qdd.as_slice(),
            tau: tau.as_slice(),
            stribeck: &stribeck,
            qd_r: qd_r.as_slice(),
            qdd_r: qdd_r.as_slice(),
            jerk: jerk.as_slice(),
            snap: snap.as_slice(),
            wrench: wrench.as_slice(),
        };
        for (function, rounded) in &self.programs {
            let outputs: Vec<f64> = rounded.run(&inputs);
            record(&mut values, *function, Outputs(outputs.into_iter()));
        }
        values.combined(state)
    }
}

/// Puts the outputs of a function where they belong.
fn record<const N: usize>(values: &mut Evaluation<N>, function: Function, mut outputs: Outputs) {
    match function {
        Function::MassMatrix => values.mass_matrix = Some(outputs.matrix()),
        Function::CoriolisVector => values.coriolis_vector = Some(outputs.matrix()),
        Function::GravityVector => values.gravity_vector = Some(outputs.matrix()),
        Function::FrictionVector => values.friction_vector = Some(outputs.matrix()),
        Function::SpringVector => values.spring_vector = Some(outputs.matrix()),
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
        Function::CoriolisCoefficients => values.coriolis_coefficients = Some(outputs.columns()),
        Function::CentrifugalCoefficients => {
            values.centrifugal_coefficients = Some(outputs.matrix());
        }
        Function::ForwardKinematics => values.forward_kinematics = Some(outputs.matrix()),
        Function::LinkPoses => values.link_poses = Some([(); N].map(|()| outputs.matrix())),
        Function::Jacobian => values.jacobian = Some(outputs.matrix()),
        Function::InverseDynamicsDerivatives => {
            values.inverse_dynamics_derivatives = Some((outputs.matrix(), outputs.matrix()));
        }
        Function::ForwardDynamicsDerivatives => {
            let derivatives = (outputs.matrix(), outputs.matrix(), outputs.matrix());
            values.forward_dynamics_derivatives = Some(outputs.tested::<_, N>(derivatives));
        }
        Function::Regressor => values.regressor = Some(outputs.columns()),
        Function::BaseParameters => values.base_parameters = Some(outputs.0.collect()),
        Function::WrenchTorques => values.wrench_torques = Some(outputs.matrix()),
        Function::ToolVelocity => values.tool_velocity = Some(outputs.matrix()),
        Function::ToolAcceleration => values.tool_acceleration = Some(outputs.matrix()),
        Function::JacobianRate => values.jacobian_rate = Some(outputs.matrix()),
        Function::LinkJacobians => {
            values.link_jacobians = Some([(); N].map(|()| outputs.matrix()));
        }
        Function::CenterOfMass => values.center_of_mass = Some(outputs.matrix()),
        Function::CenterOfMassJacobian => values.center_of_mass_jacobian = Some(outputs.matrix()),
        Function::OperationalInertiaInverse => {
            let inverse = outputs.matrix::<6, 6>();
            values.operational_inertia_inverse = Some(outputs.tested::<_, N>(inverse));
        }
        Function::GeneralizedMomentum => values.generalized_momentum = Some(outputs.matrix()),
        Function::MomentumBias => values.momentum_bias = Some(outputs.matrix()),
        Function::PassivityTorque => values.passivity_torque = Some(outputs.matrix()),
        Function::PassivityRegressor => values.passivity_regressor = Some(outputs.columns()),
        Function::EnergyRegressors => {
            let energies: Vec<f64> = outputs.0.collect();
            let (kinetic, potential) = energies.split_at(energies.len() / 2);
            values.energy_regressors = Some((kinetic.to_vec(), potential.to_vec()));
        }
        Function::InverseDynamicsRates => {
            values.inverse_dynamics_rates = Some((outputs.matrix(), outputs.matrix()));
        }
    }
}
