//! Joints that follow others: `<mimic>`.
//!
//! A joint of the tree that follows another one of it is coupled to it, on whatever branch it is. A joint that follows one which stands
//! still beside the tree stands still itself.

use dynamics_symbolic::exact::bit_length;
use dynamics_symbolic::robot::Value;

use super::assembly::{Assembly, expression};
use super::document::{Joint, Kind, Mimic};
use crate::description::{Expr, Name, Positioned};
use crate::limits::MOST_BITS;
use crate::mistake::size;
use crate::mistake::urdf::{self as mistake, Still};
use crate::words;

impl<'a> Assembly<'a> {
    /// Couples a joint of the tree to the one that it follows, where it does.
    pub(super) fn follow(&mut self, joint: &'a Joint) {
        let mimic = joint.mimic.as_ref();
        let Some(mimic) = mimic.filter(|_| self.lock_of(joint).is_none()) else {
            return;
        };
        let Some(leader) = self.leader(joint, mimic) else {
            return;
        };
        let name = Name::new(&joint.name, mimic.place);
        if self.is_on_tree(leader) {
            let factor = Expr::signed(mimic.multiplier.clone(), mimic.place);
            let offset = expression(&mimic.offset, mimic.place);
            let leader = Name::new(&leader.name, mimic.place);
            self.coupled
                .push(Positioned::following(name, factor, &leader, offset));
        } else if !self.stands_still(leader) {
            let mistake = mistake::leader_off_chain(Still::of(joint), Still::of(leader));
            self.error(mimic.place, mistake);
        } else if let Some((position, _)) = self.position_beside(joint) {
            let position = Some(expression(&position, mimic.place));
            self.locked.push(Positioned { name, position });
        }
    }

    /// Where a joint stands still that is locked, or follows one that is, and by which lock. A joint off the tree that
    /// moves by itself is reported, as any other mistake is.
    pub(super) fn position_beside(&mut self, joint: &'a Joint) -> Option<(Value, &'a Name)> {
        let (mut factor, mut offset) = (Value::integer(1), Value::zero());
        let mut at = joint;
        for _ in 0..=self.tree.joints.len() {
            if let Some(lock) = self.lock_of(at) {
                let position = self.locked_position(at, lock)?;
                return Some((factor * position + offset, &lock.0));
            }
            let Some(mimic) = &at.mimic else {
                let mistake = match (self.is_on_tree(at), core::ptr::eq(at, joint)) {
                    (true, _) => mistake::follower_off_chain(Still::of(joint), &at.name),
                    (false, true) => mistake::off_chain(Still::of(joint)),
                    (false, false) => mistake::leader_off_chain(Still::of(joint), Still::of(at)),
                };
                self.error(joint.place, mistake);
                return None;
            };
            // k (k' q + c') + c
            offset = factor.clone() * mimic.offset.clone() + offset;
            factor = factor * Value::Rational(mimic.multiplier.clone());
            let mut numbers = [&factor, &offset]
                .into_iter()
                .filter_map(Value::as_rational);
            if numbers.any(|x| bit_length(x) > MOST_BITS) {
                self.error(mimic.place, size::digits());
                return None;
            }
            at = self.leader(at, mimic)?;
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

    /// The lock that makes a joint stand still by itself: that of its name, or that of the rest.
    fn lock_of(&self, joint: &Joint) -> Option<&'a (Name, Option<Value>)> {
        let mut locks = self.request.lock.iter();
        let lock = locks.find(|(name, _)| name.plain() == joint.name);
        lock.or_else(|| {
            let rest = self.rest_locked()?;
            let is_of_rest = self.is_beside(joint) && !self.follows_beside(joint);
            is_of_rest.then_some(rest)
        })
    }

    /// Whether a joint is beside the tree, and not left out by its name.
    fn is_beside(&self, joint: &Joint) -> bool {
        !self.is_on_tree(joint) && !self.is_ignored_by_name(joint)
    }

    /// Whether a joint follows one that stands still by its name or as one of the rest, and so is none of the rest.
    fn follows_beside(&self, joint: &Joint) -> bool {
        let leader = self.leader_of(joint);
        leader.is_some_and(|leader| {
            let mut locks = self.request.lock.iter();
            let is_named = locks.any(|(name, _)| name.plain() == leader.name);
            has_position(leader) && (is_named || self.is_beside(leader))
        })
    }

    /// Reports a joint that stands still beside the tree, beyond its limits, where it is locked.
    pub(super) fn report_out_of_limits(&self, joint: &Joint, position: &Value, lock: &Name) {
        let (still, position) = (Still::of(joint), position.to_f64(&[]));
        let is_beyond = |[lower, upper]: &[f64; 2]| !(*lower..=*upper).contains(&position);
        if let Some(limits) = still.limits.filter(is_beyond) {
            self.error(lock, mistake::still_out_of_limits(still, position, limits));
        }
    }

    /// The joint that another one follows, which has a position.
    fn leader(&self, joint: &Joint, mimic: &Mimic) -> Option<&'a Joint> {
        let leader = self.named(&mimic.joint);
        let why = match leader {
            Some(leader) if has_position(leader) => return Some(leader),
            Some(_) => mistake::WITHOUT_POSITION.to_owned(),
            None => {
                let known: Vec<&str> = self.tree.joints.iter().map(|j| j.name.as_str()).collect();
                mistake::unknown_leader(words::nearest(&mimic.joint, &known))
            }
        };
        let is_beside = !self.is_on_tree(joint);
        let mistake = mistake::no_leader(Still::of(joint), is_beside, &mimic.joint, &why);
        self.error(mimic.place, mistake);
        None
    }

    /// The joint that another one follows, whatever it is.
    fn leader_of(&self, joint: &Joint) -> Option<&'a Joint> {
        self.named(&joint.mimic.as_ref()?.joint)
    }

    pub(super) fn named(&self, name: &str) -> Option<&'a Joint> {
        self.tree.joints.iter().find(|joint| joint.name == name)
    }

    pub(super) fn is_on_tree(&self, joint: &Joint) -> bool {
        let inward = self.inward.get(joint.child.as_str());
        inward.is_some_and(|index| self.on_tree.contains(index))
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
}

fn has_position(joint: &Joint) -> bool {
    matches!(joint.kind, Kind::Revolute | Kind::Prismatic)
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
