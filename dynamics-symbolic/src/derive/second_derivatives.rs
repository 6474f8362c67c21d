//! Second derivatives of inverse dynamics, in the frames of the links, by differentiating the first derivatives of
//! [`derivatives`](super::derivatives). (Singh, Wensing et al., "On second-order derivatives of rigid-body dynamics:
//! theory and implementation", 2024, derive them in spatial vectors of the base.)
//!
//! With S, psi', psi'', I, B and f as there (B is twice that of the paper), a displacement and a velocity of a joint
//! k <= j cause the forces f_j,k and g_j,k on links j to n as one body,
//!
//!   f_j,k = I_j psi_k'' + B_j psi_k'      g_j,k = 2 I_j psi_k' + B_j S_k
//!
//! in axes that move with the joint, and tau_i is S_i . f_i. Seen from the link before joint j,
//! S_k, psi_k' and psi_k'' do not change when joint j moves. With I_j', B_j', f_j' for the derivatives by its displacement
//! and B_j^, f_j^ for those by its velocity, the derivatives of tau_i for i, k <= j are
//!
//!   d2 tau_i/dq_j dq_k    = S_i . (I_j' psi_k'' + B_j' psi_k')  + S_i . (S_k x* f_j') for i < k
//!   d2 tau_i/dq_j dqd_k   = S_i . (2 I_j' psi_k' + B_j' S_k)
//!   d2 tau_i/dqd_j dq_k   = S_i . B_j^ psi_k'                   + S_i . (S_k x* f_j^) for i < k,   k < j
//!   d2 tau_i/dqd_j dqd_k  = S_i . B_j^ S_k
//!
//! with f_j' = S_j x* f_j + f_j,j and f_j^ = g_j,j. A part of B_j' comes from the velocity psi_j' that
//! the displacement adds; B_j^ is the operator of the velocity S_j alone.
//!
//! The remaining entries, of joints k <= j < i, follow from the rows e_i = S_i I_i and S_i B_i. With B_b the operator of
//! a body that moves at b, the form a . B_b c changes its sign if a and b change places. Therefore
//!
//!   d2 tau_i/dq_j dq_k    = psi_k'' . (S_j x* e_i)  + psi_k' . (S_j x S_i B_i)  - psi_j' . B_i^ psi_k'
//!   d2 tau_i/dq_j dqd_k   = 2 psi_k' . (S_j x* e_i) + S_k . (S_j x S_i B_i)     - psi_j' . B_i^ S_k
//!   d2 tau_i/dqd_j dq_k   = -S_j . B_i^ psi_k',  k < j
//!   d2 tau_i/dqd_j dqd_k  = -S_j . B_i^ S_k
//!
//! B acts on the angular part of the motion behind it; of the axis in a product with S B the angular part counts. The
//! Christoffel symbols c_ijk = 1/2 S_i . B_j^ S_k also give dM_ij/dq_k = c_ijk + c_jik.

use super::chain::Chain;
use super::derivatives::{Composite, Matrix, Moving, Rates};
use super::joints::Joints;
use super::momentum::Momentum;
use super::symbols::Symbols;
use super::{composite, derivatives};
use crate::expr::Expr;
use crate::linear::{Ring, Symmetric3, Vector3};
use crate::spatial::{AxisMotion, Body, Force, Joint, Motion};

/// A matrix for each joint force.
type Matrices<R> = Vec<Matrix<R>>;

/// The second derivatives of joint forces tau_i, of M qdd + V + G as they are made here, indexed
/// `[i][j][k]`.
pub(super) struct SecondDerivatives<R> {
    /// d2 tau_i/dq_j dq_k
    pub(super) by_position: Matrices<R>,
    /// d2 tau_i/dqd_j dqd_k
    pub(super) by_velocity: Matrices<R>,
    /// d2 tau_i/dq_j dqd_k
    pub(super) by_both: Matrices<R>,
    /// dM_ij/dq_k
    pub(super) of_inertia: Matrices<R>,
}

/// The effect of joint k on the links outside it, in the frame of one of them.
struct Effect<R> {
    /// S
    axis: Motion<R>,
    /// 2 psi'
    twice_velocity: Motion<R>,
    rates: Rates<R>,
}

