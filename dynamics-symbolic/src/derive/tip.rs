//! The velocity and the acceleration of a frame, which may be the tip, and the joint forces of a wrench on it.
//!
//! A motion of the frame is gathered from the frame inwards. Seen from link i the frame is at r, moves at u
//! and accelerates at a, and turns at w with the rate e. Joint i adds its own motion; a revolute one, as
//! the product rule has it for Rz(q) r,
//!
//!   u' = u + qd z x r,   a' = a + z x (qd (u + u') + qdd r),
//!   w' = w + qd z,       e' = e + qd z x w + qdd z,
//!
//! and a prismatic one u' = u + qd z, a' = a + qdd z. The values that reach the base are in its axes: nothing has to
//! be turned back.

use super::chain::Chain;
use super::place;
use super::rows::Places;
use super::symbols::Symbols;
use crate::expr::Expr;
use crate::function::Argument;
use crate::linear::Vector3;
use crate::mechanism::Frame;
use crate::spatial::{Axis, AxisMotion, Joint, leave_about};

type Vector<'g> = Vector3<Expr<'g>>;

/// Where a frame is in the chain's frame of the link that carries it; anywhere if that is the base.
fn place_of<'g>(symbols: &mut Symbols<'g>, chain: &Chain<Expr<'g>>, frame: &Frame) -> Vector<'g> {
    let Some(link) = frame.link else {
        return Vector3::splat(chain.zero);
    };
    let in_link = place::place(symbols, &frame.places).origin;
    let places = Places::new(symbols, symbols.arm());
    let on_axis = places.leave_point(link, in_link);
    let link = &chain.links[link];
    leave_about(Axis::Z, link.behind, on_axis.plus_z(-link.shift))
}

/// J qd: velocity of the frame's origin, angular velocity.
pub(super) fn velocity<'g>(
    symbols: &mut Symbols<'g>,
    chain: &Chain<Expr<'g>>,
    frame: &Frame,
) -> Vec<Expr<'g>> {
    let mut r = place_of(symbols, chain, frame);
    let none = Vector3::splat(chain.zero);
    let (mut u, mut w) = (none, none);
    for i in chain.tree.carriers_of(frame.link) {
        let (joint, qd) = (chain.joint(i), symbols.joint(i).qd);
        match joint.axis_motion {
            AxisMotion::Turns => {
                u = u + z_cross(chain, r, qd);
                w = w.plus_z(qd);
            }
            AxisMotion::Slides => u = u.plus_z(qd),
        }
        (u, w) = (joint.leave(u), joint.leave(w));
        r = inward(joint, r);
    }
    in_world(symbols, [u, w])
}

/// J qdd + Jdot qd: acceleration of the frame's origin, angular acceleration.
pub(super) fn acceleration<'g>(
    symbols: &mut Symbols<'g>,
    chain: &Chain<Expr<'g>>,
    frame: &Frame,
) -> Vec<Expr<'g>> {
    let mut r = place_of(symbols, chain, frame);
    let none = Vector3::splat(chain.zero);
    let (mut u, mut a, mut w, mut e) = (none, none, none, none);
    for i in chain.tree.carriers_of(frame.link) {
        let (joint, of_joint) = (chain.joint(i), symbols.joint(i));
        let (qd, qdd) = (of_joint.qd, of_joint.qdd);
        match joint.axis_motion {
            AxisMotion::Turns => {
                let before = u;
                u = u + z_cross(chain, r, qd);
                a = a + (z_cross(chain, before + u, qd) + z_cross(chain, r, qdd));
                e = (e + z_cross(chain, w, qd)).plus_z(qdd);
                w = w.plus_z(qd);
            }
            AxisMotion::Slides => {
                u = u.plus_z(qd);
                a = a.plus_z(qdd);
            }
        }
        [u, a, w, e] = [u, a, w, e].map(|v| joint.leave(v));
        r = inward(joint, r);
    }
    in_world(symbols, [a, e])
}

/// J' w, the force f and the moment n handed on outwards as they are: with the frame that is pushed at r from
/// the origin of frame i, joint i feels z.(n + r x f). Where the chain has a pivot that carries the pushed frame, the
/// moment is taken about the origin of that joint, and handed on from there ([`Wrench::about`]).
pub(super) fn wrench_torques<'g>(
    symbols: &mut Symbols<'g>,
    chain: &Chain<Expr<'g>>,
    frame: &Frame,
) -> Vec<Expr<'g>> {
    let wrench = Wrench::new(symbols, chain, frame);
    let mut forces = vec![None; chain.links.len()];
    if let Some(pivot) = chain.pivot.filter(|pivot| wrench.carriers.contains(pivot)) {
        wrench.about(chain, pivot, &mut forces);
    }
    for &i in wrench.carriers.iter().rev() {
        forces[i] = forces[i].or_else(|| Some(wrench.joint_force(i, chain.joint(i))));
    }
    let forces = forces
        .into_iter()
        .map(|forces| forces.unwrap_or(chain.zero));
    forces.collect()
}

