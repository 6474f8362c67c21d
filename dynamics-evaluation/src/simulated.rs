//! A robot at run time as simulations take it: its number of joints is known at run time alone.

use core::marker::PhantomData;

use dynamics_runtime::nalgebra::{DMatrix, DVector, Dyn, Matrix4, Matrix6xX};
use dynamics_runtime::{
    Dual, Pose, Scalar, SingularMassMatrix, SizedKinematics, SizedMomenta,
    simulation::{EquationsOfMotion, OnBase, Responses, SizedModel, Stand},
    table::RuntimeTable,
};
use dynamics_symbolic::Function;

use crate::compiled::Compiled;
use crate::{EvaluationError, RuntimeRobot};

/// A [`RuntimeRobot`] that has the functions by which an arm moves, as
/// [`Simulation`](dynamics_runtime::Simulation) needs them: vectors are `DVector<f64>`.
///
/// With a [`Tip`], it has the kinematics of its tip too: a simulation of it may have a force at the tool. One that [`Moves`] is
/// on a base that moves.
#[derive(Clone, Debug)]
pub struct RuntimeDynamics<'a, K = ()> {
    arm: &'a RuntimeRobot,
    table: RuntimeTable,
    /// Some of the functions of [`OF_SIMULATIONS`].
    functions: Vec<&'a Compiled>,
    tip: PhantomData<K>,
}

/// The mark of a [`RuntimeDynamics`] that has the functions of its tip.
#[derive(Clone, Copy, Debug)]
pub enum Tip {}

/// The mark of a [`RuntimeDynamics`] whose base moves.
#[derive(Clone, Copy, Debug)]
pub enum Moves {}

/// The marks of a [`RuntimeDynamics`].
pub trait Mark: Sized {
    /// The base of the robot: it stands or moves.
    type Base: Stand<Joints = Dyn, Freedoms = Dyn>;

    /// The robot in positions and momenta, if its base stands.
    #[doc(hidden)]
    fn in_momenta<'r>(_: &'r RuntimeDynamics<'_, Self>) -> Option<&'r dyn SizedMomenta<Dyn>> {
        None
    }
}

macro_rules! stands {
    ($($mark:ty),*) => {$(
        impl Mark for $mark {
            type Base = Dyn;

            fn in_momenta<'r>(
                robot: &'r RuntimeDynamics<'_, Self>,
            ) -> Option<&'r dyn SizedMomenta<Dyn>> {
                Some(robot)
            }
        }
    )*};
}

stands!((), Tip);

impl Mark for Moves {
    type Base = OnBase<Dyn, Dyn>;
}

/// The marks of robots whose base stands.
pub trait Stands: Mark<Base = Dyn> {}

impl<M: Mark<Base = Dyn>> Stands for M {}

/// The functions of [`RuntimeRobot::dynamics`], then those of [`RuntimeDynamics::with_tip`].
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
    /// The names of the functions that a simulation needs: those of [`dynamics`](RuntimeRobot::dynamics), then the two of
    /// [`with_tip`](RuntimeDynamics::with_tip).
    ///
    /// Forward dynamics moves the arm; methods that work in momenta need the mass matrix and inverse dynamics, energies
    /// are compared; the last two, `forward_kinematics` and `jacobian`, are those of a force at the tool.
    pub fn simulation_functions() -> [&'static str; 7] {
        OF_SIMULATIONS.map(Function::name)
    }

    /// The motion by functions, each by itself, not a method of several that has its name.
    fn simulated<K>(
        &self,
        functions: &[Function],
    ) -> Result<RuntimeDynamics<'_, K>, EvaluationError> {
        let compiled = |function: &Function| {
            let mut known = self.functions().iter();
            known
                .find(|known| known.request.function() == Some(*function))
                .ok_or_else(|| EvaluationError::NotSimulated(function.name().to_owned()))
        };
        Ok(RuntimeDynamics {
            arm: self,
            table: self.table(),
            functions: functions.iter().map(compiled).collect::<Result<_, _>>()?,
            tip: PhantomData,
        })
    }

    /// The arm with its motion, which [`Simulation`](dynamics_runtime::Simulation) takes.
    ///
    /// ```
    /// # mod robot_dynamics {
    /// # pub use dynamics_runtime::*;
    /// # pub use dynamics_evaluation as evaluation;
    /// # }
    /// # fn simulated() -> Result<(), Box<dyn std::error::Error>> {
    /// use robot_dynamics::Simulation;
    /// use robot_dynamics::evaluation::{ReadOptions, RuntimeRobot};
    ///
    /// let options = ReadOptions::new().functions(RuntimeRobot::simulation_functions());
    /// let robot = RuntimeRobot::from_file("puma560.toml", &options)?;
    /// let motion = Simulation::new(&robot.dynamics()?).duration(2.0).run()?;
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    ///
    /// [`EvaluationError::MovingBase`] of a robot whose base moves; [`EvaluationError::NotSimulated`] unless all
    /// [`simulation_functions`](RuntimeRobot::simulation_functions) except the two of the tip were requested.
    pub fn dynamics(&self) -> Result<RuntimeDynamics<'_>, EvaluationError> {
        match self.robot().floating() {
            Some(_) => Err(EvaluationError::MovingBase),
            None => self.simulated(&OF_SIMULATIONS[..5]),
        }
    }

    /// A robot on a base that moves, with its motion: a [`Simulation`](dynamics_runtime::Simulation) of it is given the pose of
    /// the base, and its laws are too.
    ///
    /// # Errors
    ///
    /// [`EvaluationError::StandingBase`] of a robot whose base stands; [`EvaluationError::NotSimulated`] as for
    /// [`dynamics`](RuntimeRobot::dynamics).
    pub fn dynamics_on_base(&self) -> Result<RuntimeDynamics<'_, Moves>, EvaluationError> {
        match self.robot().floating() {
            Some(_) => self.simulated(&OF_SIMULATIONS[2..5]),
            None => Err(EvaluationError::StandingBase),
        }
    }
}

