//! The methods of arms, which stand where their tables say, and of robots on a base that moves, which are told where it is.

use dynamics_runtime::{Conditioning, Pose, SingularMassMatrix, Size, SizedSecondDerivatives};
use nalgebra::{Matrix4, Vector3, Vector6};

use super::NumericArm;
use super::floating::NumericFloating;

/// Methods of an arm.
macro_rules! of_arm {
    (
        plain { $($(#[$text:meta])* fn $plain:ident($($x:ident: $kind:ty),*) -> $value:ty;)* }
        on_base {
            $($(#[$other:meta])* fn $on_base:ident $([$frame:ident])? ($($y:ident: $of:ty),*) -> $result:ty;)*
        }
    ) => {
        impl<D: Size> NumericArm<D> {
            $($(#[$text])* #[inline]
            pub fn $plain(&self $(, $x: $kind)*) -> $value {
                self.standing().$plain($($x),*)
            })*

            $($(#[$other])* #[inline]
            pub fn $on_base(&self $(, $frame: usize)? $(, $y: $of)*) -> $result {
                self.standing().$on_base($($frame,)? $($y),*)
            })*
        }
    };
}

/// Methods of a robot on a base that moves. If a method does not read where it is, any place will do.
macro_rules! of_floating {
    (
        plain { $($(#[$text:meta])* fn $plain:ident($($x:ident: $kind:ty),*) -> $value:ty;)* }
        on_base {
            $($(#[$other:meta])* fn $on_base:ident $([$frame:ident])? ($($y:ident: $of:ty),*) -> $result:ty;)*
        }
    ) => {
        impl<D: Size, V: Size> NumericFloating<D, V> {
            $($(#[$text])*
            pub fn $plain(&self $(, $x: $kind)*) -> $value {
                self.anywhere().$plain($($x),*)
            })*

            $($(#[$other])*
            pub fn $on_base(&self $(, $frame: usize)?, base: &Pose<f64> $(, $y: $of)*) -> $result {
                let base = self.footing(base);
                self.placed(&base).$on_base($($frame,)? $($y),*)
            })*
        }
    };
}

/// The methods, each made by `$make` for a robot with `$V` velocities: as many as joints, or six of the base before those of
/// the joints. There `qd`, `qdd` and `tau` are the velocities v, the accelerations a and the forces of all.
macro_rules! methods {
    ($make:ident, $V:ident) => {
        $make! {
            plain {
                /// Mass matrix M(q), both triangles: column j is the torque of a unit acceleration j, at rest and without
                /// gravity. It holds no coordinate of a base. Reflected inertias are on the diagonal.
                fn mass_matrix(q: &D::Vector) -> $V::Matrix;

                /// Coriolis and centrifugal torques V(q, qd): no acceleration, no gravity. They hold no coordinate of a base.
                fn coriolis_vector(q: &D::Vector, qd: &$V::Vector) -> $V::Vector;

                /// Coriolis matrix C(q, qd), so that V = C qd and Mdot - 2 C is skew.
                ///
                /// The matrix of an arm has the Christoffel symbols of the first kind. On a base that moves there are none: the
                /// six numbers of the base are the rates of no coordinates.
                fn coriolis_matrix(q: &D::Vector, qd: &$V::Vector) -> $V::Matrix;

                /// Friction torques F(qd), zero for the numbers of a base.
                fn friction_vector(qd: &$V::Vector) -> $V::Vector;

                /// Spring torques K(q), zero for the numbers of a base.
                fn spring_vector(q: &D::Vector) -> $V::Vector;

                /// Kinetic energy, the sum of 1/2 m v_c^2 + 1/2 w.I w over the bodies and of 1/2 J qd^2 over the reflected
                /// inertias, J.
                fn kinetic_energy(q: &D::Vector, qd: &$V::Vector) -> f64;

                /// How near M(q) is to singular: which joint, and how many digits accelerations lose there. The six numbers of
                /// a base count first.
                fn conditioning(q: &D::Vector) -> Conditioning;
            }
            on_base {
                /// Gravity torques G: no velocity, no acceleration, no springs. The six numbers of a base hold the weight of the
                /// robot.
                fn gravity_vector(q: &D::Vector) -> $V::Vector;

                /// Torques of a motion, M qdd + V + G + K + F.
                fn inverse_dynamics(q: &D::Vector, qd: &$V::Vector, qdd: &$V::Vector) -> $V::Vector;

                /// Torques without acceleration, V + G + K + F.
                fn bias_force(q: &D::Vector, qd: &$V::Vector) -> $V::Vector;

                /// Accelerations qdd of `M qdd + V + G + K + F = tau`; `tau` in N m or N.
                ///
                /// # Errors
                ///
                /// [`SingularMassMatrix`] where M is not positive definite to working precision, or holds a NaN. Its `joint`
                /// counts the six numbers of a base first.
                fn forward_dynamics(
                    q: &D::Vector,
                    qd: &$V::Vector,
                    tau: &$V::Vector
                ) -> Result<$V::Vector, SingularMassMatrix>;

                /// The same accelerations by articulated bodies: the time grows with the number of joints, and not with its
                /// cube.
                ///
                /// # Errors
                ///
                /// As [`forward_dynamics`](Self::forward_dynamics).
                fn forward_dynamics_aba(
                    q: &D::Vector,
                    qd: &$V::Vector,
                    tau: &$V::Vector
                ) -> Result<$V::Vector, SingularMassMatrix>;

                /// Derivatives of the inverse dynamics by positions and by velocities; row i belongs to tau_i, column j to
                /// velocity j. Displacements of a base are in its own axes; columns of those without a turn are zero.
                ///
                /// The stiffness of springs is on the diagonal of the first one, viscous friction on that of the second. Coulomb
                /// friction is taken as constant.
                fn inverse_dynamics_derivatives(
                    q: &D::Vector,
                    qd: &$V::Vector,
                    qdd: &$V::Vector
                ) -> ($V::Matrix, $V::Matrix);

                /// d2 tau/dq dq, d2 tau/dqd dqd, d2 tau/dq dqd and dM/dq of the inverse dynamics. Entry `[i][(j, k)]` is the
                /// derivative of tau_i by q_j and q_k, by qd_j and qd_k, by q_j and qd_k, and that of M_ij by q_k.
                ///
                /// Friction that falls with the velocity is on the diagonal of d2 tau/dqd dqd; that of other friction and of
                /// springs is zero. Displacements of a base are in its own axes: the first one is the Hessian of
                /// f(p + R d, R exp(phi), q) at d = phi = 0. It is symmetric, while repeated derivatives along the axes of the
                /// base are not.
                fn inverse_dynamics_second_derivatives(
                    q: &D::Vector,
                    qd: &$V::Vector,
                    qdd: &$V::Vector
                ) -> SizedSecondDerivatives<$V>;

                /// First and second derivative by time of the torques M qdd + V + G + K + F along a motion; `jerk` and `snap`
                /// are the first two derivatives of `qdd`. Coulomb friction counts as constant.
                fn inverse_dynamics_rates(
                    q: &D::Vector,
                    qd: &$V::Vector,
                    qdd: &$V::Vector,
                    jerk: &$V::Vector,
                    snap: &$V::Vector
                ) -> ($V::Vector, $V::Vector);

                /// Potential energy of gravity and springs, U = -sum m g.c + sum 1/2 stiffness (q - rest)^2, J. The energy of
                /// gravity is zero if all centres of mass are at the world's origin.
                fn potential_energy(q: &D::Vector) -> f64;

                /// Homogeneous transforms of the link frames in the world, of those joints that move by themselves.
                fn link_poses(q: &D::Vector) -> D::Each<Matrix4<f64>>;

                /// Homogeneous transform of the tip in the world: of the tool, or else of the only link frame that carries no
                /// other link. For no joints, that of the base.
                fn forward_kinematics(q: &D::Vector) -> Matrix4<f64>;

                /// Homogeneous transform of a frame in the world.
                fn frame_pose[frame](q: &D::Vector) -> Matrix4<f64>;

                /// Geometric Jacobian of the tip's origin: rows vx vy vz wx wy wz in the world, a column for each velocity.
                fn jacobian(q: &D::Vector) -> $V::Columns<6>;

                /// Geometric Jacobian of a frame's origin. The columns of joints that do not carry it are zero.
                fn frame_jacobian[frame](q: &D::Vector) -> $V::Columns<6>;

                /// J' w: the torques of a wrench w = (fx fy fz nx ny nz), N and N m, on a frame, about its origin and in the
                /// axes of the world.
                fn frame_wrench_torques[frame](q: &D::Vector, wrench: &Vector6<f64>) -> $V::Vector;

                /// The rate of the geometric Jacobian along a motion.
                fn jacobian_rate(q: &D::Vector, qd: &$V::Vector) -> $V::Columns<6>;

                /// The rate of the geometric Jacobian of a frame along a motion.
                fn frame_jacobian_rate[frame](q: &D::Vector, qd: &$V::Vector) -> $V::Columns<6>;

                /// Geometric Jacobians of the origins of the link frames, of those joints that move by themselves; joints that
                /// do not carry a link do not move it.
                fn link_jacobians(q: &D::Vector) -> D::Each<$V::Columns<6>>;

                /// Centre of mass of all links, of a base that moves, of the tool and of the bodies of frames in the world,
                /// `sum m c / sum m`.
                fn center_of_mass(q: &D::Vector) -> Vector3<f64>;

                /// Jacobian of the centre of mass in the world.
                fn center_of_mass_jacobian(q: &D::Vector) -> $V::Columns<3>;

                /// Centroidal momentum matrix A: A qd is the linear momentum of all bodies, then their angular momentum about
                /// the centre of mass, in the world, kg m/s and kg m^2/s. Reflected inertias of motors have no part in it.
                fn centroidal_momentum_matrix(q: &D::Vector) -> $V::Columns<6>;

                /// dA/dt qd: the rate of that momentum without acceleration.
                fn centroidal_momentum_bias(q: &D::Vector, qd: &$V::Vector) -> Vector6<f64>;

                /// The standard regressor, a block of ten columns for each link: with the
                /// [standard parameters](dynamics_runtime::Table::standard_parameters) x_k of the links,
                ///
                /// `sum_k Y_k x_k = M qdd + V + G - J qdd`,
                ///
                /// the torques without friction, springs and the reflected inertias J of the motors.
                ///
                /// None of the columns depends on the masses of the table. They are not independent:
                /// [`base_parameter_map`](crate::check::base_parameter_map) says which combinations a motion shows.
                ///
                /// Where joints follow others, the terms of their links belong to the sum too
                /// ([`standard_regressor_of_followers`](Self::standard_regressor_of_followers)), and the motor of a follower
                /// adds factor^2 times its reflected inertia to J of the joint that leads. So does the body of a base that
                /// moves.
                fn standard_regressor(
                    q: &D::Vector,
                    qd: &$V::Vector,
                    qdd: &$V::Vector
                ) -> D::Each<$V::Rows<10>>;

                /// The blocks of the [standard regressor](Self::standard_regressor) for the links of joints that follow others,
                /// in the order of [their parameters](dynamics_runtime::Table::standard_parameters_of_followers). Empty where nothing is
                /// coupled.
                fn standard_regressor_of_followers(
                    q: &D::Vector,
                    qd: &$V::Vector,
                    qdd: &$V::Vector
                ) -> impl Iterator<Item = $V::Rows<10>>;
            }
        }
    };
}

methods!(of_arm, D);
methods!(of_floating, V);
