//! Joints that follow others.

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
