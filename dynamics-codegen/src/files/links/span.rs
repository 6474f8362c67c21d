//! The joints of a file that are on the tree of the robot: those from a link to some tips, or all that a link carries.

use std::collections::{BTreeMap, BTreeSet};

use super::assembly::Assembly;
use super::tree::{Joint, Kind};
use crate::description::Name;
use crate::mistake::links as mistake;
use crate::place::Place;
use crate::words;

impl<'a> Assembly<'a> {
    /// Finds the first link and the joints of the tree; `None` if there is no such tree, which is reported.
    pub(super) fn find(&mut self) -> Option<()> {
        self.index()?;
        match self.request.chain.as_deref() {
            None => {
                self.first = self.root()?;
                self.on_tree = self.carried(self.first, |joint| !self.is_ignored_by_name(joint));
            }
            Some(links) => {
                self.report_links(links)?;
                let (first, tips) = links.split_first()?;
                self.first = first.plain();
                self.on_tree = if tips.is_empty() {
                    self.carried(self.first, |joint| !self.is_ignored_by_name(joint))
                } else {
                    self.between(tips)?
                };
            }
        }
        let mut joints = self.on_tree.iter().map(|&joint| &self.tree.joints[joint]);
        if self.request.base.is_none() && joints.all(|joint| joint.kind == Kind::Fixed) {
            let last = self.tips().last().map(Name::plain);
            self.at_chain(mistake::nothing_moves(self.first, last));
            return None;
        }
        Some(())
    }

    fn index(&mut self) -> Option<()> {
        let mut is_tree = true;
        for (index, joint) in self.tree.joints.iter().enumerate() {
            if self.inward.insert(&joint.child, index).is_some() {
                self.error(joint.place, mistake::two_parents(&joint.child));
                is_tree = false;
            }
            self.outward.entry(&joint.parent).or_default().push(index);
        }
        is_tree.then_some(())
    }

    /// The tips to which the joints of the tree lead; empty if they are all that the first link carries.
    pub(super) fn tips(&self) -> &'a [Name] {
        let links = self.request.chain.as_deref().unwrap_or_default();
        links.get(1..).unwrap_or_default()
    }

    /// The only link to which no joint leads.
    fn root(&self) -> Option<&'a str> {
        let (roots, _) = self.tree.ends();
        let root = match roots[..] {
            [] => None,
            [root] => Some(root),
            _ => {
                let joints_of = |root: &&&str| self.carried(root, |_| true).len();
                let largest = roots.iter().max_by_key(joints_of).copied()?;
                let beside = roots.iter().copied().find(|root| *root != largest);
                let place = beside.map_or(Place::START, |root| self.place_of(root));
                self.error(place, mistake::several_trees(&roots, largest));
                return None;
            }
        };
        // Every joint that the root does not carry hangs on a circle, because there is no other root.
        let carried = root.map_or(BTreeSet::new(), |root| self.carried(root, |_| true));
        let all = 0..self.tree.joints.len();
        let Some(joint) = all.clone().find(|joint| !carried.contains(joint)) else {
            return root;
        };
        let on_circle = all.fold(joint, |joint, _| {
            let parent = self.tree.joints[joint].parent.as_str();
            self.inward.get(parent).copied().unwrap_or(joint)
        });
        self.report_circle(&self.tree.joints[on_circle]);
        None
    }

    /// Reports a joint that closes a circle of links.
    pub(super) fn report_circle(&self, joint: &Joint) {
        self.error(joint.place, mistake::circle_of_links(&joint.child));
    }

    /// The joints that a link carries, without those that are not taken and what hangs on them.
    pub(super) fn carried(
        &self,
        first: &str,
        is_taken: impl Fn(&Joint) -> bool,
    ) -> BTreeSet<usize> {
        let mut joints = BTreeSet::new();
        let mut open = vec![first];
        while let Some(link) = open.pop() {
            for &index in self.outward.get(link).into_iter().flatten() {
                let joint = &self.tree.joints[index];
                if is_taken(joint) && joints.insert(index) {
                    open.push(&joint.child);
                }
            }
        }
        joints
    }

    /// Reports names of `chain` that no link has, and those that stand in it twice.
    fn report_links(&self, links: &[Name]) -> Option<()> {
        let known = self.tree.link_names();
        let mut seen = BTreeSet::new();
        let mut is_good = true;
        for link in links {
            let name = link.plain();
            let mistake = if !known.contains(&name) {
                crate::mistake::unknown("link", name, words::nearest(name, &known), &known)
            } else if !seen.insert(name) {
                mistake::link_twice(name)
            } else {
                continue;
            };
            self.error(link, mistake);
            is_good = false;
        }
        is_good.then_some(())
    }

    /// The joints between the first link and the tips.
    fn between(&self, tips: &'a [Name]) -> Option<BTreeSet<usize>> {
        let mut joints = BTreeSet::new();
        // The links on the way to a tip, and one of these tips.
        let mut passed = BTreeMap::new();
        let mut is_good = true;
        for tip in tips {
            let (mut link, mut way) = (tip.plain(), Vec::new());
            while link != self.first {
                let joint = self.inward.get(link).copied();
                // More joints than there are lead around a circle.
                let Some(joint) = joint.filter(|_| way.len() <= self.tree.joints.len()) else {
                    self.error(tip, mistake::no_path(self.first, tip.plain(), link));
                    is_good = false;
                    way.clear();
                    break;
                };
                way.push(joint);
                link = &self.tree.joints[joint].parent;
            }
            let parent = |joint: &usize| self.tree.joints[*joint].parent.as_str();
            passed.extend(way.iter().map(parent).map(|link| (link, tip.plain())));
            joints.extend(way);
        }
        for tip in tips {
            if let Some(other) = passed.get(tip.plain()) {
                self.error(tip, mistake::on_the_way(tip.plain(), other));
                is_good = false;
            }
        }
        is_good.then_some(joints)
    }
}
