//! A robot at run time as simulations take it: its number of joints is known at run time alone.

use dynamics_runtime::nalgebra::{DMatrix, DVector, Dyn, Matrix4, Matrix6xX};
use dynamics_runtime::{
    Dual, Scalar, SingularMassMatrix, SizedKinematics, SizedMomenta,
    simulation::{EquationsOfMotion, Responses, SizedModel},
    table::RuntimeTable,
};
use dynamics_symbolic::{Function, Request};

use crate::compiled::Compiled;
use crate::{EvaluationError, RuntimeRobot};

/// A [`RuntimeRobot`] that has the functions by which an arm moves, as
/// [`Simulation`](dynamics_runtime::Simulation) needs them: vectors are `DVector<f64>`.
///
/// With a [`Tip`], it has the kinematics of its tip too: a simulation of it may have a force at the tool.
#[derive(Clone, Debug)]
pub struct RuntimeDynamics<'a, K = ()> {
    arm: &'a RuntimeRobot,
    table: RuntimeTable,
    mass_matrix: &'a Compiled,
    inverse_dynamics: &'a Compiled,
    forward_dynamics: &'a Compiled,
    kinetic_energy: &'a Compiled,
    potential_energy: &'a Compiled,
    tip: K,
}

/// The functions of the tip of a [`RuntimeDynamics`].
#[derive(Clone, Copy, Debug)]
pub struct Tip<'a> {
    forward_kinematics: &'a Compiled,
    jacobian: &'a Compiled,
}

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

    /// A function by itself, not a method of several that has its name.
    fn simulated(&self, function: Function) -> Result<&Compiled, EvaluationError> {
        let mut known = self.functions().iter();
        known
            .find(|known| known.request == Request::One(function))
            .ok_or_else(|| EvaluationError::NotSimulated(function.name().to_owned()))
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
    /// [`EvaluationError::NotSimulated`] unless all [`simulation_functions`](RuntimeRobot::simulation_functions) but the
    /// two of the tip were asked for.
    pub fn dynamics(&self) -> Result<RuntimeDynamics<'_>, EvaluationError> {
        Ok(RuntimeDynamics {
            arm: self,
            table: self.table(),
            mass_matrix: self.simulated(Function::MassMatrix)?,
            inverse_dynamics: self.simulated(Function::InverseDynamics)?,
            forward_dynamics: self.simulated(Function::ForwardDynamics)?,
            kinetic_energy: self.simulated(Function::KineticEnergy)?,
            potential_energy: self.simulated(Function::PotentialEnergy)?,
            tip: (),
        })
    }
}

impl<'a> RuntimeDynamics<'a> {
    /// The arm with its tip: its simulation may have a force at the tool.
    ///
    /// # Errors
    ///
    /// [`EvaluationError::NotSimulated`] where `forward_kinematics` or `jacobian` was not asked for.
    pub fn with_tip(self) -> Result<RuntimeDynamics<'a, Tip<'a>>, EvaluationError> {
        let tip = Tip {
            forward_kinematics: self.arm.simulated(Function::ForwardKinematics)?,
            jacobian: self.arm.simulated(Function::Jacobian)?,
        };
        Ok(RuntimeDynamics {
            arm: self.arm,
            table: self.table,
            mass_matrix: self.mass_matrix,
            inverse_dynamics: self.inverse_dynamics,
            forward_dynamics: self.forward_dynamics,
            kinetic_energy: self.kinetic_energy,
            potential_energy: self.potential_energy,
            tip,
        })
    }
}

impl<K> RuntimeDynamics<'_, K> {
    /// The values of a function, in the arithmetic of its arguments.
    fn at<T: Scalar>(
        &self,
        function: &Compiled,
        arguments: &[&[T]],
    ) -> Result<Vec<T>, SingularMassMatrix> {
        let shared = function.tape.shared(self.arm.fields(), &T::from_f64);
        let entry = function.entry(arguments, &T::from_f64);
        self.arm.values(function, &shared, &entry, &T::from_f64)
    }

    /// The values of a function that does not solve with M.
    fn numbers<T: Scalar>(&self, function: &Compiled, arguments: &[&[T]]) -> Vec<T> {
        let entries = function.layout.entries();
        let unknown = |_| vec![T::from_f64(f64::NAN); entries];
        self.at(function, arguments).unwrap_or_else(unknown)
    }
}

