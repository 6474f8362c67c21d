//! The Dormand-Prince method of order 5(4) with error control and dense output.
//!
//! Own code because no crate fits. `ode_solvers` 0.6.2 builds on another nalgebra.
//! `differential-equations` 0.7.0 was tried: its right-hand side cannot fail. Standing in for a
//! failure, a NaN at t = 1 of a pendulum cost 65,000 evaluations up to the limit of steps, and the
//! error that came then holds none of the samples before. It also brings nalgebra's default
//! features, two versions of syn among them, into every user's build.

use nalgebra::SVector;

use super::Phase;
use super::step_control::StepControl;
use super::tableau::{A, C, DENSE, ERROR, STAGES};

/// Error bounds: a step's error in an entry y may be `absolute + relative |y|`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tolerance {
    pub(crate) relative: f64,
    pub(crate) absolute: f64,
}

impl Tolerance {
    /// Root mean square of the entries, each over its bound at the larger of two phases (Hairer,
    /// Nørsett, Wanner I, (II.4.11)).
    fn norm<const N: usize>(&self, error: &Phase<N>, from: &Phase<N>, to: &Phase<N>) -> f64 {
        let entries = error.entries().zip(from.entries().zip(to.entries()));
        let squares = entries.map(|(error, (from, to))| {
            let bound = self.absolute + self.relative * from.abs().max(to.abs());
            (error / bound).powi(2)
        });
        (squares.sum::<f64>() / (2 * N) as f64).sqrt()
    }
}

/// Bounds of the step size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StepRange {
    pub(crate) least: f64,
    pub(crate) greatest: f64,
}

/// Why a step could not be made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Failure<E> {
    /// The acceleration is refused however short the step is.
    Refused(E),
    /// The error stays too large however short the step is.
    StepTooSmall,
}

/// An integration under way, at the end of its last step.
pub(crate) struct Adaptive<const N: usize> {
    pub(crate) t: f64,
    pub(crate) phase: Phase<N>,
    rate: Phase<N>,
    h: f64,
    tolerance: Tolerance,
    range: StepRange,
    control: StepControl,
    dense: Dense<N>,
}

impl<const N: usize> Adaptive<N> {
    /// At the start, with a first guess of the step size.
    pub(crate) fn start<E>(
        acceleration: &impl Fn(f64, &Phase<N>) -> Result<SVector<f64, N>, E>,
        t: f64,
        phase: Phase<N>,
        tolerance: Tolerance,
        range: StepRange,
    ) -> Result<Self, E> {
        let rate = phase.rate(acceleration(t, &phase)?);
        let h = initial_step(acceleration, t, &phase, &rate, &tolerance);
        Ok(Adaptive {
            t,
            phase,
            rate,
            h,
            tolerance,
            range,
            control: StepControl::new(),
            dense: Dense::resting(t, phase),
        })
    }

    /// Makes one step, which ends at `end` at the latest, as long as the tolerance permits.
    ///
    /// A step on which the acceleration is refused is tried again shorter: the place where it is
    /// refused may lie beyond the end of the motion, or in a stage that a good step avoids.
    pub(crate) fn step<E>(
        &mut self,
        acceleration: &impl Fn(f64, &Phase<N>) -> Result<SVector<f64, N>, E>,
        end: f64,
    ) -> Result<(), Failure<E>> {
        loop {
            let left = end - self.t;
            self.h = self.h.min(self.range.greatest);
            // Rather a step longer by a hundredth than a tiny one after it.
            let last = 1.01 * self.h >= left;
            if last {
                self.h = left;
            }
            let (error, failure) = match self.trial(acceleration) {
                Ok(trial) => {
                    let error = self.error(&trial);
                    if error <= 1.0 {
                        self.accept(trial, error, last.then_some(end));
                        return Ok(());
                    }
                    (error, Failure::StepTooSmall)
                }
                Err(refusal) => (f64::NAN, Failure::Refused(refusal)),
            };
            self.h *= self.control.reject(error);
            if self.h < self.range.least {
                return Err(failure);
            }
        }
    }