/// The links from joint j on as one body, and what joint j changes of them.
struct Slopes<R> {
    /// I', B'
    body: Body<R>,
    momentum: Momentum<R>,
    /// f'
    force: Force<R>,
    /// B^
    momentum_of_axis: Momentum<R>,
    /// f^
    force_by_velocity: Force<R>,
    /// e
    inertia_row: Force<R>,
    /// S B
    coriolis_row: Vector3<R>,
}

/// The second derivatives by the recursion.
pub(super) fn recursion<'g>(
    symbols: &Symbols<'g>,
    chain: &Chain<Expr<'g>>,
    qd: &[Expr<'g>],
    qdd: &[Expr<'g>],
) -> SecondDerivatives<Expr<'g>> {
    let half = symbols.graph().half();
    let moving = Moving::new(chain, qd, qdd);
    let effects = effects(chain, &moving.rates);
    let mut derivatives = SecondDerivatives::none(chain.zero, chain.links.len());
    moving.inwards(chain, |j, composite| {
        let slopes = Slopes::new(chain, j, own_effect(&effects[j]), composite);
        derivatives.outermost(j, &slopes, &effects[j], half);
        derivatives.carried(chain, j, slopes, &effects);
    });
    derivatives
}

/// The derivatives of the first derivatives and of the mass matrix, taken on the graph: those of the joints
/// that move by themselves.
pub(super) fn differentiated<'g>(
    symbols: &Symbols<'g>,
    chain: &Chain<Expr<'g>>,
    qd: &[Expr<'g>],
    qdd: &[Expr<'g>],
) -> SecondDerivatives<Expr<'g>> {
    let first = derivatives::differentiated(symbols, chain, [qd, qdd]);
    let joints: Vec<_> = symbols.arm().free().collect();
    let positions = derivatives::along_positions(symbols, &joints, chain.one);
    let velocities = derivatives::along_velocities(qd, &joints, chain.one);
    let inertia = Joints::of(symbols).block(composite::mass_matrix(chain));
    let along = |matrix: &Matrix<Expr<'g>>, directions: &[_]| -> Matrices<Expr<'g>> {
        let entries = |x: &Expr<'g>| directions.iter().map(|d| x.derivative(d)).collect();
        let rows = matrix.iter();
        rows.map(|row| row.iter().map(entries).collect()).collect()
    };
    SecondDerivatives {
        by_position: along(&first.by_position, &positions),
        by_velocity: along(&first.by_velocity, &velocities),
        by_both: along(&first.by_position, &velocities),
        of_inertia: along(&inertia, &positions),
    }
}

impl<'g> SecondDerivatives<Expr<'g>> {
    /// The derivatives of the joints that move by themselves, from those of all rows.
    pub(super) fn of_joints(self, symbols: &Symbols<'g>) -> Self {
        let joints = Joints::of(symbols);
        SecondDerivatives {
            by_position: joints.cube(self.by_position),
            by_velocity: joints.cube(self.by_velocity),
            by_both: joints.cube(self.by_both),
            of_inertia: joints.cube(self.of_inertia),
        }
    }
}

/// The effects of the joints that carry a link, in its frame, each with the number of the joint: see
/// [`Tree::of_carriers`](crate::mechanism::Tree::of_carriers).
type Effects<R> = Vec<(usize, Effect<R>)>;

/// The effect of a link's own joint.
fn own_effect<R>(effects: &Effects<R>) -> &Effect<R> {
    &effects[effects.len() - 1].1
}

/// The effects on every link.
fn effects<R: Ring>(chain: &Chain<R>, rates: &[Rates<R>]) -> Vec<Effects<R>> {
    let own = |i: usize| Effect {
        axis: chain.axis(i),
        twice_velocity: rates[i].velocity + rates[i].velocity,
        rates: rates[i],
    };
    chain
        .tree
        .of_carriers(own, |i, effect: &Effect<R>| effect.enter(chain.joint(i)))
}

impl<R: Ring> Effect<R> {
    fn enter(&self, joint: &Joint<R>) -> Self {
        let velocity = self.rates.velocity.enter(joint);
        Effect {
            axis: self.axis.enter(joint),
            twice_velocity: velocity + velocity,
            rates: Rates {
                velocity,
                acceleration: self.rates.acceleration.enter(joint),
            },
        }
    }
}

