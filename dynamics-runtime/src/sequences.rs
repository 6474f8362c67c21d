//! Arrays and vectors of N entries as sequences of data: serde has none of its own for an N that is a parameter.

use core::fmt;
use core::marker::PhantomData;

use serde::de::{Deserialize, Deserializer, Error, SeqAccess, Visitor};
use serde::ser::{Serialize, SerializeTuple, Serializer};

use crate::size::JointVector;

/// For `#[serde(with = "sequences::array")]` on a `[T; N]`.
pub(crate) mod array {
    use super::*;

    pub(crate) fn serialize<S: Serializer, T: Serialize, const N: usize>(
        array: &[T; N],
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        let mut sequence = serializer.serialize_tuple(N)?;
        for entry in array {
            sequence.serialize_element(entry)?;
        }
        sequence.end()
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>, T: Deserialize<'de>, const N: usize>(
        deserializer: D,
    ) -> Result<[T; N], D::Error> {
        deserializer.deserialize_tuple(N, Entries::<T, N>(PhantomData))
    }
}

/// For `#[serde(with = "sequences::vectors")]` on a list of vectors.
pub(crate) mod vectors {
    use super::*;

    pub(crate) fn serialize<S: Serializer, V: JointVector>(
        vectors: &[V],
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(vectors.iter().map(Entry))
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>, V: JointVector>(
        deserializer: D,
    ) -> Result<Vec<V>, D::Error> {
        let entries = Vec::<Entry<V>>::deserialize(deserializer)?;
        Ok(entries.into_iter().map(|Entry(vector)| vector).collect())
    }

    /// A vector, whose number of entries stands with it where its type does not tell.
    struct Entry<V>(V);

    impl<V: JointVector> Serialize for Entry<&V> {
        fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
            let entries = self.0.entries();
            if V::SIZE.is_none() {
                return serializer.collect_seq(entries);
            }
            let mut sequence = serializer.serialize_tuple(entries.len())?;
            for entry in entries {
                sequence.serialize_element(entry)?;
            }
            sequence.end()
        }
    }

    impl<'de, V: JointVector> Deserialize<'de> for Entry<V> {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            let entries = match V::SIZE {
                Some(size) => deserializer.deserialize_tuple(size, Numbers(V::SIZE))?,
                None => Vec::<f64>::deserialize(deserializer)?,
            };
            Ok(Entry(V::from_entries(entries.len(), |i| entries[i])))
        }
    }

    /// Reads so many numbers.
    struct Numbers(Option<usize>);

    impl<'de> Visitor<'de> for Numbers {
        type Value = Vec<f64>;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            write!(f, "a sequence of {}", self.0.unwrap_or_default())
        }

        fn visit_seq<A: SeqAccess<'de>>(self, mut sequence: A) -> Result<Vec<f64>, A::Error> {
            let mut entries = Vec::new();
            while let Some(entry) = sequence.next_element()? {
                entries.push(entry);
            }
            if self.0.is_some_and(|size| size != entries.len()) {
                return Err(Error::invalid_length(entries.len(), &self));
            }
            Ok(entries)
        }
    }
}

/// Reads as many entries as an array has.
struct Entries<T, const N: usize>(PhantomData<T>);

impl<'de, T: Deserialize<'de>, const N: usize> Visitor<'de> for Entries<T, N> {
    type Value = [T; N];

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a sequence of {N}")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut sequence: A) -> Result<[T; N], A::Error> {
        let mut entries = Vec::with_capacity(N);
        while let Some(entry) = sequence.next_element()? {
            entries.push(entry);
        }
        let found = entries.len();
        entries
            .try_into()
            .map_err(|_| Error::invalid_length(found, &self))
    }
}
