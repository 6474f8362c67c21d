//! Operators of numbers that are copied.

/// Operators by their values: `Add add |a, b| value;`.
macro_rules! impl_operators {
    (impl $generics:tt for $number:ty; $($operator:ident $method:ident |$a:ident $(, $b:ident)?| $value:expr;)*) => {$(
        $crate::operators::impl_operators! {
            @one impl $generics for $number; $operator $method |$a $(, $b)?| $value
        }
    )*};
    (@one impl [$($generics:tt)*] for $number:ty; $operator:ident $method:ident |$a:ident $(, $b:ident)?| $value:expr) => {
        impl<$($generics)*> core::ops::$operator for $number {
            type Output = Self;

            #[inline(always)]
            fn $method(self $(, $b: Self)?) -> Self {
                let $a = self;
                $value
            }
        }
    };
}

/// `a += b` and its like, 0 and 1, where `|x| number` makes a number of a double.
macro_rules! impl_assign {
    (impl $generics:tt for $number:ty; |$x:ident| $from:expr) => {
        $crate::operators::impl_assign! { @one impl $generics for $number; AddAssign add_assign + }
        $crate::operators::impl_assign! { @one impl $generics for $number; SubAssign sub_assign - }
        $crate::operators::impl_assign! { @one impl $generics for $number; MulAssign mul_assign * }
        $crate::operators::impl_assign! { @one impl $generics for $number; DivAssign div_assign / }
        $crate::operators::impl_assign! { @units impl $generics for $number; |$x| $from }
    };
    (@one impl [$($generics:tt)*] for $number:ty; $assign:ident $method:ident $operator:tt) => {
        impl<$($generics)*> core::ops::$assign for $number {
            #[inline]
            fn $method(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    };
    (@units impl [$($generics:tt)*] for $number:ty; |$x:ident| $from:expr) => {
        impl<$($generics)*> num_traits::Zero for $number {
            #[inline]
            fn zero() -> Self {
                let $x = 0.0;
                $from
            }

            #[inline]
            fn is_zero(&self) -> bool {
                *self == <Self as num_traits::Zero>::zero()
            }
        }

        impl<$($generics)*> num_traits::One for $number {
            #[inline]
            fn one() -> Self {
                let $x = 1.0;
                $from
            }
        }
    };
}

/// Methods of [`Scalar`](crate::Scalar) by their values: `sqrt(x) => value;`.
macro_rules! scalar_methods {
    ($($method:ident($($x:ident),*) => $value:expr;)*) => {
        $($crate::operators::scalar_methods! { @$method($($x),*) $value })*
    };
    (@from_f64($x:ident) $value:expr) => {
        #[inline(always)]
        fn from_f64($x: f64) -> Self {
            $value
        }
    };
    (@epsilon() $value:expr) => {
        #[inline(always)]
        fn epsilon() -> Self {
            $value
        }
    };
    (@is_positive($x:ident) $value:expr) => {
        #[inline(always)]
        fn is_positive(self) -> bool {
            let $x = self;
            $value
        }
    };
    (@mul_add($x:ident, $a:ident, $b:ident) $value:expr) => {
        #[inline(always)]
        fn mul_add(self, $a: Self, $b: Self) -> Self {
            let $x = self;
            $value
        }
    };
    (@ratio_to_f64($x:ident, $of:ident) $value:expr) => {
        #[inline(always)]
        fn ratio_to_f64(self, $of: Self) -> f64 {
            let $x = self;
            $value
        }
    };
    (@$method:ident($x:ident) $value:expr) => {
        #[inline(always)]
        fn $method(self) -> Self {
            let $x = self;
            $value
        }
    };
}

pub(crate) use {impl_assign, impl_operators, scalar_methods};
