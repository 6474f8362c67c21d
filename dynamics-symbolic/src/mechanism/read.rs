//! From the rows of a table to a mechanism.

use super::{Aligned, FixedBody, Forces, Frame, Joint, Law, Mechanism, Origin, Tree, base};
use crate::robot::{Convention, JointType, Placement, Robot, Row, Value};
use crate::spatial::AxisMotion;

impl From<JointType> for AxisMotion {
    fn from(joint_type: JointType) -> Self {
        match joint_type {
            JointType::Revolute => AxisMotion::Turns,
            JointType::Prismatic => AxisMotion::Slides,
        }
    }
}

impl From<&Robot> for Mechanism {
    fn from(robot: &Robot) -> Self {
        let rows = 0..robot.rows.len();
        let mut joints = robot.floating().map_or(Vec::new(), base::joints);
        let of_base = (0..joints.len()).map(|i| i.checked_sub(1));
        let parents = rows.clone().map(|i| link(robot, robot.parent(i)));
        let tree = Tree::new(of_base.chain(parents).collect());
        let (mut free, mut following) = (joints.len().., robot.dof()..);
        joints.extend(rows.map(|i| {
            let numbers = if robot.rows[i].is_free() {
                &mut free
            } else {
                &mut following
            };
            joint(robot, i, numbers)
        }));
        Aligned::align(&mut joints, &tree);
        Mechanism {
            fields: robot.fields.len(),
            gravity: robot.gravity.clone(),
            base: robot.placement().cloned(),
            joints,
            tree,
            fixed_bodies: fixed_bodies(robot),
            tip: tip(robot),
            frames: frames(robot),
            neglected: robot.neglected.clone(),
        }
    }
}

/// The link that a row moves; without a row what the base is: the last of the links of one that moves, or none.
fn link(robot: &Robot, row: Option<usize>) -> Option<usize> {
    let links_of_base = robot.freedoms().base;
    match row {
        Some(row) => Some(links_of_base + row),
        None => links_of_base.checked_sub(1),
    }
}

/// The tool, or else the tip that a file says or the link frame.
fn tip(robot: &Robot) -> Frame {
    let link = robot.tip_row();
    let of_file = link.and_then(|link| robot.rows[link].tip());
    let places = of_file.into_iter().flatten();
    let tool = robot.tool.iter().filter(|_| link.is_some());
    let places = places.chain(tool.map(|tool| &tool.placement));
    Frame {
        link: self::link(robot, link),
        places: places.cloned().collect(),
    }
}

fn frames(robot: &Robot) -> Vec<Frame> {
    let frames = robot.frames.iter().map(|frame| Frame {
        link: link(robot, frame.on),
        places: frame.places.clone(),
    });
    frames.collect()
}

/// The tool, and the bodies of frames on links. A body on a base that stands does not move.
fn fixed_bodies(robot: &Robot) -> Vec<FixedBody> {
    let tool = robot.tool.as_ref().filter(|tool| tool.has_body());
    let tool = tool.and_then(|tool| {
        let Frame { link, places } = tip(robot);
        Some(FixedBody {
            link: link?,
            places,
            body: tool.body.clone(),
        })
    });
    let of_frames = robot.frames.iter().filter_map(|frame| {
        Some(FixedBody {
            link: link(robot, frame.on)?,
            places: frame.places.clone(),
            body: frame.body.clone()?,
        })
    });
    tool.into_iter().chain(of_frames).collect()
}

/// The joint of row i, with the next of the numbers if it moves.
fn joint(robot: &Robot, i: usize, numbers: &mut impl Iterator<Item = usize>) -> Joint {
    let row = &robot.rows[i];
    let [start, link_frame] = robot.mounted(i);
    let (before, link_frame, origin) = match (robot.convention, &row.mount) {
        // The a and the alpha of a row are behind its joint.
        (Convention::Standard, _) => {
            let behind_carrier = robot.parent(i).map(|parent| screw(&robot.rows[parent]));
            let before = behind_carrier.into_iter().chain(start).collect();
            (before, vec![screw(row)], Origin::BeforeOffset)
        }
        (Convention::Modified, None) => {
            let before = start.into_iter().chain([screw(row)]).collect();
            (before, Vec::new(), Origin::AfterOffset)
        }
        (Convention::Modified, Some(_)) => (start, link_frame, Origin::AfterOffset),
    };
    let mut law = law(row, numbers);
    if let Law::Following { coupling, .. } = &mut law {
        coupling.leader += robot.freedoms().base;
    }
    Joint {
        name: row.name.clone(),
        axis_motion: row.joint_type.into(),
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
        body: row.body(),
        forces: match law {
            Law::Standing { .. } => Forces::none(),
            Law::Free { .. } | Law::Base { .. } | Law::Following { .. } => Forces::of(row),
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
