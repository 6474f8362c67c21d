//! Values of several parts, each of which lies where it likes: arrays and tuples.

use fearless_simd::Simd;

use super::{Sink, StatesMut, lengths};
use crate::batch::wide::{Precision, Wide};
use crate::function::{Arrangement, Of, each_tuple};

/// A sink for each element of an array.
pub struct Elements<X, const K: usize>([X; K]);

impl<A, E, X, const K: usize> Sink<[A; K], E> for Elements<X, K>
where
    A: Arrangement,
    E: Precision,
    X: Sink<A, E>,
{
    type Room = [X::Room; K];
    type Copied<'r>
        = Elements<X::Copied<'r>, K>
    where
        Self: 'r;

    fn states(&self) -> (usize, Option<usize>) {
        lengths(self.0.iter().map(Sink::states))
    }

    #[cfg(feature = "rayon")]
    fn take(&mut self, states: usize) -> Self {
        Elements(self.0.each_mut().map(|element| element.take(states)))
    }

    fn state(&self, state: usize) -> [Of<A, E>; K] {
        self.0.each_ref().map(|element| element.state(state))
    }

    fn set(&mut self, state: usize, value: &[Of<A, E>; K]) {
        for (element, value) in self.0.iter_mut().zip(value) {
            element.set(state, value);
        }
    }

    fn room() -> Self::Room {
        core::array::from_fn(|_| X::room())
    }

    fn elsewhere<'r>(room: &'r mut Self::Room) -> Elements<X::Copied<'r>, K>
    where
        Self: 'r,
    {
        Elements(room.each_mut().map(X::elsewhere))
    }

    #[inline(always)]
    fn store<S: Simd>(&mut self, first: usize, value: &[Of<A, Wide<S, E>>; K]) {
        for i in 0..K {
            self.0[i].store(first, &value[i]);
        }
    }
}

impl<A, E, X, const K: usize> StatesMut<[A; K], E> for [X; K]
where
    A: Arrangement,
    E: Precision,
    X: StatesMut<A, E>,
{
    type Sink = Elements<X::Sink, K>;

    fn sink(self) -> Self::Sink {
        Elements(self.map(StatesMut::sink))
    }
}

macro_rules! impl_parts {
    () => {};
    ($($part:ident $sink:ident $x:ident $y:ident),*) => {
        impl<E: Precision, $($part: Arrangement, $sink: Sink<$part, E>,)*> Sink<($($part,)*), E>
            for ($($sink,)*)
        {
            type Room = ($($sink::Room,)*);
            type Copied<'r> = ($($sink::Copied<'r>,)*) where Self: 'r;

            fn states(&self) -> (usize, Option<usize>) {
                let ($($x,)*) = self;
                lengths([$($x.states()),*].into_iter())
            }

            #[cfg(feature = "rayon")]
            fn take(&mut self, states: usize) -> Self {
                let ($($x,)*) = self;
                ($($x.take(states),)*)
            }

            fn state(&self, state: usize) -> Of<($($part,)*), E> {
                let ($($x,)*) = self;
                ($($x.state(state),)*)
            }

            fn set(&mut self, state: usize, ($($y,)*): &Of<($($part,)*), E>) {
                let ($($x,)*) = self;
                $($x.set(state, $y);)*
            }

            fn room() -> Self::Room {
                ($($sink::room(),)*)
            }

            fn elsewhere<'r>(($($x,)*): &'r mut Self::Room) -> Self::Copied<'r>
            where
                Self: 'r,
            {
                ($($sink::elsewhere($x),)*)
            }

            #[inline(always)]
            fn store<S: Simd>(&mut self, first: usize, ($($y,)*): &Of<($($part,)*), Wide<S, E>>) {
                let ($($x,)*) = self;
                $($x.store(first, $y);)*
            }
        }

        impl<E: Precision, $($part: Arrangement, $sink: StatesMut<$part, E>,)*>
            StatesMut<($($part,)*), E> for ($($sink,)*)
        {
            type Sink = ($($sink::Sink,)*);

            fn sink(self) -> Self::Sink {
                let ($($x,)*) = self;
                ($($x.sink(),)*)
            }
        }
    };
}

each_tuple!(impl_parts);
