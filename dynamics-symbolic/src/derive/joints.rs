//! The joints that move among those of the table.
//!
//! The equations of an arm with locked joints are those of the whole arm where these joints have a
//! constant position and no velocity or acceleration, without their own rows and columns.

use crate::function::Function;
use crate::robot::Robot;

/// Which rows of the table have a joint that moves.
pub(super) struct Joints {
    moving: Vec<usize>,
    rows: usize,
}

impl Joints {
    /// Those of a robot.
    pub(super) fn of(robot: &Robot) -> Self {
        Joints {
            moving: robot.moving(),
            rows: robot.rows.len(),
        }
    }

    /// The entries of a vector.
    pub(super) fn entries<T: Copy>(&self, of_rows: Vec<T>) -> Vec<T> {
        self.moving.iter().map(|&i| of_rows[i]).collect()
    }

    /// The rows and columns of a square matrix.
    pub(super) fn block<T: Copy>(&self, of_rows: Vec<Vec<T>>) -> Vec<Vec<T>> {
        let row = |&i: &usize| self.moving.iter().map(|&j| of_rows[i][j]).collect();
        self.moving.iter().map(row).collect()
    }

    /// The vector with `zero` where a joint is locked.
    pub(super) fn rows<T: Copy>(&self, of_joints: &[T], zero: T) -> Vec<T> {
        let mut of_rows = vec![zero; self.rows];
        for (&i, &x) in self.moving.iter().zip(of_joints) {
            of_rows[i] = x;
        }
        of_rows
    }

    /// Of the outputs of a function for the joint of every row, matrices by rows, those of its
    /// contract. What was solved for has no others.
    pub(super) fn outputs<T: Copy>(&self, function: Function, of_rows: Vec<T>) -> Vec<T> {
        if self.moving.len() == self.rows {
            return of_rows;
        }
        let (all, joints) = ((0..self.rows).collect::<Vec<_>>(), &self.moving);
        let pairs = |among: &[usize]| {
            let inner = |(j, &a)| among[j + 1..].iter().map(move |&b| self.pair(a, b));
            among.iter().enumerate().flat_map(inner).collect::<Vec<_>>()
        };
        let columns = |count: usize| (0..count).collect::<Vec<_>>();
        match function {
            Function::CoriolisVector
            | Function::GravityVector
            | Function::FrictionVector
            | Function::InverseDynamics
            | Function::BiasForce
            | Function::TaylorSeries => pick(&of_rows, 1, joints, &[0]),
            Function::MassMatrix | Function::CoriolisMatrix | Function::CentrifugalCoefficients => {
                pick(&of_rows, self.rows, joints, joints)
            }
            Function::CoriolisCoefficients => {
                pick(&of_rows, pairs(&all).len(), joints, &pairs(joints))
            }
            Function::InverseDynamicsDerivatives => of_rows
                .chunks(self.rows * self.rows)
                .flat_map(|matrix| pick(matrix, self.rows, joints, joints))
                .collect(),
            Function::LinkPoses => pick(&of_rows, 16, joints, &columns(16)),
            Function::Jacobian => pick(&of_rows, self.rows, &columns(6), joints),
            Function::Regressor => {
                let parameters = of_rows.len() / self.rows;
                pick(&of_rows, parameters, joints, &columns(parameters))
            }
            Function::KineticEnergy
            | Function::PotentialEnergy
            | Function::ForwardKinematics
            | Function::BaseParameters
            | Function::ForwardDynamics
            | Function::ForwardDynamicsAba
            | Function::ForwardDynamicsDerivatives => of_rows,
        }
    }

    /// The place of a pair of rows in the order (1,2), (1,3), ..., (n-1,n).
    fn pair(&self, a: usize, b: usize) -> usize {
        let before = |a: usize| (0..a).map(|i| self.rows - 1 - i).sum::<usize>();
        before(a) + b - a - 1
    }
}

/// Rows and columns of a matrix that is given by rows of that width.
fn pick<T: Copy>(matrix: &[T], width: usize, rows: &[usize], columns: &[usize]) -> Vec<T> {
    let row = |&i: &usize| columns.iter().map(move |&j| matrix[i * width + j]);
    rows.iter().flat_map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_of_joints_keep_their_order() {
        let joints = Joints {
            moving: vec![0, 2, 3],
            rows: 4,
        };
        // (1,2) (1,3) (1,4) (2,3) (2,4) (3,4), three rows that matter.
        let of_rows: Vec<usize> = (0..24).collect();
        let picked = joints.outputs(Function::CoriolisCoefficients, of_rows);
        assert_eq!(picked, [1, 2, 5, 13, 14, 17, 19, 20, 23]);
    }
}
