//! Groups of joints that share nothing but the base: each of them is a mechanism of its own.
//!
//! No choice of a gauge in one group changes the operations of another, so that each is searched as if it stood
//! alone. Programs whose outputs share no variable are shortened apart (`simplify_apart`). Two equal arms on one base
//! take exactly twice the operations of one. Branches on a link that moves share the effort of a search, which is
//! that of an arm for each branch.

use super::{Aligned, Forces, Joint, Law, Mechanism};
use crate::robot::Value;

impl Mechanism {
    /// Joints that have nothing but the base in common with others, by groups: the joints of a group stand on each other's
    /// links or follow each other. Joints of the base, or of a base that moves, are in the first group.
    pub(crate) fn groups(&self) -> Vec<Vec<usize>> {
        let joints = 0..self.joints.len();
        let first = joints.clone().find(|&i| !self.is_of_root(i)).unwrap_or(0);
        let own = |i: usize| if self.is_of_root(i) { first } else { i };
        let mut names: Vec<usize> = joints.clone().map(own).collect();
        for i in joints.clone() {
            let carrier = self.tree.parent(i).filter(|&other| !self.is_of_root(other));
            let leader = match &self.joints[i].law {
                Law::Following { coupling, .. } => Some(coupling.leader),
                Law::Free { .. } | Law::Base { .. } | Law::Standing { .. } => None,
            };
            for other in carrier.into_iter().chain(leader) {
                let (old, new) = (names[i], names[other]);
                let renamed = names.iter_mut().filter(|name| **name == old);
                renamed.for_each(|name| *name = new);
            }
        }
        let members = |name: usize| joints.clone().filter(|&i| names[i] == name).collect();
        let groups = joints.clone().map(members);
        groups.filter(|group: &Vec<_>| !group.is_empty()).collect()
    }

    /// Whether link i is a part of the base, be it one that moves.
    fn is_of_root(&self, i: usize) -> bool {
        let is_of_root = |i: usize| self.joints[i].stands() || self.joints[i].is_of_base();
        self.tree.carriers(i).all(is_of_root)
    }

    /// The mechanism in which joints of other groups stand still, without a place and a motor of their own. The joints
    /// keep their indices.
    pub(crate) fn only(&self, group: &[usize]) -> Mechanism {
        let mut part = self.clone();
        let mut numbers = [0, self.dof()];
        for (i, joint) in part.joints.iter_mut().enumerate() {
            if !group.contains(&i) && !self.is_of_root(i) {
                joint.stand();
            }
            let (number, kind) = match &mut joint.law {
                Law::Free { number } | Law::Base { number } => (number, 0),
                Law::Following { number, .. } => (number, 1),
                Law::Standing { .. } => continue,
            };
            *number = numbers[kind];
            numbers[kind] += 1;
        }
        part
    }
}

impl Joint {
    /// Makes it stand still where its carrier is.
    fn stand(&mut self) {
        let zero = Value::zero;
        self.law = Law::Standing { at: zero() };
        self.forces = Forces::none();
        self.aligned = Aligned {
            before: Vec::new(),
            turn: vec![zero()],
            d: zero(),
            own: Vec::new(),
        };
    }
}
