//! A robot at run time as generic code of a fixed number of joints takes it: checks and simulations.

use dynamics_runtime::nalgebra::{DVector, Dyn, SVector};
use dynamics_runtime::{
    Certified, JointVector as _, Model, Scalar, Size, SizedState, State,
    check::{Checked, Evaluate, Evaluation},
    table::{RuntimeTable, Table},
};
use dynamics_symbolic::function::Argument;
use dynamics_symbolic::{Function, Request};

use crate::compiled::Compiled;
use crate::table::table;
use crate::{EvaluationError, RuntimeRobot, WrongJoints};

impl RuntimeRobot {
    /// The robot as an arm of `N` joints, which generic code takes. Checks take the robot as it is
    /// ([`Check::run_any`](dynamics_runtime::check::Check::run_any)), and simulations its [`dynamics`](RuntimeRobot::dynamics).
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

/// What [`RuntimeRobot::dynamics`] takes, then what [`RuntimeDynamics::with_tip`](crate::RuntimeDynamics::with_tip) takes.
const OF_SIMULATIONS: [Function; 7] = [
    Function::MassMatrix,
    Function::InverseDynamics,
    Function::ForwardDynamics,
    Function::KineticEnergy,
    Function::PotentialEnergy,
    Function::ForwardKinematics,
    Function::Jacobian,
];

impl RuntimeRobot {
    /// The names of the functions that a simulation needs: those of
    /// [`dynamics`](RuntimeRobot::dynamics), then the two of [`with_tip`](crate::RuntimeDynamics::with_tip).
    ///
    /// Forward dynamics moves the arm; methods that work in momenta need the mass matrix and inverse dynamics, energies
    /// are compared; the last two, `forward_kinematics` and `jacobian`, are those of a force at the tool.
    pub fn simulation_functions() -> [&'static str; 7] {
        OF_SIMULATIONS.map(Function::name)
    }

    /// A function by itself, not a method of several that has its name.
    pub(crate) fn simulated(&self, function: Function) -> Result<&Compiled, EvaluationError> {
        let mut known = self.functions().iter();
        known
            .find(|known| known.request == Request::One(function))
            .ok_or_else(|| EvaluationError::NotSimulated(function.name().to_owned()))
    }
}

/// The names of joints are known at run time alone: see `joint_names`.
impl<const N: usize> Model<N> for Typed<'_, N> {
    const JOINT_NAMES: [&'static str; N] = ["joint"; N];

    fn table(&self) -> Table<N> {
        self.table
    }

    fn joint_names(&self) -> [&str; N] {
        let mut names = self.arm.joint_names();
        core::array::from_fn(|_| names.next().unwrap_or_default())
    }
}

impl<const N: usize> Evaluate<N> for Typed<'_, N> {
    fn evaluate_in<T: Scalar>(
        &self,
        state: &State<N>,
        tau: &SVector<f64, N>,
        real: fn(f64) -> T,
    ) -> Evaluation<T> {
        self.arm.evaluation(state, tau, real)
    }

    fn evaluate_parts(
        &self,
        state: &State<N>,
        tau: &SVector<f64, N>,
        found: &mut dyn FnMut(&str, Evaluation),
    ) {
        self.arm.evaluate_parts(state, tau, found);
    }
}

impl Checked for RuntimeRobot {
    fn names(&self) -> Vec<String> {
        self.joint_names().map(str::to_owned).collect()
    }

    fn runtime_table(&self) -> RuntimeTable {
        table(self.robot(), self.fields())
    }

    fn values(&self, state: &SizedState<Dyn>, tau: &DVector<f64>) -> Evaluation {
        self.evaluation(state, tau, |x| x)
    }

    fn certified_values(
        &self,
        state: &SizedState<Dyn>,
        tau: &DVector<f64>,
    ) -> Evaluation<Certified> {
        self.evaluation(state, tau, Certified::exact)
    }

    fn values_of_parts(
        &self,
        state: &SizedState<Dyn>,
        tau: &DVector<f64>,
        found: &mut dyn FnMut(&str, Evaluation),
    ) {
        self.evaluate_parts(state, tau, found);
    }
}

impl RuntimeRobot {
    /// The values of all functions that are evaluated by themselves, in numbers that `real` makes of the state's.
    fn evaluation<D: Size, T: Scalar>(
        &self,
        state: &SizedState<D>,
        tau: &D::Vector,
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
        let qd: Vec<T> = state.qd.entries().iter().map(|x| real(*x)).collect();
        evaluation.combined(&qd)
    }

    /// The parts of the methods that return several functions, each method by its own program.
    fn evaluate_parts<D: Size>(
        &self,
        state: &SizedState<D>,
        tau: &D::Vector,
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
                evaluation.combined(state.qd.entries()),
            );
        }
    }
}

/// The entries of all arguments at a state.
fn arguments<D: Size>(state: &SizedState<D>, tau: &D::Vector) -> impl Fn(Argument, usize) -> f64 {
    let (SizedState { q, qd, qdd }, tau) = (state.clone(), tau.clone());
    let [qd_r, qdd_r] = [state.reference_velocity(), state.reference_acceleration()];
    let ([jerk, snap], wrench) = ([state.jerk(), state.snap()], SizedState::<D>::wrench());
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
