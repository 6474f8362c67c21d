//! Poses of the link frames of the table and of the tip, and the geometric Jacobian.

use super::place::{self, place};
use super::symbols::Symbols;
use crate::expr::Expr;
use crate::linear::{Matrix3, Vector3};
use crate::mechanism::{Mechanism, Origin};
use crate::robot::{Interpretation, JointType};
use crate::spatial::{Axis, Place, Turn, Turns};

/// A frame in the world, which is the base frame where the table says nothing else.
#[derive(Clone, Copy)]
pub(super) struct Pose<'g> {
    /// The frame's axes, by columns.
    pub(super) rotation: Matrix3<Expr<'g>>,
    /// The frame's origin.
    pub(super) origin: Vector3<Expr<'g>>,
}

/// A link frame, and the axis of its joint, in the world.
pub(super) struct Frame<'g> {
    /// The link frame.
    pub(super) pose: Pose<'g>,
    /// Direction of the joint's axis.
    pub(super) axis: Vector3<Expr<'g>>,
    /// A point of the joint's axis.
    pub(super) axis_origin: Vector3<Expr<'g>>,
}

/// A column of a Jacobian: linear and angular velocity.
pub(super) type Column<'g> = (Vector3<Expr<'g>>, Vector3<Expr<'g>>);

/// The frame that is reached so far.
#[derive(Clone)]
pub(super) struct Axes<'g> {
    /// Its axes x, y and z.
    pub(super) columns: [Vector3<Expr<'g>>; 3],
    origin: Vector3<Expr<'g>>,
}

impl<'g> Axes<'g> {
    pub(super) fn new(pose: &Pose<'g>) -> Self {
        Axes {
            columns: [0, 1, 2].map(|j| pose.rotation.column(j)),
            origin: pose.origin,
        }
    }

    fn pose(&self) -> Pose<'g> {
        let rows = Matrix3(self.columns.map(|column| column.0));
        Pose {
            rotation: rows.transpose(),
            origin: self.origin,
        }
    }

    /// Turned about one of its axes.
    pub(super) fn turned(mut self, axis: Axis, turn: Turn<Expr<'g>>) -> Self {
        let [_, i, j] = axis.indices();
        let [u, v] = [self.columns[i], self.columns[j]];
        self.columns[i] = u * turn.c + v * turn.s;
        self.columns[j] = v * turn.c - u * turn.s;
        self
    }

    /// Turned about one of its axes after the other.
    pub(super) fn turned_by(self, turns: &Turns<Expr<'g>>) -> Self {
        let turns = turns.0.iter();
        turns.fold(self, |axes, (axis, turn)| axes.turned(*axis, *turn))
    }

    /// The frame that is placed in this one.
    fn then(mut self, place: &Place<Expr<'g>>) -> Self {
        for (column, step) in self.columns.iter().zip(place.origin.0) {
            self.origin = self.origin + *column * step;
        }
        self.turned_by(&place.turns)
    }
}

/// Frame 0.
pub(super) fn base<'g>(symbols: &mut Symbols<'g>) -> Pose<'g> {
    let (zero, one) = (symbols.graph().zero(), symbols.graph().one());
    let world = Pose {
        rotation: Matrix3([[one, zero, zero], [zero, one, zero], [zero, zero, one]]),
        origin: Vector3::splat(zero),
    };
    match place::base(symbols, symbols.arm()) {
        Some(base) => placed(symbols, &world, &base),
        None => world,
    }
}

/// The frame that is placed in another one.
fn placed<'g>(symbols: &Symbols<'g>, frame: &Pose<'g>, place: &Place<Expr<'g>>) -> Pose<'g> {
    let (zero, one) = (symbols.graph().zero(), symbols.graph().one());
    // The place is multiplied out first: where it is known in numbers, it is a matrix of constants.
    let axes = [[one, zero, zero], [zero, one, zero], [zero, zero, one]]
        .map(|axis| frame.rotation.apply(place.turns.leave(Vector3(axis))).0);
    Pose {
        rotation: Matrix3(axes).transpose(),
        origin: frame.origin + frame.rotation.apply(place.origin),
    }
}

