//! The joints that move among those of the table.
//!
//! The equations of an arm with locked joints are those of the whole arm where these joints have a
//! constant position and no velocity or acceleration, without their own rows and columns.

use crate::function::{Shape, Size, Sizes};
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

    /// Of values for the joint of every row, in that arrangement, those of the joints that move.
    pub(super) fn outputs<T: Copy>(&self, shape: &Shape, of_rows: Vec<T>) -> Vec<T> {
        if self.moving.len() == self.rows {
            return of_rows;
        }
        self.picked(shape, self.sizes(shape, of_rows.len()), &of_rows)
    }

    /// The sizes for the joint of every row.
    fn sizes(&self, shape: &Shape, entries: usize) -> Sizes {
        Sizes {
            joints: self.rows,
            parameters: shape.parameters(self.rows, entries),
        }
    }

    fn picked<T: Copy>(&self, shape: &Shape, sizes: Sizes, of_rows: &[T]) -> Vec<T> {
        match shape {
            Shape::Number => of_rows.to_vec(),
            Shape::Matrix(rows, columns) => {
                let places = |size| self.places(size, sizes);
                pick(
                    of_rows,
                    columns.of(sizes),
                    &places(*rows),
                    &places(*columns),
                )
            }
            Shape::Each(one) => {
                let entries = one.entries(sizes);
                let of_joint = |&i: &usize| &of_rows[i * entries..(i + 1) * entries];
                let moving = self.moving.iter().map(of_joint);
                moving
                    .flat_map(|part| self.picked(one, sizes, part))
                    .collect()
            }
            Shape::Tuple(parts) => {
                let mut rest = of_rows;
                let mut picked = Vec::new();
                for part in *parts {
                    let (values, others) = rest.split_at(part.entries(sizes));
                    picked.extend(self.picked(part, sizes, values));
                    rest = others;
                }
                picked
            }
            Shape::Series => self.entries(of_rows.to_vec()),
        }
    }

    /// Which of so many rows or columns belong to joints that move, or to none.
    fn places(&self, size: Size, sizes: Sizes) -> Vec<usize> {
        match size {
            Size::One | Size::Fixed(_) | Size::Parameters => (0..size.of(sizes)).collect(),
            Size::Joints => self.moving.clone(),
            Size::Pairs => {
                let among = self.moving.iter().enumerate();
                let inner = |(j, &a): (usize, &usize)| {
                    let outer = self.moving[j + 1..].iter();
                    outer.map(|&b| self.pair(a, b)).collect::<Vec<_>>()
                };
                among.flat_map(inner).collect()
            }
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
        let picked = joints.outputs(&Shape::Matrix(Size::Joints, Size::Pairs), of_rows);
        assert_eq!(picked, [1, 2, 5, 13, 14, 17, 19, 20, 23]);
    }

    /// A vector for each joint beside a matrix with a column for each: two of three joints move.
    #[test]
    fn what_does_not_belong_to_joints_stays() {
        let joints = Joints {
            moving: vec![0, 2],
            rows: 3,
        };
        const EACH: Shape = Shape::Each(&Shape::Matrix(Size::Fixed(2), Size::One));
        const SHAPE: Shape = Shape::Tuple(&[
            EACH,
            Shape::Number,
            Shape::Matrix(Size::Fixed(2), Size::Joints),
            Shape::Matrix(Size::Joints, Size::Parameters),
        ]);
        let of_rows: Vec<usize> = (0..19).collect();
        let picked = joints.outputs(&SHAPE, of_rows);
        assert_eq!(picked, [0, 1, 4, 5, 6, 7, 9, 10, 12, 13, 14, 17, 18]);
    }
}
