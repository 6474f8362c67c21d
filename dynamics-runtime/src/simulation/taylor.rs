//! Integration by Taylor series.

use core::cell::{Cell, RefCell};

use nalgebra::{Const, SVector};

use super::by_series::BySeries;
use super::drive::smooth;
use super::error::{Cause, InvalidSetting, SimulationError};
use super::events::Eventful;
use super::friction::Law;
use super::limits::{AtLimit, Limits};
use super::method::begin;
use super::motion::Motion;
use super::plan::Plan;
use super::recorder::Recorder;
use super::sampling::Sampled;
use super::settings::ErrorControl;
use super::torque::{NoTorque, TorqueLaw, finite};
use super::trajectory::Trajectory;
use crate::equations_of_motion::inverse_columns;
use crate::factorisation::JointFactors;
use crate::integrate::{Phase, Tolerance};
use crate::table::AsArm as _;
use crate::taylor::{FEWEST_ORDERS, SeriesStepper, Steady, mass_matrix, order};
use crate::{
    SingularMassMatrix, SizedMomenta,
    simulation::{EquationsOfMotion, Responses, TaylorDynamics},
};

/// Settings of the Taylor method.
///
/// A step is so long that the last terms of the series of each position and velocity y stay below
/// `absolute_tolerance + relative_tolerance |y|`; the error of a step is a few times smaller. The
/// error of a whole run grows with its length and with the motion's own sensitivity. Steps are added
/// with compensated sums, so that a tolerance of 1e-16 makes sense: what remains is the rounding of
/// the equations. Samples between the ends of steps are taken from the series and are as accurate as those ends.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Taylor {
    /// Relative tolerance of a step.
    pub relative_tolerance: f64,
    /// Absolute tolerance of a step, rad or m, and per second.
    pub absolute_tolerance: f64,
    /// The order of the series, 8 to [`MAX_TAYLOR_ORDER`](crate::simulation::MAX_TAYLOR_ORDER); `None` for the
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
        match (FEWEST_ORDERS..=crate::simulation::MAX_TAYLOR_ORDER).contains(&self.order()) {
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
/// motions, of 1e-8 and better, under torques that are constant or held.
///
/// The method differentiates the equations of motion along the motion. A torque law is a Rust function of time and
/// state, whose derivatives nobody knows. Torques are therefore constant over a run, or those of a controller that
/// samples and holds ([`control_period`](TaylorSimulation::control_period)). Viscous friction is part of the equations. Coulomb friction
/// jumps where a joint reverses, and no series continues across a jump: an arm with Coulomb friction is refused. For
/// laws and friction of any kind use [`Simulation`](crate::Simulation).
/// Joints pass the limits of the table, unless these are [`stops`](TaylorSimulation::stops) or
/// [errors](TaylorSimulation::limits_are_errors).
///
/// By default the arm starts from rest at q = 0, moves freely for 1 s and is sampled 101 times.
#[derive(Clone, Debug)]
#[must_use]
pub struct TaylorSimulation<'a, R, const N: usize, L = SVector<f64, N>> {
    robot: &'a R,
    torque: L,
    settings: Taylor,
    limits: Limits<Const<N>>,
    plan: Plan<Const<N>>,
}

/// A torque law that is called once each period, and whose torque is held until the next call.
#[derive(Clone, Copy, Debug)]
pub struct HeldTorque<F> {
    law: F,
    asked: Sampled,
}

impl<'a, R: TaylorDynamics<N>, const N: usize> TaylorSimulation<'a, R, N> {
    /// Free motion of the arm.
    pub fn new(robot: &'a R) -> Self {
        TaylorSimulation {
            robot,
            torque: SVector::zeros(),
            settings: Taylor::default(),
            limits: Limits::none(Const),
            plan: Plan::new(Const),
        }
    }

    /// The constant joint torques, N m or N.
    pub fn torque(self, tau: SVector<f64, N>) -> Self {
        TaylorSimulation {
            torque: tau,
            ..self
        }
    }

    /// Sample and hold, as [`Simulation::control_period`](crate::Simulation::control_period): the torque law that is given next
    /// is called at multiples of `period` in s, and a new series begins there.
    pub fn control_period(
        self,
        period: f64,
    ) -> TaylorSimulation<'a, R, N, HeldTorque<NoTorque<Const<N>>>> {
        let law: NoTorque<Const<N>> = |_, _, _| SVector::zeros();
        let asked = Sampled { period };
        self.with_torque(HeldTorque { law, asked })
    }

    /// Runs the simulation. It allocates the samples and the room for one series at the start and
    /// nothing later.
    ///
    /// # Errors
    ///
    /// [`SimulationError`], with the time and the state reached and all samples up to there. Its [`Cause`] is an invalid
    /// setting, Coulomb friction among them; a singular mass matrix, or an acceleration or a state that is not finite,
    /// reached by the motion; or that no step fits the equations. Never panics.
    pub fn run(&self) -> Result<Trajectory<N>, Box<SimulationError<N>>> {
        self.setting().run(None, |_, _| finite(self.torque))
    }
}

