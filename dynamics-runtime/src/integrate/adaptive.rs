//! Integration by explicit methods with error control and dense output.

use core::ops::{Index, IndexMut};

use super::initial_step::initial_step;
use super::step_control::{Constants, StepControl};
use super::{Equations, Failure, Phase, StepRange, Stepper, Tolerance};

/// An explicit Runge-Kutta method with an error estimate and dense output.
pub(crate) trait Embedded<const N: usize> {
    /// The rates of all stages, those of the dense output among them.
    type Rates: Copy + Index<usize, Output = Phase<N>> + IndexMut<usize>;

    /// Coefficients of the polynomial through a step.
    type Polynomial: Copy;

    /// The stage at the end of the step, which is the first of the next step.
    const LAST: usize;

    /// How the step size is chosen.
    const CONTROL: Constants;

    /// All stages at one rate.
    fn rates(rate: Phase<N>) -> Self::Rates;

    /// Evaluates the stages of a step but the first, and returns the end of the step.
    fn trial<S: Equations<N>>(
        system: &S,
        from: &Start<N>,
        rates: &mut Self::Rates,
    ) -> Result<Phase<N>, S::Refusal>;

    /// Evaluates the stage [`LAST`](Embedded::LAST), where the trial did not.
    fn finish<S: Equations<N>>(
        _system: &S,
        _from: &Start<N>,
        _end: &Phase<N>,
        _rates: &mut Self::Rates,
    ) -> Result<(), S::Refusal> {
        Ok(())
    }

    /// Size of the error of a step, 1 at the tolerance, where `norm` measures a phase.
    fn error(h: f64, rates: &Self::Rates, norm: impl Fn(&Phase<N>) -> f64) -> f64;

    /// The polynomial through a step to `end`; may evaluate stages of its own.
    fn polynomial<S: Equations<N>>(
        system: &S,
        from: &Start<N>,
        end: &Phase<N>,
        rates: &mut Self::Rates,
    ) -> Result<Self::Polynomial, S::Refusal>;

    /// The polynomial at `s`, which runs from 0 to 1 over the step.
    fn evaluate(polynomial: &Self::Polynomial, s: f64) -> Phase<N>;
}

/// Where a step starts, and its length.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Start<const N: usize> {
    pub(super) t: f64,
    pub(super) phase: Phase<N>,
    pub(super) h: f64,
}

impl<const N: usize> Start<N> {
    /// The phase plus h times the stages' rates, each by its weight.
    #[inline(always)]
    pub(super) fn plus(
        &self,
        weights: &[f64],
        rates: &impl Index<usize, Output = Phase<N>>,
    ) -> Phase<N> {
        self.phase.plus(self.h, &combination(weights, rates))
    }
}

/// Sum of the stages' rates, each by its weight.
#[inline(always)]
pub(super) fn combination<const N: usize>(
    weights: &[f64],
    rates: &impl Index<usize, Output = Phase<N>>,
) -> Phase<N> {
    let mut sum = Phase::zeros();
    for (i, weight) in weights.iter().enumerate() {
        // A product with 0 could not be left out otherwise: a rate might be infinite.
        if *weight != 0.0 {
            sum = sum.plus(*weight, &rates[i]);
        }
    }
    sum
}

/// An integration under way, at the end of its last step.
pub(crate) struct Adaptive<M: Embedded<N>, const N: usize> {
    t: f64,
    phase: Phase<N>,
    h: f64,
    rates: M::Rates,
    last: Start<N>,
    fresh: bool,
    polynomial: Option<M::Polynomial>,
    tolerance: Tolerance,
    range: StepRange,
    control: StepControl,
    rejected: u64,
}

