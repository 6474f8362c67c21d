//! The generated methods behind one trait, so that a test can be written once for all robots.

use robot_dynamics::nalgebra::{Matrix4, SMatrix, SVector};
use robot_dynamics::{
    AccelerationDerivatives, Energy, ForwardDynamics, Scalar, SingularMassMatrix, check::Evaluate,
};

use super::*;

/// An arm of N joints, with P = N(N-1)/2 pairs of joints.
pub trait Arm<const N: usize, const P: usize>:
    Evaluate<N> + ForwardDynamics<N> + Energy<N>
{
    /// The name of its files in `tests/data`.
    const FILE: &'static str;

    /// M(q).
    fn mass_matrix<T: Scalar>(&self, q: &SVector<T, N>) -> SMatrix<T, N, N>;
    /// V(q, qd).
    fn coriolis_vector<T: Scalar>(&self, q: &SVector<T, N>, qd: &SVector<T, N>) -> SVector<T, N>;
    /// G(q).
    fn gravity_vector<T: Scalar>(&self, q: &SVector<T, N>) -> SVector<T, N>;
    /// F(qd).
    fn friction_vector<T: Scalar>(&self, qd: &SVector<T, N>) -> SVector<T, N>;
    /// K(q).
    fn spring_vector<T: Scalar>(&self, q: &SVector<T, N>) -> SVector<T, N>;
    /// V + G + K + F.
    fn bias_force<T: Scalar>(&self, q: &SVector<T, N>, qd: &SVector<T, N>) -> SVector<T, N>;
    /// M qdd + V + G + K + F.
    fn inverse_dynamics<T: Scalar>(
        &self,
        q: &SVector<T, N>,
        qd: &SVector<T, N>,
        qdd: &SVector<T, N>,
    ) -> SVector<T, N>;
    /// C from the Christoffel symbols.
    fn coriolis_matrix<T: Scalar>(&self, q: &SVector<T, N>, qd: &SVector<T, N>)
    -> SMatrix<T, N, N>;
    /// B of V = B [qd qd] + C [qd^2].
    fn coriolis_coefficients<T: Scalar>(&self, q: &SVector<T, N>) -> SMatrix<T, N, P>;
    /// C of V = B [qd qd] + C [qd^2].
    fn centrifugal_coefficients<T: Scalar>(&self, q: &SVector<T, N>) -> SMatrix<T, N, N>;
    /// The last frame in the base.
    fn forward_kinematics<T: Scalar>(&self, q: &SVector<T, N>) -> Matrix4<T>;
    /// Every frame in the base.
    fn link_poses<T: Scalar>(&self, q: &SVector<T, N>) -> [Matrix4<T>; N];
    /// The geometric Jacobian of the last frame's origin.
    fn jacobian<T: Scalar>(&self, q: &SVector<T, N>) -> SMatrix<T, 6, N>;
    /// d tau/dq and d tau/dqd.
    fn inverse_dynamics_derivatives<T: Scalar>(
        &self,
        q: &SVector<T, N>,
        qd: &SVector<T, N>,
        qdd: &SVector<T, N>,
    ) -> (SMatrix<T, N, N>, SMatrix<T, N, N>);
    /// d qdd/dq, d qdd/dqd and M^-1.
    fn forward_dynamics_derivatives<T: Scalar>(
        &self,
        q: &SVector<T, N>,
        qd: &SVector<T, N>,
        tau: &SVector<T, N>,
    ) -> Result<AccelerationDerivatives<T, N>, SingularMassMatrix>;
}

/// Implements [`Arm`] by the inherent methods, which is also a check of their signatures.
macro_rules! arms {
    ($($file:ident: $robot:ident, $n:literal, $p:literal;)*) => {$(
        impl Arm<$n, $p> for $robot {
            const FILE: &'static str = stringify!($file);

            fn mass_matrix<T: Scalar>(&self, q: &SVector<T, $n>) -> SMatrix<T, $n, $n> {
                $robot::mass_matrix(self, q)
            }
            fn coriolis_vector<T: Scalar>(
                &self,
                q: &SVector<T, $n>,
                qd: &SVector<T, $n>,
            ) -> SVector<T, $n> {
                $robot::coriolis_vector(self, q, qd)
            }
            fn gravity_vector<T: Scalar>(&self, q: &SVector<T, $n>) -> SVector<T, $n> {
                $robot::gravity_vector(self, q)
            }
            fn friction_vector<T: Scalar>(&self, qd: &SVector<T, $n>) -> SVector<T, $n> {
                $robot::friction_vector(self, qd)
            }
            fn spring_vector<T: Scalar>(&self, q: &SVector<T, $n>) -> SVector<T, $n> {
                $robot::spring_vector(self, q)
            }
            fn bias_force<T: Scalar>(
                &self,
                q: &SVector<T, $n>,
                qd: &SVector<T, $n>,
            ) -> SVector<T, $n> {
                $robot::bias_force(self, q, qd)
            }
            fn inverse_dynamics<T: Scalar>(
                &self,
                q: &SVector<T, $n>,
                qd: &SVector<T, $n>,
                qdd: &SVector<T, $n>,
            ) -> SVector<T, $n> {
                $robot::inverse_dynamics(self, q, qd, qdd)
            }
            fn coriolis_matrix<T: Scalar>(
                &self,
                q: &SVector<T, $n>,
                qd: &SVector<T, $n>,
            ) -> SMatrix<T, $n, $n> {
                $robot::coriolis_matrix(self, q, qd)
            }
            fn coriolis_coefficients<T: Scalar>(&self, q: &SVector<T, $n>) -> SMatrix<T, $n, $p> {
                $robot::coriolis_coefficients(self, q)
            }
            fn centrifugal_coefficients<T: Scalar>(
                &self,
                q: &SVector<T, $n>,
            ) -> SMatrix<T, $n, $n> {
                $robot::centrifugal_coefficients(self, q)
            }
            fn forward_kinematics<T: Scalar>(&self, q: &SVector<T, $n>) -> Matrix4<T> {
                $robot::forward_kinematics(self, q)
            }
            fn link_poses<T: Scalar>(&self, q: &SVector<T, $n>) -> [Matrix4<T>; $n] {
                $robot::link_poses(self, q)
            }
            fn jacobian<T: Scalar>(&self, q: &SVector<T, $n>) -> SMatrix<T, 6, $n> {
                $robot::jacobian(self, q)
            }
            fn inverse_dynamics_derivatives<T: Scalar>(
                &self,
                q: &SVector<T, $n>,
                qd: &SVector<T, $n>,
                qdd: &SVector<T, $n>,
            ) -> (SMatrix<T, $n, $n>, SMatrix<T, $n, $n>) {
                $robot::inverse_dynamics_derivatives(self, q, qd, qdd)
            }
            fn forward_dynamics_derivatives<T: Scalar>(
                &self,
                q: &SVector<T, $n>,
                qd: &SVector<T, $n>,
                tau: &SVector<T, $n>,
            ) -> Result<AccelerationDerivatives<T, $n>, SingularMassMatrix> {
                $robot::forward_dynamics_derivatives(self, q, qd, tau)
            }
        }
    )*};
}
for_each_robot!(arms);
arms! { tilting_cell: TiltingCell, 4, 6; }
arms! { generic_mixed_n6_modified: GenericMixed6Modified, 6, 15; }
arms! { sprung_arm: SprungArm, 3, 3; }
arms! { sticky_arm: StickyArm, 2, 1; }
arms! { gripper_arm: GripperArm, 3, 3; }
arms! { palletiser: Palletiser, 3, 3; }
