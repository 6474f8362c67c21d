//! Gauss-Legendre collocation in positions and momenta, the implicit midpoint rule among it.
//!
//! E. Hairer, C. Lubich, G. Wanner, *Geometric Numerical Integration*, 2nd edition, section II.1.3:
//! the methods; theorem VI.4.2: they are symplectic; section V.2: they are symmetric. Iteration to
//! rounding and compensated summation as in E. Hairer, R. I. McLachlan, A. Razakarivony,
//! *Achieving Brouwer's law with implicit Runge-Kutta methods*, BIT 48 (2008).
//!
//! In positions and momenta p = M qd, dT/dq = C' qd = M' qd - V needs no C: M along a dual number gives M' qd. So two
//! functions of the default set suffice. Joints that stick leave the arm: the velocities of the others are those of
//! their own momenta, M_ff qd_f = p_f, and theirs are zero at every stage.

use dynamics_runtime::{JointVector as _, Size};

use super::compensated::Compensated;
use super::{Canonical, Failure, OneStep, Phase, Point, Start};

/// Collocation at the zeros of the Legendre polynomial of degree `STAGES`, of order 2 `STAGES`.
pub(crate) struct GaussLegendre<const STAGES: usize, D: Size> {
    tableau: Tableau<STAGES>,
    carried: Option<Carried<STAGES, D>>,
}

/// Coefficients of a collocation method.
struct Tableau<const STAGES: usize> {
    a: [[f64; STAGES]; STAGES],
    b: [f64; STAGES],
    c: [f64; STAGES],
    /// Values at the nodes of the next step of the Lagrange polynomials of the nodes.
    ahead: [[f64; STAGES]; STAGES],
}

/// The start of a step, and a first guess of the stages' rates.
type Begun<const STAGES: usize, D> = (Compensated<D>, [Point<D>; STAGES]);

/// The numbers that a step hands on to the next one, besides the phase that it returned.
struct Carried<const STAGES: usize, D: Size> {
    phase: Phase<D>,
    h: f64,
    at: Compensated<D>,
    rates: [Point<D>; STAGES],
}

impl<D: Size> GaussLegendre<1, D> {
    /// The implicit midpoint rule, of order 2.
    pub(crate) fn order_2() -> Self {
        Self::new([[0.5]], [1.0], [0.5])
    }
}

impl<D: Size> GaussLegendre<2, D> {
    /// The method of order 4.
    pub(crate) fn order_4() -> Self {
        let r = 3.0_f64.sqrt() / 6.0;
        let a = [[0.25, 0.25 - r], [0.25 + r, 0.25]];
        Self::new(a, [0.5, 0.5], [0.5 - r, 0.5 + r])
    }
}

impl<D: Size> GaussLegendre<3, D> {
    /// The method of order 6.
    pub(crate) fn order_6() -> Self {
        let r = 15.0_f64.sqrt();
        let (outer, inner) = (5.0 / 36.0, 2.0 / 9.0);
        let a = [
            [outer, inner - r / 15.0, outer - r / 30.0],
            [outer + r / 24.0, inner, outer - r / 24.0],
            [outer + r / 30.0, inner + r / 15.0, outer],
        ];
        let b = [5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0];
        Self::new(a, b, [0.5 - r / 10.0, 0.5, 0.5 + r / 10.0])
    }
}

/// A relative change of the stages' velocities that is rounding if it does not become smaller.
const ROUNDING: f64 = 1e-10;

/// The way in a step to which changes are relative if it is more than that by the velocities, rad or m.
const SLOW: f64 = 1e-4;

/// An iteration that takes longer does not converge: the step is too long for it.
const MOST_ITERATIONS: usize = 100;

/// An iteration that has not come near by then moves away.
const PATIENCE: usize = 10;

impl<const STAGES: usize, D: Size> GaussLegendre<STAGES, D> {
    fn new(a: [[f64; STAGES]; STAGES], b: [f64; STAGES], c: [f64; STAGES]) -> Self {
        let lagrange = |x: f64, j: usize| {
            let factor = |k: usize| (x - c[k]) / (c[j] - c[k]);
            (0..STAGES).filter(|k| *k != j).map(factor).product()
        };
        let ahead = c.map(|c| core::array::from_fn(|j| lagrange(1.0 + c, j)));
        let tableau = Tableau { a, b, c, ahead };
        GaussLegendre {
            tableau,
            carried: None,
        }
    }

