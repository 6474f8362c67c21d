//! Euler's scheme as Craig has it.

use super::{Equations, Failure, OneStep, Phase};

/// The scheme of Craig, *Introduction to Robotics*, (6.117):
///
/// `qd+ = qd + qdd h`, `q+ = q + qd h + qdd h^2 / 2`
///
/// with the old velocity in the second equation. First order: the error of qd, and through it the
/// error of q, is proportional to h.
pub(crate) struct CraigEuler;

impl<S: Equations<N>, const N: usize> OneStep<S, S::Refusal, N> for CraigEuler {
    #[inline]
    fn step(
        &mut self,
        system: &S,
        t: f64,
        phase: &Phase<N>,
        h: f64,
    ) -> Result<Phase<N>, Failure<S::Refusal>> {
        let qdd = system.acceleration(t, phase)?;
        Ok(Phase {
            q: phase.q + phase.qd * h + qdd * (0.5 * h * h),
            qd: phase.qd + qdd * h,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::CraigEuler;
    use crate::integrate::test_problems::{convergence_orders, vector};
    use crate::integrate::{OneStep, Phase};

    #[test]
    fn position_takes_the_old_velocity() {
        let start = Phase {
            q: vector(1.0),
            qd: vector(2.0),
        };
        let push = |_: f64, _: &Phase<1>| Ok::<_, ()>(vector(8.0));
        let next = CraigEuler.step(&push, 0.0, &start, 0.5).unwrap();
        assert_eq!((next.q[0], next.qd[0]), (1.0 + 1.0 + 1.0, 6.0));
    }

    #[test]
    fn is_of_first_order() {
        for order in convergence_orders(CraigEuler, &[400, 800, 1600]) {
            assert!((order - 1.0).abs() < 0.1, "order {order}");
        }
    }
}
