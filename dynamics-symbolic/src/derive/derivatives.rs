//! Derivatives of inverse dynamics by position and velocity (Singh, Russell and Wensing,
//! "Efficient analytical derivatives of rigid-body dynamics using spatial vector algebra", 2022),
//! in the frames of the links.
//!
//! With S_i the axis of joint i, v its link's velocity, and the inertia I_i, the
//! Coriolis operator B_i and the wrench f_i of links i to n as one, for j <= i:
//!
//!   d tau_j/dqd_i = S_j . 2 (B_i S_i + I_i psi_i')
//!   d tau_i/dqd_j = S_i . 2 (B_i S_j + I_i psi_j')
//!   d tau_j/dq_i  = S_j . (2 B_i psi_i' + I_i psi_i'' + S_i x* f_i)
//!   d tau_i/dq_j  = S_i . (2 B_i psi_j' + I_i psi_j'')
//!
//! psi' = v x S is what a displacement of the joint adds to the velocities of the links outside it, in
//! axes that move with them, and psi'' what it adds to their accelerations. What has index i is
//! a wrench that is carried inwards from joint to joint; of the others the rows S_i I_i and S_i B_i are.
//!
//! Velocities and accelerations are those of frames' origins: with U as in
//! [`recursive`](super::recursive) and a the acceleration of the origin,
//!
//!   revolute:  psi' = (w x z, v x z),  psi'' = (U z, a x z + 2 v x (w x z))
//!   prismatic: psi' = (0, w x z),      psi'' = (0, U z).

use super::chain::{Chain, Link};
use super::inertia::Body;
use super::momentum::Momentum;
use super::recursive::{self, motions, wrench};
use super::spatial::{Force, Motion, momentum};
use super::symbols::Symbols;
use crate::expr::{Direction, Expr};
use crate::linear::Vector3;
use crate::robot::JointType;

type Vector<'g> = Vector3<Expr<'g>>;
type Matrix<'g> = Vec<Vec<Expr<'g>>>;

/// The derivatives of joint forces, without friction; row i belongs to tau_i.
pub(super) struct ForceDerivatives<'g> {
    /// d tau/dq
    pub(super) by_position: Matrix<'g>,
    /// d tau/dqd
    pub(super) by_velocity: Matrix<'g>,
}

/// What a displacement of a joint adds to the links outside it.
#[derive(Clone, Copy)]
struct Rates<'g> {
    /// psi'
    velocity: Motion<'g>,
    /// psi''
    acceleration: Motion<'g>,
}

/// The links from some joint on, as one body.
struct Composite<'g> {
    body: Body<Expr<'g>>,
    momentum: Momentum<'g>,
    wrench: Force<'g>,
}

/// The derivatives by the recursion.
pub(super) fn recursion<'g>(
    chain: &Chain<'g>,
    qd: &[Expr<'g>],
    qdd: &[Expr<'g>],
) -> ForceDerivatives<'g> {
    let n = chain.links.len();
    let zero = chain.zero;
    let motions = motions(chain, qd, qdd, chain.gravity);
    let velocities = velocities(chain, &motions, qd);
    let links = chain.links.iter().zip(&motions).zip(&velocities);
    let rates: Vec<_> = links
        .map(|((link, m), &v)| Rates::new(chain, link, m, v))
        .collect();
    let mut derivatives = ForceDerivatives {
        by_position: vec![vec![zero; n]; n],
        by_velocity: vec![vec![zero; n]; n],
    };
    let mut composite = Composite::none(zero);
    for i in (0..n).rev() {
        let link = &chain.links[i];
        composite.join(link, &motions[i], velocities[i]);
        derivatives.column_and_row(chain, &rates, &composite, i);
        composite = composite.leave(link, zero);
    }
    derivatives
}

/// The derivatives of the recursive inverse dynamics, taken on the graph.
pub(super) fn differentiated<'g>(
    symbols: &Symbols<'g>,
    chain: &Chain<'g>,
    qd: &[Expr<'g>],
    qdd: &[Expr<'g>],
) -> ForceDerivatives<'g> {
    let forces = recursive::inverse_dynamics(chain, qd, qdd, chain.gravity);
    let along = |directions: Vec<Direction<'g>>| -> Matrix<'g> {
        let row = |force: &Expr<'g>| directions.iter().map(|d| force.derivative(d)).collect();
        forces.iter().map(row).collect()
    };
    let positions = (0..qd.len()).map(|i| symbols.along_position(Direction::new(), i, chain.one));
    let velocities = qd.iter().map(|&qd| match qd.is_zero() {
        true => Direction::new(),
        false => Direction::new().with(qd, chain.one),
    });
    ForceDerivatives {
        by_position: along(positions.collect()),
        by_velocity: along(velocities.collect()),
    }
}

