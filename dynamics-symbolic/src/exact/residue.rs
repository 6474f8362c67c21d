//! The field of integers modulo a prime that is little below a power of two, itself below 2^63.
//!
//! Two different rational functions of total degree d agree at a random point
//! of this field with probability below d/p (Schwartz 1980, Zippel 1979).

use super::{Rational, SplitMix64};
use crate::operators::impl_operators;
use dashu_int::Sign;

/// A number modulo the prime `P`, always reduced.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Residue<const P: u64>(u64);

impl<const P: u64> Residue<P> {
    /// P = 2^BITS - DISTANCE.
    const BITS: u32 = u64::BITS - P.leading_zeros();
    const DISTANCE: u64 = {
        let distance = (1 << Self::BITS) - P;
        assert!(Self::BITS > 32 && Self::BITS < 64 && distance < 1 << 16);
        distance
    };

    /// Zero.
    pub const ZERO: Self = Residue(0);
    /// One.
    pub const ONE: Self = Residue(1);

    /// The residue of an integer.
    pub const fn new(n: u64) -> Self {
        Residue(n % P)
    }

    /// A smaller number with the same residue: 2^BITS is DISTANCE. The rest of a product after two of
    /// these is below 2^BITS + DISTANCE^2, less than twice P.
    #[inline]
    fn folded(n: u128) -> u128 {
        let low = n & ((1 << Self::BITS) - 1);
        low + (n >> Self::BITS) * u128::from(Self::DISTANCE)
    }

    /// The representative in 0..P.
    pub fn get(self) -> u64 {
        self.0
    }

    /// Whether this is zero.
    pub fn is_zero(self) -> bool {
        self.0 == 0
    }

    /// A random element.
    pub fn random(random: &mut SplitMix64) -> Self {
        Residue::new(random.next_u64())
    }

    /// The residue of a rational number, or `None` where P divides its
    /// denominator, or its numerator without the number being zero: such a
    /// number has no faithful image.
    pub fn from_rational(x: &Rational) -> Option<Self> {
        let (sign, magnitude) = x.numerator().clone().into_parts();
        let numerator = match sign {
            Sign::Positive => Residue(magnitude % P),
            Sign::Negative => -Residue(magnitude % P),
        };
        let image = numerator * Residue(x.denominator() % P).inverse()?;
        (image.is_zero() == x.is_zero()).then_some(image)
    }

    /// The number with that square, if there is one: of two the one that is a square itself. P + 1 must be a multiple of 4.
    pub fn square_root(self) -> Option<Self> {
        const { assert!(P % 4 == 3) };
        let mut exponent = P.div_ceil(4);
        let (mut root, mut power) = (Self::ONE, self);
        while exponent > 0 {
            if exponent & 1 == 1 {
                root = root * power;
            }
            power = power * power;
            exponent >>= 1;
        }
        (root * root == self).then_some(root)
    }

    /// The multiplicative inverse; zero has none.
    pub fn inverse(self) -> Option<Self> {
        if self.is_zero() {
            return None;
        }
        // Extended Euclid: t*self = r (mod P) in every step, with |t| <= P < 2^63.
        let (mut r0, mut r1) = (P as i64, self.0 as i64);
        let (mut t0, mut t1) = (0_i64, 1_i64);
        while r1 != 0 {
            let quotient = r0 / r1;
            (r0, r1) = (r1, r0 - quotient * r1);
            (t0, t1) = (t1, t0 - quotient * t1);
        }
        Some(Residue(t0.rem_euclid(P as i64) as u64))
    }
}

impl_operators! {
    impl [const P: u64] for Residue<P>;
    Add add |a, b| {
        let sum = a.0 + b.0;
        Residue(if sum >= P { sum - P } else { sum })
    };
    Sub sub |a, b| a + -b;
    Neg neg |a| Residue(if a.0 == 0 { 0 } else { P - a.0 });
    Mul mul |a, b| {
        let folded = Self::folded(a.0 as u128 * b.0 as u128);
        // For P = 2^BITS - 1 once is enough: both parts are below P.
        let folded = match Self::DISTANCE {
            1 => folded as u64,
            _ => Self::folded(folded) as u64,
        };
        Residue(if folded >= P { folded - P } else { folded })
    };
}

