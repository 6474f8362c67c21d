//! The Radau IIA method of order 5, for stiff equations.
//!
//! E. Hairer, G. Wanner, *Solving Ordinary Differential Equations II*, 2nd edition, section IV.8, and
//! their program RADAU5: a simplified Newton iteration on transformed stages, an error estimate of
//! order 3 that is filtered by the Jacobian, and predictive step control. That q' is the velocity
//! halves the systems of equations ([`Shifted`]).

use nalgebra::Complex;

use super::initial_step::initial_step;
use super::jacobian::{Jacobian, Shifted};
use super::radau_tableau::{C, COMPLEX, ERROR, REAL, T, T_INVERSE};
use super::{Equations, Failure, Phase, StepRange, Stepper, Tolerance};

/// An integration under way, at the end of its last step.
pub(crate) struct Radau<const N: usize> {
    t: f64,
    phase: Phase<N>,
    rate: Phase<N>,
    /// Where the last step started.
    from: Place<N>,
    h: f64,
    jacobian: Jacobian<N>,
    jacobian_is: Age,
    polynomial: Option<Polynomial<N>>,
    before: Option<Accepted>,
    tolerance: Tolerance,
    newton_tolerance: f64,
    /// What is left of an error over the last correction, and the ratio of the last two
    /// corrections, as the last Newton iteration had them.
    left_over: f64,
    theta: f64,
    range: StepRange,
    rejected: u64,
    just_rejected: bool,
}

/// A time, the phase then, and how it moves.
#[derive(Clone, Copy)]
struct Place<const N: usize> {
    t: f64,
    phase: Phase<N>,
    rate: Phase<N>,
}

/// Whether the Jacobian is that of the place reached.
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

/// The polynomial through the stages of a step that ends at `end`.
#[derive(Clone, Copy)]
struct Polynomial<const N: usize> {
    end: f64,
    h: f64,
    coefficients: [Phase<N>; 4],
}

/// A step that was tried.
struct Trial<const N: usize> {
    /// Changes of the phase from the start to the stages.
    changes: [Phase<N>; 3],
    error: f64,
    iterations: u32,
}

/// Why a trial gave no step.
enum Miss<E> {
    Refused(E),
    /// The Newton iteration converges too slowly; a step shorter by the factor may do.
    Newton(f64),
}

impl<E> From<E> for Miss<E> {
    fn from(refusal: E) -> Self {
        Miss::Refused(refusal)
    }
}

const MOST_ITERATIONS: u32 = 7;
/// A Newton iteration that converges so fast keeps its Jacobian for the next step.
const FAST: f64 = 1e-3;
const SAFETY: f64 = 0.9;
/// Bounds of the old step over the new one.
const QUOTIENTS: (f64, f64) = (1.0 / 8.0, 5.0);

impl<const N: usize> Radau<N> {
    /// At the start, with a first guess of the step size.
    pub(crate) fn start<S: Equations<N>>(
        system: &S,
        t: f64,
        phase: Phase<N>,
        wanted: Tolerance,
        range: StepRange,
    ) -> Result<Self, S::Refusal> {
        let rate = system.rate(t, &phase)?;
        // The estimate is of order 3 and the result of order 5.
        let relative = 0.1 * wanted.relative.powf(2.0 / 3.0);
        let tolerance = Tolerance {
            relative,
            absolute: relative * (wanted.absolute / wanted.relative),
        };
        let least = 10.0 * f64::EPSILON / relative;
        Ok(Radau {
            t,
            phase,
            rate,
            from: Place { t, phase, rate },
            h: initial_step(system, t, &phase, &rate, &wanted, 4.0),
            jacobian: Jacobian::zeros(),
            jacobian_is: Age::Useless,
            polynomial: None,
            before: None,
            tolerance,
            newton_tolerance: least.max(relative.sqrt().min(0.03)),
            left_over: 1.0,
            theta: 1.0,
            range,
            rejected: 0,
            just_rejected: false,
        })
    }

    /// The stages of a step of length `h` and its error.
    fn trial<S: Equations<N>>(&mut self, system: &S) -> Result<Trial<N>, Miss<S::Refusal>> {
        if self.jacobian_is == Age::Useless {
            self.jacobian = Jacobian::at(system, self.t, &self.phase, &self.rate.qd)?;
            self.jacobian_is = Age::Fresh;
        }
        let real = Shifted::new(REAL / self.h, &self.jacobian);
        let complex = Shifted::new(COMPLEX / self.h, &self.jacobian);
        let (changes, iterations) = self.newton(system, &real, &complex)?;
        let error = self.error(system, &changes, &real)?;
        Ok(Trial {
            changes,
            error,
            iterations,
        })
    }