    /// Positions and momenta at the start of a step, and a first guess of the stages' rates: those
    /// of the step before, extrapolated.
    fn begin<S: Canonical<D>>(
        &self,
        system: &S,
        Start { t, phase, h }: &Start<D>,
    ) -> Result<Begun<STAGES, D>, S::Refusal> {
        if let Some(before) = &self.carried
            && (&before.phase, &before.h) == (phase, h)
        {
            let ahead = self.tableau.ahead;
            let guess = ahead.map(|row| combination(&row, &before.rates));
            return Ok((before.at.clone(), guess));
        }
        let p = system.momentum(phase)?;
        let at = Point {
            q: phase.q.clone(),
            p,
        };
        let rate = system.rate(*t, &at)?;
        let guess = core::array::from_fn(|_| rate.clone());
        Ok((Compensated::new(at), guess))
    }

    /// The rates k of the stages, of which each is that at y + h sum_j a_ij k_j, by iteration.
    fn stages<S: Canonical<D>>(
        &self,
        system: &S,
        t: f64,
        from: &Compensated<D>,
        h: f64,
        mut rates: [Point<D>; STAGES],
    ) -> Result<[Point<D>; STAGES], Failure<S::Refusal>> {
        let Tableau { a, c, .. } = &self.tableau;
        let mut before = f64::INFINITY;
        for k in 0..MOST_ITERATIONS {
            let old = rates.clone();
            for i in 0..STAGES {
                let at = from.plus(h, &combination(&a[i], &old));
                rates[i] = system.rate(t + c[i] * h, &at)?;
            }
            let Change { all, velocities } = change(&old, &rates, h);
            if all == 0.0 || (all >= before && velocities < ROUNDING) {
                return Ok(rates);
            }
            if k >= PATIENCE && (velocities >= 0.5 || velocities.is_nan()) {
                break;
            }
            before = all;
        }
        Err(Failure::NoConvergence)
    }
}

impl<S: Canonical<D>, const STAGES: usize, D: Size> OneStep<S, S::Refusal, D>
    for GaussLegendre<STAGES, D>
{
    fn step(&mut self, system: &S, from: &Start<D>) -> Result<Phase<D>, Failure<S::Refusal>> {
        let (mut at, guess) = self.begin(system, from)?;
        let h = from.h;
        let rates = self.stages(system, from.t, &at, h, guess)?;
        at.add(h, &combination(&self.tableau.b, &rates));
        let phase = system.phase(&at.value)?;
        self.carried = Some(Carried {
            phase: phase.clone(),
            h,
            at,
            rates,
        });
        Ok(phase)
    }

    fn restart(&mut self) {
        self.carried = None;
    }
}

/// Change of the rates of the stages by an iteration, relative to them. NaN where a rate is.
struct Change {
    /// The greater of those of positions and of momenta.
    all: f64,
    /// The change of positions, relative to [`SLOW`] a step besides: in an arm at rest, the other is rounding over
    /// rounding.
    velocities: f64,
}

#[inline(always)]
fn change<const STAGES: usize, D: Size>(
    old: &[Point<D>; STAGES],
    new: &[Point<D>; STAGES],
    h: f64,
) -> Change {
    let (mut moved, mut size) = ([0.0; 2], [0.0; 2]);
    for (old, new) in old.iter().zip(new) {
        let difference = new.plus(-1.0, old);
        // Sums, for a maximum drops what is not a number.
        let [q, p] = [&difference.q, &difference.p].map(|vector| sum(vector.entries()));
        moved = [moved[0] + q, moved[1] + p];
        let [q, p] = [&new.q, &new.p].map(|vector| sum(vector.entries()));
        size = [size[0] + q, size[1] + p];
    }
    // Nothing moved of nothing is no change.
    let ratio = |i: usize| moved[i] / if moved[i] == 0.0 { 1.0 } else { size[i] };
    let [of_q, of_p] = [0, 1].map(ratio);
    // NaN where either is.
    let all = if of_q >= of_p {
        of_q
    } else {
        of_p + 0.0 * of_q
    };
    let velocities = moved[0] / (size[0] + SLOW / h);
    Change { all, velocities }
}

