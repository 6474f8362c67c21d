//! The elbow of seven joints: its angle at a position of the joints, and the angles at which all joints are within their limits.

use core::f64::consts::{PI, TAU};
use core::ops::Deref;

use nalgebra::Vector3;

use super::angle::angle;
use super::pose::{cross, dot};
use super::roots::direction;
use super::{Real, Solutions};

/// The angle of the elbow about the line from shoulder to wrist, from the half plane that holds the direction of axis 1. All
/// vectors are in a frame whose z axis is axis 1: that line, the way from it to the elbow, and the direction of axis 4.
/// Where the line vanishes beside `size`, or is along axis 1, and where the elbow is on the line, other directions take their
/// place as they do in `inverse_kinematics`.
#[doc(hidden)]
pub fn elbow_angle<T: Real>(line: Vector3<T>, elbow: Vector3<T>, axis: Vector3<T>, size: T) -> T {
    let (zero, one) = (T::from_f64(0.0), T::from_f64(1.0));
    let (x, z) = ([one, zero, zero], [zero, zero, one]);
    let [line, elbow, axis] = [line, elbow, axis].map(|v| v.data.0[0]);
    let along = |[x, y, z]: [T; 3], [u, v, w]: [T; 3], size: T| {
        direction(x, y, z, u, v, w, size).0.data.0[0]
    };
    let across = |v: [T; 3], line: &[T; 3]| {
        let by = dot(&v, line);
        core::array::from_fn(|i| v[i] - line[i] * by)
    };
    let line = along(line, z, size);
    let start = across(along(across(z, &line), across(x, &line), one), &line);
    let beside = cross(&axis, &line);
    let elbow = across(along(across(elbow, &line), beside, size), &line);
    let (cosine, sine) = (dot(&start, &elbow), dot(&line, &cross(&start, &elbow)));
    angle(sine, cosine)
}

/// Ranges have room for so many. Each of six joints meets each of its two limits at two angles of the elbow at most, for both
/// positions of the fourth joint. A range lies between two of these, and one may be cut at half a turn.
const MOST: usize = 25;

/// Ranges of elbow angles, a slice of `[lower, upper]`, rad, from -pi to pi in rising order. One that goes on beyond half a turn is
/// two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElbowRanges<T: Real> {
    all: [[T; 2]; MOST],
    count: usize,
}

impl<T: Real> Deref for ElbowRanges<T> {
    type Target = [[T; 2]];

    fn deref(&self) -> &Self::Target {
        &self.all[..self.count]
    }
}