impl<'a, R: TaylorDynamics<N>, F, const N: usize> TaylorSimulation<'a, R, N, HeldTorque<F>> {
    /// The joint torques, N m or N, as a function of t in s, q in rad or m, and qd at a sample. They are held
    /// until the next sample. The law may have a memory.
    pub fn torque<G: FnMut(f64, &SVector<f64, N>, &SVector<f64, N>) -> SVector<f64, N>>(
        self,
        law: G,
    ) -> TaylorSimulation<'a, R, N, HeldTorque<G>> {
        let asked = self.torque.asked;
        self.with_torque(HeldTorque { law, asked })
    }

    /// Runs the simulation. It allocates the samples and the room for one series at the start and
    /// nothing later.
    ///
    /// # Errors
    ///
    /// [`SimulationError`], with the time and the state reached and all samples up to there. Its [`Cause`] is an invalid
    /// setting, Coulomb friction among them; a singular mass matrix, or a torque, acceleration or state that is not
    /// finite, reached by the motion; or that no step fits the equations. Never panics, unless the law does.
    pub fn run(&mut self) -> Result<Trajectory<N>, Box<SimulationError<N>>>
    where
        F: FnMut(f64, &SVector<f64, N>, &SVector<f64, N>) -> SVector<f64, N>,
    {
        let setting = self.setting();
        let HeldTorque { law, asked } = &mut self.torque;
        if let Err(setting) = asked.validate(self.plan.duration) {
            let recorder = Recorder::new(self.plan.initial.clone());
            return recorder.finished(Err(setting.into()), 0);
        }
        setting.run(Some(asked.period), |t, phase| {
            finite(law(t, &phase.q, &phase.qd))
        })
    }
}

impl<'a, R: TaylorDynamics<N>, L, const N: usize> TaylorSimulation<'a, R, N, L> {
    fn with_torque<M>(self, torque: M) -> TaylorSimulation<'a, R, N, M> {
        TaylorSimulation {
            robot: self.robot,
            torque,
            settings: self.settings,
            limits: self.limits,
            plan: self.plan,
        }
    }

    fn setting(&self) -> Setting<'a, R, N> {
        Setting {
            robot: self.robot,
            settings: self.settings,
            limits: self.limits.clone(),
            plan: self.plan.clone(),
        }
    }

    /// Tolerances, order and bounds of the steps.
    pub fn settings(self, settings: Taylor) -> Self {
        TaylorSimulation { settings, ..self }
    }

    /// Makes the `limits` of the table hard stops, as [`Simulation::stops`](crate::Simulation::stops): a joint comes
    /// back with `restitution` times its speed, 0 to 1, or leans on its stop until the stop would have to pull it.
    ///
    /// The time of an impact, or at which a joint leaves its stop, is the first zero of a polynomial,
    /// the series of the step. It is as accurate as the motion, and is found however often a joint turns within the
    /// step. A new series begins at each such time; between them steps are as long as without stops.
    ///
    /// ```
    /// # extern crate dynamics_runtime as robot_dynamics;
    /// use robot_dynamics::nalgebra::SVector;
    /// use robot_dynamics::{TaylorSimulation, robot_dynamics};
    ///
    /// robot_dynamics! {
    ///     /// A ball that falls along z.
    ///     struct Ball;
    ///     convention: modified,
    ///     gravity: [0, 0, -10],
    ///     joints: [height: prismatic { mass: 1, limits: [0, 2] }],
    ///     functions: [default, taylor_series],
    /// }
    ///
    /// // From 1.25 m it falls for 1/2 s, and rises again with half of 5 m/s.
    /// let motion = TaylorSimulation::new(&Ball)
    ///     .initial(SVector::repeat(1.25), SVector::zeros())
    ///     .stops(0.5)
    ///     .duration(0.75)
    ///     .run()?;
    /// assert!((motion.q[100][0] - 0.3125).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn stops(self, restitution: f64) -> Self {
        self.at_limits(AtLimit::Rebounds { restitution })
    }

    /// Ends the run in [`Cause::JointLimit`](crate::simulation::Cause::JointLimit) where a joint passes one of the `limits` of the
    /// table. The error has the time and the state there, and all samples before. A joint may rest at a limit.
    pub fn limits_are_errors(self) -> Self {
        self.at_limits(AtLimit::Ends)
    }

    fn at_limits(mut self, kind: AtLimit) -> Self {
        self.limits = Limits::of(self.robot.table().arm(), kind);
        self
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
}

/// What a run is asked for, whatever the torques are.
struct Setting<'a, R, const N: usize> {
    robot: &'a R,
    settings: Taylor,
    limits: Limits<Const<N>>,
    plan: Plan<Const<N>>,
}

