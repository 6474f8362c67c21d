//! The textbook definition, evaluated in the prime field from the raw table.
//!
//!   A_i = Rz(theta) Tz(d) Tx(a) Rx(alpha)   or   Rx(alpha) Tx(a) Rz(theta) Tz(d)
//!   link frame i = link frame of the row that carries it, or the base, `at` A_i
//!   base, tool, at, frames: T(xyz) Rz(yaw) Ry(pitch) Rx(roll)
//!   T = sum 1/2 (m c'.c' + w.I w) + sum 1/2 r^2 J_m qd^2
//!   U = U_g + U_k,   U_g = -sum m g.c,   U_k = sum 1/2 stiffness (q - rest)^2
//!   M_ij = d2T / dqd_i dqd_j
//!   V_i = sum_jk c_ijk qd_j qd_k,  c_ijk = 1/2 (dM_ij/dq_k + dM_ik/dq_j - dM_jk/dq_i)
//!   G_i = dU_g/dq_i,   K_i = dU_k/dq_i
//!
//! with q, qd of the joints that move by themselves; those that are locked have constants in their place,
//! and those that follow others their leader's times the factor, plus the offset.
//!
//! A base that moves has the velocities v and w in its own axes, which turn: with displacements d and phi in these axes
//!
//!   d/dt (dT/dv) + w x dT/dv - dT/dd + dU/dd = force
//!   d/dt (dT/dw) + w x dT/dw + v x dT/dv - dT/dphi + dU/dphi = moment
//!
//! (Hamel 1904), and `coriolis` has its Coriolis matrix. T and U are those of positions and velocities in the world.
//!
//! Where base parameters are neglected, what they contribute to T and U is taken off.
//!
//! Velocities are derivatives of positions by dual numbers. They are linear in qd, and T is quadratic in them, so that its second
//! derivatives are its polar form.

mod body;
mod centroidal;
mod configuration;
mod coriolis;
mod derivatives;
mod elimination;
mod energy;
mod equations;
mod frames;
mod friction;
mod joint;
mod kinematics;
mod motion;
mod parameters;
mod place;
mod pose;
mod regressor;
mod row;
mod walk;

use super::assignment::{Assignment, JointPoint, Number, STATES};
use crate::function::{Argument, Function, Part};
use crate::linear::{Matrix3, Vector3};
use crate::robot::Robot;
use body::Body;
use configuration::{Configuration, pose_of_base};
use frames::{FixedBody, Frame};
use pose::Pose;
use row::Row;

type Vector = Vec<Number>;
type Matrix = Vec<Vector>;

/// Functions that a robot whose base moves does not have.
const OF_STANDING_BASES: [Function; 3] = [
    Function::CoriolisCoefficients,
    Function::CentrifugalCoefficients,
    Function::TaylorSeries,
];

/// A robot at a random point of the field.
pub struct Definition {
    gravity: Vector3<Number>,
    /// The body of a base that moves.
    floating: Option<Body>,
    rows: Vec<Row>,
    /// The tip, if there is one.
    tip: Option<Frame>,
    /// The named frames.
    frames: Vec<Frame>,
    /// The tool and the bodies of frames.
    fixed_bodies: Vec<FixedBody>,
    /// Where the base and all joints are.
    q: Configuration<Number>,
    qd: Vector,
    qdd: Vector,
    tau: Vector,
    /// A reference motion.
    qd_r: Vector,
    qdd_r: Vector,
    jerk: Vector,
    snap: Vector,
    wrench: Vector,
    /// For each link, the axes of its moments as parameters, unless they are the link's own.
    moment_axes: Vec<Option<Matrix3<Number>>>,
    /// The values of all parameters that are neglected, or nothing.
    neglected: Vector,
    /// The complete arm in which nothing is coupled, where something is: the arm's base parameters are among
    /// those of this one.
    uncoupled: Option<Box<Definition>>,
    /// The seed of the states at which base parameters are found.
    states: u64,
    unfaithful: bool,
}

impl Definition {
    /// The definition at a point.
    pub fn new(point: &mut Assignment, robot: &Robot) -> Self {
        let mut definition = Definition::read(point, robot);
        if robot.floating().is_some() && robot.neglected.is_some() {
            // Nothing is defined: no table neglects parameters on a base that moves.
            definition.unfaithful = true;
        } else if let Some(neglected) = &robot.neglected {
            match definition.values_of(&neglected.columns) {
                Some(values) => definition.neglected = values,
                None => definition.unfaithful = true,
            }
        }
        definition
    }

