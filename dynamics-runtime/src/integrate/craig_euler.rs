//! Euler's scheme as Craig has it.

use nalgebra::SVector;

use super::Phase;

/// One step of the scheme of Craig, *Introduction to Robotics*, (6.117):
///
/// `qd+ = qd + qdd h`, `q+ = q + qd h + qdd h^2 / 2`
///
/// with the old velocity in the second equation. First order: the error of qd, and through it the
/// error of q, is proportional to h.
pub(crate) fn craig_euler<E, const N: usize>(
    acceleration: &impl Fn(f64, &Phase<N>) -> Result<SVector<f64, N>, E>,
    t: f64,
    phase: &Phase<N>,
    h: f64,
) -> Result<Phase<N>, E> {
    let qdd = acceleration(t, phase)?;
    Ok(Phase {
        q: phase.q + phase.qd * h + qdd * (0.5 * h * h),
        qd: phase.qd + qdd * h,
    })
}

#[cfg(test)]
mod tests {
    use super::craig_euler;
    use crate::integrate::Phase;
    use crate::integrate::test_problems::{convergence_orders, vector};

    #[test]
    fn position_takes_the_old_velocity() {
        let start = Phase {
            q: vector(1.0),
            qd: vector(2.0),
        };
        let next = craig_euler::<(), 1>(&|_, _| Ok(vector(8.0)), 0.0, &start, 0.5).unwrap();
        assert_eq!((next.q[0], next.qd[0]), (1.0 + 1.0 + 1.0, 6.0));
    }

    #[test]
    fn is_of_first_order() {
        for order in convergence_orders(craig_euler, &[400, 800, 1600]) {
            assert!((order - 1.0).abs() < 0.1, "order {order}");
        }
    }
}
