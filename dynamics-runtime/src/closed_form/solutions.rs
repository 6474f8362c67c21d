//! All joint positions that lead to a pose.

use core::ops::Deref;

use nalgebra::SVector;

use super::angle::angles;
use super::roots::NO_TRY;
use super::{Found, Real, Roots};

/// The most solutions of an arm that has a closed form.
const MOST: usize = 8;

/// Angles are computed by so many, which no processor's vectors are longer than: none is left over to be computed alone.
const TOGETHER: usize = 8;

/// Joint positions that lead to a pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution<T: Real, const N: usize> {
    /// The positions, rad or m. Angles are above -pi and up to pi, unless [`within`](Solutions::within) or
    /// [`nearest`](Solutions::nearest) has added whole turns.
    pub q: SVector<T, N>,
    /// Whether the pose is singular: other positions of two joints do as well, or two solutions cannot be told apart within
    /// 1e-7 rad (1e-3 rad in single precision). `q` is then one of them: of an angle that is free the one nearest to zero with
    /// which the arm reaches the pose.
    pub is_singular: bool,
    /// The name of the branch, as "shoulder left, elbow up, wrist flipped": the same on all ways on which no joint jumps.
    pub branch: &'static str,
}

/// Why a pose has no solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoSolution {
    /// No positions of the joints lead to the pose.
    OutOfReach,
    /// The matrix is none: a number that is read is not finite, the last row is not 0, 0, 0, 1, or its rotation R misses one
    /// by more than 1e-3, as max |R'R - 1|, or mirrors.
    NotAPose,
}

/// The solutions of a generated `inverse_kinematics`, a slice in the order of the equations that they solve, at most eight. If
/// there is none, [`reason`](Solutions::reason) says why.
///
/// ```
/// use robot_dynamics::closed_form::Solutions;
/// # let solutions = Solutions::<f64, 1>::default();
/// for solution in &solutions {
///     println!("{} {}", solution.q, solution.is_singular);
/// }
/// assert!(solutions.nearest(&[0.1].into()).is_none());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solutions<T: Real, const N: usize> {
    all: [Solution<T, N>; MOST],
    count: usize,
    reason: Option<NoSolution>,
    turns: [bool; N],
    limits: [Option<[T; 2]>; N],
}

/// The solutions as they are found, angles by their sines and cosines.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Branches<T: Real, const N: usize> {
    sines: [[T; N]; MOST],
    cosines: [[T; N]; MOST],
    are_singular: [bool; MOST],
    /// The joints that stand at the second of two roots, one bit each.
    seconds: [u8; MOST],
    pub(super) count: usize,
    /// How far the best equation without a solution is from having one, at most 0.
    pub(super) miss: T,
    is_loose: bool,
}

impl<T: Real, const N: usize> Default for Branches<T, N> {
    #[inline]
    fn default() -> Self {
        let zeros = [[T::from_f64(0.0); N]; MOST];
        Branches {
            sines: zeros,
            cosines: zeros,
            are_singular: [false; MOST],
            seconds: [0; MOST],
            count: 0,
            miss: T::from_f64(NO_TRY),
            is_loose: false,
        }
    }
}

impl<T: Real, const N: usize> Branches<T, N> {
    /// Roots as they are; if there is none, it is noted whether other positions of joints before might have some.
    #[inline]
    pub fn asked(&mut self, roots: Roots<T>, before: &[&Found<T>]) -> Roots<T> {
        if roots.count == 0 {
            self.is_loose |= before.iter().any(|found| found.may_solve(roots.miss));
        }
        roots
    }

    /// Whether other positions of joints might have more solutions.
    #[inline]
    pub fn is_loose(&self) -> bool {
        self.is_loose
    }

    /// Roots as they are; if there is none, it is noted how far the equation is from having one.
    #[inline]
    pub fn noted(&mut self, roots: Roots<T>) -> Roots<T> {
        if roots.count == 0 && roots.miss > self.miss {
            self.miss = roots.miss;
        }
        roots
    }

    /// Adds one, unless a number in it is not finite.
    #[inline]
    pub fn push(&mut self, joints: [Found<T>; N], is_singular: bool) {
        let add = |sum: T, joint: &Found<T>| sum + joint.sine + joint.cosine;
        let sum = joints.iter().fold(T::from_f64(0.0), add);
        // A copy, which no write can change: the compiler knows that it is an index.
        let at = self.count;
        if at < MOST && sum.is_finite() {
            let (sines, cosines) = (&mut self.sines[at], &mut self.cosines[at]);
            self.are_singular[at] = is_singular;
            self.seconds[at] = 0;
            for (i, joint) in joints.iter().enumerate() {
                (sines[i], cosines[i]) = (joint.sine, joint.cosine);
                self.are_singular[at] |= joint.is_singular;
                self.seconds[at] |= u8::from(joint.is_second) << i;
            }
            self.count += 1;
        }
    }