#[inline(always)]
fn sum(entries: &[f64]) -> f64 {
    entries.iter().map(|entry| entry.abs()).sum()
}

#[inline(always)]
fn combination<const STAGES: usize, D: Size>(
    weights: &[f64; STAGES],
    rates: &[Point<D>; STAGES],
) -> Point<D> {
    let terms = weights.iter().zip(rates);
    let none = Point::zeros(D::of(&rates[0].q));
    terms.fold(none, |sum, (weight, rate)| sum.plus(*weight, rate))
}

#[cfg(test)]
mod tests {
    use nalgebra::Const;

    use super::GaussLegendre;
    use crate::integrate::canonical::InVelocities;
    use crate::integrate::order_conditions::order;
    use crate::integrate::test_problems::{Acceleration, convergence_orders};
    use crate::integrate::{Equations, Failure, OneStep, Phase, Start};

    fn order_of<const STAGES: usize>(method: GaussLegendre<STAGES, Const<1>>) -> usize {
        let a: Vec<Vec<f64>> = method.tableau.a.iter().map(|row| row.to_vec()).collect();
        for (row, c) in a.iter().zip(method.tableau.c) {
            assert!((row.iter().sum::<f64>() - c).abs() < 1e-15);
        }
        order(&a, &method.tableau.b)
    }

    #[test]
    fn coefficients_satisfy_the_order_conditions() {
        assert_eq!(order_of(GaussLegendre::order_2()), 2);
        assert_eq!(order_of(GaussLegendre::order_4()), 4);
        assert_eq!(order_of(GaussLegendre::order_6()), 6);
    }

    /// `b_i a_ij + b_j a_ji = b_i b_j`, which makes a method symplectic (J. M. Sanz-Serna 1988).
    fn check_symplectic<const STAGES: usize>(method: GaussLegendre<STAGES, Const<1>>) {
        let (a, b) = (&method.tableau.a, &method.tableau.b);
        for i in 0..STAGES {
            for j in 0..STAGES {
                let defect = b[i] * a[i][j] + b[j] * a[j][i] - b[i] * b[j];
                assert!(defect.abs() < 1e-16, "{i} {j} {defect:e}");
            }
        }
    }

    #[test]
    fn coefficients_are_those_of_symplectic_methods() {
        check_symplectic(GaussLegendre::order_2());
        check_symplectic(GaussLegendre::order_4());
        check_symplectic(GaussLegendre::order_6());
    }

    /// The method on the test problem, which has the velocity for its momentum.
    struct OnVelocities<const STAGES: usize>(GaussLegendre<STAGES, Const<1>>);

    impl<const STAGES: usize, E> OneStep<Acceleration, E, Const<1>> for OnVelocities<STAGES>
    where
        Acceleration: Equations<Const<1>, Refusal = E>,
    {
        fn step(
            &mut self,
            system: &Acceleration,
            from: &Start<Const<1>>,
        ) -> Result<Phase<Const<1>>, Failure<E>> {
            self.0.step(&InVelocities(system), from)
        }
    }

    #[test]
    fn orders_are_two_four_and_six() {
        for order in convergence_orders(OnVelocities(GaussLegendre::order_2()), &[100, 200, 400]) {
            assert!((order - 2.0).abs() < 0.05, "order {order}");
        }
        for order in convergence_orders(OnVelocities(GaussLegendre::order_4()), &[20, 40, 80]) {
            assert!((order - 4.0).abs() < 0.1, "order {order}");
        }
        for order in convergence_orders(OnVelocities(GaussLegendre::order_6()), &[10, 20, 40]) {
            assert!((order - 6.0).abs() < 0.2, "order {order}");
        }
    }

    #[test]
    fn a_step_that_is_too_long_for_the_iteration_is_refused() {
        let stiff = |_: f64, phase: &Phase<Const<1>>| Ok::<_, ()>(-1e6 * phase.qd);
        let phase = Phase {
            q: [0.0].into(),
            qd: [1.0].into(),
        };
        let (t, h) = (0.0, 1e-2);
        let step = GaussLegendre::order_4().step(&InVelocities(&stiff), &Start { t, phase, h });
        assert_eq!(step, Err(Failure::NoConvergence));
    }
}
