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
//! axes that move with them, and psi'' what it adds to their accelerations. Terms with index i are
//! wrenches that are carried inwards from joint to joint. In the others the rows S_i I_i and S_i B_i are
//! carried so.
//!
//! Velocities and accelerations are those of frames' origins: with U as in
//! [`Acceleration`] and a the acceleration of the origin,
//!
//!   revolute:  psi' = (w x z, v x z),  psi'' = (U z, a x z + 2 v x (w x z))
//!   prismatic: psi' = (0, w x z),      psi'' = (0, U z).

use super::chain::{Chain, Link};
use super::joints::Joints;
use super::momentum::Momentum;
use super::recursive;
use super::symbols::Symbols;
use crate::expr::{Direction, Expr};
use crate::linear::{Ring, Vector3};
use crate::spatial::{Acceleration, AxisMotion, Body, Force, Joint, Motion};

pub(super) type Matrix<R> = Vec<Vec<R>>;

/// The derivatives of joint forces, row i those of tau_i: of M qdd + V + G as they are made here.
/// The recursion has those of the joints of all rows.
pub(super) struct ForceDerivatives<R> {
    /// d tau/dq
    pub(super) by_position: Matrix<R>,
    /// d tau/dqd
    pub(super) by_velocity: Matrix<R>,
}

/// The velocity and the acceleration that a displacement of a joint adds to the links outside it.
#[derive(Clone, Copy)]
pub(super) struct Rates<R> {
    /// psi'
    pub(super) velocity: Motion<R>,
    /// psi''
    pub(super) acceleration: Motion<R>,
}

/// How the links move, and what displacements of their joints add.
pub(super) struct Moving<R> {
    accelerations: Vec<Acceleration<R>>,
    velocities: Vec<Vector3<R>>,
    pub(super) rates: Vec<Rates<R>>,
}

/// The links from some joint on, as one body.
#[derive(Clone)]
pub(super) struct Composite<R> {
    pub(super) body: Body<R>,
    pub(super) momentum: Momentum<R>,
    pub(super) force: Force<R>,
}

/// The derivatives by the recursion.
pub(super) fn recursion<R: Ring>(chain: &Chain<R>, qd: &[R], qdd: &[R]) -> ForceDerivatives<R> {
    let n = chain.links.len();
    let zero = chain.zero;
    let moving = Moving::new(chain, qd, qdd);
    let mut derivatives = ForceDerivatives {
        by_position: vec![vec![zero; n]; n],
        by_velocity: vec![vec![zero; n]; n],
    };
    moving.inwards(chain, |i, composite| {
        derivatives.column_and_row(chain, &moving.rates, composite, i);
    });
    derivatives
}

impl<'g> ForceDerivatives<Expr<'g>> {
    /// The derivatives of the joints that move by themselves, from those of all rows.
    pub(super) fn of_joints(self, symbols: &Symbols<'g>) -> Self {
        let joints = Joints::of(symbols);
        ForceDerivatives {
            by_position: joints.block(self.by_position),
            by_velocity: joints.block(self.by_velocity),
        }
    }
}

impl<R: Ring> Moving<R> {
    pub(super) fn new(chain: &Chain<R>, qd: &[R], qdd: &[R]) -> Self {
        let accelerations = chain.accelerations(chain.gravity, qd, qdd);
        let velocities = velocities(chain, &accelerations, qd);
        let links = chain.links.iter().zip(&accelerations).zip(&velocities);
        let rates = links.map(|((link, a), &v)| Rates::new(chain, &link.joint, a, v));
        Moving {
            rates: rates.collect(),
            accelerations,
            velocities,
        }
    }

    /// Visits each joint, from the tips inwards, with the links outside it as one body in its frame.
    pub(super) fn inwards(&self, chain: &Chain<R>, mut visit: impl FnMut(usize, &Composite<R>)) {
        let none = Composite::none(chain.zero);
        chain.tree.inward(none, Composite::joined, |i, outer| {
            let composite = outer.with(&chain.links[i], &self.accelerations[i], self.velocities[i]);
            visit(i, &composite);
            composite.leave(chain.joint(i))
        });
    }
}

/// The derivatives of the recursive inverse dynamics, taken on the graph: those of the joints that move
/// by themselves.
pub(super) fn differentiated<'g>(
    symbols: &Symbols<'g>,
    chain: &Chain<Expr<'g>>,
    [qd, qdd]: [&[Expr<'g>]; 2],
) -> ForceDerivatives<Expr<'g>> {
    let forces = recursive::inverse_dynamics(chain, qd, qdd, chain.gravity);
    let forces = Joints::of(symbols).entries(forces);
    let along = |directions: Vec<Direction<'g>>| -> Matrix<Expr<'g>> {
        let row = |force: &Expr<'g>| directions.iter().map(|d| force.derivative(d)).collect();
        forces.iter().map(row).collect()
    };
    let joints: Vec<_> = symbols.arm().free().collect();
    ForceDerivatives {
        by_position: along(along_positions(symbols, &joints, chain.one)),
        by_velocity: along(along_velocities(qd, &joints, chain.one)),
    }
}

/// The directions of the positions of some joints.
pub(super) fn along_positions<'g>(
    symbols: &Symbols<'g>,
    joints: &[usize],
    one: Expr<'g>,
) -> Vec<Direction<'g>> {
    let along = |&i: &usize| symbols.along_position(Direction::new(), i, one);
    joints.iter().map(along).collect()
}

/// The directions of their velocities.
pub(super) fn along_velocities<'g>(
    qd: &[Expr<'g>],
    joints: &[usize],
    one: Expr<'g>,
) -> Vec<Direction<'g>> {
    let along = |&i: &usize| Direction::new().with(qd[i], one);
    joints.iter().map(along).collect()
}

