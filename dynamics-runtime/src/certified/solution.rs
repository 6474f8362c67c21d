//! Verified solutions of M x = b.
//!
//! With a matrix R near M^-1, whatever it came from, and C >= |1 - R M|, entry by entry, a vector x and its residual
//! r = b - M x say how far x is from the solution:
//!
//! ```text
//! e = M^-1 b - x = R r + (1 - R M) e
//! |e| <= |R r| + C |e|
//! ```
//!
//! In a norm max_i |e_i| / w_i in which that of C is alpha < 1, |e| is at most that of R r over 1 - alpha, which is put
//! into C |e| once. If alpha < 1, R and every matrix within M's errors are regular (S. M. Rump, *Verification methods:
//! rigorous results using floating-point arithmetic*, Acta Numerica 19 (2010), section 10).
//!
//! The residual of M x = b is evaluated in numbers of the third precision, `DoubleDouble` with bounds in doubles.
//! Sums add what they round off exactly (2Sum), other operations half a unit in the last place, sines and
//! exponentials one.

use core::ops::Index;

use nalgebra::allocator::Allocator;
use nalgebra::{Const, DefaultAllocator, Dim, OMatrix, OVector};

use super::outward::Bound;
use super::rounded::Magnitude;
use super::{Certified, Rounded};
use crate::factorisation::{factor, substitute};

/// The bounds by which solutions with a matrix M are judged.
pub(super) struct Verification<F: Rounded, D: Dim>
where
    DefaultAllocator: Allocator<D> + Allocator<D, D>,
{
    /// R.
    inverse: OMatrix<F, D, D>,
    /// C.
    defect: OMatrix<Bound<F::Magnitude>, D, D>,
    /// w: one over the roots of M's diagonal, so that units and light links do not matter.
    weights: OVector<Bound<F::Magnitude>, D>,
    /// 1 - alpha, or less.
    margin: Bound<F::Magnitude>,
}

impl<F: Rounded, D: Dim> Verification<F, D>
where
    DefaultAllocator: Allocator<D> + Allocator<D, D>,
{
    /// `None` where some matrix within the errors of `m` may be singular.
    pub(super) fn of(m: &OMatrix<Certified<F>, D, D>) -> Option<Self> {
        let [zero, one] = [F::ZERO, F::from_f64(1.0)];
        let (size, joints) = (m.shape_generic().0, m.nrows());
        let unit = |i: usize, j: usize| if i == j { one } else { zero };
        let mut upper = m.map(Certified::value);
        let diagonal = OVector::from_fn_generic(size, Const::<1>, |i, _| upper[(i, i)]);
        let mut inverse_pivots = diagonal.clone();
        factor(joints, &mut upper, &mut inverse_pivots).ok()?;
        let mut inverse = OMatrix::from_fn_generic(size, size, unit);
        for j in 0..joints {
            let mut column = inverse.column(j).into_owned();
            substitute(joints, &upper, &inverse_pivots, &mut column);
            inverse.set_column(j, &column);
        }
        let defect = OMatrix::from_fn_generic(size, size, |i, j| {
            let column = m.column(j).into_owned();
            (product(joints, &inverse, i, &column) - Certified::exact(unit(i, j))).largest()
        });
        let weights = diagonal.map(|x| Bound::new((one / x.sqrt()).magnitude()));
        let row = |i: usize| sum((0..joints).map(|j| defect[(i, j)] * weights[j])) / weights[i];
        let alpha = (0..joints).map(row).fold(Bound::NONE, Bound::max);
        Some(Verification {
            margin: Bound::new(F::Magnitude::ONE).beyond(alpha)?,
            inverse,
            defect,
            weights,
        })
    }

    /// R b: near the solution.
    pub(super) fn approximate(&self, b: &OVector<Certified<F>, D>) -> OVector<F, D> {
        let entry = |i: usize, _| product(b.len(), &self.inverse, i, b).value();
        OVector::from_fn_generic(b.shape_generic().0, Const::<1>, entry)
    }

    /// The greatest distance of a vector with this residual from the solution.
    pub(super) fn error(
        &self,
        residual: &OVector<Certified<F>, D>,
    ) -> OVector<Bound<F::Magnitude>, D> {
        let (size, joints) = (residual.shape_generic().0, residual.len());
        let first = |i: usize, _| product(joints, &self.inverse, i, residual).largest();
        let first = OVector::from_fn_generic(size, Const::<1>, first);
        let relative = (0..joints).map(|i| first[i] / self.weights[i]);
        let norm = relative.fold(Bound::NONE, Bound::max) / self.margin;
        OVector::from_fn_generic(size, Const::<1>, |i, _| {
            let rest = (0..joints).map(|j| self.defect[(i, j)] * (norm * self.weights[j]));
            first[i] + sum(rest)
        })
    }
}

