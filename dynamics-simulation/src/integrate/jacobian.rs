//! The derivatives of an acceleration.

use dynamics_runtime::Size;
use nalgebra::{Complex, ComplexField};

use super::lu::Lu;
use super::{Equations, Phase};

/// dq''/dq and dq''/dq'.
#[derive(Clone)]
pub(super) struct Jacobian<D: Size> {
    by_q: D::Matrix,
    by_qd: D::Matrix,
}

impl<D: Size> Jacobian<D> {
    pub(super) fn zeros(size: D) -> Self {
        Jacobian {
            by_q: size.matrix(),
            by_qd: size.matrix(),
        }
    }

    /// By differences over the square root of the rounding, in 2 N evaluations: enough for a simplified Newton
    /// iteration under any torque law.
    pub(super) fn at<S: Equations<D>>(
        system: &S,
        t: f64,
        phase: &Phase<D>,
        acceleration: &D::Vector,
    ) -> Result<Self, S::Refusal> {
        let size = phase.size();
        let differences = |part: fn(&mut Phase<D>) -> &mut D::Vector| {
            let mut matrix = size.matrix();
            for j in size.joints() {
                let mut moved = phase.clone();
                let entry = &mut part(&mut moved)[j];
                // As in the program RADAU5 of Hairer and Wanner.
                let distance = (f64::EPSILON * entry.abs().max(1e-5)).sqrt();
                *entry += distance;
                let change = system.acceleration(t, &moved)? - acceleration.clone();
                for i in size.joints() {
                    matrix[(i, j)] = change[i] / distance;
                }
            }
            Ok(matrix)
        };
        Ok(Jacobian {
            by_q: differences(|phase| &mut phase.q)?,
            by_qd: differences(|phase| &mut phase.qd)?,
        })
    }
}

/// The equations `(mu - J) (x, v) = (r, s)` with `J = (0, 1; A, B)`, A and B the derivatives by q and
/// q': `x = (r + v) / mu` leaves `(mu - B - A / mu) v = s + A r / mu`, half as many.
#[derive(Clone)]
pub(super) struct Shifted<T: ComplexField<RealField = f64> + Copy, D: Size> {
    mu: T,
    by_q: D::Matrix,
    factors: Lu<T, D>,
}

impl<T, D: Size> Shifted<T, D>
where
    T: ComplexField<RealField = f64> + Copy,
{
    pub(super) fn new(size: D, mu: T, jacobian: &Jacobian<D>) -> Self {
        let Jacobian { by_q, by_qd } = jacobian;
        let entry = |i, j| {
            let unit = if i == j { mu } else { T::zero() };
            unit - T::from_real(by_qd[(i, j)]) - T::from_real(by_q[(i, j)]) / mu
        };
        Shifted {
            mu,
            by_q: by_q.clone(),
            factors: Lu::new(size, entry),
        }
    }

    /// The solution for right sides of which some phases are the real and the imaginary parts.
    #[inline(always)]
    fn solve_parts(
        &self,
        size: D,
        right: impl Fn(fn(&Phase<D>) -> &D::Vector, usize) -> T,
    ) -> [D::Each<T>; 2] {
        let r = size.each(|i| right(|phase| &phase.q, i));
        let pulled = size.each(|i| {
            let terms = size
                .joints()
                .map(|j| T::from_real(self.by_q[(i, j)]) * r[j]);
            right(|phase| &phase.qd, i) + terms.fold(T::zero(), |sum, term| sum + term) / self.mu
        });
        let v = self.factors.solve(pulled);
        [size.each(|i| (r[i] + v[i]) / self.mu), v]
    }
}

impl<D: Size> Shifted<f64, D> {
    pub(super) fn solve(&self, right: &Phase<D>) -> Phase<D> {
        let size = right.size();
        let [q, qd] = self.solve_parts(size, |part, i| part(right)[i]);
        Phase {
            q: size.vector_of(|i| q[i]),
            qd: size.vector_of(|i| qd[i]),
        }
    }
}

impl<D: Size> Shifted<Complex<f64>, D> {
    /// With real and imaginary parts apart.
    pub(super) fn solve(&self, real: &Phase<D>, imaginary: &Phase<D>) -> (Phase<D>, Phase<D>) {
        let size = real.size();
        let joined = |part: fn(&Phase<D>) -> &D::Vector, i: usize| {
            Complex::new(part(real)[i], part(imaginary)[i])
        };
        let [q, qd] = self.solve_parts(size, joined);
        let phase = |part: fn(&Complex<f64>) -> f64| Phase {
            q: size.vector_of(|i| part(&q[i])),
            qd: size.vector_of(|i| part(&qd[i])),
        };
        (phase(|z| z.re), phase(|z| z.im))
    }
}

#[cfg(test)]
mod tests {
    use core::convert::Infallible;

    use nalgebra::{Complex, Const, Matrix2, Vector2};

    use super::{Jacobian, Shifted};
    use crate::integrate::Phase;

    const A: Matrix2<f64> = Matrix2::new(-3.0, 0.5, 1.0, -2.0);
    const B: Matrix2<f64> = Matrix2::new(-0.1, 2.0, -2.0, -0.3);

    #[test]
    fn differences_are_derivatives() {
        let law = |t: f64, p: &Phase<Const<2>>| {
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
        let times = |p: &Phase<Const<2>>| Phase {
            q: p.qd,
            qd: A * p.q + B * p.qd,
        };
        let x = Phase {
            q: Vector2::new(1.0, -2.0),
            qd: Vector2::new(0.5, 3.0),
        };
        let right = x.scaled(7.0).minus(&times(&x));
        let found = Shifted::new(Const::<2>, 7.0, &jacobian).solve(&right);
        assert!(found.minus(&x).entries().all(|e| e.abs() < 1e-14));

        let y = Phase { q: x.qd, qd: x.q };
        let (re, im) = (2.0, 5.0);
        let real = x.scaled(re).plus(-im, &y).minus(&times(&x));
        let imaginary = y.scaled(re).plus(im, &x).minus(&times(&y));
        let shifted = Shifted::new(Const::<2>, Complex::new(re, im), &jacobian);
        let (found_x, found_y) = shifted.solve(&real, &imaginary);
        assert!(found_x.minus(&x).entries().all(|e| e.abs() < 1e-14));
        assert!(found_y.minus(&y).entries().all(|e| e.abs() < 1e-14));
    }
}