/// The sum of the products of two lists, as far as both go.
pub(super) fn sum_of_products<'g>(zero: Expr<'g>, a: &[Expr<'g>], b: &[Expr<'g>]) -> Expr<'g> {
    a.iter().zip(b).fold(zero, |sum, (&a, &b)| sum + a * b)
}

/// The velocities of the frames' origins.
fn velocities<R: Ring>(
    chain: &Chain<R>,
    accelerations: &[Acceleration<R>],
    qd: &[R],
) -> Vec<Vector3<R>> {
    let rest = Vector3::splat(chain.zero);
    chain.tree.outward(rest, |i, &before| {
        let parent = chain.tree.parent(i);
        let w = parent.map_or(rest, |parent| accelerations[parent].w);
        let joint = chain.joint(i);
        let v = joint.enter(before + w.cross(joint.position()));
        match joint.axis_motion {
            AxisMotion::Turns => v,
            AxisMotion::Slides => v.plus_z(qd[i]),
        }
    })
}

impl<R: Ring> Rates<R> {
    fn new(
        chain: &Chain<R>,
        joint: &Joint<R>,
        acceleration: &Acceleration<R>,
        v: Vector3<R>,
    ) -> Self {
        let none = Vector3::splat(chain.zero);
        let z = Vector3::new(chain.zero, chain.zero, chain.one);
        let turning = acceleration.w.cross(z);
        let u = acceleration.u().column(2);
        match joint.axis_motion {
            AxisMotion::Turns => Rates {
                velocity: Motion {
                    w: turning,
                    v: v.cross(z),
                },
                acceleration: Motion {
                    w: u,
                    v: acceleration.a.cross(z) + twice(v.cross(turning)),
                },
            },
            AxisMotion::Slides => Rates {
                velocity: Motion {
                    w: none,
                    v: turning,
                },
                acceleration: Motion { w: none, v: u },
            },
        }
    }
}

impl<R: Ring> Composite<R> {
    fn none(zero: R) -> Self {
        Composite {
            body: Body::splat(zero),
            momentum: Momentum::none(zero),
            force: Force::splat(zero),
        }
    }

    fn with(self, link: &Link<R>, acceleration: &Acceleration<R>, v: Vector3<R>) -> Self {
        let body = self.body.joined(link.body);
        let own = Momentum::of(&link.body, acceleration.w, v);
        Composite {
            body,
            momentum: self.momentum.joined(own),
            force: self.force + link.writing.force(acceleration, &link.body),
        }
    }

    fn joined(self, other: Self) -> Self {
        Composite {
            body: self.body.joined(other.body),
            momentum: self.momentum.joined(other.momentum),
            force: self.force + other.force,
        }
    }

    fn leave(&self, joint: &Joint<R>) -> Self {
        Composite {
            body: joint.leave_body(self.body),
            momentum: self.momentum.leave(joint),
            force: self.force.leave(joint),
        }
    }

    /// 2 B a + I m: what a motion with the angular velocity a and an acceleration m take.
    pub(super) fn apply(&self, angular: Vector3<R>, acceleration: Motion<R>) -> Force<R> {
        self.momentum.apply(angular) + self.body.momentum(acceleration)
    }

    /// 2 S B for the axis S along z: it acts on angular velocities alone.
    pub(super) fn coriolis_row(&self, axis: Motion<R>, axis_motion: AxisMotion) -> Vector3<R> {
        match axis_motion {
            AxisMotion::Turns => Vector3(self.momentum.n.0[2]),
            AxisMotion::Slides => self.momentum.p.cross(axis.v),
        }
    }
}

impl<R: Ring> ForceDerivatives<R> {
    /// Column i down to the diagonal, and row i up to it: carried inwards from frame i.
    fn column_and_row(
        &mut self,
        chain: &Chain<R>,
        rates: &[Rates<R>],
        composite: &Composite<R>,
        i: usize,
    ) {
        let own = chain.axis(i);
        let Rates {
            velocity,
            acceleration,
        } = rates[i];
        let by_position =
            composite.apply(velocity.w, acceleration) + own.cross_force(composite.force);
        let by_velocity = composite.apply(own.w, velocity + velocity);
        // The forces by the position and by the velocity of joint i, and S_i I_i; behind them S_i 2 B_i.
        let forces = [by_position, by_velocity, composite.body.momentum(own)];
        let coriolis_row = composite.coriolis_row(own, chain.joint(i).axis_motion);
        let leave = |j: usize, (forces, row): ([Force<R>; 3], Vector3<R>)| {
            let joint = chain.joint(j);
            (forces.map(|force| force.leave(joint)), joint.leave(row))
        };
        let carried = (forces, coriolis_row);
        chain.tree.along_carriers(i, carried, leave, |j, carried| {
            let ([by_position, by_velocity, inertia_row], coriolis_row) = *carried;
            let axis_motion = chain.joint(j).axis_motion;
            self.by_position[j][i] = by_position.along(axis_motion);
            self.by_velocity[j][i] = by_velocity.along(axis_motion);
            if j != i {
                let Rates {
                    velocity,
                    acceleration,
                } = rates[j];
                self.by_position[i][j] =
                    coriolis_row.dot(velocity.w) + acceleration.dot(inertia_row);
                self.by_velocity[i][j] =
                    coriolis_row.dot(chain.axis(j).w) + (velocity + velocity).dot(inertia_row);
            }
        });
    }
}

fn twice<R: Ring>(v: Vector3<R>) -> Vector3<R> {
    v + v
}
