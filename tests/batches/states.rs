//! Random states.

use robot_dynamics::Scalar;
use robot_dynamics::nalgebra::{SVector, Vector6};

/// All arguments, one vector for each state.
pub(crate) struct States<T, const N: usize> {
    pub(crate) q: Vec<SVector<T, N>>,
    pub(crate) qd: Vec<SVector<T, N>>,
    pub(crate) qdd: Vec<SVector<T, N>>,
    pub(crate) tau: Vec<SVector<T, N>>,
    pub(crate) qd_r: Vec<SVector<T, N>>,
    pub(crate) qdd_r: Vec<SVector<T, N>>,
    pub(crate) jerk: Vec<SVector<T, N>>,
    pub(crate) snap: Vec<SVector<T, N>>,
    pub(crate) wrench: Vec<Vector6<T>>,
}

impl<T: Scalar, const N: usize> States<T, N> {
    /// Numbers within 2, from a linear congruential generator (Knuth's MMIX).
    pub(crate) fn random(count: usize, seed: u64) -> Self {
        let mut state = seed;
        let mut number = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            T::from_f64((state >> 11) as f64 / (1_u64 << 51) as f64 - 2.0)
        };
        let mut vectors = || -> Vec<SVector<T, N>> {
            (0..count)
                .map(|_| SVector::from_fn(|_, _| number()))
                .collect()
        };
        let [q, qd, qdd, tau] = [(); 4].map(|()| vectors());
        let [qd_r, qdd_r, jerk, snap] = [(); 4].map(|()| vectors());
        let wrench = (0..count)
            .map(|_| Vector6::from_fn(|_, _| number()))
            .collect();
        States {
            q,
            qd,
            qdd,
            tau,
            qd_r,
            qdd_r,
            jerk,
            snap,
            wrench,
        }
    }
}