/// Entry `i` of R x, for so many joints.
fn product<F: Rounded>(
    joints: usize,
    inverse: &impl Index<(usize, usize), Output = F>,
    i: usize,
    x: &impl Index<usize, Output = Certified<F>>,
) -> Certified<F> {
    let terms = (0..joints).map(|j| Certified::exact(inverse[(i, j)]) * x[j]);
    terms.fold(Certified::exact(F::ZERO), |sum, term| sum + term)
}

fn sum<F: Magnitude>(bounds: impl Iterator<Item = Bound<F>>) -> Bound<F> {
    bounds.fold(Bound::NONE, |sum, bound| sum + bound)
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix2, SMatrix, SVector};

    use super::Verification;
    use crate::certified::Certified;
    use crate::factorisation::Factors;
    use crate::random::SplitMix64;
    use crate::{Conditioning, DoubleDouble, Scalar};

    const N: usize = 5;
    type Matrix<T> = SMatrix<T, N, N>;
    type Vector<T> = SVector<T, N>;

    fn digits<const R: usize, const C: usize>(
        x: &SMatrix<f64, R, C>,
    ) -> SMatrix<DoubleDouble, R, C> {
        x.map(DoubleDouble::from)
    }

    /// A positive definite matrix whose least pivot is about `pivot`, in units of a joint each.
    fn definite(random: &mut SplitMix64, pivot: f64) -> Matrix<f64> {
        let lower = Matrix::from_fn(|i, j| match i.cmp(&j) {
            core::cmp::Ordering::Less => random.within(&(-1.0..=1.0)),
            core::cmp::Ordering::Equal => 1.0,
            core::cmp::Ordering::Greater => 0.0,
        });
        let units = Vector::from_fn(|_, _| libm::exp10(random.within(&(-6.0..=6.0))));
        let mut pivots = Vector::repeat(1.0);
        pivots[1] = pivot;
        let m = lower * Matrix::from_diagonal(&pivots) * lower.transpose();
        let m = (m + m.transpose()) * 0.5;
        Matrix::from_fn(|i, j| m[(i, j)] * units[i] * units[j])
    }

    /// |M'^-1 b' - x| for a matrix and a right side within the errors, beside its bound; the largest quotient.
    fn largest_ratio(pivot: f64, relative_error: f64) -> f64 {
        let mut random = SplitMix64(11);
        let mut largest = 0.0_f64;
        for _ in 0..200 {
            let values = definite(&mut random, pivot);
            let errors = values.map(|x| x.abs() * relative_error);
            let m = values.zip_map(&errors, Certified::with_error);
            let verification = Verification::of(&m).expect("regular");
            let solution =
                Vector::from_fn(|i, _| random.within(&(-1.0..=1.0)) / values[(i, i)].sqrt());
            let b = values * solution;
            let size = b.amax();
            let forces = b.map(|b| Certified::with_error(b, relative_error * size));
            let x = verification.approximate(&forces);
            let bounds = verification.error(&(forces - m * x.map(Certified::exact)));
            let moved = Matrix::from_fn(|i, j| errors[(i, j)] * random.within(&(-1.0..=1.0)));
            let moved = Matrix::from_fn(|i, j| moved[(i.min(j), i.max(j))]);
            let exact = digits(&values) + digits(&moved);
            let forces = b.map(|b| {
                DoubleDouble::from(b)
                    + DoubleDouble::from(relative_error * size * random.within(&(-1.0..=1.0)))
            });
            let exact = Factors::new(exact).expect("regular").solve(&forces);
            for i in 0..N {
                let error = (DoubleDouble::from(x[i]) - exact[i]).abs().high();
                assert!(error <= bounds[i].get(), "{error:e} {:?}", bounds[i]);
                largest = largest.max(error / bounds[i].get());
            }
        }
        largest
    }

    #[test]
    fn no_solution_within_the_errors_is_beyond_its_bound() {
        for pivot in [1.0, 1e-3, 1e-9] {
            for relative_error in [0.0, 1e-15, 1e-13] {
                let ratio = largest_ratio(pivot, relative_error);
                println!("pivot {pivot:e}, errors {relative_error:e}: {ratio:.3}");
                assert!(ratio > 0.05, "{ratio}");
            }
        }
    }

    /// Errors of M that reach a singular matrix leave nothing to be said, and half of them something.
    #[test]
    fn what_may_be_singular_has_no_bound() {
        let m = Matrix2::new(1.0 + 1e-8, 1.0, 1.0, 1.0);
        assert_eq!(Conditioning::of(&m).joint, 0);
        let known = |error| Verification::of(&m.map(|x| Certified::with_error(x, error))).is_some();
        assert!(known(1e-9) && !known(1e-8));
        let unknown = m.map(|x| Certified::with_error(x, f64::INFINITY));
        assert!(Verification::of(&unknown).is_none());
        assert!(Verification::of(&unknown.map(|_| Certified::exact(f64::NAN))).is_none());
        assert!(Verification::of(&unknown.map(|_| Certified::<f64>::from_f64(0.0))).is_none());
    }
}