impl<R: Ring> Slopes<R> {
    /// The slopes of joint j, which has that effect on its own link.
    fn new(chain: &Chain<R>, j: usize, own: &Effect<R>, composite: &Composite<R>) -> Self {
        let &Effect {
            axis,
            twice_velocity,
            rates,
        } = own;
        let axis_motion = chain.joint(j).axis_motion;
        let (zero, one) = (chain.zero, chain.one);
        let body = &composite.body;
        let turned = composite.momentum.displaced(axis_motion, zero, one);
        let faster = Momentum::of(body, rates.velocity.w, rates.velocity.v);
        let own = composite.apply(rates.velocity.w, rates.acceleration);
        Slopes {
            body: displaced(body, axis_motion, zero, one),
            momentum: turned.joined(faster),
            force: axis.cross_force(composite.force) + own,
            momentum_of_axis: Momentum::of(body, axis.w, axis.v),
            force_by_velocity: composite.apply(axis.w, twice_velocity),
            inertia_row: body.momentum(axis),
            coriolis_row: composite.coriolis_row(axis, axis_motion),
        }
    }

    /// I' a + B' w: of a motion with the angular velocity w and an acceleration a.
    fn apply(&self, angular: Vector3<R>, acceleration: Motion<R>) -> Force<R> {
        self.momentum.apply(angular) + self.body.momentum(acceleration)
    }

    /// The parts that are carried inwards, in the frame of the link before.
    fn leave(self, joint: &Joint<R>) -> Self {
        Slopes {
            force: self.force.leave(joint),
            force_by_velocity: self.force_by_velocity.leave(joint),
            inertia_row: self.inertia_row.leave(joint),
            coriolis_row: joint.leave(self.coriolis_row),
            ..self
        }
    }
}

/// The derivative of a body's parameters where it is displaced along z, of a joint or of the axis of one.
fn displaced<R: Ring>(body: &Body<R>, axis_motion: AxisMotion, zero: R, one: R) -> Body<R> {
    let z = Vector3::new(zero, zero, one);
    let h = body.moment;
    match axis_motion {
        // z x h, and [z]x J - J [z]x
        AxisMotion::Turns => Body {
            mass: zero,
            moment: z.cross(h),
            inertia: body.inertia.slope_about_z(zero),
        },
        AxisMotion::Slides => Body {
            mass: zero,
            moment: z * body.mass,
            inertia: Symmetric3::shift(h, z),
        },
    }
}

impl<R: Ring> SecondDerivatives<R> {
    fn none(zero: R, n: usize) -> Self {
        let none = || vec![vec![vec![zero; n]; n]; n];
        SecondDerivatives {
            by_position: none(),
            by_velocity: none(),
            by_both: none(),
            of_inertia: none(),
        }
    }

    /// Sets what the joints i and k that carry link j have to do with joint j, in its frame.
    fn outermost(&mut self, j: usize, slopes: &Slopes<R>, effects: &Effects<R>, half: R) {
        for (k, effect) in effects {
            let (k, rates) = (*k, &effect.rates);
            let by_position = slopes.apply(rates.velocity.w, rates.acceleration);
            let by_both = slopes.apply(effect.axis.w, effect.twice_velocity);
            let by_velocity = slopes.momentum_of_axis.apply(effect.axis.w);
            let of_rate = slopes.momentum_of_axis.apply(rates.velocity.w);
            for (i, Effect { axis, .. }) in effects {
                set(&mut self.by_position[*i], [j, k], axis.dot(by_position));
                set(&mut self.by_velocity[*i], [j, k], axis.dot(by_velocity));
                self.by_both[*i][j][k] = axis.dot(by_both);
                if k != j {
                    self.by_both[*i][k][j] = axis.dot(of_rate);
                }
            }
        }
        self.reversed(j, slopes, effects);
        self.inertia(j, effects, half);
    }

