//! The arm from the world to a frame: fixed steps and joints.

use super::moves::{Move, Path};
use super::view::Unknown;
use super::why::Unsolved;
use crate::derive::place;
use crate::derive::symbols::Symbols;
use crate::linear::{Matrix3, Vector3};
use crate::mechanism::{Law, Mechanism};
use crate::robot::{Interpretation, JointType, Placement};
use std::collections::BTreeSet;

/// A step of the way to the frame.
pub(super) enum Link<'g> {
    Fixed(Move<'g>),
    Joint(Unknown, Move<'g>),
}

/// The joints that move.
pub(super) fn joints<'g>(chain: &[Link<'g>]) -> impl Iterator<Item = Unknown> {
    chain.iter().filter_map(|link| match link {
        Link::Fixed(_) => None,
        Link::Joint(joint, _) => Some(*joint),
    })
}

/// The way to the first joint that is not known, those between such joints, and the one behind the last.
pub(super) fn between<'g>(
    chain: &[Link<'g>],
    known: &BTreeSet<usize>,
) -> (Path<'g>, Vec<Path<'g>>, Path<'g>) {
    let mut paths = vec![Path::default()];
    for link in chain {
        let here = paths.last_mut().expect("never empty");
        match link {
            Link::Fixed(motion) => here.0.push(*motion),
            Link::Joint(joint, motion) if known.contains(&joint.number) => here.0.push(*motion),
            Link::Joint(..) => paths.push(Path::default()),
        }
    }
    let last = paths.pop().expect("never empty");
    if paths.is_empty() {
        return (last, Vec::new(), Path::default());
    }
    let first = paths.remove(0);
    (first, paths, last)
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
    let frame = arm.frame(frame);
    let mut carriers: Vec<usize> = arm.tree.carriers_of(frame.link).collect();
    carriers.sort_unstable();
    let others = (0..arm.joints.len()).filter(|i| !carriers.contains(i));
    if let Some(other) = others.map(|i| &arm.joints[i]).find(|joint| !joint.stands()) {
        return Err(Unsolved::OtherJoint(other.name.clone()));
    }
    let mut chain = vec![fixed(symbols, arm.base.as_slice())];
    for &i in &carriers {
        let joint = &arm.joints[i];
        let (joint_type, variables) = (joint.joint_type, *symbols.joint(i));
        let turning = (joint_type == JointType::Revolute).then_some(variables.sin_cos);
        let motion = turning.map_or(Move::Slide(variables.q), |(s, c)| Move::Turn(s, c));
        let moving = match joint.law {
            Law::Free { number } => Link::Joint(Unknown { number, joint_type }, motion),
            Law::Standing { .. } | Law::Base { .. } => Link::Fixed(motion),
            Law::Following { .. } => return Err(Unsolved::Follower(joint.name.clone())),
        };
        let before = fixed(symbols, &joint.aligned.before);
        let turn = symbols.constant_turn(i);
        let slide = symbols.value(&joint.aligned.d);
        let constant = [Move::Turn(turn.s, turn.c), Move::Slide(slide)].map(Link::Fixed);
        chain.push(before);
        chain.extend(constant.into_iter().chain([moving]));
    }
    let behind = match frame.link {
        Some(link) => {
            let joint = &arm.joints[link];
            [&joint.aligned.own[..], &joint.link_frame, &frame.places].concat()
        }
        None => frame.places.clone(),
    };
    chain.push(fixed(symbols, &behind));
    Ok(chain)
}

fn fixed<'g>(symbols: &mut Symbols<'g>, places: &[Placement]) -> Link<'g> {
    let place = place::place(symbols, places);
    let (zero, one) = (symbols.graph().zero(), symbols.graph().one());
    let axes = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
    let columns = axes.map(|axis| place.turns.leave(Vector3(axis)).0);
    Link::Fixed(Move::Fixed(Matrix3(columns).transpose(), place.origin))
}
