//! A column for each joint, or for each entry of a matrix.

use core::array::from_fn;

use fearless_simd::{Simd, SimdBase};
use nalgebra::{Const, Dyn, Matrix, SMatrix, SVector, VecStorage};

use super::{MOST_LANES, Sink, Source, States, StatesMut, each_joint, lengths};
use crate::batch::wide::{Precision, Wide, lanes};
use crate::function::Entries;
use crate::unrolled::for_each_index;

/// A column for each joint.
#[derive(Clone, Copy)]
pub struct Columns<'a, E, const N: usize>([&'a [E]; N]);

/// Room in a column for each entry.
pub struct ColumnsMut<'a, E, const R: usize, const C: usize>([[&'a mut [E]; R]; C]);

impl<'a, E: Precision, const N: usize> Source<Entries<N, 1>, E> for Columns<'a, E, N> {
    type Room = [SMatrix<E, MOST_LANES, 1>; N];
    type Copied<'r>
        = Columns<'r, E, N>
    where
        Self: 'r;

    fn states(&self, tell: &mut dyn FnMut(usize, Option<usize>)) {
        let (states, other) = lengths(self.0.iter().map(|column| (column.len(), None)));
        tell(states, other);
    }

    #[cfg(feature = "rayon")]
    fn split(self, states: usize) -> (Self, Self) {
        let (mut first, mut others) = (self.0, self.0);
        for (first, others) in first.iter_mut().zip(&mut others) {
            (*first, *others) = first.split_at(states);
        }
        (Columns(first), Columns(others))
    }

    fn state(&self, state: usize) -> SVector<E, N> {
        SVector::from_fn(|joint, _| self.0[joint][state])
    }

    fn room() -> Self::Room {
        [SMatrix::repeat(E::from_f64(0.0)); N]
    }

    fn padded<'r>(&self, states: usize, room: &'r mut Self::Room) -> Columns<'r, E, N>
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
    fn load<S: Simd>(&self, simd: S, first: usize) -> SVector<Wide<S, E>, N> {
        each_joint(
            #[inline(always)]
            |joint| {
                E::Native::<S>::from_slice(simd, &self.0[joint][first..first + lanes::<S, E>()])
            },
        )
    }
}

impl<'a, E: Precision, const R: usize, const C: usize> Sink<Entries<R, C>, E>
    for ColumnsMut<'a, E, R, C>
{
    type Room = [[SMatrix<E, MOST_LANES, 1>; R]; C];
    type Copied<'r>
        = ColumnsMut<'r, E, R, C>
    where
        Self: 'r;

    fn states(&self) -> (usize, Option<usize>) {
        let columns = self.0.iter().flatten();
        lengths(columns.map(|column| (column.len(), None)))
    }

    #[cfg(feature = "rayon")]
    fn take(&mut self, states: usize) -> Self {
        ColumnsMut(self.0.each_mut().map(|columns| {
            columns.each_mut().map(|column| {
                let (first, others) = core::mem::take(column).split_at_mut(states);
                *column = others;
                first
            })
        }))
    }

    fn state(&self, state: usize) -> SMatrix<E, R, C> {
        SMatrix::from_fn(|i, j| self.0[j][i][state])
    }

    fn set(&mut self, state: usize, value: &SMatrix<E, R, C>) {
        for column in 0..C {
            for row in 0..R {
                self.0[column][row][state] = value[(row, column)];
            }
        }
    }

    fn room() -> Self::Room {
        [[SMatrix::repeat(E::from_f64(0.0)); R]; C]
    }

    fn elsewhere<'r>(room: &'r mut Self::Room) -> ColumnsMut<'r, E, R, C>
    where
        Self: 'r,
    {
        ColumnsMut(
            room.each_mut()
                .map(|columns| columns.each_mut().map(|column| column.as_mut_slice())),
        )
    }

    #[inline(always)]
    fn store<S: Simd>(&mut self, first: usize, value: &SMatrix<Wide<S, E>, R, C>) {
        for_each_index!(C, column => for_each_index!(R, row => {
            let states = &mut self.0[column][row][first..first + lanes::<S, E>()];
            value.data.0[column][row].0.store_slice(states);
        }));
    }
}

/// The matrices of a column for each joint.
type ByColumns<E, const N: usize> = Matrix<E, Dyn, Const<N>, VecStorage<E, Dyn, Const<N>>>;

/// The vectors as slices.
///
/// Not by `map`, which writes an array in parts and reads it as a whole: a processor waits hundreds of cycles there.
#[inline(always)]
fn slices<E: Precision, const R: usize, const C: usize>(
    vectors: &mut [[Vec<E>; R]; C],
) -> ColumnsMut<'_, E, R, C> {
    let mut slices = ColumnsMut(from_fn(|_| from_fn(|_| &mut [][..])));
    for (slices, vectors) in slices.0.iter_mut().zip(vectors) {
        for (slice, vector) in slices.iter_mut().zip(vectors) {
            *slice = vector;
        }
    }
    slices
}

macro_rules! impl_columns {
    ($(States<$n:ident> for $states:ty, |$self:ident| $source:expr;)*) => {$(
        impl<'a, E: Precision, const $n: usize> States<$n, E> for $states {
            type Source = Columns<'a, E, $n>;

            fn source($self) -> Columns<'a, E, $n> {
                $source
            }
        }
    )*};
    ($(StatesMut<$r:ident, $c:tt $(of $columns:ident)?> for $states:ty, |$self:ident| $sink:expr;)*) => {$(
        impl<'a, E: Precision, const $r: usize $(, const $columns: usize)?>
            StatesMut<Entries<$r, $c>, E> for $states
        {
            type Sink = ColumnsMut<'a, E, $r, $c>;

            fn sink($self) -> ColumnsMut<'a, E, $r, $c> {
                $sink
            }
        }
    )*};
}

impl_columns! {
    States<N> for [&'a [E]; N], |self| Columns(self);
    States<N> for &'a [Vec<E>; N], |self| {
        let mut columns = Columns([&[]; N]);
        for (column, vector) in columns.0.iter_mut().zip(self) {
            *column = vector;
        }
        columns
    };
    States<N> for &'a ByColumns<E, N>, |self| {
        let mut columns = self.as_slice().chunks_exact(self.nrows().max(1));
        Columns(from_fn(|_| columns.next().unwrap_or_default()))
    };
}

impl_columns! {
    StatesMut<R, C of C> for [[&'a mut [E]; R]; C], |self| ColumnsMut(self);
    StatesMut<R, C of C> for &'a mut [[Vec<E>; R]; C], |self| slices(self);
    StatesMut<R, 1> for [&'a mut [E]; R], |self| ColumnsMut([self]);
    StatesMut<R, 1> for &'a mut [Vec<E>; R], |self| slices(core::array::from_mut(self));
    StatesMut<R, 1> for &'a mut ByColumns<E, R>, |self| {
        let states = self.nrows().max(1);
        let mut columns = self.as_mut_slice().chunks_exact_mut(states);
        ColumnsMut([from_fn(|_| columns.next().unwrap_or_default())])
    };
}
