//! Geometric Jacobians of all links, and the rate of the tip's, in the axes of the base.

use super::kinematics::{Column, by_rows, columns, frames, tip};
use super::symbols::Symbols;
use crate::expr::Expr;
use crate::linear::Vector3;
use crate::robot::{JointType, Robot};

type Vector<'g> = Vector3<Expr<'g>>;

/// The Jacobian of every link frame's origin, by rows. Joints beyond a link do not move it.
pub(super) fn of_links<'g>(symbols: &mut Symbols<'g>, robot: &Robot) -> Vec<Expr<'g>> {
    let zero = symbols.graph().zero();
    let none = (Vector3::splat(zero), Vector3::splat(zero));
    let frames = frames(symbols, robot);
    let of_link = |i: usize| {
        let mut columns = columns(&frames[..=i], robot, frames[i].pose.origin, zero);
        columns.resize(frames.len(), none);
        by_rows(&columns)
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
    let columns = columns(&frames, robot, tip, zero);
    let velocities = outer_velocities(&columns, &qd, zero);
    let mut w = Vector3::splat(zero);
    let mut rates = Vec::with_capacity(columns.len());
    for (j, &(linear, angular)) in columns.iter().enumerate() {
        let turned = (w.cross(linear), w.cross(angular));
        rates.push(match robot.rows[j].joint_type {
            JointType::Revolute => (turned.0 + angular.cross(velocities[j]), turned.1),
            JointType::Prismatic => turned,
        });
        w = w + angular * qd[j];
    }
    by_rows(&rates)
}

/// u_j: the velocity of the tip by joint j and those beyond.
fn outer_velocities<'g>(
    columns: &[Column<'g>],
    qd: &[Expr<'g>],
    zero: Expr<'g>,
) -> Vec<Vector<'g>> {
    let mut u = Vector3::splat(zero);
    let joints = columns.iter().zip(qd).rev();
    let mut velocities: Vec<_> = joints
        .map(|(&(linear, _), &qd)| {
            u = u + linear * qd;
            u
        })
        .collect();
    velocities.reverse();
    velocities
}
