//! Where a polynomial is zero for the first time.

use dynamics_runtime::MAX_TAYLOR_ORDER;

/// Numbers for each order.
const ORDERS: usize = MAX_TAYLOR_ORDER + 1;

/// A polynomial in s from 0 to 1, by its coefficients.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Polynomial(pub(super) [f64; ORDERS]);

impl Polynomial {
    /// `sign (p(s) - x)`
    pub(crate) fn less(mut self, x: f64, sign: f64) -> Self {
        self.0[0] -= x;
        Polynomial(self.0.map(|c| sign * c))
    }

    /// Its greatest coefficient.
    pub(crate) fn size(&self) -> f64 {
        self.0.iter().fold(0.0, |size, c| c.abs().max(size))
    }

    /// Its value, and that of its derivative.
    fn at(&self, s: f64) -> (f64, f64) {
        let (mut value, mut slope) = (0.0, 0.0);
        for c in self.0.iter().rev() {
            slope = slope * s + value;
            value = value * s + c;
        }
        (value, slope)
    }

    /// The least s from 0 to 1 at which the polynomial passes from above `-margin` to below it; `None`
    /// where it does not, or is not a number.
    ///
    /// In the basis of Bernstein a polynomial lies between its least and its greatest coefficient, and has no more zeros
    /// in an interval than its coefficients have changes of sign (G. Farin, *Curves and Surfaces for CAGD*, chapter 6):
    /// intervals are halved, the earlier half first, until these settle it.
    pub(crate) fn first_passage(mut self, margin: f64) -> Option<f64> {
        self.0[0] += margin;
        // A polynomial that begins at the margin and rises has not passed it.
        if self.0[0] <= 0.0 {
            let next = self.0[1..].iter().find(|c| **c != 0.0)?;
            if *next <= 0.0 || next.is_nan() {
                return Some(0.0);
            }
            self.0[0] = f64::MIN_POSITIVE;
        }
        let [constant, rest @ ..] = &self.0;
        let falls: f64 = rest.iter().map(|c| c.min(0.0)).sum();
        // Also where a coefficient is not a number.
        let reaches_zero = constant + falls <= 0.0;
        if !reaches_zero {
            return None;
        }
        self.first_of(&self.bernstein(), 0.0, 1.0)
    }

    /// The coefficients in the basis of Bernstein, `b_j = sum_(k <= j) C(j, k) / C(n, k) c_k`.
    fn bernstein(&self) -> [f64; ORDERS] {
        let n = ORDERS - 1;
        core::array::from_fn(|j| {
            let mut ratio = 1.0;
            let mut sum = 0.0;
            for k in 0..=j {
                sum += ratio * self.0[k];
                ratio *= (j - k) as f64 / (n - k).max(1) as f64;
            }
            sum
        })
    }

    /// The first zero from `a` to `b`, of a polynomial that is positive at `a` and has these coefficients
    /// between the two.
    fn first_of(&self, coefficients: &[f64; ORDERS], a: f64, b: f64) -> Option<f64> {
        let pairs = coefficients.windows(2);
        let changes = pairs.filter(|pair| (pair[0] > 0.0) != (pair[1] > 0.0));
        match changes.count() {
            0 => None,
            1 => Some(self.only_zero(a, b)),
            // A zero of several orders, or several that rounding does not tell apart.
            _ if b - a <= 4.0 * f64::EPSILON * b => Some(b),
            _ => {
                let (left, right) = halves(coefficients);
                let middle = 0.5 * (a + b);
                let in_left = self.first_of(&left, a, middle);
                let is_positive = right[0] > 0.0;
                let in_right = || self.first_of(&right, middle, b);
                in_left.or_else(|| {
                    if is_positive {
                        in_right()
                    } else {
                        Some(middle)
                    }
                })
            }
        }
    }

    /// The zero between `a`, where the polynomial is positive, and `b`, where it is not: Newton's steps,
    /// and halves where they lead out of what is left.
    fn only_zero(&self, mut a: f64, mut b: f64) -> f64 {
        let mut s = 0.5 * (a + b);
        for _ in 0..MOST_STEPS {
            let (value, slope) = self.at(s);
            let end = if value > 0.0 { &mut a } else { &mut b };
            *end = s;
            let newton = s - value / slope;
            let is_within = newton > a && newton < b;
            let next = if is_within { newton } else { 0.5 * (a + b) };
            if next <= a || next >= b || (next - s).abs() <= f64::EPSILON * s {
                return next.clamp(a, b);
            }
            s = next;
        }
        b
    }

