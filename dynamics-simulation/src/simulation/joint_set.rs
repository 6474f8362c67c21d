//! Sets of joints.

use core::fmt;

/// A set of joints. Joints are counted from 0; it has room for the first 128.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct JointSet(u128);

impl JointSet {
    const ROOM: usize = 128;

    /// Whether a joint, counted from 0, is one of them.
    pub fn contains(&self, joint: usize) -> bool {
        joint < Self::ROOM && self.0 >> joint & 1 == 1
    }

    /// The joints, counted from the one behind so many.
    pub(super) fn behind(&self, count: usize) -> Self {
        JointSet(self.0 >> count)
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.0 == 0
    }

    /// The joints, counted from 0, in order.
    pub fn iter(&self) -> impl Iterator<Item = usize> {
        let set = *self;
        (0..Self::ROOM).filter(move |joint| set.contains(*joint))
    }
}

impl Extend<usize> for JointSet {
    fn extend<I: IntoIterator<Item = usize>>(&mut self, joints: I) {
        let within = joints.into_iter().filter(|joint| *joint < Self::ROOM);
        self.0 = within.fold(self.0, |set, joint| set | 1 << joint);
    }
}

impl FromIterator<usize> for JointSet {
    fn from_iter<I: IntoIterator<Item = usize>>(joints: I) -> Self {
        let mut set = JointSet::default();
        set.extend(joints);
        set
    }
}

impl fmt::Display for JointSet {
    /// `joint 2`, `joints 1 and 2`, `joints 1, 2 and 4`, counted from 1.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = self.iter().count();
        f.write_str(if count == 1 { "joint " } else { "joints " })?;
        for (k, joint) in self.iter().enumerate() {
            let before = match k {
                0 => "",
                _ if k + 1 == count => " and ",
                _ => ", ",
            };
            write!(f, "{before}{}", joint + 1)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::JointSet;

    #[test]
    fn sets_of_joints_are_said_as_lists() {
        let said = |joints: &[usize]| joints.iter().copied().collect::<JointSet>().to_string();
        assert_eq!(said(&[1]), "joint 2");
        assert_eq!(said(&[4, 0]), "joints 1 and 5");
        assert_eq!(said(&[0, 127, 1, 1, 128]), "joints 1, 2 and 128");
    }
}
