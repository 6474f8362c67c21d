//! The mass matrix by composite bodies (Walker and Orin 1982; Featherstone 2008, 6.2).
//!
//! Column j: the wrench that accelerates the body made of links j to n by a
//! unit acceleration of joint j, carried inwards.
//!
//! Gravity is an acceleration -g of the base. What joint j feels of that is, for M is symmetric, what the
//! base feels along -g of a unit acceleration of joint j: G_j = -g.f_j with the force of column j.
//!
//! V comes from the same bodies. The acceleration of a point of link k is what it would
//! have as a point of link k - 1, and what joint k adds to that; so the links outside joint j, taken as one
//! body, move with link j, and each joint k outside adds a force on the body of links k to n:
//!
//!   V_j = S_j . (force of body j in the motion of link j + sum over k > j of what joint k adds to body k).
//!
//! To the acceleration of a point at r, U r with U of [`Acceleration::u`], a revolute joint adds, with w the
//! angular velocity before it, x = w_x qd, y = w_y qd and s = (w_z + qd)^2 - w_z^2,
//!
//!   (-s r_x, -s r_y, 2 (x r_x + y r_y)),
//!
//! and a prismatic one 2 w x z qd. Where M is computed in any case, so are these
//! bodies, and what is left is shorter than the force of every link: see `fused`.

use super::chain::Chain;
use crate::linear::{Ring, Vector3};
use crate::robot::JointType;
use crate::spatial::{Acceleration, Body, Force, Motion, accelerations, felt_inwards};

/// M(q) by rows, both triangles.
pub(super) fn mass_matrix<R: Ring>(chain: &Chain<R>) -> Vec<Vec<R>> {
    let n = chain.links.len();
    let mut matrix = vec![vec![chain.zero; n]; n];
    for (j, composite) in composites(chain) {
        let column = felt_inwards(wrench(chain, j, &composite), chain.joints().take(j + 1));
        for (i, along) in column.into_iter().enumerate() {
            matrix[i][j] = along;
            matrix[j][i] = along;
        }
        matrix[j][j] = matrix[j][j] + chain.links[j].reflected;
    }
    matrix
}

/// G(q) from the forces of M's columns.
pub(super) fn gravity_vector<R: Ring>(chain: &Chain<R>) -> Vec<R> {
    let g = chain.links[0].joint.enter(chain.gravity);
    let felt = composites(chain).map(|(j, composite)| {
        let inwards = chain.links[1..=j].iter().rev();
        let on_first = inwards.fold(wrench(chain, j, &composite), |force, link| {
            force.leave(&link.joint)
        });
        -g.dot(on_first.f)
    });
    let mut felt: Vec<R> = felt.collect();
    felt.reverse();
    felt
}

/// V, or V + G where `gravity` is the chain's.
pub(super) fn bias_force<R: Ring>(chain: &Chain<R>, qd: &[R], gravity: Vector3<R>) -> Vec<R> {
    let base = Acceleration::of_base(chain.zero, gravity);
    let still = vec![chain.zero; chain.links.len()];
    let motions = accelerations(base, chain.joints(), qd, &still);
    let mut forces = vec![chain.zero; chain.links.len()];
    let mut outer = Force::splat(chain.zero);
    for (j, composite) in composites(chain) {
        let link = &chain.links[j];
        let (joint_type, motion) = (link.joint.joint_type, &motions[j]);
        forces[j] = motion.force(&composite).along(joint_type) + outer.along(joint_type);
        let added = added(&composite, joint_type, motion, (qd[j], chain.zero));
        outer = (outer + added).leave(&link.joint);
    }
    forces
}

/// The force of what the velocity of a joint adds to the motion of the links behind it, but for what the joint
/// itself feels of that, which is nothing.
fn added<R: Ring>(
    body: &Body<R>,
    joint_type: JointType,
    motion: &Acceleration<R>,
    (qd, zero): (R, R),
) -> Force<R> {
    let ([wx, wy, wz], [hx, hy, _], j) = (motion.w.0, body.moment.0, &body.inertia);
    let (x, y) = (wx * qd, wy * qd);
    let (twice_x, twice_y) = (x + x, y + y);
    match joint_type {
        JointType::Revolute => {
            let s = qd * (wz + (wz - qd));
            let apart = j.xx - j.yy;
            Force {
                n: Vector3::new(
                    y * (j.zz + apart) - twice_x * j.xy - s * j.yz,
                    s * j.xz + twice_y * j.xy - x * (j.zz - apart),
                    zero,
                ),
                f: Vector3::new(-(s * hx), -(s * hy), twice_x * hx + twice_y * hy),
            }
        }
        JointType::Prismatic => {
            let a = Vector3::new(twice_y, -twice_x, zero);
            Force {
                n: body.moment.cross(a),
                f: a * body.mass,
            }
        }
    }
}

/// From the tip inwards, each link with all links outside it as one body.
fn composites<R: Ring>(chain: &Chain<R>) -> impl Iterator<Item = (usize, Body<R>)> {
    let mut outer: Option<Body<R>> = None;
    (0..chain.links.len()).rev().map(move |j| {
        let own = chain.links[j].body;
        let composite = outer.map_or(own, |outer| {
            chain.links[j + 1].joint.leave_body(outer).joined(own)
        });
        outer = Some(composite);
        (j, composite)
    })
}

/// What a unit acceleration of joint j takes.
fn wrench<R: Ring>(chain: &Chain<R>, j: usize, composite: &Body<R>) -> Force<R> {
    let joint_type = chain.links[j].joint.joint_type;
    composite.momentum(Motion::axis(joint_type, chain.zero, chain.one))
}
