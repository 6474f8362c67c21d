//! The coefficients of a motion, order by order.

use nalgebra::SVector;

use super::TaylorDynamics;
use super::coefficients::{MAX_TAYLOR_ORDER, TaylorCoefficients};
use super::products::Products;
use super::term::{Coefficients, Term};
use crate::factorisation::Factors;
use crate::inputs::Known;
use crate::{Scalar, SingularMassMatrix};

/// The series of a motion, and all that its next coefficient depends on.
#[derive(Debug)]
pub(crate) struct Expansion<R, T, const N: usize>
where
    R: TaylorDynamics<N>,
    T: Scalar,
{
    coefficients: TaylorCoefficients<T, N>,
    motion: Coefficients<T, N>,
    factors: Factors<T, N>,
    products: R::Products<T>,
}

impl<R, T, const N: usize> Expansion<R, T, N>
where
    R: TaylorDynamics<N>,
    T: Scalar,
{
    /// Room for a series; the numbers of `like` do not matter.
    // Not inlined: the zeros of the products are written to their place, and not to another one first.
    #[inline(never)]
    pub(crate) fn new(like: &SVector<T, N>) -> Self {
        let like = like[0];
        let zero = SVector::repeat(like.constant(0.0));
        Expansion {
            coefficients: [zero; MAX_TAYLOR_ORDER + 1],
            motion: Coefficients {
                q: zero,
                qd: zero,
                qdd: zero,
                sine: zero,
                cosine: zero,
                sign: zero,
                tau: zero,
            },
            factors: Factors::unit(like),
            products: R::Products::new(like.constant(0.0)),
        }
    }

    pub(crate) fn coefficients(&self) -> &TaylorCoefficients<T, N> {
        &self.coefficients
    }

    /// The accelerations of the series that was begun.
    #[cfg(feature = "std")]
    pub(crate) fn acceleration(&self) -> SVector<T, N> {
        self.motion.qdd
    }

    /// Begins a series: everything of order 0, the accelerations included. The coefficients of the
    /// series before stay until [`extend`](Self::extend).
    // Inlined wherever it is compiled for more instructions than the build has.
    #[inline(always)]
    pub(crate) fn begin(
        &mut self,
        robot: &R,
        q: &SVector<T, N>,
        qd: &SVector<T, N>,
        tau: &SVector<T, N>,
    ) -> Result<(), SingularMassMatrix> {
        let zero = q[0].constant(0.0);
        let angles: [T; N] = core::array::from_fn(|i| if R::READS_ANGLE[i] { q[i] } else { zero });
        let sines = T::sin_cos_array(angles);
        self.factors = Factors::new(robot.leading_matrix(&Known(sines), q))
            .map_err(|error| error.named(R::JOINT_NAMES[error.joint]))?;
        let motion = Coefficients {
            q: *q,
            qd: *qd,
            qdd: SVector::repeat(zero),
            sine: SVector::from_fn(|i, _| sines[i].0),
            cosine: SVector::from_fn(|i, _| sines[i].1),
            sign: qd.map(|qd| qd.sign()),
            tau: *tau,
        };
        self.term::<true>(robot, 0, motion);
        Ok(())
    }

    /// The coefficients of the series that was begun, up to an order.
    #[inline(always)]
    pub(crate) fn extend(&mut self, robot: &R, order: usize) {
        let order = order.clamp(2, MAX_TAYLOR_ORDER);
        let zero = SVector::repeat(self.motion.q[0].constant(0.0));
        self.coefficients[0] = self.motion.q;
        self.coefficients[1] = self.motion.qd;
        // From order 1 on, the constants tau are zero.
        self.motion.tau = zero;
        for k in 0..order - 1 {
            if k > 0 {
                self.products.advance(k);
                let motion = Coefficients {
                    q: self.coefficients[k],
                    qdd: zero,
                    ..self.motion
                };
                self.term::<false>(robot, k, motion);
            }
            // qd_{k+1} = qdd_k / (k + 1), q_{k+2} = qd_{k+1} / (k + 2)
            let [first, second] = [k + 1, k + 2].map(|n| reciprocal(self.motion.q[0], n));
            self.motion.qd = self.motion.qdd.map(|x| x * first);
            self.coefficients[k + 2] = self.motion.qd.map(|x| x * second);
        }
        self.coefficients[order + 1..].fill(zero);
    }

    /// Order k of the equations of motion.
    #[inline(always)]
    fn term<const LEADING: bool>(&mut self, robot: &R, k: usize, motion: Coefficients<T, N>) {
        let mut term = Term::<_, T, N, LEADING> {
            motion,
            next_sine: motion.sine,
            next_cosine: motion.cosine,
            factors: &self.factors,
            products: &mut self.products,
        };
        robot.series_term(&mut term);
        let (sine, cosine, qdd) = (term.next_sine, term.next_cosine, term.motion.qdd);
        let inverse = reciprocal(motion.q[0], k + 1);
        for (sine, cosine) in self.products.multiples() {
            (*sine, *cosine) = (*sine * inverse, *cosine * inverse);
        }
        self.motion = Coefficients {
            qdd,
            sine: sine.map(|x| x * inverse),
            cosine: cosine.map(|x| x * inverse),
            ..motion
        };
    }
}

/// 1 / n, rounded in the arithmetic of `like`.
#[inline(always)]
fn reciprocal<T: Scalar>(like: T, n: usize) -> T {
    like.constant(1.0) / like.constant(n as f64)
}
