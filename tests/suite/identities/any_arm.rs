//! An arm as a trait object: what holds for it is compiled once for each number of joints, not once for
//! each robot.

use num_dual::Dual64;
use robot_dynamics::nalgebra::{Matrix4, SMatrix, SVector};
use robot_dynamics::{
    AccelerationDerivatives, DoubleDouble, Scalar, SingularMassMatrix, State, check::Evaluation,
    simulation::Momenta, table::Table,
};
use robots::Arm;

/// A trait for each function at one kind of number, so that an arm has those kinds of it that the
/// identities ask for, and the compiler writes no others.
macro_rules! functions {
    ($($trait:ident: $function:ident($($argument:ident),*) -> $value:ty;)*) => {$(
        pub(super) trait $trait<T, const N: usize, const P: usize> {
            fn $function(&self, $($argument: &SVector<T, N>),*) -> $value;
        }

        impl<T: Scalar, R: Arm<N, P>, const N: usize, const P: usize> $trait<T, N, P> for R {
            fn $function(&self, $($argument: &SVector<T, N>),*) -> $value {
                R::$function(self, $($argument),*)
            }
        }
    )*};
}

functions! {
    MassMatrix: mass_matrix(q) -> SMatrix<T, N, N>;
    CoriolisVector: coriolis_vector(q, qd) -> SVector<T, N>;
    GravityVector: gravity_vector(q) -> SVector<T, N>;
    FrictionVector: friction_vector(qd) -> SVector<T, N>;
    SpringVector: spring_vector(q) -> SVector<T, N>;
    BiasForce: bias_force(q, qd) -> SVector<T, N>;
    InverseDynamics: inverse_dynamics(q, qd, qdd) -> SVector<T, N>;
    ForwardDynamics: forward_dynamics(q, qd, tau) -> Result<SVector<T, N>, SingularMassMatrix>;
    CoriolisMatrix: coriolis_matrix(q, qd) -> SMatrix<T, N, N>;
    CoriolisCoefficients: coriolis_coefficients(q) -> SMatrix<T, N, P>;
    CentrifugalCoefficients: centrifugal_coefficients(q) -> SMatrix<T, N, N>;
    ForwardKinematics: forward_kinematics(q) -> Matrix4<T>;
    LinkPoses: link_poses(q) -> [Matrix4<T>; N];
    Jacobian: jacobian(q) -> SMatrix<T, 6, N>;
    KineticEnergy: kinetic_energy(q, qd) -> T;
    PotentialEnergy: potential_energy(q) -> T;
    ForceDerivatives: inverse_dynamics_derivatives(q, qd, qdd) -> (SMatrix<T, N, N>, SMatrix<T, N, N>);
    MotionDerivatives: forward_dynamics_derivatives(q, qd, tau)
        -> Result<AccelerationDerivatives<T, N>, SingularMassMatrix>;
}

/// All functions in doubles.
pub(super) trait Doubles<const N: usize, const P: usize>:
    MassMatrix<f64, N, P>
    + CoriolisVector<f64, N, P>
    + GravityVector<f64, N, P>
    + FrictionVector<f64, N, P>
    + SpringVector<f64, N, P>
    + BiasForce<f64, N, P>
    + InverseDynamics<f64, N, P>
    + ForwardDynamics<f64, N, P>
    + CoriolisMatrix<f64, N, P>
    + CoriolisCoefficients<f64, N, P>
    + CentrifugalCoefficients<f64, N, P>
    + ForwardKinematics<f64, N, P>
    + LinkPoses<f64, N, P>
    + Jacobian<f64, N, P>
    + KineticEnergy<f64, N, P>
    + PotentialEnergy<f64, N, P>
    + ForceDerivatives<f64, N, P>
    + MotionDerivatives<f64, N, P>
{
}

/// The functions that are differentiated.
pub(super) trait Duals<const N: usize, const P: usize>:
    MassMatrix<Dual64, N, P>
    + InverseDynamics<Dual64, N, P>
    + ForwardDynamics<Dual64, N, P>
    + ForwardKinematics<Dual64, N, P>
    + LinkPoses<Dual64, N, P>
    + KineticEnergy<Dual64, N, P>
    + PotentialEnergy<Dual64, N, P>
{
}

/// The functions that are compared in single precision.
pub(super) trait Singles<const N: usize, const P: usize>:
    MassMatrix<f32, N, P>
    + CoriolisVector<f32, N, P>
    + GravityVector<f32, N, P>
    + FrictionVector<f32, N, P>
    + SpringVector<f32, N, P>
    + InverseDynamics<f32, N, P>
    + ForwardDynamics<f32, N, P>
    + ForwardKinematics<f32, N, P>
    + ForceDerivatives<f32, N, P>
{
}

/// An arm of N joints, with P = N(N-1)/2 pairs of joints.
pub(super) trait AnyArm<const N: usize, const P: usize>:
    Doubles<N, P> + Duals<N, P> + Singles<N, P> + InverseDynamics<DoubleDouble, N, P>
{
    /// The name of its files in `tests/data`.
    fn file(&self) -> &'static str;
    fn table(&self) -> Table<N>;
    fn evaluate(&self, state: &State<N>, tau: &SVector<f64, N>) -> Evaluation;
    fn momenta(&self) -> Option<&dyn Momenta<N>>;
}

impl<R: Arm<N, P>, const N: usize, const P: usize> Doubles<N, P> for R {}
impl<R: Arm<N, P>, const N: usize, const P: usize> Duals<N, P> for R {}
impl<R: Arm<N, P>, const N: usize, const P: usize> Singles<N, P> for R {}

impl<R: Arm<N, P>, const N: usize, const P: usize> AnyArm<N, P> for R {
    fn file(&self) -> &'static str {
        R::FILE
    }

    fn table(&self) -> Table<N> {
        R::table(self)
    }

    fn evaluate(&self, state: &State<N>, tau: &SVector<f64, N>) -> Evaluation {
        R::evaluate(self, state, tau)
    }

    fn momenta(&self) -> Option<&dyn Momenta<N>> {
        R::momenta(self)
    }
}
