//! The arm from the world to a frame: fixed steps and joints.

use super::moves::{Move, Path};
use super::view::Unknown;
use super::why::Unsolved;
use crate::derive::place;
use crate::derive::symbols::Symbols;
use crate::linear::{Matrix3, Vector3};
use crate::mechanism::{Law, Mechanism};
use crate::robot::{Interpretation, Placement};
use crate::spatial::AxisMotion;
use std::collections::BTreeSet;

/// A step of the way to the frame.
pub(super) struct Link<'g> {
    /// The joint that makes it; `None` if it is fixed.
    pub(super) joint: Option<Unknown>,
    pub(super) motion: Move<'g>,
}

impl<'g> Link<'g> {
    fn fixed(motion: Move<'g>) -> Self {
        let joint = None;
        Link { joint, motion }
    }
}

/// The joints that move.
pub(super) fn joints(chain: &[Link<'_>]) -> impl Iterator<Item = Unknown> {
    chain.iter().filter_map(|link| link.joint)
}

/// The way to the first joint that is not known, those between such joints, and the one behind the last.
pub(super) fn between<'g>(chain: &[Link<'g>], known: &BTreeSet<usize>) -> Vec<Path<'g>> {
    let is_unknown = |joint: Unknown| !known.contains(&joint.number);
    let ways = chain.split(|link| link.joint.is_some_and(is_unknown));
    ways.map(|way| Path(way.iter().map(|link| link.motion).collect()))
        .collect()
}

/// The arm from the world to a frame. All joints that move must carry the frame.
pub(super) fn chain<'g>(
    symbols: &mut Symbols<'g>,
    arm: &'g Mechanism,
    frame: Option<usize>,
) -> Result<Vec<Link<'g>>, Unsolved> {
    if arm.freedoms().has_base() {
        return Err(Unsolved::MovingBase);
    }
    let (graph, frame) = (symbols.graph(), arm.frame(frame));
    let mut carriers: Vec<usize> = arm.tree.carriers_of(frame.link).collect();
    carriers.sort_unstable();
    let others = (0..arm.joints.len()).filter(|i| !carriers.contains(i));
    if let Some(other) = others.map(|i| &arm.joints[i]).find(|joint| !joint.stands()) {
        return Err(Unsolved::OtherJoint(other.name.clone()));
    }
    let mut chain = vec![Link::fixed(placed(symbols, arm.base.as_slice()))];
    for &i in &carriers {
        let joint = &arm.joints[i];
        let (axis_motion, variables) = (joint.axis_motion, *symbols.joint(i));
        let motion = match axis_motion {
            AxisMotion::Turns => Move::turn(graph, variables.sin_cos),
            AxisMotion::Slides => Move::slide(graph, variables.q),
        };
        let moving = match joint.law {
            Law::Free { number } => Some(Unknown {
                number,
                axis_motion,
            }),
            Law::Standing { .. } | Law::Base { .. } => None,
            Law::Following { .. } => return Err(Unsolved::Follower(joint.name.clone())),
        };
        let before = placed(symbols, &joint.aligned.before);
        let turn = symbols.constant_turn(i);
        let slide = symbols.value(&joint.aligned.d);
        let constant = [
            Move::turn(graph, (turn.s, turn.c)),
            Move::slide(graph, slide),
        ];
        chain.extend([before, constant[0], constant[1]].map(Link::fixed));
        chain.push(Link {
            joint: moving,
            motion,
        });
    }
    let behind = match frame.link {
        Some(link) => {
            let joint = &arm.joints[link];
            [&joint.aligned.own[..], &joint.link_frame, &frame.places].concat()
        }
        None => frame.places.clone(),
    };
    chain.push(Link::fixed(placed(symbols, &behind)));
    Ok(chain)
}

fn placed<'g>(symbols: &mut Symbols<'g>, places: &[Placement]) -> Move<'g> {
    let place = place::place(symbols, places);
    let (zero, one) = (symbols.graph().zero(), symbols.graph().one());
    let axes = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
    let columns = axes.map(|axis| place.turns.leave(Vector3(axis)).0);
    Move {
        rotation: Matrix3(columns).transpose(),
        origin: place.origin,
    }
}