/// A random point (sine, cosine) of the unit circle over the field:
/// s = 2t/(1+t^2), c = (1-t^2)/(1+t^2).
pub fn circle_point<const P: u64>(random: &mut SplitMix64) -> (Residue<P>, Residue<P>) {
    loop {
        let t = Residue::<P>::random(random);
        if let Some(scale) = (Residue::ONE + t * t).inverse() {
            return ((t + t) * scale, (Residue::ONE - t * t) * scale);
        }
    }
}

/// The random rotation of a unit quaternion, by rows.
pub fn rotation_point<const P: u64>(random: &mut SplitMix64) -> [[Residue<P>; 3]; 3] {
    loop {
        let [w, x, y, z] = [(); 4].map(|()| Residue::<P>::random(random));
        let Some(scale) = (w * w + x * x + y * y + z * z).inverse() else {
            continue;
        };
        // 1 - s (a a + b b) on the diagonal, s (a b +- c d) beside it.
        let twice = scale + scale;
        let diagonal = |a, b| Residue::ONE - twice * (a * a + b * b);
        let beside = |a, b, c, d| twice * (a * b + c * d);
        return [
            [diagonal(y, z), beside(x, y, -w, z), beside(x, z, w, y)],
            [beside(x, y, w, z), diagonal(x, z), beside(y, z, -w, x)],
            [beside(x, z, -w, y), beside(y, z, w, x), diagonal(x, y)],
        ];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MERSENNE_61: u64 = (1 << 61) - 1;

    type Mersenne = Residue<MERSENNE_61>;
    type Other = Residue<{ (1 << 62) - 57 }>;

    fn check_field<const P: u64>() {
        for (a, b) in [(1, 1), (1, 2), (2, P / 2), (P - 1, 1)] {
            let product = Residue::<P>(P - a) * Residue(P - b);
            assert_eq!(product, Residue(a) * Residue(b));
            assert_eq!(
                product.get(),
                (u128::from(a) * u128::from(b) % u128::from(P)) as u64
            );
        }
        let mut random = SplitMix64::new(1);
        for _ in 0..200 {
            let (a, b) = (
                Residue::<P>::random(&mut random),
                Residue::<P>::random(&mut random),
            );
            assert_eq!(a * a.inverse().unwrap(), Residue::ONE);
            assert_eq!((a + b) * (a - b), a * a - b * b);
            let expected = (a.get() as u128 * b.get() as u128 % P as u128) as u64;
            assert_eq!((a * b).get(), expected);
            let (s, c) = circle_point::<P>(&mut random);
            assert_eq!(s * s + c * c, Residue::ONE);
            let r = rotation_point::<P>(&mut random);
            for (i, j) in (0..9).map(|k| (k / 3, k % 3)) {
                let dot = (0..3).fold(Residue::ZERO, |sum, k| sum + r[i][k] * r[j][k]);
                assert_eq!(dot, Residue(u64::from(i == j)));
            }
            // The third row is the cross product of the others: no reflection.
            let cross = r[0][0] * r[1][1] - r[0][1] * r[1][0];
            assert_eq!(cross, r[2][2]);
        }
    }

    #[test]
    fn field_laws() {
        check_field::<MERSENNE_61>();
        check_field::<{ (1 << 62) - 57 }>();
        check_field::<{ (1 << 61) - 31 }>();
    }

    #[test]
    fn rationals_map_to_quotients() {
        let x = Rational::from_parts((-22).into(), 7_u32.into());
        let image = Mersenne::from_rational(&x).unwrap();
        assert_eq!(image * Mersenne::new(7), -Mersenne::new(22));
        let image = Other::from_rational(&x).unwrap();
        assert_eq!(image * Other::new(7), -Other::new(22));
    }

    #[test]
    fn a_number_without_faithful_image_is_refused() {
        let p = Rational::from(MERSENNE_61);
        assert_eq!(Mersenne::from_rational(&p), None);
        assert_eq!(Mersenne::from_rational(&(Rational::ONE / p)), None);
        assert_eq!(
            Mersenne::from_rational(&Rational::ZERO),
            Some(Mersenne::ZERO)
        );
    }

    /// Either a number or its opposite has a root, and it is one of the two whose square it is.
    #[test]
    fn square_roots() {
        let mut random = SplitMix64::new(2);
        for _ in 0..100 {
            let a = Other::random(&mut random);
            let root = (a * a).square_root();
            assert!(root == Some(a) || root == Some(-a));
            assert!(a.square_root().is_some() != (-a).square_root().is_some());
        }
    }
}
