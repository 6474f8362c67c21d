//! Poses of the link frames of the table, and the geometric Jacobian.

use super::symbols::Symbols;
use crate::expr::Expr;
use crate::linear::{Matrix3, Vector3};
use crate::robot::{Convention, Interpretation, JointType, Robot};

/// A link frame, and the axis of its joint, in the base.
pub(super) struct Frame<'g> {
    /// Axes of the link frame in the base, by columns.
    pub(super) rotation: Matrix3<Expr<'g>>,
    /// Origin of the link frame in the base.
    pub(super) origin: Vector3<Expr<'g>>,
    /// Direction of the joint's axis in the base.
    pub(super) axis: Vector3<Expr<'g>>,
    /// A point of the joint's axis in the base.
    pub(super) axis_origin: Vector3<Expr<'g>>,
}

/// The orientation that is reached so far: the columns are the axes.
struct Axes<'g> {
    x: Vector3<Expr<'g>>,
    y: Vector3<Expr<'g>>,
    z: Vector3<Expr<'g>>,
    origin: Vector3<Expr<'g>>,
}

impl<'g> Axes<'g> {
    /// Tx(a) Rx(alpha)
    fn screw_x(self, a: Expr<'g>, (s, c): (Expr<'g>, Expr<'g>)) -> Self {
        Axes {
            x: self.x,
            y: self.y * c + self.z * s,
            z: self.z * c - self.y * s,
            origin: self.origin + self.x * a,
        }
    }

    /// Tz(d) Rz(theta)
    fn screw_z(self, d: Expr<'g>, (s, c): (Expr<'g>, Expr<'g>)) -> Self {
        Axes {
            x: self.x * c + self.y * s,
            y: self.y * c - self.x * s,
            z: self.z,
            origin: self.origin + self.z * d,
        }
    }
}

/// Every link frame, from the base outwards.
pub(super) fn frames<'g>(symbols: &mut Symbols<'g>, robot: &Robot) -> Vec<Frame<'g>> {
    let (zero, one) = (symbols.graph().zero(), symbols.graph().one());
    let mut axes = Axes {
        x: Vector3::new(one, zero, zero),
        y: Vector3::new(zero, one, zero),
        z: Vector3::new(zero, zero, one),
        origin: Vector3::splat(zero),
    };
    let mut frames = Vec::with_capacity(robot.rows.len());
    for (i, row) in robot.rows.iter().enumerate() {
        let (a, twist) = (symbols.value(&row.a), symbols.sin_cos(&row.alpha));
        let turn = symbols.joint_sin_cos(i, row.joint_type, &row.theta);
        let d = symbols.value(&row.d);
        let d = match row.joint_type {
            JointType::Revolute => d,
            JointType::Prismatic => d + symbols.joint(i).q,
        };
        let (axis, axis_origin);
        axes = match robot.convention {
            Convention::Standard => {
                (axis, axis_origin) = (axes.z, axes.origin);
                axes.screw_z(d, turn).screw_x(a, twist)
            }
            Convention::Modified => {
                let axes = axes.screw_x(a, twist).screw_z(d, turn);
                (axis, axis_origin) = (axes.z, axes.origin);
                axes
            }
        };
        let rows = Matrix3([axes.x.0, axes.y.0, axes.z.0]);
        frames.push(Frame {
            rotation: rows.transpose(),
            origin: axes.origin,
            axis,
            axis_origin,
        });
    }
    frames
}

impl<'g> Frame<'g> {
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

/// The geometric Jacobian of the last frame's origin by rows: vx vy vz wx wy wz.
///
/// Columns (z x (p - o), z) for a revolute joint, (z, 0) for a prismatic one.
pub(super) fn jacobian<'g>(symbols: &mut Symbols<'g>, robot: &Robot) -> Vec<Expr<'g>> {
    let zero = symbols.graph().zero();
    let frames = frames(symbols, robot);
    let Some(tip) = frames.last().map(|frame| frame.origin) else {
        return Vec::new();
    };
    let columns: Vec<_> = frames
        .iter()
        .zip(&robot.rows)
        .map(|(frame, row)| match row.joint_type {
            JointType::Revolute => (frame.axis.cross(tip - frame.axis_origin), frame.axis),
            JointType::Prismatic => (frame.axis, Vector3::splat(zero)),
        })
        .collect();
    let linear = (0..3).flat_map(|k| columns.iter().map(move |column| column.0[k]));
    let angular = (0..3).flat_map(|k| columns.iter().map(move |column| column.1[k]));
    linear.chain(angular).collect()
}
