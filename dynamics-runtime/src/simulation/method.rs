//! The methods of integration.

use super::drive::drive;
use super::motion::Motion;
use super::settings::{Dop853, DormandPrince, ErrorControl, validate_step};
use super::trajectory::Recorder;
use super::{Cause, InvalidSetting, TorqueLaw};
use crate::ForwardDynamics;
use crate::integrate::{
    Adaptive, CraigEuler, Dop853Method, DormandPrince54, Embedded, ExplicitEuler, FixedStep,
    OneStep, Rk4, SemiImplicitEuler,
};

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
    /// Euler's explicit method: `qd+ = qd + qdd h`, `q+ = q + qd h`. First order.
    ///
    /// It is here to be compared with: a swing without friction gains energy at every step.
    ExplicitEuler {
        /// The longest step, s: positive and finite.
        step: f64,
    },
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
    /// DOP853, the method of order 8(5,3) of Dormand and Prince, with error control and dense
    /// output.
    Dop853(Dop853),
}

impl Default for Method {
    /// [`DormandPrince`] with its default settings.
    fn default() -> Self {
        Method::DormandPrince(DormandPrince::default())
    }
}

impl Method {
    pub(super) fn integrate<R, L, const N: usize>(
        &self,
        motion: &Motion<R, L>,
        recorder: &mut Recorder<N>,
    ) -> Result<(), Cause>
    where
        R: ForwardDynamics<N>,
        L: TorqueLaw<N>,
    {
        recorder.sample();
        match self {
            Method::ExplicitEuler { step } => fixed(ExplicitEuler, *step, motion, recorder),
            Method::CraigEuler { step } => fixed(CraigEuler, *step, motion, recorder),
            Method::SemiImplicitEuler { step } => fixed(SemiImplicitEuler, *step, motion, recorder),
            Method::RungeKutta4 { step } => fixed(Rk4, *step, motion, recorder),
            Method::DormandPrince(settings) => {
                adaptive::<DormandPrince54, _, _, N>(&settings.control(), motion, recorder)
            }
            Method::Dop853(settings) => {
                adaptive::<Dop853Method, _, _, N>(&settings.control(), motion, recorder)
            }
        }
    }

    pub(super) fn validate(&self, duration: f64) -> Result<(), InvalidSetting> {
        match self {
            Method::ExplicitEuler { step }
            | Method::CraigEuler { step }
            | Method::SemiImplicitEuler { step }
            | Method::RungeKutta4 { step } => validate_step(*step, duration),
            Method::DormandPrince(settings) => settings.control().validate(duration),
            Method::Dop853(settings) => settings.control().validate(duration),
        }
    }
}

fn fixed<S, const N: usize>(
    method: impl OneStep<S, Cause, N>,
    step: f64,
    system: &S,
    recorder: &mut Recorder<N>,
) -> Result<(), Cause> {
    let run = FixedStep::start(method, recorder.grid(step), recorder.phase);
    drive(system, run, recorder, usize::MAX)
}

fn adaptive<M, R, L, const N: usize>(
    control: &ErrorControl,
    motion: &Motion<R, L>,
    recorder: &mut Recorder<N>,
) -> Result<(), Cause>
where
    M: Embedded<N>,
    R: ForwardDynamics<N>,
    L: TorqueLaw<N>,
{
    let range = control.range(recorder.duration());
    let run = Adaptive::<M, N>::start(motion, 0.0, recorder.phase, control.tolerance, range)?;
    drive(motion, run, recorder, control.max_steps)
}
