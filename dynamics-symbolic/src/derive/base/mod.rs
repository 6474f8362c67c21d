//! Base inertial parameters: the smallest set that determines the forces of every motion.
//!
//! The Lagrangian is linear in the standard inertial parameters of the links (Maes, Samson and
//! Bastin 1989). Let F_i(c) be the part of it that parameters c of link i contribute. Where F_i(c)
//! does not depend on joint i, it is what it is at q_i = 0, qd_i = 0: there link i is a part of
//! link i-1, so that F_i(c) = F_{i-1}(X c) with the constant change of frame X, and c may move to
//! link i-1 without a division. Those c are a space A_i. What is left when they have moved, for
//! each link from the tip inwards, is minimal: if sum F_i(b_i) is constant and b_n is not 0, F_n(b_n)
//! does not depend on joint n, so b_n is in A_n. The rules of Gautier and Khalil (1990) give
//! the part of A_i that every chain has; here all of A_i is found ([`Grouping`]), from the motions
//! that link i-1 can make.
//!
//! Which parameters are kept does not depend on the way of writing the equations: the links from
//! the base outwards, the parameters of a link in the order of [`Parameter::ALL`], each kept unless
//! it is a combination of those before it.
//!
//! Constants other than multiples of a quarter turn count as independent of one another: a
//! coincidence such as sin 30 deg = 1/2 groups nothing.

mod axes;
mod group;
mod observe;

pub(crate) use group::{LinkGeometry, group, unit};
pub use observe::{Coefficient, Direction, Grouping, LinkGrouping, Tie};

use super::chain::{body, twists};
use super::inertia::{Body, Turn};
use super::symbols::Symbols;
use crate::expr::Expr;
use crate::robot::{Interpretation, JointType, Parameter, Robot};

/// The constant geometry of every link.
pub(crate) fn geometry<'g>(
    symbols: &mut Symbols<'g>,
    robot: &Robot,
) -> Vec<LinkGeometry<Expr<'g>>> {
    let (zero, one) = (symbols.graph().zero(), symbols.graph().one());
    let twists = twists(symbols, robot);
    let rows = robot.rows.iter().enumerate().zip(&twists);
    rows.map(|((i, row), twist)| {
        let (s, c) = match (row.joint_type, &row.locked) {
            (JointType::Revolute, None) => (zero, one),
            (JointType::Prismatic, _) => symbols.sin_cos(&row.theta),
            (JointType::Revolute, Some(_)) => symbols.joint_sin_cos(i, row.joint_type, &row.theta),
        };
        let slide = match (row.joint_type, &row.locked) {
            (JointType::Prismatic, Some(position)) => symbols.value(position),
            _ => zero,
        };
        LinkGeometry {
            joint_type: row.joint_type,
            locked: row.locked.is_some(),
            a: twist.a,
            d: symbols.value(&row.d) + slide,
            twist: twist.turn,
            turn: Turn { s, c },
        }
    })
    .collect()
}

/// The standard inertial parameters of every link.
fn bodies<'g>(symbols: &mut Symbols<'g>, robot: &Robot) -> Vec<(Body<Expr<'g>>, Expr<'g>)> {
    let twists = twists(symbols, robot);
    let rows = robot.rows.iter().zip(&twists[1..]);
    rows.map(|(row, next)| {
        let ratio = symbols.value(&row.gear_ratio);
        let reflected = ratio * ratio * symbols.value(&row.motor_inertia);
        (body(symbols, robot.convention, row, next), reflected)
    })
    .collect()
}

/// The base parameters of a robot, in the order of the regressor's columns.
pub(super) fn base_parameters<'g>(symbols: &mut Symbols<'g>, robot: &Robot) -> Vec<Expr<'g>> {
    let grouping = Grouping::of(robot);
    let (zero, one) = (symbols.graph().zero(), symbols.graph().one());
    let geometry = geometry(symbols, robot);
    let mut carried = Body::splat(zero);
    let mut columns = Vec::new();
    for (i, (body, reflected)) in bodies(symbols, robot).into_iter().enumerate().rev() {
        let whole = (body.joined(carried), reflected);
        let moved = group(&grouping, &geometry, i, whole, (zero, one));
        columns.push(moved.kept);
        carried = moved.inward;
    }
    columns.reverse();
    columns.concat()
}

/// Link and parameter of every column.
pub fn columns(grouping: &Grouping) -> Vec<(usize, Parameter)> {
    let links = grouping.links.iter().enumerate();
    links
        .flat_map(|(i, link)| link.kept.iter().map(move |&kept| (i, kept)))
        .collect()
}
