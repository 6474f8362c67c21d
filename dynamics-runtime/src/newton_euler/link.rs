//! A link in the frame that the recursion works in: origin and z on the axis of its own joint.

use nalgebra::{Matrix3, Vector3};

use super::angle::SinCos;
use crate::{JointType, Row};

/// Rotation and position of one frame in another.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pose {
    pub(super) rotation: Matrix3<f64>,
    pub(super) position: Vector3<f64>,
}

impl Pose {
    /// A frame that is the other frame.
    pub(super) fn identity() -> Self {
        Pose {
            rotation: Matrix3::identity(),
            position: Vector3::zeros(),
        }
    }

    /// `Rx(alpha) Tx(a)`; the two commute.
    pub(super) fn along_x(alpha: SinCos, a: f64) -> Self {
        Pose::craig(alpha, a, SinCos::ZERO, 0.0)
    }

    /// `Rx(alpha) Tx(a) Rz(theta) Tz(d)`: Craig (3.6).
    pub(super) fn craig(alpha: SinCos, a: f64, theta: SinCos, d: f64) -> Self {
        let (sa, ca, st, ct) = (alpha.sin, alpha.cos, theta.sin, theta.cos);
        #[rustfmt::skip]
        let rotation = Matrix3::new(
            ct,      -st,      0.0,
            st * ca, ct * ca, -sa,
            st * sa, ct * sa,  ca,
        );
        let position = Vector3::new(a, -sa * d, ca * d);
        Pose { rotation, position }
    }

    /// The frame that `next` describes in this one, in the frame that this one is described in.
    pub(super) fn then(&self, next: &Pose) -> Pose {
        Pose {
            rotation: self.rotation * next.rotation,
            position: self.rotation * next.position + self.position,
        }
    }
}

/// A joint and the link that it moves, in Craig's frames: frame i has its z on the axis of joint i.
#[derive(Clone, Debug)]
pub(super) struct Link {
    pub(super) joint_type: JointType,
    /// alpha_{i-1}.
    alpha: SinCos,
    /// a_{i-1}.
    a: f64,
    d: f64,
    theta: SinCos,
    pub(super) mass: f64,
    pub(super) com: Vector3<f64>,
    /// About the centre of mass.
    pub(super) inertia: Matrix3<f64>,
    pub(super) reflected_inertia: f64,
    pub(super) viscous: f64,
    pub(super) coulomb: f64,
    /// The link frame of the table in this frame.
    pub(super) table_frame: Pose,
}

impl Link {
    /// A row of a modified table: it is in these frames as it stands.
    pub(super) fn modified(row: &Row) -> Self {
        Link::new(SinCos::of_constant(row.alpha), row.a, row, Pose::identity())
    }

    /// A row of a standard table and the row before it.
    ///
    /// The chain `Rz(theta_1) Tz(d_1) Tx(a_1) Rx(alpha_1) Rz(theta_2) ...` is split before each
    /// rotation about z instead of after each rotation about x. So row i takes a and alpha from row
    /// i-1 (from the first on: none), and the table's link frame is `Tx(a_i) Rx(alpha_i)` in the
    /// frame of the joint.
    pub(super) fn standard(before: Option<&Row>, row: &Row) -> Self {
        let (alpha, a) = before.map_or((SinCos::ZERO, 0.0), |before| {
            (SinCos::of_constant(before.alpha), before.a)
        });
        let table_frame = Pose::along_x(SinCos::of_constant(row.alpha), row.a);
        Link::new(alpha, a, row, table_frame)
    }

    /// Mass properties move from the table's frame to the joint's: c' = p + R c, I' = R I R^T.
    fn new(alpha: SinCos, a: f64, row: &Row, table_frame: Pose) -> Self {
        let Pose { rotation, position } = table_frame;
        let [xx, yy, zz, xy, yz, xz] = row.inertia;
        let inertia = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        Link {
            joint_type: row.joint_type,
            alpha,
            a,
            d: row.d,
            theta: SinCos::of_constant(row.theta),
            mass: row.mass,
            com: position + rotation * Vector3::from(row.com),
            inertia: rotation * inertia * rotation.transpose(),
            reflected_inertia: row.reflected_inertia(),
            viscous: row.viscous,
            coulomb: row.coulomb,
            table_frame,
        }
    }

    /// The link at joint position zero where it was at `turn` (revolute) or `distance` (prismatic).
    pub(super) fn displaced(&self, turn: SinCos, distance: f64) -> Self {
        match self.joint_type {
            JointType::Revolute => Link {
                theta: self.theta.plus(turn),
                ..self.clone()
            },
            JointType::Prismatic => Link {
                d: self.d + distance,
                ..self.clone()
            },
        }
    }

    /// Frame i in frame i-1 at joint position `q`.
    pub(super) fn pose(&self, q: f64) -> Pose {
        match self.joint_type {
            JointType::Revolute => {
                let theta = SinCos::of_joint(q).plus(self.theta);
                Pose::craig(self.alpha, self.a, theta, self.d)
            }
            JointType::Prismatic => Pose::craig(self.alpha, self.a, self.theta, self.d + q),
        }
    }
}