    /// Solves `z = h A f(y + z)` for the stages' changes z by the transformed equations, in which the
    /// stages come apart: `D / h w = T^-1 f(y + T w)`.
    fn newton<S: Equations<N>>(
        &mut self,
        system: &S,
        real: &Shifted<f64, N>,
        complex: &Shifted<Complex<f64>, N>,
    ) -> Result<([Phase<N>; 3], u32), Miss<S::Refusal>> {
        let (gamma, alpha, beta) = (REAL / self.h, COMPLEX.re / self.h, COMPLEX.im / self.h);
        let mut z = self.predicted();
        let mut w = transformed(&T_INVERSE, &z);
        self.left_over = self.left_over.max(f64::EPSILON).powf(0.8);
        self.theta = FAST;
        let (mut before, mut quotient_before) = (0.0, 0.0);
        for k in 0..MOST_ITERATIONS {
            let mut rates = z;
            for i in 0..3 {
                let phase = self.phase.plus(1.0, &z[i]);
                rates[i] = system.rate(self.t + C[i] * self.h, &phase)?;
            }
            let [f1, f2, f3] = transformed(&T_INVERSE, &rates);
            let d1 = real.solve(&f1.plus(-gamma, &w[0]));
            let (d2, d3) = complex.solve(
                &f2.plus(-alpha, &w[1]).plus(beta, &w[2]),
                &f3.plus(-alpha, &w[2]).plus(-beta, &w[1]),
            );
            let size = self.size(&[d1, d2, d3]);
            if k > 0 {
                let quotient = size / before;
                self.converges(k, size, quotient, quotient_before)?;
                quotient_before = quotient;
            }
            before = size.max(f64::MIN_POSITIVE);
            w = [
                w[0].plus(1.0, &d1),
                w[1].plus(1.0, &d2),
                w[2].plus(1.0, &d3),
            ];
            z = transformed(&T, &w);
            if self.left_over * size <= self.newton_tolerance {
                return Ok((z, k + 1));
            }
        }
        Err(Miss::Newton(0.5))
    }

    /// Judges the Newton iteration by the ratio of its last two corrections, and of the two before
    /// (IV.8.10, IV.8.11).
    fn converges<E>(&mut self, k: u32, size: f64, ratio: f64, before: f64) -> Result<(), Miss<E>> {
        self.theta = if k == 1 {
            ratio
        } else {
            (ratio * before).sqrt()
        };
        // In doubt, for what is not a number, shorter.
        if self.theta.is_nan() || self.theta >= 0.99 {
            return Err(Miss::Newton(0.5));
        }
        self.left_over = self.theta / (1.0 - self.theta);
        let left = MOST_ITERATIONS as i32 - 2 - k as i32;
        let expected = self.left_over * size * self.theta.powi(left) / self.newton_tolerance;
        if expected < 1.0 {
            return Ok(());
        }
        let exponent = -1.0 / f64::from(4 + left);
        Err(Miss::Newton(0.8 * expected.min(20.0).powf(exponent)))
    }

    /// The stages' changes that the polynomial of the step before predicts.
    fn predicted(&self) -> [Phase<N>; 3] {
        let Some(polynomial) = self.polynomial.filter(|_| !self.just_rejected) else {
            return [Phase::zeros(); 3];
        };
        C.map(|c| polynomial.at(self.t + c * self.h).minus(&self.phase))
    }

    /// Root mean square over all stages, each entry over its tolerance.
    fn size(&self, stages: &[Phase<N>; 3]) -> f64 {
        let squares = stages.iter().map(|stage| self.norm(stage).powi(2));
        (squares.sum::<f64>() / 3.0).sqrt()
    }

    fn norm(&self, value: &Phase<N>) -> f64 {
        self.tolerance.norm(value, &self.phase, &self.phase)
    }

    /// (IV.8.19) and (IV.8.20): `(gamma / h - J)^-1 (f(y) + e.z / h)`, and once more from there at the
    /// start and after a rejected step, where the estimate of a very stiff component is too large.
    fn error<S: Equations<N>>(
        &self,
        system: &S,
        changes: &[Phase<N>; 3],
        real: &Shifted<f64, N>,
    ) -> Result<f64, S::Refusal> {
        let weighted = combination(&ERROR, changes).scaled(1.0 / self.h);
        let estimate = real.solve(&weighted.plus(1.0, &self.rate));
        let error = self.norm(&estimate).max(1e-10);
        if error < 1.0 || !(self.before.is_none() || self.just_rejected) {
            return Ok(error);
        }
        let ahead = self.phase.plus(1.0, &estimate);
        let rate = system.rate(self.t, &ahead)?;
        let estimate = real.solve(&weighted.plus(1.0, &rate));
        Ok(self.norm(&estimate).max(1e-10))
    }

