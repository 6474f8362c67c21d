//! Lists of any length, which need no allocator while they are short.

use core::fmt;
use core::ops::{Deref, DerefMut};

/// A list of any length: up to `ROOM` entries stand in the list itself, more of them on the heap.
///
/// Without the feature `std` there is no heap, and a list has no more than `ROOM` entries.
#[derive(Clone)]
pub struct List<T, const ROOM: usize>(Kept<T, ROOM>);

#[derive(Clone)]
enum Kept<T, const ROOM: usize> {
    None,
    /// So many of the entries.
    Here(usize, [T; ROOM]),
    #[cfg(feature = "std")]
    OnHeap(Vec<T>),
}

impl<T, const ROOM: usize> List<T, ROOM> {
    /// A list without entries.
    pub const NONE: Self = List(Kept::None);

    /// How many entries it may have: any number where there is a heap.
    pub(crate) const MOST: usize = if cfg!(feature = "std") {
        usize::MAX
    } else {
        ROOM
    };
}

impl<T: Copy, const ROOM: usize> List<T, ROOM> {
    /// The same entry so many times.
    #[inline(always)]
    #[doc(hidden)]
    pub fn filled(count: usize, entry: T) -> Self {
        match count {
            0 => List::NONE,
            count if count <= ROOM => List(Kept::Here(count, [entry; ROOM])),
            count => Self::long(count, entry),
        }
    }

    #[cfg(feature = "std")]
    #[cold]
    fn long(count: usize, entry: T) -> Self {
        List(Kept::OnHeap(vec![entry; count]))
    }

    #[cfg(not(feature = "std"))]
    #[cold]
    fn long(count: usize, _: T) -> Self {
        panic!("{count} entries of a list that has room for {ROOM} without the feature `std`")
    }

    /// Adds an entry at the end.
    ///
    /// # Panics
    ///
    /// Without the feature `std`, if the list has `ROOM` entries.
    pub fn push(&mut self, entry: T) {
        let count = self.len();
        match &mut self.0 {
            Kept::Here(count, list) if *count < ROOM => {
                list[*count] = entry;
                *count += 1;
            }
            #[cfg(feature = "std")]
            Kept::OnHeap(list) => list.push(entry),
            _ => {
                let mut longer = Self::filled(count + 1, entry);
                longer[..count].copy_from_slice(self);
                *self = longer;
            }
        }
    }
}

impl<T, const ROOM: usize> Default for List<T, ROOM> {
    fn default() -> Self {
        List::NONE
    }
}

impl<T, const ROOM: usize> Deref for List<T, ROOM> {
    type Target = [T];

    #[inline(always)]
    fn deref(&self) -> &[T] {
        match &self.0 {
            Kept::None => &[],
            Kept::Here(count, list) => &list[..*count],
            #[cfg(feature = "std")]
            Kept::OnHeap(list) => list,
        }
    }
}

impl<T, const ROOM: usize> DerefMut for List<T, ROOM> {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut [T] {
        match &mut self.0 {
            Kept::None => &mut [],
            Kept::Here(count, list) => &mut list[..*count],
            #[cfg(feature = "std")]
            Kept::OnHeap(list) => list,
        }
    }
}

impl<T: fmt::Debug, const ROOM: usize> fmt::Debug for List<T, ROOM> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        (**self).fmt(f)
    }
}

impl<T: PartialEq, const ROOM: usize> PartialEq for List<T, ROOM> {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

impl<T: Copy, const ROOM: usize> FromIterator<T> for List<T, ROOM> {
    fn from_iter<I: IntoIterator<Item = T>>(entries: I) -> Self {
        let mut list = List::NONE;
        entries.into_iter().for_each(|entry| list.push(entry));
        list
    }
}

impl<T: Copy, const ROOM: usize> From<&[T]> for List<T, ROOM> {
    fn from(entries: &[T]) -> Self {
        entries.iter().copied().collect()
    }
}

impl<'l, T, const ROOM: usize> IntoIterator for &'l List<T, ROOM> {
    type Item = &'l T;
    type IntoIter = core::slice::Iter<'l, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

#[cfg(feature = "serde")]
impl<T: serde::Serialize, const ROOM: usize> serde::Serialize for List<T, ROOM> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self)
    }
}

#[cfg(feature = "serde")]
impl<'de, T: serde::Deserialize<'de> + Copy, const ROOM: usize> serde::Deserialize<'de>
    for List<T, ROOM>
{
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Vec::deserialize(deserializer).map(|entries: Vec<T>| entries.into_iter().collect())
    }
}
