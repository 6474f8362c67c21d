//! The regressor: joint forces by the motion and a unit base parameter, one column for each.
//!
//! The joint forces are linear in the inertial parameters (Khosla and Kanade 1985), so the column
//! of a parameter is what the equations of motion give where that one is 1 and all others are 0.

use super::base::{self, Grouping};
use super::chain::Chain;
use super::inertia::Body;
use super::recursive::{Motion, outward, wrench};
use super::symbols::Symbols;
use crate::expr::Expr;
use crate::linear::Vector3;
use crate::robot::{JointType, Parameter, Robot};

type Vector<'g> = Vector3<Expr<'g>>;
type Wrench<'g> = (Vector<'g>, Vector<'g>);

/// A column in the making: its link, and the wrench of its body on the link's origin. A motor has
/// none.
type Column<'g> = (usize, Option<Wrench<'g>>);

/// Each body's wrench handed on from link to link, to the base. By rows.
pub(super) fn by_recursion<'g>(
    symbols: &mut Symbols<'g>,
    robot: &Robot,
    chain: &Chain<'g>,
) -> Vec<Expr<'g>> {
    let zero = chain.zero;
    let qdd = symbols.all(|joint| joint.qdd);
    let forces = columns(symbols, robot, chain)
        .into_iter()
        .map(|(i, wrench)| {
            let mut forces = vec![zero; qdd.len()];
            let Some((mut f, mut n)) = wrench else {
                forces[i] = qdd[i];
                return forces;
            };
            for (j, link) in chain.links[..=i].iter().enumerate().rev() {
                forces[j] = match link.joint_type {
                    JointType::Revolute => n[2],
                    JointType::Prismatic => f[2],
                };
                f = link.leave(f);
                n = link.leave(n) + link.position(zero).cross(f);
            }
            forces
        });
    by_rows(&forces.collect::<Vec<_>>(), qdd.len())
}

/// The power of each body's wrench in a unit velocity of each joint (Kane's partial velocities). By
/// rows.
pub(super) fn by_partial_velocities<'g>(
    symbols: &mut Symbols<'g>,
    robot: &Robot,
    chain: &Chain<'g>,
) -> Vec<Expr<'g>> {
    let (zero, one) = (chain.zero, chain.one);
    let qdd = symbols.all(|joint| joint.qdd);
    let (rest, axis) = (Vector3::splat(zero), Vector3::new(zero, zero, one));
    // The twists (w, v) of link i by unit velocities of joints 0..=i.
    let mut twists: Vec<Vec<Wrench<'g>>> = Vec::new();
    for link in &chain.links {
        let mut partial: Vec<_> = match twists.last() {
            None => Vec::new(),
            Some(previous) => {
                let p = link.position(zero);
                let entered = |&(w, v): &Wrench<'g>| (link.enter(w), link.enter(v + w.cross(p)));
                previous.iter().map(entered).collect()
            }
        };
        partial.push(match link.joint_type {
            JointType::Revolute => (axis, rest),
            JointType::Prismatic => (rest, axis),
        });
        twists.push(partial);
    }
    let forces = columns(symbols, robot, chain)
        .into_iter()
        .map(|(i, wrench)| {
            let mut forces = vec![zero; qdd.len()];
            match wrench {
                None => forces[i] = qdd[i],
                Some((f, n)) => {
                    for (force, (w, v)) in forces.iter_mut().zip(&twists[i]) {
                        *force = w.dot(n) + v.dot(f);
                    }
                }
            }
            forces
        });
    by_rows(&forces.collect::<Vec<_>>(), qdd.len())
}

/// The wrench of every unit base parameter.
fn columns<'g>(symbols: &mut Symbols<'g>, robot: &Robot, chain: &Chain<'g>) -> Vec<Column<'g>> {
    let grouping = Grouping::of(robot);
    let geometry = base::geometry(symbols, robot);
    let motions = motions(symbols, chain);
    let column = |(i, parameter): (usize, Parameter)| {
        let body = base::unit(&grouping, &geometry, i, parameter, (chain.zero, chain.one));
        let placed = |body: Body<_>| chain.links[i].place(body, chain.zero);
        (i, body.map(|body| wrench(&placed(body), &motions[i])))
    };
    base::columns(&grouping).into_iter().map(column).collect()
}

fn motions<'g>(symbols: &Symbols<'g>, chain: &Chain<'g>) -> Vec<Motion<'g>> {
    let mut motion = Motion::of_base(chain.zero, chain.gravity);
    let links = chain.links.iter().enumerate();
    links
        .map(|(i, link)| {
            let joint = symbols.joint(i);
            motion = outward(chain, link, motion, joint.qd, joint.qdd);
            motion
        })
        .collect()
}

fn by_rows<'g>(columns: &[Vec<Expr<'g>>], rows: usize) -> Vec<Expr<'g>> {
    let row = |i: usize| columns.iter().map(move |column| column[i]);
    (0..rows).flat_map(row).collect()
}
