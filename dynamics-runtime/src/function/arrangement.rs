//! Arrangements of numbers: the arguments and values of generated functions, apart from the kind of number.

use core::slice;

use nalgebra::SMatrix;

use crate::Scalar;

/// An arrangement of numbers, apart from what numbers they are.
#[doc(hidden)]
pub trait Arrangement: 'static {
    /// Numbers in this arrangement.
    type Of<T: Scalar>: Copy;

    /// The same number everywhere.
    fn filled<T: Scalar>(x: T) -> Self::Of<T>;

    /// How many runs of numbers that lie beside each other there are.
    const RUNS: usize;

    /// One of the runs, counted from 0.
    fn run<T: Scalar>(value: &Self::Of<T>, index: usize) -> &[T];

    /// The same, to write to.
    fn run_mut<T: Scalar>(value: &mut Self::Of<T>, index: usize) -> &mut [T];

    /// Does something to each number of `a`, with its counterpart in `b`.
    #[inline(always)]
    fn zip<A: Scalar, B: Scalar>(
        a: &mut Self::Of<A>,
        b: &Self::Of<B>,
        mut f: impl FnMut(&mut A, B),
    ) {
        for index in 0..Self::RUNS {
            let runs = Self::run_mut::<A>(a, index).iter_mut();
            for (a, b) in runs.zip(Self::run::<B>(b, index)) {
                f(a, *b);
            }
        }
    }
}

/// One number.
#[doc(hidden)]
#[derive(Debug)]
pub enum Number {}

impl Arrangement for Number {
    type Of<T: Scalar> = T;

    #[inline(always)]
    fn filled<T: Scalar>(x: T) -> T {
        x
    }

    const RUNS: usize = 1;

    #[inline(always)]
    fn run<T: Scalar>(value: &T, _: usize) -> &[T] {
        slice::from_ref(value)
    }

    #[inline(always)]
    fn run_mut<T: Scalar>(value: &mut T, _: usize) -> &mut [T] {
        slice::from_mut(value)
    }
}

/// A matrix of `R` rows and `C` columns.
#[doc(hidden)]
#[derive(Debug)]
pub enum Entries<const R: usize, const C: usize> {}

impl<const R: usize, const C: usize> Arrangement for Entries<R, C> {
    type Of<T: Scalar> = SMatrix<T, R, C>;

    #[inline(always)]
    fn filled<T: Scalar>(x: T) -> SMatrix<T, R, C> {
        SMatrix::repeat(x)
    }

    const RUNS: usize = 1;

    #[inline(always)]
    fn run<T: Scalar>(value: &SMatrix<T, R, C>, _: usize) -> &[T] {
        value.data.0.as_flattened()
    }

    #[inline(always)]
    fn run_mut<T: Scalar>(value: &mut SMatrix<T, R, C>, _: usize) -> &mut [T] {
        value.data.0.as_flattened_mut()
    }
}

impl<P: Arrangement, const K: usize> Arrangement for [P; K] {
    type Of<T: Scalar> = [P::Of<T>; K];

    #[inline(always)]
    fn filled<T: Scalar>(x: T) -> [P::Of<T>; K] {
        [P::filled(x); K]
    }

    const RUNS: usize = K * P::RUNS;

    #[inline(always)]
    fn run<T: Scalar>(value: &[P::Of<T>; K], index: usize) -> &[T] {
        match P::RUNS {
            0 => &[],
            runs => P::run::<T>(&value[index / runs], index % runs),
        }
    }

    #[inline(always)]
    fn run_mut<T: Scalar>(value: &mut [P::Of<T>; K], index: usize) -> &mut [T] {
        match P::RUNS {
            0 => &mut [],
            runs => P::run_mut::<T>(&mut value[index / runs], index % runs),
        }
    }
}

macro_rules! impl_tuple {
    ($($part:ident $other:ident $x:ident $y:ident),*) => {
        #[allow(clippy::unused_unit, reason = "one of the tuples is empty")]
        impl<$($part: Arrangement),*> Arrangement for ($($part,)*) {
            type Of<T: Scalar> = ($($part::Of<T>,)*);

            #[inline(always)]
            fn filled<T: Scalar>(x: T) -> Self::Of<T> {
                let _ = x;
                ($($part::filled(x),)*)
            }

            const RUNS: usize = 0 $(+ $part::RUNS)*;

            #[inline(always)]
            fn run<T: Scalar>(($($x,)*): &Self::Of<T>, index: usize) -> &[T] {
                $(
                    let Some(index) = index.checked_sub($part::RUNS) else {
                        return $part::run::<T>($x, index);
                    };
                )*
                let _ = index;
                &[]
            }

            #[inline(always)]
            fn run_mut<T: Scalar>(($($x,)*): &mut Self::Of<T>, index: usize) -> &mut [T] {
                $(
                    let Some(index) = index.checked_sub($part::RUNS) else {
                        return $part::run_mut::<T>($x, index);
                    };
                )*
                let _ = index;
                &mut []
            }
        }
    };
}

/// Calls a macro for each length of the tuples that functions take and return, with the names of two types and of two
/// variables for each part.
macro_rules! each_tuple {
    ($then:ident) => {
        $then!();
        $then!(P PP p pp);
        $then!(P PP p pp, Q QQ q qq);
        $then!(P PP p pp, Q QQ q qq, R RR r rr);
        $then!(P PP p pp, Q QQ q qq, R RR r rr, V VV v vv);
        $then!(P PP p pp, Q QQ q qq, R RR r rr, V VV v vv, X XX x xx);
        $then!(P PP p pp, Q QQ q qq, R RR r rr, V VV v vv, X XX x xx, Z ZZ z zz);
        $then!(P PP p pp, Q QQ q qq, R RR r rr, V VV v vv, X XX x xx, Z ZZ z zz, G GG g gg);
        $then!(P PP p pp, Q QQ q qq, R RR r rr, V VV v vv, X XX x xx, Z ZZ z zz, G GG g gg, I II i ii);
        $then!(P PP p pp, Q QQ q qq, R RR r rr, V VV v vv, X XX x xx, Z ZZ z zz, G GG g gg, I II i ii, K KK k kk);
        $then!(P PP p pp, Q QQ q qq, R RR r rr, V VV v vv, X XX x xx, Z ZZ z zz, G GG g gg, I II i ii, K KK k kk, M MM m mm);
        $then!(P PP p pp, Q QQ q qq, R RR r rr, V VV v vv, X XX x xx, Z ZZ z zz, G GG g gg, I II i ii, K KK k kk, M MM m mm, O OO o oo);
        $then!(P PP p pp, Q QQ q qq, R RR r rr, V VV v vv, X XX x xx, Z ZZ z zz, G GG g gg, I II i ii, K KK k kk, M MM m mm, O OO o oo, D DD d dd);
    };
}
#[cfg(feature = "std")]
pub(crate) use each_tuple;

each_tuple!(impl_tuple);

/// Numbers in an arrangement.
pub(crate) type Of<A, T> = <A as Arrangement>::Of<T>;
