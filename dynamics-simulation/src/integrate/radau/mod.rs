//! The Radau IIA method of order 5, for stiff equations.
//!
//! E. Hairer, G. Wanner, *Solving Ordinary Differential Equations II*, 2nd edition, section IV.8, and
//! their program RADAU5: a simplified Newton iteration on transformed stages, an error estimate of
//! order 3 that is filtered by the Jacobian, and predictive step control. That q' is the velocity
//! halves the systems of equations ([`Shifted`]).

mod newton;
mod polynomial;
mod tableau;
#[cfg(test)]
mod tests;

use dynamics_runtime::Size;

use super::embedded::combination;
use super::initial_step::initial_step;
use super::jacobian::{Jacobian, Shifted};
use super::{Equations, Failure, Phase, StepRange, Stepper, Tolerance};
use newton::{MOST_ITERATIONS, Matrices, Miss, Newton, Step};
use polynomial::Polynomial;
use tableau::{C, ERROR};

/// An integration under way, at the end of its last step.
pub(crate) struct Radau<D: Size> {
    here: Place<D>,
    /// The start of the last step.
    from: Place<D>,
    h: f64,
    /// The step that the motion needs at its start.
    first: f64,
    jacobian: Jacobian<D>,
    jacobian_is: Age,
    polynomial: Option<Polynomial<D>>,
    before: Option<Accepted>,
    tolerance: Tolerance,
    newton: Newton,
    range: StepRange,
    rejected: u64,
    just_rejected: bool,
}

/// A time, the phase then, and its rate.
#[derive(Clone)]
struct Place<D: Size> {
    t: f64,
    phase: Phase<D>,
    rate: Phase<D>,
}

/// Whether the Jacobian is that of the phase reached.
#[derive(Clone, Copy, PartialEq)]
enum Age {
    Fresh,
    Old,
    Useless,
}

/// Length and error of an accepted step.
#[derive(Clone, Copy)]
struct Accepted {
    h: f64,
    error: f64,
}

/// A step that was tried.
struct Trial<D: Size> {
    /// Changes of the phase from the start to the stages.
    changes: [Phase<D>; 3],
    error: f64,
    iterations: u32,
}

const SAFETY: f64 = 0.9;
/// Bounds of the old step over the new one.
const QUOTIENTS: (f64, f64) = (1.0 / 8.0, 5.0);

impl<D: Size> Radau<D> {
    /// At the start, t = 0, with a first guess of the step size.
    pub(crate) fn start<S: Equations<D>>(
        system: &S,
        phase: Phase<D>,
        wanted: Tolerance,
        range: StepRange,
    ) -> Result<Self, S::Refusal> {
        let t = 0.0;
        let rate = system.rate(t, &phase)?;
        // The estimate is of order 3 and the result of order 5.
        let relative = 0.1 * wanted.relative.powf(2.0 / 3.0);
        let tolerance = Tolerance {
            relative,
            absolute: relative * (wanted.absolute / wanted.relative),
        };
        let least = 10.0 * f64::EPSILON / relative;
        let first = initial_step(system, &phase, &rate, &wanted, 4.0);
        let jacobian = Jacobian::zeros(phase.size());
        let here = Place { t, phase, rate };
        Ok(Radau {
            from: here.clone(),
            here,
            h: first,
            first,
            jacobian,
            jacobian_is: Age::Useless,
            polynomial: None,
            before: None,
            tolerance,
            newton: Newton::new(least.max(relative.sqrt().min(0.03))),
            range,
            rejected: 0,
            just_rejected: false,
        })
    }

    /// The stages of a step of length `h` and its error.
    fn trial<S: Equations<D>>(&mut self, system: &S) -> Result<Trial<D>, Miss<S::Refusal>> {
        if self.jacobian_is == Age::Useless {
            let Place { t, phase, rate } = &self.here;
            self.jacobian = Jacobian::at(system, *t, phase, &rate.qd)?;
            self.jacobian_is = Age::Fresh;
        }
        let guess = self.predicted();
        let matrices = Matrices::new(self.here.phase.size(), &self.jacobian, self.h);
        let step = Step {
            system,
            t: self.here.t,
            phase: &self.here.phase,
            h: self.h,
            tolerance: &self.tolerance,
        };
        let (changes, iterations) = self.newton.solve(&step, &matrices, guess)?;
        let error = self.error(system, &changes, &matrices.real)?;
        Ok(Trial {
            changes,
            error,
            iterations,
        })
    }

    /// The stages' changes that the polynomial of the step before predicts.
    fn predicted(&self) -> [Phase<D>; 3] {
        let polynomial = self.polynomial.as_ref().filter(|_| !self.just_rejected);
        let Place { t, phase, .. } = &self.here;
        C.map(|c| match polynomial {
            Some(polynomial) => polynomial.at(t + c * self.h).minus(phase),
            None => Phase::zeros(phase.size()),
        })
    }

    fn norm(&self, value: &Phase<D>) -> f64 {
        let phase = &self.here.phase;
        self.tolerance.norm(value, phase, phase)
    }

