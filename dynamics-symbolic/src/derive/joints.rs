//! The joints that move by themselves among those of the table.
//!
//! The equations of an arm with locked joints are those of the whole arm where these joints have a
//! constant position and no velocity or acceleration, without their own rows and columns.
//!
//! The equations of an arm in which joints follow others are the whole arm's too: its positions are
//! q = S q_j + c, q_j those of the joints that move by themselves, and S and c constant. So qd = S qd_j
//! and qdd = S qdd_j, and by the chain rule, or by virtual work,
//!
//!   tau_j = S' tau,   M_j = S' M S,   V_j = S' V,   G_j = S' G,   J_j = J S,
//!
//! and so for everything else that has an index of joints: forces, columns of Jacobians, Christoffel
//! symbols, derivatives. A row of S has a 1 for a joint that moves by itself, the factor for a follower,
//! and nothing for a joint that is locked.
//!
//! A locked joint stays a link of the chain, with a constant turn or slide. Constants are folded, so that the
//! equations are as short as if the links had been joined: a merged transform of two rows is no row, and one rotation
//! of nine products stands where two turns take eight. All parameters of a locked link are grouped into the link
//! before. Here its rows and columns are left out.

use super::symbols::Symbols;
use crate::expr::Expr;
use crate::function::{Shape, Size, Sizes};
use crate::linear::Ring;

/// The joints that move by themselves, and those that follow these: S.
pub(super) struct Joints<R> {
    free: Vec<usize>,
    /// Each follower, the number of the free joint that leads it, and the factor.
    followers: Vec<(usize, usize, R)>,
    /// How many joints there are.
    count: usize,
    /// How many of them, the first ones, are of a base that moves.
    of_base: usize,
}

impl<'g> Joints<Expr<'g>> {
    /// The joints of an arm.
    pub(super) fn of(symbols: &Symbols<'g>) -> Self {
        let arm = symbols.arm();
        let follower = |i: usize| Some((i, arm.moved_by(i)?.0, symbols.joint(i).factor));
        Joints {
            free: arm.free().collect(),
            followers: arm.following().filter_map(follower).collect(),
            count: arm.joints.len(),
            of_base: arm.freedoms().base,
        }
    }
}

impl<R: Ring> Joints<R> {
    /// S' times a list of anything; `add(x, k, y)` adds k y to x.
    fn gathered<T: Clone>(&self, of_all: &[T], add: impl Fn(&mut T, R, &T)) -> Vec<T> {
        let mut gathered: Vec<T> = self.free.iter().map(|&i| of_all[i].clone()).collect();
        for &(i, joint, factor) in &self.followers {
            add(&mut gathered[joint], factor, &of_all[i]);
        }
        gathered
    }

    /// S' x
    pub(super) fn entries(&self, of_all: Vec<R>) -> Vec<R> {
        self.gathered(&of_all, |x, factor, &y| *x = *x + factor * y)
    }

    /// S' A S
    pub(super) fn block(&self, of_all: Vec<Vec<R>>) -> Vec<Vec<R>> {
        let columns = of_all.into_iter().map(|row| self.entries(row));
        self.rows_of_matrix(columns.collect())
    }

    /// S' A
    pub(super) fn rows_of_matrix(&self, of_all: Vec<Vec<R>>) -> Vec<Vec<R>> {
        self.gathered(&of_all, |row, factor, other| {
            add_multiple(row, factor, other);
        })
    }

    /// S' A S for a diagonal matrix, which is diagonal too, for each follower follows one joint.
    pub(super) fn diagonal(&self, of_all: &[R]) -> Vec<R> {
        self.gathered(of_all, |x, factor, &y| *x = *x + factor * factor * y)
    }

    /// The symbols c_ijk of the joints from those of all rows.
    pub(super) fn cube(&self, of_all: Vec<Vec<Vec<R>>>) -> Vec<Vec<Vec<R>>> {
        let blocks: Vec<_> = of_all.into_iter().map(|c| self.block(c)).collect();
        self.gathered(&blocks, |block, factor, other| {
            let rows = block.iter_mut().zip(other);
            rows.for_each(|(row, other)| add_multiple(row, factor, other));
        })
    }

    /// The values of the joints that move by themselves, from values for the joint of every row in that arrangement.
    /// An array has the values of each joint's own link, and none of the base.
    pub(super) fn outputs(&self, shape: &Shape, of_all: Vec<R>) -> Vec<R> {
        if self.free.len() == self.count && self.of_base == 0 {
            return of_all;
        }
        let sizes = Sizes {
            freedoms: self.count.into(),
            parameters: shape.parameters(self.count, of_all.len()),
        };
        self.of_shape(shape, sizes, &of_all)
    }

