//! Numbers that carry a derivative.

use crate::Scalar;
use crate::operators::{impl_operators, scalar_methods};

/// A dual number, `value + slope e` with e^2 = 0: a function of `q + e v` has the derivative along v
/// as its slope (W. K. Clifford 1873).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual {
    /// The number.
    pub value: f64,
    /// Its derivative.
    pub slope: f64,
}

impl Dual {
    /// A number with its derivative.
    pub fn new(value: f64, slope: f64) -> Self {
        Dual { value, slope }
    }
}

impl_operators! {
    impl [] for Dual;
    Add add |a, b| Dual::new(a.value + b.value, a.slope + b.slope);
    Sub sub |a, b| Dual::new(a.value - b.value, a.slope - b.slope);
    Mul mul |a, b| Dual::new(a.value * b.value, a.value * b.slope + a.slope * b.value);
    Div div |a, b| {
        let value = a.value / b.value;
        Dual::new(value, (a.slope - value * b.slope) / b.value)
    };
    Neg neg |a| Dual::new(-a.value, -a.slope);
}

#[diagnostic::do_not_recommend]
impl Scalar for Dual {
    scalar_methods! {
        from_f64(x) => Dual::new(x, 0.0);
        epsilon() => Dual::new(f64::EPSILON, 0.0);
        sqrt(x) => {
            let root = x.value.sqrt();
            Dual::new(root, 0.5 * x.slope / root)
        };
        exp(x) => {
            let value = Scalar::exp(x.value);
            Dual::new(value, value * x.slope)
        };
        mul_add(x, a, b) => {
            let fused = <f64 as Scalar>::mul_add;
            let slope = fused(x.slope, a.value, b.slope);
            Dual::new(fused(x.value, a.value, b.value), fused(x.value, a.slope, slope))
        };
        // Constant except for its jump.
        sign(x) => Dual::new(Scalar::sign(x.value), 0.0);
        is_positive(x) => Scalar::is_positive(x.value);
        ratio_to_f64(x, of) => x.value / of.value;
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let [pair] = Self::sin_cos_array([self]);
        pair
    }

    #[inline]
    fn sin_cos_array<const K: usize>(angles: [Self; K]) -> [(Self, Self); K] {
        let values = f64::sin_cos_array(angles.map(|angle| angle.value));
        core::array::from_fn(|i| {
            let ((sin, cos), slope) = (values[i], angles[i].slope);
            (Dual::new(sin, slope * cos), Dual::new(cos, -slope * sin))
        })
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::Dual;
    use crate::Scalar;

    /// Every operation in one expression, and its derivative by hand.
    #[test]
    fn slopes_are_derivatives() {
        let f = |x: Dual| {
            let (sin, cos) = x.sin_cos();
            Scalar::mul_add(sin, x.sqrt(), -cos / (x * x + x) - x)
        };
        let x = 1.3_f64;
        let (sin, cos) = x.sin_cos();
        let square = x * x + x;
        let slope = cos * x.sqrt()
            + 0.5 * sin / x.sqrt()
            + (sin * square + cos * (2.0 * x + 1.0)) / square.powi(2)
            - 1.0;
        let y = f(Dual::new(x, 1.0));
        assert_relative_eq!(
            y.value,
            sin * x.sqrt() - cos / square - x,
            max_relative = 1e-15
        );
        assert_relative_eq!(y.slope, slope, max_relative = 1e-14);
        assert_eq!(f(Dual::from_f64(x)).slope, 0.0);
    }
}
