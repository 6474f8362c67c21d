//! The Denavit-Hartenberg table of an arm in space.
//!
//! The z axes of a table's frames are the axes of the joints, in their directions, so that positions keep their signs and
//! zeros; the x axes are along the common normals of neighbours. A modified table puts frame i at the foot of the normal
//! on axis i, a standard table at the foot on axis i + 1. Four numbers take a frame to the next one, because x is across
//! the next axis and meets it. `base` and `tool` have the rest of the first link and of the tip.
//!
//! The normal of two axes that are nearly parallel is far away, and numbers that describe the arm by it lose as many
//! digits. A row that stands still leads from the one axis to the other then: its own axis meets both. So does one where
//! an angle is within 1e-9 of a quarter turn, which no single cell can say.

use dynamics_codegen::geometry::{Body, Mass, Matrix, Transform, Vector, cross, dot, tidy};
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::Convention;

use super::angle::{is_same, is_zero, roll_pitch_yaw};
use super::arm::{Arm, Joint, between, length};
use super::normal::{Axis, Normal, across, common_normal};
use super::parameters::Parameters;

/// A normal further away than so many times the length of the arm is not used.
const FARTHEST: u8 = 10;

/// A Denavit-Hartenberg table that was found.
pub(super) struct Table<'a> {
    pub(super) convention: Convention,
    /// Frame 0 in the world, where they are not the same.
    pub(super) base: Option<Transform>,
    pub(super) rows: Vec<Row<'a>>,
    /// The tip in the last frame, where they are not the same.
    pub(super) tool: Option<Transform>,
}

/// A row.
pub(super) struct Row<'a> {
    /// The joint; none of a row that stands still.
    pub(super) joint: Option<&'a Joint<'a>>,
    pub(super) parameters: Parameters,
    /// The link in its frame.
    pub(super) body: Body,
}

/// The axis of a row.
struct Line<'a> {
    axis: Axis,
    joint: Option<&'a Joint<'a>>,
}

/// At which ends a row that stands still takes up the rotation that roll, pitch and yaw cannot say: see
/// [`Parameters::in_steps`].
#[derive(Clone, Copy, Default)]
struct Ends {
    base: bool,
    tool: bool,
}

/// Whether roll, pitch and yaw of a frame mean what they say.
fn is_sayable(frame: Option<&Transform>) -> bool {
    let angles = frame.map(|frame| roll_pitch_yaw(&frame.rotation));
    let mut angles = angles.into_iter().flatten();
    angles.all(|angle| angle.split().0.is_none())
}

impl<'a> Table<'a> {
    /// The table of an arm that has a joint; none where the numbers found are not those of the arm.
    pub(super) fn of(arm: &'a Arm<'a>, convention: Convention) -> Option<Table<'a>> {
        let table = Table::with(arm, convention, Ends::default())?;
        let ends = Ends {
            base: !is_sayable(table.base.as_ref()),
            tool: !is_sayable(table.tool.as_ref()),
        };
        if ends.base || ends.tool {
            Table::with(arm, convention, ends)
        } else {
            Some(table)
        }
    }

    fn with(arm: &'a Arm<'a>, convention: Convention, ends: Ends) -> Option<Table<'a>> {
        let first = arm.joints.first()?;
        let mut axis = Axis::of(&first.frame);
        if first.slides() {
            // A joint that slides may have its axis anywhere.
            axis.point = [Rational::ZERO; 3];
        }
        let mut start = start(convention, &axis);
        let mut lines = Lines::new(arm);
        if ends.base {
            let rpy = roll_pitch_yaw(&start.rotation).map(|angle| {
                let (whole, rest) = angle.split();
                whole.unwrap_or(rest).value()
            });
            start = Transform::new(&start.origin, &rpy)?;
            lines.start(&start, Axis::of(&start), None);
            lines.lead_to(axis, Some(first));
        } else {
            lines.start(&start, axis, Some(first));
        }
        for joint in arm.joints.iter().skip(1) {
            lines.lead_to(Axis::of(&joint.frame), Some(joint));
        }
        if ends.tool {
            lines.lead_to(Axis::of(&arm.tip), None);
        }
        let Lines { lines, normals, .. } = lines;
        let frames = frames(convention, &lines, &normals, &start, &arm.tip);
        let mut rows = Vec::with_capacity(lines.len());
        for (line, pair) in lines.iter().zip(frames.windows(2)) {
            rows.extend(rows_between(convention, &pair[0], &pair[1], line.joint)?);
        }
        let unless_same = |frame: Transform| {
            let is_identity = is_same(&frame, &Transform::identity());
            (!is_identity).then_some(frame)
        };
        let last = frames.last()?;
        Some(Table {
            convention,
            base: unless_same(frames[0].clone()),
            rows,
            tool: unless_same(last.inverse().then(&arm.tip).tidy()),
        })
    }
}

