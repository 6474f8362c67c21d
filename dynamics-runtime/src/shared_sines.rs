//! Several functions at one configuration, with the sines of the joint angles evaluated once.

use nalgebra::{SMatrix, SVector};

use crate::inputs::Known;
use crate::{
    CoriolisVector, ForwardDynamics, GravityVector, InverseDynamics, MassMatrix, Model, Scalar,
    SingularMassMatrix,
};

/// An arm at one configuration q: its functions share the sines and cosines of the joint angles.
///
/// Sines are a good part of what a short program costs. A controller that needs M, V and G at the
/// same q evaluates them once:
///
/// ```
/// # use robot_dynamics::nalgebra::{SMatrix, SVector, Vector1};
/// # use robot_dynamics::table::{Convention, JointType, Row, Table};
/// use robot_dynamics::{SharedSines, GravityVector, MassMatrix, Model, Scalar};
/// # struct Pendulum;
/// # impl Model<1> for Pendulum {
/// #     const JOINT_NAMES: [&'static str; 1] = ["swing"];
/// #     fn table(&self) -> Table<1> { unimplemented!() }
/// # }
/// # impl GravityVector<1> for Pendulum {
/// #     fn gravity_vector<T: Scalar>(&self, q: &SVector<T, 1>) -> SVector<T, 1> {
/// #         Vector1::new(q[0].sin_cos().0 * q[0].constant(9.81))
/// #     }
/// # }
/// # impl MassMatrix<1> for Pendulum {
/// #     fn mass_matrix<T: Scalar>(&self, q: &SVector<T, 1>) -> SMatrix<T, 1, 1> {
/// #         SMatrix::<T, 1, 1>::new(q[0].constant(1.0))
/// #     }
/// # }
/// # let (arm, q) = (Pendulum, Vector1::new(0.5));
/// let here = SharedSines::new(&arm, &q);
/// let (m, g) = (here.mass_matrix(), here.gravity_vector());
/// assert_eq!(g, arm.gravity_vector(&q));
/// # assert_eq!(m[0], 1.0);
/// ```
///
/// The values are bit for bit those of the arm's own methods.
#[derive(Clone, Copy, Debug)]
pub struct SharedSines<'a, R, T, const N: usize> {
    arm: &'a R,
    q: SVector<T, N>,
    sines: Known<T, N>,
}

impl<'a, R: Model<N>, T: Scalar, const N: usize> SharedSines<'a, R, T, N> {
    /// The arm at joint positions `q`, rad or m.
    #[inline]
    pub fn new(arm: &'a R, q: &SVector<T, N>) -> Self {
        // An angle that no function reads, and the position of a slide, has no sine.
        let angles = core::array::from_fn(|i| {
            if R::READS_ANGLE[i] {
                q[i]
            } else {
                q[i].constant(0.0)
            }
        });
        SharedSines {
            arm,
            q: *q,
            sines: Known(T::sin_cos_array(angles)),
        }
    }
}

/// The functions, each with the sines that are known.
macro_rules! shared_functions {
    ($($(#[doc = $description:literal])* $method:ident, $method_at:ident: $name:ident($($x:ident),*) -> $value:ty;)*) => {
        impl<R, T: Scalar, const N: usize> SharedSines<'_, R, T, N> {$(
            $(#[doc = $description])*
            #[inline]
            pub fn $method(&self $(, $x: &SVector<T, N>)*) -> $value
            where
                R: $name<N>,
            {
                self.arm.$method_at(&self.sines, &self.q $(, $x)*)
            }
        )*}
    };
}

shared_functions! {
    /// Mass matrix M(q), kg m^2, kg m or kg.
    mass_matrix, mass_matrix_at: MassMatrix() -> SMatrix<T, N, N>;
    /// Coriolis and centrifugal vector V(q, qd), N m or N; `qd` per second.
    coriolis_vector, coriolis_vector_at: CoriolisVector(qd) -> SVector<T, N>;
    /// Gravity vector G(q), N m or N.
    gravity_vector, gravity_vector_at: GravityVector() -> SVector<T, N>;
    /// Inverse dynamics tau = M qdd + V + G + K + F, N m or N; `qd` per second, `qdd` per second
    /// squared.
    inverse_dynamics, inverse_dynamics_at: InverseDynamics(qd, qdd) -> SVector<T, N>;
    /// Forward dynamics qdd with M qdd + V + G + K + F = tau, rad/s^2 or m/s^2; `qd` per second,
    /// `tau` in N m or N.
    ///
    /// # Errors
    ///
    /// [`SingularMassMatrix`] where M(q) is not positive definite to working precision.
    forward_dynamics, forward_dynamics_at: ForwardDynamics(qd, tau)
        -> Result<SVector<T, N>, SingularMassMatrix>;
}
