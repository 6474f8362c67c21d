//! The traits by which generic code knows a generated robot.

use nalgebra::{Const, Matrix4, SMatrix, SVector};

use crate::factorisation::solve;
use crate::size::{JointMatrix as _, Size};
use crate::{Inputs, Pose, Scalar, SingularMassMatrix, Table};

/// The operations of a function, sines included, where they have not been counted.
pub(crate) const UNKNOWN_WORK: u32 = 200;

/// An arm with `N` joints that can show the table it was generated from.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no robot",
    note = "`robot_dynamics!` makes robots, from Denavit-Hartenberg tables"
)]
pub trait Model<const N: usize, const V: usize = N> {
    /// Names of the joints, from the base outwards.
    const JOINT_NAMES: [&'static str; N];

    /// Whether a generated function of q reads the sine and cosine of a joint's position:
    /// [`SharedSines`](crate::SharedSines) evaluates no others.
    const READS_ANGLE: [bool; N] = [true; N];

    /// The table as numbers.
    fn table(&self) -> Table<N>;

    /// The names of the joints, where they are known at run time alone.
    fn joint_names(&self) -> [&str; N] {
        Self::JOINT_NAMES
    }

    /// Kinetic and potential energy, J; `None` for an arm without both functions. A generated arm has them if its
    /// functions include `kinetic_energy` and `potential_energy`.
    fn energies(&self, q: &SVector<f64, N>, qd: &SVector<f64, V>) -> Option<[f64; 2]> {
        let _ = (q, qd);
        None
    }

    /// The same of a robot on a base that moves.
    #[doc(hidden)]
    fn energies_on(
        &self,
        base: &Pose<f64>,
        q: &SVector<f64, N>,
        v: &SVector<f64, V>,
    ) -> Option<[f64; 2]> {
        let _ = (base, q, v);
        None
    }
}

/// The traits of functions whose sines can be shared with others at the same q.
macro_rules! function_traits {
    ($(
        $(#[doc = $about:literal])*
        $name:ident, without: $lacking:tt;
        $(#[doc = $description:literal])*
        $method:ident, $method_at:ident($($x:ident: $size:ident),*) -> $value:ty;
        $({ $($more:tt)* })?
    )*) => {$(
        $(#[doc = $about])*
        #[diagnostic::on_unimplemented(
            message = $lacking,
            note = "add it to its `functions:`, or write `functions: [default, ...]`, which holds it"
        )]
        pub trait $name<const N: usize, const V: usize = N> {
            /// Roughly the number of operations of one call, sines included: it tells a batch how many states are
            /// worth another core.
            #[doc(hidden)]
            const WORK: u32 = UNKNOWN_WORK;

            $(#[doc = $description])*
            fn $method<T: Scalar>(&self, $($x: &SVector<T, $size>),*) -> $value;

            /// The same, with the sines of the joint positions from `sines`: see
            /// [`SharedSines`](crate::SharedSines).
            #[doc(hidden)]
            #[inline]
            fn $method_at<T: Scalar>(
                &self,
                sines: &impl Inputs<T>,
                $($x: &SVector<T, $size>),*
            ) -> $value {
                let _ = sines;
                self.$method($($x),*)
            }

            $($($more)*)?
        }
    )*};
}

function_traits! {
    /// An arm whose joint accelerations can be computed: what a simulation needs.
    ///
    /// Positions are `N` numbers, and velocities `V`: as many, unless the base moves.
    ForwardDynamics,
    without: "`{Self}` has no forward dynamics: `forward_dynamics` is not in `functions`";
    /// Joint accelerations qdd of `M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd) = tau`.
    ///
    /// `q` in rad or m, `qd` per second, `tau` in N m or N.
    ///
    /// # Errors
    ///
    /// [`SingularMassMatrix`] where M(q) is not positive definite to working precision, or holds a
    /// NaN.
    forward_dynamics, forward_dynamics_at(q: N, qd: V, tau: V)
        -> Result<SVector<T, V>, SingularMassMatrix>;
    {
        /// The arm in positions and momenta, as the structure-preserving methods of a
        /// `Simulation` need it; `None` for an arm without these functions.
        ///
        /// A generated arm has them if its functions include `mass_matrix` and `inverse_dynamics`. For an arm
        /// of your own with [`MassMatrix`] and [`InverseDynamics`], return `Some(self)`.
        fn momenta(&self) -> Option<&dyn Momenta<N>> {
            None
        }
    }

    /// An arm whose mass matrix can be computed.
    MassMatrix, without: "`{Self}` has no mass matrix: `mass_matrix` is not in `functions`";
    /// Mass matrix M(q), both triangles, reflected motor inertias included; kg m^2, kg m or kg.
    ///
    /// `q` in rad or m. Where a joint position is not finite, the entries that depend on it are not.
    mass_matrix, mass_matrix_at(q: N) -> SMatrix<T, V, V>;

    /// An arm whose Coriolis and centrifugal forces can be computed.
    CoriolisVector, without: "`{Self}` has no Coriolis vector: `coriolis_vector` is not in `functions`";
    /// Coriolis and centrifugal vector V(q, qd), N m or N.
    ///
    /// `q` in rad or m, `qd` per second.
    coriolis_vector, coriolis_vector_at(q: N, qd: V) -> SVector<T, V>;

    /// An arm whose gravity forces can be computed.
    GravityVector, without: "`{Self}` has no gravity vector: `gravity_vector` is not in `functions`";
    /// Gravity vector G(q) = dU/dq, N m or N.
    ///
    /// `q` in rad or m.
    gravity_vector, gravity_vector_at(q: N) -> SVector<T, V>;

    /// An arm whose joint forces can be computed from its motion.
    InverseDynamics, without: "`{Self}` has no inverse dynamics: `inverse_dynamics` is not in `functions`";
    /// Inverse dynamics tau = M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd), N m or N.
    ///
    /// `q` in rad or m, `qd` per second, `qdd` per second squared.
    inverse_dynamics, inverse_dynamics_at(q: N, qd: V, qdd: V) -> SVector<T, V>;
}

/// An arm whose mechanical energy can be computed.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no energies: `kinetic_energy` and `potential_energy` are not both in `functions`",
    note = "add them to its `functions:`, or write `functions: [default, ...]`, which holds them"
)]
pub trait Energy<const N: usize, const V: usize = N> {
    /// Kinetic energy 1/2 qd^T M(q) qd with the motors' reflected inertias, J.
    fn kinetic_energy<T: Scalar>(&self, q: &SVector<T, N>, qd: &SVector<T, V>) -> T;

