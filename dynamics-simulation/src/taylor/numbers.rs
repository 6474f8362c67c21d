//! The series of a step, in the numbers that the processor computes it with fastest.

use dynamics_runtime::internal::{Expansion, Fused, is_worth_it, with_best_instructions};
use dynamics_runtime::{MAX_TAYLOR_ORDER, SingularMassMatrix, TaylorCoefficients, TaylorDynamics};
use nalgebra::{Const, SVector};

use crate::integrate::Phase;

/// A series in doubles, whichever way they are added.
pub(super) enum Series<R, const N: usize>
where
    R: TaylorDynamics<N>,
{
    /// As the build does it.
    Plain(Box<Expansion<R, f64, N>>),
    /// With fused instructions that the build may not count on.
    Fused {
        expansion: Box<Expansion<R, Fused, N>>,
        coefficients: Box<TaylorCoefficients<f64, N>>,
        forces: Box<TaylorCoefficients<f64, N>>,
    },
}

impl<R: TaylorDynamics<N>, const N: usize> Series<R, N> {
    pub(super) fn new() -> Self {
        let zero = SVector::zeros();
        if !is_worth_it() {
            return Series::Plain(Box::new(Expansion::new(&zero)));
        }
        let zeros = Box::new([zero; MAX_TAYLOR_ORDER + 1]);
        Series::Fused {
            expansion: Box::new(Expansion::new(&zero.map(Fused))),
            coefficients: zeros.clone(),
            forces: zeros,
        }
    }

    /// Which joints series that begin from now on hold where they are.
    pub(super) fn hold(&mut self, joints: Option<[bool; N]>) {
        match self {
            Series::Plain(expansion) => expansion.hold(joints),
            Series::Fused { expansion, .. } => expansion.hold(joints),
        }
    }

    pub(super) fn begin(
        &mut self,
        robot: &R,
        Phase { q, qd }: &Phase<Const<N>>,
        tau: &SVector<f64, N>,
    ) -> Result<(), SingularMassMatrix> {
        match self {
            Series::Plain(expansion) => expansion.begin(robot, q, qd, tau),
            Series::Fused { expansion, .. } => {
                let [q, qd, tau] = [q, qd, tau].map(|x| x.map(Fused));
                with_best_instructions(
                    #[inline(always)]
                    || expansion.begin(robot, &q, &qd, &tau),
                )
            }
        }
    }

    pub(super) fn extend(&mut self, robot: &R, order: usize) {
        match self {
            Series::Plain(expansion) => expansion.extend(robot, order),
            Series::Fused {
                expansion,
                coefficients,
                forces,
            } => {
                with_best_instructions(
                    #[inline(always)]
                    || expansion.extend(robot, order),
                );
                let computed = &expansion.coefficients()[..=order];
                for (x, computed) in coefficients.iter_mut().zip(computed) {
                    *x = computed.map(|x| x.0);
                }
                if expansion.holds() {
                    for (x, computed) in forces.iter_mut().zip(expansion.forces()) {
                        *x = computed.map(|x| x.0);
                    }
                }
            }
        }
    }

    pub(super) fn coefficients(&self) -> &TaylorCoefficients<f64, N> {
        match self {
            Series::Plain(expansion) => expansion.coefficients(),
            Series::Fused { coefficients, .. } => coefficients,
        }
    }

    /// The series of the forces that hold joints; without meaning where none is held.
    pub(super) fn forces(&self) -> &TaylorCoefficients<f64, N> {
        match self {
            Series::Plain(expansion) => expansion.forces(),
            Series::Fused { forces, .. } => forces,
        }
    }

    pub(super) fn acceleration(&self) -> SVector<f64, N> {
        match self {
            Series::Plain(expansion) => expansion.acceleration(),
            Series::Fused { expansion, .. } => expansion.acceleration().map(|x| x.0),
        }
    }
}