/// The rows that lead from a frame to the next one, which stands on the axis of `joint`; none where the numbers found
/// lead elsewhere.
fn rows_between<'a>(
    convention: Convention,
    from: &Transform,
    to: &Transform,
    joint: Option<&'a Joint<'a>>,
) -> Option<Vec<Row<'a>>> {
    let step = from.inverse().then(to).tidy();
    let steps = Parameters::of(convention, &step).in_steps(convention);
    let mut product = Transform::identity();
    for (parameters, _) in &steps {
        product = product.then(&parameters.step(convention)?).tidy();
    }
    if !is_same(&product, &step) {
        return None;
    }
    let body = joint.map_or_else(Mass::none, |joint| {
        let frame = to.inverse().then(&joint.frame).tidy();
        joint.body.seen_from(&frame)
    });
    let last = steps.len() - 1;
    let row = |(index, (parameters, moves))| Row {
        joint: joint.filter(|_| moves),
        parameters,
        body: if index == last {
            body.body()
        } else {
            Mass::none().body()
        },
    };
    Some(steps.into_iter().enumerate().map(row).collect())
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

/// Frame 0: that of the world where four numbers lead from it to the first axis, or else one on that axis. Its
/// x axis is a direction across the first axis, and meets it.
fn start(convention: Convention, first: &Axis) -> Transform {
    let world = Transform::identity();
    let is_reached = match convention {
        Convention::Modified => meeting(&world, first).is_some(),
        Convention::Standard => is_along(&world, first),
    };
    if is_reached {
        return world;
    }
    let [x, y, z] = [0, 1, 2].map(|axis| world.axis(axis));
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
struct Lines<'a> {
    lines: Vec<Line<'a>>,
    normals: Vec<Normal>,
    /// The direction that the next normal's is to be near to.
    like: Vector,
    /// Where on the last axis the next normal starts, where it may start anywhere.
    near: Vector,
    farthest: Rational,
}

impl<'a> Lines<'a> {
    fn new(arm: &Arm) -> Self {
        let nothing = || [Rational::ZERO; 3];
        Lines {
            lines: Vec::new(),
            normals: Vec::new(),
            like: nothing(),
            near: nothing(),
            farthest: Rational::from(FARTHEST) * arm.size()
                + Rational::ONE / Rational::from(10).pow(30),
        }
    }

    /// The first axis, which the x axis of frame 0 meets.
    fn start(&mut self, start: &Transform, axis: Axis, joint: Option<&'a Joint<'a>>) {
        self.like = start.axis(0);
        self.near = meeting(start, &axis).unwrap_or_else(|| axis.point.clone());
        self.lines.push(Line { axis, joint });
    }

    /// The next axis, by way of another one where their normal is far away.
    fn lead_to(&mut self, mut axis: Axis, joint: Option<&'a Joint<'a>>) {
        if joint.is_some_and(Joint::slides) {
            axis.point = self.near.clone();
        }
        let last = &self.lines[self.lines.len() - 1].axis;
        let normal = common_normal(last, &axis, &self.like, &self.near);
        let is_far = |from: &Vector, to: &Vector| length(&between(from, to)) > self.farthest;
        if normal.is_vague || is_far(&self.near, &normal.from) || is_far(&axis.point, &normal.to) {
            let leading = leading(&self.near, &axis, &self.like);
            let normal = common_normal(last, &leading, &self.like, &self.near);
            self.add(leading, None, normal);
            let last = &self.lines[self.lines.len() - 1].axis;
            let normal = common_normal(last, &axis, &self.like, &self.near);
            self.add(axis, joint, normal);
        } else {
            self.add(axis, joint, normal);
        }
    }

    fn add(&mut self, axis: Axis, joint: Option<&'a Joint<'a>>, normal: Normal) {
        self.like = normal.direction.clone();
        self.near = normal.to.clone();
        self.normals.push(normal);
        self.lines.push(Line { axis, joint });
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

/// Frame 0 and those of all rows.
fn frames(
    convention: Convention,
    lines: &[Line],
    normals: &[Normal],
    start: &Transform,
    tip: &Transform,
) -> Vec<Transform> {
    let mut frames = vec![start.clone()];
    for (index, normal) in normals.iter().enumerate() {
        let (line, foot) = match convention {
            Convention::Modified => (&lines[index], &normal.from),
            Convention::Standard => (&lines[index + 1], &normal.to),
        };
        frames.push(frame(&normal.direction, &line.axis.direction, foot));
    }
    let before = &frames[frames.len() - 1];
    let last = &lines[lines.len() - 1].axis;
    let end = match convention {
        Convention::Modified if is_along(tip, last) => tip.clone(),
        Convention::Modified => {
            let origin = match normals.last() {
                Some(normal) => normal.to.clone(),
                None => meeting(start, last).unwrap_or_else(|| last.point.clone()),
            };
            frame(&before.axis(0), &last.direction, &origin)
        }
        Convention::Standard if meeting(tip, last).is_some() => tip.clone(),
        Convention::Standard => before.clone(),
    };
    frames.push(end);
    frames
}
