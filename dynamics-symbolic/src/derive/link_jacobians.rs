//! Geometric Jacobians of all links, and the rate of a frame's, in the axes of the base.

use super::kinematics::{by_rows, columns, fixed, frames};
use super::symbols::Symbols;
use crate::expr::Expr;
use crate::linear::Vector3;
use crate::mechanism::Frame;
use crate::spatial::AxisMotion;
use core::ops::Add;

/// The Jacobian of every link frame's origin, by rows. Joints beyond a link do not move it.
pub(super) fn of_links<'g>(symbols: &mut Symbols<'g>) -> Vec<Expr<'g>> {
    let (zero, arm) = (symbols.graph().zero(), symbols.arm());
    let frames = frames(symbols);
    let of_link = |i: usize| {
        let point = frames[i].pose.origin;
        by_rows(&columns(arm, &frames, Some(i), (point, zero)))
    };
    (0..frames.len()).flat_map(of_link).collect()
}

/// dJ/dt by rows, from the columns (L_j, A_j) of J.
///
/// A revolute joint with the axis z_j, about which the frame is at r_j, has L_j = z_j x r_j. With w the
/// angular velocity before the joint, the axis changes at the rate w x z_j, and r_j at
/// w x r_j + u_j, u_j = sum L_k qd_k over the joints k >= j. So, by Jacobi's identity,
///
///   dL_j/dt = w x L_j + z_j x u_j,   dA_j/dt = w x A_j,
///
/// and of a prismatic joint dL_j/dt = w x L_j.
pub(super) fn rate<'g>(symbols: &mut Symbols<'g>, frame: &Frame) -> Vec<Expr<'g>> {
    let (zero, arm) = (symbols.graph().zero(), symbols.arm());
    let qd = symbols.all(|joint| joint.qd);
    let frames = frames(symbols);
    let origin = fixed(symbols, &frames, frame.place()).origin;
    let columns = columns(arm, &frames, frame.link, (origin, zero));
    let none = Vector3::splat(zero);
    // u_j: the velocity of the frame by joint j and those beyond.
    let mut velocities = vec![none; columns.len()];
    arm.tree.inward(none, Vector3::add, |j, outer| {
        velocities[j] = outer + columns[j].0 * qd[j];
        velocities[j]
    });
    let mut rates = Vec::with_capacity(columns.len());
    arm.tree.outward(none, |j, &w| {
        let (linear, angular) = columns[j];
        let turned = (w.cross(linear), w.cross(angular));
        rates.push(match arm.joints[j].axis_motion {
            AxisMotion::Turns => (turned.0 + angular.cross(velocities[j]), turned.1),
            AxisMotion::Slides => turned,
        });
        w + angular * qd[j]
    });
    by_rows(&rates)
}
