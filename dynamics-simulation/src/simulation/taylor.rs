//! Integration by Taylor series.

use core::cell::RefCell;

use dynamics_runtime::internal::{JointFactors, inverse_columns, mass_matrix};
use dynamics_runtime::table::AsArm as _;
use dynamics_runtime::{
    EquationsOfMotion, MAX_TAYLOR_ORDER, Place, Responses, SingularMassMatrix, TaylorDynamics,
};
use nalgebra::{Const, SVector};

use super::Setting;
use super::by_series::BySeries;
use super::drive::drive;
use super::error::{Cause, InvalidSetting, Outcome, SimulationError};
use super::law::{ForceLaw, FreeMotion};
use super::limits::{AtLimit, Limits};
use super::method::Integrator;
use super::motion::Motion;
use super::placed::Placed;
use super::plan::{Plan, plan_setters};
use super::recorder::Recorder;
use super::sampling::Sampled;
use super::settings::Taylor;
use super::torque::{Laws, SampledLaw, greatest};
use super::trajectory::Trajectory;
use super::wrench::Wrenches;
use crate::integrate::Phase;
use crate::taylor::{FEWEST_ORDERS, SeriesStepper, Steady, order};

/// A simulation by the Taylor method, of high order and with long steps: for accurate motions, of 1e-8 and better.
///
/// The method differentiates the equations of motion along the motion. Torques are therefore constant over a run, or
/// those of a controller that samples and holds ([`control_period`](TaylorSimulation::control_period)). Viscous
/// friction is part of the equations. An arm with Coulomb friction is refused: no series continues across its jump
/// where a joint reverses. For laws and friction of any kind use [`Simulation`](crate::Simulation).
///
/// Joints pass the limits of the table, unless these are [`stops`](TaylorSimulation::stops) or
/// [errors](TaylorSimulation::limits_are_errors). By default the arm moves freely from rest at q = 0 for 1 s, with 101
/// samples.
#[derive(Clone, Debug)]
#[must_use]
pub struct TaylorSimulation<'a, R, const N: usize, L = SVector<f64, N>> {
    robot: &'a R,
    torque: L,
    settings: Taylor,
    setting: Setting<Const<N>>,
    initial: Phase<Const<N>>,
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
        let dry = robot.table().arm().dry_friction::<Const<N>>();
        let mut setting = Setting::new(Const);
        setting.friction.dry = dry;
        TaylorSimulation {
            robot,
            torque: SVector::zeros(),
            settings: Taylor::default(),
            setting,
            initial: Phase::zeros(Const),
        }
    }

    /// The constant joint torques, N m or N.
    pub fn torque(self, torque: SVector<f64, N>) -> Self {
        TaylorSimulation { torque, ..self }
    }

    /// Sample and hold, as [`Simulation::control_period`](crate::Simulation::control_period): the torque law that is given next
    /// is called at multiples of `period` in s, and a new series begins there.
    pub fn control_period(self, period: f64) -> TaylorSimulation<'a, R, N, HeldTorque<FreeMotion>> {
        let (law, asked) = (FreeMotion, Sampled { period });
        self.with_torque(HeldTorque { law, asked })
    }

    /// Runs the simulation. It allocates the samples and the room for one series at the start and
    /// nothing later.
    ///
    /// # Errors
    ///
    /// [`SimulationError`], with the time and the state reached and all samples up to there; its [`Cause`] says why.
    /// Coulomb friction is an invalid setting. Never panics, unless a torque law does.
    pub fn run(&self) -> Result<Trajectory<N>, Box<SimulationError<N>>> {
        let mut law = |_: f64, _: &SVector<f64, N>, _: &SVector<f64, N>| self.torque;
        let (series, initial) = (self.series(), self.initial.clone());
        series.run(&self.setting, initial, None, &mut law)
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

    /// Runs the simulation, as under constant torques.
    ///
    /// # Errors
    ///
    /// [`SimulationError`], as under constant torques.
    pub fn run(&mut self) -> Result<Trajectory<N>, Box<SimulationError<N>>>
    where
        F: ForceLaw<Const<N>>,
    {
        let (series, initial) = (self.series(), self.initial.clone());
        let HeldTorque { law, asked } = &mut self.torque;
        series.run(&self.setting, initial, Some(asked.period), law)
    }
}

impl<'a, R: TaylorDynamics<N>, L, const N: usize> TaylorSimulation<'a, R, N, L> {
    fn with_torque<M>(self, torque: M) -> TaylorSimulation<'a, R, N, M> {
        TaylorSimulation {
            robot: self.robot,
            torque,
            settings: self.settings,
            setting: self.setting,
            initial: self.initial,
        }
    }

    fn series(&self) -> Series<'a, R> {
        Series {
            robot: self.robot,
            settings: self.settings,
        }
    }

    /// Tolerances, order and bounds of the steps.
    pub fn settings(mut self, settings: Taylor) -> Self {
        self.settings = settings;
        self
    }

    /// Cuts the torques to the `torque_limit` of each joint, as [`Simulation::saturate`](crate::Simulation::saturate).
    pub fn saturate(mut self) -> Self {
        self.setting.greatest = Some(greatest::<Const<N>>(self.robot.table().arm()));
        self
    }

    /// Makes the `limits` of the table hard stops, as [`Simulation::stops`](crate::Simulation::stops): a joint comes
    /// back with `restitution` times its speed, 0 to 1, or leans on its stop until the stop would have to pull it.
    ///
    /// The time of an impact, or at which a joint leaves its stop, is the first zero of the series of the step. It is
    /// as accurate as the motion, and is found however often a joint turns within the step.
    pub fn stops(self, restitution: f64) -> Self {
        self.at_limits(AtLimit::Rebounds { restitution })
    }

    /// Ends the run in [`Cause::JointLimit`](crate::simulation::Cause::JointLimit) where a joint passes one of the `limits` of the
    /// table. The error has the time and the state there, and all samples before. A joint may rest at a limit.
    pub fn limits_are_errors(self) -> Self {
        self.at_limits(AtLimit::Ends)
    }

    fn at_limits(mut self, kind: AtLimit) -> Self {
        self.setting.limits = Limits::of(self.robot.table().arm(), kind);
        self
    }

    /// Positions and velocities at t = 0, rad or m, and per second.
    pub fn initial(mut self, q: SVector<f64, N>, qd: SVector<f64, N>) -> Self {
        self.initial = Phase { q, qd };
        self
    }

    plan_setters!();
}

