//! The dual numbers of the crate `num-dual` as scalars: exact derivatives of any generated function.

use num_dual::{Dual, Dual2, DualNum, DualSVec, HyperDual};

use crate::Scalar;
use crate::operators::scalar_methods;

macro_rules! impl_scalar {
    ($($dual:ty $(, $n:ident)?;)*) => {$(
        /// Values and derivatives are those of the function that is evaluated, to some roundings of
        /// the inner numbers. Signs and branches are those of the value.
        impl<T: Scalar + DualNum $(, const $n: usize)?> Scalar for $dual {
            scalar_methods! {
                from_f64(x) => Self::from_re(<T as Scalar>::from_f64(x));
                epsilon() => Self::from_re(<T as Scalar>::epsilon());
                sqrt(x) => DualNum::sqrt(&x);
                // With x = a + e, where e has no value: exp x = exp a exp e.
                exp(x) => {
                    let value = <T as Scalar>::exp(x.re);
                    DualNum::exp(&(x - Self::from_re(x.re))).scale(&value)
                };
                mul_add(x, a, b) => x * a + b;
                sign(x) => Self::from_re(Scalar::sign(x.re));
                is_positive(x) => Scalar::is_positive(x.re);
                ratio_to_f64(x, of) => x.re.ratio_to_f64(of.re);
            }

            #[inline]
            fn rounded_once(mut self, single: f32) -> Self {
                self.re = self.re.rounded_once(single);
                self
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
        }
    )*};
}

impl_scalar! {
    Dual<T>;
    DualSVec<T, N>, N;
    Dual2<T>;
    HyperDual<T>;
}
