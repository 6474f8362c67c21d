//! The methods of integration and their settings.

use nalgebra::SVector;

use super::fixed_step::fixed_step;
use super::trajectory::Recorder;
use super::{Cause, InvalidSetting};
use crate::integrate::{Phase, craig_euler, rk4, semi_implicit_euler};

/// A method of integration.
///
/// The methods of fixed step divide the interval between two samples into the least whole number of
/// equal steps that are no longer than `step`, so that every sample is the end of a step. An
/// interval of 0.2 s and a step of 1 ms give 200 steps of 1 ms. A `step` longer than the interval
/// gives one step; an infinite one is an error all the same, for it says nothing of the accuracy
/// that is wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Method {
    /// Euler's scheme as Craig has it, (6.117): `qd+ = qd + qdd h`, `q+ = q + qd h + qdd h^2 / 2`
    /// with the old velocity in the second equation. First order.
    CraigEuler {
        /// The longest step, s: positive and finite.
        step: f64,
    },
    /// The semi-implicit Euler scheme: `qd+ = qd + qdd h`, `q+ = q + qd+ h`. First order.
    SemiImplicitEuler {
        /// The longest step, s: positive and finite.
        step: f64,
    },
    /// The classical Runge-Kutta method. Fourth order.
    RungeKutta4 {
        /// The longest step, s: positive and finite.
        step: f64,
    },
    /// The Dormand-Prince method of order 5(4) with error control and dense output.
    DormandPrince(DormandPrince),
}

impl Default for Method {
    /// [`DormandPrince`] with its default settings.
    fn default() -> Self {
        Method::DormandPrince(DormandPrince::default())
    }
}

/// Settings of the Dormand-Prince method of order 5(4), known as `ode45` and `RK45`.
///
/// A step is as long as its estimated error in each position and velocity y stays below
/// `absolute_tolerance + relative_tolerance |y|`. The error of a whole run grows with its length
/// and with the motion's own sensitivity. Samples between the steps are taken from a polynomial of
/// fourth order.
///
/// Dry friction is discontinuous in the velocity: a joint that sticks makes the steps minute, and
/// the run ends with [`Cause::TooManySteps`]. Use a method of fixed step there, or a smooth law of
/// friction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DormandPrince {
    /// Relative tolerance of a step.
    pub relative_tolerance: f64,
    /// Absolute tolerance of a step, rad or m, and per second.
    pub absolute_tolerance: f64,
    /// The longest step, s; `None` for a fiftieth of the duration, infinity for no bound.
    ///
    /// The estimate vanishes in an arm at rest, and steps would become as long as the run: a torque
    /// that comes and goes within one step would never be seen.
    pub max_step: Option<f64>,
    /// The greatest number of steps between two samples.
    pub max_steps: usize,
}

impl DormandPrince {
    /// One value for both tolerances, the other settings as by default.
    pub fn with_tolerance(tolerance: f64) -> Self {
        DormandPrince {
            relative_tolerance: tolerance,
            absolute_tolerance: tolerance,
            max_step: None,
            max_steps: 100_000,
        }
    }

    pub(super) fn longest_step(&self, duration: f64) -> f64 {
        self.max_step.unwrap_or(duration / 50.0)
    }
}

impl Default for DormandPrince {
    /// Tolerances of 1e-9, steps of up to a fiftieth of the duration, at most 100 000 of them
    /// between two samples.
    fn default() -> Self {
        DormandPrince::with_tolerance(1e-9)
    }
}

impl From<DormandPrince> for Method {
    fn from(settings: DormandPrince) -> Self {
        Method::DormandPrince(settings)
    }
}

impl Method {
    pub(super) fn integrate<const N: usize>(
        &self,
        acceleration: &impl Fn(f64, &Phase<N>) -> Result<SVector<f64, N>, Cause>,
        recorder: &mut Recorder<N>,
    ) -> Result<(), Cause> {
        match self {
            Method::CraigEuler { step } => fixed_step(recorder, *step, |t, p, h| {
                craig_euler(acceleration, t, p, h)
            }),
            Method::SemiImplicitEuler { step } => fixed_step(recorder, *step, |t, p, h| {
                semi_implicit_euler(acceleration, t, p, h)
            }),
            Method::RungeKutta4 { step } => {
                fixed_step(recorder, *step, |t, p, h| rk4(acceleration, t, p, h))
            }
            Method::DormandPrince(settings) => settings.integrate(acceleration, recorder),
        }
    }

    pub(super) fn validate(&self, duration: f64) -> Result<(), InvalidSetting> {
        match self {
            Method::CraigEuler { step }
            | Method::SemiImplicitEuler { step }
            | Method::RungeKutta4 { step } => validate_step(*step, duration),
            Method::DormandPrince(settings) => {
                let tolerances = [settings.relative_tolerance, settings.absolute_tolerance];
                for tolerance in tolerances {
                    if !(tolerance > 0.0 && tolerance.is_finite()) {
                        return Err(InvalidSetting::Tolerance(tolerance));
                    }
                }
                let longest = settings.longest_step(duration);
                match longest {
                    f64::INFINITY => Ok(()),
                    _ => validate_step(longest, duration),
                }
            }
        }
    }
}

/// A step that is lost in the rounding of the time would never end.
fn validate_step(step: f64, duration: f64) -> Result<(), InvalidSetting> {
    if step > duration * f64::EPSILON && step.is_finite() {
        Ok(())
    } else {
        Err(InvalidSetting::Step(step))
    }
}
