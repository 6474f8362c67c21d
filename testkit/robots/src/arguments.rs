//! The arguments of the functions that `each_function` names.

use robot_dynamics::nalgebra::SVector;

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
    /// The highest order of a series.
    pub order: usize,
}
