//! The classical Runge-Kutta method.

use nalgebra::SVector;

use super::Phase;

/// One step of the classical Runge-Kutta method of fourth order (W. Kutta, *Beitrag zur
/// näherungsweisen Integration totaler Differentialgleichungen*, Z. Math. Phys. 46 (1901)).
pub(crate) fn rk4<E, const N: usize>(
    acceleration: &impl Fn(f64, &Phase<N>) -> Result<SVector<f64, N>, E>,
    t: f64,
    phase: &Phase<N>,
    h: f64,
) -> Result<Phase<N>, E> {
    let rate = |t: f64, phase: &Phase<N>| Ok(phase.rate(acceleration(t, phase)?));
    let k1 = rate(t, phase)?;
    let k2 = rate(t + 0.5 * h, &phase.plus(0.5 * h, &k1))?;
    let k3 = rate(t + 0.5 * h, &phase.plus(0.5 * h, &k2))?;
    let k4 = rate(t + h, &phase.plus(h, &k3))?;
    let outer = k1.plus(1.0, &k4);
    let inner = k2.plus(1.0, &k3);
    Ok(phase.plus(h / 6.0, &outer.plus(2.0, &inner)))
}

#[cfg(test)]
mod tests {
    use super::rk4;
    use crate::integrate::test_problems::convergence_orders;

    #[test]
    fn is_of_fourth_order() {
        for order in convergence_orders(rk4, &[50, 100, 200]) {
            assert!((order - 4.0).abs() < 0.15, "order {order}");
        }
    }
}
