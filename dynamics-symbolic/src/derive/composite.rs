//! The mass matrix by composite bodies (Walker and Orin 1982; Featherstone 2008, 6.2).
//!
//! Column j: the wrench that accelerates the body made of links j to n by a
//! unit acceleration of joint j, carried inwards.
//!
//! Gravity is an acceleration -g of the base. M is symmetric, so joint j feels of that what the base feels
//! along -g of a unit acceleration of joint j: G_j = -g.f_j with the force of column j.
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
use crate::spatial::{Acceleration, AxisMotion, Body, Force};

/// M(q) by rows, both triangles.
pub(super) fn mass_matrix<R: Ring>(chain: &Chain<R>) -> Vec<Vec<R>> {
    let n = chain.links.len();
    let mut matrix = vec![vec![chain.zero; n]; n];
    composites(chain, |j, composite| {
        let column = chain.joint_forces(j, composite.momentum(chain.axis(j)));
        for i in chain.tree.carriers(j) {
            matrix[i][j] = column[i];
            matrix[j][i] = column[i];
        }
        matrix[j][j] = matrix[j][j] + chain.links[j].reflected;
    });
    matrix
}

/// G(q) from the forces of M's columns.
pub(super) fn gravity_vector<R: Ring>(chain: &Chain<R>) -> Vec<R> {
    let leave = |i: usize, force: Force<R>| force.leave(chain.joint(i));
    // Gravity in the axes of the links that the base carries.
    let on_base = |i: usize| chain.joint(i).enter(chain.gravity);
    let links = 0..chain.links.len();
    let gravity: Vec<_> = links
        .map(|i| chain.tree.parent(i).is_none().then(|| on_base(i)))
        .collect();
    let mut forces = vec![chain.zero; chain.links.len()];
    composites(chain, |j, composite| {
        let wrench = composite.momentum(chain.axis(j));
        chain.tree.along_carriers(j, wrench, leave, |i, force| {
            if let Some(g) = gravity[i] {
                forces[j] = -g.dot(force.f);
            }
        });
    });
    forces
}

/// V, or V + G where `gravity` is the chain's, of these velocities and of the accelerations if these are
/// constant: zero, except for the joints of a base that moves.
pub(super) fn bias_force<R: Ring>(
    chain: &Chain<R>,
    [qd, still]: [&[R]; 2],
    gravity: Vector3<R>,
) -> Vec<R> {
    let motions = chain.accelerations(gravity, qd, still);
    let mut forces = vec![chain.zero; chain.links.len()];
    let none = (Body::splat(chain.zero), Force::splat(chain.zero));
    let add = |a: (Body<R>, Force<R>), b: (Body<R>, Force<R>)| (a.0.joined(b.0), a.1 + b.1);
    chain.tree.inward(none, add, |j, (bodies, outer)| {
        let composite = bodies.joined(chain.links[j].body);
        let (joint, motion) = (chain.joint(j), &motions[j]);
        if chain.links[j].is_of_base {
            // Its joints have accelerations: the force of all links is handed on as it is.
            let force = motion.force(&composite) + outer;
            forces[j] = force.along(joint.axis_motion);
            return (Body::splat(chain.zero), force.leave(joint));
        }
        let own = motion.force(&composite).along(joint.axis_motion);
        forces[j] = own + outer.along(joint.axis_motion);
        let added = added(&composite, joint.axis_motion, motion, (qd[j], chain.zero));
        let force = (outer + added).leave(joint);
        (carried(chain, j, &composite), force)
    });
    forces
}

/// The force of what the velocity of a joint adds to the motion of the links behind it, except for what the joint
/// itself feels of that, which is nothing.
fn added<R: Ring>(
    body: &Body<R>,
    axis_motion: AxisMotion,
    motion: &Acceleration<R>,
    (qd, zero): (R, R),
) -> Force<R> {
    let ([wx, wy, wz], [hx, hy, _], j) = (motion.w.0, body.moment.0, &body.inertia);
    let (x, y) = (wx * qd, wy * qd);
    let (twice_x, twice_y) = (x + x, y + y);
    match axis_motion {
        AxisMotion::Turns => {
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
        AxisMotion::Slides => {
            let a = Vector3::new(twice_y, -twice_x, zero);
            Force {
                n: body.moment.cross(a),
                f: a * body.mass,
            }
        }
    }
}

/// From the tips inwards, hands on each link with all links outside it as one body.
fn composites<R: Ring>(chain: &Chain<R>, mut visit: impl FnMut(usize, &Body<R>)) {
    let none = Body::splat(chain.zero);
    chain.tree.inward(none, Body::joined, |j, outer| {
        let composite = outer.joined(chain.links[j].body);
        visit(j, &composite);
        carried(chain, j, &composite)
    });
}

/// Links j to the tips as one body, for the link that carries joint j; the base needs nothing of them.
fn carried<R: Ring>(chain: &Chain<R>, j: usize, composite: &Body<R>) -> Body<R> {
    match chain.tree.parent(j) {
        Some(_) => chain.joint(j).leave_body(*composite),
        None => Body::splat(chain.zero),
    }
}
