//! The links that bodies can have, nearest to given ones.
//!
//! A link has the mass m, the first moments h and the tensor J about the origin. Its pseudo-inertia is
//! `P = [[S, h], [h', m]]` with `S = tr(J)/2 1 - J`. Positive masses can be distributed so if and only if P is positive
//! definite, or semidefinite at the limit (P. M. Wensing, S. Kim, J.-J. E. Slotine, IEEE Robotics and Automation
//! Letters 3 (2018), 60-67).
//!
//! The distance from the table's links is the sum of their entropic divergences `tr(P0^-1 P) - log det(P0^-1 P) - 4`.
//! No choice of units or frames changes it (T. Lee, P. M. Wensing, F. C. Park, IEEE Transactions on Robotics 36
//! (2020), 168-182). It is a barrier as well: it grows without bound where P becomes singular.

use dynamics_runtime::nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// The number of parameters of a link; a motor has one, its reflected inertia, which is its matrix P.
pub(crate) const OF_LINK: usize = 10;

/// The least eigenvalue of P0 beside the greatest: the divergence is finite for positive definite P0 alone.
const LEAST: f64 = 1e-4;

/// The excess of the square of a distance over the least one that is small enough, relative to it.
const NEAR: f64 = 0.1;

/// The stages, each of which makes the equations ten times as hard, and the most steps of Newton's method for each.
const STAGES: usize = 16;
const STEPS: usize = 60;

/// A link or a motor.
pub(crate) struct Part {
    /// The matrices E_k of `P = sum p_k E_k`.
    basis: Vec<DMatrix<f64>>,
    prior: DMatrix<f64>,
    inverse_prior: DMatrix<f64>,
}

/// The matrix P of a link or of a motor.
fn matrix(p: &[f64]) -> DMatrix<f64> {
    let &[m, x, y, z, xx, yy, zz, xy, yz, xz] = p else {
        return DMatrix::from_column_slice(p.len(), 1, p);
    };
    let half = 0.5 * (xx + yy + zz);
    #[rustfmt::skip]
    let entries = [half - xx, -xy, -xz, x, -xy, half - yy, -yz, y, -xz, -yz, half - zz, z, x, y, z, m];
    DMatrix::from_column_slice(4, 4, &entries)
}

/// The parameters of a matrix P.
fn parameters(matrix: &DMatrix<f64>) -> Vec<f64> {
    if matrix.len() == 1 {
        return vec![matrix[0]];
    }
    let [x, y, z] = [0, 1, 2].map(|i| matrix[(i, i)]);
    let [mx, my, mz] = [0, 1, 2].map(|i| matrix[(i, 3)]);
    let [xy, yz, xz] = [(0, 1), (1, 2), (0, 2)].map(|entry| -matrix[entry]);
    let moments = [y + z, z + x, x + y, xy, yz, xz];
    [&[matrix[(3, 3)], mx, my, mz][..], &moments].concat()
}

impl Part {
    /// A part with these parameters in the table, of an arm with links of about this mass, kg, and length, m.
    pub(crate) fn new(p: &[f64], (mass, length): (f64, f64)) -> Option<Self> {
        let units = DMatrix::identity(p.len(), p.len());
        let basis = units
            .column_iter()
            .map(|unit| matrix(unit.as_slice()))
            .collect();
        let size = matrix(p).nrows();
        // Moments in units of mass, so that all entries have one unit.
        let scale = |x: f64| {
            let entry = |i: usize, _| if i < 3 && size > 1 { x } else { 1.0 };
            DMatrix::from_diagonal(&DVector::from_fn(size, entry))
        };
        let mut eigen = (scale(1.0 / length) * matrix(p) * scale(1.0 / length)).symmetric_eigen();
        let largest = eigen.eigenvalues.max();
        let least = LEAST * if largest > 0.0 { largest } else { mass };
        eigen.eigenvalues.apply(|x| *x = x.max(least));
        let prior = scale(length) * eigen.recompose() * scale(length);
        let inverse_prior = prior.clone().cholesky()?.inverse();
        Some(Part {
            basis,
            prior,
            inverse_prior,
        })
    }
}

/// Parts with the equations `map (p - start) = missing`.
pub(crate) struct Search {
    pub(crate) parts: Vec<Part>,
    pub(crate) map: DMatrix<f64>,
    pub(crate) start: DVector<f64>,
    pub(crate) missing: DVector<f64>,
}

/// The divergence at some parameters.
struct Divergence {
    value: f64,
    gradient: DVector<f64>,
    hessian: Cholesky<f64, Dyn>,
    /// `sum tr(P0^-1 P)`
    traces: f64,
}