    /// Potential energy U = -sum m g.c, zero where all centres of mass are at the base's origin, J.
    fn potential_energy<T: Scalar>(&self, q: &SVector<T, N>) -> T;
}

/// An arm whose tip can be followed: what a force at the tool is handed to the joints by.
#[diagnostic::on_unimplemented(
    message = "the tip of `{Self}` is not known: `forward_kinematics` and `jacobian` are not both in `functions`",
    note = "add them: `functions: [default, forward_kinematics, jacobian]`"
)]
pub trait Kinematics<const N: usize, const V: usize = N> {
    /// The tip's homogeneous transform, m.
    fn forward_kinematics<T: Scalar>(&self, q: &SVector<T, N>) -> Matrix4<T>;

    /// Geometric Jacobian of the tip's origin, rows vx vy vz wx wy wz, in the axes of
    /// [`forward_kinematics`](Kinematics::forward_kinematics).
    fn jacobian<T: Scalar>(&self, q: &SVector<T, N>) -> SMatrix<T, 6, V>;
}

/// The tip of an arm of any size, in doubles. Every arm with [`Kinematics`] has it.
#[diagnostic::on_unimplemented(
    message = "the tip of `{Self}` is not known: `forward_kinematics` and `jacobian` are not both in `functions`",
    note = "add them: `functions: [default, forward_kinematics, jacobian]`"
)]
pub trait SizedKinematics<D: Size> {
    /// As [`Kinematics::forward_kinematics`].
    fn tip_pose(&self, q: &D::Vector) -> Matrix4<f64>;

