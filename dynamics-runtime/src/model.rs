//! What a generated robot is to generic code.

#[cfg(feature = "std")]
use nalgebra::Matrix4;
use nalgebra::{SMatrix, SVector};

#[cfg(feature = "std")]
use crate::TaylorCoefficients;
use crate::{JointSines, Momenta, Scalar, SingularMassMatrix, Table};

/// An arm with `N` joints that can show the table it was generated from.
pub trait Model<const N: usize> {
    /// Names of the joints, from the base outwards.
    const JOINT_NAMES: [&'static str; N];

    /// Whether a generated function of q reads the sine and cosine of a joint's position:
    /// [`Configuration`](crate::Configuration) evaluates no others.
    const READS_ANGLE: [bool; N] = [true; N];

    /// The table as numbers.
    fn table(&self) -> Table<N>;
}

/// An arm whose joint accelerations can be computed: what a simulation needs.
pub trait ForwardDynamics<const N: usize> {
    /// Joint accelerations qdd of `M(q) qdd + V(q, qd) + G(q) + F(qd) = tau`.
    ///
    /// `q` in rad or m, `qd` per second, `tau` in N m or N.
    ///
    /// # Errors
    ///
    /// [`SingularMassMatrix`] where M(q) is not positive definite to working precision, or holds a
    /// NaN.
    fn forward_dynamics<T: Scalar>(
        &self,
        q: &SVector<T, N>,
        qd: &SVector<T, N>,
        tau: &SVector<T, N>,
    ) -> Result<SVector<T, N>, SingularMassMatrix>;
    /// The same, with the sines of the joint positions from `sines`: see
    /// [`Configuration`](crate::Configuration).
    #[doc(hidden)]
    #[inline]
    fn forward_dynamics_at<T: Scalar>(
        &self,
        sines: &impl JointSines<T>,
        q: &SVector<T, N>,
        qd: &SVector<T, N>,
        tau: &SVector<T, N>,
    ) -> Result<SVector<T, N>, SingularMassMatrix> {
        let _ = sines;
        self.forward_dynamics(q, qd, tau)
    }

    /// The arm in positions and momenta, which the structure-preserving methods of a
    /// [`Simulation`](crate::Simulation) need; `None` where it is not known in them.
    ///
    /// A generated arm is, if its functions include `mass_matrix` and `inverse_dynamics`. For an arm
    /// of your own with [`MassMatrix`] and [`InverseDynamics`] it is `Some(self)`.
    fn momenta(&self) -> Option<&dyn Momenta<N>> {
        None
    }
}

/// An arm whose mass matrix can be computed.
pub trait MassMatrix<const N: usize> {
    /// Mass matrix M(q), both triangles, reflected motor inertias included; kg m^2, kg m or kg.
    ///
    /// `q` in rad or m. None of it fails: what depends on an input that is not finite is not
    /// finite.
    fn mass_matrix<T: Scalar>(&self, q: &SVector<T, N>) -> SMatrix<T, N, N>;
    /// The same, with the sines of the joint positions from `sines`: see
    /// [`Configuration`](crate::Configuration).
    #[doc(hidden)]
    #[inline]
    fn mass_matrix_at<T: Scalar>(
        &self,
        sines: &impl JointSines<T>,
        q: &SVector<T, N>,
    ) -> SMatrix<T, N, N> {
        let _ = sines;
        self.mass_matrix(q)
    }
}

/// An arm whose Coriolis and centrifugal forces can be computed.
pub trait CoriolisVector<const N: usize> {
    /// Coriolis and centrifugal vector V(q, qd), N m or N.
    ///
    /// `q` in rad or m, `qd` per second.
    fn coriolis_vector<T: Scalar>(&self, q: &SVector<T, N>, qd: &SVector<T, N>) -> SVector<T, N>;
    /// The same, with the sines of the joint positions from `sines`: see
    /// [`Configuration`](crate::Configuration).
    #[doc(hidden)]
    #[inline]
    fn coriolis_vector_at<T: Scalar>(
        &self,
        sines: &impl JointSines<T>,
        q: &SVector<T, N>,
        qd: &SVector<T, N>,
    ) -> SVector<T, N> {
        let _ = sines;
        self.coriolis_vector(q, qd)
    }
}

/// An arm whose gravity forces can be computed.
pub trait GravityVector<const N: usize> {
    /// Gravity vector G(q) = dU/dq, N m or N.
    ///
    /// `q` in rad or m.
    fn gravity_vector<T: Scalar>(&self, q: &SVector<T, N>) -> SVector<T, N>;
    /// The same, with the sines of the joint positions from `sines`: see
    /// [`Configuration`](crate::Configuration).
    #[doc(hidden)]
    #[inline]
    fn gravity_vector_at<T: Scalar>(
        &self,
        sines: &impl JointSines<T>,
        q: &SVector<T, N>,
    ) -> SVector<T, N> {
        let _ = sines;
        self.gravity_vector(q)
    }
}

/// An arm whose joint forces can be computed from its motion.
pub trait InverseDynamics<const N: usize> {
    /// Inverse dynamics tau = M(q) qdd + V(q, qd) + G(q) + F(qd), N m or N.
    ///
    /// `q` in rad or m, `qd` per second, `qdd` per second squared.
    fn inverse_dynamics<T: Scalar>(
        &self,
        q: &SVector<T, N>,
        qd: &SVector<T, N>,
        qdd: &SVector<T, N>,
    ) -> SVector<T, N>;
    /// The same, with the sines of the joint positions from `sines`: see
    /// [`Configuration`](crate::Configuration).
    #[doc(hidden)]
    #[inline]
    fn inverse_dynamics_at<T: Scalar>(
        &self,
        sines: &impl JointSines<T>,
        q: &SVector<T, N>,
        qd: &SVector<T, N>,
        qdd: &SVector<T, N>,
    ) -> SVector<T, N> {
        let _ = sines;
        self.inverse_dynamics(q, qd, qdd)
    }
}

/// An arm whose mechanical energy can be computed.
pub trait Energy<const N: usize> {
    /// Kinetic energy 1/2 qd^T M(q) qd with the motors' reflected inertias, J.
    fn kinetic_energy<T: Scalar>(&self, q: &SVector<T, N>, qd: &SVector<T, N>) -> T;

    /// Potential energy U = -sum m g.c, zero where all centres of mass are at the base's origin, J.
    fn potential_energy<T: Scalar>(&self, q: &SVector<T, N>) -> T;
}

/// An arm all of whose generated functions can be evaluated at a state: what the checks need.
#[cfg(feature = "std")]
pub trait Evaluate<const N: usize>: Model<N> {
    /// Every function at one state, `None` where the function was not generated.
    ///
    /// `tau` are the joint torques at which the forward dynamics is evaluated.
    fn evaluate(&self, state: &State<N>, tau: &SVector<f64, N>) -> Evaluation<N>;
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
    /// M qdd + V + G + F.
    pub inverse_dynamics: Option<SVector<f64, N>>,
    /// qdd, at the torques that were given.
    pub forward_dynamics: Option<Result<SVector<f64, N>, SingularMassMatrix>>,
    /// Kinetic energy.
    pub kinetic_energy: Option<f64>,
    /// Potential energy.
    pub potential_energy: Option<f64>,
    /// V + G + F.
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
    /// Transform of the last frame in the base frame.
    pub forward_kinematics: Option<Matrix4<f64>>,
    /// Transform of every frame in the base frame.
    pub link_poses: Option<[Matrix4<f64>; N]>,
    /// Geometric Jacobian of the last frame's origin in the base frame.
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
