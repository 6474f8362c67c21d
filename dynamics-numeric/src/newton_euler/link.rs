//! A link in the frame that the recursion works in: origin and z on the axis of its own joint.

use dynamics_runtime::internal::geometry::{Joint, Pose, SinCos};
use dynamics_runtime::internal::{DryFriction, Moving};
use dynamics_runtime::table::Arm;
use dynamics_runtime::{Convention, JointType, Placement, Row, Spring};
use nalgebra::Vector3;

use super::inertia::Solid;

/// A joint and the link that it moves, in Craig's frames: frame i has its z on the axis of joint i.
#[derive(Clone, Copy, Debug)]
pub struct Link {
    pub(super) joint_type: JointType,
    /// alpha_{i-1}.
    alpha: SinCos,
    /// a_{i-1}.
    a: f64,
    pub(super) d: f64,
    pub(super) theta: SinCos,
    /// The place before alpha and a, if the row does not begin at the frame of the carrying link.
    mount: Option<Mount>,
    pub(super) solid: Solid,
    pub(super) reflected_inertia: f64,
    pub(super) viscous: f64,
    pub(super) dry: DryFriction,
    pub(super) spring: Spring,
    /// The link frame of the table in this frame.
    pub(super) table_frame: Pose,
    /// The tip in this frame, of the link that carries it.
    pub(super) tip: Pose,
    /// The link that carries this one; none for a link on the base.
    pub(super) carrier: Option<usize>,
    /// The joint of q with which this one moves, and how far for each unit of that joint.
    pub(super) joint: usize,
    pub(super) factor: f64,
    /// Whether the joint follows another one.
    pub(super) is_follower: bool,
}

/// Frame i in frame i-1 where nothing is known of it: `Rz(before) Rx(alpha) Rz(theta)` at a place.
#[derive(Clone, Copy, Debug)]
struct Mount {
    before: SinCos,
    origin: Vector3<f64>,
}

impl Link {
    /// No link, whose place another one takes.
    pub(super) const NONE: Link = Link {
        joint_type: JointType::Prismatic,
        alpha: SinCos::ZERO,
        a: 0.0,
        d: 0.0,
        theta: SinCos::ZERO,
        mount: None,
        solid: Solid::NONE,
        reflected_inertia: 0.0,
        viscous: 0.0,
        dry: DryFriction::NONE,
        spring: Spring::NONE,
        table_frame: Pose::IDENTITY,
        tip: Pose::IDENTITY,
        carrier: None,
        joint: 0,
        factor: 1.0,
        is_follower: false,
    };

    /// The links of a robot from the base outwards, the tool and the bodies of frames parts of the links that carry them.
    /// Standard rows are converted to frames on the joints' own axes.
    pub(super) fn all(arm: Arm<'_>) -> impl Iterator<Item = Link> {
        arm.chain().enumerate().map(move |(k, moving)| {
            let carrier = moving.row.on.of(k);
            let row = arm.with_bodies(k, moving.row);
            let link = match arm.convention {
                Convention::Modified => Link::modified(&row),
                Convention::Standard => {
                    let before = carrier.and_then(|carrier| arm.chain().nth(carrier));
                    Link::standard(before.map(|before| before.row), &row)
                }
            };
            link.moving(carrier, &moving)
        })
    }

    /// A row of a modified table: it is in these frames as it stands.
    fn modified(row: &Row) -> Self {
        let screw_x = Joint::along_x(SinCos::of_constant(row.alpha), row.a);
        let link_frame = Pose::from(&row.link_frame);
        Link::new(SinCos::of_constant(row.alpha), row.a, row, link_frame)
            .mounted(&row.mount, |mount| mount.then(&screw_x))
    }

