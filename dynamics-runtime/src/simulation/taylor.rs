//! Integration by Taylor series.

use nalgebra::SVector;

use super::drive::smooth;
use super::error::{Cause, InvalidSetting, SimulationError};
use super::plan::Plan;
use super::recorder::Recorder;
use super::settings::ErrorControl;
use super::trajectory::Trajectory;
use crate::TaylorDynamics;
use crate::friction::DryFriction;
use crate::integrate::{Phase, Tolerance, first_non_finite};
use crate::taylor::{FEWEST_ORDERS, SeriesStepper, Steady, order};

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

    fn control(&self) -> ErrorControl {
        ErrorControl {
            tolerance: Tolerance {
                relative: self.relative_tolerance,
                absolute: self.absolute_tolerance,
            },
            max_step: self.max_step,
            least_steps: 10.0,
            max_steps: self.max_steps,
        }
    }

    fn validate(&self, duration: f64) -> Result<(), InvalidSetting> {
        self.control().validate(duration)?;
        match (FEWEST_ORDERS..=crate::MAX_TAYLOR_ORDER).contains(&self.order()) {
            true => Ok(()),
            false => Err(InvalidSetting::Order(self.order())),
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
        recorder.sample();
        let control = self.settings.control();
        let range = control.range(self.plan.duration);
        let motion = Steady {
            robot: self.robot,
            tau: self.tau,
        };
        let (start, order) = (self.plan.initial, self.settings.order());
        let run = SeriesStepper::start(&motion, start, order, control.tolerance, range)?;
        smooth(&motion, run, recorder, control.max_steps).map_err(Cause::of_long_steps)
    }

    fn validate(&self) -> Result<(), Cause> {
        self.plan.validate()?;
        if let Some(joint) = first_non_finite(&self.tau) {
            return Err(Cause::NonFiniteTorque { joint });
        }
        let rows = self.robot.table().rows;
        if let Some(joint) = rows.iter().position(|row| !DryFriction::of(row).is_none()) {
            return Err(InvalidSetting::CoulombFriction { joint }.into());
        }
        Ok(self.settings.validate(self.plan.duration)?)
    }
}
