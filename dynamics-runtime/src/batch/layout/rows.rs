//! A value for each state: a number, a vector, a matrix, an array or a tuple.

use fearless_simd::{Simd, SimdBase};
use nalgebra::SVector;

use super::transposition::transposed;
use super::{MOST_LANES, Sink, Source, States, StatesMut, each_joint};
use crate::Pose;
use crate::batch::wide::{Precision, Wide, lanes};
use crate::function::{Arrangement, Entries, Of};

/// The numbers of one state: a vector or a pose.
pub trait Numbers<E: Precision, const N: usize>: Copy + Send + Sync {
    /// Any numbers.
    fn any() -> Self;

    /// The numbers as a vector.
    fn vector(&self) -> SVector<E, N>;

    /// One of them.
    fn number(&self, index: usize) -> E;
}

impl<E: Precision, const N: usize> Numbers<E, N> for SVector<E, N> {
    fn any() -> Self {
        SVector::repeat(E::from_f64(0.0))
    }

    fn vector(&self) -> SVector<E, N> {
        *self
    }

    #[inline(always)]
    fn number(&self, index: usize) -> E {
        self.data.0[0][index]
    }
}

/// The rotation by rows, then the position.
impl<E: Precision> Numbers<E, 12> for Pose<E> {
    fn any() -> Self {
        Pose::identity()
    }

    fn vector(&self) -> SVector<E, 12> {
        self.entries()
    }

    #[inline(always)]
    fn number(&self, index: usize) -> E {
        match index {
            0..9 => self.rotation.data.0[index % 3][index / 3],
            _ => self.position.data.0[0][index - 9],
        }
    }
}

/// The numbers of each state beside each other.
#[derive(Clone, Copy)]
pub struct Rows<'a, X>(&'a [X]);

/// Room for a value for each state.
pub struct RowsMut<'a, A: Arrangement, E: Precision>(&'a mut [Of<A, E>]);

impl<'a, X: Numbers<E, N>, E: Precision, const N: usize> Source<Entries<N, 1>, E> for Rows<'a, X> {
    type Room = [X; MOST_LANES];
    type Copied<'r>
        = Rows<'r, X>
    where
        Self: 'r;

    fn states(&self, tell: &mut dyn FnMut(usize, Option<usize>)) {
        tell(self.0.len(), None);
    }

    #[cfg(feature = "rayon")]
    fn split(self, states: usize) -> (Self, Self) {
        let (first, others) = self.0.split_at(states);
        (Rows(first), Rows(others))
    }

    fn state(&self, state: usize) -> SVector<E, N> {
        self.0[state].vector()
    }

    fn room() -> Self::Room {
        [X::any(); MOST_LANES]
    }

    fn padded<'r>(&self, states: usize, room: &'r mut Self::Room) -> Rows<'r, X>
    where
        Self: 'r,
    {
        for (lane, place) in room.iter_mut().enumerate() {
            *place = self.0[lane.min(states - 1)];
        }
        Rows(room)
    }

    #[inline(always)]
    fn load<S: Simd>(&self, simd: S, first: usize) -> SVector<Wide<S, E>, N> {
        let states = &self.0[first..first + lanes::<S, E>()];
        each_joint(
            #[inline(always)]
            |joint| {
                E::Native::<S>::from_fn(
                    simd,
                    #[inline(always)]
                    |lane| states[lane].number(joint),
                )
            },
        )
    }
}

impl<'a, A: Arrangement, E: Precision> Sink<A, E> for RowsMut<'a, A, E>
where
    Of<A, E>: Send,
{
    type Room = [Of<A, E>; MOST_LANES];
    type Copied<'r>
        = RowsMut<'r, A, E>
    where
        Self: 'r;

    fn states(&self) -> (usize, Option<usize>) {
        (self.0.len(), None)
    }

    #[cfg(feature = "rayon")]
    fn take(&mut self, states: usize) -> Self {
        let (first, others) = core::mem::take(&mut self.0).split_at_mut(states);
        self.0 = others;
        RowsMut(first)
    }

    fn state(&self, state: usize) -> Of<A, E> {
        self.0[state]
    }

    fn set(&mut self, state: usize, value: &Of<A, E>) {
        self.0[state] = *value;
    }

    fn room() -> Self::Room {
        [A::filled(E::from_f64(0.0)); MOST_LANES]
    }

    fn elsewhere<'r>(room: &'r mut Self::Room) -> RowsMut<'r, A, E>
    where
        Self: 'r,
    {
        RowsMut(room)
    }

    #[inline(always)]
    fn store<S: Simd>(&mut self, first: usize, value: &Of<A, Wide<S, E>>) {
        let lanes = lanes::<S, E>();
        let states = &mut self.0[first..first + lanes];
        for index in 0..A::RUNS {
            let numbers = A::run::<Wide<S, E>>(value, index);
            let whole = numbers.len() - numbers.len() % lanes;
            for block in (0..whole).step_by(lanes) {
                let by_state = transposed(&numbers[block..]);
                for (state, numbers) in states.iter_mut().zip(&by_state) {
                    let run = A::run_mut::<E>(state, index);
                    numbers.0.store_slice(&mut run[block..block + lanes]);
                }
            }
            for number in whole..numbers.len() {
                for (lane, state) in states.iter_mut().enumerate() {
                    A::run_mut::<E>(state, index)[number] = numbers[number].0[lane];
                }
            }
        }
    }
}

macro_rules! impl_rows {
    ($($vectors:ty, $values:ty $(, $length:ident)?;)*) => {$(
        impl<'a, E: Precision, const N: usize $(, const $length: usize)?> States<N, E>
            for &'a $vectors
        {
            type Source = Rows<'a, SVector<E, N>>;

            fn source(self) -> Self::Source {
                Rows(self)
            }
        }

        impl<'a, A: Arrangement, E: Precision $(, const $length: usize)?> StatesMut<A, E>
            for &'a mut $values
        where
            Of<A, E>: Send,
        {
            type Sink = RowsMut<'a, A, E>;

            fn sink(self) -> Self::Sink {
                RowsMut(self)
            }
        }
    )*};
}

macro_rules! impl_poses {
    ($($poses:ty $(, $length:ident)?;)*) => {$(
        impl<'a, E: Precision $(, const $length: usize)?> States<12, E> for &'a $poses {
            type Source = Rows<'a, Pose<E>>;

            fn source(self) -> Self::Source {
                Rows(self)
            }
        }
    )*};
}

impl_poses! {
    [Pose<E>];
    Vec<Pose<E>>;
    [Pose<E>; L], L;
}

impl_rows! {
    [SVector<E, N>], [Of<A, E>];
    Vec<SVector<E, N>>, Vec<Of<A, E>>;
    [SVector<E, N>; L], [Of<A, E>; L], L;
}
