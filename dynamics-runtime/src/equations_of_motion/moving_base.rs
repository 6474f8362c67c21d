//! The equations of a robot on a base that moves.

#[cfg(feature = "std")]
use nalgebra::Dyn;
use nalgebra::{Const, Dim as _, SVector};

use super::{EquationsOfMotion, Responses, inverse_columns, responses};
use crate::dual::Dual;
use crate::factorisation::JointFactors;
use crate::function::{Entries, functions};
use crate::place::{OnBase, Place, Velocities};
use crate::size::Size;
use crate::{Evaluated, Function, NumericFloating, Scalar, SingularMassMatrix};

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

macro_rules! numeric_equations {
    ($([$($n:tt)*] $k:ty, $d:ty, $v:ty;)*) => {$(
        impl<$($n)*> EquationsOfMotion<$k> for NumericFloating<$d, $v> {
            fn joints(&self) -> $d {
                <$d>::from_usize(self.dof() - 6)
            }

            fn size(&self) -> $v {
                <$v>::from_usize(self.dof())
            }

            fn accelerations(
                &self,
                place: &Place<$d>,
                v: &Velocities<$k>,
                tau: &Velocities<$k>,
            ) -> Result<Velocities<$k>, SingularMassMatrix> {
                self.forward_dynamics(&place.pose(), &place.q, v, tau)
            }

            fn accelerations_and_responses(
                &self,
                place: &Place<$d>,
                v: &Velocities<$k>,
                tau: &Velocities<$k>,
                freedoms: &<$v as Size>::Each<bool>,
            ) -> Result<Responses<$v>, SingularMassMatrix> {
                let factors = JointFactors::new(self.dof(), self.mass_matrix(&place.q))?;
                let qdd = self.forward_dynamics(&place.pose(), &place.q, v, tau)?;
                let size = <$v>::from_usize(self.dof());
                Ok((qdd, inverse_columns(size, &factors, freedoms)))
            }
        }
    )*};
}

numeric_equations! {
    [const N: usize, const V: usize] OnBase<N, V>, Const<N>, Const<V>;
    [] Dyn, Dyn, Dyn;
}
