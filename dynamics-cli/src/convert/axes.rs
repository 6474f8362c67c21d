//! The axes of the rows of a table, the normals between them, and the frames that these make.
//!
//! The z axes of a table's frames are the axes of the joints, in their directions, so that positions keep their signs and
//! zeros; the x axes are along the common normals of neighbours. A modified table puts frame i at the foot of the normal
//! on axis i, a standard table at the foot on axis i + 1. Four numbers take a frame to the next one, because x is across
//! the next axis and meets it.
//!
//! The normal of two axes that are nearly parallel is far away, and numbers that describe the arm by it lose as many
//! digits. An axis that meets both leads from the one to the other then: if a foot is further away than ten times the
//! length of the arm, or the sine between the axes is below 1e-15.

use dynamics_codegen::geometry::{Matrix, Transform, Vector, cross, dot, tidy};
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::Convention;

use super::angle::is_zero;
use super::arm::{Arm, Joint, between, length};
use super::normal::{Axis, Normal, across, common_normal};

/// A normal further away than so many times the length of the arm is not used.
const FARTHEST: u8 = 10;

/// The axis of a row.
pub(super) struct RowAxis<'a> {
    axis: Axis,
    pub(super) joint: Option<&'a Joint<'a>>,
}

/// The frame with those x and z axes.
fn frame(x: &Vector, z: &Vector, origin: &Vector) -> Transform {
    let y = cross(z, x);
    let columns = [x, &y, z];
    let rotation: Matrix = [0, 1, 2].map(|i| columns.map(|axis| axis[i].clone()));
    Transform {
        rotation,
        origin: origin.clone(),
    }
    .tidy()
}

/// The frame in which a chain begins: `from`, that of the world or of a link, where four numbers lead from it to the first
/// axis, or else one on that axis. Its x axis is a direction across the first axis, and meets it.
pub(super) fn start(convention: Convention, from: &Transform, first: &Axis) -> Transform {
    let is_reached = match convention {
        Convention::Modified => meeting(from, first).is_some(),
        Convention::Standard => is_along(from, first),
    };
    if is_reached {
        return from.clone();
    }
    let [x, y, z] = [0, 1, 2].map(|axis| from.axis(axis));
    let is_across = |axis: &Vector| is_zero(&dot(axis, &first.direction));
    let across_both = cross(&z, &first.direction);
    let x = match (is_across(&x), is_across(&y)) {
        (true, _) => x,
        (_, true) => y,
        _ => across(&across_both, &first.direction).unwrap_or(x),
    };
    frame(&x, &first.direction, &first.point)
}

/// Where the x axis of a frame meets an axis that it is across.
fn meeting(frame: &Transform, axis: &Axis) -> Option<Vector> {
    let x = frame.axis(0);
    if !is_zero(&dot(&x, &axis.direction)) {
        return None;
    }
    let along = dot(&between(&frame.origin, &axis.point), &x);
    let point = [0, 1, 2].map(|k| tidy(&frame.origin[k] + &x[k] * &along));
    axis.passes(&point).then_some(point)
}

/// Whether the z axis of a frame is an axis, in its direction.
fn is_along(frame: &Transform, axis: &Axis) -> bool {
    let z = frame.axis(2);
    let is_parallel = cross(&z, &axis.direction).iter().all(is_zero);
    is_parallel && dot(&z, &axis.direction) > Rational::ZERO && axis.passes(&frame.origin)
}

/// The axes of all rows, and the normals between them.
pub(super) struct Axes<'a> {
    pub(super) rows: Vec<RowAxis<'a>>,
    normals: Vec<Normal>,
    /// The direction that the next normal's is to be near to.
    like: Vector,
    /// Where on the last axis the next normal starts, where it may start anywhere.
    near: Vector,
    farthest: Rational,
}

