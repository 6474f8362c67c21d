//! Joints that follow others.
//!
//! A joint of the tree that follows another one of it is coupled to it, on whatever branch it is. A joint that follows one which stands
//! still beside the tree stands still itself.

use dynamics_symbolic::exact::bit_length;
use dynamics_symbolic::robot::{JointType, Placement, Value};

use super::assembly::Assembly;
use super::tree::{Follows, Joint, Kind};
use crate::description::{Expr, Name, Positioned};
use crate::limits::MOST_BITS;
use crate::mistake::links::{self as mistake, Still};
use crate::mistake::{Mistake, size};
use crate::words;

impl<'a> Assembly<'a> {
    /// Couples a joint of the tree to the one that it follows, where it does.
    pub(super) fn follow(&mut self, joint: &'a Joint) {
        let follows = joint.follows.as_ref();
        let Some(follows) = follows.filter(|_| self.lock_of(joint).is_none()) else {
            return;
        };
        let Some(leader) = self.leader(joint, follows) else {
            return;
        };
        let (place, known) = (follows.place, |value| Expr::known(value, follows.place));
        let name = Name::new(&joint.name, place);
        if self.is_on_tree(leader) {
            let factor = known(Value::Rational(follows.factor.clone()));
            let (leader, offset) = (
                Name::new(&leader.name, place),
                known(follows.offset.clone()),
            );
            self.coupled
                .push(Positioned::following(name, factor, &leader, offset));
        } else if !self.stands_still(leader) {
            self.error(place, self.leader_off_chain(joint, leader));
        } else if let Some((position, _)) = self.position_beside(joint) {
            let position = Some(known(position));
            self.locked.push(Positioned { name, position });
        }
    }

    /// Where a joint stands still that is locked, or follows one that is, and by which lock. A joint off the tree that
    /// moves by itself is reported, as any other mistake is.
    fn position_beside(&mut self, joint: &'a Joint) -> Option<(Value, &'a Name)> {
        let (mut factor, mut offset) = (Value::integer(1), Value::zero());
        let mut at = joint;
        for _ in 0..=self.tree.joints.len() {
            if let Some(lock) = self.lock_of(at) {
                let position = self.locked_position(at, lock)?;
                return Some((factor * position + offset, &lock.0));
            }
            let Some(follows) = &at.follows else {
                let mistake = match (self.is_on_tree(at), core::ptr::eq(at, joint)) {
                    (true, _) => {
                        let follower = self.tree.words.follower;
                        mistake::follower_off_chain(Still::of(joint), &at.name, follower)
                    }
                    (false, true) => mistake::off_chain(Still::of(joint)),
                    (false, false) => self.leader_off_chain(joint, at),
                };
                self.error(joint.place, mistake);
                return None;
            };
            // k (k' q + c') + c
            offset = factor.clone() * follows.offset.clone() + offset;
            factor = factor * Value::Rational(follows.factor.clone());
            let mut numbers = [&factor, &offset]
                .into_iter()
                .filter_map(Value::as_rational);
            if numbers.any(|x| bit_length(x) > MOST_BITS) {
                self.error(follows.place, size::digits());
                return None;
            }
            at = self.leader(at, follows)?;
        }
        self.error(joint.place, mistake::circle(&joint.name));
        None
    }

    /// Whether a joint is locked, or follows one that is.
    pub(super) fn stands_still(&self, joint: &'a Joint) -> bool {
        let mut at = joint;
        for _ in 0..=self.tree.joints.len() {
            if self.lock_of(at).is_some() {
                return true;
            }
            let Some(next) = self.leader_of(at) else {
                return false;
            };
            at = next;
        }
        false
    }

    /// Reports a joint that stands still beside the tree, beyond its limits, where it is locked.
    fn report_out_of_limits(&self, joint: &Joint, position: &Value, lock: &Name) {
        let (still, position) = (Still::of(joint), position.to_f64(&[]));
        let is_beyond = |[lower, upper]: &[f64; 2]| !(*lower..=*upper).contains(&position);
        if let Some(limits) = still.limits.filter(is_beyond) {
            self.error(lock, mistake::still_out_of_limits(still, position, limits));
        }
    }

    /// The joint that another one follows, which has a position.
    fn leader(&self, joint: &Joint, follows: &Follows) -> Option<&'a Joint> {
        let word = &follows.leader;
        let why = match self.named(word) {
            Some(leader) if leader.moves() => return Some(leader),
            Some(_) => mistake::WITHOUT_POSITION.to_owned(),
            None => mistake::unknown_leader(words::nearest(word, &self.tree.joint_names())),
        };
        let (is_beside, follower) = (!self.is_on_tree(joint), self.tree.words.follower);
        let mistake = mistake::no_leader(Still::of(joint), is_beside, word, &why, follower);
        self.error(follows.place, mistake);
        None
    }

    fn leader_off_chain(&self, joint: &Joint, leader: &Joint) -> Mistake {
        let follower = self.tree.words.follower;
        mistake::leader_off_chain(Still::of(joint), Still::of(leader), follower)
    }

    /// The joint that another one follows, whatever it is.
    pub(super) fn leader_of(&self, joint: &Joint) -> Option<&'a Joint> {
        self.named(&joint.follows.as_ref()?.leader)
    }

    /// The position of a joint that the call locks.
    fn locked_position(
        &mut self,
        joint: &Joint,
        (name, position): &(Name, Option<Value>),
    ) -> Option<Value> {
        if !self.is_on_tree(joint) {
            self.used.push(joint.name.clone());
        }
        // A mistake in the position of `rest` is reported once, where `rest` is read.
        if position.is_none() && name.plain() == joint.name {
            self.error(name, mistake::lock_with_names(&joint.name));
        }
        position.clone()
    }

    /// The displacement by a joint beside the tree, which stands still.
    pub(super) fn displacement(&mut self, joint: &'a Joint) -> Option<[Placement; 4]> {
        let (position, lock) = self.position_beside(joint)?;
        self.report_out_of_limits(joint, &position, lock);
        let [azimuth, polar] = joint.axis.clone();
        let turn = |roll, pitch, yaw| Placement {
            xyz: [(); 3].map(|()| Value::zero()),
            rpy: [roll, pitch, yaw],
        };
        let zero = Value::zero;
        let along = match joint.kind {
            Kind::Moves(JointType::Prismatic) => Placement {
                xyz: [zero(), zero(), position],
                ..turn(zero(), zero(), zero())
            },
            _ => turn(zero(), zero(), position),
        };
        Some([
            turn(zero(), polar.clone(), azimuth.clone()),
            along,
            turn(zero(), -polar, zero()),
            turn(zero(), zero(), -azimuth),
        ])
    }
}

impl<'a> Still<'a> {
    /// A joint for which it is proposed that it stands still. Limits of which the lower one is above are none.
    fn of(joint: &'a Joint) -> Still<'a> {
        let limits = joint.limits.as_ref();
        let limits =
            limits.map(|(limits, _)| limits.each_ref().map(|limit| limit.to_f64().value()));
        Still {
            joint: &joint.name,
            limits: limits.filter(|[lower, upper]| lower <= upper),
        }
    }
}
