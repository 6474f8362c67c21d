//! The generated methods behind one trait, so that a test can be written once for all robots.

use robot_dynamics::nalgebra::{Matrix4, SMatrix, SVector};
use robot_dynamics::{
    AccelerationDerivatives, Energy, ForwardDynamics, Scalar, SingularMassMatrix, check::Evaluate,
};

use super::*;

/// Hands the methods to the macro `$then`, behind a context in brackets: of `$n` joints, with `$p` = n(n-1)/2 pairs of joints.
macro_rules! methods {
    ($then:ident [$($context:tt)*] $n:tt $p:tt) => {
        $then! {
            [$($context)*] $n
            /// M(q).
            mass_matrix(q) -> SMatrix<T, $n, $n>;
            /// V(q, qd).
            coriolis_vector(q, qd) -> SVector<T, $n>;
            /// G(q).
            gravity_vector(q) -> SVector<T, $n>;
            /// F(qd).
            friction_vector(qd) -> SVector<T, $n>;
            /// K(q).
            spring_vector(q) -> SVector<T, $n>;
            /// V + G + K + F.
            bias_force(q, qd) -> SVector<T, $n>;
            /// M qdd + V + G + K + F.
            inverse_dynamics(q, qd, qdd) -> SVector<T, $n>;
            /// C from the Christoffel symbols.
            coriolis_matrix(q, qd) -> SMatrix<T, $n, $n>;
            /// B of V = B [qd qd] + C [qd^2].
            coriolis_coefficients(q) -> SMatrix<T, $n, $p>;
            /// C of V = B [qd qd] + C [qd^2].
            centrifugal_coefficients(q) -> SMatrix<T, $n, $n>;
            /// The last frame in the base.
            forward_kinematics(q) -> Matrix4<T>;
            /// Every frame in the base.
            link_poses(q) -> [Matrix4<T>; $n];
            /// The geometric Jacobian of the last frame's origin.
            jacobian(q) -> SMatrix<T, 6, $n>;
            /// d tau/dq and d tau/dqd.
            inverse_dynamics_derivatives(q, qd, qdd) -> (SMatrix<T, $n, $n>, SMatrix<T, $n, $n>);
            /// d qdd/dq, d qdd/dqd and M^-1.
            forward_dynamics_derivatives(q, qd, tau) -> Result<AccelerationDerivatives<T, $n>, SingularMassMatrix>;
        }
    };
}

macro_rules! declare {
    ([] $n:tt $($(#[$doc:meta])* $method:ident($($argument:ident),*) -> $value:ty;)*) => {
        /// An arm of N joints, with P = N(N-1)/2 pairs of joints.
        pub trait Arm<const N: usize, const P: usize>: Evaluate<N> + ForwardDynamics<N> + Energy<N> {
            /// The name of its files in `tests/data`.
            const FILE: &'static str;
            $($(#[$doc])* fn $method<T: Scalar>(&self, $($argument: &SVector<T, $n>),*) -> $value;)*
        }
    };
}
methods! { declare [] N P }

/// Implements [`Arm`] by the inherent methods, which is also a check of their signatures.
macro_rules! implement {
    ([$file:ident $robot:ident $p:tt] $n:tt $($(#[$doc:meta])* $method:ident($($argument:ident),*) -> $value:ty;)*) => {
        impl Arm<$n, $p> for $robot {
            const FILE: &'static str = stringify!($file);
            $(fn $method<T: Scalar>(&self, $($argument: &SVector<T, $n>),*) -> $value {
                $robot::$method(self, $($argument),*)
            })*
        }
    };
}

macro_rules! arms {
    ($($file:ident: $robot:ident, $n:literal, $p:literal;)*) => {
        $(methods! { implement [$file $robot $p] $n $p })*
    };
}
for_each_robot!(arms);
arms! { tilting_cell: TiltingCell, 4, 6; }
arms! { generic_mixed_n6_modified: GenericMixed6Modified, 6, 15; }
arms! { sprung_arm: SprungArm, 3, 3; }
arms! { sticky_arm: StickyArm, 2, 1; }
arms! { gripper_arm: GripperArm, 3, 3; }
arms! { palletiser: Palletiser, 3, 3; }
