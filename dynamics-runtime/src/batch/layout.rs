//! How the states of a batch lie in memory.

use fearless_simd::{Simd, SimdBase};
use nalgebra::{ArrayStorage, Const, Dyn, Matrix, SMatrix, SVector, VecStorage};

use super::wide::Wide;

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

/// A vector for each state.
#[derive(Clone, Copy)]
pub struct Rows<'a, const N: usize>(&'a [SVector<f64, N>]);

/// A column for each joint.
#[derive(Clone, Copy)]
pub struct Columns<'a, const N: usize>([&'a [f64]; N]);

/// Room for a matrix for each state.
pub struct RowsMut<'a, const R: usize, const C: usize>(&'a mut [SMatrix<f64, R, C>]);

/// Room in a column for each entry.
pub struct ColumnsMut<'a, const R: usize, const C: usize>([[&'a mut [f64]; R]; C]);

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

impl<'a, const N: usize> Source<N> for Rows<'a, N> {
    type Room = [SMatrix<f64, N, 1>; MOST_LANES];
    type Copied<'r>
        = Rows<'r, N>
    where
        Self: 'r;

    fn states(&self) -> (usize, Option<usize>) {
        (self.0.len(), None)
    }

    #[inline(always)]
    fn shorten(&mut self, states: usize) {
        self.0 = &self.0[..states];
    }

    #[cfg(feature = "rayon")]
    fn split(self, states: usize) -> (Self, Self) {
        let (first, others) = self.0.split_at(states);
        (Rows(first), Rows(others))
    }

    fn state(&self, state: usize) -> SVector<f64, N> {
        self.0[state]
    }

    fn room() -> Self::Room {
        [SMatrix::zeros(); MOST_LANES]
    }

    fn padded<'r>(&self, states: usize, room: &'r mut Self::Room) -> Rows<'r, N>
    where
        Self: 'r,
    {
        for (lane, place) in room.iter_mut().enumerate() {
            *place = self.0[lane.min(states - 1)];
        }
        Rows(room)
    }

    #[inline(always)]
    fn load<S: Simd>(&self, simd: S, first: usize) -> SVector<Wide<S>, N> {
        let states = &self.0[first..first + S::f64s::LEN];
        each_joint(
            #[inline(always)]
            |joint| {
                S::f64s::from_fn(
                    simd,
                    #[inline(always)]
                    |lane| states[lane].data.0[0][joint],
                )
            },
        )
    }
}

impl<'a, const N: usize> Source<N> for Columns<'a, N> {
    type Room = [SMatrix<f64, MOST_LANES, 1>; N];
    type Copied<'r>
        = Columns<'r, N>
    where
        Self: 'r;

    fn states(&self) -> (usize, Option<usize>) {
        let states = self.0.first().map_or(0, |column| column.len());
        let mut lengths = self.0.iter().map(|column| column.len());
        (states, lengths.find(|&length| length != states))
    }

    #[inline(always)]
    fn shorten(&mut self, states: usize) {
        for column in &mut self.0 {
            *column = &column[..states];
        }
    }

    #[cfg(feature = "rayon")]
    fn split(self, states: usize) -> (Self, Self) {
        let (mut first, mut others) = (self.0, self.0);
        for (first, others) in first.iter_mut().zip(&mut others) {
            (*first, *others) = first.split_at(states);
        }
        (Columns(first), Columns(others))
    }

    fn state(&self, state: usize) -> SVector<f64, N> {
        SVector::from_fn(|joint, _| self.0[joint][state])
    }

    fn room() -> Self::Room {
        [SMatrix::zeros(); N]
    }

    fn padded<'r>(&self, states: usize, room: &'r mut Self::Room) -> Columns<'r, N>
    where
        Self: 'r,
    {
        for (column, place) in self.0.iter().zip(room.iter_mut()) {
            for lane in 0..MOST_LANES {
                place[lane] = column[lane.min(states - 1)];
            }
        }
        Columns(room.each_ref().map(|column| column.as_slice()))
    }

    #[inline(always)]
    fn load<S: Simd>(&self, simd: S, first: usize) -> SVector<Wide<S>, N> {
        each_joint(
            #[inline(always)]
            |joint| S::f64s::from_slice(simd, &self.0[joint][first..first + S::f64s::LEN]),
        )
    }
}

