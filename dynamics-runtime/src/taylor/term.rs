//! One order of the series, as generated code sees it.

use nalgebra::{SMatrix, SVector};

use super::products::Products;
use crate::Scalar;
use crate::factorisation::Factors;

/// Coefficients of order k: what the generated equations of motion read and write.
///
/// Terms of the accelerations are computed twice: with accelerations of 0, up to [`solve`](SeriesTerm::solve), and with
/// those found.
#[doc(hidden)]
pub trait SeriesTerm<T, const N: usize> {
    /// A number, for its arithmetic.
    fn like(&self) -> T;
    /// The coefficient of a constant.
    fn constant(&self, x: T) -> T;
    /// The coefficient of the sine of a joint's position.
    fn sine(&self, joint: usize) -> T;
    /// The coefficient of the cosine.
    fn cosine(&self, joint: usize) -> T;
    /// The coefficient of a position.
    fn position(&self, joint: usize) -> T;
    /// The coefficient of a velocity.
    fn velocity(&self, joint: usize) -> T;
    /// The coefficient of the sign of a velocity, which counts as constant.
    fn velocity_sign(&self, joint: usize) -> T;
    /// The coefficient of an acceleration: 0 before it is solved for.
    fn acceleration(&self, joint: usize) -> T;
    /// The coefficient of the product of two series, whose coefficients of this order are given.
    fn product(&mut self, slot: usize, a: T, b: T) -> T;
    /// The same of coefficients that are not final.
    fn trial(&self, slot: usize, a: T, b: T) -> T;
    /// The next coefficients of sine and cosine of a joint's position, by two products.
    fn turn(&mut self, joint: usize, slot: usize);
    /// The coefficients of sine and cosine of a joint's position times a factor, an angle of that index.
    fn multiple(&mut self, index: usize, joint: usize, factor: T) -> (T, T);
    /// The next coefficients of these, by two products. The coefficients of this order are gone then.
    fn turn_multiple(&mut self, index: usize, joint: usize, factor: T, slot: usize);
    /// The accelerations that the forces lack.
    fn solve(&mut self, forces: [T; N]);
}

/// The state of an expansion from one order to the next.
#[derive(Clone, Copy, Debug)]
pub(super) struct Coefficients<T, const N: usize> {
    pub(super) q: SVector<T, N>,
    pub(super) qd: SVector<T, N>,
    pub(super) qdd: SVector<T, N>,
    pub(super) sine: SVector<T, N>,
    pub(super) cosine: SVector<T, N>,
    pub(super) sign: SVector<T, N>,
    pub(super) tau: SVector<T, N>,
}

/// One order of an expansion; `LEADING` is whether it is order 0.
pub(super) struct Term<'a, P, T, const N: usize, const LEADING: bool> {
    pub(super) motion: Coefficients<T, N>,
    pub(super) next_sine: SVector<T, N>,
    pub(super) next_cosine: SVector<T, N>,
    pub(super) factors: &'a Factors<T, N>,
    pub(super) rest: &'a Rest<T, N>,
    /// The forces that hold the joints that are held.
    pub(super) holding: SVector<T, N>,
    pub(super) products: &'a mut P,
}

/// Joints that are held where they are.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rest<T, const N: usize> {
    /// Which these are; none where there are none.
    pub(super) joints: Option<[bool; N]>,
    /// M(q_0) of all joints.
    pub(super) matrix: SMatrix<T, N, N>,
}

impl<P, T, const N: usize, const LEADING: bool> SeriesTerm<T, N> for Term<'_, P, T, N, LEADING>
where
    P: Products<T>,
    T: Scalar,
{
    #[inline(always)]
    fn like(&self) -> T {
        self.motion.q[0]
    }

    #[inline(always)]
    fn constant(&self, x: T) -> T {
        if LEADING { x } else { x.constant(0.0) }
    }

    #[inline(always)]
    fn sine(&self, joint: usize) -> T {
        self.motion.sine[joint]
    }

    #[inline(always)]
    fn cosine(&self, joint: usize) -> T {
        self.motion.cosine[joint]
    }

    #[inline(always)]
    fn position(&self, joint: usize) -> T {
        self.motion.q[joint]
    }

    #[inline(always)]
    fn velocity(&self, joint: usize) -> T {
        self.motion.qd[joint]
    }

    #[inline(always)]
    fn velocity_sign(&self, joint: usize) -> T {
        self.constant(self.motion.sign[joint])
    }

    #[inline(always)]
    fn acceleration(&self, joint: usize) -> T {
        self.motion.qdd[joint]
    }

    #[inline(always)]
    fn product(&mut self, slot: usize, a: T, b: T) -> T {
        self.products.store(slot, a, b);
        self.trial(slot, a, b)
    }

    #[inline(always)]
    fn trial(&self, slot: usize, a: T, b: T) -> T {
        if LEADING {
            return a * b;
        }
        let [left, right, sum] = self.products.lead(slot);
        left.mul_add(b, a.mul_add(right, sum))
    }

    #[inline(always)]
    fn turn(&mut self, joint: usize, slot: usize) {
        let (s, c) = (self.motion.sine[joint], self.motion.cosine[joint]);
        let qd = self.motion.qd[joint];
        self.next_sine[joint] = self.product(slot, c, qd);
        self.next_cosine[joint] = -self.product(slot + 1, s, qd);
    }

    #[inline(always)]
    fn multiple(&mut self, index: usize, joint: usize, factor: T) -> (T, T) {
        let multiple = &mut self.products.multiples()[index];
        if LEADING {
            *multiple = (factor * self.motion.q[joint]).sin_cos();
        }
        *multiple
    }

    #[inline(always)]
    fn turn_multiple(&mut self, index: usize, joint: usize, factor: T, slot: usize) {
        let (s, c) = self.products.multiples()[index];
        let rate = factor * self.motion.qd[joint];
        let (sine, cosine) = (
            self.product(slot, c, rate),
            -self.product(slot + 1, s, rate),
        );
        self.products.multiples()[index] = (sine, cosine);
    }

    #[inline(always)]
    fn solve(&mut self, forces: [T; N]) {
        let lacking = SVector::from_fn(|i, _| self.motion.tau[i] - forces[i]);
        match &self.rest.joints {
            None => self.motion.qdd = self.factors.solve(&lacking),
            Some(held) => self.solve_beside(held, lacking),
        }
    }
}

impl<P, T: Scalar, const N: usize, const LEADING: bool> Term<'_, P, T, N, LEADING> {
    /// The accelerations where those of some joints are zero, and the forces f that hold these: `M qdd = lacking + f`.
    /// Their rows and columns in the factors are those of the unit matrix.
    fn solve_beside(&mut self, held: &[bool; N], lacking: SVector<T, N>) {
        let zero = self.motion.q[0].constant(0.0);
        let of_others = SVector::from_fn(|i, _| if held[i] { zero } else { lacking[i] });
        let mut qdd = self.factors.solve(&of_others);
        for i in (0..N).filter(|i| held[*i]) {
            qdd[i] = zero;
        }
        self.motion.qdd = qdd;
        self.holding = SVector::from_fn(|i, _| {
            let add = |force: T, j: usize| self.rest.matrix[(i, j)].mul_add(qdd[j], force);
            if held[i] {
                (0..N).fold(-lacking[i], add)
            } else {
                zero
            }
        });
    }
}
