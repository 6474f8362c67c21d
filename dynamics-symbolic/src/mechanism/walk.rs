//! The walks over the links of an arm: outwards, inwards, and along the joints that carry a link.
//!
//! A recursion hands its step to one of these walks, which know which link carries which joint. A serial arm is the
//! case in which every joint stands on the link before it.

/// Which link carries each joint, and with it the link that the joint moves. A link stands after the one that
/// carries it.
#[derive(Clone, Debug)]
pub(crate) struct Tree {
    /// The link on which each joint stands; `None` for the base.
    parents: Vec<Option<usize>>,
}

impl Tree {
    /// The tree in which joint i stands on link `parents[i]`, or on the base.
    pub(crate) fn new(parents: Vec<Option<usize>>) -> Self {
        let mut links = parents.iter().enumerate();
        debug_assert!(links.all(|(i, parent)| parent.is_none_or(|parent| parent < i)));
        Tree { parents }
    }

    /// How many links there are.
    pub(crate) fn len(&self) -> usize {
        self.parents.len()
    }

    /// The links that carry no other.
    pub(crate) fn tips(&self) -> impl Iterator<Item = usize> {
        (0..self.len()).filter(|&i| !self.parents.contains(&Some(i)))
    }

    /// The link that carries joint i; `None` for the base.
    pub(crate) fn parent(&self, i: usize) -> Option<usize> {
        self.parents[i]
    }

    /// A value for each link, from the base outwards: `step(i, before)` makes it of the value of the link that
    /// carries joint i, which is `base` where the base carries it.
    pub(crate) fn outward<T>(&self, base: T, mut step: impl FnMut(usize, &T) -> T) -> Vec<T> {
        let mut values: Vec<T> = Vec::with_capacity(self.len());
        for (i, parent) in self.parents.iter().enumerate() {
            let value = step(i, parent.map_or(&base, |parent| &values[parent]));
            values.push(value);
        }
        values
    }

    /// From the tips inwards: `step(i, outer)` gets the sum of what the joints on link i have handed on, and returns
    /// what joint i hands on. The result is what the base gets. Nothing is added where one joint alone hands on, and
    /// `none` stands for what no joint hands on.
    pub(crate) fn inward<T: Clone>(
        &self,
        none: T,
        add: impl Fn(T, T) -> T,
        mut step: impl FnMut(usize, T) -> T,
    ) -> T {
        let mut on_base: Option<T> = None;
        let mut on_links: Vec<Option<T>> = vec![None; self.len()];
        for (i, parent) in self.parents.iter().enumerate().rev() {
            let outer = on_links[i].take().unwrap_or_else(|| none.clone());
            let handed_on = step(i, outer);
            let sum = parent.map_or(&mut on_base, |parent| &mut on_links[parent]);
            *sum = Some(match sum.take() {
                Some(others) => add(others, handed_on),
                None => handed_on,
            });
        }
        on_base.unwrap_or(none)
    }

    /// The joints that carry link i, from its own inwards.
    pub(crate) fn carriers(&self, i: usize) -> impl Iterator<Item = usize> {
        core::iter::successors(Some(i), |&joint| self.parents[joint])
    }

    /// The joints that carry a link or, where there is none, the base.
    pub(crate) fn carriers_of(&self, link: Option<usize>) -> impl Iterator<Item = usize> {
        link.into_iter().flat_map(|link| self.carriers(link))
    }

    /// A value of link i, handed on from link to link along the joints that carry it: `visit(j, value)` sees it in
    /// the frame of link j, `leave(j, value)` takes it to the link that carries joint j. It does not reach the base.
    pub(crate) fn along_carriers<T>(
        &self,
        i: usize,
        mut value: T,
        mut leave: impl FnMut(usize, T) -> T,
        mut visit: impl FnMut(usize, &T),
    ) {
        let mut joint = i;
        loop {
            visit(joint, &value);
            let Some(parent) = self.parents[joint] else {
                return;
            };
            value = leave(joint, value);
            joint = parent;
        }
    }

    /// For each link what the joints that carry it have, from the base outwards, each with the joint's number:
    /// `own` says it in the frame of the joint's own link, `enter(i, value)` takes it to link i.
    pub(crate) fn of_carriers<T>(
        &self,
        own: impl Fn(usize) -> T,
        enter: impl Fn(usize, &T) -> T,
    ) -> Vec<Vec<(usize, T)>> {
        self.outward(Vec::new(), |i, inner: &Vec<(usize, T)>| {
            let inner = inner.iter().map(|(joint, value)| (*joint, enter(i, value)));
            let mut values: Vec<_> = inner.collect();
            values.push((i, own(i)));
            values
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Joints 1 and 2 stand on link 0, joint 3 on link 2, joint 4 on the base.
    fn branched() -> Tree {
        Tree::new(vec![None, Some(0), Some(0), Some(2), None])
    }

    #[test]
    fn links_are_walked_from_the_base_outwards() {
        let names = branched().outward("b".to_owned(), |i, before| format!("{before}{i}"));
        assert_eq!(names, ["b0", "b01", "b02", "b023", "b4"]);
        let carriers: Vec<_> = branched().carriers(3).collect();
        assert_eq!(carriers, [3, 2, 0]);
        assert_eq!(branched().tips().count(), 3);
    }

    #[test]
    fn what_joints_on_one_link_hand_on_is_added() {
        let add = |a: String, b: String| format!("({a}+{b})");
        let step = |i: usize, outer: String| format!("{i}{outer}");
        let base = branched().inward(String::new(), add, step);
        assert_eq!(base, "(4+0(23+1))");
        let serial = Tree::new(vec![None, Some(0), Some(1)]);
        assert_eq!(serial.inward(String::new(), add, step), "012");
        assert_eq!(
            Tree::new(Vec::new()).inward("none".to_owned(), add, step),
            "none"
        );
    }

    #[test]
    fn a_value_passes_the_joints_that_carry_its_link() {
        let mut seen = Vec::new();
        let leave = |j: usize, value: String| format!("{value}{j}");
        branched().along_carriers(3, String::new(), leave, |j, value| {
            seen.push((j, value.clone()));
        });
        let expected = [(3, ""), (2, "3"), (0, "32")];
        assert_eq!(seen, expected.map(|(j, value)| (j, value.to_owned())));
        let of_carriers = branched().of_carriers(|i| i, |i, value| 10 * value + i);
        assert_eq!(of_carriers[3], [(0, 23), (2, 23), (3, 3)]);
    }
}