impl<'a> RuntimeDynamics<'a> {
    /// The arm with its tip: its simulation may have a force at the tool.
    ///
    /// # Errors
    ///
    /// [`EvaluationError::NotSimulated`] where `forward_kinematics` or `jacobian` was not requested.
    pub fn with_tip(self) -> Result<RuntimeDynamics<'a, Tip>, EvaluationError> {
        self.arm.simulated(&OF_SIMULATIONS)
    }
}

impl<K> RuntimeDynamics<'_, K> {
    fn compiled(&self, function: Function) -> &Compiled {
        let is_it = |compiled: &&&Compiled| compiled.request.function() == Some(function);
        let found = self.functions.iter().find(is_it);
        found.expect("a function of this motion")
    }

    /// The values of a function, in the arithmetic of its arguments.
    fn at<T: Scalar>(
        &self,
        function: Function,
        arguments: &[&[T]],
    ) -> Result<Vec<T>, SingularMassMatrix> {
        let function = self.compiled(function);
        let shared = function.tape.shared(self.arm.fields(), &T::from_f64);
        let entry = function.entry(arguments, &T::from_f64);
        self.arm.values(function, &shared, &entry, &T::from_f64)
    }

    /// The values of a function that does not solve with M.
    fn numbers<T: Scalar>(&self, function: Function, arguments: &[&[T]]) -> Vec<T> {
        let entries = self.compiled(function).layout.entries();
        let unknown = |_| vec![T::from_f64(f64::NAN); entries];
        self.at(function, arguments).unwrap_or_else(unknown)
    }

    /// Accelerations, and the columns of M^-1 that belong to `joints`. A column is the derivative by a torque, which a dual
    /// number carries along.
    fn responses(
        &self,
        state: &[&[f64]],
        tau: &DVector<f64>,
        joints: &[bool],
    ) -> Result<Responses<Dyn>, SingularMassMatrix> {
        let mut columns = DMatrix::zeros(tau.len(), tau.len());
        let state: Vec<_> = state.iter().map(|x| duals(x, |_| 0.0)).collect();
        let under = |j: usize| {
            let tau = duals(tau.as_slice(), |i| f64::from(u8::from(i == j)));
            let arguments = state.iter().map(Vec::as_slice).chain([tau.as_slice()]);
            let arguments: Vec<_> = arguments.collect();
            self.at(Function::ForwardDynamics, &arguments)
                .map(DVector::from_vec)
        };
        let mut free = None;
        for j in (0..tau.len()).filter(|j| joints[*j]) {
            let qdd = under(j)?;
            columns.set_column(j, &qdd.map(|x| x.slope));
            free = Some(qdd);
        }
        // Along no torque, where there is no such joint.
        let free = free.map_or_else(|| under(tau.len()), Ok)?;
        Ok((free.map(|x| x.value), columns))
    }
}

