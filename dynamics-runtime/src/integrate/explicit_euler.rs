//! Euler's explicit method.

use super::{Equations, Failure, OneStep, Phase};

/// Euler's method (L. Euler, *Institutiones calculi integralis* I (1768), section 650):
///
/// `qd+ = qd + qdd h`, `q+ = q + qd h`
///
/// First order. A swing without friction gains energy at every step, however short: its amplitude
/// grows by `sqrt(1 + (w h)^2)` at an angular frequency of w.
pub(crate) struct ExplicitEuler;

impl<S: Equations<N>, const N: usize> OneStep<S, S::Refusal, N> for ExplicitEuler {
    #[inline]
    fn step(
        &mut self,
        system: &S,
        t: f64,
        phase: &Phase<N>,
        h: f64,
    ) -> Result<Phase<N>, Failure<S::Refusal>> {
        Ok(phase.plus(h, &system.rate(t, phase)?))
    }
}

#[cfg(test)]
mod tests {
    use super::ExplicitEuler;
    use crate::integrate::test_problems::{convergence_orders, vector};
    use crate::integrate::{OneStep, Phase};

    #[test]
    fn both_take_the_old_rate() {
        let start = Phase {
            q: vector(1.0),
            qd: vector(2.0),
        };
        let push = |_: f64, _: &Phase<1>| Ok::<_, ()>(vector(8.0));
        let next = ExplicitEuler.step(&push, 0.0, &start, 0.5).unwrap();
        assert_eq!((next.q[0], next.qd[0]), (1.0 + 1.0, 6.0));
    }

    #[test]
    fn is_of_first_order() {
        for order in convergence_orders(ExplicitEuler, &[400, 800, 1600]) {
            assert!((order - 1.0).abs() < 0.1, "order {order}");
        }
    }
}
