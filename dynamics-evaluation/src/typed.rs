//! A robot at run time as generic code of a fixed number of joints takes it: checks and simulations.

use dynamics_runtime::nalgebra::{Matrix4, SMatrix, SVector};
use dynamics_runtime::{
    CoriolisVector, Energy, Evaluate, Evaluation, ForwardDynamics, GravityVector, InverseDynamics,
    Kinematics, MassMatrix, Model, Momenta, Scalar, SingularMassMatrix, State, Table,
};
use dynamics_symbolic::function::Argument;
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Function, Request};

use crate::compiled::Compiled;
use crate::table::table;
use crate::{BuildError, EvaluationError, RuntimeRobot, WrongJoints};

impl RuntimeRobot {
    /// The robot as an arm of `N` joints, which [`Check`](dynamics_runtime::Check) takes; simulations take its
    /// [`dynamics`](Typed::dynamics).
    ///
    /// ```
    /// # use dynamics_evaluation::RuntimeRobot;
    /// # use dynamics_runtime as robot_dynamics;
    /// # fn checked(arm: &RuntimeRobot) -> Result<(), Box<dyn std::error::Error>> {
    /// let report = robot_dynamics::check_against_rnea(&arm.typed::<6>()?);
    /// assert!(report.is_ok());
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    ///
    /// [`WrongJoints`] where another number of joints moves.
    pub fn typed<const N: usize>(&self) -> Result<Typed<'_, N>, WrongJoints> {
        let table = table(self.robot(), self.fields()).of_joints();
        let table = table.ok_or(WrongJoints {
            found: self.dof(),
            expected: N,
        })?;
        Ok(Typed { arm: self, table })
    }
}

/// A [`RuntimeRobot`] of `N` joints, whose functions can be evaluated.
#[derive(Clone, Copy, Debug)]
pub struct Typed<'a, const N: usize> {
    pub(crate) arm: &'a RuntimeRobot,
    pub(crate) table: Table<N>,
}

/// A [`RuntimeRobot`] of `N` joints that has the functions by which an arm moves, as
/// [`Simulation`](dynamics_runtime::Simulation) needs them.
#[derive(Clone, Copy, Debug)]
pub struct TypedDynamics<'a, const N: usize> {
    typed: Typed<'a, N>,
    mass_matrix: &'a Compiled,
    coriolis_vector: &'a Compiled,
    gravity_vector: &'a Compiled,
    inverse_dynamics: &'a Compiled,
    forward_dynamics: &'a Compiled,
    kinetic_energy: &'a Compiled,
    potential_energy: &'a Compiled,
}

/// A [`TypedDynamics`] with the kinematics of its tip: a simulation of it may have a force at the tool.
#[derive(Clone, Copy, Debug)]
pub struct TypedTip<'a, const N: usize> {
    dynamics: TypedDynamics<'a, N>,
    forward_kinematics: &'a Compiled,
    jacobian: &'a Compiled,
}

impl<'a, const N: usize> Typed<'a, N> {
    /// The arm with its motion, which [`Simulation`](dynamics_runtime::Simulation) takes.
    ///
    /// # Errors
    ///
    /// [`EvaluationError::NotSimulated`] unless all [`simulation_functions`](RuntimeRobot::simulation_functions) but the
    /// two of the tip were asked for, as [`for_simulation`](RuntimeRobot::for_simulation) does.
    pub fn dynamics(self) -> Result<TypedDynamics<'a, N>, EvaluationError> {
        let function = |function: Function| self.arm.simulated(function);
        Ok(TypedDynamics {
            typed: self,
            mass_matrix: function(Function::MassMatrix)?,
            coriolis_vector: function(Function::CoriolisVector)?,
            gravity_vector: function(Function::GravityVector)?,
            inverse_dynamics: function(Function::InverseDynamics)?,
            forward_dynamics: function(Function::ForwardDynamics)?,
            kinetic_energy: function(Function::KineticEnergy)?,
            potential_energy: function(Function::PotentialEnergy)?,
        })
    }

    /// The values of a function at joint vectors, in the arithmetic of their numbers.
    fn at<T: Scalar>(
        &self,
        function: &Compiled,
        arguments: &[(Argument, &SVector<T, N>)],
    ) -> Result<Vec<T>, SingularMassMatrix> {
        let like = arguments.first().map(|(_, vector)| vector[0]);
        let constant = |x: f64| like.map_or_else(|| T::from_f64(x), |like| like.constant(x));
        let argument = |of: Argument, i: usize| {
            let mut known = arguments.iter();
            let vector = known.find(|(argument, _)| *argument == of);
            vector.map_or_else(|| constant(f64::NAN), |(_, vector)| vector[i])
        };
        let shared = self.arm.shared(function, &constant);
        self.arm.values(function, &shared, &argument, &constant)
    }

    /// The same of a function that does not solve with M.
    fn vector<T: Scalar, const R: usize, const C: usize>(
        &self,
        function: &Compiled,
        arguments: &[(Argument, &SVector<T, N>)],
    ) -> SMatrix<T, R, C> {
        let like = arguments[0].1[0];
        match self.at(function, arguments) {
            Ok(values) => SMatrix::from_iterator(values),
            Err(_) => SMatrix::repeat(like.constant(f64::NAN)),
        }
    }
}

