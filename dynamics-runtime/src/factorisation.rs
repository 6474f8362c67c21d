//! The factorisation of a mass matrix.

use core::ops::{Index, IndexMut};

use nalgebra::{SMatrix, SVector};

use crate::size::{JointMatrix, JointVector};
use crate::{Scalar, SingularMassMatrix};

/// M = U D U^T from the tip inwards, with ones on the diagonal of U (R. Featherstone, *Rigid Body
/// Dynamics Algorithms*, section 6.5, without the square roots): each pivot is the inertia that a
/// joint feels with the joints beyond it free, as those of the generated forward dynamics are.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Factors<T, const N: usize> {
    /// The entries of U above its diagonal; what is below is no part of it.
    upper: SMatrix<T, N, N>,
    inverse_pivots: SVector<T, N>,
}

impl<T: Scalar, const N: usize> Factors<T, N> {
    /// The factors of the unit matrix.
    #[inline]
    pub(crate) fn unit(like: T) -> Self {
        Factors {
            upper: SMatrix::repeat(like.constant(0.0)),
            inverse_pivots: SVector::repeat(like.constant(1.0)),
        }
    }

    #[inline(always)]
    pub(crate) fn new(mut m: SMatrix<T, N, N>) -> Result<Self, SingularMassMatrix> {
        let mut inverse_pivots = m.diagonal();
        factor(N, &mut m, &mut inverse_pivots)?;
        Ok(Factors {
            upper: m,
            inverse_pivots,
        })
    }

    /// x with M x = b.
    #[inline(always)]
    pub(crate) fn solve(&self, b: &SVector<T, N>) -> SVector<T, N> {
        let mut x = *b;
        substitute(N, &self.upper, &self.inverse_pivots, &mut x);
        x
    }
}

/// Turns M of so many rows into U; `diagonal`, which is that of M, becomes the inverse of the pivots.
#[inline(always)]
pub fn factor<T: Scalar>(
    size: usize,
    m: &mut impl IndexMut<(usize, usize), Output = T>,
    diagonal: &mut impl IndexMut<usize, Output = T>,
) -> Result<(), SingularMassMatrix> {
    for j in (0..size).rev() {
        let pivot = m[(j, j)];
        SingularMassMatrix::test(j, pivot, diagonal[j])?;
        diagonal[j] = pivot.constant(1.0) / pivot;
        eliminate(m, j, diagonal[j]);
    }
    Ok(())
}

/// Turns b into x with M x = b.
#[inline(always)]
pub fn substitute<T: Scalar>(
    size: usize,
    upper: &impl Index<(usize, usize), Output = T>,
    inverse_pivots: &impl Index<usize, Output = T>,
    x: &mut impl IndexMut<usize, Output = T>,
) {
    for j in (0..size).rev() {
        for i in 0..j {
            x[i] = (-upper[(i, j)]).mul_add(x[j], x[i]);
        }
    }
    for i in 0..size {
        x[i] = x[i] * inverse_pivots[i];
    }
    for j in 0..size {
        for i in j + 1..size {
            x[i] = (-upper[(j, i)]).mul_add(x[j], x[i]);
        }
    }
}

/// Eliminates joint `j` from the upper triangle of the matrix of the joints before it; its column becomes that of U.
#[inline(always)]
pub(crate) fn eliminate<T: Scalar>(
    m: &mut impl IndexMut<(usize, usize), Output = T>,
    j: usize,
    inverse_pivot: T,
) {
    for i in (0..j).rev() {
        let ratio = m[(i, j)] * inverse_pivot;
        for k in 0..=i {
            m[(k, i)] = m[(k, i)] - m[(k, j)] * ratio;
        }
        m[(i, j)] = ratio;
    }
}

/// The same for an arm of any size, in doubles.
pub struct JointFactors<M: JointMatrix> {
    upper: M,
    inverse_pivots: M::Vector,
}

impl<M: JointMatrix> JointFactors<M> {
    /// Factors M of so many joints.
    #[inline(always)]
    pub fn new(size: usize, mut m: M) -> Result<Self, SingularMassMatrix> {
        let mut inverse_pivots = M::Vector::from_entries(size, |i| m[(i, i)]);
        factor(size, &mut m, &mut inverse_pivots)?;
        Ok(JointFactors {
            upper: m,
            inverse_pivots,
        })
    }

    /// x with M x = b.
    #[inline(always)]
    pub fn solve(&self, b: &M::Vector) -> M::Vector {
        let (mut x, size) = (b.clone(), b.entries().len());
        substitute(size, &self.upper, &self.inverse_pivots, &mut x);
        x
    }
}

/// x with M x = b.
#[inline(always)]
pub fn solve<M: JointMatrix>(m: M, b: &M::Vector) -> Result<M::Vector, SingularMassMatrix> {
    Ok(JointFactors::new(b.entries().len(), m)?.solve(b))
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix3, Vector3};

    use super::Factors;

    #[test]
    fn solves_and_reports_the_joint_of_a_pivot() {
        let m = Matrix3::new(4.0, 1.0, 0.5, 1.0, 3.0, 0.2, 0.5, 0.2, 2.0);
        let x = Vector3::new(1.0, -2.0, 3.0);
        let solved = Factors::new(m).unwrap().solve(&(m * x));
        assert!((solved - x).amax() < 1e-15, "{solved}");
        // Rows and columns 0 and 1 are alike behind joint 2: the pivot of joint 0 vanishes.
        let singular = Matrix3::new(1.0, 1.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0);
        assert_eq!(Factors::new(singular).unwrap_err().joint, 0);
    }
}