impl<M: Embedded<N>, const N: usize> Adaptive<M, N> {
    /// At the start, with a first guess of the step size.
    pub(crate) fn start<S: Equations<N>>(
        system: &S,
        t: f64,
        phase: Phase<N>,
        tolerance: Tolerance,
        range: StepRange,
    ) -> Result<Self, S::Refusal> {
        let rate = system.rate(t, &phase)?;
        Ok(Adaptive {
            t,
            phase,
            h: initial_step(system, t, &phase, &rate, &tolerance, M::CONTROL.order),
            rates: M::rates(rate),
            last: Start { t, phase, h: 0.0 },
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
    fn trial<S: Equations<N>>(&mut self, system: &S) -> Result<(Phase<N>, f64), S::Refusal> {
        let from = Start {
            t: self.t,
            phase: self.phase,
            h: self.h,
        };
        let end = M::trial(system, &from, &mut self.rates)?;
        let norm = |value: &Phase<N>| self.tolerance.norm(value, &self.phase, &end);
        let error = M::error(self.h, &self.rates, norm);
        if error <= 1.0 {
            M::finish(system, &from, &end, &mut self.rates)?;
        }
        Ok((end, error))
    }

    fn accept(&mut self, phase: Phase<N>, error: f64, end: Option<f64>) {
        self.last = Start {
            t: self.t,
            phase: self.phase,
            h: self.h,
        };
        self.fresh = true;
        self.polynomial = None;
        self.t = end.unwrap_or(self.t + self.h);
        self.phase = phase;
        self.h *= self.control.accept(error);
    }
}

impl<M: Embedded<N>, S: Equations<N>, const N: usize> Stepper<S, S::Refusal, N> for Adaptive<M, N> {
    fn t(&self) -> f64 {
        self.t
    }

    fn phase(&self) -> &Phase<N> {
        &self.phase
    }

    /// Makes one step, as long as the tolerance permits.
    ///
    /// A step on which the acceleration is refused is tried again shorter: the place where it is
    /// refused may lie beyond the end of the motion, or in a stage that a good step avoids.
    fn step(&mut self, system: &S, end: f64) -> Result<(), Failure<S::Refusal>> {
        // The stages of the last step are kept until here for its polynomial.
        if self.fresh {
            self.rates[0] = self.rates[M::LAST];
            self.fresh = false;
        }
        loop {
            let left = end - self.t;
            self.h = self.range.within(self.h);
            // Rather a step longer by a hundredth than a tiny one after it.
            let last = 1.01 * self.h >= left;
            if last {
                self.h = left;
            }
            let (error, failure) = match self.trial(system) {
                Ok((phase, error)) => {
                    if error <= 1.0 {
                        self.accept(phase, error, last.then_some(end));
                        return Ok(());
                    }
                    (error, Failure::StepTooSmall)
                }
                Err(refusal) => (f64::NAN, Failure::Refused(refusal)),
            };
            self.rejected += 1;
            self.h *= self.control.reject(error);
            if self.h < self.range.least {
                return Err(failure);
            }
        }
    }

    /// The phase at a time within the last step, by its polynomial.
    fn at(&mut self, system: &S, t: f64) -> Result<Phase<N>, Failure<S::Refusal>> {
        if t >= self.t {
            return Ok(self.phase);
        }
        let polynomial = match self.polynomial {
            Some(polynomial) => polynomial,
            None => M::polynomial(system, &self.last, &self.phase, &mut self.rates)?,
        };
        self.polynomial = Some(polynomial);
        Ok(M::evaluate(&polynomial, (t - self.last.t) / self.last.h))
    }

    fn retake(&mut self, system: &S, end: f64) -> Result<(), Failure<S::Refusal>> {
        let from = Start {
            h: end - self.last.t,
            ..self.last
        };
        // The first of the stages is still that of the step to be made again.
        self.phase = M::trial(system, &from, &mut self.rates)?;
        M::finish(system, &from, &self.phase, &mut self.rates)?;
        self.t = end;
        self.last = from;
        self.polynomial = None;
        Ok(())
    }

    fn restart(&mut self, system: &S, phase: Phase<N>) -> Result<(), Failure<S::Refusal>> {
        self.rates[0] = system.rate(self.t, &phase)?;
        self.phase = phase;
        self.fresh = false;
        Ok(())
    }

    fn rejected(&self) -> u64 {
        self.rejected
    }
}

#[cfg(test)]
mod tests {
    use core::convert::Infallible;

    use super::{Adaptive, Embedded};
    use crate::integrate::test_problems::{ACCELERATION, Acceleration, distance, solution, vector};
    use crate::integrate::{
        Dop853Method, DormandPrince54, Equations, Failure, Phase, StepRange, Stepper, Tolerance,
    };

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

    fn start<M: Embedded<1>>(value: f64) -> Adaptive<M, 1> {
        let Ok(run) = Adaptive::start(&ACCELERATION, 0.0, solution(0.0), tolerance(value), RANGE);
        run
    }

    /// The test problem at its start, with a given step size.
    fn with_step<M: Embedded<1>>(h: f64) -> Adaptive<M, 1> {
        let mut run = start::<M>(1e6);
        run.range.greatest = h;
        run.h = h;
        run
    }

    fn step<M: Embedded<1>>(run: &mut Adaptive<M, 1>) {
        run.step(&ACCELERATION, 2.0).unwrap();
    }

    fn at<M: Embedded<1>>(run: &mut Adaptive<M, 1>, t: f64) -> Phase<1> {
        run.at(&ACCELERATION, t).unwrap()
    }

    /// Errors of the end of two seconds and of the middles of the steps, at a fixed step size.
    fn errors<M: Embedded<1>>(steps: usize) -> (f64, f64) {
        let mut run = with_step::<M>(2.0 / steps as f64);
        let mut dense = 0.0_f64;
        while run.t < 2.0 {
            let before = run.t;
            step(&mut run);
            for s in [0.25, 0.5, 0.8] {
                let t = before + s * (run.t - before);
                dense = dense.max(distance(&at(&mut run, t), &solution(t)));
            }
        }
        (distance(&run.phase, &solution(2.0)).log2(), dense.log2())
    }

    #[test]
    fn dormand_prince_is_of_fifth_order_with_output_of_local_order_five() {
        let (coarse, fine) = (errors::<DormandPrince54>(40), errors::<DormandPrince54>(80));
        let order = coarse.0 - fine.0;
        assert!((order - 5.0).abs() < 0.2, "order {order}");
        // The polynomial is of fourth order: its own error within one step falls with h^5.
        let dense = coarse.1 - fine.1;
        assert!((dense - 5.0).abs() < 0.3, "dense order {dense}");
    }

    #[test]
    fn dop853_is_of_eighth_order_with_output_of_local_order_eight() {
        let (coarse, fine) = (errors::<Dop853Method>(8), errors::<Dop853Method>(16));
        let order = coarse.0 - fine.0;
        assert!((order - 8.0).abs() < 0.4, "order {order}");
        let dense = coarse.1 - fine.1;
        assert!((dense - 8.0).abs() < 0.5, "dense order {dense}");
    }

    fn check_output<M: Embedded<1>>() {
        let mut run = with_step::<M>(0.1);
        for before in [0.0, 0.1] {
            let from = run.phase;
            step(&mut run);
            assert_eq!(at(&mut run, before), from);
            let end = run.t;
            assert_eq!(at(&mut run, end), run.phase);
            let before_the_end = M::evaluate(&run.polynomial.unwrap(), 1.0);
            assert!(distance(&before_the_end, &run.phase) < 1e-15);
        }
    }

    #[test]
    fn output_meets_the_ends_of_the_step() {
        check_output::<DormandPrince54>();
        check_output::<Dop853Method>();
    }

    fn check_tolerance<M: Embedded<1>>(least: f64) {
        for value in [1e-4, 1e-7, 1e-10] {
            let mut run = start::<M>(value);
            while run.t < 2.0 {
                step(&mut run);
            }
            assert_eq!(run.t, 2.0);
            let error = distance(&run.phase, &solution(2.0));
            assert!((least * value..10.0 * value).contains(&error), "{error:e}");
        }
    }

    #[test]
    fn error_follows_the_tolerance() {
        check_tolerance::<DormandPrince54>(1e-2);
        // Its estimate is of lower order than its error.
        check_tolerance::<Dop853Method>(1e-4);
    }

    fn failure<M: Embedded<1>, S: Equations<1>>(
        system: &S,
        start: Phase<1>,
    ) -> (f64, Failure<S::Refusal>) {
        let Ok(mut run) = Adaptive::<M, 1>::start(system, 0.0, start, tolerance(1e-6), RANGE)
        else {
            panic!("refused at the start");
        };
        loop {
            if let Err(failure) = run.step(system, 2.0) {
                return (run.t, failure);
            }
        }
    }

    #[test]
    fn a_wall_is_reached_and_not_crossed() {
        let wall = |t: f64, _: &Phase<1>| if t < 1.0 { Ok(vector(t)) } else { Err("wall") };
        for (t, failure) in [
            failure::<DormandPrince54, _>(&wall, Phase::zeros()),
            failure::<Dop853Method, _>(&wall, Phase::zeros()),
        ] {
            assert_eq!(failure, Failure::Refused("wall"));
            assert!(t < 1.0 && t > 1.0 - 1e-12, "{t}");
        }
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
        for (t, failure) in [
            failure::<DormandPrince54, _>(&pole, start),
            failure::<Dop853Method, _>(&pole, start),
        ] {
            assert_eq!(failure, Failure::StepTooSmall);
            // The place of the pole is as accurate as the steps before it.
            assert!((t - 1.0).abs() < 1e-5, "{t}");
        }
    }

    /// From rest with an acceleration that is even in time, embedded differences may vanish: the
    /// first step must be short all the same, and the steps after it no longer than each permits.
    fn check_rest<M: Embedded<1>>() {
        let swing = |_: f64, phase: &Phase<1>| Ok::<_, Infallible>(vector(-phase.q[0].cos()));
        let range = StepRange {
            greatest: f64::INFINITY,
            ..RANGE
        };
        let Ok(mut run) =
            Adaptive::<M, 1>::start(&swing, 0.0, Phase::zeros(), tolerance(1e-9), range);
        let mut steps = 0;
        while run.t < 10.0 {
            run.step(&swing, 10.0).unwrap();
            steps += 1;
        }
        assert!(steps > 10, "{steps}");
        let energy = 0.5 * run.phase.qd[0].powi(2) + run.phase.q[0].sin();
        assert!(energy.abs() < 1e-7, "{energy}");
    }

    #[test]
    fn a_start_from_rest_is_not_stepped_over() {
        check_rest::<DormandPrince54>();
        check_rest::<Dop853Method>();
    }

    /// Stages, rates at the ends and stages of the output.
    #[test]
    fn evaluations_are_those_of_the_method() {
        let count = core::cell::Cell::new(0);
        let counted = |t: f64, phase: &Phase<1>| {
            count.set(count.get() + 1);
            let acceleration: Acceleration = ACCELERATION;
            acceleration(t, phase)
        };
        let Ok(mut run) =
            Adaptive::<Dop853Method, 1>::start(&counted, 0.0, solution(0.0), tolerance(1e6), RANGE);
        count.set(0);
        run.step(&counted, 1.0).unwrap();
        assert_eq!(count.replace(0), 12);
        for t in [0.3, 0.5] {
            run.at(&counted, t * run.t).unwrap();
        }
        assert_eq!(count.get(), 3);
    }
}
