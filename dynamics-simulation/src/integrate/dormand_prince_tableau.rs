//! Coefficients of the Dormand-Prince method of order 5(4).
//!
//! J. R. Dormand, P. J. Prince, *A family of embedded Runge-Kutta formulae*, J. Comp. Appl. Math. 6
//! (1980), 19-26: the method RK5(4)7M. Dense output: E. Hairer, S. P. Nørsett, G. Wanner, *Solving
//! Ordinary Differential Equations I*, 2nd edition, section II.6, and their program DOPRI5.

/// Number of stages. The last is the first of the next step.
pub(super) const STAGES: usize = 7;

/// Times of the stages.
pub(super) const C: [f64; STAGES] = [0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0, 1.0];

/// Weights of the stages before in each stage. The last row is the result of order 5.
#[rustfmt::skip]
pub(super) const A: [[f64; STAGES - 1]; STAGES] = [
    [0.0; 6],
    [1.0 / 5.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0],
    [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0],
    [19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0, 0.0, 0.0],
    [9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0, 0.0],
    [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];

/// Result of order 5 minus the embedded result of order 4.
pub(super) const ERROR: [f64; STAGES] = [
    71.0 / 57600.0,
    0.0,
    -71.0 / 16695.0,
    71.0 / 1920.0,
    -17253.0 / 339200.0,
    22.0 / 525.0,
    -1.0 / 40.0,
];

/// The part of the dense output that lifts it from order 3 to order 4.
pub(super) const DENSE: [f64; STAGES] = [
    -12715105075.0 / 11282082432.0,
    0.0,
    87487479700.0 / 32700410799.0,
    -10690763975.0 / 1880347072.0,
    701980252875.0 / 199316789632.0,
    -1453857185.0 / 822651844.0,
    69997945.0 / 29380423.0,
];

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::{A, C, ERROR, STAGES};
    use crate::integrate::order_conditions::{order, square};

    /// sum_j a_ij = c_i.
    #[test]
    fn stages_are_consistent() {
        for (row, time) in A.iter().zip(C) {
            assert_abs_diff_eq!(row.iter().sum::<f64>(), time, epsilon = 1e-14);
        }
    }

    #[test]
    fn results_are_of_order_five_and_four() {
        let a = square(&A, STAGES);
        let mut fifth = a[STAGES - 1].clone();
        assert_eq!(order(&a, &fifth), 5);
        for (weight, error) in fifth.iter_mut().zip(ERROR) {
            *weight -= error;
        }
        assert_eq!(order(&a, &fifth), 4);
    }
}
