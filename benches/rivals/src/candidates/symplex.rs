//! The functions that symplex generates from the same tables (see `build/`).
//!
//! symplex solves no linear system: forward dynamics is its M and bias, and nalgebra's Cholesky
//! factorisation. Friction is added as the runtime computes it.

use robot_dynamics::nalgebra::{SMatrix, SVector};
use robot_dynamics::{Model, NewtonEuler};

use super::Candidate;
use measured_arms::*;

#[allow(clippy::all, unused)]
mod code {
    include!(concat!(env!("OUT_DIR"), "/symplex.rs"));
}

/// The code for the arm `A`.
pub(crate) struct Symplex<A, const N: usize> {
    numeric: NewtonEuler<N>,
    arm: std::marker::PhantomData<A>,
}

impl<A: Model<N>, const N: usize> Symplex<A, N> {
    pub(crate) fn new(arm: &A) -> Self {
        Symplex {
            numeric: NewtonEuler::new(&arm.table()),
            arm: std::marker::PhantomData,
        }
    }
}

macro_rules! candidates {
    ($($file:ident: $arm:ident, $n:literal;)*) => {$(
        impl Candidate<$n> for Symplex<$arm, $n> {
            const NAME: &'static str = "symplex";

            fn inverse_dynamics(
                &mut self,
                q: &SVector<f64, $n>,
                qd: &SVector<f64, $n>,
                qdd: &SVector<f64, $n>,
            ) -> SVector<f64, $n> {
                let [q, v, qdd] = [q, qd, qdd].map(|x| &x.data.0[0]);
                SVector::from(code::$file::inverse_dynamics(q, v, qdd))
                    + self.numeric.friction_vector(qd)
            }

            fn mass_matrix(&mut self, q: &SVector<f64, $n>) -> SMatrix<f64, $n, $n> {
                SMatrix::from_row_slice(&code::$file::mass_matrix(&q.data.0[0]))
            }

            fn coriolis_vector(
                &mut self,
                q: &SVector<f64, $n>,
                qd: &SVector<f64, $n>,
            ) -> SVector<f64, $n> {
                code::$file::coriolis_vector(&q.data.0[0], &qd.data.0[0]).into()
            }

            fn gravity_vector(&mut self, q: &SVector<f64, $n>) -> SVector<f64, $n> {
                code::$file::gravity_vector(&q.data.0[0]).into()
            }

            fn forward_dynamics(
                &mut self,
                q: &SVector<f64, $n>,
                qd: &SVector<f64, $n>,
                tau: &SVector<f64, $n>,
            ) -> Option<SVector<f64, $n>> {
                let bias = SVector::from(code::$file::bias_force(&q.data.0[0], &qd.data.0[0]));
                let available = tau - bias - self.numeric.friction_vector(qd);
                Some(self.mass_matrix(q).cholesky()?.solve(&available))
            }
        }
    )*};
}
for_each_arm!(candidates);
