//! The classical Runge-Kutta method.

use dynamics_runtime::Size;

use super::{Equations, Failure, OneStep, Phase, Start};

/// The classical Runge-Kutta method of fourth order (W. Kutta, *Beitrag zur näherungsweisen
/// Integration totaler Differentialgleichungen*, Z. Math. Phys. 46 (1901)).
pub(crate) struct Rk4;

impl<S: Equations<D>, D: Size> OneStep<S, S::Refusal, D> for Rk4 {
    #[inline]
    fn step(&mut self, system: &S, from: &Start<D>) -> Result<Phase<D>, Failure<S::Refusal>> {
        let Start { t, ref phase, h } = *from;
        let k1 = system.rate(t, phase)?;
        let k2 = system.rate(t + 0.5 * h, &phase.plus(0.5 * h, &k1))?;
        let k3 = system.rate(t + 0.5 * h, &phase.plus(0.5 * h, &k2))?;
        let k4 = system.rate(t + h, &phase.plus(h, &k3))?;
        let outer = k1.plus(1.0, &k4);
        let inner = k2.plus(1.0, &k3);
        Ok(phase.plus(h / 6.0, &outer.plus(2.0, &inner)))
    }

    fn recentred(&self, system: &S, phase: &Phase<D>) -> Option<D::Vector> {
        system.recentred(phase)
    }
}

#[cfg(test)]
mod tests {
    use super::Rk4;
    use crate::integrate::test_problems::convergence_orders;

    #[test]
    fn is_of_fourth_order() {
        for order in convergence_orders(Rk4, &[50, 100, 200]) {
            assert!((order - 4.0).abs() < 0.15, "order {order}");
        }
    }
}
