//! The joints that are not known yet, in a row, and what stays where it is while some of them move.
//!
//!   Z_1 C_1 Z_2 C_2 ... Z_m = L
//!
//! Z_i is the motion of joint i about or along its z axis, C_i the known way to the next one, and L the known way from the
//! first joint's frame to the last joint's.

use super::moves::Path;
use crate::expr::{Expr, Graph, NodeId};
use crate::linear::Vector3;
use crate::spatial::AxisMotion;
use core::ops::Range;
use std::collections::BTreeSet;

type Vector<'g> = Vector3<Expr<'g>>;

/// A joint whose position is to be found.
#[derive(Clone, Copy)]
pub(super) struct Unknown {
    /// Its number among the joints that move.
    pub(super) number: usize,
    pub(super) axis_motion: AxisMotion,
}

/// The equation above, or that of its inverse.
pub(super) struct View<'g> {
    pub(super) graph: &'g Graph,
    pub(super) joints: Vec<Unknown>,
    /// C_i, one less than joints.
    pub(super) links: Vec<Path<'g>>,
    /// L.
    pub(super) target: Path<'g>,
    /// Whether it is the inverse equation: joints in the opposite order, which move the other way.
    pub(super) is_inverse: bool,
    /// A point of the last frame, of which L says where it is without the rotation of the pose, in the equation itself.
    pub(super) tip: Vector<'g>,
    /// The sum of the squares of the arm's fixed lengths: positions are rounded as much as these are.
    pub(super) span: Expr<'g>,
    /// Symbols that no equation may read.
    pub(super) forbidden: BTreeSet<NodeId>,
}