/// Numbers with a derivative.
fn duals(values: &[f64], slope: impl Fn(usize) -> f64) -> Vec<Dual> {
    let pairs = values.iter().enumerate();
    pairs.map(|(i, x)| Dual::new(*x, slope(i))).collect()
}

/// The entries of the pose of a base that moves, before other arguments.
fn behind_base<const N: usize, X>(
    base: Option<&Pose<f64>>,
    others: [&DVector<f64>; N],
    read: impl FnOnce(&[&[f64]]) -> X,
) -> X {
    let entries = base.map(Pose::entries);
    let base = entries.iter().map(|entries| entries.as_slice());
    let arguments = base.chain(others.map(DVector::as_slice));
    read(&arguments.collect::<Vec<_>>())
}

impl<M: Mark> EquationsOfMotion<M::Base> for RuntimeDynamics<'_, M> {
    fn size(&self) -> Dyn {
        Dyn(self.arm.dof())
    }

    fn accelerations(
        &self,
        place: <M::Base as Stand>::Place<'_>,
        v: &DVector<f64>,
        tau: &DVector<f64>,
    ) -> Result<DVector<f64>, SingularMassMatrix> {
        let (base, q) = M::Base::parts(place);
        let qdd = behind_base(base, [q, v, tau], |arguments| {
            self.at(Function::ForwardDynamics, arguments)
        });
        Ok(qdd?.into())
    }

    fn accelerations_and_responses(
        &self,
        place: <M::Base as Stand>::Place<'_>,
        v: &DVector<f64>,
        tau: &DVector<f64>,
        freedoms: &Vec<bool>,
    ) -> Result<Responses<Dyn>, SingularMassMatrix> {
        let (base, q) = M::Base::parts(place);
        behind_base(base, [q, v], |state| self.responses(state, tau, freedoms))
    }

    fn in_momenta(&self) -> Option<&dyn SizedMomenta<Dyn>> {
        M::in_momenta(self)
    }
}

impl<M: Stands> SizedMomenta<Dyn> for RuntimeDynamics<'_, M> {
    fn inertia(&self, q: &DVector<f64>) -> DMatrix<f64> {
        let entries = self.numbers(Function::MassMatrix, &[q.as_slice()]);
        DMatrix::from_vec(q.len(), q.len(), entries)
    }

    /// As that of generated arms: dT/dq = M' qd - V, with the rate M' of M along qd.
    fn force(&self, q: &DVector<f64>, qd: &DVector<f64>, tau: &DVector<f64>) -> DVector<f64> {
        let along = duals(q.as_slice(), |i| qd[i]);
        let entries = self.numbers(Function::MassMatrix, &[&along]);
        let slopes = entries.iter().map(|entry| entry.slope);
        let mass_rate = DMatrix::from_iterator(q.len(), q.len(), slopes);
        let rest = vec![0.0; q.len()];
        let bias = self.numbers(
            Function::InverseDynamics,
            &[q.as_slice(), qd.as_slice(), &rest],
        );
        tau + mass_rate * qd - DVector::from_vec(bias)
    }
}

impl<M: Mark> SizedModel<M::Base> for RuntimeDynamics<'_, M> {
    fn sized_table(&self) -> RuntimeTable {
        self.table.clone()
    }

    fn names(&self) -> Vec<String> {
        self.arm.joint_names().map(str::to_owned).collect()
    }

    fn sized_energies(
        &self,
        place: <M::Base as Stand>::Place<'_>,
        v: &DVector<f64>,
    ) -> Option<[f64; 2]> {
        let (base, q) = M::Base::parts(place);
        let kinetic = self.numbers(Function::KineticEnergy, &[q.as_slice(), v.as_slice()]);
        let potential = behind_base(base, [q], |place| {
            self.numbers(Function::PotentialEnergy, place)
        });
        Some([kinetic[0], potential[0]])
    }
}

impl SizedKinematics<Dyn> for RuntimeDynamics<'_, Tip> {
    fn tip_pose(&self, q: &DVector<f64>) -> Matrix4<f64> {
        let entries = self.numbers(Function::ForwardKinematics, &[q.as_slice()]);
        Matrix4::from_column_slice(&entries)
    }

    fn tip_jacobian(&self, q: &DVector<f64>) -> Matrix6xX<f64> {
        let entries = self.numbers(Function::Jacobian, &[q.as_slice()]);
        Matrix6xX::from_vec(entries)
    }
}
