//! The functions that `robot_dynamics!` generates.

use robot_dynamics::nalgebra::{SMatrix, SVector};

use super::Candidate;
use measured_arms::*;

/// The name of the generated functions among the candidates.
pub(crate) const GENERATED: &str = "generated";

macro_rules! candidates {
    ($($file:ident: $arm:ident, $n:literal;)*) => {$(
        impl Candidate<$n> for $arm {
            const NAME: &'static str = GENERATED;

            #[inline]
            fn inverse_dynamics(
                &mut self,
                q: &SVector<f64, $n>,
                qd: &SVector<f64, $n>,
                qdd: &SVector<f64, $n>,
            ) -> SVector<f64, $n> {
                $arm::inverse_dynamics(self, q, qd, qdd)
            }

            #[inline]
            fn mass_matrix(&mut self, q: &SVector<f64, $n>) -> SMatrix<f64, $n, $n> {
                $arm::mass_matrix(self, q)
            }

            #[inline]
            fn coriolis_vector(
                &mut self,
                q: &SVector<f64, $n>,
                qd: &SVector<f64, $n>,
            ) -> SVector<f64, $n> {
                $arm::coriolis_vector(self, q, qd)
            }

            #[inline]
            fn gravity_vector(&mut self, q: &SVector<f64, $n>) -> SVector<f64, $n> {
                $arm::gravity_vector(self, q)
            }

            #[inline]
            fn forward_dynamics(
                &mut self,
                q: &SVector<f64, $n>,
                qd: &SVector<f64, $n>,
                tau: &SVector<f64, $n>,
            ) -> Option<SVector<f64, $n>> {
                $arm::forward_dynamics(self, q, qd, tau).ok()
            }
        }
    )*};
}
for_each_arm!(candidates);
