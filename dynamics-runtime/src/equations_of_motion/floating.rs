//! The equations of a robot on a base that moves.

use nalgebra::{Const, SVector};

use super::{Responses, inverse_columns, responses};
use crate::dual::Dual;
use crate::factorisation::JointFactors;
use crate::function::{Entries, functions};
use crate::size::Size;
use crate::{Evaluated, Function, NumericFloating, Pose, Scalar, SingularMassMatrix};

/// A robot on a base that moves, whose motion a [`Simulation`](crate::Simulation) follows: its equations of motion, solved for
/// the accelerations, in doubles. `D` is the number of its joints and `V` that of its velocities, 6 + D.
///
/// Every robot with `base: floating` and `forward_dynamics` is one, and
/// [`FloatingNewtonEuler`](crate::FloatingNewtonEuler) is one for any table.
pub trait FloatingEquations<D: Size, V: Size> {
    /// The number of velocities.
    fn freedoms(&self) -> V;

    /// The number of joints.
    fn joints(&self) -> D {
        D::from_usize(self.freedoms().value() - 6)
    }

    /// Accelerations a of `M(q) a + V(q, v) + G(base, q) + K(q) + F(v) = tau`, as those of
    /// [`NumericFloating::forward_dynamics`].
    ///
    /// # Errors
    ///
    /// [`SingularMassMatrix`] where M(q) is not positive definite to working precision, or holds a NaN.
    fn accelerations_on(
        &self,
        base: &Pose<f64>,
        q: &D::Vector,
        v: &V::Vector,
        tau: &V::Vector,
    ) -> Result<V::Vector, SingularMassMatrix>;

    /// The accelerations, and the columns of M(q)^-1 that belong to `freedoms`; other columns are zero.
    ///
    /// # Errors
    ///
    /// As [`accelerations_on`](FloatingEquations::accelerations_on).
    fn responses_on(
        &self,
        base: &Pose<f64>,
        q: &D::Vector,
        v: &V::Vector,
        tau: &V::Vector,
        freedoms: &V::Each<bool>,
    ) -> Result<Responses<V>, SingularMassMatrix>;
}

/// Vectors of the generated forward dynamics on a base that moves: the pose, q, v, tau.
type OfForwardDynamics<const N: usize, const V: usize> =
    (Entries<12, 1>, Entries<N, 1>, Entries<V, 1>, Entries<V, 1>);

impl<R, const N: usize, const V: usize> FloatingEquations<Const<N>, Const<V>> for R
where
    R: Function<
            functions::ForwardDynamics,
            N,
            Arguments = OfForwardDynamics<N, V>,
            Values = Entries<V, 1>,
            Error = SingularMassMatrix,
        >,
{
    fn freedoms(&self) -> Const<V> {
        Const
    }

    #[inline]
    fn accelerations_on(
        &self,
        base: &Pose<f64>,
        q: &SVector<f64, N>,
        v: &SVector<f64, V>,
        tau: &SVector<f64, V>,
    ) -> Result<SVector<f64, V>, SingularMassMatrix> {
        let arguments = (base.entries(), *q, *v, *tau);
        self.at(functions::ForwardDynamics, &Evaluated, &arguments)
    }

    fn responses_on(
        &self,
        base: &Pose<f64>,
        q: &SVector<f64, N>,
        v: &SVector<f64, V>,
        tau: &SVector<f64, V>,
        freedoms: &[bool; V],
    ) -> Result<Responses<Const<V>>, SingularMassMatrix> {
        let base = base.entries().map(Dual::from_f64);
        let (q, v) = (q.map(Dual::from_f64), v.map(Dual::from_f64));
        responses(tau, freedoms, |tau| {
            self.at(functions::ForwardDynamics, &Evaluated, &(base, q, v, *tau))
        })
    }
}

impl<D: Size, V: Size> FloatingEquations<D, V> for NumericFloating<D, V> {
    fn freedoms(&self) -> V {
        V::from_usize(self.dof())
    }

    fn accelerations_on(
        &self,
        base: &Pose<f64>,
        q: &D::Vector,
        v: &V::Vector,
        tau: &V::Vector,
    ) -> Result<V::Vector, SingularMassMatrix> {
        self.forward_dynamics(base, q, v, tau)
    }

    fn responses_on(
        &self,
        base: &Pose<f64>,
        q: &D::Vector,
        v: &V::Vector,
        tau: &V::Vector,
        freedoms: &V::Each<bool>,
    ) -> Result<Responses<V>, SingularMassMatrix> {
        let factors = JointFactors::new(self.dof(), self.mass_matrix(q))?;
        let qdd = self.forward_dynamics(base, q, v, tau)?;
        Ok((qdd, inverse_columns(self.freedoms(), &factors, freedoms)))
    }
}