/// The points that stay where they are.
#[derive(Clone, Copy)]
pub(super) enum Points<'g> {
    /// All of them: nothing moves.
    All,
    /// Lines of this direction stay lines, each on itself.
    Lines(Vector<'g>),
    /// This line, by a point and a direction, and if `each` each of its points.
    Line {
        point: Vector<'g>,
        direction: Vector<'g>,
        each: bool,
    },
    /// One.
    One(Vector<'g>),
    /// None.
    None,
}

impl<'g> View<'g> {
    /// The axes x, y and z of a frame.
    pub(super) fn axes(&self) -> [Vector<'g>; 3] {
        let (zero, one) = (self.graph.zero(), self.graph.one());
        [[one, zero, zero], [zero, one, zero], [zero, zero, one]].map(Vector3)
    }

    pub(super) fn z(&self) -> Vector<'g> {
        self.axes()[2]
    }

    pub(super) fn origin(&self) -> Vector<'g> {
        Vector3::splat(self.graph.zero())
    }

    /// Whether expressions read no symbol that is forbidden.
    pub(super) fn allows(&self, expressions: &[Expr<'g>]) -> bool {
        let mut seen = BTreeSet::new();
        if self.forbidden.is_empty() {
            return true;
        }
        for x in expressions {
            let (is_known, root) = (|seen: &BTreeSet<_>, id| seen.contains(&id), x.edge().node());
            self.graph
                .visit_operands_first(&mut seen, root, is_known, |seen, id, _| {
                    seen.insert(id);
                });
        }
        self.forbidden.is_disjoint(&seen)
    }

    /// The way from the frame of joint a to that of joint b, if those between them stand at zero.
    pub(super) fn way(&self, a: usize, b: usize) -> Path<'g> {
        let links = self.links[a..b].iter();
        links.fold(Path::default(), |way, link| way.then(link))
    }

    /// From the last of some joints to the first: `none` is taken over each joint by `join`, and by `leave` over each way between
    /// two.
    fn gathered<T>(
        &self,
        range: Range<usize>,
        none: T,
        leave: impl Fn(&Path<'g>, T) -> T,
        join: impl Fn(usize, T) -> T,
    ) -> T {
        let end = range.end;
        range.rev().fold(none, |found, i| {
            let here = if i + 1 < end {
                leave(&self.links[i], found)
            } else {
                found
            };
            join(i, here)
        })
    }

    /// The points that no joint of a range moves, in the frame of its first joint.
    pub(super) fn points(&self, range: Range<usize>) -> Points<'g> {
        let join = |i: usize, points| match self.joints[i].axis_motion {
            AxisMotion::Turns => self.on_axis(points),
            AxisMotion::Slides => self.along_axis(points),
        };
        self.gathered(range, Points::All, moved, join)
    }

    /// The points among these that a turn about z leaves.
    fn on_axis(&self, points: Points<'g>) -> Points<'g> {
        let (z, point) = (self.z(), self.origin());
        let axis = |each| Points::Line {
            point,
            direction: z,
            each,
        };
        match points {
            Points::All => axis(true),
            Points::Lines(direction) if are_parallel(direction, z) => axis(false),
            Points::One(p) if is_on_z(p) => points,
            Points::Line {
                point,
                direction,
                each,
            } => {
                if are_parallel(direction, z) {
                    return if is_on_z(point) { points } else { Points::None };
                }
                let meets = (point[0] * direction[1] - point[1] * direction[0]).is_zero();
                if !each || !meets {
                    return Points::None;
                }
                let k = if direction[0].is_zero() { 1 } else { 0 };
                Points::One(point - direction * (point[k] / direction[k]))
            }
            Points::Lines(_) | Points::One(_) | Points::None => Points::None,
        }
    }

    /// The points among these that a step along z leaves.
    fn along_axis(&self, points: Points<'g>) -> Points<'g> {
        let z = self.z();
        match points {
            Points::All => Points::Lines(z),
            Points::Lines(direction) if are_parallel(direction, z) => points,
            Points::Line {
                point, direction, ..
            } if are_parallel(direction, z) => Points::Line {
                point,
                direction,
                each: false,
            },
            _ => Points::None,
        }
    }

    /// A basis of the directions that no joint of a range turns, in the frame of its first joint.
    pub(super) fn directions(&self, range: Range<usize>) -> Vec<Vector<'g>> {
        self.heights(range, |i| self.joints[i].axis_motion == AxisMotion::Slides)
    }

    /// A basis of the directions along which no joint of a range moves a point, except for those that are skipped.
    pub(super) fn heights(
        &self,
        range: Range<usize>,
        is_skipped: impl Fn(usize) -> bool,
    ) -> Vec<Vector<'g>> {
        let turned = |way: &Path<'g>, basis: Vec<Vector<'g>>| {
            basis.into_iter().map(|v| way.direction(v)).collect()
        };
        let join = |i: usize, basis| match self.joints[i].axis_motion {
            _ if is_skipped(i) => basis,
            AxisMotion::Turns => self.containing_z(basis),
            AxisMotion::Slides => self.across_z(basis),
        };
        self.gathered(range, self.axes().to_vec(), turned, join)
    }

    /// z, if it is a combination of a basis.
    fn containing_z(&self, basis: Vec<Vector<'g>>) -> Vec<Vector<'g>> {
        let z = self.z();
        let contains = match basis[..] {
            [] => false,
            [a] => are_parallel(a, z),
            [a, b] => a.cross(b).dot(z).is_zero(),
            _ => true,
        };
        if contains { vec![z] } else { Vec::new() }
    }

    /// The combinations of a basis that are at right angles to z.
    fn across_z(&self, basis: Vec<Vector<'g>>) -> Vec<Vector<'g>> {
        let Some(pivot) = basis.iter().position(|v| !v[2].is_zero()) else {
            return basis;
        };
        let p = basis[pivot];
        let others = basis.iter().enumerate().filter(|(i, _)| *i != pivot);
        others
            .map(|(_, v)| {
                if v[2].is_zero() {
                    *v
                } else {
                    *v * p[2] - p * v[2]
                }
            })
            .collect()
    }
}

/// Points of the last frame of a way, in its first.
pub(super) fn moved<'g>(way: &Path<'g>, points: Points<'g>) -> Points<'g> {
    match points {
        Points::Lines(direction) => Points::Lines(way.direction(direction)),
        Points::Line {
            point,
            direction,
            each,
        } => Points::Line {
            point: way.point(point),
            direction: way.direction(direction),
            each,
        },
        Points::One(p) => Points::One(way.point(p)),
        Points::All | Points::None => points,
    }
}

/// Whether two directions are parallel or opposite.
pub(super) fn are_parallel<'g>(a: Vector<'g>, b: Vector<'g>) -> bool {
    a.cross(b).0.iter().all(|x| x.is_zero())
}

fn is_on_z(p: Vector<'_>) -> bool {
    p[0].is_zero() && p[1].is_zero()
}
