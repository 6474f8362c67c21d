//! All axes of an arm: those of its joints, and those that follow them.

use robot_dynamics::nalgebra::{DVector, Matrix4};
use robot_dynamics::{
    Scalar,
    table::{Convention, Frame, JointMotion, JointType, Row, RuntimeTable},
};

/// An axis at `factor * q + offset`, q the position of its joint.
#[derive(Clone, Copy)]
pub(super) struct Axis {
    pub(super) row: Row,
    pub(super) joint: usize,
    /// The place of its joint among the degrees of freedom.
    pub(super) freedom: usize,
    pub(super) factor: f64,
    pub(super) offset: f64,
    /// Whether it is that of the joint itself.
    pub(super) is_free: bool,
}

impl Axis {
    /// Where it is.
    pub(super) fn position<T: Scalar>(&self, q: &DVector<T>) -> T {
        T::from_f64(self.factor) * q[self.joint] + T::from_f64(self.offset)
    }

    /// How fast it moves.
    pub(super) fn speed(&self, qd: &DVector<f64>) -> f64 {
        self.factor * qd[self.freedom]
    }
}

/// From the base outwards.
pub(super) fn axes(table: &RuntimeTable) -> Vec<Axis> {
    let mut axes = Vec::new();
    let of_base = table.floating.map_or(0, |_| 6);
    for joint in 0..=table.rows.len() {
        let followers = table.followers();
        let here = followers.filter(|follower| follower.place == joint);
        axes.extend(here.map(|follower| Axis {
            row: follower.row,
            joint: follower.leader,
            freedom: of_base + follower.leader,
            factor: follower.factor,
            offset: follower.offset,
            is_free: false,
        }));
        axes.extend(table.rows.get(joint).map(|row| Axis {
            row: *row,
            joint,
            freedom: of_base + joint,
            factor: 1.0,
            offset: 0.0,
            is_free: true,
        }));
    }
    axes
}

/// The table of an arm with these axes, which move as those of `table` do.
pub(super) fn with_axes(table: &RuntimeTable, axes: &[Axis]) -> RuntimeTable {
    let rows: Vec<Row> = axes.iter().map(|axis| axis.row).collect();
    let row_of = |joint: usize| {
        let mut places = axes.iter();
        places.position(|axis| axis.is_free && axis.joint == joint)
    };
    let motion = |axis: &Axis| match axis.is_free {
        true => JointMotion::Free,
        false => JointMotion::Follows {
            leader: row_of(axis.joint).expect("a joint"),
            factor: axis.factor,
            offset: axis.offset,
        },
    };
    let motions: Vec<JointMotion> = axes.iter().map(motion).collect();
    let mut moving = RuntimeTable::couple(table.convention, table.gravity, &rows, &motions);
    (moving.base, moving.tool) = (table.base, table.tool);
    moving
}

/// A homogeneous transform in any arithmetic.
pub(super) type Pose<T> = Matrix4<T>;

/// Rotation by an angle about an axis of the frame, and displacement along it.
fn screw<T: Scalar>(axis: usize, angle: T, along: T) -> Pose<T> {
    let number = |x: f64| T::from_f64(x);
    let mut pose = Pose::from_fn(|i, j| number(f64::from(u8::from(i == j))));
    let (s, c) = angle.sin_cos();
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    (pose[(j, j)], pose[(j, k)]) = (c, -s);
    (pose[(k, j)], pose[(k, k)]) = (s, c);
    pose[(axis, 3)] = along;
    pose
}

/// The frame that `next` describes in the one of `pose`.
fn then<T: Scalar>(pose: &Pose<T>, next: &Pose<T>) -> Pose<T> {
    let entry = |i: usize, j: usize| {
        let terms = (0..4).map(|k| pose[(i, k)] * next[(k, j)]);
        terms.fold(T::from_f64(0.0), |sum, term| sum + term)
    };
    Pose::from_fn(entry)
}

/// `T(xyz) Rz(yaw) Ry(pitch) Rx(roll)`.
pub(super) fn placed<T: Scalar>(frame: &Frame) -> Pose<T> {
    let zero = T::from_f64(0.0);
    let turns = [2, 1, 0].map(|axis| screw(axis, T::from_f64(frame.rpy[axis]), zero));
    let mut pose = then(&then(&turns[0], &turns[1]), &turns[2]);
    for (k, x) in frame.xyz.iter().enumerate() {
        pose[(k, 3)] = T::from_f64(*x);
    }
    pose
}

/// `Rz(theta) Tz(d) Tx(a) Rx(alpha)` or `Rx(alpha) Tx(a) Rz(theta) Tz(d)`.
fn transform<T: Scalar>(convention: Convention, row: &Row, q: T) -> Pose<T> {
    let [a, alpha, d, theta] = [row.a, row.alpha, row.d, row.theta].map(T::from_f64);
    let joint = match row.joint_type {
        JointType::Revolute => screw(2, theta + q, d),
        JointType::Prismatic => screw(2, theta, d + q),
    };
    let link = screw(0, alpha, a);
    match convention {
        Convention::Standard => then(&joint, &link),
        Convention::Modified => then(&link, &joint),
    }
}

/// The link frames of all axes: the products of the table's transforms.
pub(super) fn poses<T: Scalar>(table: &RuntimeTable, q: &DVector<T>) -> Vec<Pose<T>> {
    let mut pose = placed(&table.base);
    let links = axes(table).into_iter().map(|axis| {
        pose = then(
            &pose,
            &transform(table.convention, &axis.row, axis.position(q)),
        );
        pose
    });
    links.collect()
}

/// The links' frames as the arm has them, and those of its followers by the table.
pub(super) fn with_followers<T: Scalar>(
    table: &RuntimeTable,
    q: &DVector<T>,
    of_joints: &[Pose<T>],
) -> Vec<Pose<T>> {
    let poses = axes(table).into_iter().zip(poses(table, q));
    let poses = poses.map(|(axis, pose)| match axis.is_free {
        true => of_joints[axis.joint],
        false => pose,
    });
    poses.collect()
}
