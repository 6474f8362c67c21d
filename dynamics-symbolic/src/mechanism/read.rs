//! From the rows of a table to a mechanism.

use super::{Aligned, FixedBody, Forces, Frame, Joint, Law, Mechanism, Origin, Tree};
use crate::robot::{Body, Convention, JointType, Placement, Robot, Row, Value};

impl From<&Robot> for Mechanism {
    fn from(robot: &Robot) -> Self {
        let rows = 0..robot.rows.len();
        let tree = Tree::new(rows.clone().map(|i| robot.parent(i)).collect());
        let (mut free, mut following) = (0.., robot.dof()..);
        let joints = rows.map(|i| {
            let numbers = if robot.rows[i].is_free() {
                &mut free
            } else {
                &mut following
            };
            joint(robot, (i, tree.parent(i)), numbers)
        });
        let mut joints: Vec<_> = joints.collect();
        Aligned::align(&mut joints, &tree);
        Mechanism {
            fields: robot.fields.len(),
            gravity: robot.gravity.clone(),
            base: robot.base.clone(),
            joints,
            tree,
            fixed_bodies: fixed_bodies(robot),
            tip: tip(robot),
            frames: frames(robot),
            neglected: robot.neglected.clone(),
        }
    }
}

/// The tool, or else the tip that a file says or the link frame.
fn tip(robot: &Robot) -> Frame {
    let link = robot.tip_row();
    let mount = link.and_then(|link| robot.rows[link].mount.as_ref());
    let places = mount.iter().flat_map(|mount| &mount.tip);
    let tool = robot.tool.iter().filter(|_| link.is_some());
    let places = places.chain(tool.map(|tool| &tool.placement));
    Frame {
        link,
        places: places.cloned().collect(),
    }
}

fn frames(robot: &Robot) -> Vec<Frame> {
    let frames = robot.frames.iter().map(|frame| Frame {
        link: frame.on,
        places: frame.places.clone(),
    });
    frames.collect()
}

/// The tool, and the bodies of frames on links. A body on the base does not move.
fn fixed_bodies(robot: &Robot) -> Vec<FixedBody> {
    let tool = robot.tool.as_ref().filter(|tool| tool.has_body());
    let tool = tool.and_then(|tool| {
        let Frame { link, places } = tip(robot);
        let body = Body {
            mass: tool.mass.clone(),
            com: tool.com.clone(),
            inertia: tool.inertia.clone(),
        };
        let link = link?;
        Some(FixedBody { link, places, body })
    });
    let of_frames = robot.frames.iter().filter_map(|frame| {
        Some(FixedBody {
            link: frame.on?,
            places: frame.places.clone(),
            body: frame.body.clone()?,
        })
    });
    tool.into_iter().chain(of_frames).collect()
}

/// The joint of row i, with the next of the numbers if it moves.
fn joint(
    robot: &Robot,
    (i, parent): (usize, Option<usize>),
    numbers: &mut impl Iterator<Item = usize>,
) -> Joint {
    let row = &robot.rows[i];
    let [start, link_frame, _] = robot.mounted(i);
    let (before, link_frame, origin) = match (robot.convention, &row.mount) {
        // The a and the alpha of a row are behind its joint.
        (Convention::Standard, _) => {
            let behind_carrier = parent.map(|parent| screw(&robot.rows[parent]));
            let before = behind_carrier.into_iter().chain(start).collect();
            (before, vec![screw(row)], Origin::BeforeOffset)
        }
        (Convention::Modified, None) => {
            let before = start.into_iter().chain([screw(row)]).collect();
            (before, Vec::new(), Origin::AfterOffset)
        }
        (Convention::Modified, Some(_)) => (start, link_frame, Origin::AfterOffset),
    };
    let law = law(row, numbers);
    Joint {
        name: row.name.clone(),
        joint_type: row.joint_type,
        aligned: Aligned {
            before: before.clone(),
            turn: constant_turn(row),
            d: row.d.clone(),
            own: Vec::new(),
        },
        before,
        turn: constant_turn(row),
        d: row.d.clone(),
        origin,
        link_frame,
        mass: row.mass.clone(),
        com: row.com.clone(),
        inertia: row.inertia.clone(),
        forces: match law {
            Law::Standing { .. } => forces(&Row::new("", row.joint_type)),
            Law::Free { .. } | Law::Following { .. } => forces(row),
        },
        law,
        limits: row.limits.clone(),
    }
}

/// Tx(a) Rx(alpha)
fn screw(row: &Row) -> Placement {
    Placement {
        xyz: [row.a.clone(), Value::zero(), Value::zero()],
        rpy: [row.alpha.clone(), Value::zero(), Value::zero()],
    }
}

/// A joint that is locked stands still, whatever it follows.
fn law(row: &Row, numbers: &mut impl Iterator<Item = usize>) -> Law {
    let mut number = || numbers.next().unwrap_or_default();
    match (&row.locked, &row.follows) {
        (Some(position), _) => Law::Standing {
            at: position.clone(),
        },
        (None, None) => Law::Free { number: number() },
        (None, Some(coupling)) => Law::Following {
            number: number(),
            coupling: coupling.clone(),
        },
    }
}

/// Theta, and the offset of an angle that follows another: among the places of a mount a turn of its own, as it
/// was written, else a part of the cell.
fn constant_turn(row: &Row) -> Vec<Value> {
    let theta = row.theta.clone();
    let offset = row.follows.as_ref().map(|coupling| coupling.offset.clone());
    match offset.filter(|_| row.joint_type == JointType::Revolute && row.locked.is_none()) {
        None => vec![theta],
        Some(offset) if row.mount.is_none() => vec![theta + offset],
        Some(offset) => vec![theta, offset],
    }
}

/// What acts at the joint of a row.
pub(super) fn forces(row: &Row) -> Forces {
    Forces {
        motor_inertia: row.motor_inertia.clone(),
        gear_ratio: row.gear_ratio.clone(),
        viscous: row.viscous.clone(),
        coulomb: row.coulomb.clone(),
        stribeck: row.stribeck.clone(),
        spring: row.spring.clone(),
    }
}
