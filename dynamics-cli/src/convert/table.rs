//! The Denavit-Hartenberg table of a robot in space.
//!
//! The z axes of a table's frames are the axes of the joints, in their directions, so that positions keep their signs and
//! zeros; the x axes are along the common normals of neighbours. A modified table puts frame i at the foot of the normal
//! on axis i, a standard table at the foot on axis i + 1. Four numbers take a frame to the next one, because x is across
//! the next axis and meets it. `base` and `tool` have the rest of the first link and of the tip.
//!
//! The normal of two axes that are nearly parallel is far away, and numbers that describe the arm by it lose as many
//! digits. A row that stands still leads from the one axis to the other then: its own axis meets both. So does one where
//! an angle is within 1e-9 of a quarter turn, which no single cell can say.
//!
//! Numbers lose digits if axes are nearly parallel, because their normal is far away. If a foot is further away than
//! ten times the length of the arm, or the sine between the axes is below 1e-15, a locked row goes from the one axis
//! straight to the other. The rows are multiplied out and compared with the frames they came from before anything is
//! written. The text is read back by the macro's reader: if it refuses what the file had already, an unphysical
//! tensor or an odd angle, `allow` is put into that row.

use dynamics_codegen::geometry::{Body, Mass, Matrix, Transform, Vector, cross, dot, tidy};
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{Carrier, Convention};

use super::angle::{Origin, is_same, is_zero, origins, roll_pitch_yaw};
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
    /// The body of a base that moves.
    pub(super) floating: Option<Body>,
    pub(super) rows: Vec<Row<'a>>,
    /// The tip in the last frame, where they are not the same.
    pub(super) tool: Option<Transform>,
    /// The frames of the robot: the index of the row that carries each, none of the base, and the frame on it.
    pub(super) frames: Vec<(Option<usize>, Transform)>,
}

/// A row.
pub(super) struct Row<'a> {
    /// The joint; none of a row that stands still.
    pub(super) joint: Option<&'a Joint<'a>>,
    /// The link that carries the row.
    pub(super) on: Carrier,
    /// Where the row begins on that link, if it is not at the link's frame.
    pub(super) at: Option<Origin>,
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
    /// The table of an arm that has a joint, or a base that moves; none where the numbers found are not those of the arm.
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
        let branches = Branches {
            arm,
            convention,
            rows: arm.joints.iter().map(|_| Vec::new()).collect(),
            links: vec![Transform::identity(); arm.joints.len()],
        };
        if arm.base.is_some() {
            branches.on_moving_base(ends)
        } else {
            branches.on_standing_base(ends)
        }
    }
}

/// The rows of each joint, with those that stand still before it.
struct Branches<'a> {
    arm: &'a Arm<'a>,
    convention: Convention,
    rows: Vec<Vec<Row<'a>>>,
    /// The frames behind them in the world.
    links: Vec<Transform>,
}

