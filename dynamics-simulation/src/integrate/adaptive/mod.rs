//! Integration by explicit methods with error control and dense output.

#[cfg(test)]
mod tests;

use dynamics_runtime::Size;

use super::embedded::Embedded;
use super::initial_step::initial_step;
use super::step_control::StepControl;
use super::{Equations, Failure, Phase, Start, StepRange, Stepper, Tolerance};

/// An integration under way, at the end of its last step.
pub(crate) struct Adaptive<M: Embedded<D>, D: Size> {
    next: Start<D>,
    last: Start<D>,
    /// The step that the motion needs at its start.
    first: f64,
    rates: M::Rates,
    fresh: bool,
    polynomial: Option<M::Polynomial>,
    tolerance: Tolerance,
    range: StepRange,
    control: StepControl,
    rejected: u64,
}

impl<M: Embedded<D>, D: Size> Adaptive<M, D> {
    /// At the start, t = 0, with a first guess of the step size.
    pub(crate) fn start<S: Equations<D>>(
        system: &S,
        phase: Phase<D>,
        tolerance: Tolerance,
        range: StepRange,
    ) -> Result<Self, S::Refusal> {
        let t = 0.0;
        let rate = system.rate(t, &phase)?;
        let first = initial_step(system, &phase, &rate, &tolerance, M::CONTROL.order);
        let next = Start { t, phase, h: first };
        Ok(Adaptive {
            last: next.clone(),
            next,
            first,
            rates: M::rates(rate),
            fresh: false,
            polynomial: None,
            tolerance,
            range,
            control: StepControl::new(M::CONTROL),
            rejected: 0,
        })
    }

    /// A step from here: its end and its error, 1 at the tolerance.
    #[inline]
    fn trial<S: Equations<D>>(&mut self, system: &S) -> Result<(Phase<D>, f64), S::Refusal> {
        let from = &self.next;
        let end = M::trial(system, from, &mut self.rates)?;
        let norm = |value: &Phase<D>| self.tolerance.norm(value, &from.phase, &end);
        let error = M::error(from.h, &self.rates, norm);
        if error <= 1.0 {
            M::finish(system, from, &end, &mut self.rates)?;
        }
        Ok((end, error))
    }

    fn accept(&mut self, phase: Phase<D>, error: f64, end: Option<f64>) {
        let Start { t, h, .. } = self.next;
        let next = Start {
            t: end.unwrap_or(t + h),
            phase,
            h: h * self.control.accept(error),
        };
        self.last = core::mem::replace(&mut self.next, next);
        self.fresh = true;
        self.polynomial = None;
    }
}

impl<M: Embedded<D>, S: Equations<D>, D: Size> Stepper<S, S::Refusal, D> for Adaptive<M, D> {
    fn t(&self) -> f64 {
        self.next.t
    }

    fn phase(&self) -> &Phase<D> {
        &self.next.phase
    }

    /// Makes one step, as long as the tolerance permits.
    ///
    /// A step on which the acceleration is refused is tried again shorter: a stage that a good step avoids may lie
    /// beyond the end of the motion.
    fn step(&mut self, system: &S, end: f64) -> Result<(), Failure<S::Refusal>> {
        // The stages of the last step are kept until here for its polynomial.
        if self.fresh {
            self.rates[0] = self.rates[M::LAST].clone();
            self.fresh = false;
        }
        loop {
            let (step, is_last) = self.range.choose(self.next.h, end - self.next.t);
            self.next.h = step;
            let (error, failure) = match self.trial(system) {
                Ok((phase, error)) => {
                    if error <= 1.0 {
                        self.accept(phase, error, is_last.then_some(end));
                        return Ok(());
                    }
                    (error, Failure::StepTooSmall)
                }
                Err(refusal) => (f64::NAN, Failure::Refused(refusal)),
            };
            self.rejected += 1;
            self.next.h *= self.control.reject(error);
            if self.next.h < self.range.least {
                return Err(self.range.judge(failure, self.first));
            }
        }
    }

    /// The phase at a time within the last step, by its polynomial.
    fn at(&mut self, system: &S, t: f64) -> Result<Phase<D>, Failure<S::Refusal>> {
        let end = &self.next;
        if t >= end.t {
            return Ok(end.phase.clone());
        }
        let polynomial = match self.polynomial.take() {
            Some(polynomial) => polynomial,
            None => M::polynomial(system, &self.last, &end.phase, &mut self.rates)?,
        };
        let polynomial = self.polynomial.insert(polynomial);
        Ok(M::evaluate(polynomial, (t - self.last.t) / self.last.h))
    }

    fn retake(&mut self, system: &S, end: f64) -> Result<(), Failure<S::Refusal>> {
        let from = Start {
            h: end - self.last.t,
            ..self.last.clone()
        };
        // The first of the stages is still that of the step to be made again.
        self.next.phase = M::trial(system, &from, &mut self.rates)?;
        M::finish(system, &from, &self.next.phase, &mut self.rates)?;
        self.next.t = end;
        self.last = from;
        self.polynomial = None;
        Ok(())
    }

    fn restart(&mut self, system: &S, phase: Phase<D>) -> Result<(), Failure<S::Refusal>> {
        self.rates[0] = system.rate(self.next.t, &phase)?;
        self.next.phase = phase;
        self.fresh = false;
        Ok(())
    }

    fn recentre(&mut self, system: &S) {
        let Some(q) = system.recentred(&self.next.phase) else {
            return;
        };
        self.next.phase.q = q;
        // Accelerations are the same in each chart.
        let first = if self.fresh { M::LAST } else { 0 };
        self.rates[first].q = system.position_rates(&self.next.phase);
    }

    fn rejected(&self) -> u64 {
        self.rejected
    }
}