    /// (IV.8.19) and (IV.8.20): `(gamma / h - J)^-1 (f(y) + e.z / h)`. At the start and after a rejected step this is
    /// done once more from there, because the estimate of a very stiff component is too large.
    fn error<S: Equations<D>>(
        &self,
        system: &S,
        changes: &[Phase<D>; 3],
        real: &Shifted<f64, D>,
    ) -> Result<f64, S::Refusal> {
        let Place { t, phase, rate } = &self.here;
        let weighted = combination(&ERROR, changes).scaled(1.0 / self.h);
        let estimate = real.solve(&weighted.plus(1.0, rate));
        let error = self.norm(&estimate).max(1e-10);
        if error < 1.0 || !(self.before.is_none() || self.just_rejected) {
            return Ok(error);
        }
        let rate = system.rate(*t, &phase.plus(1.0, &estimate))?;
        let estimate = real.solve(&weighted.plus(1.0, &rate));
        Ok(self.norm(&estimate).max(1e-10))
    }

    /// The old step over the one that the error allows, the fewer iterations the longer; after
    /// Gustafsson (1994) from the errors of two steps.
    fn quotient(&self, trial: &Trial<D>) -> f64 {
        let (least, greatest) = QUOTIENTS;
        let patience = f64::from(1 + 2 * MOST_ITERATIONS);
        let taken = f64::from(trial.iterations + 2 * MOST_ITERATIONS);
        let factor = SAFETY * (patience / taken).min(1.0);
        let plain = (trial.error.powf(0.25) / factor).clamp(least, greatest);
        match self.before {
            Some(before) if trial.error < 1.0 => {
                let ratio = trial.error.powi(2) / before.error;
                let predicted = before.h / self.h * ratio.powf(0.25) / SAFETY;
                plain.max(predicted.clamp(least, greatest))
            }
            _ => plain,
        }
    }

    fn accept<S: Equations<D>>(
        &mut self,
        system: &S,
        trial: &Trial<D>,
        end: f64,
    ) -> Result<(), S::Refusal> {
        let (t, phase) = (end, self.here.phase.plus(1.0, &trial.changes[2]));
        let rate = system.rate(t, &phase)?;
        let quotient = self.quotient(trial);
        self.polynomial = Some(Polynomial::new(end, self.h, &phase, &trial.changes));
        self.before = Some(Accepted {
            h: self.h,
            error: trial.error.max(1e-2),
        });
        self.from = core::mem::replace(&mut self.here, Place { t, phase, rate });
        // A step that just failed is not followed by a longer one.
        let least = if self.just_rejected { 1.0 } else { QUOTIENTS.0 };
        self.h /= quotient.max(least);
        self.just_rejected = false;
        let keeps = self.newton.was_fast();
        self.jacobian_is = if keeps { Age::Old } else { Age::Useless };
        Ok(())
    }

    /// Makes the step shorter by a factor, and the Jacobian new where it was not.
    fn shorten(&mut self, factor: f64) {
        self.rejected += 1;
        self.just_rejected = true;
        self.h *= factor;
        if self.jacobian_is == Age::Old {
            self.jacobian_is = Age::Useless;
        }
    }
}

impl<S: Equations<D>, D: Size> Stepper<S, S::Refusal, D> for Radau<D> {
    fn t(&self) -> f64 {
        self.here.t
    }

    fn phase(&self) -> &Phase<D> {
        &self.here.phase
    }

    fn step(&mut self, system: &S, end: f64) -> Result<(), Failure<S::Refusal>> {
        loop {
            let (step, is_last) = self.range.choose(self.h, end - self.here.t);
            self.h = step;
            let step_end = if is_last { end } else { self.here.t + step };
            let failure = match self.trial(system) {
                Ok(trial) if trial.error < 1.0 => match self.accept(system, &trial, step_end) {
                    Ok(()) => return Ok(()),
                    Err(refusal) => {
                        self.shorten(0.2);
                        Failure::Refused(refusal)
                    }
                },
                Ok(trial) => {
                    let quotient = self.before.map(|_| self.quotient(&trial));
                    let factor = quotient.map_or(0.1, |quotient| 1.0 / quotient);
                    // An error that is not a number makes none.
                    self.shorten(if factor < 1.0 { factor } else { 0.2 });
                    Failure::StepTooSmall
                }
                Err(Miss::Newton(factor)) => {
                    self.shorten(factor);
                    Failure::StepTooSmall
                }
                Err(Miss::Refused(refusal)) => {
                    self.shorten(0.2);
                    Failure::Refused(refusal)
                }
            };
            if self.h < self.range.least {
                return Err(self.range.judge(failure, self.first));
            }
        }
    }

    fn at(&mut self, _: &S, t: f64) -> Result<Phase<D>, Failure<S::Refusal>> {
        Ok(match &self.polynomial {
            Some(polynomial) if t < self.here.t => polynomial.at(t),
            _ => self.here.phase.clone(),
        })
    }

    fn retake(&mut self, system: &S, end: f64) -> Result<(), Failure<S::Refusal>> {
        self.here = self.from.clone();
        let next = self.h;
        self.h = end - self.here.t;
        self.polynomial = None;
        self.jacobian_is = Age::Useless;
        match self.trial(system) {
            Ok(trial) => self.accept(system, &trial, end)?,
            Err(Miss::Refused(refusal)) => return Err(Failure::Refused(refusal)),
            Err(Miss::Newton(_)) => return Err(Failure::NoConvergence),
        }
        self.h = next;
        Ok(())
    }

    fn restart(&mut self, system: &S, phase: Phase<D>) -> Result<(), Failure<S::Refusal>> {
        self.here.rate = system.rate(self.here.t, &phase)?;
        self.here.phase = phase;
        self.polynomial = None;
        self.before = None;
        self.jacobian_is = Age::Useless;
        Ok(())
    }

    fn rejected(&self) -> u64 {
        self.rejected
    }
}
