//! The numbers that a series is.

use nalgebra::SVector;

/// The highest order of a Taylor series.
pub const MAX_TAYLOR_ORDER: usize = 30;

/// The coefficients q_k of `q(t) = sum q_k t^k`, from q_0 on; zero beyond the order requested.
pub type TaylorCoefficients<T, const N: usize> = [SVector<T, N>; MAX_TAYLOR_ORDER + 1];
