//! The numbers of a batch.

use fearless_simd::{Simd, SimdFloatElement};

use super::Wide;
use crate::Scalar;
use crate::sine::Part;

/// The numbers of a batch: `f64`, or `f32` in twice as many lanes.
#[diagnostic::on_unimplemented(message = "batches are of `f64` or `f32`, not of `{Self}`")]
pub trait Precision: Scalar + SimdFloatElement + Send + Sync {
    /// The number of lanes of the widest vectors.
    #[doc(hidden)]
    const MOST_LANES: usize;

    /// Sines and cosines of angles in lanes, of which only these parts are read.
    #[doc(hidden)]
    fn sin_cos_of_lanes<S: Simd, const K: usize>(
        angles: [Wide<S, Self>; K],
        parts: [Part; K],
    ) -> [(Wide<S, Self>, Wide<S, Self>); K];
}