    /// Sets what joint j feels of joints k <= a < j by the form that changes its sign.
    fn reversed(&mut self, j: usize, slopes: &Slopes<R>, effects: &Effects<R>) {
        for (a, outer) in effects.iter().filter(|(a, _)| *a != j) {
            let row = slopes.momentum_of_axis.row(outer.rates.velocity);
            for (k, effect) in effects.iter().filter(|(k, _)| k <= a) {
                let (a, k, velocity) = (*a, *k, effect.rates.velocity);
                set(&mut self.by_position[j], [a, k], -row.dot(velocity.w));
                self.by_both[j][a][k] = -row.dot(effect.axis.w);
                let x = -self.by_velocity[a][j][k];
                set(&mut self.by_velocity[j], [a, k], x);
                if k < a {
                    self.by_both[j][k][a] = -self.by_both[a][k][j];
                }
            }
        }
    }

    /// Sets the derivatives of M by q_j, and those of its column j, of the joints that carry link j.
    fn inertia(&mut self, j: usize, effects: &Effects<R>, half: R) {
        let joints = || effects.iter().map(|(joint, _)| *joint);
        for b in joints() {
            for a in joints().filter(|a| *a <= b) {
                let [x, y] = [self.by_velocity[a][j][b], self.by_velocity[b][j][a]];
                let of_column = half * (x - y);
                let by_outermost = half * (x + y);
                self.of_inertia[a][b][j] = by_outermost;
                self.of_inertia[b][a][j] = by_outermost;
                if a < b {
                    self.of_inertia[a][j][b] = of_column;
                    self.of_inertia[j][a][b] = of_column;
                }
            }
        }
    }

    /// Adds what is carried inwards from joint j.
    fn carried(&mut self, chain: &Chain<R>, j: usize, slopes: Slopes<R>, effects: &[Effects<R>]) {
        let leave = |b: usize, slopes: Slopes<R>| slopes.leave(chain.joint(b));
        chain.tree.along_carriers(j, slopes, leave, |b, slopes| {
            self.turned_forces([j, b], slopes, &effects[b]);
            if b != j {
                self.rows([j, b], slopes, &effects[b]);
            }
        });
    }

    /// Adds S_i . (S_b x* f_j') and S_i . (S_b x* f_j^) for i < b, in the frame of joint b with the axis S_b.
    fn turned_forces(&mut self, [j, b]: [usize; 2], slopes: &Slopes<R>, effects: &Effects<R>) {
        let own = own_effect(effects).axis;
        let force = own.cross_force(slopes.force);
        let by_velocity = own.cross_force(slopes.force_by_velocity);
        for (i, Effect { axis, .. }) in effects.iter().filter(|(i, _)| *i != b) {
            add(&mut self.by_position[*i], [j, b], axis.dot(force));
            if b != j {
                let entry = &mut self.by_both[*i][b][j];
                *entry = *entry + axis.dot(by_velocity);
            }
        }
    }

    /// Adds what joint j feels of joints k <= b by its rows e and S B, in the frame of joint b with the axis S_b.
    fn rows(&mut self, [j, b]: [usize; 2], slopes: &Slopes<R>, effects: &Effects<R>) {
        let own = own_effect(effects).axis;
        let inertia_row = own.cross_force(slopes.inertia_row);
        let coriolis_row = own.w.cross(slopes.coriolis_row);
        for (k, effect) in effects {
            let Rates {
                velocity,
                acceleration,
            } = effect.rates;
            let by_position = acceleration.dot(inertia_row) + velocity.w.dot(coriolis_row);
            add(&mut self.by_position[j], [b, *k], by_position);
            let entry = &mut self.by_both[j][b][*k];
            *entry =
                *entry + effect.twice_velocity.dot(inertia_row) + effect.axis.w.dot(coriolis_row);
        }
    }
}

/// Sets an entry of a symmetric matrix.
fn set<R: Ring>(matrix: &mut Matrix<R>, [j, k]: [usize; 2], x: R) {
    matrix[j][k] = x;
    matrix[k][j] = x;
}

/// Adds to an entry of a symmetric matrix.
fn add<R: Ring>(matrix: &mut Matrix<R>, [j, k]: [usize; 2], x: R) {
    let sum = matrix[j][k] + x;
    set(matrix, [j, k], sum);
}
