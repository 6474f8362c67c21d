//! The arguments of a function: a source for each.

use fearless_simd::Simd;

use super::layout::Source;
use super::wide::{Precision, Wide};
use crate::function::{Arrangement, Of, each_tuple};

macro_rules! impl_arguments {
    ($($part:ident $source:ident $x:ident $y:ident),*) => {
        #[allow(unused_variables, unused_mut, clippy::unused_unit, reason = "there may be no argument")]
        impl<E: Precision, $($part: Arrangement, $source: Source<$part, E>),*> Source<($($part,)*), E>
            for ($($source,)*)
        {
            type Room = ($($source::Room,)*);
            type Copied<'r> = ($($source::Copied<'r>,)*) where Self: 'r;

            fn states(&self, tell: &mut dyn FnMut(usize, Option<usize>)) {
                let ($($x,)*) = self;
                $($x.states(tell);)*
            }

            #[cfg(feature = "rayon")]
            fn split(self, states: usize) -> (Self, Self) {
                let ($($x,)*) = self;
                $(let ($x, $y) = $x.split(states);)*
                (($($x,)*), ($($y,)*))
            }

            #[inline]
            fn state(&self, state: usize) -> Of<($($part,)*), E> {
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
            fn load<S: Simd>(&self, simd: S, first: usize) -> Of<($($part,)*), Wide<S, E>> {
                let ($($x,)*) = self;
                ($($x.load(simd, first),)*)
            }
        }
    };
}

each_tuple!(impl_arguments);
