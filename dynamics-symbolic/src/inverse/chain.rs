//! The arm from the world to a frame: fixed steps and joints.

use super::moves::{Move, Path};
use super::view::{Unknown, View};
use super::why::Unsolved;
use crate::derive::place;
use crate::derive::symbols::Symbols;
use crate::expr::{Expr, Graph};
use crate::linear::{Matrix3, Vector3};
use crate::mechanism::{Joint, Law, Mechanism};
use crate::robot::{Interpretation, JointType, Placement};
use std::collections::BTreeSet;

/// A step of the way to the frame.
pub(super) enum Link<'g> {
    Fixed(Matrix3<Expr<'g>>, Vector3<Expr<'g>>),
    Joint(Unknown, Move<'g>),
}

/// The joints of a chain with all of them unknown.
pub(super) fn chain_view<'g>(chain: &[Link<'g>], graph: &'g Graph) -> View<'g> {
    let (first, links, last) = between(chain, &BTreeSet::new());
    View {
        graph,
        joints: joints(chain).collect(),
        links,
        target: first.then(&last),
        is_inverse: false,
        tip: last.point(Vector3::splat(graph.zero())),
        forbidden: BTreeSet::new(),
    }
}

/// The joints that move.
pub(super) fn joints<'g>(chain: &[Link<'g>]) -> impl Iterator<Item = Unknown> {
    chain.iter().filter_map(|link| match link {
        Link::Fixed(..) => None,
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
            Link::Fixed(rotation, origin) => here.0.push(Move::Fixed(*rotation, *origin)),
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
    let mut chain = Vec::new();
    if let Some(base) = place::base(symbols, arm) {
        let columns = units(symbols).map(|axis| base.leave(axis).0);
        chain.push(Link::Fixed(Matrix3(columns).transpose(), base.origin));
    }
    for &i in &carriers {
        let joint = &arm.joints[i];
        chain.push(fixed(symbols, &joint.aligned.before));
        joint_links(symbols, joint, i, &mut chain)?;
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

/// The constant turn and step along a joint's axis, and its motion.
fn joint_links<'g>(
    symbols: &mut Symbols<'g>,
    joint: &Joint,
    i: usize,
    chain: &mut Vec<Link<'g>>,
) -> Result<(), Unsolved> {
    let graph = symbols.graph();
    let d = symbols.value(&joint.aligned.d);
    let turn = symbols.constant_turn(i);
    let variables = *symbols.joint(i);
    let joint_type = joint.joint_type;
    let turning = (joint_type == JointType::Revolute).then_some(variables.sin_cos);
    let motion = match turning {
        Some((s, c)) => Move::Turn(s, c),
        None => Move::Slide(variables.q),
    };
    let mut constant = Path(vec![Move::Turn(turn.s, turn.c), Move::Slide(d)]);
    let moving = match joint.law {
        Law::Free { number } => Some(Unknown { number, joint_type }),
        Law::Standing { .. } | Law::Base { .. } => {
            constant.0.push(motion);
            None
        }
        Law::Following { .. } => return Err(Unsolved::Follower(joint.name.clone())),
    };
    let columns = units(symbols).map(|axis| constant.direction(axis).0);
    let origin = constant.point(Vector3::splat(graph.zero()));
    chain.push(Link::Fixed(Matrix3(columns).transpose(), origin));
    chain.extend(moving.map(|unknown| Link::Joint(unknown, motion)));
    Ok(())
}

fn fixed<'g>(symbols: &mut Symbols<'g>, places: &[Placement]) -> Link<'g> {
    let place = place::place(symbols, places);
    let columns = units(symbols).map(|axis| place.turns.leave(axis).0);
    Link::Fixed(Matrix3(columns).transpose(), place.origin)
}

fn units<'g>(symbols: &Symbols<'g>) -> [Vector3<Expr<'g>>; 3] {
    let (zero, one) = (symbols.graph().zero(), symbols.graph().one());
    [[one, zero, zero], [zero, one, zero], [zero, zero, one]].map(Vector3)
}