    /// A zero nearer than `s`, by one of Newton's steps, where it is one from 0 to 1.
    pub(crate) fn refined(&self, s: f64) -> f64 {
        let (value, slope) = self.at(s);
        let next = s - value / slope;
        let is_nearer = slope < 0.0 && next > 0.0 && next <= 1.0;
        if is_nearer { next } else { s }
    }
}

/// Twice as many halvings as there are digits.
const MOST_STEPS: usize = 106;

/// The coefficients of both halves of an interval (P. de Casteljau).
fn halves(coefficients: &[f64; ORDERS]) -> ([f64; ORDERS], [f64; ORDERS]) {
    let (mut left, mut right) = (*coefficients, *coefficients);
    for step in 1..ORDERS {
        for j in 0..ORDERS - step {
            right[j] = 0.5 * (right[j] + right[j + 1]);
        }
        left[step] = right[0];
    }
    (left, right)
}

#[cfg(test)]
mod tests {
    use super::{ORDERS, Polynomial};

    fn polynomial(coefficients: &[f64]) -> Polynomial {
        let at = |k: usize| coefficients.get(k).copied().unwrap_or(0.0);
        Polynomial(core::array::from_fn(at))
    }

    /// The product of x - zero over all zeros, with the sign that makes it positive before the first.
    fn with_zeros(zeros: &[f64]) -> Polynomial {
        let mut product = polynomial(&[1.0]);
        for zero in zeros {
            let before = product.0;
            for k in 0..ORDERS {
                let shifted = if k == 0 { 0.0 } else { before[k - 1] };
                product.0[k] = zero * before[k] - shifted;
            }
        }
        product
    }

    #[test]
    fn the_first_of_many_zeros_is_found() {
        for zeros in [
            vec![0.25],
            vec![0.3, 0.31, 0.9],
            vec![0.5, 0.500_1, 0.75, 0.8, 0.95],
            vec![0.999, 1.5, 2.0],
            vec![1.0],
        ] {
            let found = with_zeros(&zeros).first_passage(0.0).unwrap();
            assert!((found - zeros[0]).abs() < 1e-10, "{zeros:?}: {found}");
        }
    }

    #[test]
    fn what_does_not_pass_has_no_zero() {
        // It comes as near as 1e-6, and touches.
        for (constant, passes) in [(1e-6, false), (-1e-6, true)] {
            let p = polynomial(&[0.09 + constant, -0.6, 1.0]);
            assert_eq!(p.first_passage(0.0).is_some(), passes, "{constant}");
        }
        assert_eq!(
            with_zeros(&[1.2, -0.4]).less(0.0, -1.0).first_passage(0.0),
            None
        );
        assert_eq!(polynomial(&[1.0, f64::NAN]).first_passage(0.0), None);
        assert_eq!(polynomial(&[0.0]).first_passage(0.0), None);
    }

    /// A polynomial that rises from the margin has passed nothing, and comes back later.
    #[test]
    fn the_start_is_no_zero() {
        let thrown = polynomial(&[0.0, 1.0, -4.0]);
        let found = thrown.first_passage(1e-16).unwrap();
        assert!((found - 0.25).abs() < 1e-15, "{found}");
        assert!((thrown.first_passage(0.0).unwrap() - 0.25).abs() < 1e-15);
        assert_eq!(polynomial(&[0.0, -1.0]).first_passage(0.0), Some(0.0));
        assert_eq!(polynomial(&[0.0, 1.0, -0.5]).first_passage(0.0), None);
    }

    /// cos(20 s), of degree 30, passes zero six times.
    #[test]
    fn a_zero_of_a_long_series_is_as_accurate_as_the_series() {
        let mut coefficients = [0.0; ORDERS];
        let mut term = 1.0;
        for k in 0..ORDERS {
            coefficients[k] = [1.0, 0.0, -1.0, 0.0][k % 4] * term;
            term *= 5.0 / (k + 1) as f64;
        }
        let found = Polynomial(coefficients).first_passage(0.0).unwrap();
        assert!(
            (5.0 * found - core::f64::consts::FRAC_PI_2).abs() < 1e-14,
            "{found}"
        );
    }

    #[test]
    fn a_refined_zero_is_that_without_the_margin() {
        let p = polynomial(&[1.0, -2.0]);
        let found = p.first_passage(1e-3).unwrap();
        assert!((found - 0.5005).abs() < 1e-15);
        assert_eq!(p.refined(found), 0.5);
    }
}