/// The velocities of the frames' origins.
fn velocities<'g>(
    chain: &Chain<'g>,
    motions: &[recursive::Motion<'g>],
    qd: &[Expr<'g>],
) -> Vec<Vector<'g>> {
    let rest = Vector3::splat(chain.zero);
    let (mut w, mut v) = (rest, rest);
    let links = chain.links.iter().zip(motions).zip(qd);
    let velocities = links.map(|((link, motion), &qd)| {
        v = link.enter(v + w.cross(link.position(chain.zero)));
        if link.joint_type == JointType::Prismatic {
            v.0[2] = v[2] + qd;
        }
        w = motion.w;
        v
    });
    velocities.collect()
}

impl<'g> Rates<'g> {
    fn new(
        chain: &Chain<'g>,
        link: &Link<'g>,
        motion: &recursive::Motion<'g>,
        v: Vector<'g>,
    ) -> Self {
        let none = Vector3::splat(chain.zero);
        let z = Vector3::new(chain.zero, chain.zero, chain.one);
        let turning = motion.w.cross(z);
        let u = motion.u().column(2);
        match link.joint_type {
            JointType::Revolute => Rates {
                velocity: Motion {
                    w: turning,
                    v: v.cross(z),
                },
                acceleration: Motion {
                    w: u,
                    v: motion.a.cross(z) + twice(v.cross(turning)),
                },
            },
            JointType::Prismatic => Rates {
                velocity: Motion {
                    w: none,
                    v: turning,
                },
                acceleration: Motion { w: none, v: u },
            },
        }
    }
}

impl<'g> Composite<'g> {
    fn none(zero: Expr<'g>) -> Self {
        let none = Vector3::splat(zero);
        Composite {
            body: Body::splat(zero),
            momentum: Momentum::none(zero),
            wrench: Force { n: none, f: none },
        }
    }

    fn join(&mut self, link: &Link<'g>, motion: &recursive::Motion<'g>, v: Vector<'g>) {
        self.body = self.body.joined(link.body);
        let own = Momentum::of(&link.body, motion.w, v);
        self.momentum = self.momentum.joined(own);
        let (f, n) = wrench(&link.body, motion);
        self.wrench = self.wrench.plus(Force { n, f });
    }

    fn leave(&self, link: &Link<'g>, zero: Expr<'g>) -> Self {
        Composite {
            body: link.leave_body(self.body),
            momentum: self.momentum.leave(link, zero),
            wrench: self.wrench.leave(link, zero),
        }
    }

    /// 2 B a + I m: what a motion with the angular velocity a and an acceleration m take.
    fn apply(&self, angular: Vector<'g>, acceleration: Motion<'g>) -> Force<'g> {
        let coriolis = Force {
            n: self.momentum.n.apply(angular),
            f: angular.cross(self.momentum.p),
        };
        coriolis.plus(momentum(&self.body, acceleration))
    }

    /// 2 S B for the axis S along z: it acts on angular velocities alone.
    fn coriolis_row(&self, axis: Motion<'g>, joint_type: JointType) -> Vector<'g> {
        match joint_type {
            JointType::Revolute => Vector3(self.momentum.n.0[2]),
            JointType::Prismatic => self.momentum.p.cross(axis.v),
        }
    }
}

impl<'g> ForceDerivatives<'g> {
    /// Column i down to the diagonal, and row i up to it: carried inwards from frame i.
    fn column_and_row(
        &mut self,
        chain: &Chain<'g>,
        rates: &[Rates<'g>],
        composite: &Composite<'g>,
        i: usize,
    ) {
        let zero = chain.zero;
        let axis = |link: &Link<'g>| Motion::axis(link.joint_type, zero, chain.one);
        let own = axis(&chain.links[i]);
        let Rates {
            velocity,
            acceleration,
        } = rates[i];
        let mut by_position = composite
            .apply(velocity.w, acceleration)
            .plus(own.cross_force(composite.wrench));
        let mut by_velocity = composite.apply(own.w, velocity.twice());
        let mut inertia_row = momentum(&composite.body, own);
        let mut coriolis_row = composite.coriolis_row(own, chain.links[i].joint_type);
        for j in (0..=i).rev() {
            let link = &chain.links[j];
            self.by_position[j][i] = by_position.along(link.joint_type);
            self.by_velocity[j][i] = by_velocity.along(link.joint_type);
            if j < i {
                let Rates {
                    velocity,
                    acceleration,
                } = rates[j];
                self.by_position[i][j] =
                    coriolis_row.dot(velocity.w) + acceleration.dot(inertia_row);
                self.by_velocity[i][j] =
                    coriolis_row.dot(axis(link).w) + velocity.twice().dot(inertia_row);
            }
            if j == 0 {
                break;
            }
            by_position = by_position.leave(link, zero);
            by_velocity = by_velocity.leave(link, zero);
            inertia_row = inertia_row.leave(link, zero);
            coriolis_row = link.leave(coriolis_row);
        }
    }
}

fn twice<'g>(v: Vector<'g>) -> Vector<'g> {
    v + v
}
