//! The Lagrangian as in textbooks, expanded by differentiation on the graph.
//!
//! T = sum 1/2 (m c'.c' + w.I w) + sum 1/2 r^2 J_m qd^2 and U = -sum m g.c in
//! the world, M_ij = d2T/dqd_i dqd_j, V_i = sum c_ijk qd_j qd_k with the
//! Christoffel symbols c_ijk = 1/2 (dM_ij/dq_k + dM_ik/dq_j - dM_jk/dq_i), and
//! G_i = dU/dq_i, without springs and friction, which act at the joints themselves. Beyond three joints it is too long
//! for a program; the shorter derivations are compared with it.

use super::base::reflected;
use super::kinematics::{Pose, fixed, frames};
use super::symbols::Symbols;
use crate::expr::{Direction, Expr};
use crate::linear::{Symmetric3, Vector3};
use crate::mechanism::FixedBody;
use crate::robot::{self, Interpretation};

/// The equations of motion of the joints that move by themselves, by the textbook.
pub struct Textbook<'g> {
    /// T
    pub kinetic_energy: Expr<'g>,
    /// U
    pub potential_energy: Expr<'g>,
    /// M, by rows.
    pub mass_matrix: Vec<Vec<Expr<'g>>>,
    /// V
    pub coriolis_vector: Vec<Expr<'g>>,
    /// G
    pub gravity_vector: Vec<Expr<'g>>,
}

impl<'g> Textbook<'g> {
    /// Derives the equations from the mechanism.
    pub fn new(symbols: &mut Symbols<'g>) -> Self {
        let joints: Vec<_> = symbols.arm().free().collect();
        let n = joints.len();
        let half = symbols.graph().half();
        let kinetic_energy = kinetic_energy(symbols, half);
        let potential_energy = potential_energy(symbols);
        let one = symbols.graph().one();
        let along_qd: Vec<_> = joints
            .iter()
            .map(|&i| Direction::new().with(symbols.joint(i).qd, one))
            .collect();
        let along_q: Vec<_> = joints
            .iter()
            .map(|&i| symbols.along_position(Direction::new(), i, one))
            .collect();
        let mass_matrix: Vec<Vec<_>> = along_qd
            .iter()
            .map(|i| {
                along_qd
                    .iter()
                    .map(|j| kinetic_energy.derivative(i).derivative(j))
                    .collect()
            })
            .collect();
        let slope = |i: usize, j: usize, k: usize| mass_matrix[i][j].derivative(&along_q[k]);
        let qd: Vec<_> = joints.iter().map(|&i| symbols.joint(i).qd).collect();
        let zero = symbols.graph().zero();
        let coriolis = |i: usize| {
            let pairs = (0..n).flat_map(|j| (0..n).map(move |k| (j, k)));
            pairs.fold(zero, |sum, (j, k)| {
                let christoffel = half * (slope(i, j, k) + slope(i, k, j) - slope(j, k, i));
                sum + christoffel * qd[j] * qd[k]
            })
        };
        let coriolis_vector = (0..n).map(coriolis).collect();
        let gravity_vector = along_q
            .iter()
            .map(|direction| potential_energy.derivative(direction))
            .collect();
        Textbook {
            kinetic_energy,
            potential_energy,
            mass_matrix,
            coriolis_vector,
            gravity_vector,
        }
    }
}

/// A body of the table, and its frame.
struct Body<'g> {
    /// The link that carries it.
    link: usize,
    cells: &'g robot::Body,
    pose: Pose<'g>,
}

impl<'g> Body<'g> {
    /// The centre of mass in the world.
    fn center(&self, symbols: &mut Symbols<'g>) -> Vector3<Expr<'g>> {
        let com = Vector3(self.cells.com.each_ref().map(|x| symbols.value(x)));
        self.pose.leave(com) + self.pose.origin
    }

    /// w of [w]x = R^T R', in the body's frame.
    fn angular_velocity(&self, motion: &Direction<'g>) -> Vector3<Expr<'g>> {
        let column = |j: usize| self.pose.axes[j];
        let rate = |j: usize| Vector3(column(j).0.map(|x| x.derivative(motion)));
        let entry = |i: usize, j: usize| column(i).dot(rate(j));
        Vector3::new(entry(2, 1), entry(0, 2), entry(1, 0))
    }

    /// The inertia tensor about the centre of mass, in the body's frame.
    fn tensor(&self, symbols: &mut Symbols<'g>) -> Symmetric3<Expr<'g>> {
        let entries = self
            .cells
            .inertia
            .each_ref()
            .map(|entry| symbols.value(entry));
        Symmetric3::from_entries(entries)
    }
}

/// The links' bodies, and those that are fixed to links.
fn bodies<'g>(symbols: &mut Symbols<'g>) -> Vec<Body<'g>> {
    let frames = frames(symbols);
    let arm = symbols.arm();
    let links = arm.joints.iter().zip(&frames).enumerate();
    let links = links.map(|(link, (joint, frame))| Body {
        link,
        cells: &joint.body,
        pose: frame.pose,
    });
    let fixed_bodies = arm
        .fixed_bodies
        .iter()
        .map(|FixedBody { link, places, body }| Body {
            link: *link,
            cells: body,
            pose: fixed(symbols, &frames, (Some(*link), places)),
        });
    links.chain(fixed_bodies).collect()
}

fn kinetic_energy<'g>(symbols: &mut Symbols<'g>, half: Expr<'g>) -> Expr<'g> {
    let motion = (0..symbols.arm().joints.len()).fold(Direction::new(), |direction, i| {
        let qd = symbols.joint(i).qd;
        symbols.along_position(direction, i, qd)
    });
    let mut twice = symbols.graph().zero();
    for (i, body) in bodies(symbols).iter().enumerate() {
        let velocity = Vector3(body.center(symbols).0.map(|x| x.derivative(&motion)));
        let w = body.angular_velocity(&motion);
        let inertia = body.tensor(symbols);
        let motor = symbols.arm().joints.get(i);
        let motor = motor.map(|joint| (reflected(symbols, joint), symbols.joint(i).qd));
        let linear = symbols.value(&body.cells.mass) * velocity.dot(velocity);
        twice = twice + linear + w.dot(inertia.apply(w));
        if let Some((reflected, qd)) = motor {
            twice = twice + reflected * qd * qd;
        }
    }
    half * twice
}

fn potential_energy<'g>(symbols: &mut Symbols<'g>) -> Expr<'g> {
    let gravity = Vector3([0, 1, 2].map(|k| symbols.value(&symbols.arm().gravity[k])));
    let mut energy = symbols.graph().zero();
    let arm = symbols.arm();
    let bodies = bodies(symbols).into_iter();
    for body in bodies.filter(|body| !arm.is_of_base(body.link)) {
        let center = body.center(symbols);
        energy = energy - symbols.value(&body.cells.mass) * gravity.dot(center);
    }
    energy
}