    /// Reads the raw table.
    pub(super) fn read(point: &mut Assignment, robot: &Robot) -> Self {
        point.note([robot.convention as u64]);
        for (row, parameter) in robot
            .neglected
            .iter()
            .flat_map(|left_out| &left_out.columns)
        {
            point.note([*row, parameter.index()].map(|x| x as u64));
        }
        let rows = 0..robot.rows.len();
        let rows: Vec<_> = rows.map(|i| Row::new(point, robot, i)).collect();
        let gravity = Vector3([0, 1, 2].map(|k| point.cell(&robot.gravity[k])));
        let base = robot.placement().map(|base| place::placement(point, base));
        let floating = robot.floating().map(|body| {
            point.note([u64::MAX]);
            Body::new(point, body)
        });
        let base = match floating {
            Some(_) => pose_of_base(point),
            None => Pose::identity().then_fixed(&base),
        };
        let tip = Frame::tip(point, robot);
        let frames = Frame::named(point, robot);
        let fixed_bodies = FixedBody::all(point, robot);
        let uncoupled = robot.is_coupled().then(|| {
            let complete = Robot {
                neglected: None,
                bounds: Default::default(),
                ..robot.uncoupled()
            };
            let read = |point: &mut Assignment| Definition::read(point, &complete);
            Box::new(point.with_joints_of(&complete, read))
        });
        let dof = robot.dof();
        let entries = |argument, count| (0..count).map(|k| point.entry(argument, k)).collect();
        let joints = &point.joints()[..dof];
        let all = |variable: fn(&JointPoint) -> Number| joints.iter().map(variable).collect();
        let mut definition = Definition {
            gravity,
            floating,
            tip,
            frames,
            fixed_bodies,
            q: Configuration {
                base,
                joints: rows.iter().map(|row| row.joint.position).collect(),
            },
            rows,
            qd: all(|joint| joint.qd),
            qdd: all(|joint| joint.qdd),
            tau: all(|joint| joint.tau),
            qd_r: entries(Argument::ReferenceVelocity, dof),
            qdd_r: entries(Argument::ReferenceAcceleration, dof),
            jerk: entries(Argument::Jerk, dof),
            snap: entries(Argument::Snap, dof),
            wrench: entries(Argument::Wrench, 6),
            moment_axes: Vec::new(),
            neglected: Vec::new(),
            uncoupled,
            states: point.seed_for(STATES),
            unfaithful: point.is_unfaithful(),
        };
        definition.moment_axes = definition.moment_axes();
        definition
    }

    /// The right outputs of a function, of a frame where it is about one. `None` if the table defines none at this point, as
    /// for functions of the tip where there is none. Results of solving
    /// with M are judged: `computed` accelerations for which M qdd + V + G + K + F = tau holds are right.
    pub fn expected(&self, part: impl Into<Part>, computed: &[Option<Number>]) -> Option<Vector> {
        if self.unfaithful {
            return None;
        }
        let Part { function, frame } = part.into();
        if self.floating.is_some() && OF_STANDING_BASES.contains(&function) {
            return None;
        }
        let frame = match frame {
            Some(named) => self.frames.get(named),
            None => self.tip.as_ref(),
        };
        Some(match function {
            Function::MassMatrix => self.mass_matrix(&self.q).concat(),
            Function::CoriolisVector => self.coriolis_vector(),
            Function::GravityVector => self.gravity_vector(),
            Function::FrictionVector => self.friction_vector(),
            Function::SpringVector => self.spring_vector(),
            Function::InverseDynamics | Function::TaylorSeries => self.inverse_dynamics(&self.qdd),
            Function::ForwardDynamics | Function::ForwardDynamicsAba => {
                self.forward_dynamics(computed)
            }
            Function::KineticEnergy => vec![self.kinetic_energy(&self.q, &self.qd)],
            Function::PotentialEnergy => vec![self.potential_energy(&self.q)],
            Function::BiasForce => self.bias_force(),
            Function::CoriolisMatrix => self.coriolis_matrix().concat(),
            Function::CoriolisCoefficients => self.coriolis_coefficients(),
            Function::CentrifugalCoefficients => self.centrifugal_coefficients(),
            Function::ForwardKinematics => self.forward_kinematics(frame?),
            Function::LinkPoses => self.link_poses(),
            Function::Jacobian => self.jacobian(frame?).concat(),
            Function::InverseDynamicsDerivatives => self.inverse_dynamics_derivatives(),
            Function::ForwardDynamicsDerivatives => self.forward_dynamics_derivatives(computed),
            Function::Regressor => self.regressor()?,
            Function::BaseParameters => self.base_parameters()?,
            Function::WrenchTorques => self.wrench_torques(frame?),
            Function::ToolVelocity => self.tool_velocity(frame?),
            Function::ToolAcceleration => self.tool_acceleration(frame?),
            Function::JacobianRate => self.jacobian_rate(frame?),
            Function::LinkJacobians => self.link_jacobians(),
            Function::CenterOfMass => self.center_of_mass()?,
            Function::CenterOfMassJacobian => self.center_of_mass_jacobian()?,
            Function::CentroidalMomentumMatrix => self.centroidal_momentum_matrix()?,
            Function::CentroidalMomentumBias => self.centroidal_momentum_bias()?,
            Function::OperationalInertiaInverse => {
                self.operational_inertia_inverse(frame?, computed)
            }
            Function::GeneralizedMomentum => self.generalized_momentum(),
            Function::MomentumBias => self.momentum_bias(),
            Function::PassivityTorque => self.passivity_torque(),
            Function::PassivityRegressor => self.passivity_regressor()?,
            Function::EnergyRegressors => self.energy_regressors()?,
            Function::InverseDynamicsRates => self.inverse_dynamics_rates(),
            Function::InverseDynamicsSecondDerivatives => self.second_derivatives(),
        })
    }

    /// The number of degrees of freedom: six of a base that moves, and the joints that move by themselves.
    fn dof(&self) -> usize {
        self.qd.len()
    }
}
