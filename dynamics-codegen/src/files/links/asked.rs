//! The joints that a request names: those that are left out, and those that stand still. The links that it names.

use dynamics_symbolic::robot::Value;

use super::assembly::Assembly;
use super::tree::{Joint, Kind};
use crate::description::Name;
use crate::mistake::links as mistake;
use crate::words;

/// The word for all joints beside the chain that are not named. Where a joint has this name it is that joint.
const REST: &str = "rest";

impl<'a> Assembly<'a> {
    /// Names in `lock` and `ignore` that no joint has, and `rest` where it means nothing. Joints that a slip leaves out would
    /// be reported where they matter: `None` where there is one.
    pub(super) fn report_names(&mut self) -> Option<()> {
        if let Some((name, position)) = self.rest_locked() {
            self.used.push(REST.to_owned());
            if position.is_none() {
                self.error(name, mistake::rest_with_names());
            }
            if self.rest_ignored().is_some() {
                self.error(name, mistake::rest_twice());
            }
        }
        let locked = self.rest_locked().map(|(name, _)| name);
        if let Some(name) = locked.or(self.rest_ignored())
            && self.tips().is_empty()
        {
            let (first, last) = self.tree.ends();
            self.error(name, mistake::rest_of_nothing(&first, &last));
        }
        let known = self.tree.joint_names();
        let mut is_good = true;
        let locked = self.request.lock.iter().map(|(name, _)| name);
        for name in locked.chain(&self.request.ignore) {
            if !known.contains(&name.plain()) && name.plain() != REST {
                let meant = words::nearest(name.plain(), &known);
                let mistake = crate::mistake::unknown("joint", name.plain(), meant, &known);
                self.error(name, mistake);
                is_good = false;
            }
        }
        let known = self.tree.link_names();
        for name in &self.request.links {
            if !known.contains(&name.plain()) {
                let meant = words::nearest(name.plain(), &known);
                let mistake = crate::mistake::unknown("link", name.plain(), meant, &known);
                self.error(name, mistake);
                is_good = false;
            }
        }
        is_good.then_some(())
    }

    /// Whether a joint is left out, by its name or as one of the rest.
    pub(super) fn is_ignored(&self, joint: &'a Joint) -> bool {
        let is_of_rest = || {
            let moves = joint.kind != Kind::Fixed && self.rest_ignored().is_some();
            moves && !self.is_on_tree(joint) && !self.stands_still(joint)
        };
        self.is_ignored_by_name(joint) || is_of_rest()
    }

    pub(super) fn is_ignored_by_name(&self, joint: &Joint) -> bool {
        let mut ignored = self.request.ignore.iter();
        ignored.any(|name| name.plain() == joint.name)
    }

    fn rest_ignored(&self) -> Option<&'a Name> {
        let mut ignored = self.request.ignore.iter();
        let rest = ignored.find(|name| name.plain() == REST);
        rest.filter(|_| self.named(REST).is_none())
    }

    /// Where the joints beside the chain stand still that are not named.
    fn rest_locked(&self) -> Option<&'a (Name, Option<Value>)> {
        let rest = self.lock_by_name(REST);
        rest.filter(|_| self.named(REST).is_none())
    }

    fn lock_by_name(&self, word: &str) -> Option<&'a (Name, Option<Value>)> {
        let mut locks = self.request.lock.iter();
        locks.find(|(name, _)| name.plain() == word)
    }

    /// The lock that makes a joint stand still by itself: that of its name, or that of the rest.
    pub(super) fn lock_of(&self, joint: &Joint) -> Option<&'a (Name, Option<Value>)> {
        self.lock_by_name(&joint.name).or_else(|| {
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
            let is_named = self.lock_by_name(&leader.name).is_some();
            leader.moves() && (is_named || self.is_beside(leader))
        })
    }
}
