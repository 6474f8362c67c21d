//! The arguments of the functions that `each_function` names.

use robot_dynamics::nalgebra::{SVector, Vector6};

/// A field for each argument of a generated function, by the argument's name.
#[derive(Clone, Copy, Debug)]
pub struct Arguments<'a, T, const N: usize> {
    /// Joint positions.
    pub q: &'a SVector<T, N>,
    /// Joint velocities.
    pub qd: &'a SVector<T, N>,
    /// Joint accelerations.
    pub qdd: &'a SVector<T, N>,
    /// Joint forces and torques.
    pub tau: &'a SVector<T, N>,
    /// Velocities of a reference motion.
    pub qd_r: &'a SVector<T, N>,
    /// Accelerations of a reference motion.
    pub qdd_r: &'a SVector<T, N>,
    /// Rates of the accelerations.
    pub jerk: &'a SVector<T, N>,
    /// Rates of the jerk.
    pub snap: &'a SVector<T, N>,
    /// Force and moment at the tip.
    pub wrench: &'a Vector6<T>,
    /// The highest order of a series.
    pub order: usize,
}
