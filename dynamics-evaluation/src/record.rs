//! The values of functions where checks look for them.

use dynamics_runtime::nalgebra::{SMatrix, SVector};
use dynamics_runtime::{Evaluation, Scalar, SingularMassMatrix};
use dynamics_symbolic::Function;

/// Values that are read one after the other, matrices by columns.
struct Values<T>(std::vec::IntoIter<T>);

impl<T: Scalar> Values<T> {
    fn number(&mut self) -> T {
        self.0.next().unwrap_or_else(|| T::from_f64(f64::NAN))
    }

    fn matrix<const R: usize, const C: usize>(&mut self) -> SMatrix<T, R, C> {
        SMatrix::from_iterator((0..R * C).map(|_| self.number()))
    }

    /// One for each joint.
    fn each<const N: usize, const R: usize, const C: usize>(&mut self) -> [SMatrix<T, R, C>; N] {
        [(); N].map(|()| self.matrix())
    }

    /// The columns of a matrix of `N` rows whose width is known here alone.
    fn columns<const N: usize>(self) -> Vec<SVector<T, N>> {
        let values: Vec<T> = self.0.collect();
        values
            .chunks_exact(N)
            .map(SVector::from_column_slice)
            .collect()
    }
}

/// Puts the values of a function where they belong.
pub(crate) fn record<const N: usize, T: Scalar>(
    evaluation: &mut Evaluation<N, T>,
    function: Function,
    values: Result<Vec<T>, SingularMassMatrix>,
) {
    match values {
        Ok(values) => found(evaluation, function, Values(values.into_iter())),
        Err(error) => refused(evaluation, function, error),
    }
}

fn refused<const N: usize, T: Scalar>(
    evaluation: &mut Evaluation<N, T>,
    function: Function,
    error: SingularMassMatrix,
) {
    match function {
        Function::ForwardDynamics => evaluation.forward_dynamics = Some(Err(error)),
        Function::ForwardDynamicsAba => evaluation.forward_dynamics_aba = Some(Err(error)),
        Function::ForwardDynamicsDerivatives => {
            evaluation.forward_dynamics_derivatives = Some(Err(error));
        }
        Function::OperationalInertiaInverse => {
            evaluation.operational_inertia_inverse = Some(Err(error));
        }
        _ => {}
    }
}

fn found<const N: usize, T: Scalar>(
    evaluation: &mut Evaluation<N, T>,
    function: Function,
    mut values: Values<T>,
) {
    match function {
        Function::MassMatrix => evaluation.mass_matrix = Some(values.matrix()),
        Function::CoriolisVector => evaluation.coriolis_vector = Some(values.matrix()),
        Function::GravityVector => evaluation.gravity_vector = Some(values.matrix()),
        Function::FrictionVector => evaluation.friction_vector = Some(values.matrix()),
        Function::SpringVector => evaluation.spring_vector = Some(values.matrix()),
        Function::InverseDynamics => evaluation.inverse_dynamics = Some(values.matrix()),
        Function::ForwardDynamics => evaluation.forward_dynamics = Some(Ok(values.matrix())),
        Function::ForwardDynamicsAba => {
            evaluation.forward_dynamics_aba = Some(Ok(values.matrix()));
        }
        // No program over numbers: a runtime robot has none.
        Function::TaylorSeries => {}
        Function::KineticEnergy => evaluation.kinetic_energy = Some(values.number()),
        Function::PotentialEnergy => evaluation.potential_energy = Some(values.number()),
        Function::BiasForce => evaluation.bias_force = Some(values.matrix()),
        Function::CoriolisMatrix => evaluation.coriolis_matrix = Some(values.matrix()),
        Function::CoriolisCoefficients => {
            evaluation.coriolis_coefficients = Some(values.columns());
        }
        Function::CentrifugalCoefficients => {
            evaluation.centrifugal_coefficients = Some(values.matrix());
        }
        Function::ForwardKinematics => evaluation.forward_kinematics = Some(values.matrix()),
        Function::LinkPoses => evaluation.link_poses = Some(values.each()),
        Function::Jacobian => evaluation.jacobian = Some(values.matrix()),
        Function::InverseDynamicsDerivatives => {
            evaluation.inverse_dynamics_derivatives = Some((values.matrix(), values.matrix()));
        }
        Function::ForwardDynamicsDerivatives => {
            let derivatives = (values.matrix(), values.matrix(), values.matrix());
            evaluation.forward_dynamics_derivatives = Some(Ok(derivatives));
        }
        Function::Regressor => evaluation.regressor = Some(values.columns()),
        Function::BaseParameters => evaluation.base_parameters = Some(values.0.collect()),
        Function::WrenchTorques => evaluation.wrench_torques = Some(values.matrix()),
        Function::ToolVelocity => evaluation.tool_velocity = Some(values.matrix()),
        Function::ToolAcceleration => evaluation.tool_acceleration = Some(values.matrix()),
        Function::JacobianRate => evaluation.jacobian_rate = Some(values.matrix()),
        Function::LinkJacobians => evaluation.link_jacobians = Some(values.each()),
        Function::CenterOfMass => evaluation.center_of_mass = Some(values.matrix()),
        Function::CenterOfMassJacobian => {
            evaluation.center_of_mass_jacobian = Some(values.matrix());
        }
        Function::OperationalInertiaInverse => {
            evaluation.operational_inertia_inverse = Some(Ok(values.matrix()));
        }
        Function::GeneralizedMomentum => evaluation.generalized_momentum = Some(values.matrix()),
        Function::MomentumBias => evaluation.momentum_bias = Some(values.matrix()),
        Function::PassivityTorque => evaluation.passivity_torque = Some(values.matrix()),
        Function::PassivityRegressor => evaluation.passivity_regressor = Some(values.columns()),
        Function::EnergyRegressors => {
            let energies: Vec<T> = values.0.collect();
            let (kinetic, potential) = energies.split_at(energies.len() / 2);
            evaluation.energy_regressors = Some((kinetic.to_vec(), potential.to_vec()));
        }
        Function::InverseDynamicsRates => {
            evaluation.inverse_dynamics_rates = Some((values.matrix(), values.matrix()));
        }
        Function::InverseDynamicsSecondDerivatives => {
            let derivatives = (values.each(), values.each(), values.each(), values.each());
            evaluation.inverse_dynamics_second_derivatives = Some(Box::new(derivatives));
        }
    }
}