    /// A row of a standard table, and the row of the link that carries it.
    ///
    /// The chain `Rz(theta_1) Tz(d_1) Tx(a_1) Rx(alpha_1) Rz(theta_2) ...` is split before each
    /// rotation about z instead of after each rotation about x. So a row takes a and alpha from the row
    /// that carries it (on the base: none), and the table's link frame is `Tx(a_i) Rx(alpha_i)` in the
    /// frame of the joint.
    fn standard(before: Option<&Row>, row: &Row) -> Self {
        let (alpha, a) = before.map_or((SinCos::ZERO, 0.0), |before| {
            (SinCos::of_constant(before.alpha), before.a)
        });
        let table_frame = Joint::along_x(SinCos::of_constant(row.alpha), row.a);
        let screw_x = Joint::along_x(alpha, a);
        Link::new(alpha, a, row, table_frame).mounted(&row.mount, |mount| screw_x.then(mount))
    }

    /// The link where its row begins elsewhere than at the frame before: `place` says where the
    /// factors `Rz(theta) Tz(d)` begin then.
    ///
    /// Every rotation is Rz(psi) Rx(phi) Rz(chi). Chi is taken from what the two others leave, so
    /// that psi may be anything where phi is next to zero.
    fn mounted(self, mount: &Placement, place: impl Fn(&Pose) -> Pose) -> Self {
        if *mount == Placement::IDENTITY {
            return self;
        }
        let Pose { rotation, position } = place(&mount.into());
        let (x, y, z) = (rotation.m13, -rotation.m23, rotation.m33);
        let sine = libm::hypot(x, y);
        let before = if sine == 0.0 {
            SinCos::ZERO
        } else {
            SinCos {
                sin: x / sine,
                cos: y / sine,
            }
        };
        let alpha = SinCos { sin: sine, cos: z };
        let turned = Joint::new(alpha, 0.0, SinCos::ZERO, 0.0).behind(before);
        let chi = turned.pose().rotation.transpose() * rotation;
        let rest = SinCos {
            sin: chi.m21,
            cos: chi.m11,
        };
        Link {
            alpha,
            a: 0.0,
            theta: rest.plus(self.theta),
            mount: Some(Mount {
                before,
                origin: position,
            }),
            ..self
        }
    }

    /// Mass properties move from the table's frame to the joint's.
    fn new(alpha: SinCos, a: f64, row: &Row, table_frame: Pose) -> Self {
        Link {
            joint_type: row.joint_type,
            alpha,
            a,
            d: row.d,
            theta: SinCos::of_constant(row.theta),
            mount: None,
            solid: Solid::new(row, &table_frame),
            reflected_inertia: row.reflected_inertia(),
            viscous: row.viscous,
            dry: DryFriction::of(row),
            spring: row.spring,
            table_frame,
            tip: table_frame.then(&row.tip_in_link()),
            carrier: None,
            joint: 0,
            factor: 1.0,
            is_follower: false,
        }
    }

    /// The link with its joint's law of motion. The offset becomes a part of the link.
    fn moving(self, carrier: Option<usize>, moving: &Moving<'_>) -> Self {
        let (theta, d) = match self.joint_type {
            JointType::Revolute => (self.theta.plus(SinCos::of_constant(moving.offset)), self.d),
            JointType::Prismatic => (self.theta, self.d + moving.offset),
        };
        let rest = self.spring.rest - moving.offset;
        Link {
            theta,
            d,
            spring: Spring {
                rest,
                ..self.spring
            },
            carrier,
            joint: moving.joint,
            factor: moving.factor,
            is_follower: moving.is_follower,
            ..self
        }
    }

    /// The torque or force of friction at a velocity.
    #[inline(always)]
    pub(super) fn friction(&self, qd: f64) -> f64 {
        self.viscous * qd + self.dry.force(qd)
    }

    /// The joint at position `q`, of which the sine and cosine are `turned`.
    #[inline(always)]
    pub(super) fn joint(&self, q: f64, turned: SinCos) -> Joint {
        let joint = match self.joint_type {
            JointType::Revolute => Joint::new(self.alpha, self.a, turned.plus(self.theta), self.d),
            JointType::Prismatic => Joint::new(self.alpha, self.a, self.theta, self.d + q),
        };
        match &self.mount {
            None => joint,
            Some(mount) => joint.behind(mount.before).at(&mount.origin),
        }
    }
}