    /// The stages of a step from here.
    fn trial<E>(
        &self,
        acceleration: &impl Fn(f64, &Phase<N>) -> Result<SVector<f64, N>, E>,
    ) -> Result<Trial<N>, E> {
        let mut rates = [self.rate; STAGES];
        let mut end = self.phase;
        for i in 1..STAGES {
            let slope = combination(&A[i][..i], &rates);
            end = self.phase.plus(self.h, &slope);
            rates[i] = end.rate(acceleration(self.t + C[i] * self.h, &end)?);
        }
        Ok(Trial { rates, end })
    }

    fn error(&self, trial: &Trial<N>) -> f64 {
        let error = combination(&ERROR, &trial.rates).scaled(self.h);
        self.tolerance.norm(&error, &self.phase, &trial.end)
    }

    fn accept(&mut self, trial: Trial<N>, error: f64, end: Option<f64>) {
        self.dense = Dense::new(self.t, &self.phase, self.h, &trial);
        self.t = end.unwrap_or(self.t + self.h);
        self.phase = trial.end;
        self.rate = trial.rates[STAGES - 1];
        self.h *= self.control.accept(error);
    }

    /// The phase at a time within the last step, to fourth order.
    pub(crate) fn at(&self, t: f64) -> Phase<N> {
        if t >= self.t {
            return self.phase;
        }
        self.dense.at(t)
    }
}

/// A step that was tried.
struct Trial<const N: usize> {
    rates: [Phase<N>; STAGES],
    end: Phase<N>,
}

fn combination<const N: usize>(weights: &[f64], rates: &[Phase<N>]) -> Phase<N> {
    let terms = weights.iter().zip(rates);
    terms.fold(Phase::zeros(), |sum, (weight, rate)| {
        sum.plus(*weight, rate)
    })
}

/// The polynomial of fourth degree through a step (Hairer, Nørsett, Wanner I, section II.6, in the
/// form of their program DOPRI5).
struct Dense<const N: usize> {
    t: f64,
    h: f64,
    coefficients: [Phase<N>; 5],
}

impl<const N: usize> Dense<N> {
    fn resting(t: f64, phase: Phase<N>) -> Self {
        let zero = Phase::zeros();
        Dense {
            t,
            h: 1.0,
            coefficients: [phase, zero, zero, zero, zero],
        }
    }

    fn new(t: f64, start: &Phase<N>, h: f64, trial: &Trial<N>) -> Self {
        let change = trial.end.minus(start);
        let bend = trial.rates[0].scaled(h).minus(&change);
        let twist = change
            .minus(&trial.rates[STAGES - 1].scaled(h))
            .minus(&bend);
        let lift = combination(&DENSE, &trial.rates).scaled(h);
        Dense {
            t,
            h,
            coefficients: [*start, change, bend, twist, lift],
        }
    }

    /// y = r1 + s (r2 + (1 - s) (r3 + s (r4 + (1 - s) r5))), s from 0 to 1 over the step.
    fn at(&self, t: f64) -> Phase<N> {
        let s = (t - self.t) / self.h;
        let [r1, r2, r3, r4, r5] = &self.coefficients;
        let inner = r3.plus(s, &r4.plus(1.0 - s, r5));
        r1.plus(s, &r2.plus(1.0 - s, &inner))
    }
}

/// A step size at which an Euler step is about as good as the tolerance asks (Hairer, Nørsett,
/// Wanner I, section II.4, "starting step size").
fn initial_step<E, const N: usize>(
    acceleration: &impl Fn(f64, &Phase<N>) -> Result<SVector<f64, N>, E>,
    t: f64,
    phase: &Phase<N>,
    rate: &Phase<N>,
    tolerance: &Tolerance,
) -> f64 {
    let norm = |value: &Phase<N>| tolerance.norm(value, phase, phase);
    let (size, speed) = (norm(phase), norm(rate));
    let small = size < 1e-5 || speed < 1e-5;
    let first = if small { 1e-6 } else { 0.01 * size / speed };

    let ahead = phase.plus(first, rate);
    let Ok(qdd) = acceleration(t + first, &ahead) else {
        return first;
    };
    let bending = norm(&ahead.rate(qdd).minus(rate)) / first;
    let steepness = speed.max(bending);
    let second = if steepness <= 1e-15 {
        (1e-3 * first).max(1e-6)
    } else {
        (0.01 / steepness).powf(0.2)
    };
    second.min(100.0 * first)
}

#[cfg(test)]
mod tests {
    use core::convert::Infallible;

