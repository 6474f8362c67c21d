//! Arrays and vectors of N entries as sequences of data: serde has none of its own for an N that is a parameter.

use core::fmt;
use core::marker::PhantomData;

use nalgebra::SVector;
use serde::de::{Deserialize, Deserializer, Error, SeqAccess, Visitor};
use serde::ser::{Serialize, SerializeTuple, Serializer};

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

    pub(crate) fn serialize<S: Serializer, const N: usize>(
        vectors: &[SVector<f64, N>],
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(vectors.iter().map(|vector| Entry((*vector).into())))
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>, const N: usize>(
        deserializer: D,
    ) -> Result<Vec<SVector<f64, N>>, D::Error> {
        let entries = Vec::<Entry<N>>::deserialize(deserializer)?;
        Ok(entries
            .into_iter()
            .map(|Entry(entry)| entry.into())
            .collect())
    }

    #[derive(serde::Serialize, serde::Deserialize)]
    struct Entry<const N: usize>(#[serde(with = "array")] [f64; N]);

    use super::array;
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
