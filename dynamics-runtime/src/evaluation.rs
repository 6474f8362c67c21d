//! A state of an arm, and the values of all generated functions there.

#[cfg(feature = "std")]
use nalgebra::{Matrix4, Matrix6, Vector3};
use nalgebra::{SMatrix, SVector, Vector6};

#[cfg(feature = "std")]
use crate::{Model, Scalar, SingularMassMatrix, TaylorCoefficients};

/// An arm that evaluates all of its generated functions at a state, as the checks need it.
#[cfg(feature = "std")]
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no robot that `robot_dynamics!` made",
    note = "checks compare what the macro generated with the table that it was generated from"
)]
pub trait Evaluate<const N: usize>: Model<N> {
    /// Every function at one state, `None` where the function was not generated.
    ///
    /// `tau` are the joint torques at which the forward dynamics is evaluated.
    fn evaluate(&self, state: &State<N>, tau: &SVector<f64, N>) -> Evaluation<N>;

    /// The same in the arithmetic `T`; `real` turns the doubles of the state into its numbers. In
    /// [`Certified`](crate::Certified) numbers the values carry bounds of their rounding errors.
    ///
    /// Generated arms implement it. By default, every value is `None`.
    fn evaluate_in<T: Scalar>(
        &self,
        state: &State<N>,
        tau: &SVector<f64, N>,
        real: fn(f64) -> T,
    ) -> Evaluation<N, T> {
        let _ = (state, tau, real);
        Evaluation::default()
    }