impl<'r, T: Real> IntoIterator for &'r ElbowRanges<T> {
    type Item = &'r [T; 2];
    type IntoIter = core::slice::Iter<'r, [T; 2]>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

/// Angles of a grid, between which a range may begin or end.
const GRID: u32 = 256;
/// Steps that narrow or halve an interval: an angle is then known to its last digits.
const ROUNDS: u32 = 60;

/// The ranges of elbow angles at which a solution is within the limits.
#[doc(hidden)]
pub fn elbow_ranges<T: Real, const N: usize>(
    solutions: impl Fn(T) -> Solutions<T, N>,
    limits: &[Option<[f64; 2]>; N],
) -> ElbowRanges<T> {
    let margin = |elbow: f64| {
        let elbow = T::from_f64(elbow);
        (elbow.into(), margin(&solutions(elbow), limits))
    };
    let mut ranges = Ranges::default();
    search(&margin, &mut ranges);
    ElbowRanges {
        all: ranges.all.map(|range| range.map(T::from_f64)),
        count: ranges.count,
    }
}

/// How far the joints of the best solution are within their limits, the one that is least; below 0 if one is beyond.
///
/// A joint whose range is shorter than a turn is within it by half the range less the way to its middle, which has no jump.
fn margin<T: Real, const N: usize>(
    solutions: &Solutions<T, N>,
    limits: &[Option<[f64; 2]>; N],
) -> f64 {
    let of_joint = |(range, q): (&Option<[f64; 2]>, &T)| match range {
        Some([lower, upper]) if upper - lower < TAU => {
            let way = (*q).into() - (lower + upper) / 2.0;
            let way = way - TAU * libm::rint(way / TAU);
            (upper - lower) / 2.0 - way.abs()
        }
        // No position is within a range that is none.
        Some([lower, upper]) if (upper - lower).is_nan() => f64::NEG_INFINITY,
        _ => TAU,
    };
    let of_solution = |q: &[T; N]| limits.iter().zip(q).map(of_joint).fold(TAU, f64::min);
    let margins = solutions.iter().map(|one| of_solution(&one.q.data.0[0]));
    margins.fold(f64::NEG_INFINITY, f64::max)
}

/// An elbow angle and the margin there.
type Point = (f64, f64);

#[derive(Default)]
struct Ranges {
    all: [[f64; 2]; MOST],
    count: usize,
    /// Where the range began that has not ended.
    begin: Option<f64>,
}

impl Ranges {
    fn end(&mut self, upper: f64) {
        let Some(lower) = self.begin.take() else {
            return;
        };
        if let Some(place) = self.all.get_mut(self.count) {
            *place = [lower, upper];
            self.count += 1;
        }
    }
}

/// Looks from -pi to pi where the margin changes its sign. A point of the grid gives way to the extreme beside it, if that may be on
/// the other side of zero.
fn search(margin: &dyn Fn(f64) -> Point, ranges: &mut Ranges) {
    let on_grid = |k: u32| margin(TAU * (f64::from(k) / f64::from(GRID)) - PI);
    let [mut before, mut middle] = [0, 1].map(on_grid);
    let mut last = before;
    ranges.begin = (before.1 >= 0.0).then_some(-PI);
    for k in 1..=GRID {
        let behind = if k < GRID { on_grid(k + 1) } else { middle };
        let next = extreme(margin, [before, middle, behind]);
        match (last.1 >= 0.0, next.1 >= 0.0) {
            (false, true) => ranges.begin = Some(boundary(margin, last, next)),
            (true, false) => ranges.end(boundary(margin, next, last)),
            _ => {}
        }
        (before, middle, last) = (middle, behind, next);
    }
    ranges.end(PI);
}

/// The outermost angle with a margin of at least 0 that is found between one outside and one inside.
fn boundary(margin: &dyn Fn(f64) -> Point, (mut outside, _): Point, (mut inside, _): Point) -> f64 {
    for _ in 0..ROUNDS {
        let (middle, value) = margin((outside + inside) / 2.0);
        if value >= 0.0 {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    inside
}

/// The middle one of three points, or one between the others whose margin has the other sign, if the middle is the nearest to zero and
/// the way to zero is not much longer than those to the others.
fn extreme(margin: &dyn Fn(f64) -> Point, mut around: [Point; 3]) -> Point {
    let middle = around[1];
    let sign = if middle.1 >= 0.0 { -1.0 } else { 1.0 };
    let height = |point: Point| sign * point.1;
    let falls = [0, 2].map(|k| height(middle) - height(around[k]));
    let is_extreme = falls.iter().all(|fall| *fall >= 0.0);
    let may_reach = -height(middle) <= 4.0 * falls[0].max(falls[1]);
    if !(is_extreme && may_reach) {
        return middle;
    }
    for _ in 0..ROUNDS {
        let [before, top, behind] = around;
        let is_before = top.0 - before.0 > behind.0 - top.0;
        let one = margin(0.5 * (top.0 + if is_before { before.0 } else { behind.0 }));
        if height(one) > 0.0 {
            return one;
        }
        around = match (is_before, height(one) >= height(top)) {
            (true, true) => [before, one, top],
            (true, false) => [one, top, behind],
            (false, true) => [top, one, behind],
            (false, false) => [before, top, one],
        };
    }
    middle
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(margin: impl Fn(f64) -> f64) -> Vec<[f64; 2]> {
        let mut ranges = Ranges::default();
        search(&|x| (x, margin(x)), &mut ranges);
        ranges.all[..ranges.count].to_vec()
    }

    fn assert_ranges(margin: impl Fn(f64) -> f64, expected: &[[f64; 2]]) {
        let found = found(margin);
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
            assert!((found - expected).abs() < 1e-15, "{found} {expected}");
        }
    }

    /// Ranges end where the margin is zero, and are cut at half a turn.
    #[test]
    fn ranges_end_where_the_margin_vanishes() {
        assert_ranges(|x| 0.5 - (x - 0.3).abs(), &[[-0.2, 0.8]]);
        assert_ranges(|x| x.abs() - 2.5, &[[-PI, -2.5], [2.5, PI]]);
        assert_ranges(|_| 1.0, &[[-PI, PI]]);
        assert_ranges(|_| f64::NEG_INFINITY, &[]);
    }

    /// Ranges, and gaps between ranges, are found that are shorter than a step of the grid.
    #[test]
    fn short_ranges_and_gaps_are_found() {
        assert_ranges(|x| 1e-3 - (x - 0.3).abs(), &[[0.299, 0.301]]);
        assert_ranges(|x| (x - 0.3).abs() - 1e-3, &[[-PI, 0.299], [0.301, PI]]);
    }
}