impl<'a> Axes<'a> {
    pub(super) fn new(arm: &Arm) -> Self {
        let nothing = || [Rational::ZERO; 3];
        Axes {
            rows: Vec::new(),
            normals: Vec::new(),
            like: nothing(),
            near: nothing(),
            farthest: Rational::from(FARTHEST) * arm.size()
                + Rational::ONE / Rational::from(10).pow(30),
        }
    }

    /// The first axis, which the x axis of frame 0 meets.
    pub(super) fn start(&mut self, start: &Transform, axis: Axis, joint: Option<&'a Joint<'a>>) {
        self.like = start.axis(0);
        self.near = meeting(start, &axis).unwrap_or_else(|| axis.point.clone());
        self.rows.push(RowAxis { axis, joint });
    }

    /// The next axis, by way of another one where their normal is far away.
    pub(super) fn lead_to(&mut self, mut axis: Axis, joint: Option<&'a Joint<'a>>) {
        if joint.is_some_and(Joint::slides) {
            axis.point = self.near.clone();
        }
        let last = &self.rows[self.rows.len() - 1].axis;
        let normal = common_normal(last, &axis, &self.like, &self.near);
        let is_far = |from: &Vector, to: &Vector| length(&between(from, to)) > self.farthest;
        if normal.is_vague || is_far(&self.near, &normal.from) || is_far(&axis.point, &normal.to) {
            let leading = leading(&self.near, &axis, &self.like);
            let normal = common_normal(last, &leading, &self.like, &self.near);
            self.add(leading, None, normal);
            let last = &self.rows[self.rows.len() - 1].axis;
            let normal = common_normal(last, &axis, &self.like, &self.near);
            self.add(axis, joint, normal);
        } else {
            self.add(axis, joint, normal);
        }
    }

    /// Leaves out the first axis. Returns the frame on it at the foot of the normal that leads from it to the next one.
    pub(super) fn without_first(&mut self) -> Transform {
        let axis = self.rows.remove(0).axis;
        let normal = self.normals.remove(0);
        frame(&normal.direction, &axis.direction, &normal.from)
    }

    /// The frame in which a chain begins, and those of all its rows.
    pub(super) fn frames(
        &self,
        convention: Convention,
        start: &Transform,
        tip: Option<&Transform>,
    ) -> Vec<Transform> {
        let Axes { rows, normals, .. } = self;
        let mut frames = vec![start.clone()];
        for (index, normal) in normals.iter().enumerate() {
            let (line, foot) = match convention {
                Convention::Modified => (&rows[index], &normal.from),
                Convention::Standard => (&rows[index + 1], &normal.to),
            };
            frames.push(frame(&normal.direction, &line.axis.direction, foot));
        }
        let before = &frames[frames.len() - 1];
        let last = &rows[rows.len() - 1].axis;
        let is_end = |tip: &&Transform| match convention {
            Convention::Modified => is_along(tip, last),
            Convention::Standard => meeting(tip, last).is_some(),
        };
        let end = match (tip.filter(is_end), convention) {
            (Some(tip), _) => tip.clone(),
            (None, Convention::Standard) => before.clone(),
            (None, Convention::Modified) => {
                let origin = match normals.last() {
                    Some(normal) => normal.to.clone(),
                    None => meeting(start, last).unwrap_or_else(|| last.point.clone()),
                };
                frame(&before.axis(0), &last.direction, &origin)
            }
        };
        frames.push(end);
        frames
    }

    fn add(&mut self, axis: Axis, joint: Option<&'a Joint<'a>>, normal: Normal) {
        self.like = normal.direction.clone();
        self.near = normal.to.clone();
        self.normals.push(normal);
        self.rows.push(RowAxis { axis, joint });
    }
}

/// The axis from a point to the nearest one of another axis, across that; through a point of it like a direction that is
/// across another axis, nearly parallel to it.
fn leading(from: &Vector, to: &Axis, like: &Vector) -> Axis {
    let way = between(from, &to.nearest(from));
    let direction = across(&way, &to.direction).or_else(|| across(like, &to.direction));
    Axis {
        point: from.clone(),
        direction: direction.unwrap_or_else(|| like.clone()),
    }
}
