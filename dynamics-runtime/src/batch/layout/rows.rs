//! A vector or a matrix for each state.

use fearless_simd::{Simd, SimdBase};
use nalgebra::{SMatrix, SVector};

use super::{MOST_LANES, Sink, Source, States, StatesMut, each_joint};
use crate::batch::wide::Wide;

/// A vector for each state.
#[derive(Clone, Copy)]
pub struct Rows<'a, const N: usize>(&'a [SVector<f64, N>]);

/// Room for a matrix for each state.
pub struct RowsMut<'a, const R: usize, const C: usize>(&'a mut [SMatrix<f64, R, C>]);

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