/// The frame whose motion is that of the tip: the tool's, or else the last one of `frames`, which are
/// those of all links.
pub(super) fn tip<'g>(symbols: &mut Symbols<'g>, frames: &[Frame<'g>]) -> Pose<'g> {
    let last = match symbols.arm().tip {
        Some(link) => frames[link].pose,
        None => base(symbols),
    };
    match &symbols.arm().tip_frame[..] {
        [] => last,
        frames => {
            let tip = place(symbols, frames);
            placed(symbols, &last, &tip)
        }
    }
}

/// Every link frame.
pub(super) fn frames<'g>(symbols: &mut Symbols<'g>) -> Vec<Frame<'g>> {
    let arm = symbols.arm();
    let base = Axes::new(&base(symbols));
    let mut frames = Vec::with_capacity(arm.joints.len());
    arm.tree.outward(base, |i, before| {
        let joint = &arm.joints[i];
        // The cells in the order of the table.
        let aligned = &joint.aligned;
        let behind = place(symbols, &[&aligned.own[..], &joint.link_frame].concat());
        let foot = before.clone().then(&place(symbols, &aligned.before));
        let turn = symbols.turn(i);
        let d = symbols.value(&aligned.d);
        let d = match joint.joint_type {
            JointType::Revolute => d,
            JointType::Prismatic => d + symbols.joint(i).q,
        };
        let foot_origin = foot.origin;
        let mut axes = foot.turned(Axis::Z, turn);
        axes.origin = axes.origin + axes.columns[2] * d;
        let axis_origin = match joint.origin {
            Origin::BeforeOffset => foot_origin,
            Origin::AfterOffset => axes.origin,
        };
        let pose = match &behind.turns.0[..] {
            [] | [_] => axes.clone().then(&behind).pose(),
            _ => placed(symbols, &axes.pose(), &behind),
        };
        frames.push(Frame {
            pose,
            axis: axes.columns[2],
            axis_origin,
        });
        axes
    });
    frames
}

impl<'g> Pose<'g> {
    /// The homogeneous transform, by rows.
    pub(super) fn homogeneous(&self, zero: Expr<'g>, one: Expr<'g>) -> Vec<Expr<'g>> {
        let rows = self.rotation.0.iter().zip(&self.origin.0);
        let mut entries: Vec<_> = rows
            .flat_map(|(row, &x)| [row[0], row[1], row[2], x])
            .collect();
        entries.extend([zero, zero, zero, one]);
        entries
    }
}

/// The geometric Jacobian of the tip's origin by rows: vx vy vz wx wy wz.
///
/// Columns (z x (p - o), z) for a revolute joint, (z, 0) for a prismatic one.
pub(super) fn jacobian<'g>(symbols: &mut Symbols<'g>) -> Vec<Expr<'g>> {
    let zero = symbols.graph().zero();
    let frames = frames(symbols);
    let tip = tip(symbols, &frames).origin;
    by_rows(&columns(
        symbols.arm(),
        &frames,
        symbols.arm().tip,
        (tip, zero),
    ))
}

/// What each joint gives a point of a link at unit speed: its velocity, and the angular velocity of the link.
pub(super) fn columns<'g>(
    arm: &Mechanism,
    frames: &[Frame<'g>],
    link: Option<usize>,
    (point, zero): (Vector3<Expr<'g>>, Expr<'g>),
) -> Vec<Column<'g>> {
    let none = Vector3::splat(zero);
    let carriers: Vec<_> = arm.tree.carriers_of(link).collect();
    let mut columns = vec![(none, none); frames.len()];
    for &i in carriers.iter().rev() {
        let frame = &frames[i];
        columns[i] = match arm.joints[i].joint_type {
            JointType::Revolute => (frame.axis.cross(point - frame.axis_origin), frame.axis),
            JointType::Prismatic => (frame.axis, none),
        };
    }
    columns
}

/// The six rows of a Jacobian.
pub(super) fn by_rows<'g>(columns: &[Column<'g>]) -> Vec<Expr<'g>> {
    let linear = (0..3).flat_map(|k| columns.iter().map(move |column| column.0[k]));
    let angular = (0..3).flat_map(|k| columns.iter().map(move |column| column.1[k]));
    linear.chain(angular).collect()
}
