//! Integration by Taylor series.

use nalgebra::SVector;

use super::method::of_long_steps;
use super::plan::Plan;
use super::trajectory::Recorder;
use super::{Cause, InvalidSetting, SimulationError, Trajectory};
use crate::TaylorDynamics;
use crate::integrate::{Phase, StepRange, Tolerance, first_non_finite};
use crate::taylor::{Stepper, order};

/// Settings of the Taylor method.
///
/// A step is as long as the last terms of the series of each position and velocity y stay below
/// `absolute_tolerance + relative_tolerance |y|`; the error of a step is a few times smaller. The
/// error of a whole run grows with its length and with the motion's own sensitivity. Sums of steps
/// are compensated, so that a tolerance of 1e-16 makes sense: the error is then that of rounding
/// the equations. Samples between the steps are taken from the series, as accurate as its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Taylor {
    /// Relative tolerance of a step.
    pub relative_tolerance: f64,
    /// Absolute tolerance of a step, rad or m, and per second.
    pub absolute_tolerance: f64,
    /// The order of the series, 8 to [`MAX_TAYLOR_ORDER`](crate::MAX_TAYLOR_ORDER); `None` for the
    /// one that suits the tolerance.
    pub order: Option<usize>,
    /// The longest step, s; `None` for a tenth of the duration, infinity for no bound.
    pub max_step: Option<f64>,
    /// The greatest number of steps between two samples.
    pub max_steps: usize,
}

impl Taylor {
    /// One value for both tolerances, the other settings as by default.
    pub fn with_tolerance(tolerance: f64) -> Self {
        Taylor {
            relative_tolerance: tolerance,
            absolute_tolerance: tolerance,
            order: None,
            max_step: None,
            max_steps: 100_000,
        }
    }

    fn order(&self) -> usize {
        let tolerance = self.relative_tolerance.min(self.absolute_tolerance);
        self.order.unwrap_or_else(|| order(tolerance))
    }

    fn longest_step(&self, duration: f64) -> f64 {
        self.max_step.unwrap_or(duration / 10.0)
    }

    fn validate(&self, duration: f64) -> Result<(), InvalidSetting> {
        for tolerance in [self.relative_tolerance, self.absolute_tolerance] {
            if !(tolerance > 0.0 && tolerance.is_finite()) {
                return Err(InvalidSetting::Tolerance(tolerance));
            }
        }
        if !(order(1.0)..=crate::MAX_TAYLOR_ORDER).contains(&self.order()) {
            return Err(InvalidSetting::Order(self.order()));
        }
        let longest = self.longest_step(duration);
        match longest > duration * f64::EPSILON {
            true => Ok(()),
            false => Err(InvalidSetting::Step(longest)),
        }
    }
}

impl Default for Taylor {
    /// Tolerances of 1e-12, steps of up to a tenth of the duration, at most 100 000 of them between
    /// two samples.
    fn default() -> Self {
        Taylor::with_tolerance(1e-12)
    }
}

/// A simulation of an arm by the Taylor method, of high order and with long steps: for accurate
/// motions, of 1e-8 and better, under a constant torque.
///
/// The method differentiates the equations of motion along the motion, so that it has to know them:
/// a torque law, a Rust function of time or state, has no derivatives. Torques are therefore
/// constant over a run; where they change at known times (a controller that samples and holds), a
/// run for each interval starts where the last one ended. Viscous friction belongs to the equations
/// and is included. Coulomb friction jumps where a joint reverses, where no series goes across: an
/// arm that has it is refused. For laws and friction of any kind use
/// [`Simulation`](crate::Simulation).
///
/// As it is made, the arm starts from rest at q = 0, moves freely for 1 s and is sampled 101 times.
#[derive(Clone, Debug)]
#[must_use]
pub struct TaylorSimulation<'a, R, const N: usize> {
    robot: &'a R,
    tau: SVector<f64, N>,
    settings: Taylor,
    plan: Plan<N>,
}

impl<'a, R, const N: usize> TaylorSimulation<'a, R, N>
where
    R: TaylorDynamics<N>,
{
    /// Free motion of the arm.
    pub fn new(robot: &'a R) -> Self {
        TaylorSimulation {
            robot,
            tau: SVector::zeros(),
            settings: Taylor::default(),
            plan: Plan::new(),
        }
    }

    /// The constant joint torques, N m or N.
    pub fn torque(self, tau: SVector<f64, N>) -> Self {
        TaylorSimulation { tau, ..self }
    }

    /// Tolerances, order and bounds of the steps.
    pub fn settings(self, settings: Taylor) -> Self {
        TaylorSimulation { settings, ..self }
    }

    /// Positions and velocities at t = 0.
    pub fn initial(mut self, q: SVector<f64, N>, qd: SVector<f64, N>) -> Self {
        self.plan.initial = Phase { q, qd };
        self
    }

    /// The time simulated, s.
    pub fn duration(mut self, duration: f64) -> Self {
        self.plan.duration = duration;
        self
    }

    /// The number of samples, at equal intervals, the first at t = 0 and the last at the end.
    pub fn samples(mut self, samples: usize) -> Self {
        self.plan.samples = samples;
        self
    }

    /// Runs the simulation. It allocates the samples and the room for one series at the start and
    /// nothing later.
    ///
    /// # Errors
    ///
    /// [`SimulationError`], with the time and the state reached and all samples up to there, where
    /// a setting is invalid or the arm has Coulomb friction, where the motion reaches a singular
    /// mass matrix or an acceleration or a state that is not finite, and where no step fits the
    /// equations ([`Cause`]). Never panics.
    pub fn run(&self) -> Result<Trajectory<N>, Box<SimulationError<N>>> {
        let mut recorder = Recorder::new(self.plan.initial);
        let end = self.record(&mut recorder);
        // One series for each step.
        let series = recorder.work.steps;
        recorder.finished(end, series)
    }

    fn record(&self, recorder: &mut Recorder<N>) -> Result<(), Cause> {
        self.validate()?;
        recorder.plan(&self.plan)?;
        let Taylor {
            relative_tolerance: relative,
            absolute_tolerance: absolute,
            max_steps,
            ..
        } = self.settings;
        let range = StepRange {
            // A few roundings of the time.
            least: 16.0 * f64::EPSILON * self.plan.duration,
            greatest: self.settings.longest_step(self.plan.duration),
        };
        let tolerance = Tolerance { relative, absolute };
        let order = self.settings.order();
        recorder.sample();
        let (robot, start) = (self.robot, self.plan.initial);
        let mut run = Stepper::start(robot, start, self.tau, order, tolerance, range)?;
        while let Some(t) = recorder.next_sample() {
            let mut steps = 0;
            while run.t < t {
                if steps == max_steps {
                    return Err(Cause::TooManySteps);
                }
                let made = run.step(self.plan.duration);
                recorder.work.rejected = run.rejected;
                made.map_err(|failure| of_long_steps(failure.into()))?;
                recorder.reach(run.t, run.phase)?;
                steps += 1;
            }
            recorder.push(t, run.at(t));
        }
        Ok(())
    }

    fn validate(&self) -> Result<(), Cause> {
        self.plan.validate()?;
        if let Some(joint) = first_non_finite(&self.tau) {
            return Err(Cause::NonFiniteTorque { joint });
        }
        let rows = self.robot.table().rows;
        if let Some(joint) = rows.iter().position(|row| row.coulomb != 0.0) {
            return Err(InvalidSetting::CoulombFriction { joint }.into());
        }
        Ok(self.settings.validate(self.plan.duration)?)
    }
}