    /// The old step over the one that the error asks for, the fewer iterations the longer; after
    /// Gustafsson (1994) from the errors of two steps.
    fn quotient(&self, trial: &Trial<N>) -> f64 {
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

    fn accept<S: Equations<N>>(
        &mut self,
        system: &S,
        trial: &Trial<N>,
        end: f64,
    ) -> Result<(), S::Refusal> {
        let phase = self.phase.plus(1.0, &trial.changes[2]);
        let rate = system.rate(end, &phase)?;
        let quotient = self.quotient(trial);
        self.polynomial = Some(Polynomial::new(end, self.h, &phase, &trial.changes));
        self.before = Some(Accepted {
            h: self.h,
            error: trial.error.max(1e-2),
        });
        self.from = Place {
            t: self.t,
            phase: self.phase,
            rate: self.rate,
        };
        (self.t, self.phase, self.rate) = (end, phase, rate);
        // A step that just failed is not followed by a longer one.
        self.h /= if self.just_rejected {
            quotient.max(1.0)
        } else {
            quotient
        };
        self.just_rejected = false;
        self.jacobian_is = if self.theta <= FAST {
            Age::Old
        } else {
            Age::Useless
        };
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

impl<S: Equations<N>, const N: usize> Stepper<S, S::Refusal, N> for Radau<N> {
    fn t(&self) -> f64 {
        self.t
    }

    fn phase(&self) -> &Phase<N> {
        &self.phase
    }

    fn step(&mut self, system: &S, end: f64) -> Result<(), Failure<S::Refusal>> {
        loop {
            let left = end - self.t;
            self.h = self.range.within(self.h);
            let last = 1.01 * self.h >= left;
            if last {
                self.h = left;
            }
            let step_end = if last { end } else { self.t + self.h };
            let failure = match self.trial(system) {
                Ok(trial) if trial.error < 1.0 => match self.accept(system, &trial, step_end) {
                    Ok(()) => return Ok(()),
                    Err(refusal) => {
                        self.shorten(0.2);
                        Failure::Refused(refusal)
                    }
                },
                Ok(trial) => {
                    let first = self.before.is_none();
                    let factor = if first {
                        0.1
                    } else {
                        1.0 / self.quotient(&trial)
                    };
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
                return Err(failure);
            }
        }
    }

    fn at(&mut self, _: &S, t: f64) -> Result<Phase<N>, Failure<S::Refusal>> {
        Ok(match self.polynomial {
            Some(polynomial) if t < self.t => polynomial.at(t),
            _ => self.phase,
        })
    }

    fn retake(&mut self, system: &S, end: f64) -> Result<(), Failure<S::Refusal>> {
        let Place { t, phase, rate } = self.from;
        (self.t, self.phase, self.rate) = (t, phase, rate);
        let next = self.h;
        self.h = end - t;
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

    fn restart(&mut self, system: &S, phase: Phase<N>) -> Result<(), Failure<S::Refusal>> {
        self.rate = system.rate(self.t, &phase)?;
        self.phase = phase;
        self.polynomial = None;
        self.before = None;
        self.jacobian_is = Age::Useless;
        Ok(())
    }

    fn rejected(&self) -> u64 {
        self.rejected
    }
}

impl<const N: usize> Polynomial<N> {
    /// Newton's interpolation through the start and the stages, from the end backwards.
    fn new(end: f64, h: f64, phase: &Phase<N>, [z1, z2, z3]: &[Phase<N>; 3]) -> Self {
        let [c1, c2, _] = C;
        let third = z2.minus(z3).scaled(1.0 / (c2 - 1.0));
        let second = z1.minus(z2).scaled(1.0 / (c1 - c2));
        let bend = second.minus(&third).scaled(1.0 / (c1 - 1.0));
        let first = second.minus(&z1.scaled(1.0 / c1)).scaled(1.0 / c2);
        Polynomial {
            end,
            h,
            coefficients: [*phase, third, bend, bend.minus(&first)],
        }
    }

    /// y = r1 + s (r2 + (s + 1 - c2) (r3 + (s + 1 - c1) r4)), s from -1 to 0 over the step.
    fn at(&self, t: f64) -> Phase<N> {
        let s = (t - self.end) / self.h;
        let [r1, r2, r3, r4] = &self.coefficients;
        let inner = r3.plus(s + 1.0 - C[0], r4);
        r1.plus(s, &r2.plus(s + 1.0 - C[1], &inner))
    }
}

/// Sum of three phases, each by its weight.
fn combination<const N: usize>(weights: &[f64; 3], of: &[Phase<N>; 3]) -> Phase<N> {
    of[0]
        .scaled(weights[0])
        .plus(weights[1], &of[1])
        .plus(weights[2], &of[2])
}

fn transformed<const N: usize>(by: &[[f64; 3]; 3], of: &[Phase<N>; 3]) -> [Phase<N>; 3] {
    by.map(|row| combination(&row, of))
}

#[cfg(test)]
mod tests {
    use core::cell::Cell;
    use core::convert::Infallible;

    use super::Radau;
    use crate::integrate::test_problems::{ACCELERATION, distance, solution, vector};
    use crate::integrate::{Failure, Phase, StepRange, Stepper, Tolerance};

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

    /// Errors of the end of two seconds and within the steps, at a fixed step size.
    fn errors(steps: usize) -> (f64, f64) {
        let h = 2.0 / steps as f64;
        let Ok(mut run) = Radau::start(&ACCELERATION, 0.0, solution(0.0), tolerance(1e-13), RANGE);
        run.newton_tolerance = 1e-6;
        // No error is too large.
        run.tolerance = tolerance(1e-6);
        run.range.greatest = h;
        let mut dense = 0.0_f64;
        while run.t < 2.0 {
            let before = run.t;
            run.h = h;
            run.step(&ACCELERATION, 2.0).unwrap();
            assert_eq!(run.rejected, 0);
            for s in [0.25, 0.5, 0.8] {
                let t = before + s * (run.t - before);
                let at = run.at(&ACCELERATION, t).unwrap();
                dense = dense.max(distance(&at, &solution(t)));
            }
        }
        (distance(&run.phase, &solution(2.0)).log2(), dense.log2())
    }

    #[test]
    fn is_of_fifth_order_with_output_of_local_order_four() {
        let (coarse, fine) = (errors(80), errors(160));
        let order = coarse.0 - fine.0;
        assert!((order - 5.0).abs() < 0.3, "order {order}");
        let dense = coarse.1 - fine.1;
        assert!((dense - 4.0).abs() < 0.3, "dense order {dense}");
    }

    #[test]
    fn output_meets_the_ends_of_the_step() {
        let Ok(mut run) = Radau::start(&ACCELERATION, 0.0, solution(0.0), tolerance(1e-6), RANGE);
        run.step(&ACCELERATION, 2.0).unwrap();
        let (start, end) = (
            run.polynomial.unwrap().at(0.0),
            run.polynomial.unwrap().at(run.t),
        );
        assert!(distance(&start, &solution(0.0)) < 1e-15);
        assert!(distance(&end, &run.phase) < 1e-15);
    }

    #[test]
    fn error_follows_the_tolerance() {
        for value in [1e-4, 1e-7, 1e-10] {
            let Ok(mut run) =
                Radau::start(&ACCELERATION, 0.0, solution(0.0), tolerance(value), RANGE);
            while run.t < 2.0 {
                run.step(&ACCELERATION, 2.0).unwrap();
            }
            assert_eq!(run.t, 2.0);
            let error = distance(&run.phase, &solution(2.0));
            assert!((1e-3 * value..10.0 * value).contains(&error), "{error:e}");
        }
    }

    /// q'' = -b q' - G sin q with b = 10^6, G = 10^3, from rest: q lags by G sin(1) / b^2 behind the
    /// solution 2 atan(tan(1/2) exp(-G t / b)) of b q' = -G sin q, up to the next order of 1/b.
    #[test]
    fn stiff_friction_takes_few_evaluations() {
        let count = Cell::new(0);
        let law = |_: f64, p: &Phase<1>| {
            count.set(count.get() + 1);
            Ok::<_, Infallible>(vector(-1e6 * p.qd[0] - 1e3 * p.q[0].sin()))
        };
        let start = Phase {
            q: vector(1.0),
            qd: vector(0.0),
        };
        let Ok(mut run) = Radau::start(&law, 0.0, start, tolerance(1e-8), RANGE);
        while run.t < 1.0 {
            run.step(&law, 1.0).unwrap();
        }
        let exact = 2.0 * (0.5_f64.tan() * (-1e-3_f64).exp()).atan() + 1e-9 * 1.0_f64.sin();
        let error = run.phase.q[0] - exact;
        assert!(error.abs() < 2e-11, "{error:e}");
        assert!(count.get() < 400, "{}", count.get());
    }

    #[test]
    fn a_wall_is_reached_and_not_crossed() {
        let wall = |t: f64, _: &Phase<1>| if t < 1.0 { Ok(vector(t)) } else { Err("wall") };
        let mut run = Radau::start(&wall, 0.0, Phase::zeros(), tolerance(1e-6), RANGE).unwrap();
        let failure = loop {
            if let Err(failure) = run.step(&wall, 2.0) {
                break failure;
            }
        };
        assert_eq!(failure, Failure::Refused("wall"));
        assert!(run.t < 1.0 && run.t > 1.0 - 1e-12, "{}", run.t);
    }
}