/// The method of Taylor series for an arm.
#[derive(Clone, Copy, Debug)]
struct Series<'a, R> {
    robot: &'a R,
    settings: Taylor,
}

impl<R> Series<'_, R> {
    fn run<L: ForceLaw<Const<N>>, const N: usize>(
        self,
        setting: &Setting<Const<N>>,
        initial: Phase<Const<N>>,
        period: Option<f64>,
        law: &mut L,
    ) -> Outcome<Const<N>>
    where
        R: TaylorDynamics<N>,
    {
        let robot = BySteps(self.robot);
        let start = Place {
            base: None,
            q: initial.q,
        };
        let (placed, _) = Placed::<_, Const<N>>::at(&robot, &start);
        let laws = Laws {
            placed: &placed,
            torque: SampledLaw {
                period,
                law: RefCell::new(law),
                held: RefCell::new(SVector::zeros()),
            },
            wrenches: &Wrenches::default(),
            greatest: setting.greatest.as_ref(),
        };
        setting.run(&self, &placed, &laws, initial)
    }
}

/// A motion, and the series of its arm.
struct SeriesOf<'m, R, const N: usize> {
    arm: &'m R,
    motion: &'m Motion<'m, Const<N>>,
}

impl<R: TaylorDynamics<N>, const N: usize> Steady<N> for SeriesOf<'_, R, N> {
    type Arm = R;

    fn arm(&self) -> &R {
        self.arm
    }

    fn torque(&self, t: f64, phase: &Phase<Const<N>>) -> SVector<f64, N> {
        self.motion.torque.motors(t, phase)
    }

    fn held(&self) -> Option<[bool; N]> {
        self.motion.still(&self.motion.contacts())
    }
}

impl<R: TaylorDynamics<N>, const N: usize> Integrator<Const<N>> for Series<'_, R> {
    fn validate(&self, motion: &Motion<Const<N>>, plan: &Plan) -> Result<(), InvalidSetting> {
        self.settings.control().validate(plan.duration)?;
        if let Some(joint) = motion.friction.dry.iter().position(|dry| !dry.is_none()) {
            return Err(InvalidSetting::CoulombFriction { joint });
        }
        let order = self.settings.series_order();
        if (FEWEST_ORDERS..=MAX_TAYLOR_ORDER).contains(&order) {
            Ok(())
        } else {
            Err(InvalidSetting::Order(order))
        }
    }

    fn integrate(
        &self,
        motion: &Motion<Const<N>>,
        recorder: &mut Recorder<Const<N>>,
    ) -> Result<(), Cause> {
        let control = self.settings.control();
        let range = control.range(recorder.duration);
        let (start, order) = (recorder.phase.clone(), self.settings.series_order());
        let arm = self.robot;
        let system = &SeriesOf { arm, motion };
        let mut run = SeriesStepper::start(system, start, order, control.tolerance, range)?;
        let end = drive::<BySeries, _, _, _>(motion, system, &mut run, recorder, Some(control));
        // One series for each step; impacts evaluate the equations besides.
        motion.count(recorder.work.steps);
        end.map_err(Cause::of_long_steps)
    }
}

impl Taylor {
    fn series_order(&self) -> usize {
        let tolerance = self.relative_tolerance.min(self.absolute_tolerance);
        self.order.unwrap_or_else(|| order(tolerance))
    }
}

/// An arm that is known by its series.
struct BySteps<'a, R>(&'a R);

impl<R: TaylorDynamics<N>, const N: usize> EquationsOfMotion<Const<N>> for BySteps<'_, R> {
    fn joints(&self) -> Const<N> {
        Const
    }

    fn size(&self) -> Const<N> {
        Const
    }

    fn accelerations(
        &self,
        Place { q, .. }: &Place<Const<N>>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
    ) -> Result<SVector<f64, N>, SingularMassMatrix> {
        Ok(self.0.taylor_series(q, qd, tau, 2)?[2] * 2.0)
    }

    fn accelerations_and_responses(
        &self,
        place: &Place<Const<N>>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
        joints: &[bool; N],
    ) -> Result<Responses<Const<N>>, SingularMassMatrix> {
        let qdd = self.accelerations(place, qd, tau)?;
        let factors = JointFactors::new(N, mass_matrix(self.0, &place.q))?;
        let columns = inverse_columns(Const, &factors, joints);
        Ok((qdd, columns))
    }
}