/// A wrench on a frame, as it is in another one.
#[derive(Clone, Copy)]
struct LocalWrench<'g> {
    force: Vector<'g>,
    moment: Vector<'g>,
    /// Where the frame is that is pushed.
    lever: Vector<'g>,
}

/// A wrench on a frame, in frame 0 and the frames of the links that carry the pushed one.
struct Wrench<'g> {
    /// The links that carry the pushed frame, from its own inwards.
    carriers: Vec<usize>,
    in_base: LocalWrench<'g>,
    in_links: Vec<LocalWrench<'g>>,
}

impl<'g> Wrench<'g> {
    fn new(symbols: &mut Symbols<'g>, chain: &Chain<Expr<'g>>, frame: &Frame) -> Self {
        let mut lever = place_of(symbols, chain, frame);
        let mut levers = vec![lever; chain.links.len()];
        let carriers: Vec<_> = chain.tree.carriers_of(frame.link).collect();
        for &i in &carriers {
            levers[i] = lever;
            lever = inward(chain.joint(i), lever);
        }
        let [force, moment] = wrench(symbols);
        let in_base = LocalWrench {
            force,
            moment,
            lever,
        };
        let in_links = chain.tree.outward(in_base, |i, before| LocalWrench {
            force: chain.joint(i).enter(before.force),
            moment: chain.joint(i).enter(before.moment),
            lever: levers[i],
        });
        Wrench {
            carriers,
            in_base,
            in_links,
        }
    }

    /// z.(n + r x f)
    fn joint_force(&self, i: usize, joint: &Joint<Expr<'g>>) -> Expr<'g> {
        let LocalWrench {
            force: f,
            moment: n,
            lever: r,
        } = self.in_links[i];
        match joint.axis_motion {
            AxisMotion::Turns => n[2] + (r[0] * f[1] - r[1] * f[0]),
            AxisMotion::Slides => f[2],
        }
    }

    /// The joint forces of the moment m about the origin of one joint, written in the frame before it:
    /// outwards those whose axes meet there, inwards all, with joint k outside joint i at p in frame i,
    ///
    ///   m_i = R (m_k + slide z x f_k) + p x f_i.
    fn about(&self, chain: &Chain<Expr<'g>>, pivot: usize, forces: &mut [Option<Expr<'g>>]) {
        let parent = chain.tree.parent(pivot);
        let local = parent.map_or(&self.in_base, |parent| &self.in_links[parent]);
        let place = chain.joint(pivot).offset;
        let about = local.moment + (local.lever - place).cross(local.force);
        let is_at_pivot = |joint: &Joint<Expr<'g>>| joint.offset.0.iter().all(|x| x.is_zero());
        let mut outer = self.carriers.clone();
        let inner = outer.split_off(outer.iter().take_while(|i| **i != pivot).count());
        let mut m = about;
        for i in inner.iter().take(1).chain(outer.iter().rev()).copied() {
            let joint = chain.joint(i);
            if joint.axis_motion == AxisMotion::Slides || (i != pivot && !is_at_pivot(joint)) {
                break;
            }
            m = joint.enter(m);
            forces[i] = Some(m[2]);
        }
        m = about;
        for (&i, &outside) in inner.iter().skip(1).zip(&inner) {
            let (f, joint) = (self.in_links[i].force, chain.joint(i));
            m = m + chain.joint(outside).offset.cross(f);
            if joint.axis_motion == AxisMotion::Turns {
                forces[i] = Some(m[2]);
            }
            m = joint.leave(m + z_cross(chain, f, joint.slide));
        }
    }
}

/// Force and moment, in the axes of frame 0.
fn wrench<'g>(symbols: &mut Symbols<'g>) -> [Vector<'g>; 2] {
    let mut vector =
        |first: usize| Vector3([0, 1, 2].map(|k| symbols.entry(Argument::Wrench, first + k)));
    let wrench = [vector(0), vector(3)];
    match place::base(symbols, symbols.arm()) {
        Some(base) => wrench.map(|v| base.enter(v)),
        None => wrench,
    }
}

/// Two vectors of frame 0 in the axes of the world, one after the other.
fn in_world<'g>(symbols: &mut Symbols<'g>, vectors: [Vector<'g>; 2]) -> Vec<Expr<'g>> {
    let vectors = match place::base(symbols, symbols.arm()) {
        Some(base) => vectors.map(|v| base.leave(v)),
        None => vectors,
    };
    vectors.map(|v| v.0).concat()
}

/// A place in the frame of the previous link.
fn inward<'g>(joint: &Joint<Expr<'g>>, r: Vector<'g>) -> Vector<'g> {
    joint.offset + joint.leave(r.plus_z(joint.slide))
}

/// k z x v
fn z_cross<'g>(chain: &Chain<Expr<'g>>, v: Vector<'g>, k: Expr<'g>) -> Vector<'g> {
    Vector3::new(-(k * v[1]), k * v[0], chain.zero)
}
