//! The dual numbers of the crate `num-dual` as scalars: exact derivatives of any generated function.

use num_dual::{Dual, Dual2, DualNum, DualSVec, HyperDual};

use crate::Scalar;

macro_rules! impl_scalar {
    ($($dual:ty $(, $n:ident)?;)*) => {$(
        /// Values and derivatives are those of the function that is evaluated, to some roundings of
        /// the inner numbers. Signs and branches are those of the value.
        impl<T: Scalar + DualNum $(, const $n: usize)?> Scalar for $dual {
            #[inline]
            fn from_f64(x: f64) -> Self {
                Self::from_re(<T as Scalar>::from_f64(x))
            }

            #[inline]
            fn rounded_once(mut self, single: f32) -> Self {
                self.re = self.re.rounded_once(single);
                self
            }

            #[inline]
            fn epsilon() -> Self {
                Self::from_re(<T as Scalar>::epsilon())
            }

            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                let [value] = Self::sin_cos_array([self]);
                value
            }

            /// With x = a + e, where e has no value: sin x = sin a cos e + cos a sin e.
            #[inline]
            fn sin_cos_array<const K: usize>(angles: [Self; K]) -> [(Self, Self); K] {
                let values = <T as Scalar>::sin_cos_array(angles.map(|x| x.re));
                core::array::from_fn(|i| {
                    let (s, c) = values[i];
                    let (sine, cosine) = DualNum::sin_cos(&(angles[i] - Self::from_re(angles[i].re)));
                    (
                        cosine.scale(&s) + sine.scale(&c),
                        cosine.scale(&c) - sine.scale(&s),
                    )
                })
            }

            #[inline]
            fn sqrt(self) -> Self {
                DualNum::sqrt(&self)
            }

            /// With x = a + e, where e has no value: exp x = exp a exp e.
            #[inline]
            fn exp(self) -> Self {
                let value = <T as Scalar>::exp(self.re);
                DualNum::exp(&(self - Self::from_re(self.re))).scale(&value)
            }

            #[inline]
            fn mul_add(self, a: Self, b: Self) -> Self {
                self * a + b
            }

            #[inline]
            fn sign(self) -> Self {
                Self::from_re(Scalar::sign(self.re))
            }

            #[inline]
            fn is_positive(self) -> bool {
                Scalar::is_positive(self.re)
            }

            #[inline]
            fn ratio_to_f64(self, of: Self) -> f64 {
                self.re.ratio_to_f64(of.re)
            }
        }
    )*};
}

impl_scalar! {
    Dual<T>;
    DualSVec<T, N>, N;
    Dual2<T>;
    HyperDual<T>;
}
