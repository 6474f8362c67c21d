//! A column for each joint, or for each entry of a matrix.

use fearless_simd::{Simd, SimdBase};
use nalgebra::{Const, Dyn, Matrix, SMatrix, SVector, VecStorage};

use super::{MOST_LANES, Sink, Source, States, StatesMut, each_joint};
use crate::batch::wide::Wide;

/// A column for each joint.
#[derive(Clone, Copy)]
pub struct Columns<'a, const N: usize>([&'a [f64]; N]);

/// Room in a column for each entry.
pub struct ColumnsMut<'a, const R: usize, const C: usize>([[&'a mut [f64]; R]; C]);

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
