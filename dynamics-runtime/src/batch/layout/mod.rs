//! How the states of a batch lie in memory.

mod columns;
mod parts;
mod rows;
mod transposition;

use fearless_simd::Simd;
use nalgebra::{ArrayStorage, SVector};

use crate::batch::wide::{Precision, Wide};
use crate::function::{Arrangement, Entries, Of};

/// `N` numbers for each of many states: an argument of a batch. `T` is `f64` or `f32`.
///
/// Implemented for
///
/// - a vector for each state: `&[SVector<T, N>]`, and references to a `Vec` or an array of them;
/// - a column for each joint, which takes up to a sixth less time: `[&[T]; N]`,
///   `&[Vec<T>; N]`, and `&OMatrix<T, Dyn, Const<N>>`, a matrix of a row for each state;
/// - where a base that moves stands, 12 numbers, a [`Pose`](crate::Pose) for each state: `&[Pose<T>]`, and references to a
///   `Vec` or an array of them.
///
/// Columns of several thousand states whose lengths are powers of two share sets of the cache, and
/// lose what they have gained.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not hold {N} numbers for each of many states",
    note = "it may be `&[SVector<{T}, {N}>]`, `&Vec<SVector<{T}, {N}>>`, `[&[{T}]; {N}]` or `&OMatrix<{T}, Dyn, Const<{N}>>`"
)]
pub trait States<const N: usize, T: Precision = f64> {
    #[doc(hidden)]
    type Source: Source<Entries<N, 1>, T>;

    #[doc(hidden)]
    fn source(self) -> Self::Source;
}

/// Room for the values of a function at each of many states: the results of a batch. `T` is `f64` or `f32`,
/// `A` stands for the type that a single call returns.
///
/// Implemented for
///
/// - what a single call returns, for each state: `&mut [SMatrix<T, R, C>]`, `&mut [T]`, `&mut [(A, B)]`, and
///   mutable references to a `Vec` or an array of them;
/// - a column for each entry, which takes less time, for a mass matrix a quarter less:
///   `[&mut [T]; R]`, `&mut [Vec<T>; R]` or `&mut OMatrix<T, Dyn, Const<R>>` for vectors,
///   and `[[&mut [T]; R]; C]` or `&mut [[Vec<T>; R]; C]` for matrices, entry `(i, j)` in `[j][i]`;
/// - where a single call returns a tuple or an array, a tuple or an array of any of these, such as
///   `(&mut by_position, &mut by_velocity)`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no room for the values of this function at each of many states",
    note = "it may be `&mut [V]` or a mutable reference to a `Vec` of `V`, where `V` is what a single call returns in {T}, or a column for each entry",
    note = "columns are `[&mut [{T}]; R]` or `&mut [Vec<{T}>; R]` for vectors, `[[&mut [{T}]; R]; C]` or `&mut [[Vec<{T}>; R]; C]` for matrices"
)]
pub trait StatesMut<A: Arrangement, T: Precision = f64> {
    #[doc(hidden)]
    type Sink: Sink<A, T>;

    #[doc(hidden)]
    fn sink(self) -> Self::Sink;
}

/// The number of lanes of the widest vectors, of single precision.
pub(super) const MOST_LANES: usize = 16;

/// Where the lanes read: an argument, a vector for each state, or a tuple of arguments.
pub trait Source<A: Arrangement, E: Precision>: Copy + Send {
    /// Room for as many states as there are lanes.
    type Room;

    /// The source that reads there.
    type Copied<'r>: Source<A, E>
    where
        Self: 'r;

    /// Tells of each argument the number of states, and one that differs from it, if the columns are not all as long.
    fn states(&self, tell: &mut dyn FnMut(usize, Option<usize>));

    /// The first states, and the others.
    #[cfg(feature = "rayon")]
    fn split(self, states: usize) -> (Self, Self);

    /// One state.
    fn state(&self, state: usize) -> Of<A, E>;

    /// Empty room.
    fn room() -> Self::Room;

    /// The states, of which there are fewer than lanes, and copies of the last one. Any other
    /// numbers might be no state of the arm.
    fn padded<'r>(&self, states: usize, room: &'r mut Self::Room) -> Self::Copied<'r>
    where
        Self: 'r;

    /// As many states as there are lanes, from the first on.
    fn load<S: Simd>(&self, simd: S, first: usize) -> Of<A, Wide<S, E>>;
}

/// Where the lanes write.
pub trait Sink<A: Arrangement, E: Precision>: Send + Sized {
    /// Room for as many states as there are lanes.
    type Room;

    /// The sink that writes there.
    type Copied<'r>: Sink<A, E>
    where
        Self: 'r;

    /// The number of states, and one that differs from it, if the columns are not all as long.
    fn states(&self) -> (usize, Option<usize>);

    /// The first states; what is left are the others.
    #[cfg(feature = "rayon")]
    #[must_use]
    fn take(&mut self, states: usize) -> Self;

    /// One state.
    fn state(&self, state: usize) -> Of<A, E>;

    /// Writes one state.
    fn set(&mut self, state: usize, value: &Of<A, E>);

    /// Empty room.
    fn room() -> Self::Room;

    /// A sink for as many states as there are lanes.
    fn elsewhere<'r>(room: &'r mut Self::Room) -> Self::Copied<'r>
    where
        Self: 'r;

    /// Writes as many states as there are lanes, from the first on.
    fn store<S: Simd>(&mut self, first: usize, value: &Of<A, Wide<S, E>>);
}

/// The number of states of parts, and one that differs from it.
fn lengths(parts: impl Iterator<Item = (usize, Option<usize>)>) -> (usize, Option<usize>) {
    let mut whole = None;
    let mut other = None;
    for (states, differing) in parts {
        let first = *whole.get_or_insert(states);
        other = other.or(differing).or((states != first).then_some(states));
    }
    (whole.unwrap_or(0), other)
}

/// The vector of the lanes of each joint.
#[inline(always)]
fn each_joint<S: Simd, E: Precision, const N: usize>(
    lanes: impl Fn(usize) -> E::Native<S>,
) -> SVector<Wide<S, E>, N> {
    if N == 0 {
        // A body without joints has no first one.
        return SVector::from_data(ArrayStorage([core::array::from_fn(|joint| {
            Wide(lanes(joint))
        })]));
    }
    // Not `from_fn`, which is not inlined for certain.
    let mut vector = [Wide(lanes(0)); N];
    for joint in 1..N {
        vector[joint] = Wide(lanes(joint));
    }
    SVector::from_data(ArrayStorage([vector]))
}
