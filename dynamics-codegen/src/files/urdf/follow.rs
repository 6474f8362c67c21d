//! Joints that follow others: `<mimic>`.
//!
//! What follows a joint on the chain is coupled to it, on whichever side of it. What follows a joint that
//! stands still beside the chain stands still itself.

use dynamics_symbolic::robot::Value;

use super::chain::{Chain, expression};
use super::document::{Joint, Kind, Mimic};
use crate::description::{Coupled, Locked, Name};
use crate::files::signed::signed;
use crate::mistake::urdf as mistake;
use crate::words;

impl<'a> Chain<'a> {
    /// Couples a joint on the chain to the one that it follows, where it does.
    pub(super) fn follow(&mut self, joint: &'a Joint) {
        let Some(mimic) = joint.mimic.as_ref().filter(|_| !self.is_locked(joint)) else {
            return;
        };
        let Some(leader) = self.leader(joint, mimic) else {
            return;
        };
        let name = Name::new(&joint.name, mimic.place);
        if self.is_on_chain(leader) {
            let factor = signed(mimic.multiplier.clone(), mimic.place);
            let offset = expression(&mimic.offset, mimic.place);
            let leader = Name::new(&leader.name, mimic.place);
            self.coupled
                .push(Coupled::new(name, factor, &leader, offset));
        } else if !self.stands_still(leader) {
            let mistake = mistake::leader_off_chain(&joint.name, &leader.name);
            self.error(mimic.place, mistake);
        } else if let Some(position) = self.position_beside(joint) {
            let position = Some(expression(&position, mimic.place));
            self.locked.push(Locked { name, position });
        }
    }

    /// Where a joint stands still that is locked, or follows one that is. What is wrong is reported, of a joint
    /// off the chain that moves by itself too.
    pub(super) fn position_beside(&mut self, joint: &'a Joint) -> Option<Value> {
        let (mut factor, mut offset) = (Value::integer(1), Value::zero());
        let mut at = joint;
        for _ in 0..=self.tree.joints.len() {
            if self.is_locked(at) {
                let position = self.locked_position(at)?;
                return Some(factor * position + offset);
            }
            let Some(mimic) = &at.mimic else {
                let mistake = match (self.is_on_chain(at), core::ptr::eq(at, joint)) {
                    (true, _) => mistake::follower_off_chain(&joint.name, &at.name),
                    (false, true) => mistake::off_chain(&joint.name),
                    (false, false) => mistake::leader_off_chain(&joint.name, &at.name),
                };
                self.error(joint.place, mistake);
                return None;
            };
            // k (k' q + c') + c
            offset = factor.clone() * mimic.offset.clone() + offset;
            factor = factor * Value::Rational(mimic.multiplier.clone());
            at = self.leader(at, mimic)?;
        }
        self.error(joint.place, mistake::circle(&joint.name));
        None
    }

    /// Whether a joint is locked, or follows one that is.
    pub(super) fn stands_still(&self, joint: &'a Joint) -> bool {
        let mut at = joint;
        for _ in 0..=self.tree.joints.len() {
            if self.is_locked(at) {
                return true;
            }
            let next = at.mimic.as_ref().and_then(|mimic| self.named(&mimic.joint));
            let Some(next) = next else {
                return false;
            };
            at = next;
        }
        false
    }

    /// The joint that another one follows, which has a position.
    fn leader(&self, joint: &Joint, mimic: &Mimic) -> Option<&'a Joint> {
        let Some(leader) = self.named(&mimic.joint) else {
            let known: Vec<&str> = self.tree.joints.iter().map(|j| j.name.as_str()).collect();
            let meant = words::nearest(&mimic.joint, &known);
            let mistake = mistake::unknown_leader(&joint.name, &mimic.joint, meant);
            self.error(mimic.place, mistake);
            return None;
        };
        if !matches!(leader.kind, Kind::Revolute | Kind::Prismatic) {
            let mistake = mistake::leader_without_position(&joint.name, &leader.name);
            self.error(mimic.place, mistake);
            return None;
        }
        Some(leader)
    }

    fn named(&self, name: &str) -> Option<&'a Joint> {
        self.tree.joints.iter().find(|joint| joint.name == name)
    }

    fn is_on_chain(&self, joint: &Joint) -> bool {
        let mut on_chain = self.on_chain.iter();
        on_chain.any(|&index| self.tree.joints[index].name == joint.name)
    }

    /// The position of a joint that the call locks.
    fn locked_position(&mut self, joint: &Joint) -> Option<Value> {
        let mut locks = self.request.lock.iter();
        let (name, position) = locks.find(|(name, _)| name.plain() == joint.name)?;
        if !self.is_on_chain(joint) {
            self.used.push(joint.name.clone());
        }
        if position.is_none() {
            self.error(name, mistake::lock_with_names(&joint.name));
        }
        position.clone()
    }
}