impl<'a, const N: usize> TypedDynamics<'a, N> {
    /// The arm with its tip: its simulation may have a force at the tool.
    ///
    /// # Errors
    ///
    /// [`EvaluationError::NotSimulated`] where `forward_kinematics` or `jacobian` was not asked for.
    pub fn with_tip(self) -> Result<TypedTip<'a, N>, EvaluationError> {
        Ok(TypedTip {
            dynamics: self,
            forward_kinematics: self.typed.arm.simulated(Function::ForwardKinematics)?,
            jacobian: self.typed.arm.simulated(Function::Jacobian)?,
        })
    }
}

/// What [`Typed::dynamics`] takes, then what [`TypedDynamics::with_tip`] takes.
const OF_SIMULATIONS: [Function; 9] = [
    Function::MassMatrix,
    Function::CoriolisVector,
    Function::GravityVector,
    Function::InverseDynamics,
    Function::ForwardDynamics,
    Function::KineticEnergy,
    Function::PotentialEnergy,
    Function::ForwardKinematics,
    Function::Jacobian,
];

impl RuntimeRobot {
    /// The robot with the [`simulation_functions`](RuntimeRobot::simulation_functions).
    ///
    /// ```
    /// # mod robot_dynamics {
    /// # pub use dynamics_runtime::*;
    /// # pub use dynamics_evaluation as evaluation;
    /// # }
    /// # use robot_dynamics::evaluation::dynamics_symbolic::robot::Robot;
    /// # fn simulated(robot: Robot) -> Result<(), Box<dyn std::error::Error>> {
    /// use robot_dynamics::Simulation;
    /// use robot_dynamics::evaluation::RuntimeRobot;
    ///
    /// let robot = RuntimeRobot::for_simulation(robot)?;
    /// let arm = robot.typed::<6>()?.dynamics()?;
    /// let motion = Simulation::new(&arm).duration(2.0).run()?;
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    ///
    /// [`BuildError`], as [`new`](RuntimeRobot::new).
    pub fn for_simulation(robot: Robot) -> Result<Self, BuildError> {
        RuntimeRobot::new(robot, RuntimeRobot::simulation_functions())
    }

    /// The functions that a simulation needs, for robots that have others as well:
    /// `RuntimeRobot::new(robot, RuntimeRobot::simulation_functions().into_iter().chain([Function::Regressor]))`.
    ///
    /// Forward dynamics moves the arm; methods that work in momenta need the mass matrix and inverse dynamics, energies
    /// are compared; the last two, `forward_kinematics` and `jacobian`, are those of a force at the tool.
    pub fn simulation_functions() -> [Function; 9] {
        OF_SIMULATIONS
    }

    /// A function by itself, not a method of several that has its name.
    pub(crate) fn simulated(&self, function: Function) -> Result<&Compiled, EvaluationError> {
        let mut known = self.functions().iter();
        known
            .find(|known| known.request == Request::One(function))
            .ok_or_else(|| EvaluationError::NotSimulated(function.name().to_owned()))
    }
}

