//! A state of an arm, and the values of all generated functions there.

#[cfg(feature = "std")]
use nalgebra::Matrix4;
use nalgebra::{SMatrix, SVector};

#[cfg(feature = "std")]
use crate::{Model, SingularMassMatrix, TaylorCoefficients};

/// An arm all of whose generated functions can be evaluated at a state: what the checks need.
#[cfg(feature = "std")]
pub trait Evaluate<const N: usize>: Model<N> {
    /// Every function at one state, `None` where the function was not generated.
    ///
    /// `tau` are the joint torques at which the forward dynamics is evaluated.
    fn evaluate(&self, state: &State<N>, tau: &SVector<f64, N>) -> Evaluation<N>;

    /// Calls `found` with each method that returns several functions: its name, and its parts at one
    /// state.
    fn evaluate_parts(
        &self,
        state: &State<N>,
        tau: &SVector<f64, N>,
        found: &mut dyn FnMut(&'static str, Evaluation<N>),
    ) {
        let _ = (state, tau, found);
    }
}

/// Position, velocity and acceleration of all joints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State<const N: usize> {
    /// Joint positions, rad or m.
    pub q: SVector<f64, N>,
    /// Joint velocities, rad/s or m/s.
    pub qd: SVector<f64, N>,
    /// Joint accelerations, rad/s^2 or m/s^2.
    pub qdd: SVector<f64, N>,
}

/// Values of the generated functions at one state, `None` where a function was not generated.
#[cfg(feature = "std")]
#[derive(Clone, Debug, Default)]
pub struct Evaluation<const N: usize> {
    /// M(q).
    pub mass_matrix: Option<SMatrix<f64, N, N>>,
    /// V(q, qd).
    pub coriolis_vector: Option<SVector<f64, N>>,
    /// G(q).
    pub gravity_vector: Option<SVector<f64, N>>,
    /// F(qd).
    pub friction_vector: Option<SVector<f64, N>>,
    /// K(q).
    pub spring_vector: Option<SVector<f64, N>>,
    /// M qdd + V + G + K + F.
    pub inverse_dynamics: Option<SVector<f64, N>>,
    /// qdd, at the torques that were given.
    pub forward_dynamics: Option<Result<SVector<f64, N>, SingularMassMatrix>>,
    /// Kinetic energy.
    pub kinetic_energy: Option<f64>,
    /// Potential energy.
    pub potential_energy: Option<f64>,
    /// V + G + K + F.
    pub bias_force: Option<SVector<f64, N>>,
    /// C(q, qd) of the Christoffel symbols of the first kind.
    pub coriolis_matrix: Option<SMatrix<f64, N, N>>,
    /// B(q) of `V = B(q) [qd qd] + C(q) [qd^2]`: the column of each pair of joints in the order
    /// (1,2), (1,3), ..., (N-1,N).
    pub coriolis_coefficients: Option<Vec<SVector<f64, N>>>,
    /// C(q) of `V = B(q) [qd qd] + C(q) [qd^2]`: column j belongs to the square of joint j's
    /// velocity.
    pub centrifugal_coefficients: Option<SMatrix<f64, N, N>>,
    /// B(q) [qd qd] + C(q) [qd^2], where both coefficient functions exist.
    pub configuration_space_coriolis: Option<SVector<f64, N>>,
    /// Transform of the tip in the world.
    pub forward_kinematics: Option<Matrix4<f64>>,
    /// Transform of every link frame in the world.
    pub link_poses: Option<[Matrix4<f64>; N]>,
    /// Geometric Jacobian of the tip's origin in the world.
    pub jacobian: Option<SMatrix<f64, 6, N>>,
    /// Y(q, qd, qdd): the column of each base parameter.
    pub regressor: Option<Vec<SVector<f64, N>>>,
    /// The base inertial parameters.
    pub base_parameters: Option<Vec<f64>>,
    /// Y times the base parameters, M qdd + V + G, where both functions exist.
    pub regressor_forces: Option<SVector<f64, N>>,
    /// d tau/dq and d tau/dqd.
    pub inverse_dynamics_derivatives: Option<(SMatrix<f64, N, N>, SMatrix<f64, N, N>)>,
    /// d qdd/dq, d qdd/dqd and the inverse of M, at the torques that were given.
    pub forward_dynamics_derivatives:
        Option<Result<AccelerationDerivatives<f64, N>, SingularMassMatrix>>,
    /// qdd by articulated bodies, at the torques that were given.
    pub forward_dynamics_aba: Option<Result<SVector<f64, N>, SingularMassMatrix>>,
    /// Taylor coefficients up to order [`Evaluation::TAYLOR_ORDER`], at the torques that were given.
    pub taylor_series: Option<Result<TaylorCoefficients<f64, N>, SingularMassMatrix>>,
}

#[cfg(feature = "std")]
impl<const N: usize> Evaluation<N> {
    /// The order of the Taylor series: accelerations and jerks are compared.
    pub const TAYLOR_ORDER: usize = 3;

    /// With what follows from two functions, where there are both: Y times the base parameters, and
    /// the velocity terms of the configuration-space form (Craig, Introduction to Robotics, 3rd ed.,
    /// equation 6.63).
    #[must_use]
    pub fn combined(mut self, state: &State<N>) -> Self {
        self.regressor_forces = self.regressor_forces();
        self.configuration_space_coriolis = self.configuration_space_coriolis(&state.qd);
        self
    }

    fn regressor_forces(&self) -> Option<SVector<f64, N>> {
        let columns = self.regressor.as_ref()?.iter();
        let terms = columns.zip(self.base_parameters.as_ref()?);
        Some(terms.fold(SVector::zeros(), |sum, (column, x)| sum + column * *x))
    }

    /// `B [qd qd] + C [qd^2]`: `[qd qd]` holds the products in the order (1,2), (1,3), ..., (n-1,n).
    fn configuration_space_coriolis(&self, qd: &SVector<f64, N>) -> Option<SVector<f64, N>> {
        let products = (0..N).flat_map(|i| (i + 1..N).map(move |j| qd[i] * qd[j]));
        let terms = self.coriolis_coefficients.as_ref()?.iter().zip(products);
        let coriolis = terms.fold(SVector::zeros(), |sum, (column, x)| sum + column * x);
        Some(coriolis + self.centrifugal_coefficients? * qd.component_mul(qd))
    }
}

/// The columns of a matrix whose width a field of [`Evaluation`] does not name.
#[cfg(feature = "std")]
#[doc(hidden)]
pub fn columns<const R: usize, const C: usize>(
    matrix: &SMatrix<f64, R, C>,
) -> Vec<SVector<f64, R>> {
    let columns = matrix.column_iter();
    columns.map(|column| column.into_owned()).collect()
}

/// d qdd/dq, d qdd/dqd and d qdd/d tau, the inverse of M.
pub type AccelerationDerivatives<T, const N: usize> =
    (SMatrix<T, N, N>, SMatrix<T, N, N>, SMatrix<T, N, N>);
