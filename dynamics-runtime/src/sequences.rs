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
        write(array, serializer)
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>, T: Deserialize<'de>, const N: usize>(
        deserializer: D,
    ) -> Result<[T; N], D::Error> {
        let entries = read(deserializer, N)?.try_into();
        Ok(entries.unwrap_or_else(|_| unreachable!("so many were read")))
    }
}

/// For `#[serde(with = "sequences::vectors")]` on a list of vectors.
pub mod vectors {
    use super::*;

    /// Writes the vectors one after the other.
    pub fn serialize<S: Serializer, V: JointVector>(
        vectors: &[V],
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(vectors.iter().map(Entry))
    }

    /// Reads as many vectors as there are.
    pub fn deserialize<'de, D: Deserializer<'de>, V: JointVector>(
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
            match V::size() {
                Some(_) => write(entries, serializer),
                None => serializer.collect_seq(entries),
            }
        }
    }

    impl<'de, V: JointVector> Deserialize<'de> for Entry<V> {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            let entries: Vec<Number> = match V::size() {
                Some(size) => read(deserializer, size)?,
                None => Vec::deserialize(deserializer)?,
            };
            Ok(Entry(V::from_entries(entries.len(), |i| entries[i].0)))
        }
    }

    /// A number. Texts such as JSON have nothing (`null`) in place of one that is not finite.
    struct Number(f64);

    impl<'de> Deserialize<'de> for Number {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            if deserializer.is_human_readable() {
                let number = Option::deserialize(deserializer)?;
                Ok(Number(number.unwrap_or(f64::NAN)))
            } else {
                f64::deserialize(deserializer).map(Number)
            }
        }
    }
}

/// Writes entries whose number the reader knows.
fn write<S: Serializer>(entries: &[impl Serialize], serializer: S) -> Result<S::Ok, S::Error> {
    let mut sequence = serializer.serialize_tuple(entries.len())?;
    for entry in entries {
        sequence.serialize_element(entry)?;
    }
    sequence.end()
}

/// Reads so many entries.
fn read<'de, D: Deserializer<'de>, T: Deserialize<'de>>(
    deserializer: D,
    size: usize,
) -> Result<Vec<T>, D::Error> {
    let entries = Entries {
        size,
        kind: PhantomData,
    };
    deserializer.deserialize_tuple(size, entries)
}

struct Entries<T> {
    size: usize,
    kind: PhantomData<T>,
}

impl<'de, T: Deserialize<'de>> Visitor<'de> for Entries<T> {
    type Value = Vec<T>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a sequence of {}", self.size)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut sequence: A) -> Result<Vec<T>, A::Error> {
        let mut entries = Vec::with_capacity(self.size);
        while let Some(entry) = sequence.next_element()? {
            entries.push(entry);
        }
        if entries.len() == self.size {
            Ok(entries)
        } else {
            Err(Error::invalid_length(entries.len(), &self))
        }
    }
}