    /// The number of a solution's branch: one bit for each of the joints that have two roots, the first joint's counts least.
    #[inline]
    pub fn branch(&self, solution: usize, joints: &[usize]) -> usize {
        let bit =
            |(k, joint): (usize, &usize)| usize::from(self.seconds[solution] >> joint & 1) << k;
        joints.iter().enumerate().map(bit).sum()
    }

    /// The solutions of an arm of whose joints these turn, for a matrix that is a pose or is none. The branches that joints with two
    /// roots make have names. Cosines become the positions.
    pub fn solutions(
        &mut self,
        turns: [bool; N],
        is_pose: bool,
        (joints, names): (&[usize], &[&'static str]),
    ) -> Solutions<T, N> {
        let some = (self.count.min(MOST) * N).next_multiple_of(TOGETHER);
        let some = some.min(MOST * N);
        let cosines = &mut self.cosines.as_flattened_mut()[..some];
        angles(&self.sines.as_flattened()[..some], cosines);
        for i in (0..N).filter(|&i| !turns[i]) {
            for branch in 0..MOST {
                self.cosines[branch][i] = self.sines[branch][i];
            }
        }
        let solution = |branch: usize| Solution {
            q: self.cosines[branch].into(),
            is_singular: self.are_singular[branch],
            branch: names.get(self.branch(branch, joints)).unwrap_or(&""),
        };
        let why = if is_pose {
            NoSolution::OutOfReach
        } else {
            NoSolution::NotAPose
        };
        Solutions {
            all: core::array::from_fn(solution),
            count: self.count,
            reason: (self.count == 0).then_some(why),
            turns,
            limits: [None; N],
        }
    }
}

impl<T: Real, const N: usize> Solutions<T, N> {
    /// Why the pose has no solution; `None` if it has one, though [`within`](Solutions::within) may have left none.
    pub fn reason(&self) -> Option<NoSolution> {
        self.reason
    }

    /// The solutions within the ranges of the joints, `JOINT_LIMITS` of a robot as it is: angles outside of their range get
    /// whole turns that bring them into it. A joint without a range may be anywhere.
    #[must_use]
    pub fn within(&self, limits: &[Option<[f64; 2]>; N]) -> Self {
        let limits = limits.map(|range| range.map(|range| range.map(T::from_f64)));
        let turns = self.turns;
        let mut within = Solutions {
            reason: self.reason,
            turns,
            limits,
            ..Solutions::default()
        };
        for solution in self.iter() {
            let mut q = solution.q;
            let is_within = (0..N).all(|i| {
                q[i] = within.nearest_turn(i, q[i], q[i]);
                limits[i].is_none_or(|[lower, upper]| q[i] >= lower && q[i] <= upper)
            });
            if let (true, Some(place)) = (is_within, within.all.get_mut(within.count)) {
                *place = Solution { q, ..*solution };
                within.count += 1;
            }
        }
        within
    }

    /// The solution whose joints have the least sum of squares of their ways from `seed`, whole turns left out. Behind
    /// [`within`](Solutions::within) whole turns are added that bring it nearest to the seed within the limits; without limits its
    /// angles stay as they are. `None` if there is no solution, or the seed is not finite.
    pub fn nearest(&self, seed: &SVector<T, N>) -> Option<Solution<T, N>> {
        let solution = *self.nearest_one(seed)?;
        let mut q = solution.q;
        for i in 0..N {
            if self.limits[i].is_some() {
                q[i] = self.nearest_turn(i, q[i], seed[i]);
            }
        }
        Some(Solution { q, ..solution })
    }

    /// The solution with the least sum of squares of the joints' ways, as it stands.
    pub(super) fn nearest_one(&self, seed: &SVector<T, N>) -> Option<&Solution<T, N>> {
        let mut nearest: Option<(T, &Solution<T, N>)> = None;
        for solution in self.iter() {
            let way = |i: usize| self.way(i, solution.q[i], seed[i]);
            let distance = (0..N).fold(T::from_f64(0.0), |sum, i| sum + way(i) * way(i));
            let is_nearer = match &nearest {
                None => distance.is_finite(),
                Some((least, _)) => distance < *least,
            };
            if is_nearer {
                nearest = Some((distance, solution));
            }
        }
        nearest.map(|(_, solution)| solution)
    }

    /// The way of joint i from a position to the nearest turn of another one.
    pub(super) fn way(&self, i: usize, q: T, from: T) -> T {
        self.nearest_turn(i, q, from) - from
    }

    /// The position of joint i that is whole turns away and nearest to another one, within its range if it has one.
    fn nearest_turn(&self, i: usize, q: T, seed: T) -> T {
        if self.turns[i] {
            nearest_turn(q, seed, self.limits[i])
        } else {
            q
        }
    }
}

/// None of any arm: a place for those of a batch.
impl<T: Real, const N: usize> Default for Solutions<T, N> {
    fn default() -> Self {
        let none = Branches::default().solutions([true; N], true, (&[], &[]));
        Solutions {
            reason: None,
            ..none
        }
    }
}

impl<T: Real, const N: usize> Deref for Solutions<T, N> {
    type Target = [Solution<T, N>];

    #[inline]
    fn deref(&self) -> &Self::Target {
        &self.all[..self.count.min(MOST)]
    }
}

/// The angle that is whole turns away from `q` and nearest to `seed`, in a range if one of them is.
pub fn nearest_turn<T: Real>(q: T, seed: T, range: Option<[T; 2]>) -> T {
    let near = q + whole_turns(seed - q, false);
    match range {
        // From outside of the range into it.
        Some([lower, _]) if near < lower => near + whole_turns(lower - near, true),
        Some([_, upper]) if near > upper => near - whole_turns(near - upper, true),
        _ => near,
    }
}

/// The multiple of a whole turn that is nearest to an angle, or, upwards, the least that is not below it.
fn whole_turns<T: Real>(angle: T, upwards: bool) -> T {
    let turn = T::from_f64(core::f64::consts::TAU);
    let turns = angle / turn;
    let nearest = turns.rint();
    let whole = if upwards && nearest < turns {
        nearest + T::from_f64(1.0)
    } else {
        nearest
    };
    whole * turn
}

impl<'s, T: Real, const N: usize> IntoIterator for &'s Solutions<T, N> {
    type Item = &'s Solution<T, N>;
    type IntoIter = core::slice::Iter<'s, Solution<T, N>>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::{PI, TAU};

    fn solutions(all: &[[f64; 2]]) -> Solutions<f64, 2> {
        let turns = [true, false];
        let mut solutions = Solutions {
            turns,
            ..Solutions::default()
        };
        for q in all {
            solutions.all[solutions.count].q = (*q).into();
            solutions.count += 1;
        }
        solutions
    }

    fn positions(solutions: &Solutions<f64, 2>) -> Vec<[f64; 2]> {
        solutions.iter().map(|solution| solution.q.into()).collect()
    }

    #[test]
    fn whole_turns_bring_angles_into_their_range() {
        let found = solutions(&[[-3.0, 0.2], [0.5, 0.2], [0.5, 0.9]]);
        let limits = [Some([3.0, 3.6]), Some([0.0, 0.5])];
        let within = found.within(&limits);
        assert_eq!(positions(&within), [[-3.0 + TAU, 0.2]]);
        assert_eq!(found.within(&[None, None]), {
            let mut same = found;
            same.limits = [None; 2];
            same
        });
        // A range below the angle, several turns away, and one of no whole turn.
        let below = found.within(&[Some([-13.0, -12.0]), None]);
        assert_eq!(positions(&below).len(), 2);
        assert!(found.within(&[Some([1.0, 1.1]), None]).is_empty());
    }

    #[test]
    fn the_nearest_is_measured_without_whole_turns() {
        let found = solutions(&[[-3.1, 0.0], [2.0, 0.0]]);
        let seed = [3.1, 0.0].into();
        // Beyond pi, which is 0.08 away; without limits the angle stays.
        assert_eq!(found.nearest(&seed).unwrap().q[0], -3.1);
        let wide = found.within(&[Some([-TAU, TAU]), None]);
        assert_eq!(wide.nearest(&seed).unwrap().q[0], -3.1 + TAU);
        // A whole turn that the limits do not allow.
        let narrow = found.within(&[Some([-PI, PI]), None]);
        assert_eq!(narrow.nearest(&seed).unwrap().q[0], 2.0);
        assert!(found.nearest(&[f64::NAN, 0.0].into()).is_none());
    }

    #[test]
    fn numbers_that_are_not_finite_are_no_solutions() {
        let mut branches = Branches::default();
        let joints = [
            [f64::NAN, 1.0],
            [1.0, f64::INFINITY],
            [f64::NEG_INFINITY, 0.0],
        ];
        for [sine, cosine] in joints {
            let joint = |sine, cosine| Found::new(sine, cosine, false);
            branches.push([joint(sine, cosine), joint(0.5, 0.0)], false);
            branches.push([joint(0.0, 1.0), joint(sine, 0.0)], false);
        }
        // A displacement of 1 is one.
        let found = branches.solutions([true, false], true, (&[], &[]));
        assert_eq!(positions(&found), [[0.0, 1.0]]);
    }
}
