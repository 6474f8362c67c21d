//! The derivatives of an acceleration.

use nalgebra::{Complex, ComplexField, SMatrix, SVector};

use super::lu::Lu;
use super::{Equations, Phase};

/// dq''/dq and dq''/dq'.
#[derive(Clone, Copy)]
pub(super) struct Jacobian<const N: usize> {
    by_q: SMatrix<f64, N, N>,
    by_qd: SMatrix<f64, N, N>,
}

impl<const N: usize> Jacobian<N> {
    pub(super) fn zeros() -> Self {
        Jacobian {
            by_q: SMatrix::zeros(),
            by_qd: SMatrix::zeros(),
        }
    }

    /// By differences over the square root of the rounding, 2 N evaluations: enough for a simplified
    /// Newton iteration, and they see whatever a torque law does.
    pub(super) fn at<S: Equations<N>>(
        system: &S,
        t: f64,
        phase: &Phase<N>,
        acceleration: &SVector<f64, N>,
    ) -> Result<Self, S::Refusal> {
        let mut jacobian = Self::zeros();
        for j in 0..N {
            let mut moved = *phase;
            let distance = distance(phase.q[j]);
            moved.q[j] += distance;
            let change = system.acceleration(t, &moved)? - acceleration;
            jacobian.by_q.set_column(j, &(change / distance));
        }
        for j in 0..N {
            let mut moved = *phase;
            let distance = distance(phase.qd[j]);
            moved.qd[j] += distance;
            let change = system.acceleration(t, &moved)? - acceleration;
            jacobian.by_qd.set_column(j, &(change / distance));
        }
        Ok(jacobian)
    }
}

/// The distance of a difference (Hairer and Wanner's program RADAU5).
fn distance(x: f64) -> f64 {
    (f64::EPSILON * x.abs().max(1e-5)).sqrt()
}

/// The equations `(mu - J) (x, v) = (r, s)` with `J = (0, 1; A, B)`, A and B the derivatives by q and
/// q': `x = (r + v) / mu` leaves `(mu - B - A / mu) v = s + A r / mu`, half as many.
#[derive(Clone, Copy)]
pub(super) struct Shifted<T, const N: usize> {
    mu: T,
    by_q: SMatrix<f64, N, N>,
    factors: Lu<T, N>,
}

impl<T, const N: usize> Shifted<T, N>
where
    T: ComplexField<RealField = f64> + Copy,
{
    pub(super) fn new(mu: T, jacobian: &Jacobian<N>) -> Self {
        let Jacobian { by_q, by_qd } = jacobian;
        let matrix = SMatrix::from_fn(|i, j| {
            let unit = if i == j { mu } else { T::zero() };
            unit - T::from_real(by_qd[(i, j)]) - T::from_real(by_q[(i, j)]) / mu
        });
        Shifted {
            mu,
            by_q: *by_q,
            factors: Lu::new(matrix),
        }
    }

    fn solve_parts(&self, r: SVector<T, N>, s: SVector<T, N>) -> (SVector<T, N>, SVector<T, N>) {
        let pull = self.by_q.map(T::from_real) * r / self.mu;
        let v = self.factors.solve(s + pull);
        ((r + v) / self.mu, v)
    }
}

impl<const N: usize> Shifted<f64, N> {
    pub(super) fn solve(&self, right: &Phase<N>) -> Phase<N> {
        let (q, qd) = self.solve_parts(right.q, right.qd);
        Phase { q, qd }
    }
}

impl<const N: usize> Shifted<Complex<f64>, N> {
    /// With real and imaginary parts apart.
    pub(super) fn solve(&self, real: &Phase<N>, imaginary: &Phase<N>) -> (Phase<N>, Phase<N>) {
        let join = |re: &SVector<f64, N>, im: &SVector<f64, N>| re.zip_map(im, Complex::new);
        let (q, qd) = self.solve_parts(join(&real.q, &imaginary.q), join(&real.qd, &imaginary.qd));
        let (re, im) = (|z: Complex<f64>| z.re, |z: Complex<f64>| z.im);
        let real = Phase {
            q: q.map(re),
            qd: qd.map(re),
        };
        let imaginary = Phase {
            q: q.map(im),
            qd: qd.map(im),
        };
        (real, imaginary)
    }
}

#[cfg(test)]
mod tests {
    use core::convert::Infallible;

    use nalgebra::{Complex, Matrix2, Vector2};

    use super::{Jacobian, Shifted};
    use crate::integrate::Phase;

    const A: Matrix2<f64> = Matrix2::new(-3.0, 0.5, 1.0, -2.0);
    const B: Matrix2<f64> = Matrix2::new(-0.1, 2.0, -2.0, -0.3);

    #[test]
    fn differences_are_derivatives() {
        let law = |t: f64, p: &Phase<2>| {
            Ok::<_, Infallible>(A * p.q.map(f64::sin) + B * p.qd + Vector2::repeat(t))
        };
        let phase = Phase {
            q: Vector2::new(0.3, -40.0),
            qd: Vector2::new(1.0, 0.0),
        };
        let Ok(qdd) = law(2.0, &phase);
        let Ok(jacobian) = Jacobian::at(&law, 2.0, &phase, &qdd);
        let by_q = A * Matrix2::from_diagonal(&phase.q.map(f64::cos));
        // Roundings of numbers near 4 over distances of 1e-10 to 1e-7.
        assert!((jacobian.by_q - by_q).amax() < 3e-5);
        assert!((jacobian.by_qd - B).amax() < 3e-5);
    }

    #[test]
    fn shifted_systems_are_solved() {
        let jacobian = Jacobian { by_q: A, by_qd: B };
        let times = |p: &Phase<2>| Phase {
            q: p.qd,
            qd: A * p.q + B * p.qd,
        };
        let x = Phase {
            q: Vector2::new(1.0, -2.0),
            qd: Vector2::new(0.5, 3.0),
        };
        let right = x.scaled(7.0).minus(&times(&x));
        let found = Shifted::<f64, 2>::new(7.0, &jacobian).solve(&right);
        assert!(found.minus(&x).entries().all(|e| e.abs() < 1e-14));

        let y = Phase { q: x.qd, qd: x.q };
        let (re, im) = (2.0, 5.0);
        let real = x.scaled(re).plus(-im, &y).minus(&times(&x));
        let imaginary = y.scaled(re).plus(im, &x).minus(&times(&y));
        let shifted = Shifted::<Complex<f64>, 2>::new(Complex::new(re, im), &jacobian);
        let (found_x, found_y) = shifted.solve(&real, &imaginary);
        assert!(found_x.minus(&x).entries().all(|e| e.abs() < 1e-14));
        assert!(found_y.minus(&y).entries().all(|e| e.abs() < 1e-14));
    }
}