impl<'a, const R: usize, const C: usize> Sink<R, C> for RowsMut<'a, R, C> {
    type Room = [SMatrix<f64, R, C>; MOST_LANES];
    type Copied<'r>
        = RowsMut<'r, R, C>
    where
        Self: 'r;

    fn states(&self) -> (usize, Option<usize>) {
        (self.0.len(), None)
    }

    #[inline(always)]
    fn shorten(&mut self, states: usize) {
        self.0 = &mut core::mem::take(&mut self.0)[..states];
    }

    #[cfg(feature = "rayon")]
    fn split(self, states: usize) -> (Self, Self) {
        let (first, others) = self.0.split_at_mut(states);
        (RowsMut(first), RowsMut(others))
    }

    fn state(&self, state: usize) -> SMatrix<f64, R, C> {
        self.0[state]
    }

    fn set(&mut self, state: usize, value: &SMatrix<f64, R, C>) {
        self.0[state] = *value;
    }

    fn room() -> Self::Room {
        [SMatrix::zeros(); MOST_LANES]
    }

    fn elsewhere<'r>(&self, room: &'r mut Self::Room) -> RowsMut<'r, R, C>
    where
        Self: 'r,
    {
        RowsMut(room)
    }

    #[inline(always)]
    fn store<S: Simd>(&mut self, first: usize, value: &SMatrix<Wide<S>, R, C>) {
        let states = &mut self.0[first..first + S::f64s::LEN];
        for column in 0..C {
            for row in 0..R {
                let lanes = value.data.0[column][row].0;
                for lane in 0..S::f64s::LEN {
                    states[lane].data.0[column][row] = lanes[lane];
                }
            }
        }
    }
}

impl<'a, const R: usize, const C: usize> Sink<R, C> for ColumnsMut<'a, R, C> {
    type Room = [[SMatrix<f64, MOST_LANES, 1>; R]; C];
    type Copied<'r>
        = ColumnsMut<'r, R, C>
    where
        Self: 'r;

    fn states(&self) -> (usize, Option<usize>) {
        let lengths = || self.0.iter().flatten().map(|column| column.len());
        let states = lengths().next().unwrap_or(0);
        (states, lengths().find(|&length| length != states))
    }

    #[inline(always)]
    fn shorten(&mut self, states: usize) {
        for column in self.0.iter_mut().flatten() {
            *column = &mut core::mem::take(column)[..states];
        }
    }

    #[cfg(feature = "rayon")]
    fn split(self, states: usize) -> (Self, Self) {
        let mut others = self.0;
        let first = others.each_mut().map(|columns| {
            columns.each_mut().map(|column| {
                let (first, rest) = core::mem::take(column).split_at_mut(states);
                *column = rest;
                first
            })
        });
        (ColumnsMut(first), ColumnsMut(others))
    }

    fn state(&self, state: usize) -> SMatrix<f64, R, C> {
        SMatrix::from_fn(|i, j| self.0[j][i][state])
    }

    fn set(&mut self, state: usize, value: &SMatrix<f64, R, C>) {
        for column in 0..C {
            for row in 0..R {
                self.0[column][row][state] = value[(row, column)];
            }
        }
    }

    fn room() -> Self::Room {
        [[SMatrix::zeros(); R]; C]
    }

    fn elsewhere<'r>(&self, room: &'r mut Self::Room) -> ColumnsMut<'r, R, C>
    where
        Self: 'r,
    {
        ColumnsMut(
            room.each_mut()
                .map(|columns| columns.each_mut().map(|column| column.as_mut_slice())),
        )
    }

    #[inline(always)]
    fn store<S: Simd>(&mut self, first: usize, value: &SMatrix<Wide<S>, R, C>) {
        for column in 0..C {
            for row in 0..R {
                let states = &mut self.0[column][row][first..first + S::f64s::LEN];
                value.data.0[column][row].0.store_slice(states);
            }
        }
    }
}

