//! Operators of numbers that are copied.

/// Operators by their values: `Add add |a, b| value;`.
macro_rules! impl_operators {
    (impl $generics:tt for $number:ty; $(
        $(#[$equation:meta])* $operator:ident $method:ident |$a:ident $(, $b:ident)?| $value:expr;
    )*) => {$(
        $crate::operators::impl_operators! {
            @one impl $generics for $number; $(#[$equation])* $operator $method |$a $(, $b)?| $value
        }
    )*};
    (@one impl [$($generics:tt)*] for $number:ty;
        $(#[$equation:meta])* $operator:ident $method:ident |$a:ident $(, $b:ident)?| $value:expr
    ) => {
        impl<$($generics)*> core::ops::$operator for $number {
            type Output = Self;

            $(#[$equation])*
            #[inline]
            fn $method(self $(, $b: Self)?) -> Self {
                let $a = self;
                $value
            }
        }
    };
}
pub(crate) use impl_operators;
