//! Paths that stay on a branch.

use core::fmt;

use nalgebra::SVector;

use super::{Real, Solution, Solutions};

/// The branch that a path was on ends: no solution is near enough.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BranchEnds {
    /// The number of the joint, from 0, that moves farthest to the nearest solution; `None` if there is no solution, or the
    /// position before is not finite.
    pub joint: Option<usize>,
    /// How far this joint moves, rad or m.
    pub way: f64,
    /// How far it may.
    pub most: f64,
}

impl fmt::Display for BranchEnds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.joint {
            None => write!(f, "the branch ends: there is no solution"),
            Some(joint) => write!(
                f,
                "the branch ends: to the nearest solution joint {} moves by {:.3}, more than {:.3}",
                joint + 1,
                self.way,
                self.most
            ),
        }
    }
}

impl core::error::Error for BranchEnds {}

impl<T: Real, const N: usize> Solutions<T, N> {
    /// The solution that continues a path: the [nearest](Solutions::nearest) to the position before it, if no joint moves by more
    /// than `most`, rad or m. Ways are measured with whole turns left out, and within the limits behind
    /// [`within`](Solutions::within). The angles of the solution stand as they are in the list, which may be a whole turn away.
    ///
    /// ```
    /// # extern crate dynamics_runtime as robot_dynamics;
    /// # use robot_dynamics::closed_form::{BranchEnds, Solutions};
    /// # let solutions = Solutions::<f64, 1>::default();
    /// let error: BranchEnds = solutions.follow(&[0.1].into(), 0.05).unwrap_err();
    /// assert_eq!(error.to_string(), "the branch ends: there is no solution");
    /// ```
    ///
    /// # Errors
    ///
    /// [`BranchEnds`] with the joint that moves farthest, if it moves by more than `most`, or if there is no solution.
    pub fn follow(&self, last: &SVector<T, N>, most: T) -> Result<&Solution<T, N>, BranchEnds> {
        let ends = |joint, way: T| BranchEnds {
            joint,
            way: way.into(),
            most: most.into(),
        };
        let none = T::from_f64(f64::INFINITY);
        let nearest = self.nearest_one(last).ok_or(ends(None, none))?;
        let way = |i: usize| {
            let way = self.way(i, nearest.q[i], last[i]);
            if way.is_positive() { way } else { -way }
        };
        let mut farthest = (0, way(0));
        for i in 1..N {
            if way(i) > farthest.1 {
                farthest = (i, way(i));
            }
        }
        match farthest.1 <= most {
            true => Ok(nearest),
            false => Err(ends(Some(farthest.0), farthest.1)),
        }
    }
}