    use super::{Adaptive, Failure, StepRange, Tolerance};
    use crate::integrate::Phase;
    use crate::integrate::test_problems::{ACCELERATION, distance, solution, vector};

    const RANGE: StepRange = StepRange {
        least: 1e-14,
        greatest: 10.0,
    };

    fn tolerance(value: f64) -> Tolerance {
        Tolerance {
            relative: value,
            absolute: value,
        }
    }

    /// The test problem at its start, with a given step size.
    fn with_step(h: f64) -> Adaptive<1> {
        let accept_all = tolerance(1e6);
        let Ok(mut run) = Adaptive::start(&ACCELERATION, 0.0, solution(0.0), accept_all, RANGE);
        run.range.greatest = h;
        run.h = h;
        run
    }

    /// Errors of the end of two seconds and of the middles of the steps, at a fixed step size.
    fn errors(steps: usize) -> (f64, f64) {
        let mut run = with_step(2.0 / steps as f64);
        let mut dense = 0.0_f64;
        while run.t < 2.0 {
            let before = run.t;
            run.step(&ACCELERATION, 2.0).unwrap();
            for s in [0.25, 0.5, 0.8] {
                let t = before + s * (run.t - before);
                dense = dense.max(distance(&run.at(t), &solution(t)));
            }
        }
        (distance(&run.phase, &solution(2.0)).log2(), dense.log2())
    }

    #[test]
    fn is_of_fifth_order_with_output_of_local_order_five() {
        let (coarse, fine) = (errors(40), errors(80));
        let order = coarse.0 - fine.0;
        assert!((order - 5.0).abs() < 0.2, "order {order}");
        // The polynomial is of fourth order: its own error within one step falls with h^5.
        let dense = coarse.1 - fine.1;
        assert!((dense - 5.0).abs() < 0.3, "dense order {dense}");
    }

    #[test]
    fn output_meets_the_ends_of_the_step() {
        let mut run = with_step(0.1);
        run.step(&ACCELERATION, 2.0).unwrap();
        assert_eq!(run.at(0.0), solution(0.0));
        assert_eq!(run.at(0.1), run.phase);
        let before_the_end = run.dense.at(0.1);
        assert!(distance(&before_the_end, &run.phase) < 1e-15);
    }

    #[test]
    fn error_follows_the_tolerance() {
        for value in [1e-4, 1e-7, 1e-10] {
            let Ok(mut run) =
                Adaptive::start(&ACCELERATION, 0.0, solution(0.0), tolerance(value), RANGE);
            while run.t < 2.0 {
                run.step(&ACCELERATION, 2.0).unwrap();
            }
            assert_eq!(run.t, 2.0);
            let error = distance(&run.phase, &solution(2.0));
            assert!((0.01 * value..10.0 * value).contains(&error), "{error:e}");
        }
    }

    #[test]
    fn a_wall_is_reached_and_not_crossed() {
        let wall = |t: f64, _: &Phase<1>| if t < 1.0 { Ok(vector(t)) } else { Err("wall") };
        let mut run = Adaptive::start(&wall, 0.0, Phase::zeros(), tolerance(1e-6), RANGE).unwrap();
        let failure = loop {
            if let Err(failure) = run.step(&wall, 2.0) {
                break failure;
            }
        };
        assert_eq!(failure, Failure::Refused("wall"));
        assert!(run.t < 1.0 && run.t > 1.0 - 1e-12, "{}", run.t);
    }

    #[test]
    fn a_pole_ends_in_a_step_that_is_too_small() {
        // q' = 1 / (1 - t), which no step passes.
        let pole =
            |_: f64, phase: &Phase<1>| Ok::<_, Infallible>(phase.qd.component_mul(&phase.qd));
        let start = Phase {
            q: vector(0.0),
            qd: vector(1.0),
        };
        let Ok(mut run) = Adaptive::start(&pole, 0.0, start, tolerance(1e-6), RANGE);
        let failure = loop {
            if let Err(failure) = run.step(&pole, 2.0) {
                break failure;
            }
        };
        assert_eq!(failure, Failure::StepTooSmall);
        // The place of the pole is as accurate as the steps before it.
        assert!((run.t - 1.0).abs() < 1e-5, "{}", run.t);
    }
}