    fn of_shape(&self, shape: &Shape, sizes: Sizes, of_all: &[R]) -> Vec<R> {
        match shape {
            Shape::Number => of_all.to_vec(),
            Shape::Matrix(rows, columns) => self.of_matrix(*rows, *columns, sizes, of_all),
            Shape::Each(count, one) => {
                let first = if *count == Size::Joints {
                    self.of_base
                } else {
                    0
                };
                let entries = one.entries(sizes);
                let of_joint = |&i: &usize| &of_all[i * entries..(i + 1) * entries];
                let moving = self.free[first..].iter().map(of_joint);
                moving
                    .flat_map(|part| self.of_shape(one, sizes, part))
                    .collect()
            }
            Shape::Tuple(parts) => {
                let mut rest = of_all;
                let mut picked = Vec::new();
                for (_, part) in *parts {
                    let (values, others) = rest.split_at(part.entries(sizes));
                    picked.extend(self.of_shape(part, sizes, values));
                    rest = others;
                }
                picked
            }
            Shape::Series => self.entries(of_all.to_vec()),
        }
    }

    fn of_matrix(&self, rows: Size, columns: Size, sizes: Sizes, of_all: &[R]) -> Vec<R> {
        let width = columns.of(sizes);
        if width == 0 {
            return Vec::new();
        }
        let mut matrix: Vec<Vec<R>> = of_all.chunks(width).map(<[R]>::to_vec).collect();
        if columns == Size::Freedoms {
            matrix = matrix.into_iter().map(|row| self.entries(row)).collect();
        }
        if rows == Size::Freedoms {
            matrix = self.rows_of_matrix(matrix);
        }
        matrix.concat()
    }
}

/// Adds a multiple of a row to another one.
fn add_multiple<R: Ring>(row: &mut [R], factor: R, other: &[R]) {
    let entries = row.iter_mut().zip(other);
    entries.for_each(|(x, &y)| *x = *x + factor * y);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn joints(moving: &[usize], followers: &[(usize, usize, i64)], count: usize) -> Joints<i64> {
        Joints {
            free: moving.to_vec(),
            followers: followers.to_vec(),
            count,
            of_base: 0,
        }
    }

    /// A vector for each joint beside a matrix with a column for each: two of three joints move.
    #[test]
    fn what_does_not_belong_to_joints_stays() {
        let joints = joints(&[0, 2], &[], 3);
        const EACH: Shape = Shape::Each(Size::Joints, &Shape::Matrix(Size::Fixed(2), Size::One));
        const SHAPE: Shape = Shape::Tuple(&[
            ("each", EACH),
            ("number", Shape::Number),
            ("columns", Shape::Matrix(Size::Fixed(2), Size::Freedoms)),
            ("rows", Shape::Matrix(Size::Freedoms, Size::Parameters)),
        ]);
        let picked = joints.outputs(&SHAPE, (0..19).collect());
        assert_eq!(picked, [0, 1, 4, 5, 6, 7, 9, 10, 12, 13, 14, 17, 18]);
    }

    /// Joint 1 is followed by row 2 with the factor -2; row 3 is locked.
    #[test]
    fn followers_count_through_the_joint_that_leads() {
        let joints = joints(&[0, 1], &[(2, 1, -2)], 4);
        assert_eq!(joints.entries(vec![1, 10, 100, 1000]), [1, -190]);
        assert_eq!(joints.diagonal(&[1, 10, 100, 1000]), [1, 410]);
        let jacobian = Shape::Matrix(Size::Fixed(2), Size::Freedoms);
        let picked = joints.outputs(&jacobian, vec![1, 2, 3, 4, 5, 6, 7, 8]);
        assert_eq!(picked, [1, 2 - 6, 5, 6 - 14]);
        // S' A S with the entries of A in place.
        let matrix = |f: fn(usize, usize) -> i64| -> Vec<Vec<i64>> {
            (0..4).map(|i| (0..4).map(|j| f(i, j)).collect()).collect()
        };
        let block = joints.block(matrix(|i, j| (10 * i + j) as i64));
        assert_eq!(
            block,
            [[0, 1 - 4], [10 - 40, 11 - 2 * 12 - 2 * (21 - 2 * 22)]]
        );
        let cube = (0..4).map(|k| vec![vec![k; 4]; 4]).collect();
        assert_eq!(joints.cube(cube)[1], [[1 - 4, 3], [3, -3]]);
    }

    /// An array has the poses of the joints' own links.
    #[test]
    fn links_of_followers_have_no_entry_in_an_array() {
        let joints = joints(&[0, 2], &[(1, 0, 3)], 3);
        const POSES: Shape =
            Shape::Each(Size::Joints, &Shape::Matrix(Size::Fixed(1), Size::Fixed(1)));
        assert_eq!(joints.outputs(&POSES, vec![4, 5, 6]), [4, 6]);
        let on_moving_base = Joints {
            of_base: 1,
            ..joints
        };
        assert_eq!(on_moving_base.outputs(&POSES, vec![4, 5, 6]), [6]);
    }
}
