//! The Denavit-Hartenberg table of a robot in space.
//!
//! `axes` has the axes of its rows and their frames. `base` and `tool` have the rest of the first link and of the tip.
//!
//! A row that stands still has an axis that leads from one joint to the next, where their normal is far away. So does one
//! where an angle is within 1e-9 of a quarter turn, which no single cell can say. The rows are multiplied out and compared
//! with the frames they came from before anything is written. The text is read back by the macro's reader: if it refuses
//! what the file had already, an unphysical tensor or an odd angle, `allow` is put into that row.

use dynamics_codegen::geometry::{Body, Mass, Transform};
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{Carrier, Convention};

use super::angle::{Origin, is_same, origins, roll_pitch_yaw};
use super::arm::{Arm, Joint};
use super::axes::{Axes, start};
use super::normal::Axis;
use super::parameters::Parameters;

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
    pub(super) fn find(arm: &'a Arm<'a>, convention: Convention) -> Option<Table<'a>> {
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
        let mut axis = Axis::z(&arm.joints.first()?.frame);
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
        let mut axes = Axes::new(arm);
        if ends.base {
            axes.start(&base, Axis::z(&base), None);
            axes.lead_to(axis, Some(&arm.joints[0]));
        } else {
            axes.start(&base, axis, Some(&arm.joints[0]));
        }
        self.follow(axes, &base, 0, ends.tool)?;
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
        let mut axis = Axis::z(&joint.frame);
        let mut axes = Axes::new(self.arm);
        let beginning = match self.convention {
            Convention::Modified => {
                axes.start(carrier, Axis::z(carrier), None);
                axes.lead_to(axis, Some(joint));
                axes.without_first()
            }
            Convention::Standard => {
                if joint.slides() {
                    axis.point = carrier.origin.clone();
                }
                let beginning = start(self.convention, carrier, &axis);
                axes.start(&beginning, axis, Some(joint));
                beginning
            }
        };
        let at = carrier.inverse().then(&beginning).tidy();
        self.follow(axes, &beginning, first, has_end)?;
        if !is_same(&at, &Transform::identity()) {
            self.begin(first, &at);
        }
        Some(())
    }

    /// The rows of a joint, to which `axes` lead from a frame, and of the first joint on each link behind it.
    fn follow(
        &mut self,
        mut axes: Axes<'a>,
        start: &Transform,
        first: usize,
        has_end: bool,
    ) -> Option<()> {
        let arm = self.arm;
        let mut joints = vec![first];
        while let Some(next) = arm.children(joints.last().copied()).next() {
            axes.lead_to(Axis::z(&arm.joints[next].frame), Some(&arm.joints[next]));
            joints.push(next);
        }
        let last = joints[joints.len() - 1];
        let tip = arm.tip.as_ref().filter(|tip| tip.on == Some(last));
        let tip = tip.map(|tip| &tip.frame);
        if let Some(tip) = tip.filter(|_| has_end) {
            axes.lead_to(Axis::z(tip), None);
        }
        let frames = axes.frames(self.convention, start, tip);
        // Rows that stand still belong to the joint behind them, and at the end to the last one.
        let (mut joints, mut still) = (joints.into_iter(), Vec::new());
        for (line, pair) in axes.rows.iter().zip(frames.windows(2)) {
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
        for (joint, mut joint_rows) in arm.joints.iter().zip(self.rows) {
            let above = rows.len().checked_sub(1);
            let parent = joint.parent.map(|parent| ends[parent]);
            if parent != above {
                joint_rows[0].on = parent.map_or(Carrier::Base, Carrier::Row);
            }
            rows.append(&mut joint_rows);
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
    let steps = Parameters::from_step(convention, &step).in_steps(convention);
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