    /// Calls `found` for each method that returns several functions, with its name and the values of these functions
    /// at one state.
    fn evaluate_parts(
        &self,
        state: &State<N>,
        tau: &SVector<f64, N>,
        found: &mut dyn FnMut(&str, Evaluation<N>),
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

/// Some functions have arguments that a state does not hold. Checks make them of the state, so that the state is all
/// that they choose: these arguments are as fast as the state, and none is a multiple of another argument of the same
/// function.
impl<const N: usize> State<N> {
    /// qd_r, a reference velocity.
    #[doc(hidden)]
    pub fn reference_velocity(&self) -> SVector<f64, N> {
        self.qdd * 0.25
    }

    /// qdd_r, a reference acceleration.
    #[doc(hidden)]
    pub fn reference_acceleration(&self) -> SVector<f64, N> {
        self.qd * 4.0 - self.qdd * 0.5
    }

    /// The rates of the accelerations.
    #[doc(hidden)]
    pub fn jerk(&self) -> SVector<f64, N> {
        self.qdd * -2.0 + self.qd * 8.0
    }

    /// The rates of the jerk.
    #[doc(hidden)]
    pub fn snap(&self) -> SVector<f64, N> {
        self.qdd * 8.0 - self.qd * 4.0
    }

    /// A force on the tip and a moment about its origin: the same at every state.
    #[doc(hidden)]
    pub fn wrench() -> Vector6<f64> {
        Vector6::new(5.0, -3.0, 8.0, 2.0, -1.0, 0.5)
    }
}

/// Values of the generated functions at one state, `None` where a function was not generated.
#[cfg(feature = "std")]
#[derive(Clone, Debug)]
pub struct Evaluation<const N: usize, T: Scalar = f64> {
    /// M(q).
    pub mass_matrix: Option<SMatrix<T, N, N>>,
    /// V(q, qd).
    pub coriolis_vector: Option<SVector<T, N>>,
    /// G(q).
    pub gravity_vector: Option<SVector<T, N>>,
    /// F(qd).
    pub friction_vector: Option<SVector<T, N>>,
    /// K(q).
    pub spring_vector: Option<SVector<T, N>>,
    /// M qdd + V + G + K + F.
    pub inverse_dynamics: Option<SVector<T, N>>,
    /// qdd, at the torques that were given.
    pub forward_dynamics: Option<Result<SVector<T, N>, SingularMassMatrix>>,
    /// Kinetic energy.
    pub kinetic_energy: Option<T>,
    /// Potential energy.
    pub potential_energy: Option<T>,
    /// V + G + K + F.
    pub bias_force: Option<SVector<T, N>>,
    /// C(q, qd) of the Christoffel symbols of the first kind.
    pub coriolis_matrix: Option<SMatrix<T, N, N>>,
    /// B(q) of `V = B(q) [qd qd] + C(q) [qd^2]`: the column of each pair of joints in the order
    /// (1,2), (1,3), ..., (N-1,N).
    pub coriolis_coefficients: Option<Vec<SVector<T, N>>>,
    /// C(q) of `V = B(q) [qd qd] + C(q) [qd^2]`: column j belongs to the square of joint j's
    /// velocity.
    pub centrifugal_coefficients: Option<SMatrix<T, N, N>>,
    /// B(q) [qd qd] + C(q) [qd^2], where both coefficient functions exist.
    pub configuration_space_coriolis: Option<SVector<T, N>>,
    /// Transform of the tip in the world.
    pub forward_kinematics: Option<Matrix4<T>>,
    /// Transform of every link frame in the world.
    pub link_poses: Option<[Matrix4<T>; N]>,
    /// Geometric Jacobian of the tip's origin in the world.
    pub jacobian: Option<SMatrix<T, 6, N>>,
    /// Y(q, qd, qdd): the column of each base parameter.
    pub regressor: Option<Vec<SVector<T, N>>>,
    /// The base inertial parameters.
    pub base_parameters: Option<Vec<T>>,
    /// Y times the base parameters, M qdd + V + G, where both functions exist.
    pub regressor_forces: Option<SVector<T, N>>,
    /// d tau/dq and d tau/dqd.
    pub inverse_dynamics_derivatives: Option<(SMatrix<T, N, N>, SMatrix<T, N, N>)>,
    /// d qdd/dq, d qdd/dqd and the inverse of M, at the torques that were given.
    pub forward_dynamics_derivatives:
        Option<Result<AccelerationDerivatives<T, N>, SingularMassMatrix>>,
    /// qdd by articulated bodies, at the torques that were given.
    pub forward_dynamics_aba: Option<Result<SVector<T, N>, SingularMassMatrix>>,
    /// Taylor coefficients up to order [`Evaluation::TAYLOR_ORDER`], at the torques that were given.
    pub taylor_series: Option<Result<TaylorCoefficients<T, N>, SingularMassMatrix>>,
    /// Joint torques of a wrench at the tip.
    pub wrench_torques: Option<SVector<T, N>>,
    /// Velocity of the tip.
    pub tool_velocity: Option<Vector6<T>>,
    /// Acceleration of the tip.
    pub tool_acceleration: Option<Vector6<T>>,
    /// Rate of the geometric Jacobian.
    pub jacobian_rate: Option<SMatrix<T, 6, N>>,
    /// Geometric Jacobians of the origins of all frames.
    pub link_jacobians: Option<[SMatrix<T, 6, N>; N]>,
    /// Centre of mass of all links.
    pub center_of_mass: Option<Vector3<T>>,
    /// Its Jacobian.
    pub center_of_mass_jacobian: Option<SMatrix<T, 3, N>>,
    /// J M^-1 J'.
    pub operational_inertia_inverse: Option<Result<Matrix6<T>, SingularMassMatrix>>,
    /// M qd.
    pub generalized_momentum: Option<SVector<T, N>>,
    /// C' qd - G - K - F.
    pub momentum_bias: Option<SVector<T, N>>,
    /// M qdd_r + C qd_r + G + K + F, for the reference motion of the state.
    pub passivity_torque: Option<SVector<T, N>>,
    /// The column of each base parameter in M qdd_r + C qd_r + G.
    pub passivity_regressor: Option<Vec<SVector<T, N>>>,
    /// It times the base parameters, where both functions exist.
    pub passivity_regressor_forces: Option<SVector<T, N>>,
    /// What each base parameter has of kinetic and of potential energy.
    pub energy_regressors: Option<(Vec<T>, Vec<T>)>,
    /// The energies by these and the base parameters, where both functions exist.
    pub energies_of_parameters: Option<(T, T)>,
    /// First and second derivative of the torques by time.
    pub inverse_dynamics_rates: Option<(SVector<T, N>, SVector<T, N>)>,
    /// Second derivatives of the torques, and dM/dq.
    pub inverse_dynamics_second_derivatives: Option<Box<SecondDerivatives<T, N>>>,
}

/// Nothing was generated.
#[cfg(feature = "std")]
impl<const N: usize, T: Scalar> Default for Evaluation<N, T> {
    fn default() -> Self {
        Evaluation {
            mass_matrix: None,
            coriolis_vector: None,
            gravity_vector: None,
            friction_vector: None,
            spring_vector: None,
            inverse_dynamics: None,
            forward_dynamics: None,
            kinetic_energy: None,
            potential_energy: None,
            bias_force: None,
            coriolis_matrix: None,
            coriolis_coefficients: None,
            centrifugal_coefficients: None,
            configuration_space_coriolis: None,
            forward_kinematics: None,
            link_poses: None,
            jacobian: None,
            regressor: None,
            base_parameters: None,
            regressor_forces: None,
            inverse_dynamics_derivatives: None,
            forward_dynamics_derivatives: None,
            forward_dynamics_aba: None,
            taylor_series: None,
            wrench_torques: None,
            tool_velocity: None,
            tool_acceleration: None,
            jacobian_rate: None,
            link_jacobians: None,
            center_of_mass: None,
            center_of_mass_jacobian: None,
            operational_inertia_inverse: None,
            generalized_momentum: None,
            momentum_bias: None,
            passivity_torque: None,
            passivity_regressor: None,
            passivity_regressor_forces: None,
            energy_regressors: None,
            energies_of_parameters: None,
            inverse_dynamics_rates: None,
            inverse_dynamics_second_derivatives: None,
        }
    }
}

#[cfg(feature = "std")]
impl<const N: usize> Evaluation<N> {
    /// The order of the Taylor series: accelerations and jerks are compared.
    pub const TAYLOR_ORDER: usize = 3;
}

#[cfg(feature = "std")]
impl<const N: usize, T: Scalar> Evaluation<N, T> {
    /// With what follows from two functions, where there are both: regressors times the base parameters,
    /// and the velocity terms of the configuration-space form (Craig, Introduction to Robotics, 3rd ed.,
    /// equation 6.63). `qd` are the joint velocities.
    #[must_use]
    pub fn combined(mut self, qd: &SVector<T, N>) -> Self {
        let parameters = self.base_parameters.as_ref();
        self.regressor_forces = combination(self.regressor.as_ref(), parameters);
        self.passivity_regressor_forces =
            combination(self.passivity_regressor.as_ref(), parameters);
        self.energies_of_parameters = self.energies_of_parameters();
        self.configuration_space_coriolis = self.configuration_space_coriolis(qd);
        self
    }

    fn energies_of_parameters(&self) -> Option<(T, T)> {
        let (kinetic, potential) = self.energy_regressors.as_ref()?;
        let parameters = self.base_parameters.as_ref()?;
        let product = |regressor: &[T]| {
            let terms = regressor.iter().zip(parameters);
            terms.fold(T::from_f64(0.0), |sum, (a, b)| sum + *a * *b)
        };
        Some((product(kinetic), product(potential)))
    }

    /// `B [qd qd] + C [qd^2]`: `[qd qd]` holds the products in the order (1,2), (1,3), ..., (n-1,n).
    fn configuration_space_coriolis(&self, qd: &SVector<T, N>) -> Option<SVector<T, N>> {
        let products = (0..N).flat_map(|i| (i + 1..N).map(move |j| qd[i] * qd[j]));
        let coriolis = sum_of_columns(self.coriolis_coefficients.as_ref()?, products);
        let centrifugal = columns(self.centrifugal_coefficients.as_ref()?);
        let centrifugal = sum_of_columns(&centrifugal, qd.iter().map(|x| *x * *x));
        Some(coriolis.zip_map(&centrifugal, |a, b| a + b))
    }
}

/// The sum of columns, each times its parameter.
#[cfg(feature = "std")]
fn combination<const N: usize, T: Scalar>(
    columns: Option<&Vec<SVector<T, N>>>,
    parameters: Option<&Vec<T>>,
) -> Option<SVector<T, N>> {
    Some(sum_of_columns(columns?, parameters?.iter().copied()))
}

/// The sum of columns, each times its factor.
#[cfg(feature = "std")]
fn sum_of_columns<const N: usize, T: Scalar>(
    columns: &[SVector<T, N>],
    factors: impl Iterator<Item = T>,
) -> SVector<T, N> {
    let terms = columns.iter().zip(factors);
    terms.fold(SVector::repeat(T::from_f64(0.0)), |sum, (column, x)| {
        sum.zip_map(column, |sum, entry| sum + entry * x)
    })
}

/// The columns of a matrix whose width a field of [`Evaluation`] does not name.
#[cfg(feature = "std")]
#[doc(hidden)]
pub fn columns<T: Scalar, const R: usize, const C: usize>(
    matrix: &SMatrix<T, R, C>,
) -> Vec<SVector<T, R>> {
    let columns = matrix.column_iter();
    columns.map(|column| column.into_owned()).collect()
}

/// What would fill the stack of a long arm.
#[cfg(feature = "std")]
#[doc(hidden)]
pub fn boxed<T>(value: T) -> Box<T> {
    Box::new(value)
}

/// Two vectors whose length a field of [`Evaluation`] does not name.
#[cfg(feature = "std")]
#[doc(hidden)]
pub fn vectors<T: Scalar, const P: usize>(
    (first, second): &(SVector<T, P>, SVector<T, P>),
) -> (Vec<T>, Vec<T>) {
    (first.as_slice().to_vec(), second.as_slice().to_vec())
}

/// d2 tau/dq dq, d2 tau/dqd dqd, d2 tau/dq dqd and dM/dq, each a matrix for every joint force: entry
/// `[i][(j, k)]` is that of tau_i by q_j and q_k, by qd_j and qd_k, by q_j and qd_k, and dM_ij/dq_k.
pub type SecondDerivatives<T, const N: usize> = (
    [SMatrix<T, N, N>; N],
    [SMatrix<T, N, N>; N],
    [SMatrix<T, N, N>; N],
    [SMatrix<T, N, N>; N],
);

/// d qdd/dq, d qdd/dqd and d qdd/d tau, the inverse of M.
pub type AccelerationDerivatives<T, const N: usize> =
    (SMatrix<T, N, N>, SMatrix<T, N, N>, SMatrix<T, N, N>);
