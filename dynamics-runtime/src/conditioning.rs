//! How near to singular a mass matrix is.

use core::ops::IndexMut;

use nalgebra::SMatrix;

use crate::factorisation::eliminate;
use crate::singular::relative_pivot;

/// How near to singular a mass matrix is: the least pivot relative to its diagonal entry.
///
/// In M = U D U^T, factored from the tip inwards, the pivot d_i is the inertia that joint i feels while the joints
/// beyond it are free; M_ii is that with these locked. A solution of M x = b loses about `-log10(min d_i / M_ii)` digits.
/// Unlike the condition number, this ratio does not change with the units of the joints, nor with small masses at the
/// end of a large arm. Scaling a positive definite matrix by its diagonal is nearly the best scaling (van der Sluis
/// 1969).
///
/// ```
/// use robot_dynamics::Conditioning;
/// use robot_dynamics::nalgebra::Matrix2;
///
/// // Joints that differ by twelve orders of magnitude, and do not know of each other.
/// let graded = Conditioning::of(&Matrix2::new(1.0, 0.0, 0.0, 1e-12));
/// assert_eq!(graded.lost_digits(), 0.0);
///
/// // The first joint's inertia is nearly all carried by the second.
/// let stretched = Conditioning::of(&Matrix2::new(1.0 + 1e-8, 1.0, 1.0, 1.0));
/// assert_eq!(stretched.joint, 0);
/// assert!((stretched.lost_digits() - 8.0).abs() < 1e-6);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Conditioning {
    /// The joint of the least relative pivot, counted from 0.
    pub joint: usize,
    /// The pivot over its diagonal entry: 1 at best; 0 or negative where M is not positive definite,
    /// NaN where M holds a NaN.
    pub relative_pivot: f64,
}

impl Conditioning {
    /// Factors M(q), and stops at the first pivot that is not positive. Never fails, never allocates.
    pub fn of<const N: usize>(mass_matrix: &SMatrix<f64, N, N>) -> Self {
        Conditioning::of_joints(N, mass_matrix)
    }

    /// The same of M(q) of an arm of any size.
    #[doc(hidden)]
    pub fn of_joints<M>(joints: usize, mass_matrix: &M) -> Self
    where
        M: Clone + IndexMut<(usize, usize), Output = f64>,
    {
        let mut m = mass_matrix.clone();
        let mut least = Conditioning {
            joint: joints.saturating_sub(1),
            relative_pivot: 1.0,
        };
        for k in (0..joints).rev() {
            let pivot = m[(k, k)];
            let ratio = relative_pivot(pivot, mass_matrix[(k, k)]);
            if ratio.is_nan() || ratio < least.relative_pivot {
                (least.joint, least.relative_pivot) = (k, ratio);
            }
            if pivot.is_nan() || pivot <= 0.0 {
                break;
            }
            eliminate(&mut m, k, 1.0 / pivot);
        }
        least
    }

    /// Decimal digits that accelerations lose by solving with this matrix: infinite where it is not
    /// positive definite, NaN where it holds a NaN.
    pub fn lost_digits(&self) -> f64 {
        match self.relative_pivot {
            pivot if pivot <= 0.0 => f64::INFINITY,
            pivot => 0.0 - libm::log10(pivot),
        }
    }

    /// Relative error of the accelerations to expect in double precision: epsilon over the relative
    /// pivot, infinite where M is not positive definite.
    pub fn error(&self) -> f64 {
        match self.relative_pivot {
            pivot if pivot <= 0.0 => f64::INFINITY,
            pivot => f64::EPSILON / pivot,
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix2, Matrix3};

    use super::Conditioning;

    #[test]
    fn pivots_are_those_of_the_tip_inwards() {
        let m = Matrix3::new(4.0, 1.0, 2.0, 1.0, 1.0, 0.5, 2.0, 0.5, 1.0);
        // d_3 = 1, d_2 = 1 - 1/4, M_12 becomes 1 - 2/2 = 0, d_1 = 4 - 4 = 0.
        let found = Conditioning::of(&m);
        assert_eq!((found.joint, found.relative_pivot), (0, 0.0));
        assert_eq!(found.lost_digits(), f64::INFINITY);
        assert_eq!(found.error(), f64::INFINITY);
        let m = Matrix2::new(1.0, 0.5, 0.5, 1.0);
        let found = Conditioning::of(&m);
        assert_eq!((found.joint, found.relative_pivot), (0, 0.75));
    }

    #[test]
    fn what_is_not_a_number_is_not_regular() {
        let nan = Conditioning::of(&Matrix2::new(1.0, 0.0, 0.0, f64::NAN));
        assert_eq!(nan.joint, 1);
        assert!(nan.relative_pivot.is_nan() && nan.lost_digits().is_nan() && nan.error().is_nan());
        let negative = Conditioning::of(&Matrix2::new(1.0, 0.0, 0.0, -2.0));
        assert_eq!((negative.joint, negative.relative_pivot), (1, -1.0));
        let massless = Conditioning::of(&Matrix2::zeros());
        assert_eq!((massless.joint, massless.relative_pivot), (1, 0.0));
    }
}