impl<R: TaylorDynamics<N>, const N: usize> Setting<'_, R, N> {
    /// A run under a law that is called at the start, and then once each period if there is one.
    fn run<F: FnMut(f64, &Phase<Const<N>>) -> Result<SVector<f64, N>, Cause>>(
        &self,
        period: Option<f64>,
        law: F,
    ) -> Result<Trajectory<N>, Box<SimulationError<N>>> {
        let arm = BySteps(self.robot);
        let law = Held {
            tau: Cell::new(SVector::zeros()),
            period,
            law: RefCell::new(law),
        };
        let motion = Motion::new(&arm, &law, Law::sign(Const), self.limits.clone());
        let mut recorder = Recorder::new(self.plan.initial.clone());
        let end = self.record(&motion, &mut recorder);
        // One series for each step; impacts evaluate the equations besides.
        let evaluations = recorder.work.steps + motion.evaluations();
        recorder.finished(end, evaluations)
    }

    fn record<F: FnMut(f64, &Phase<Const<N>>) -> Result<SVector<f64, N>, Cause>>(
        &self,
        motion: &Motion<BySteps<R>, Held<F, N>, Const<N>>,
        recorder: &mut Recorder<Const<N>>,
    ) -> Result<(), Cause> {
        self.validate()?;
        recorder.plan(&self.plan)?;
        begin(motion, recorder)?;
        let control = self.settings.control();
        let range = control.range(self.plan.duration);
        let (start, order) = (recorder.phase.clone(), self.settings.order());
        let mut run = SeriesStepper::start(motion, start, order, control.tolerance, range)?;
        let (steps, duration) = (control.max_steps, recorder.duration());
        let run = match motion.has_events() {
            true => Eventful::<_, _, _, _, BySeries, Const<N>>::start(
                motion, motion, &mut run, duration,
            )
            .and_then(|run| run.drive(recorder, steps)),
            false => smooth::<_, _, Cause, Const<N>>(motion, motion, &mut run, recorder, steps),
        };
        run.map_err(Cause::of_long_steps)
    }

    fn validate(&self) -> Result<(), Cause> {
        self.plan.validate()?;
        let dry = self.robot.table().arm().dry_friction::<Const<N>>();
        if let Some(joint) = dry.iter().position(|friction| !friction.is_none()) {
            return Err(InvalidSetting::CoulombFriction { joint }.into());
        }
        self.limits.validate(&self.plan.initial)?;
        Ok(self.settings.validate(self.plan.duration)?)
    }
}

/// An arm that is known by its series.
struct BySteps<'a, R>(&'a R);

impl<R: TaylorDynamics<N>, const N: usize> EquationsOfMotion<Const<N>> for BySteps<'_, R> {
    fn size(&self) -> Const<N> {
        Const
    }

    fn accelerations(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
    ) -> Result<SVector<f64, N>, SingularMassMatrix> {
        Ok(self.0.taylor_series(q, qd, tau, 2)?[2] * 2.0)
    }

    fn accelerations_and_responses(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
        joints: &[bool; N],
    ) -> Result<Responses<Const<N>>, SingularMassMatrix> {
        let qdd = self.accelerations(q, qd, tau)?;
        let factors = JointFactors::new(N, mass_matrix(self.0, q))?;
        let columns = inverse_columns(Const, &factors, joints);
        Ok((qdd, columns))
    }

    fn in_momenta(&self) -> Option<&dyn SizedMomenta<Const<N>>> {
        None
    }
}

/// Torques that are held.
struct Held<F, const N: usize> {
    tau: Cell<SVector<f64, N>>,
    period: Option<f64>,
    law: RefCell<F>,
}

impl<F, const N: usize> TorqueLaw<Const<N>> for Held<F, N>
where
    F: FnMut(f64, &Phase<Const<N>>) -> Result<SVector<f64, N>, Cause>,
{
    fn motors(&self, _t: f64, _phase: &Phase<Const<N>>) -> SVector<f64, N> {
        self.tau.get()
    }

    fn with_tool(
        &self,
        tau: SVector<f64, N>,
        _t: f64,
        _phase: &Phase<Const<N>>,
    ) -> Result<SVector<f64, N>, Cause> {
        Ok(tau)
    }

    fn period(&self) -> Option<f64> {
        self.period
    }

    fn sample(&self, t: f64, phase: &Phase<Const<N>>) -> Result<(), Cause> {
        self.tau.set((self.law.borrow_mut())(t, phase)?);
        Ok(())
    }
}

impl<R, F, const N: usize> Steady<N> for Motion<'_, BySteps<'_, R>, Held<F, N>, Const<N>>
where
    R: TaylorDynamics<N>,
{
    type Arm = R;

    fn arm(&self) -> &R {
        self.robot().0
    }

    fn torque(&self) -> SVector<f64, N> {
        self.torque_law().tau.get()
    }

    fn held(&self) -> Option<[bool; N]> {
        self.still()
    }
}
