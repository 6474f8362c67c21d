//! The equations of a robot on a base that moves.

use nalgebra::{Const, SVector};

use super::{EquationsOfMotion, Responses, responses};
use crate::dual::Dual;
use crate::function::{Entries, functions};
use crate::place::{OnBase, Place};
use crate::{Evaluated, Function, Scalar, SingularMassMatrix};

/// Vectors of the generated forward dynamics on a base that moves: the pose, q, v, tau.
type OfForwardDynamics<const N: usize, const V: usize> =
    (Entries<12, 1>, Entries<N, 1>, Entries<V, 1>, Entries<V, 1>);

impl<R, const N: usize, const V: usize> EquationsOfMotion<OnBase<N, V>> for R
where
    R: Function<
            functions::ForwardDynamics,
            N,
            Arguments = OfForwardDynamics<N, V>,
            Values = Entries<V, 1>,
            Error = SingularMassMatrix,
        >,
{
    fn joints(&self) -> Const<N> {
        Const
    }

    fn size(&self) -> Const<V> {
        Const
    }

    #[inline]
    fn accelerations(
        &self,
        place: &Place<Const<N>>,
        v: &SVector<f64, V>,
        tau: &SVector<f64, V>,
    ) -> Result<SVector<f64, V>, SingularMassMatrix> {
        let arguments = (place.pose().entries(), place.q, *v, *tau);
        self.at(functions::ForwardDynamics, &Evaluated, &arguments)
    }

    fn accelerations_and_responses(
        &self,
        place: &Place<Const<N>>,
        v: &SVector<f64, V>,
        tau: &SVector<f64, V>,
        freedoms: &[bool; V],
    ) -> Result<Responses<Const<V>>, SingularMassMatrix> {
        let base = place.pose().entries().map(Dual::from_f64);
        let (q, v) = (place.q.map(Dual::from_f64), v.map(Dual::from_f64));
        responses(tau, freedoms, |tau| {
            self.at(functions::ForwardDynamics, &Evaluated, &(base, q, v, *tau))
        })
    }
}