/// What all of them are; names of joints are known at run time alone: see `joint_names`.
macro_rules! impl_model {
    ($($typed:ident: [$($path:ident).*] $($energies:ident)?;)*) => {$(
        impl<const N: usize> Model<N> for $typed<'_, N> {
            /// The names of the joints are those of `joint_names`.
            const JOINT_NAMES: [&'static str; N] = ["joint"; N];

            fn table(&self) -> Table<N> {
                self.$($path.)*table
            }

            fn joint_names(&self) -> [&str; N] {
                let mut names = self.$($path.)*arm.joint_names();
                core::array::from_fn(|_| names.next().unwrap_or_default())
            }

            $(fn $energies(&self, q: &SVector<f64, N>, qd: &SVector<f64, N>) -> Option<[f64; 2]> {
                Some([self.kinetic_energy(q, qd), self.potential_energy(q)])
            })?
        }

        impl<const N: usize> Evaluate<N> for $typed<'_, N> {
            fn evaluate_in<T: Scalar>(
                &self,
                state: &State<N>,
                tau: &SVector<f64, N>,
                real: fn(f64) -> T,
            ) -> Evaluation<T> {
                self.$($path.)*arm.evaluation(state, tau, real)
            }

            fn evaluate_parts(
                &self,
                state: &State<N>,
                tau: &SVector<f64, N>,
                found: &mut dyn FnMut(&str, Evaluation),
            ) {
                self.$($path.)*arm.evaluate_parts(state, tau, found);
            }
        }
    )*};
}

impl_model! {
    Typed: [];
    TypedDynamics: [typed] energies;
    TypedTip: [dynamics.typed] energies;
}

impl RuntimeRobot {
    /// The values of all functions that are evaluated by themselves, in numbers that `real` makes of the state's.
    fn evaluation<const N: usize, T: Scalar>(
        &self,
        state: &State<N>,
        tau: &SVector<f64, N>,
        real: fn(f64) -> T,
    ) -> Evaluation<T> {
        let double = arguments(state, tau);
        let argument = |of, i| real(double(of, i));
        let mut evaluation = Evaluation::default();
        for function in self.functions() {
            // A Taylor series is no program over numbers.
            if let Request::One(one) = function.request
                && one != Function::TaylorSeries
            {
                let shared = self.shared(function, &T::from_f64);
                let values = self.values(function, &shared, &argument, &T::from_f64);
                evaluation.set(one.name(), values);
            }
        }
        evaluation.combined(state.qd.map(real).as_slice())
    }

    /// The parts of the methods that return several functions, each method by its own program.
    fn evaluate_parts<const N: usize>(
        &self,
        state: &State<N>,
        tau: &SVector<f64, N>,
        found: &mut dyn FnMut(&str, Evaluation),
    ) {
        let argument = arguments(state, tau);
        for function in self.functions() {
            let Request::Fused(fused) = &function.request else {
                continue;
            };
            let mut values = self
                .values(function, &function.shared, &argument, &|x| x)
                .map(Vec::into_iter);
            let mut evaluation = Evaluation::default();
            for &part in &fused.parts {
                let entries = part.shape().entries(function.layout.sizes);
                match &mut values {
                    Ok(values) => {
                        let of_part: Vec<f64> = values.take(entries).collect();
                        evaluation.set(part.name(), of_part);
                    }
                    Err(error) if part.row().refuses => {
                        evaluation.set(part.name(), Err::<f64, _>(*error));
                    }
                    Err(_) => {}
                }
            }
            found(
                function.request.name(),
                evaluation.combined(state.qd.as_slice()),
            );
        }
    }
}

/// The entries of all arguments at a state.
fn arguments<const N: usize>(
    state: &State<N>,
    tau: &SVector<f64, N>,
) -> impl Fn(Argument, usize) -> f64 {
    let (State { q, qd, qdd }, tau) = (*state, *tau);
    let [qd_r, qdd_r] = [state.reference_velocity(), state.reference_acceleration()];
    let ([jerk, snap], wrench) = ([state.jerk(), state.snap()], State::<N>::wrench());
    move |of, i| match of {
        Argument::Position => q[i],
        Argument::Velocity => qd[i],
        Argument::Acceleration => qdd[i],
        Argument::Force => tau[i],
        Argument::ReferenceVelocity => qd_r[i],
        Argument::ReferenceAcceleration => qdd_r[i],
        Argument::Jerk => jerk[i],
        Argument::Snap => snap[i],
        Argument::Wrench => wrench[i],
        Argument::Order => f64::NAN,
    }
}

