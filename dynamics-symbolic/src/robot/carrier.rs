//! Which link carries a joint.

use super::{Placement, Robot, Row};

/// The link on which a joint stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Carrier {
    /// The link of the row above. The first row stands on the base.
    #[default]
    Above,
    /// The base.
    Base,
    /// The link of the row of this index, which stands above.
    Row(usize),
}

impl Carrier {
    /// The row whose link carries the joint of row i; `None` for the base.
    pub fn parent(self, i: usize) -> Option<usize> {
        match self {
            Carrier::Above => i.checked_sub(1),
            Carrier::Base => None,
            Carrier::Row(row) => Some(row),
        }
    }
}

impl Robot {
    /// The row whose link carries the joint of row i; `None` for the base.
    pub fn parent(&self, i: usize) -> Option<usize> {
        self.rows[i].on.parent(i)
    }

    /// Whether each row stands on the link of the row above, and the first one on the base.
    pub fn is_serial(&self) -> bool {
        (0..self.rows.len()).all(|i| self.parent(i) == i.checked_sub(1))
    }

    /// The row whose link carries the tip. A file says which; in a table it is the only row that carries no other, the
    /// last one of a serial arm. `None` where there is no tip.
    pub fn tip_row(&self) -> Option<usize> {
        if self.rows.iter().any(|row| row.mount.is_some()) {
            return self.rows.iter().position(|row| row.tip().is_some());
        }
        self.rows.len().checked_sub(1).filter(|_| self.is_serial())
    }

    /// The placements of row i that its cells do not say, each placement in the one before it: of the joint's own frame
    /// in that of the joint that carries it, and of the link frame in the joint's own.
    pub fn mounted(&self, i: usize) -> [Vec<Placement>; 2] {
        let Row { at, mount, .. } = &self.rows[i];
        let mount_of = |row: usize| self.rows[row].mount.as_ref();
        let back = self.parent(i).and_then(mount_of);
        let back = back.map_or(Vec::new(), |mount| mount.link_frame());
        match mount {
            None => [[back, at.clone()].concat(), Vec::new()],
            Some(mount) => {
                let before = [back, at.clone(), mount.turned()];
                [before.concat(), mount.link_frame()]
            }
        }
    }
}

impl Row {
    /// The tip that a file places on this link: in the link frame, each place in the one before it.
    pub fn tip(&self) -> Option<&[Placement]> {
        self.mount.as_ref()?.tip.as_deref()
    }
}