/// Numbers with a derivative.
fn duals(values: &DVector<f64>, slope: impl Fn(usize) -> f64) -> Vec<Dual> {
    let pairs = values.iter().enumerate();
    pairs.map(|(i, x)| Dual::new(*x, slope(i))).collect()
}

impl<K> EquationsOfMotion<Dyn> for RuntimeDynamics<'_, K> {
    fn size(&self) -> Dyn {
        Dyn(self.arm.dof())
    }

    fn accelerations(
        &self,
        q: &DVector<f64>,
        qd: &DVector<f64>,
        tau: &DVector<f64>,
    ) -> Result<DVector<f64>, SingularMassMatrix> {
        let arguments = [q, qd, tau].map(DVector::as_slice);
        Ok(self.at(self.forward_dynamics, &arguments)?.into())
    }

    /// A column of M^-1 is the derivative by a torque, which a dual number carries along.
    fn accelerations_and_responses(
        &self,
        q: &DVector<f64>,
        qd: &DVector<f64>,
        tau: &DVector<f64>,
        joints: &Vec<bool>,
    ) -> Result<Responses<Dyn>, SingularMassMatrix> {
        let mut columns = DMatrix::zeros(q.len(), q.len());
        let [positions, velocities] = [q, qd].map(|vector| duals(vector, |_| 0.0));
        let mut free = None;
        for j in (0..q.len()).filter(|j| joints[*j]) {
            let tau = duals(tau, |i| f64::from(u8::from(i == j)));
            let entries = self.at(self.forward_dynamics, &[&positions, &velocities, &tau])?;
            let qdd = DVector::from_vec(entries);
            columns.set_column(j, &qdd.map(|x| x.slope));
            free = Some(qdd.map(|x| x.value));
        }
        match free {
            Some(free) => Ok((free, columns)),
            None => Ok((self.accelerations(q, qd, tau)?, columns)),
        }
    }

    fn in_momenta(&self) -> Option<&dyn SizedMomenta<Dyn>> {
        Some(self)
    }
}

impl<K> SizedMomenta<Dyn> for RuntimeDynamics<'_, K> {
    fn inertia(&self, q: &DVector<f64>) -> DMatrix<f64> {
        let entries = self.numbers(self.mass_matrix, &[q.as_slice()]);
        DMatrix::from_vec(q.len(), q.len(), entries)
    }

    /// As that of generated arms: dT/dq = M' qd - V, with the rate M' of M along qd.
    fn force(&self, q: &DVector<f64>, qd: &DVector<f64>, tau: &DVector<f64>) -> DVector<f64> {
        let along = duals(q, |i| qd[i]);
        let entries = self.numbers(self.mass_matrix, &[&along]);
        let slopes = entries.iter().map(|entry| entry.slope);
        let mass_rate = DMatrix::from_iterator(q.len(), q.len(), slopes);
        let rest = vec![0.0; q.len()];
        let bias = self.numbers(self.inverse_dynamics, &[q.as_slice(), qd.as_slice(), &rest]);
        tau + mass_rate * qd - DVector::from_vec(bias)
    }
}

impl<K> SizedModel<Dyn> for RuntimeDynamics<'_, K> {
    fn sized_table(&self) -> RuntimeTable {
        self.table.clone()
    }

    fn names(&self) -> Vec<String> {
        self.arm.joint_names().map(str::to_owned).collect()
    }

    fn sized_energies(&self, q: &DVector<f64>, qd: &DVector<f64>) -> Option<[f64; 2]> {
        let kinetic = self.numbers(self.kinetic_energy, &[q.as_slice(), qd.as_slice()])[0];
        Some([
            kinetic,
            self.numbers(self.potential_energy, &[q.as_slice()])[0],
        ])
    }
}

impl<'a> SizedKinematics<Dyn> for RuntimeDynamics<'a, Tip<'a>> {
    fn tip_pose(&self, q: &DVector<f64>) -> Matrix4<f64> {
        let entries = self.numbers(self.tip.forward_kinematics, &[q.as_slice()]);
        Matrix4::from_column_slice(&entries)
    }

    fn tip_jacobian(&self, q: &DVector<f64>) -> Matrix6xX<f64> {
        let entries = self.numbers(self.tip.jacobian, &[q.as_slice()]);
        Matrix6xX::from_vec(entries)
    }
}
