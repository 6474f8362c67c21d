//! The coefficients of a motion, order by order.

use nalgebra::{SMatrix, SVector};

use super::products::Products;
use super::term::{Coefficients, Rest, Term};
use super::{MAX_TAYLOR_ORDER, TaylorCoefficients, TaylorDynamics};
use crate::factorisation::Factors;
use crate::inputs::Known;
use crate::{Scalar, SingularMassMatrix};

/// The series of a motion, and all that its next coefficient depends on.
#[derive(Debug)]
pub struct Expansion<R, T, const N: usize>
where
    R: TaylorDynamics<N>,
    T: Scalar,
{
    coefficients: TaylorCoefficients<T, N>,
    motion: Coefficients<T, N>,
    factors: Factors<T, N>,
    products: R::Products<T>,
    rest: Rest<T, N>,
    /// The force that holds each joint that is held, at the order reached, and the series of it.
    holding: SVector<T, N>,
    forces: TaylorCoefficients<T, N>,
}

impl<R: TaylorDynamics<N>, T: Scalar, const N: usize> Expansion<R, T, N> {
    /// Room for a series; the numbers of `like` do not matter.
    // Not inlined: the zeros of the products are written to their place, and not to another one first.
    #[inline(never)]
    pub fn new(like: &SVector<T, N>) -> Self {
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
            rest: Rest {
                joints: None,
                matrix: SMatrix::repeat(like.constant(0.0)),
            },
            holding: zero,
            forces: [zero; MAX_TAYLOR_ORDER + 1],
        }
    }

    /// The coefficients of the series that was begun.
    pub fn coefficients(&self) -> &TaylorCoefficients<T, N> {
        &self.coefficients
    }

    /// The series of the forces that hold joints.
    #[cfg(feature = "std")]
    pub fn forces(&self) -> &TaylorCoefficients<T, N> {
        &self.forces
    }

    /// Whether a series that begins now holds joints.
    #[cfg(feature = "std")]
    pub fn holds(&self) -> bool {
        self.rest.joints.is_some()
    }

    /// Which joints series that begin from now on hold where they are.
    #[cfg(feature = "std")]
    pub fn hold(&mut self, joints: Option<[bool; N]>) {
        self.rest.joints = joints;
    }

    /// The accelerations of the series that was begun.
    #[cfg(feature = "std")]
    pub fn acceleration(&self) -> SVector<T, N> {
        self.motion.qdd
    }

    /// Begins a series: order 0, with the accelerations. The coefficients before stay until [`extend`](Self::extend).
    // Inlined wherever it is compiled for more instructions than the build has.
    #[inline(always)]
    pub fn begin(
        &mut self,
        robot: &R,
        q: &SVector<T, N>,
        qd: &SVector<T, N>,
        tau: &SVector<T, N>,
    ) -> Result<(), SingularMassMatrix> {
        let zero = q[0].constant(0.0);
        let sines = sines(robot, q);
        let mut matrix = robot.leading_matrix(&Known(sines), q);
        if let Some(held) = &self.rest.joints {
            self.rest.matrix = matrix;
            leave_out(&mut matrix, held);
        }
        self.factors =
            Factors::new(matrix).map_err(|error| error.named(R::JOINT_NAMES[error.joint]))?;
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
    pub fn extend(&mut self, robot: &R, order: usize) {
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
            self.forces[k] = self.holding;
            self.coefficients[k + 2] = self.motion.qd.map(|x| x * second);
        }
        self.coefficients[order + 1..].fill(zero);
        self.forces[order - 1..].fill(zero);
    }

    /// Order k of the equations of motion.
    #[inline(always)]
    fn term<const LEADING: bool>(&mut self, robot: &R, k: usize, motion: Coefficients<T, N>) {
        let mut term = Term::<_, T, N, LEADING> {
            motion,
            next_sine: motion.sine,
            next_cosine: motion.cosine,
            factors: &self.factors,
            rest: &self.rest,
            holding: self.holding,
            products: &mut self.products,
        };
        robot.series_term(&mut term);
        let (sine, cosine, qdd) = (term.next_sine, term.next_cosine, term.motion.qdd);
        self.holding = term.holding;
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

/// Sines and cosines of the positions that are read as angles.
#[inline(always)]
fn sines<R: TaylorDynamics<N>, T: Scalar, const N: usize>(_: &R, q: &SVector<T, N>) -> [(T, T); N] {
    let zero = q[0].constant(0.0);
    T::sin_cos_array(core::array::from_fn(|i| {
        if R::READS_ANGLE[i] { q[i] } else { zero }
    }))
}

/// M(q)
#[cfg(feature = "std")]
pub fn mass_matrix<R: TaylorDynamics<N>, const N: usize>(
    robot: &R,
    q: &SVector<f64, N>,
) -> SMatrix<f64, N, N> {
    robot.leading_matrix(&Known(sines(robot, q)), q)
}

/// Rows and columns of some joints become those of the unit matrix.
fn leave_out<T: Scalar, const N: usize>(matrix: &mut SMatrix<T, N, N>, joints: &[bool; N]) {
    let like = matrix[(0, 0)];
    for i in 0..N {
        for j in (0..N).filter(|j| joints[i] || joints[*j]) {
            matrix[(i, j)] = like.constant(if i == j { 1.0 } else { 0.0 });
        }
    }
}

/// 1 / n, rounded in the arithmetic of `like`.
#[inline(always)]
fn reciprocal<T: Scalar>(like: T, n: usize) -> T {
    like.constant(1.0) / like.constant(n as f64)
}
