//! A run from its settings to its end.

use dynamics_runtime::Size;
use dynamics_runtime::internal::is_rotation;

use super::error::{Cause, InvalidSetting, Outcome};
use super::friction::Law;
use super::limits::Limits;
use super::method::Integrator;
use super::motion::Motion;
use super::placed::InCoordinates;
use super::plan::Plan;
use super::progress::runs_away;
use super::recorder::Recorder;
use super::torque::{self, TorqueLaw};
use crate::integrate::Phase;

/// A run that is requested, whatever moves the robot by which method.
#[derive(Clone, Debug)]
pub(super) struct Setting<D: Size> {
    pub(super) friction: Law<D>,
    pub(super) limits: Limits<D>,
    /// The greatest torques, where motors saturate.
    pub(super) greatest: Option<D::Vector>,
    pub(super) plan: Plan,
}

impl<D: Size> Setting<D> {
    pub(super) fn new(size: D) -> Self {
        Setting {
            friction: Law::sign(size),
            limits: Limits::none(size),
            greatest: None,
            plan: Plan::default(),
        }
    }

    pub(super) fn run(
        &self,
        method: &impl Integrator<D>,
        robot: &dyn InCoordinates<D>,
        laws: &dyn TorqueLaw<D>,
        initial: Phase<D>,
    ) -> Outcome<D> {
        let mut recorder = Recorder::new(initial.clone());
        let mut limits = self.limits.clone();
        let interval = self.plan.duration / (self.plan.samples as f64 - 1.0);
        limits.straight = method.straight_step().min(interval);
        let motion = Motion::new(robot, laws, self.friction.clone(), limits);
        let end = self.record(method, &motion, &mut recorder);
        let end = end.map_err(|cause| runs_away(cause, &initial, &recorder.phase));
        recorder.finished(end, motion.evaluations.get())
    }

    fn record(
        &self,
        method: &impl Integrator<D>,
        motion: &Motion<D>,
        recorder: &mut Recorder<D>,
    ) -> Result<(), Cause> {
        let (laws, initial) = (motion.torque, recorder.phase.clone());
        let base = motion.base(&initial.q);
        if base.is_some_and(|base| !is_rotation(&base.rotation)) {
            return Err(InvalidSetting::Rotation.into());
        }
        self.plan.validate(laws.period())?;
        if let Some(joint) = initial.first_non_finite() {
            return Err(InvalidSetting::InitialState { joint }.into());
        }
        self.friction.validate()?;
        self.limits.validate(&initial)?;
        torque::validate(self.greatest.as_ref())?;
        method.validate(motion, &self.plan)?;
        recorder.plan(&self.plan)?;
        let mut begun = laws.sample(0.0, &initial).map(|()| initial.clone());
        if motion.has_events() {
            begun = begun.and_then(|phase| motion.settle_at_start(&phase));
        }
        // The first sample is the state as it was given, also where the laws or the contacts are refused.
        recorder.push(motion.sample_at(0.0, initial));
        recorder.phase = begun?;
        method.integrate(motion, recorder)
    }
}
