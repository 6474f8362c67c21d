//! Poses of the link frames of the table and of the tip, and the geometric Jacobian.

use super::place::Placed;
use super::symbols::Symbols;
use crate::expr::Expr;
use crate::linear::{Matrix3, Vector3};
use crate::mechanism::{Mechanism, Origin, Screw};
use crate::robot::{Interpretation, JointType, Placement};
use crate::spatial::Turn;

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

/// The orientation that is reached so far: the columns are the axes.
pub(super) struct Axes<'g> {
    pub(super) x: Vector3<Expr<'g>>,
    pub(super) y: Vector3<Expr<'g>>,
    pub(super) z: Vector3<Expr<'g>>,
    origin: Vector3<Expr<'g>>,
}

impl<'g> Axes<'g> {
    pub(super) fn new(pose: &Pose<'g>) -> Self {
        let [x, y, z] = [0, 1, 2].map(|j| pose.rotation.column(j));
        Axes {
            x,
            y,
            z,
            origin: pose.origin,
        }
    }

    fn pose(&self) -> Pose<'g> {
        let rows = Matrix3([self.x.0, self.y.0, self.z.0]);
        Pose {
            rotation: rows.transpose(),
            origin: self.origin,
        }
    }

    /// Tx(a) Rx(alpha)
    pub(super) fn screw_x(&self, a: Expr<'g>, (s, c): (Expr<'g>, Expr<'g>)) -> Self {
        Axes {
            x: self.x,
            y: self.y * c + self.z * s,
            z: self.z * c - self.y * s,
            origin: self.origin + self.x * a,
        }
    }

    /// Tz(d) Rz(theta)
    pub(super) fn screw_z(&self, d: Expr<'g>, (s, c): (Expr<'g>, Expr<'g>)) -> Self {
        Axes {
            x: self.x * c + self.y * s,
            y: self.y * c - self.x * s,
            z: self.z,
            origin: self.origin + self.z * d,
        }
    }
}

/// Frame 0.
pub(super) fn base<'g>(symbols: &mut Symbols<'g>) -> Pose<'g> {
    let (zero, one) = (symbols.graph().zero(), symbols.graph().one());
    let world = Pose {
        rotation: Matrix3([[one, zero, zero], [zero, one, zero], [zero, zero, one]]),
        origin: Vector3::splat(zero),
    };
    match &symbols.arm().base {
        Some(base) => placed(symbols, &world, base),
        None => world,
    }
}

/// The frame that is placed in another one.
fn placed<'g>(symbols: &mut Symbols<'g>, frame: &Pose<'g>, placement: &Placement) -> Pose<'g> {
    let (zero, one) = (symbols.graph().zero(), symbols.graph().one());
    let place = Placed::new(symbols, placement);
    // The place is multiplied out first: where it is known in numbers, it is a matrix of constants.
    let axes = [[one, zero, zero], [zero, one, zero], [zero, zero, one]]
        .map(|axis| frame.rotation.apply(place.leave(Vector3(axis))).0);
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
    match &symbols.arm().tool {
        Some(tool) => placed(symbols, &last, &tool.placement),
        None => last,
    }
}

/// Every link frame.
pub(super) fn frames<'g>(symbols: &mut Symbols<'g>) -> Vec<Frame<'g>> {
    let arm = symbols.arm();
    let base = Axes::new(&base(symbols));
    let mut frames = Vec::with_capacity(arm.joints.len());
    arm.tree.outward(base, |i, before| {
        let joint = &arm.joints[i];
        let mut screw = |screw: &Screw| (symbols.value(&screw.a), symbols.sin_cos(&screw.alpha));
        // The cells in the order of the table.
        let behind = joint.link_frame.screw().map(&mut screw);
        let (a, twist) = screw(&joint.before);
        let Turn { s, c } = symbols.turn(i);
        let d = symbols.value(&joint.d);
        let d = match joint.joint_type {
            JointType::Revolute => d,
            JointType::Prismatic => d + symbols.joint(i).q,
        };
        let foot = before.screw_x(a, twist);
        let axes = foot.screw_z(d, (s, c));
        let axis_origin = match joint.origin {
            Origin::BeforeOffset => foot.origin,
            Origin::AfterOffset => axes.origin,
        };
        let on_axis = behind.map_or(axes.pose(), |(a, twist)| axes.screw_x(a, twist).pose());
        let places = joint.link_frame.places().iter();
        let pose = places.fold(on_axis, |pose, place| placed(symbols, &pose, place));
        frames.push(Frame {
            pose,
            axis: axes.z,
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