use Argument::{Acceleration, Force, Position, Velocity};

macro_rules! impl_dynamics {
    ($($typed:ident: $($path:ident).*;)*) => {$(
        impl<const N: usize> MassMatrix<N> for $typed<'_, N> {
            fn mass_matrix<T: Scalar>(&self, q: &SVector<T, N>) -> SMatrix<T, N, N> {
                let dynamics = &self$(.$path)*;
                dynamics.typed.vector(dynamics.mass_matrix, &[(Position, q)])
            }
        }

        impl<const N: usize> CoriolisVector<N> for $typed<'_, N> {
            fn coriolis_vector<T: Scalar>(
                &self,
                q: &SVector<T, N>,
                qd: &SVector<T, N>,
            ) -> SVector<T, N> {
                let dynamics = &self$(.$path)*;
                let arguments = [(Position, q), (Velocity, qd)];
                dynamics.typed.vector(dynamics.coriolis_vector, &arguments)
            }
        }

        impl<const N: usize> GravityVector<N> for $typed<'_, N> {
            fn gravity_vector<T: Scalar>(&self, q: &SVector<T, N>) -> SVector<T, N> {
                let dynamics = &self$(.$path)*;
                dynamics.typed.vector(dynamics.gravity_vector, &[(Position, q)])
            }
        }

        impl<const N: usize> InverseDynamics<N> for $typed<'_, N> {
            fn inverse_dynamics<T: Scalar>(
                &self,
                q: &SVector<T, N>,
                qd: &SVector<T, N>,
                qdd: &SVector<T, N>,
            ) -> SVector<T, N> {
                let dynamics = &self$(.$path)*;
                let arguments = [(Position, q), (Velocity, qd), (Acceleration, qdd)];
                dynamics.typed.vector(dynamics.inverse_dynamics, &arguments)
            }
        }

        impl<const N: usize> ForwardDynamics<N> for $typed<'_, N> {
            fn forward_dynamics<T: Scalar>(
                &self,
                q: &SVector<T, N>,
                qd: &SVector<T, N>,
                tau: &SVector<T, N>,
            ) -> Result<SVector<T, N>, SingularMassMatrix> {
                let dynamics = &self$(.$path)*;
                let arguments = [(Position, q), (Velocity, qd), (Force, tau)];
                let values = dynamics.typed.at(dynamics.forward_dynamics, &arguments)?;
                Ok(SVector::from_iterator(values))
            }

            fn momenta(&self) -> Option<&dyn Momenta<N>> {
                Some(self)
            }
        }

        impl<const N: usize> Energy<N> for $typed<'_, N> {
            fn kinetic_energy<T: Scalar>(&self, q: &SVector<T, N>, qd: &SVector<T, N>) -> T {
                let dynamics = &self$(.$path)*;
                let arguments = [(Position, q), (Velocity, qd)];
                dynamics.typed.vector::<T, 1, 1>(dynamics.kinetic_energy, &arguments)[0]
            }

            fn potential_energy<T: Scalar>(&self, q: &SVector<T, N>) -> T {
                let dynamics = &self$(.$path)*;
                dynamics.typed.vector::<T, 1, 1>(dynamics.potential_energy, &[(Position, q)])[0]
            }
        }
    )*};
}

impl_dynamics! {
    TypedDynamics: ;
    TypedTip: dynamics;
}

impl<const N: usize> Kinematics<N> for TypedTip<'_, N> {
    fn forward_kinematics<T: Scalar>(&self, q: &SVector<T, N>) -> Matrix4<T> {
        let typed = &self.dynamics.typed;
        typed.vector(self.forward_kinematics, &[(Position, q)])
    }

    fn jacobian<T: Scalar>(&self, q: &SVector<T, N>) -> SMatrix<T, 6, N> {
        self.dynamics.typed.vector(self.jacobian, &[(Position, q)])
    }
}