impl Search {
    /// The nearest possible parts that fulfil the equations, and zero; or, where none do, possible parts whose residual
    /// is within 5 % of the least one, and that residual, `map (p - start) - missing`.
    ///
    /// The minima of `divergence + |residual|^2 / (2 softness)` are followed as the softness falls. `None` where a matrix
    /// cannot be factored, because numbers are too large.
    pub(crate) fn nearest(&self) -> Option<(DVector<f64>, DVector<f64>)> {
        let priors = self.parts.iter().flat_map(|part| parameters(&part.prior));
        let mut p = DVector::from_iterator(self.start.len(), priors);
        let sizes: usize = self.parts.iter().map(|part| part.prior.nrows()).sum();
        let mut softness = self.missing.norm_squared();
        for _ in 0..STAGES {
            let there;
            (p, there) = self.minimum(p, softness)?;
            let residual = self.residual(&p);
            // The last step to the equations: where it ends at possible parts, these fulfil them.
            let exact = &p + self.step(&there.hessian, &(&p * 0.0), &residual, 0.0)?;
            if let Some((nearest, _)) = self.minimum(exact, 0.0) {
                return Some((nearest, residual * 0.0));
            }
            // A convex function falls by no more than its slope times the way. Here the slope is that of the barrier,
            // and this is by how much the least squared residual may be below the present one.
            let gap = 2.0 * softness * (sizes as f64 + there.traces);
            if gap < NEAR * residual.norm_squared() {
                break;
            }
            softness *= 0.1;
        }
        let residual = self.residual(&p);
        Some((p, residual))
    }

    fn residual(&self, p: &DVector<f64>) -> DVector<f64> {
        &self.map * (p - &self.start) - &self.missing
    }

    /// The minimum at one softness, at zero that on the equations, by Newton's method with steps that are halved until
    /// the value falls; `None` where it begins outside of what is possible.
    fn minimum(&self, mut p: DVector<f64>, softness: f64) -> Option<(DVector<f64>, Divergence)> {
        // The minima on the way need not be sharp.
        let is_soft = softness > 0.0;
        let (weight, rest) = if is_soft {
            (1.0 / softness, 1e-3)
        } else {
            (0.0, 1e-10)
        };
        let penalty = |p: &DVector<f64>| 0.5 * weight * self.residual(p).norm_squared();
        let mut here = self.divergence(&p)?;
        for _ in 0..STEPS {
            let residual = self.residual(&p);
            let step = self.step(&here.hessian, &here.gradient, &residual, softness)?;
            let slope = here.gradient.dot(&step) + weight * residual.dot(&(&self.map * &step));
            let value = here.value + penalty(&p);
            let next = (0..30).find_map(|halvings| {
                let length = 0.5_f64.powi(halvings);
                let next = &p + &step * length;
                let there = self.divergence(&next)?;
                let found = there.value + penalty(&next);
                (found <= value + 0.1 * length * slope).then_some((next, there))
            });
            let Some(next) = next else { break };
            (p, here) = next;
            if slope > -rest {
                break;
            }
        }
        Some((p, here))
    }

    /// Newton's step s: `H s + map' w = -gradient`, `map s - softness w = -residual`.
    fn step(
        &self,
        hessian: &Cholesky<f64, Dyn>,
        gradient: &DVector<f64>,
        residual: &DVector<f64>,
        softness: f64,
    ) -> Option<DVector<f64>> {
        let of_equations = hessian.solve(&self.map.transpose());
        let free = hessian.solve(gradient);
        let mut schur = &self.map * &of_equations;
        (0..schur.nrows()).for_each(|k| schur[(k, k)] += softness);
        let multipliers = schur.cholesky()?.solve(&(residual - &self.map * &free));
        Some(-(free + of_equations * multipliers))
    }

    /// The divergence, less a constant, or `None` where a part is not possible.
    fn divergence(&self, p: &DVector<f64>) -> Option<Divergence> {
        let (mut value, mut traces, mut first) = (0.0, 0.0, 0);
        let (mut gradient, mut hessian) = (p * 0.0, DMatrix::zeros(p.len(), p.len()));
        for part in &self.parts {
            let (basis, inverse_prior) = (&part.basis, &part.inverse_prior);
            let matrix = matrix(&p.as_slice()[first..first + basis.len()]);
            let factor = matrix.clone().cholesky()?;
            let inverse = factor.inverse();
            traces += inverse_prior.dot(&matrix);
            value -= 2.0 * factor.l_dirty().diagonal().map(f64::ln).sum();
            let slope = inverse_prior - &inverse;
            for (l, of_l) in basis.iter().enumerate() {
                gradient[first + l] = slope.dot(of_l);
                // d P^-1 / d p_l = -P^-1 E_l P^-1
                let turned = &inverse * of_l * &inverse;
                for (k, of_k) in basis.iter().enumerate() {
                    hessian[(first + k, first + l)] = of_k.dot(&turned);
                }
            }
            first += basis.len();
        }
        Some(Divergence {
            value: value + traces,
            gradient,
            hessian: hessian.cholesky()?,
            traces,
        })
    }
}
