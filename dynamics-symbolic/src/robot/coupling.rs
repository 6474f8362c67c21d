//! Joints that follow others.
//!
//! The way of a follower from a table to a program:
//!
//! 1. `couple: [wrist = -elbow + deg(90)]` becomes `Row::follows`, a `Coupling` of leader, factor and offset.
//! 2. `mechanism::read` makes `Law::Following` of it. The offset of an angle joins theta. Beside a mount it stays an
//!    angle of its own.
//! 3. `Mechanism::moved_by` says by which free joint, and how, a joint moves.
//! 4. `Symbols` makes q, qd and qdd of the follower from those of its leader. The sine is that of the leader for a
//!    factor of 1 or -1, and a polynomial in it for whole factors up to 3. Any other factor has a symbol of its own,
//!    a point of the circle whose derivative by the leader's position has the factor. An identity that holds for
//!    independent points holds for dependent ones. Only cancellations between such a sine and its leader's are not
//!    found.
//! 5. Recursions run over all joints. `derive::joints` contracts forces to S' tau and matrices to S' M S, before
//!    products of velocities are made of them.
//! 6. `base::couple` finds which base parameters the coupling makes dependent.
//! 7. The proof makes the same S from the rows. It differentiates T and U along the joints that move by themselves,
//!    so that nothing is contracted there except friction.
//! 8. `emit` writes the symbols of the follower as functions of the leader's position or velocity.
//!
//! `neglect` shows that M is positive definite for the arm in which followers move by themselves, over the ranges in
//! which they follow. M of the coupled arm is S' M S, and S has independent columns. `forward_dynamics_aba` factors
//! S' M S: articulated bodies would need all links from a joint to its last follower as one body (constraint
//! embedding, Jain 2009), with the same digits.

use super::Value;

/// q = factor * q of the leader + offset: a joint that is moved by the one it follows, over a belt, a
/// gear or a parallelogram.
#[derive(Clone, Debug, PartialEq)]
pub struct Coupling<C = Value> {
    /// The row of the joint that leads. It moves by itself: it is not locked, and follows none.
    pub leader: usize,
    /// How far the follower moves for each unit of the leader, with the units of both.
    pub factor: C,
    /// Where the follower is while the leader is at zero, rad or m.
    pub offset: C,
}

impl Coupling {
    /// The factor's sign, where it is a number: 1 or -1.
    pub fn sign(&self) -> Option<i8> {
        let sign = || if self.factor.is_negative() { -1 } else { 1 };
        self.factor.is_number().then(sign)
    }
}
