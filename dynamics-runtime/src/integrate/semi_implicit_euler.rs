//! The semi-implicit (symplectic) Euler scheme.

use super::{Equations, Failure, OneStep, Phase};

/// The semi-implicit Euler scheme:
///
/// `qd+ = qd + qdd h`, `q+ = q + qd+ h`
///
/// First order. Where the forces depend on positions alone and the mass matrix is constant it is
/// symplectic, and its energy error stays bounded (E. Hairer, C. Lubich, G. Wanner, *Geometric
/// Numerical Integration*, I.1.2).
pub(crate) struct SemiImplicitEuler;

impl<S: Equations<N>, const N: usize> OneStep<S, S::Refusal, N> for SemiImplicitEuler {
    #[inline]
    fn step(
        &mut self,
        system: &S,
        t: f64,
        phase: &Phase<N>,
        h: f64,
    ) -> Result<Phase<N>, Failure<S::Refusal>> {
        let qd = phase.qd + system.acceleration(t, phase)? * h;
        Ok(Phase {
            q: phase.q + qd * h,
            qd,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::SemiImplicitEuler;
    use crate::integrate::test_problems::{convergence_orders, vector};
    use crate::integrate::{OneStep, Phase};

    #[test]
    fn position_takes_the_new_velocity() {
        let start = Phase {
            q: vector(1.0),
            qd: vector(2.0),
        };
        let push = |_: f64, _: &Phase<1>| Ok::<_, ()>(vector(8.0));
        let next = SemiImplicitEuler.step(&push, 0.0, &start, 0.5).unwrap();
        assert_eq!((next.q[0], next.qd[0]), (1.0 + 3.0, 6.0));
    }

    #[test]
    fn is_of_first_order() {
        for order in convergence_orders(SemiImplicitEuler, &[400, 800, 1600]) {
            assert!((order - 1.0).abs() < 0.1, "order {order}");
        }
    }
}
