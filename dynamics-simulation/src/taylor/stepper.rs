//! Steps by Taylor series.

use dynamics_runtime::internal::{two_sum, two_sums};
use dynamics_runtime::{SingularMassMatrix, TaylorCoefficients, TaylorDynamics};
use nalgebra::{Const, SVector};

use super::first_root::Polynomial;
use super::numbers::Series;
use super::step_size::step_size;
use crate::integrate::{Failure, Phase, StepRange, Stepper, Tolerance, first_non_finite};

/// An arm whose torques are constant, and of which some joints are held where they are, until a stepper
/// begins again.
pub(crate) trait Steady<const N: usize> {
    /// The arm.
    type Arm: TaylorDynamics<N>;

    fn arm(&self) -> &Self::Arm;

    /// The torques at a time in a phase, N m or N, which last over a series.
    fn torque(&self, t: f64, phase: &Phase<Const<N>>) -> SVector<f64, N>;

    /// The joints that are held, where any is.
    fn held(&self) -> Option<[bool; N]>;
}

/// Why a series cannot begin at a phase.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Refusal {
    /// A position or a velocity is not finite.
    State { joint: usize },
    /// An acceleration is not finite.
    Acceleration { joint: usize },
    /// The mass matrix is not positive definite.
    Singular(SingularMassMatrix),
}

/// A motion under constant torques, one series a step.
pub(crate) struct SeriesStepper<R, const N: usize>
where
    R: TaylorDynamics<N>,
{
    order: usize,
    tolerance: Tolerance,
    range: StepRange,
    series: Series<R, N>,
    /// Where the series of the last step starts.
    start: f64,
    t: f64,
    phase: Phase<Const<N>>,
    /// The digits that rounded times and phases have lost: the sums of steps are compensated (W. Kahan
    /// 1965; E. Hairer, C. Lubich, G. Wanner, *Geometric Numerical Integration*, VIII.5).
    lost_time: f64,
    lost: Phase<Const<N>>,
    rejected: u64,
}

/// The greatest difference of the accelerations at the end of a step, by its series and by the equations, in units of the
/// last term that the tolerance allows, and of themselves.
const GREATEST_DEFECT: f64 = 1e3;
const GREATEST_RELATIVE_DEFECT: f64 = 1e-8;

impl<R: TaylorDynamics<N>, const N: usize> SeriesStepper<R, N> {
    pub(crate) fn start(
        motion: &impl Steady<N, Arm = R>,
        phase: Phase<Const<N>>,
        order: usize,
        tolerance: Tolerance,
        range: StepRange,
    ) -> Result<Self, Refusal> {
        let mut stepper = SeriesStepper {
            order,
            tolerance,
            range,
            series: Series::new(),
            start: 0.0,
            t: 0.0,
            phase: phase.clone(),
            lost_time: 0.0,
            lost: Phase::zeros(Const),
            rejected: 0,
        };
        stepper.begin(motion, &phase)?;
        Ok(stepper)
    }

    /// The phase at a time within the last step.
    fn within(&self, t: f64) -> Phase<Const<N>> {
        if t == self.t {
            return self.phase.clone();
        }
        let (position, velocity) = self.increments(t - self.start);
        let q = self.series.coefficients();
        Phase {
            q: q[0] + position,
            qd: q[1] + velocity,
        }
    }

    /// The position of a joint over the last step, from 0 at its start to 1 at its end.
    pub(crate) fn position(&self, joint: usize) -> Polynomial {
        self.over_the_step(self.series.coefficients(), joint)
    }

    /// The force that holds a joint, over the last step.
    pub(crate) fn holding_force(&self, joint: usize) -> Polynomial {
        self.over_the_step(self.series.forces(), joint)
    }

    fn over_the_step(&self, series: &TaylorCoefficients<f64, N>, joint: usize) -> Polynomial {
        let h = self.t - self.start;
        let mut power = 1.0;
        Polynomial(series.map(|coefficient| {
            let term = coefficient[joint] * power;
            power *= h;
            term
        }))
    }

    /// The time at a share of the last step.
    pub(crate) fn time_at(&self, share: f64) -> f64 {
        self.start + share * (self.t - self.start)
    }

    /// The phase after a step, and what its rounding has lost.
    fn after(&self, h: f64) -> (Phase<Const<N>>, Phase<Const<N>>) {
        let (position, velocity) = self.increments(h);
        let (q, lost_q) = two_sums(&self.phase.q, &(position + self.lost.q));
        let (qd, lost_qd) = two_sums(&self.phase.qd, &(velocity + self.lost.qd));
        let lost = Phase {
            q: lost_q,
            qd: lost_qd,
        };
        (Phase { q, qd }, lost)
    }

    /// q(h) - q(0) and qd(h) - qd(0) of the series, by Horner's rule.
    fn increments(&self, h: f64) -> (SVector<f64, N>, SVector<f64, N>) {
        let q = self.series.coefficients();
        let (mut position, mut velocity) = (SVector::zeros(), SVector::zeros());
        for k in (2..=self.order).rev() {
            position = (position + q[k]) * h;
            velocity = (velocity + q[k] * k as f64) * h;
        }
        ((position + q[1]) * h, velocity)
    }