    /// As [`Kinematics::jacobian`].
    fn tip_jacobian(&self, q: &D::Vector) -> D::Columns<6>;
}

impl<R: Kinematics<N>, const N: usize> SizedKinematics<Const<N>> for R {
    fn tip_pose(&self, q: &SVector<f64, N>) -> Matrix4<f64> {
        self.forward_kinematics(q)
    }

    fn tip_jacobian(&self, q: &SVector<f64, N>) -> SMatrix<f64, 6, N> {
        self.jacobian(q)
    }
}

/// A robot whose table is known as numbers.
#[diagnostic::on_unimplemented(
    message = "the table of `{Self}` is not known, and its joints and their limits with it"
)]
pub trait SizedTable<D: Size> {
    /// The table as numbers.
    fn sized_numbers(&self) -> D::Table;
}

impl<R: Model<N>, const N: usize> SizedTable<Const<N>> for R {
    fn sized_numbers(&self) -> Table<N> {
        self.table()
    }
}

/// Hamilton's equations of an arm, in positions q and momenta p = M(q) qd. The structure-preserving
/// methods of a `Simulation` integrate them.
///
/// Every arm with `mass_matrix` and `inverse_dynamics` has this trait. With T the kinetic energy and C the
/// Coriolis matrix of the Christoffel symbols (C^T is its transpose),
///
/// `dq/dt = M^-1 p`, `dp/dt = dT/dq - G - K - F + tau`, `dT/dq = C^T qd`.
///
/// C itself is not needed: since `dM/dt = C + C^T` and `V = C qd`, `dT/dq = (dM/dt) qd - V`, and dM/dt is the
/// derivative of M(q) along qd, which dual numbers give.
pub trait SizedMomenta<D: Size> {
    /// M(q), kg m^2, kg m or kg.
    fn inertia(&self, q: &D::Vector) -> D::Matrix;

    /// p = M(q) qd, kg m^2/s or kg m/s.
    fn momentum(&self, q: &D::Vector, qd: &D::Vector) -> D::Vector {
        self.inertia(q).times(qd)
    }

    /// qd = M(q)^-1 p.
    ///
    /// # Errors
    ///
    /// [`SingularMassMatrix`] where M(q) is not positive definite to working precision.
    fn velocity(&self, q: &D::Vector, p: &D::Vector) -> Result<D::Vector, SingularMassMatrix> {
        solve(self.inertia(q), p)
    }

    /// The velocities of an arm some of whose joints stand still. Joints that stand still have exactly zero; the
    /// others' velocities solve M_ff qd_f = p_f, where M_ff has the rows and columns of the moving joints
    /// alone. Momenta of joints that stand still are not read.
    ///
    /// # Errors
    ///
    /// [`SingularMassMatrix`] where M_ff is not positive definite to working precision.
    fn velocity_beside(
        &self,
        still: &D::Each<bool>,
        q: &D::Vector,
        p: &D::Vector,
    ) -> Result<D::Vector, SingularMassMatrix> {
        let (mut m, mut p, size) = (self.inertia(q), p.clone(), D::of(q));
        // Their rows and columns are those of the unit matrix.
        for i in size.joints().filter(|i| still[*i]) {
            for j in size.joints() {
                (m[(i, j)], m[(j, i)]) = (0.0, 0.0);
            }
            m[(i, i)] = 1.0;
            p[i] = 0.0;
        }
        let qd = solve(m, &p)?;
        Ok(size.vector_of(|i| if still[i] { 0.0 } else { qd[i] }))
    }

    /// dp/dt = dT/dq - G - K - F + tau at the velocity `qd`, N m or N.
    fn force(&self, q: &D::Vector, qd: &D::Vector, tau: &D::Vector) -> D::Vector;
}

/// [`SizedMomenta`] of an arm whose number of joints the compiler knows.
pub trait Momenta<const N: usize>: SizedMomenta<Const<N>> {}

impl<R: SizedMomenta<Const<N>> + ?Sized, const N: usize> Momenta<N> for R {}
