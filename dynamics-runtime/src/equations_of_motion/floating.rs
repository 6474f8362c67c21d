//! The equations of a robot on a base that moves.

use nalgebra::{Const, SVector};

use super::{EquationsOfMotion, Responses, inverse_columns, responses};
use crate::dual::Dual;
use crate::factorisation::JointFactors;
use crate::function::{Entries, functions};
use crate::size::Size;
use crate::stand::OnBase;
use crate::{Evaluated, Function, NumericFloating, Pose, Scalar, SingularMassMatrix};

/// Vectors of the generated forward dynamics on a base that moves: the pose, q, v, tau.
type OfForwardDynamics<const N: usize, const V: usize> =
    (Entries<12, 1>, Entries<N, 1>, Entries<V, 1>, Entries<V, 1>);

impl<R, const N: usize, const V: usize> EquationsOfMotion<OnBase<Const<N>, Const<V>>> for R
where
    R: Function<
            functions::ForwardDynamics,
            N,
            Arguments = OfForwardDynamics<N, V>,
            Values = Entries<V, 1>,
            Error = SingularMassMatrix,
        >,
{
    fn size(&self) -> Const<V> {
        Const
    }

    #[inline]
    fn accelerations(
        &self,
        (base, q): (&Pose<f64>, &SVector<f64, N>),
        v: &SVector<f64, V>,
        tau: &SVector<f64, V>,
    ) -> Result<SVector<f64, V>, SingularMassMatrix> {
        let arguments = (base.entries(), *q, *v, *tau);
        self.at(functions::ForwardDynamics, &Evaluated, &arguments)
    }

    fn accelerations_and_responses(
        &self,
        (base, q): (&Pose<f64>, &SVector<f64, N>),
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

impl<D: Size, V: Size> EquationsOfMotion<OnBase<D, V>> for NumericFloating<D, V> {
    fn size(&self) -> V {
        V::from_usize(self.dof())
    }

    fn accelerations(
        &self,
        (base, q): (&Pose<f64>, &D::Vector),
        v: &V::Vector,
        tau: &V::Vector,
    ) -> Result<V::Vector, SingularMassMatrix> {
        self.forward_dynamics(base, q, v, tau)
    }

    fn accelerations_and_responses(
        &self,
        (base, q): (&Pose<f64>, &D::Vector),
        v: &V::Vector,
        tau: &V::Vector,
        freedoms: &V::Each<bool>,
    ) -> Result<Responses<V>, SingularMassMatrix> {
        let factors = JointFactors::new(self.dof(), self.mass_matrix(q))?;
        let qdd = self.forward_dynamics(base, q, v, tau)?;
        Ok((qdd, inverse_columns(self.size(), &factors, freedoms)))
    }
}
