//! Coefficients of the Radau IIA method of order 5.
//!
//! E. Hairer, G. Wanner, *Solving Ordinary Differential Equations II*, 2nd edition, section IV.5
//! (the method) and IV.8 (its implementation), and their program RADAU5, whose digits T and its
//! inverse have here.

use nalgebra::Complex;

const SQRT_6: f64 = 2.449489742783178;

/// Times of the stages; the last stage is the result.
pub(super) const C: [f64; 3] = [(4.0 - SQRT_6) / 10.0, (4.0 + SQRT_6) / 10.0, 1.0];

/// The real eigenvalue of the inverse of the matrix of coefficients.
pub(super) const REAL: f64 = 3.637834252744496;

/// One of its two complex eigenvalues.
pub(super) const COMPLEX: Complex<f64> = Complex::new(2.6810828736277523, 3.0504301992474105);

/// T: the columns are an eigenvector, and the real and imaginary parts of one.
pub(super) const T: [[f64; 3]; 3] = [
    [
        0.09123239487089295,
        -0.1412552950209542,
        -0.030029194105147424,
    ],
    [0.241717932707107, 0.20412935229379994, 0.3829421127572619],
    [0.966048182615093, 1.0, 0.0],
];

/// The inverse of T.
pub(super) const T_INVERSE: [[f64; 3]; 3] = [
    [4.325579890063155, 0.33919925181580984, 0.5417705399358749],
    [
        -4.178718591551905,
        -0.32768282076106237,
        0.47662355450055044,
    ],
    [-0.5028726349457868, 2.571926949855605, -0.5960392048282249],
];

/// Weights of the stages' changes, over h, in the error estimate.
pub(super) const ERROR: [f64; 3] = [
    -(13.0 + 7.0 * SQRT_6) / 3.0,
    (-13.0 + 7.0 * SQRT_6) / 3.0,
    -1.0 / 3.0,
];

#[cfg(test)]
mod tests {
    use nalgebra::{Complex, Matrix3};

    use super::{C, COMPLEX, REAL, SQRT_6, T, T_INVERSE};
    use crate::integrate::order_conditions::order;

    /// The coefficients of Hairer and Wanner II, table IV.5.6.
    fn coefficients() -> Matrix3<f64> {
        let s = SQRT_6;
        Matrix3::new(
            (88.0 - 7.0 * s) / 360.0,
            (296.0 - 169.0 * s) / 1800.0,
            (-2.0 + 3.0 * s) / 225.0,
            (296.0 + 169.0 * s) / 1800.0,
            (88.0 + 7.0 * s) / 360.0,
            (-2.0 - 3.0 * s) / 225.0,
            (16.0 - s) / 36.0,
            (16.0 + s) / 36.0,
            1.0 / 9.0,
        )
    }

    #[test]
    fn the_method_is_of_order_five() {
        let a = coefficients();
        let rows: Vec<Vec<f64>> = (0..3).map(|i| a.row(i).iter().copied().collect()).collect();
        for (row, c) in rows.iter().zip(C) {
            assert!((row.iter().sum::<f64>() - c).abs() < 1e-15);
        }
        assert_eq!(order(&rows, &rows[2]), 5);
    }

    /// A^-1 T = T D with the eigenvalues in D.
    #[test]
    fn the_transformation_diagonalises() {
        let t = Matrix3::from_fn(|i, j| T[i][j]);
        let inverse = Matrix3::from_fn(|i, j| T_INVERSE[i][j]);
        assert!((t * inverse - Matrix3::identity()).amax() < 1e-14);
        let Complex { re, im } = COMPLEX;
        let d = Matrix3::new(REAL, 0.0, 0.0, 0.0, re, -im, 0.0, im, re);
        let diagonal = inverse * coefficients().try_inverse().unwrap();
        assert!((diagonal - d * inverse).amax() < 1e-13);
    }
}
