//! States by columns, a column for each joint.

use robot_dynamics::{Batch, Scalar, batch::Precision};

use crate::five::{Five, Numbers};

/// Arguments and values of a batch.
pub struct Columns<T, const N: usize> {
    arguments: [[Vec<T>; N]; 3],
    vector: [Vec<T>; N],
    matrix: [[Vec<T>; N]; N],
}

impl<T: Precision, const N: usize> Columns<T, N> {
    /// Columns of some states, with room for the values.
    pub fn new(states: &[Numbers<T, N>]) -> Self {
        let column =
            |argument: usize, joint: usize| states.iter().map(|s| s[argument][joint]).collect();
        Columns {
            arguments: std::array::from_fn(|argument| {
                std::array::from_fn(|joint| column(argument, joint))
            }),
            vector: zeros(states.len()),
            matrix: std::array::from_fn(|_| zeros(states.len())),
        }
    }

    /// Positions, velocities, and accelerations or torques.
    pub fn arguments(&self) -> &[[Vec<T>; N]; 3] {
        &self.arguments
    }

    /// Evaluates the function of that place in [`crate::five::NAMES`] at all states.
    ///
    /// # Panics
    ///
    /// If the mass matrix is singular.
    pub fn evaluate<A: Five<N>>(&mut self, function: usize, arm: &A) {
        let [q, qd, last] = &self.arguments;
        let vector = &mut self.vector;
        let written = match function {
            0 => arm.inverse_dynamics_batch(q, qd, last, vector),
            1 => arm.mass_matrix_batch(q, &mut self.matrix),
            2 => arm.coriolis_vector_batch(q, qd, vector),
            3 => arm.gravity_vector_batch(q, vector),
            _ => {
                let written = arm.forward_dynamics_batch(q, qd, last, vector);
                written.expect("M is positive definite");
                Ok(())
            }
        };
        written.expect("columns of one length");
    }

    /// The values of the function that was evaluated last, at every state.
    pub fn values(&self, function: usize) -> Vec<Vec<f64>> {
        let at = |state: usize| -> Vec<f64> {
            let value = |column: &Vec<T>| column[state].ratio_to_f64(T::from_f64(1.0));
            match function {
                1 => self.matrix.iter().flatten().map(value).collect(),
                _ => self.vector.iter().map(value).collect(),
            }
        };
        (0..self.vector[0].len()).map(at).collect()
    }
}

/// Columns of zeros.
pub fn zeros<T: Scalar, const N: usize>(states: usize) -> [Vec<T>; N] {
    std::array::from_fn(|_| vec![T::from_f64(0.0); states])
}
