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

    /// As [`zip_runs`](Arrangement::zip_runs): what each arrangement says of itself. One reference is handed on, for
    /// references to references are not inlined for certain.
    fn each_run<A: Scalar, B: Scalar>(
        a: &mut Self::Of<A>,
        b: &Self::Of<B>,
        f: &mut impl FnMut(&mut [A], &[B]),
    );

    /// Does something to each run of numbers of `a` that lie beside each other, with its counterpart in `b`.
    #[inline(always)]
    fn zip_runs<A: Scalar, B: Scalar>(
        a: &mut Self::Of<A>,
        b: &Self::Of<B>,
        mut f: impl FnMut(&mut [A], &[B]),
    ) {
        Self::each_run(a, b, &mut f);
    }

    /// Does something to each number of `a`, with its counterpart in `b`.
    #[inline(always)]
    fn zip<A: Scalar, B: Scalar>(
        a: &mut Self::Of<A>,
        b: &Self::Of<B>,
        mut f: impl FnMut(&mut A, B),
    ) {
        Self::zip_runs(
            a,
            b,
            #[inline(always)]
            |a, b| {
                for (a, b) in a.iter_mut().zip(b) {
                    f(a, *b);
                }
            },
        );
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

    #[inline(always)]
    fn each_run<A: Scalar, B: Scalar>(a: &mut A, b: &B, f: &mut impl FnMut(&mut [A], &[B])) {
        f(slice::from_mut(a), slice::from_ref(b));
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

    #[inline(always)]
    fn each_run<A: Scalar, B: Scalar>(
        a: &mut SMatrix<A, R, C>,
        b: &SMatrix<B, R, C>,
        f: &mut impl FnMut(&mut [A], &[B]),
    ) {
        f(a.data.0.as_flattened_mut(), b.data.0.as_flattened());
    }
}

impl<P: Arrangement, const K: usize> Arrangement for [P; K] {
    type Of<T: Scalar> = [P::Of<T>; K];

    #[inline(always)]
    fn filled<T: Scalar>(x: T) -> [P::Of<T>; K] {
        [P::filled(x); K]
    }

    #[inline(always)]
    fn each_run<A: Scalar, B: Scalar>(
        a: &mut [P::Of<A>; K],
        b: &[P::Of<B>; K],
        f: &mut impl FnMut(&mut [A], &[B]),
    ) {
        for i in 0..K {
            P::each_run(&mut a[i], &b[i], f);
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

            #[inline(always)]
            fn each_run<A: Scalar, B: Scalar>(
                a: &mut Self::Of<A>,
                b: &Self::Of<B>,
                f: &mut impl FnMut(&mut [A], &[B]),
            ) {
                let (($($x,)*), ($($y,)*)) = (a, b);
                $($part::each_run($x, $y, f);)*
                let _ = f;
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
