//! How the states of a batch lie in memory.

mod columns;
mod rows;

use fearless_simd::Simd;
use nalgebra::{ArrayStorage, SMatrix, SVector};

use crate::batch::wide::Wide;

/// `N` numbers for each of many states: the arguments of a batch.
///
/// Implemented for
///
/// - a vector for each state: `&[SVector<f64, N>]`, and references to a `Vec` or an array of them;
/// - a column for each joint, which takes up to a sixth less time: `[&[f64]; N]`,
///   `&[Vec<f64>; N]`, and `&OMatrix<f64, Dyn, Const<N>>`, a matrix of a row for each state.
///
/// Columns of several thousand states whose lengths are powers of two share sets of the cache, and
/// lose what they have gained.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not hold {N} numbers for each of many states",
    note = "it may be `&[SVector<f64, {N}>]`, `&Vec<SVector<f64, {N}>>`, `[&[f64]; {N}]` or `&OMatrix<f64, Dyn, Const<{N}>>`"
)]
pub trait States<const N: usize> {
    #[doc(hidden)]
    type Source: Source<N>;

    #[doc(hidden)]
    fn source(self) -> Self::Source;
}

/// Room for a matrix of `R` rows and `C` columns for each of many states: the results of a batch.
/// Vectors are matrices of one column.
///
/// Implemented for
///
/// - a matrix or vector for each state: `&mut [SMatrix<f64, R, C>]`, and mutable references to a
///   `Vec` or an array of them;
/// - a column for each entry, which takes less time, for a mass matrix a third less:
///   `[&mut [f64]; R]`, `&mut [Vec<f64>; R]` or `&mut OMatrix<f64, Dyn, Const<R>>` for vectors,
///   and `[[&mut [f64]; R]; C]` for matrices, entry `(i, j)` in `[j][i]`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no room for {R} x {C} numbers for each of many states",
    note = "it may be `&mut [SMatrix<f64, {R}, {C}>]`, a mutable reference to a `Vec` of them, or `[[&mut [f64]; {R}]; {C}]`",
    note = "for vectors also `[&mut [f64]; {R}]` or `&mut OMatrix<f64, Dyn, Const<{R}>>`"
)]
pub trait StatesMut<const R: usize, const C: usize = 1> {
    #[doc(hidden)]
    type Sink: Sink<R, C>;

    #[doc(hidden)]
    fn sink(self) -> Self::Sink;
}

/// The number of lanes of the widest vectors.
pub(super) const MOST_LANES: usize = 8;

/// Where the lanes read.
pub trait Source<const N: usize>: Copy + Send {
    /// Room for as many states as there are lanes.
    type Room;

    /// The source that reads there.
    type Copied<'r>: Source<N>
    where
        Self: 'r;

    /// The number of states, and one that differs from it, if the columns are not all as long.
    fn states(&self) -> (usize, Option<usize>);

    /// The first states alone.
    fn shorten(&mut self, states: usize);

    /// The first states, and the others.
    #[cfg(feature = "rayon")]
    fn split(self, states: usize) -> (Self, Self);

    /// One state.
    fn state(&self, state: usize) -> SVector<f64, N>;

    /// Empty room.
    fn room() -> Self::Room;

    /// The states, of which there are fewer than lanes, and copies of the last one. Any other
    /// numbers might be no state of the arm.
    fn padded<'r>(&self, states: usize, room: &'r mut Self::Room) -> Self::Copied<'r>
    where
        Self: 'r;

    /// As many states as there are lanes, from the first on.
    fn load<S: Simd>(&self, simd: S, first: usize) -> SVector<Wide<S>, N>;
}

/// Where the lanes write.
pub trait Sink<const R: usize, const C: usize>: Send + Sized {
    /// Room for as many states as there are lanes.
    type Room;

    /// The sink that writes there.
    type Copied<'r>: Sink<R, C>
    where
        Self: 'r;

    /// The number of states, and one that differs from it, if the columns are not all as long.
    fn states(&self) -> (usize, Option<usize>);

    /// The first states alone.
    fn shorten(&mut self, states: usize);

    /// The first states, and the others.
    #[cfg(feature = "rayon")]
    fn split(self, states: usize) -> (Self, Self);

    /// One state.
    fn state(&self, state: usize) -> SMatrix<f64, R, C>;

    /// Writes one state.
    fn set(&mut self, state: usize, value: &SMatrix<f64, R, C>);

    /// Empty room.
    fn room() -> Self::Room;

    /// A sink for as many states as there are lanes.
    fn elsewhere<'r>(&self, room: &'r mut Self::Room) -> Self::Copied<'r>
    where
        Self: 'r;

    /// Writes as many states as there are lanes, from the first on.
    fn store<S: Simd>(&mut self, first: usize, value: &SMatrix<Wide<S>, R, C>);
}

/// The vector of what is there for each joint.
#[inline(always)]
fn each_joint<S: Simd, const N: usize>(lanes: impl Fn(usize) -> S::f64s) -> SVector<Wide<S>, N> {
    // Not `from_fn`, which is not inlined for certain.
    let mut vector = [Wide(lanes(0)); N];
    for joint in 1..N {
        vector[joint] = Wide(lanes(joint));
    }
    SVector::from_data(ArrayStorage([vector]))
}
