//! Which link carries a joint.

/// The link on which a joint stands.
///
/// Rows are counted from 0. Where joints follow others, their rows are counted too, in their places between the joints that
/// move by themselves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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
    /// The row whose link carries row `k`; `None` for the base.
    ///
    /// # Panics
    ///
    /// If that row does not stand above row `k`.
    #[track_caller]
    #[doc(hidden)]
    pub fn of(self, k: usize) -> Option<usize> {
        match self {
            Carrier::Above => k.checked_sub(1),
            Carrier::Base => None,
            Carrier::Row(row) => {
                assert!(
                    row < k,
                    "row {k} of the table stands on row {row}, which does not stand above it: rows are counted from 0"
                );
                Some(row)
            }
        }
    }
}