    /// Whether the accelerations at the end of a step, which the next series has begun with, are
    /// those of its series: what guards against a series that does not converge there.
    fn fits(&self, h: f64) -> bool {
        let q = self.series.coefficients();
        let mut series = SVector::<f64, N>::zeros();
        for k in (2..=self.order).rev() {
            series = series * h + q[k] * (k * (k - 1)) as f64;
        }
        let (p, of_tolerance) = (self.order as f64, &self.tolerance);
        let acceleration = self.series.acceleration();
        let size = acceleration.amax().max(2.0 * q[2].amax());
        (0..N).all(|i| {
            let allowed = of_tolerance.absolute + of_tolerance.relative * q[0][i].abs();
            let defect = (series[i] - acceleration[i]).abs() * h * h;
            let relative = GREATEST_RELATIVE_DEFECT * size * h * h;
            defect <= GREATEST_DEFECT * p * p * allowed + relative
        })
    }

    /// Begins the series at a phase.
    fn begin(
        &mut self,
        motion: &impl Steady<N, Arm = R>,
        phase: &Phase<Const<N>>,
    ) -> Result<(), Refusal> {
        if let Some(joint) = phase.first_non_finite() {
            return Err(Refusal::State { joint });
        }
        self.series.hold(motion.held());
        let begun = self
            .series
            .begin(motion.arm(), phase, &motion.torque(self.t, phase));
        begun.map_err(Refusal::Singular)?;
        match first_non_finite(self.series.acceleration().as_slice()) {
            Some(joint) => Err(Refusal::Acceleration { joint }),
            None => Ok(()),
        }
    }
}

impl<M, E, R, const N: usize> Stepper<M, E, Const<N>> for SeriesStepper<R, N>
where
    M: Steady<N, Arm = R>,
    E: From<Refusal>,
    R: TaylorDynamics<N>,
{
    fn t(&self) -> f64 {
        self.t
    }

    fn phase(&self) -> &Phase<Const<N>> {
        &self.phase
    }

    /// After a failure the phase is that before the step.
    fn step(&mut self, motion: &M, end: f64) -> Result<(), Failure<E>> {
        self.series.extend(motion.arm(), self.order);
        let coefficients = self.series.coefficients();
        let wish = step_size(coefficients, self.order, &self.tolerance);
        let rest = end - self.t - self.lost_time;
        if wish < self.range.least.min(rest) {
            return Err(Failure::StepTooSmall);
        }
        // The last two steps share what is left.
        let mut h = match wish.min(self.range.greatest) {
            h if h >= rest => rest,
            h if 2.0 * h > rest => 0.5 * rest,
            h => h,
        };
        loop {
            let (next, lost) = self.after(h);
            let failure = match self.begin(motion, &next) {
                Ok(()) if self.fits(h) => {
                    self.start = self.t;
                    (self.t, self.lost_time) = two_sum(self.t, h + self.lost_time);
                    if h == rest {
                        (self.t, self.lost_time) = (end, 0.0);
                    }
                    (self.phase, self.lost) = (next, lost);
                    return Ok(());
                }
                Ok(()) => Failure::StepTooSmall,
                Err(refusal) => Failure::Refused(refusal.into()),
            };
            self.rejected += 1;
            h *= 0.5;
            // Also where it is not a number.
            if h.is_nan() || h <= self.range.least {
                return Err(failure);
            }
        }
    }

    /// On the series of the last step.
    fn at(&mut self, _: &M, t: f64) -> Result<Phase<Const<N>>, Failure<E>> {
        Ok(self.within(t))
    }

    fn retake(&mut self, motion: &M, end: f64) -> Result<(), Failure<E>> {
        let phase = self.within(end);
        (self.t, self.lost_time) = (end, 0.0);
        self.restart(motion, phase)
    }

    fn restart(&mut self, motion: &M, phase: Phase<Const<N>>) -> Result<(), Failure<E>> {
        (self.phase, self.lost) = (phase.clone(), Phase::zeros(Const));
        self.begin(motion, &phase)
            .map_err(|refusal| Failure::Refused(refusal.into()))
    }

    fn rejected(&self) -> u64 {
        self.rejected
    }
}

#[cfg(test)]
mod tests {
    use dynamics_runtime::{
        Inputs, Model, ProductTable, Scalar, SeriesTerm, Table, TaylorDynamics,
    };
    use nalgebra::{Const, SMatrix, SVector, Vector1};

    use super::{Refusal, SeriesStepper, Steady};
    use crate::integrate::{Phase, StepRange, Stepper, Tolerance};

    /// qdd + sin q = tau.
    struct Swing;

    impl Model<1> for Swing {
        const JOINT_NAMES: [&'static str; 1] = ["swing"];

        fn table(&self) -> Table<1> {
            unreachable!("a series does not read it")
        }
    }

