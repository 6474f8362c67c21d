//! Poses of the link frames of the table and of what is fixed to them, and the geometric Jacobian.

use super::place::{self, place};
use super::symbols::Symbols;
use crate::expr::Expr;
use crate::linear::{Matrix3, Vector3};
use crate::mechanism::{self, Mechanism, Origin};
use crate::robot::{Interpretation, Placement};
use crate::spatial::{Axis, AxisMotion, Place, Turn, Turns};

/// A frame in the world, which is the base frame where the table says nothing else.
#[derive(Clone, Copy)]
pub(super) struct Pose<'g> {
    /// The frame's axes x, y and z.
    pub(super) axes: [Vector3<Expr<'g>>; 3],
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

impl<'g> Pose<'g> {
    /// A vector of the frame, in the world.
    pub(super) fn leave(&self, v: Vector3<Expr<'g>>) -> Vector3<Expr<'g>> {
        let rows = Matrix3(self.axes.map(|axis| axis.0)).transpose();
        rows.apply(v)
    }

    /// Turned about one of its axes.
    pub(super) fn turned(mut self, axis: Axis, turn: Turn<Expr<'g>>) -> Self {
        let [_, i, j] = axis.indices();
        let [u, v] = [self.axes[i], self.axes[j]];
        self.axes[i] = u * turn.c + v * turn.s;
        self.axes[j] = v * turn.c - u * turn.s;
        self
    }

    /// Turned about one of its axes after the other.
    pub(super) fn turned_by(self, turns: &Turns<Expr<'g>>) -> Self {
        let turns = turns.0.iter();
        turns.fold(self, |pose, (axis, turn)| pose.turned(*axis, *turn))
    }

    /// The frame that is placed in this one.
    fn then(mut self, place: &Place<Expr<'g>>) -> Self {
        for (axis, step) in self.axes.iter().zip(place.origin.0) {
            self.origin = self.origin + *axis * step;
        }
        self.turned_by(&place.turns)
    }

    /// The same where the place is multiplied out first: if it is known in numbers, it is a matrix of constants.
    fn placed(&self, symbols: &Symbols<'g>, place: &Place<Expr<'g>>) -> Self {
        let axes = units(symbols).map(|axis| self.leave(place.turns.leave(axis)));
        Pose {
            axes,
            origin: self.origin + self.leave(place.origin),
        }
    }

    /// The homogeneous transform, by rows.
    pub(super) fn homogeneous(&self, zero: Expr<'g>, one: Expr<'g>) -> Vec<Expr<'g>> {
        let [x, y, z] = self.axes;
        let row = |k: usize| [x[k], y[k], z[k], self.origin[k]];
        let last = [zero, zero, zero, one];
        [row(0), row(1), row(2), last].concat()
    }
}

fn units<'g>(symbols: &Symbols<'g>) -> [Vector3<Expr<'g>>; 3] {
    let (zero, one) = (symbols.graph().zero(), symbols.graph().one());
    [[one, zero, zero], [zero, one, zero], [zero, zero, one]].map(Vector3)
}

/// Frame 0.
pub(super) fn base<'g>(symbols: &mut Symbols<'g>) -> Pose<'g> {
    let world = Pose {
        axes: units(symbols),
        origin: Vector3::splat(symbols.graph().zero()),
    };
    match place::base(symbols, symbols.arm()) {
        Some(base) => Pose {
            axes: units(symbols).map(|axis| base.leave(axis)),
            origin: base.origin,
        },
        None => world,
    }
}

/// A frame that is fixed to a link or to the base, by the `frames` of all links.
pub(super) fn fixed<'g>(
    symbols: &mut Symbols<'g>,
    frames: &[Frame<'g>],
    (link, places): (Option<usize>, &[Placement]),
) -> Pose<'g> {
    let link = match link {
        Some(link) => frames[link].pose,
        None => base(symbols),
    };
    if places.is_empty() {
        return link;
    }
    let in_link = place(symbols, places);
    link.placed(symbols, &in_link)
}

/// Every link frame.
pub(super) fn frames<'g>(symbols: &mut Symbols<'g>) -> Vec<Frame<'g>> {
    let arm = symbols.arm();
    let base = base(symbols);
    let mut frames = Vec::with_capacity(arm.joints.len());
    arm.tree.outward(base, |i, before| {
        let joint = &arm.joints[i];
        // The cells in the order of the table.
        let aligned = &joint.aligned;
        let behind = place(symbols, &[&aligned.own[..], &joint.link_frame].concat());
        let foot = before.then(&place(symbols, &aligned.before));
        let turn = symbols.turn(i);
        let d = symbols.value(&aligned.d);
        let d = match joint.axis_motion {
            AxisMotion::Turns => d,
            AxisMotion::Slides => d + symbols.joint(i).q,
        };
        let mut joint_frame = foot.turned(Axis::Z, turn);
        joint_frame.origin = joint_frame.origin + joint_frame.axes[2] * d;
        let axis_origin = match joint.origin {
            Origin::BeforeOffset => foot.origin,
            Origin::AfterOffset => joint_frame.origin,
        };
        let pose = match &behind.turns.0[..] {
            [] | [_] => joint_frame.then(&behind),
            _ => joint_frame.placed(symbols, &behind),
        };
        frames.push(Frame {
            pose,
            axis: joint_frame.axes[2],
            axis_origin,
        });
        joint_frame
    });
    frames
}

/// The geometric Jacobian of a frame's origin by rows: vx vy vz wx wy wz.
///
/// Columns (z x (p - o), z) for a revolute joint, (z, 0) for a prismatic one.
pub(super) fn jacobian<'g>(symbols: &mut Symbols<'g>, frame: &mechanism::Frame) -> Vec<Expr<'g>> {
    let zero = symbols.graph().zero();
    let frames = frames(symbols);
    let origin = fixed(symbols, &frames, frame.place()).origin;
    by_rows(&columns(symbols.arm(), &frames, frame.link, (origin, zero)))
}

/// The velocity that each joint gives a point of a link at unit speed, and the angular velocity of the link.
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
        columns[i] = match arm.joints[i].axis_motion {
            AxisMotion::Turns => (frame.axis.cross(point - frame.axis_origin), frame.axis),
            AxisMotion::Slides => (frame.axis, none),
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