impl<'a> Branches<'a> {
    /// The table on a base that moves: frame 0 is the base's own, from which the first joint branches off as all others do.
    fn on_moving_base(mut self, ends: Ends) -> Option<Table<'a>> {
        let base = Transform::identity();
        if !self.arm.joints.is_empty() {
            self.branch_off(&base, 0, ends.tool)?;
        }
        self.others(&base)?;
        Some(self.table(base))
    }

    /// The table on a base that stands where the first joint needs it.
    fn on_standing_base(mut self, ends: Ends) -> Option<Table<'a>> {
        let (arm, convention) = (self.arm, self.convention);
        let mut axis = Axis::of(&arm.joints.first()?.frame);
        if arm.joints[0].slides() {
            // A joint that slides may have its axis anywhere.
            axis.point = [Rational::ZERO; 3];
        }
        let world = start(convention, &Transform::identity(), &axis);
        let base = if ends.base {
            let rpy = roll_pitch_yaw(&world.rotation).map(|angle| {
                let (whole, rest) = angle.split();
                whole.unwrap_or(rest).value()
            });
            Transform::new(&world.origin, &rpy)?
        } else {
            world
        };
        let mut lines = Lines::new(arm);
        if ends.base {
            lines.start(&base, Axis::of(&base), None);
            lines.lead_to(axis, Some(&arm.joints[0]));
        } else {
            lines.start(&base, axis, Some(&arm.joints[0]));
        }
        self.follow(lines, &base, 0, ends.tool)?;
        self.others(&base)?;
        Some(self.table(base))
    }

    /// The rows of all joints but the first one that are not the first on their links, and of the joints behind them.
    fn others(&mut self, base: &Transform) -> Option<()> {
        for first in 1..self.arm.joints.len() {
            let parent = self.arm.joints[first].parent;
            if self.arm.children(parent).next() != Some(first) {
                self.branch_off(base, first, false)?;
            }
        }
        Some(())
    }

    /// The rows of a joint that begins on the frame of its link, and of the joints behind it.
    fn branch_off(&mut self, base: &Transform, first: usize, has_end: bool) -> Option<()> {
        let joint = &self.arm.joints[first];
        let carrier = joint.parent.map_or(base, |parent| &self.links[parent]);
        let mut axis = Axis::of(&joint.frame);
        let mut lines = Lines::new(self.arm);
        let beginning = match self.convention {
            Convention::Modified => {
                lines.start(carrier, Axis::of(carrier), None);
                lines.lead_to(axis, Some(joint));
                lines.without_first()
            }
            Convention::Standard => {
                if joint.slides() {
                    axis.point = carrier.origin.clone();
                }
                let beginning = start(self.convention, carrier, &axis);
                lines.start(&beginning, axis, Some(joint));
                beginning
            }
        };
        let at = carrier.inverse().then(&beginning).tidy();
        self.follow(lines, &beginning, first, has_end)?;
        if !is_same(&at, &Transform::identity()) {
            self.begin(first, &at);
        }
        Some(())
    }

    /// The rows of a joint, to which `lines` lead from a frame, and of the first joint on each link behind it.
    fn follow(
        &mut self,
        mut lines: Lines<'a>,
        start: &Transform,
        first: usize,
        has_end: bool,
    ) -> Option<()> {
        let arm = self.arm;
        let mut joints = vec![first];
        while let Some(next) = arm.children(joints.last().copied()).next() {
            lines.lead_to(Axis::of(&arm.joints[next].frame), Some(&arm.joints[next]));
            joints.push(next);
        }
        let last = joints[joints.len() - 1];
        let tip = arm.tip.as_ref().filter(|tip| tip.on == Some(last));
        let tip = tip.map(|tip| &tip.frame);
        if let Some(tip) = tip.filter(|_| has_end) {
            lines.lead_to(Axis::of(tip), None);
        }
        let Lines { lines, normals, .. } = lines;
        let frames = frames(self.convention, &lines, &normals, start, tip);
        // Rows that stand still belong to the joint behind them, and at the end to the last one.
        let (mut joints, mut still) = (joints.into_iter(), Vec::new());
        for (line, pair) in lines.iter().zip(frames.windows(2)) {
            still.extend(rows_between(
                self.convention,
                &pair[0],
                &pair[1],
                line.joint,
            )?);
            let owner = line.joint.and_then(|_| joints.next());
            if let Some(joint) = owner {
                self.rows[joint].append(&mut still);
                self.links[joint] = pair[1].clone();
            }
        }
        self.rows[last].append(&mut still);
        self.links[last] = frames.last()?.clone();
        Some(())
    }

    /// Lets the rows of a joint begin at a place. Rows that stand still take up what one place cannot say.
    fn begin(&mut self, joint: usize, at: &Transform) {
        let mut origins = origins(at);
        let last = origins.pop();
        let rows = &mut self.rows[joint];
        rows[0].at = last;
        let row = |origin| Row {
            at: Some(origin),
            ..Row::still(Parameters::none())
        };
        rows.splice(0..0, origins.into_iter().map(row));
    }

    /// The table of all rows, in the order of the joints.
    fn table(self, base: Transform) -> Table<'a> {
        let (arm, mut rows) = (self.arm, Vec::new());
        let mut ends = Vec::with_capacity(arm.joints.len());
        for (joint, mut of_joint) in arm.joints.iter().zip(self.rows) {
            let above = rows.len().checked_sub(1);
            let parent = joint.parent.map(|parent| ends[parent]);
            if parent != above {
                of_joint[0].on = parent.map_or(Carrier::Base, Carrier::Row);
            }
            rows.append(&mut of_joint);
            ends.push(rows.len() - 1);
        }
        let behind = |on: Option<usize>, frame: &Transform| {
            let link = on.map_or(&base, |joint| &self.links[joint]);
            link.inverse().then(frame).tidy()
        };
        let unless_same =
            |frame: Transform| (!is_same(&frame, &Transform::identity())).then_some(frame);
        let frames = arm.frames.iter();
        let frames = frames.map(|place| {
            let row = place.on.map(|joint| ends[joint]);
            (row, behind(place.on, &place.frame))
        });
        let tip = arm.tip.as_ref();
        Table {
            convention: self.convention,
            frames: frames.collect(),
            tool: tip.and_then(|tip| unless_same(behind(tip.on, &tip.frame))),
            base: unless_same(base.clone()),
            floating: arm.base.as_ref().map(Mass::body),
            rows,
        }
    }
}

impl Row<'_> {
    /// A row that stands still, without a body.
    fn still(parameters: Parameters) -> Self {
        Row {
            joint: None,
            on: Carrier::Above,
            at: None,
            parameters,
            body: Mass::none().body(),
        }
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
    let row = |(index, (parameters, moves))| {
        let mut row = Row {
            joint: joint.filter(|_| moves),
            ..Row::still(parameters)
        };
        if index == last {
            row.body = body.body();
        }
        row
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

/// The frame in which a chain begins: `from`, that of the world or of a link, where four numbers lead from it to the first
/// axis, or else one on that axis. Its x axis is a direction across the first axis, and meets it.
fn start(convention: Convention, from: &Transform, first: &Axis) -> Transform {
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

    /// Leaves out the first axis. Returns the frame on it at the foot of the normal that leads from it to the next one.
    fn without_first(&mut self) -> Transform {
        let axis = self.lines.remove(0).axis;
        let normal = self.normals.remove(0);
        frame(&normal.direction, &axis.direction, &normal.from)
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

/// The frame in which a chain begins, and those of all its rows.
fn frames(
    convention: Convention,
    lines: &[Line],
    normals: &[Normal],
    start: &Transform,
    tip: Option<&Transform>,
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
