//! Second derivatives of joints from those of rows.

use nalgebra::SMatrix;

use crate::SecondDerivatives;

/// Second derivatives that are added up.
pub(super) struct Sum<const N: usize>(pub(super) SecondDerivatives<f64, N>);

impl<const N: usize> Default for Sum<N> {
    fn default() -> Self {
        let none = [SMatrix::zeros(); N];
        Sum((none, none, none, none))
    }
}

impl<const N: usize> Sum<N> {
    /// Adds what a row does that moves by so much of joint k.
    pub(super) fn add(&mut self, k: usize, factor: f64, slopes: [SMatrix<f64, N, N>; 4]) {
        let [by_position, by_velocity, by_both, of_inertia] = slopes.map(|slopes| slopes * factor);
        for i in 0..N {
            for j in 0..N {
                self.0.0[i][(j, k)] += by_position[(i, j)];
                self.0.1[i][(j, k)] += by_velocity[(i, j)];
                self.0.2[i][(k, j)] += by_both[(i, j)];
                self.0.3[i][(j, k)] += of_inertia[(i, j)];
            }
        }
    }
}
