//! Steps by Taylor series.

use nalgebra::SVector;

use super::TaylorDynamics;
use super::numbers::Series;
use super::step_size::step_size;
use crate::exact::{two_sum, two_sums};
use crate::integrate::{Failure, Phase, StepRange, Tolerance, first_non_finite};
use crate::simulation::Cause;

/// A motion under a constant torque, one series a step.
pub(crate) struct Stepper<'a, R, const N: usize>
where
    R: TaylorDynamics<N>,
{
    robot: &'a R,
    tau: SVector<f64, N>,
    order: usize,
    tolerance: Tolerance,
    range: StepRange,
    series: Series<R, N>,
    /// Where the series of the last step starts.
    start: f64,
    pub(crate) t: f64,
    pub(crate) phase: Phase<N>,
    /// What the roundings of time and phase have lost: the sums of steps are compensated (W. Kahan
    /// 1965; E. Hairer, C. Lubich, G. Wanner, *Geometric Numerical Integration*, VIII.5).
    lost_time: f64,
    lost: Phase<N>,
    /// Steps that were tried and thrown away.
    pub(crate) rejected: u64,
}

/// The greatest difference of the accelerations at the end of a step, those of its series and those
/// of the equations, in units of what the tolerance allows the last term, and of themselves.
const GREATEST_DEFECT: f64 = 1e3;
const GREATEST_RELATIVE_DEFECT: f64 = 1e-8;

impl<'a, R, const N: usize> Stepper<'a, R, N>
where
    R: TaylorDynamics<N>,
{
    pub(crate) fn start(
        robot: &'a R,
        phase: Phase<N>,
        tau: SVector<f64, N>,
        order: usize,
        tolerance: Tolerance,
        range: StepRange,
    ) -> Result<Self, Cause> {
        let mut stepper = Stepper {
            robot,
            tau,
            order,
            tolerance,
            range,
            series: Series::new(),
            start: 0.0,
            t: 0.0,
            phase,
            lost_time: 0.0,
            lost: Phase::zeros(),
            rejected: 0,
        };
        stepper.begin(&phase)?;
        Ok(stepper)
    }

    /// Makes a step, at most to `end`. After a failure the phase is that before the step.
    pub(crate) fn step(&mut self, end: f64) -> Result<(), Failure<Cause>> {
        self.series.extend(self.robot, self.order);
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
            let failure = match self.begin(&next) {
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
                Err(cause) => Failure::Refused(cause),
            };
            self.rejected += 1;
            h *= 0.5;
            // Also where it is not a number.
            if h.is_nan() || h <= self.range.least {
                return Err(failure);
            }
        }
    }

    /// The phase at a time of the last step, on its series.
    pub(crate) fn at(&self, t: f64) -> Phase<N> {
        if t == self.t {
            return self.phase;
        }
        let q = self.series.coefficients();
        let h = t - self.start;
        let (position, velocity) = self.increments(h);
        Phase {
            q: q[0] + position,
            qd: q[1] + velocity,
        }
    }

    /// The phase after a step, and what its rounding has lost.
    fn after(&self, h: f64) -> (Phase<N>, Phase<N>) {
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
    fn begin(&mut self, phase: &Phase<N>) -> Result<(), Cause> {
        if let Some(joint) = phase.first_non_finite() {
            return Err(Cause::NonFiniteState { joint });
        }
        self.series.begin(self.robot, phase, &self.tau)?;
        match first_non_finite(&self.series.acceleration()) {
            Some(joint) => Err(Cause::NonFiniteAcceleration { joint }),
            None => Ok(()),
        }
    }
}
