//! Operators that follow from others.

/// `a += b` and its like, of numbers that are copied.
macro_rules! impl_assign {
    (impl $generics:tt for $number:ty) => {
        $crate::operators::impl_assign! {
            impl $generics for $number;
            AddAssign add_assign +;
            SubAssign sub_assign -;
            MulAssign mul_assign *;
            DivAssign div_assign /;
        }
    };
    (impl $generics:tt for $number:ty; $($assign:ident $method:ident $operator:tt;)*) => {$(
        $crate::operators::impl_assign! {
            @one impl $generics for $number; $assign $method $operator
        }
    )*};
    (@one impl [$($generics:tt)*] for $number:ty; $assign:ident $method:ident $operator:tt) => {
        impl<$($generics)*> core::ops::$assign for $number {
            #[inline]
            fn $method(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    };
}

pub(crate) use impl_assign;
