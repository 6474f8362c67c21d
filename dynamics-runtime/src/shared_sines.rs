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
/// # extern crate dynamics_runtime as robot_dynamics;
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

impl<R, T: Scalar, const N: usize> SharedSines<'_, R, T, N> {
    /// Mass matrix M(q), kg m^2, kg m or kg.
    #[inline]
    pub fn mass_matrix(&self) -> SMatrix<T, N, N>
    where
        R: MassMatrix<N>,
    {
        self.arm.mass_matrix_at(&self.sines, &self.q)
    }

    /// Coriolis and centrifugal vector V(q, qd), N m or N; `qd` per second.
    #[inline]
    pub fn coriolis_vector(&self, qd: &SVector<T, N>) -> SVector<T, N>
    where
        R: CoriolisVector<N>,
    {
        self.arm.coriolis_vector_at(&self.sines, &self.q, qd)
    }

    /// Gravity vector G(q), N m or N.
    #[inline]
    pub fn gravity_vector(&self) -> SVector<T, N>
    where
        R: GravityVector<N>,
    {
        self.arm.gravity_vector_at(&self.sines, &self.q)
    }

    /// Inverse dynamics tau = M qdd + V + G + K + F, N m or N; `qd` per second, `qdd` per second
    /// squared.
    #[inline]
    pub fn inverse_dynamics(&self, qd: &SVector<T, N>, qdd: &SVector<T, N>) -> SVector<T, N>
    where
        R: InverseDynamics<N>,
    {
        self.arm.inverse_dynamics_at(&self.sines, &self.q, qd, qdd)
    }

    /// Forward dynamics qdd with M qdd + V + G + K + F = tau, rad/s^2 or m/s^2; `qd` per second,
    /// `tau` in N m or N.
    ///
    /// # Errors
    ///
    /// [`SingularMassMatrix`] where M(q) is not positive definite to working precision.
    #[inline]
    pub fn forward_dynamics(
        &self,
        qd: &SVector<T, N>,
        tau: &SVector<T, N>,
    ) -> Result<SVector<T, N>, SingularMassMatrix>
    where
        R: ForwardDynamics<N>,
    {
        self.arm.forward_dynamics_at(&self.sines, &self.q, qd, tau)
    }
}
