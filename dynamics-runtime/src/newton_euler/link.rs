//! A link in the frame that the recursion works in: origin and z on the axis of its own joint.

use nalgebra::{Matrix3, Vector3};

use super::angle::SinCos;
use super::inertia::Inertia;
use super::joint::Joint;
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
    fn along_x(alpha: SinCos, a: f64) -> Self {
        Joint::new(alpha, a, SinCos::ZERO, 0.0).pose()
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
    pub(super) tensor: Matrix3<f64>,
    /// All three about the frame's origin.
    pub(super) inertia: Inertia,
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
        let tensor = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        let com = position + rotation * Vector3::from(row.com);
        let tensor = rotation * tensor * rotation.transpose();
        Link {
            joint_type: row.joint_type,
            alpha,
            a,
            d: row.d,
            theta: SinCos::of_constant(row.theta),
            mass: row.mass,
            com,
            tensor,
            inertia: Inertia::new(row.mass, &com, &tensor),
            reflected_inertia: row.reflected_inertia(),
            viscous: row.viscous,
            coulomb: row.coulomb,
            table_frame,
        }
    }

    /// The joint at position `q`, of which the sine and cosine are `turned`.
    #[inline(always)]
    pub(super) fn joint(&self, q: f64, turned: SinCos) -> Joint {
        match self.joint_type {
            JointType::Revolute => Joint::new(self.alpha, self.a, turned.plus(self.theta), self.d),
            JointType::Prismatic => Joint::new(self.alpha, self.a, self.theta, self.d + q),
        }
    }
}
