//! The arguments of a function: a source for each.

use fearless_simd::Simd;

use super::layout::Source;
use super::wide::{Precision, Wide};
use crate::function::{Arrangement, Entries, Of, each_tuple};

/// The arguments of a function, whose arrangement is a tuple of vectors, with the methods of [`Source`] for all of them.
pub trait Arguments<A: Arrangement, E: Precision>: Copy + Send {
    type Room;
    type Copied<'r>: Arguments<A, E>
    where
        Self: 'r;

    /// Tells of each argument the number of states, and one that differs from it, if there is one.
    fn states(&self, tell: &mut dyn FnMut(usize, Option<usize>));
    #[cfg(feature = "rayon")]
    fn split(self, states: usize) -> (Self, Self);
    fn state(&self, state: usize) -> Of<A, E>;
    fn room() -> Self::Room;
    fn padded<'r>(&self, states: usize, room: &'r mut Self::Room) -> Self::Copied<'r>
    where
        Self: 'r;
    fn load<S: Simd>(&self, simd: S, first: usize) -> Of<A, Wide<S, E>>;
}

macro_rules! impl_arguments {
    ($($source:ident $size:ident $x:ident $y:ident),*) => {
        #[allow(unused_variables, unused_mut, clippy::unused_unit, reason = "there may be no argument")]
        impl<E: Precision, $($source: Source<$size, E>,)* $(const $size: usize),*>
            Arguments<($(Entries<$size, 1>,)*), E> for ($($source,)*)
        {
            type Room = ($($source::Room,)*);
            type Copied<'r> = ($($source::Copied<'r>,)*) where Self: 'r;

            fn states(&self, tell: &mut dyn FnMut(usize, Option<usize>)) {
                let ($($x,)*) = self;
                $({
                    let (states, other) = $x.states();
                    tell(states, other);
                })*
            }

            #[cfg(feature = "rayon")]
            fn split(self, states: usize) -> (Self, Self) {
                let ($($x,)*) = self;
                $(let ($x, $y) = $x.split(states);)*
                (($($x,)*), ($($y,)*))
            }

            #[inline]
            fn state(&self, state: usize) -> Of<($(Entries<$size, 1>,)*), E> {
                let ($($x,)*) = self;
                ($($x.state(state),)*)
            }

            fn room() -> Self::Room {
                ($($source::room(),)*)
            }

            fn padded<'r>(&self, states: usize, room: &'r mut Self::Room) -> Self::Copied<'r>
            where
                Self: 'r,
            {
                let (($($x,)*), ($($y,)*)) = (self, room);
                ($($x.padded(states, $y),)*)
            }

            #[inline(always)]
            fn load<S: Simd>(&self, simd: S, first: usize) -> Of<($(Entries<$size, 1>,)*), Wide<S, E>> {
                let ($($x,)*) = self;
                ($($x.load(simd, first),)*)
            }
        }
    };
}

each_tuple!(impl_arguments);
