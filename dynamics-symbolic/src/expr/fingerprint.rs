//! Fingerprints: the value of a node at one random point of a prime field.

use crate::exact::Residue;
use core::hash::{BuildHasherDefault, Hasher};
use std::collections::HashMap;

/// The field of the fingerprints.
pub(crate) type Fingerprint = Residue<{ (1 << 61) - 1 }>;

/// Keys are fingerprints, which are as good as random already.
#[derive(Default)]
pub(crate) struct FingerprintHasher(u64);

impl Hasher for FingerprintHasher {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, _: &[u8]) {
        unreachable!("fingerprints are hashed as one u64");
    }

    fn write_u64(&mut self, value: u64) {
        // The table takes its control byte from the top seven bits.
        self.0 = value.wrapping_mul(0x9E37_79B9_7F4A_7C15);
    }
}

/// A map from fingerprints.
pub(crate) type FingerprintMap<V> = HashMap<u64, V, BuildHasherDefault<FingerprintHasher>>;