    impl TaylorDynamics<1> for Swing {
        type Products<T: Scalar> = ProductTable<T, 0, 1, 0>;

        fn leading_matrix<T: Scalar>(
            &self,
            _: &impl Inputs<T>,
            q: &SVector<T, 1>,
        ) -> SMatrix<T, 1, 1> {
            SMatrix::<T, 1, 1>::new(q[0].constant(1.0))
        }

        fn series_term<T: Scalar>(&self, term: &mut impl SeriesTerm<T, 1>) {
            term.turn(0, 0);
            let force = term.acceleration(0) + term.sine(0);
            term.solve([force]);
        }
    }

    /// Under a torque of 1/4, free or held.
    struct Under {
        holds: bool,
    }

    impl Steady<1> for Under {
        type Arm = Swing;

        fn arm(&self) -> &Swing {
            &Swing
        }

        fn torque(&self, _: f64, _: &Phase<Const<1>>) -> Vector1<f64> {
            Vector1::new(0.25)
        }

        fn held(&self) -> Option<[bool; 1]> {
            self.holds.then_some([true])
        }
    }

    const FREE: Under = Under { holds: false };

    fn step(run: &mut SeriesStepper<Swing, 1>, end: f64) {
        Stepper::<_, Refusal, Const<1>>::step(run, &FREE, end).unwrap();
    }

    fn restart(run: &mut SeriesStepper<Swing, 1>, motion: &Under, phase: Phase<Const<1>>) {
        Stepper::<_, Refusal, Const<1>>::restart(run, motion, phase).unwrap();
    }

    fn start(t: f64, phase: Phase<Const<1>>) -> SeriesStepper<Swing, 1> {
        let tolerance = Tolerance {
            relative: 1e-13,
            absolute: 1e-13,
        };
        let range = StepRange {
            least: 1e-14,
            greatest: 1.0,
        };
        let mut run = SeriesStepper::start(&FREE, phase, 20, tolerance, range).unwrap();
        run.t = t;
        run
    }

    fn phase(q: f64, qd: f64) -> Phase<Const<1>> {
        Phase {
            q: Vector1::new(q),
            qd: Vector1::new(qd),
        }
    }

    fn reach(run: &mut SeriesStepper<Swing, 1>, end: f64) -> Phase<Const<1>> {
        while run.t < end {
            step(run, end);
        }
        run.phase.clone()
    }

    /// E = qd^2 / 2 - cos q - tau q.
    #[test]
    fn a_swing_keeps_its_energy() {
        let energy =
            |Phase { q, qd }: Phase<Const<1>>| 0.5 * qd[0] * qd[0] - q[0].cos() - 0.25 * q[0];
        let from = phase(2.0, -0.5);
        let end = reach(&mut start(0.0, from.clone()), 10.0);
        assert!((energy(end) - energy(from)).abs() < 1e-12);
    }

    #[test]
    fn a_step_made_again_is_one_to_the_earlier_time() {
        let mut run = start(0.0, phase(2.0, -0.5));
        step(&mut run, 5.0);
        step(&mut run, 5.0);
        let (from, to) = (run.start, run.t);
        let middle = 0.4 * from + 0.6 * to;
        let expected = run.within(middle);
        Stepper::<_, Refusal, Const<1>>::retake(&mut run, &FREE, middle).unwrap();
        assert_eq!((run.t, &run.phase), (middle, &expected));
        let whole = reach(&mut start(0.0, phase(2.0, -0.5)), 5.0);
        assert!(
            reach(&mut run, 5.0)
                .minus(&whole)
                .entries()
                .all(|e| e.abs() < 1e-12)
        );
    }

    /// A joint that is held does not move, by a force of sin q - tau; let go, it does.
    #[test]
    fn a_joint_that_is_held_stays() {
        let mut run = start(0.0, phase(0.5, 0.0));
        let held = Under { holds: true };
        restart(&mut run, &held, phase(0.5, 0.0));
        Stepper::<_, Refusal, Const<1>>::step(&mut run, &held, 0.5).unwrap();
        assert_eq!((run.t, &run.phase), (0.5, &phase(0.5, 0.0)));
        let force = run.holding_force(0);
        let expected = 0.5_f64.sin() - 0.25;
        assert!((force.0[0] - expected).abs() < 1e-15);
        assert!(force.0[1..].iter().all(|c| *c == 0.0));
        restart(&mut run, &FREE, phase(0.5, 0.0));
        step(&mut run, 1.0);
        assert!(run.phase.q[0] < 0.5);
    }

    #[test]
    fn a_restart_forgets_the_motion_before() {
        let other = phase(-1.0, 0.3);
        let mut run = start(0.0, phase(2.0, -0.5));
        reach(&mut run, 1.0);
        restart(&mut run, &FREE, other.clone());
        let expected = reach(&mut start(1.0, other), 2.0);
        assert_eq!(reach(&mut run, 2.0), expected);
    }
}
