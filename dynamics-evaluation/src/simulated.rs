//! A robot at run time as simulations take it: its number of joints is known at run time alone.

use dynamics_runtime::nalgebra::{DMatrix, DVector, Dyn};
use dynamics_runtime::{Dual, Pose, Scalar, SingularMassMatrix, SizedMomenta, table::RuntimeTable};
use dynamics_simulation::simulation::{EquationsOfMotion, Place, Responses, SizedModel};
use dynamics_symbolic::Function;

use crate::compiled::Compiled;
use crate::{EvaluationError, RuntimeRobot};

/// A [`RuntimeRobot`] that has the functions by which it moves, as
/// [`Simulation`](dynamics_simulation::Simulation) needs them: vectors are `DVector<f64>`, and laws are given a
/// [`Place`].
///
/// A force at the tip or at a frame is that of a [`RuntimeRobot::place`].
#[derive(Clone, Debug)]
pub struct RuntimeDynamics<'a> {
    arm: &'a RuntimeRobot,
    table: RuntimeTable,
    /// The ones of [`OF_SIMULATIONS`] that the robot needs.
    functions: Vec<&'a Compiled>,
}

/// The functions of a simulation. The first two are those of methods in momenta, the last two of a force at the tip.
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
    /// The names of the functions that a simulation needs: those of [`dynamics`](RuntimeRobot::dynamics), then the two of a
    /// force at the tip ([`place`](RuntimeRobot::place)).
    ///
    /// Forward dynamics moves the robot; methods that work in momenta need the mass matrix and inverse dynamics, energies
    /// are compared; the last two, `forward_kinematics` and `jacobian`, are those of a force at the tool.
    pub fn simulation_functions() -> [&'static str; 7] {
        OF_SIMULATIONS.map(Function::name)
    }

    /// The robot with its motion, which [`Simulation`](dynamics_simulation::Simulation) takes.
    ///
    /// ```
    /// # mod robot_dynamics {
    /// # pub use dynamics_simulation::*;
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
    /// [`EvaluationError::NotSimulated`] unless all
    /// [`simulation_functions`](RuntimeRobot::simulation_functions) except the two of the tip were requested; on a base that
    /// moves, `mass_matrix` and `inverse_dynamics` are not needed either.
    pub fn dynamics(&self) -> Result<RuntimeDynamics<'_>, EvaluationError> {
        let first = if self.base_moves() { 2 } else { 0 };
        // Each by itself, not a method of several that has its name.
        let compiled = |function: &Function| {
            let mut known = self.functions().iter();
            known
                .find(|known| known.request.function() == Some(*function))
                .ok_or_else(|| EvaluationError::NotSimulated(function.name().to_owned()))
        };
        let functions = OF_SIMULATIONS[first..5].iter().map(compiled);
        Ok(RuntimeDynamics {
            arm: self,
            table: self.table(),
            functions: functions.collect::<Result<_, _>>()?,
        })
    }

    /// Whether the base moves.
    pub(crate) fn base_moves(&self) -> bool {
        self.robot().floating().is_some()
    }

    /// Hands on arguments behind the entries of the pose of a base that moves.
    pub(crate) fn behind_base<const N: usize, X>(
        &self,
        place: &Place<Dyn>,
        others: [&DVector<f64>; N],
        read: impl FnOnce(&[&[f64]]) -> X,
    ) -> X {
        let pose = place.base.unwrap_or_else(Pose::identity).entries();
        let base = self.base_moves().then_some(pose.as_slice());
        let others = [&place.q].into_iter().chain(others);
        let arguments = base.into_iter().chain(others.map(DVector::as_slice));
        read(&arguments.collect::<Vec<_>>())
    }
}

impl RuntimeDynamics<'_> {
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

impl EquationsOfMotion<Dyn> for RuntimeDynamics<'_> {
    fn joints(&self) -> Dyn {
        Dyn(self.table.rows.len())
    }

    fn size(&self) -> Dyn {
        Dyn(self.arm.dof())
    }

    fn accelerations(
        &self,
        place: &Place<Dyn>,
        v: &DVector<f64>,
        tau: &DVector<f64>,
    ) -> Result<DVector<f64>, SingularMassMatrix> {
        let qdd = self.arm.behind_base(place, [v, tau], |arguments| {
            self.at(Function::ForwardDynamics, arguments)
        });
        Ok(qdd?.into())
    }

    fn accelerations_and_responses(
        &self,
        place: &Place<Dyn>,
        v: &DVector<f64>,
        tau: &DVector<f64>,
        freedoms: &Vec<bool>,
    ) -> Result<Responses<Dyn>, SingularMassMatrix> {
        let responses = |state: &[&[f64]]| self.responses(state, tau, freedoms);
        self.arm.behind_base(place, [v], responses)
    }

    fn in_momenta(&self) -> Option<&dyn SizedMomenta<Dyn>> {
        (!self.arm.base_moves()).then_some(self)
    }
}

impl SizedMomenta<Dyn> for RuntimeDynamics<'_> {
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

impl SizedModel<Dyn> for RuntimeDynamics<'_> {
    fn sized_table(&self) -> RuntimeTable {
        self.table.clone()
    }

    fn names(&self) -> Vec<String> {
        self.arm.joint_names().map(str::to_owned).collect()
    }

    fn sized_energies(&self, place: &Place<Dyn>, v: &DVector<f64>) -> Option<[f64; 2]> {
        let state = [place.q.as_slice(), v.as_slice()];
        let kinetic = self.numbers(Function::KineticEnergy, &state);
        let potential = self.arm.behind_base(place, [], |place| {
            self.numbers(Function::PotentialEnergy, place)
        });
        Some([kinetic[0], potential[0]])
    }
}