impl<'a, const N: usize> States<N> for &'a [SVector<f64, N>] {
    type Source = Rows<'a, N>;

    fn source(self) -> Rows<'a, N> {
        Rows(self)
    }
}

impl<'a, const N: usize> States<N> for &'a Vec<SVector<f64, N>> {
    type Source = Rows<'a, N>;

    fn source(self) -> Rows<'a, N> {
        Rows(self)
    }
}

impl<'a, const N: usize, const L: usize> States<N> for &'a [SVector<f64, N>; L] {
    type Source = Rows<'a, N>;

    fn source(self) -> Rows<'a, N> {
        Rows(self)
    }
}

impl<'a, const N: usize> States<N> for [&'a [f64]; N] {
    type Source = Columns<'a, N>;

    fn source(self) -> Columns<'a, N> {
        Columns(self)
    }
}

impl<'a, const N: usize> States<N> for &'a [Vec<f64>; N] {
    type Source = Columns<'a, N>;

    fn source(self) -> Columns<'a, N> {
        Columns(self.each_ref().map(|column| &column[..]))
    }
}

/// The matrices of a column for each joint.
type ByColumns<const N: usize> = Matrix<f64, Dyn, Const<N>, VecStorage<f64, Dyn, Const<N>>>;

impl<'a, const N: usize> States<N> for &'a ByColumns<N> {
    type Source = Columns<'a, N>;

    fn source(self) -> Columns<'a, N> {
        let mut columns = self.as_slice().chunks_exact(self.nrows().max(1));
        Columns(core::array::from_fn(|_| columns.next().unwrap_or_default()))
    }
}

impl<'a, const R: usize, const C: usize> StatesMut<R, C> for &'a mut [SMatrix<f64, R, C>] {
    type Sink = RowsMut<'a, R, C>;

    fn sink(self) -> RowsMut<'a, R, C> {
        RowsMut(self)
    }
}

impl<'a, const R: usize, const C: usize> StatesMut<R, C> for &'a mut Vec<SMatrix<f64, R, C>> {
    type Sink = RowsMut<'a, R, C>;

    fn sink(self) -> RowsMut<'a, R, C> {
        RowsMut(self)
    }
}

impl<'a, const R: usize, const C: usize, const L: usize> StatesMut<R, C>
    for &'a mut [SMatrix<f64, R, C>; L]
{
    type Sink = RowsMut<'a, R, C>;

    fn sink(self) -> RowsMut<'a, R, C> {
        RowsMut(self)
    }
}

impl<'a, const R: usize, const C: usize> StatesMut<R, C> for [[&'a mut [f64]; R]; C] {
    type Sink = ColumnsMut<'a, R, C>;

    fn sink(self) -> ColumnsMut<'a, R, C> {
        ColumnsMut(self)
    }
}

impl<'a, const R: usize> StatesMut<R, 1> for [&'a mut [f64]; R] {
    type Sink = ColumnsMut<'a, R, 1>;

    fn sink(self) -> ColumnsMut<'a, R, 1> {
        ColumnsMut([self])
    }
}

impl<'a, const R: usize> StatesMut<R, 1> for &'a mut [Vec<f64>; R] {
    type Sink = ColumnsMut<'a, R, 1>;

    fn sink(self) -> ColumnsMut<'a, R, 1> {
        ColumnsMut([self.each_mut().map(|column| &mut column[..])])
    }
}

impl<'a, const R: usize> StatesMut<R, 1> for &'a mut ByColumns<R> {
    type Sink = ColumnsMut<'a, R, 1>;

    fn sink(self) -> ColumnsMut<'a, R, 1> {
        let states = self.nrows().max(1);
        let mut columns = self.as_mut_slice().chunks_exact_mut(states);
        ColumnsMut([core::array::from_fn(|_| columns.next().unwrap_or_default())])
    }
}
