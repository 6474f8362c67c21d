//! Euler's method and two schemes beside it.

use dynamics_runtime::{JointVector as _, Size};

use super::{Equations, Failure, OneStep, Phase, Start};

/// Schemes of first order with one acceleration a step, `qd+ = qd + qdd h`. They differ in the positions.
pub(crate) enum Euler {
    /// Euler's method (L. Euler, *Institutiones calculi integralis* I (1768), section 650): `q+ = q + qd h`.
    ///
    /// A swing without friction gains energy at every step, however short: its amplitude grows by
    /// `sqrt(1 + (w h)^2)` at an angular frequency of w.
    Explicit,
    /// The scheme of Craig, *Introduction to Robotics*, (6.117): `q+ = q + qd h + qdd h^2 / 2` with the old velocity. The
    /// error of qd, and through it the error of q, is proportional to h.
    Craig,
    /// The semi-implicit scheme: `q+ = q + qd+ h`.
    ///
    /// If the forces depend on positions alone and the mass matrix is constant, it is symplectic, and its energy error
    /// stays bounded (E. Hairer, C. Lubich, G. Wanner, *Geometric Numerical Integration*, I.1.2).
    SemiImplicit,
}

impl<S: Equations<D>, D: Size> OneStep<S, S::Refusal, D> for Euler {
    #[inline]
    fn step(&mut self, system: &S, from: &Start<D>) -> Result<Phase<D>, Failure<S::Refusal>> {
        let Start { t, ref phase, h } = *from;
        let qdd = system.acceleration(t, phase)?;
        let qd = phase.qd.plus(h, &qdd);
        // The rates of positions are linear in the velocities.
        let rates = |qd: D::Vector| {
            let q = phase.q.clone();
            system.position_rates(&Phase { q, qd })
        };
        let before = || phase.q.plus(h, &rates(phase.qd.clone()));
        let q = match self {
            Euler::Explicit => before(),
            Euler::Craig => before().plus(0.5 * h * h, &rates(qdd)),
            Euler::SemiImplicit => phase.q.plus(h, &rates(qd.clone())),
        };
        Ok(Phase { q, qd })
    }

    fn recentred(&self, system: &S, phase: &Phase<D>) -> Option<D::Vector> {
        system.recentred(phase)
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Const;

    use super::Euler;
    use crate::integrate::test_problems::{convergence_orders, vector};
    use crate::integrate::{OneStep, Phase, Start};

    #[test]
    fn positions_take_the_velocity_of_their_scheme() {
        let phase = Phase {
            q: vector(1.0),
            qd: vector(2.0),
        };
        let start = Start {
            t: 0.0,
            phase,
            h: 0.5,
        };
        let push = |_: f64, _: &Phase<Const<1>>| Ok::<_, ()>(vector(8.0));
        for (mut scheme, way) in [
            (Euler::Explicit, 1.0),
            (Euler::Craig, 1.0 + 1.0),
            (Euler::SemiImplicit, 3.0),
        ] {
            let next = scheme.step(&push, &start).unwrap();
            assert_eq!((next.q[0], next.qd[0]), (1.0 + way, 6.0));
        }
    }

    #[test]
    fn all_are_of_first_order() {
        for scheme in [Euler::Explicit, Euler::Craig, Euler::SemiImplicit] {
            for order in convergence_orders(scheme, &[400, 800, 1600]) {
                assert!((order - 1.0).abs() < 0.1, "order {order}");
            }
        }
    }
}
