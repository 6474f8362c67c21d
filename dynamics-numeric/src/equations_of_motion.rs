//! The numeric algorithms as equations that a simulation solves.

use dynamics_runtime::internal::{JointFactors, Velocities, inverse_columns};
use dynamics_runtime::{
    EquationsOfMotion, OnBase, Place, Responses, SingularMassMatrix, Size, SizedMomenta,
};
use nalgebra::{Const, Dim as _, Dyn};

use crate::{NumericArm, NumericFloating};

impl<D: Size> EquationsOfMotion<D> for NumericArm<D> {
    fn joints(&self) -> D {
        D::from_usize(self.dof())
    }

    fn size(&self) -> D {
        self.joints()
    }

    fn accelerations(
        &self,
        place: &Place<D>,
        qd: &D::Vector,
        tau: &D::Vector,
    ) -> Result<D::Vector, SingularMassMatrix> {
        self.forward_dynamics(&place.q, qd, tau)
    }

    fn accelerations_and_responses(
        &self,
        Place { q, .. }: &Place<D>,
        qd: &D::Vector,
        tau: &D::Vector,
        joints: &D::Each<bool>,
    ) -> Result<Responses<D>, SingularMassMatrix> {
        let factors = JointFactors::new(self.dof(), self.mass_matrix(q))?;
        let available = tau.clone() - self.bias_force(q, qd);
        Ok((
            factors.solve(&available),
            inverse_columns(self.size(), &factors, joints),
        ))
    }

    fn in_momenta(&self) -> Option<&dyn SizedMomenta<D>> {
        Some(self)
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
