//! The equations of the stages, by a simplified Newton iteration.

use dynamics_runtime::Size;
use nalgebra::Complex;

use super::tableau::{C, COMPLEX, REAL, T, T_INVERSE};
use crate::integrate::embedded::combination;
use crate::integrate::jacobian::{Jacobian, Shifted};
use crate::integrate::{Equations, Phase, Tolerance};

/// The iteration, and what it knows of its speed from one step to the next.
pub(super) struct Newton {
    pub(super) tolerance: f64,
    /// The error that a correction leaves, over the correction.
    left_over: f64,
    /// The ratio of the last two corrections.
    theta: f64,
}

/// The equations of a step of length `h`, and how its corrections are measured.
pub(super) struct Step<'a, S, D: Size> {
    pub(super) system: &'a S,
    pub(super) t: f64,
    pub(super) phase: &'a Phase<D>,
    pub(super) h: f64,
    pub(super) tolerance: &'a Tolerance,
}

/// The two systems of linear equations that the transformed stages come apart into.
pub(super) struct Matrices<D: Size> {
    pub(super) real: Shifted<f64, D>,
    complex: Shifted<Complex<f64>, D>,
}

/// The changes of the stages, and the number of iterations that they took.
type Solved<D> = ([Phase<D>; 3], u32);

/// Why a trial gave no step.
pub(super) enum Miss<E> {
    Refused(E),
    /// The Newton iteration converges too slowly; a step shorter by the factor may do.
    Newton(f64),
}

impl<E> From<E> for Miss<E> {
    fn from(refusal: E) -> Self {
        Miss::Refused(refusal)
    }
}

/// Three sums of three phases, by the rows of a matrix.
fn transformed<D: Size>(rows: &[[f64; 3]; 3], phases: &[Phase<D>; 3]) -> [Phase<D>; 3] {
    rows.map(|row| combination(&row, phases))
}

pub(super) const MOST_ITERATIONS: u32 = 7;
/// An iteration that converges so fast keeps its Jacobian for the next step.
const FAST: f64 = 1e-3;

impl<D: Size> Matrices<D> {
    pub(super) fn new(size: D, jacobian: &Jacobian<D>, h: f64) -> Self {
        Matrices {
            real: Shifted::new(size, REAL / h, jacobian),
            complex: Shifted::new(size, COMPLEX / h, jacobian),
        }
    }
}

impl<S: Equations<D>, D: Size> Step<'_, S, D> {
    /// How the stages move whose changes are `z`.
    fn rates(&self, z: &[Phase<D>; 3]) -> Result<[Phase<D>; 3], S::Refusal> {
        let mut rates = z.clone();
        for i in 0..3 {
            let phase = self.phase.plus(1.0, &z[i]);
            rates[i] = self.system.rate(self.t + C[i] * self.h, &phase)?;
        }
        Ok(rates)
    }

    /// Root mean square over all stages, each entry over its tolerance.
    fn size(&self, stages: &[Phase<D>; 3]) -> f64 {
        let norm = |stage| self.tolerance.norm(stage, self.phase, self.phase);
        let squares = stages.iter().map(|stage| norm(stage).powi(2));
        (squares.sum::<f64>() / 3.0).sqrt()
    }
}

impl Newton {
    pub(super) fn new(tolerance: f64) -> Self {
        Newton {
            tolerance,
            left_over: 1.0,
            theta: 1.0,
        }
    }

    /// Whether the last iteration keeps its Jacobian.
    pub(super) fn was_fast(&self) -> bool {
        self.theta <= FAST
    }

    /// Solves `z = h A f(y + z)` for the stages' changes z, from a guess on, and counts the iterations. The transformed
    /// equations `D / h w = T^-1 f(y + T w)` are two separate systems.
    pub(super) fn solve<S: Equations<D>, D: Size>(
        &mut self,
        step: &Step<S, D>,
        matrices: &Matrices<D>,
        guess: [Phase<D>; 3],
    ) -> Result<Solved<D>, Miss<S::Refusal>> {
        let mut z = guess;
        let mut w = transformed(&T_INVERSE, &z);
        self.left_over = self.left_over.max(f64::EPSILON).powf(0.8);
        self.theta = FAST;
        let (mut before, mut quotient_before) = (0.0, 0.0);
        for k in 0..MOST_ITERATIONS {
            let d = matrices.correction(&w, &step.rates(&z)?, step.h);
            let size = step.size(&d);
            if k > 0 {
                let quotient = size / before;
                self.converges(k, size, quotient, quotient_before)
                    .map_err(Miss::Newton)?;
                quotient_before = quotient;
            }
            before = size.max(f64::MIN_POSITIVE);
            w = core::array::from_fn(|i| w[i].plus(1.0, &d[i]));
            z = transformed(&T, &w);
            if self.left_over * size <= self.tolerance {
                return Ok((z, k + 1));
            }
        }
        Err(Miss::Newton(0.5))
    }

    /// Judges the iteration by the ratio of its last two corrections, and of the two before
    /// (IV.8.10, IV.8.11). Where it is too slow: by what factor the step is to be shorter.
    fn converges(&mut self, k: u32, size: f64, ratio: f64, before: f64) -> Result<(), f64> {
        self.theta = if k == 1 {
            ratio
        } else {
            (ratio * before).sqrt()
        };
        // In doubt, for what is not a number, shorter.
        if self.theta.is_nan() || self.theta >= 0.99 {
            return Err(0.5);
        }
        self.left_over = self.theta / (1.0 - self.theta);
        let left = MOST_ITERATIONS as i32 - 2 - k as i32;
        let expected = self.left_over * size * self.theta.powi(left) / self.tolerance;
        if expected < 1.0 {
            return Ok(());
        }
        let exponent = -1.0 / f64::from(4 + left);
        Err(0.8 * expected.min(20.0).powf(exponent))
    }
}

impl<D: Size> Matrices<D> {
    /// The corrections of the transformed changes `w`, where the stages move at `rates`.
    fn correction(&self, w: &[Phase<D>; 3], rates: &[Phase<D>; 3], h: f64) -> [Phase<D>; 3] {
        let (gamma, alpha, beta) = (REAL / h, COMPLEX.re / h, COMPLEX.im / h);
        let [f1, f2, f3] = transformed(&T_INVERSE, rates);
        let d1 = self.real.solve(&f1.plus(-gamma, &w[0]));
        let (d2, d3) = self.complex.solve(
            &f2.plus(-alpha, &w[1]).plus(beta, &w[2]),
            &f3.plus(-alpha, &w[2]).plus(-beta, &w[1]),
        );
        [d1, d2, d3]
    }
}
