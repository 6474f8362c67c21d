//! Geometric Jacobians of all links, and the rate of the tip's, in the axes of the base.

use super::kinematics::{by_rows, columns, frames, link_of_tip, tip};
use super::symbols::Symbols;
use super::walk::Tree;
use crate::expr::Expr;
use crate::linear::Vector3;
use crate::robot::{JointType, Robot};
use core::ops::Add;

/// The Jacobian of every link frame's origin, by rows. Joints beyond a link do not move it.
pub(super) fn of_links<'g>(symbols: &mut Symbols<'g>, robot: &Robot) -> Vec<Expr<'g>> {
    let zero = symbols.graph().zero();
    let frames = frames(symbols, robot);
    let of_link = |i: usize| {
        by_rows(&columns(
            &frames,
            robot,
            Some(i),
            (frames[i].pose.origin, zero),
        ))
    };
    (0..frames.len()).flat_map(of_link).collect()
}

/// dJ/dt by rows, from the columns (L_j, A_j) of J.
///
/// A revolute joint with the axis z_j, about which the tip is at r_j, has L_j = z_j x r_j. With w the
/// angular velocity before the joint, the axis changes at the rate w x z_j, and r_j at
/// w x r_j + u_j, u_j = sum L_k qd_k over the joints k >= j. So, by Jacobi's identity,
///
///   dL_j/dt = w x L_j + z_j x u_j,   dA_j/dt = w x A_j,
///
/// and of a prismatic joint dL_j/dt = w x L_j.
pub(super) fn rate<'g>(symbols: &mut Symbols<'g>, robot: &Robot) -> Vec<Expr<'g>> {
    let zero = symbols.graph().zero();
    let qd = symbols.all(|joint| joint.qd);
    let frames = frames(symbols, robot);
    let tip = tip(symbols, robot, &frames).origin;
    let columns = columns(&frames, robot, link_of_tip(robot), (tip, zero));
    let (tree, none) = (Tree::of(robot), Vector3::splat(zero));
    // u_j: the velocity of the tip by joint j and those beyond.
    let mut velocities = vec![none; columns.len()];
    tree.inward(none, Vector3::add, |j, outer| {
        velocities[j] = outer + columns[j].0 * qd[j];
        velocities[j]
    });
    let mut rates = Vec::with_capacity(columns.len());
    tree.outward(none, |j, &w| {
        let (linear, angular) = columns[j];
        let turned = (w.cross(linear), w.cross(angular));
        rates.push(match robot.rows[j].joint_type {
            JointType::Revolute => (turned.0 + angular.cross(velocities[j]), turned.1),
            JointType::Prismatic => turned,
        });
        w + angular * qd[j]
    });
    by_rows(&rates)
}
