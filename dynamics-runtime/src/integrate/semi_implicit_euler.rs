//! The semi-implicit (symplectic) Euler scheme.

use nalgebra::SVector;

use super::Phase;

/// One step of the semi-implicit Euler scheme:
///
/// `qd+ = qd + qdd h`, `q+ = q + qd+ h`
///
/// First order. Where the forces depend on positions alone and the mass matrix is constant it is
/// symplectic, and its energy error stays bounded (E. Hairer, C. Lubich, G. Wanner, *Geometric
/// Numerical Integration*, I.1.2).
pub(crate) fn semi_implicit_euler<E, const N: usize>(
    acceleration: &impl Fn(f64, &Phase<N>) -> Result<SVector<f64, N>, E>,
    t: f64,
    phase: &Phase<N>,
    h: f64,
) -> Result<Phase<N>, E> {
    let qd = phase.qd + acceleration(t, phase)? * h;
    Ok(Phase {
        q: phase.q + qd * h,
        qd,
    })
}

#[cfg(test)]
mod tests {
    use super::semi_implicit_euler;
    use crate::integrate::Phase;
    use crate::integrate::test_problems::{convergence_orders, vector};

    #[test]
    fn position_takes_the_new_velocity() {
        let start = Phase {
            q: vector(1.0),
            qd: vector(2.0),
        };
        let next = semi_implicit_euler::<(), 1>(&|_, _| Ok(vector(8.0)), 0.0, &start, 0.5).unwrap();
        assert_eq!((next.q[0], next.qd[0]), (1.0 + 3.0, 6.0));
    }

    #[test]
    fn is_of_first_order() {
        for order in convergence_orders(semi_implicit_euler, &[400, 800, 1600]) {
            assert!((order - 1.0).abs() < 0.1, "order {order}");
        }
    }
}
