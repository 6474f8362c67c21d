//! Motion of a robot under a torque law.

mod by_margins;
mod by_series;
mod complementarity;
mod contacts;
mod creep;
#[cfg(feature = "csv")]
mod csv;
mod drive;
mod error;
mod events;
mod friction;
mod impact;
mod joint_set;
mod law;
mod limits;
mod method;
mod motion;
mod moving_base;
mod placed;
mod plan;
mod progress;
mod recorder;
mod run_time;
mod sampling;
mod settings;
mod taylor;
mod torque;
mod trajectory;
mod wrench;

use core::cell::RefCell;

use dynamics_runtime::internal::{Velocities, is_rotation};
use dynamics_runtime::table::AsArm as _;
use dynamics_runtime::{Pose, Size};
use nalgebra::{Const, Dim as _, Matrix4, SMatrix, SVector, Vector6};

use crate::integrate::Phase;
use error::Outcome;
use friction::Law;
use limits::{AtLimit, Limits};
use method::{Chosen, Integrator};
use motion::Motion;
use placed::{InCoordinates, Placed};
use plan::{Plan, plan_setters};
use progress::runs_away;
use recorder::Recorder;
use torque::{Laws, SampledLaw, TorqueLaw};
use wrench::{HeldWrench, Tip, Wrenches};

pub use dynamics_runtime::{
    EquationsOfMotion, InvalidDuration, MAX_TAYLOR_ORDER, Momenta, OnBase, Place, Responses,
    SizedKinematics, SizedModel, SizedMomenta, Sizes, TaylorCoefficients, TaylorDynamics,
};

#[cfg(feature = "csv")]
pub use csv::{CsvError, CsvMistake, shortest};
pub use error::{Cause, InvalidSetting, SimulationError, SizedSimulationError};
pub use friction::Friction;
pub use joint_set::JointSet;
pub use law::{ForceLaw, FreeMotion};
pub use method::Method;
pub use sampling::{Asked, AwaitsPeriod, Continuous, NothingHeld, Sampled, WithoutPeriod};
pub use settings::{Dop853, DormandPrince, Radau5, Taylor};
pub use taylor::{HeldTorque, TaylorSimulation};
pub use trajectory::{FloatingTrajectory, Sample, SizedTrajectory, Trajectory, Work};
pub use wrench::{FrameOf, Wrench, WrenchAt};

/// A simulation of an arm: set it up, then [`run`](Simulation::run) it.
///
/// By default the arm moves freely from rest at q = 0 for 1 s, with 101 samples, by [`DormandPrince`] with its default
/// tolerance.
///
/// ```
/// use robot_dynamics::nalgebra::{SVector, Vector1};
/// use robot_dynamics::{ForwardDynamics, Scalar, Simulation, SingularMassMatrix};
///
/// /// A cart of 2 kg on a rail.
/// struct Cart;
///
/// impl ForwardDynamics<1> for Cart {
///     fn forward_dynamics<T: Scalar>(
///         &self,
///         _q: &SVector<T, 1>,
///         _qd: &SVector<T, 1>,
///         tau: &SVector<T, 1>,
///     ) -> Result<SVector<T, 1>, SingularMassMatrix> {
///         Ok(Vector1::new(tau[0] / T::from_f64(2.0)))
///     }
/// }
///
/// let motion = Simulation::new(&Cart)
///     .torque(|_t, _q, _qd| Vector1::new(4.0))
///     .duration(3.0)
///     .samples(4)
///     .run()?;
/// assert_eq!(motion.t, [0.0, 1.0, 2.0, 3.0]);
/// assert!((motion.q[3][0] - 9.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
#[must_use]
pub struct Simulation<'a, R, L, K: Sizes, S = Continuous> {
    robot: &'a R,
    torque: L,
    wrenches: Wrenches<'a, R, K>,
    asked: S,
    method: Chosen<K::Freedoms>,
    setting: Setting<K::Freedoms>,
    start: Place<K::Joints>,
    velocities: Velocities<K>,
}

impl<'a, R: EquationsOfMotion<K>, K: Sizes> Simulation<'a, R, FreeMotion, K> {
    /// Free motion of the robot.
    pub fn new(robot: &'a R) -> Self {
        let (joints, size) = (robot.joints(), robot.size());
        let moves = size.value() > joints.value();
        Simulation {
            robot,
            torque: FreeMotion,
            wrenches: Wrenches::default(),
            asked: Continuous,
            method: Chosen::by_default(),
            setting: Setting::new(size),
            start: Place {
                base: moves.then(Pose::identity),
                q: joints.vector(),
            },
            velocities: size.vector(),
        }
    }
}

impl<'a, R, L, const N: usize, S: WithoutPeriod> Simulation<'a, R, L, Const<N>, S> {
    /// The joint torques as a function of t in s, q in rad or m, and qd; in N m or N.
    ///
    /// It is called wherever the integration evaluates the equations of motion: at trial stages, out of order, and in
    /// steps that are thrown away. Therefore it must be a function of its arguments alone, an `Fn`. A controller with a
    /// memory is an `FnMut` and needs [`control_period`](Simulation::control_period):
    /// `.control_period(1e-3).torque(law)`. Without it the compiler says that something is captured "in a `Fn` closure"
    /// (E0594, E0596).
    pub fn torque<F>(self, law: F) -> Simulation<'a, R, F, Const<N>, S>
    where
        // The compiler shows this line to who gives it another law.
        F: Fn(f64, &SVector<f64, N>, &SVector<f64, N>) -> SVector<f64, N>, // with a memory: `.control_period(1e-3).torque(law)`
    {
        self.with_laws(|_, asked| (law, asked))
    }
}

impl<'a, R, L, S, K: Sizes> Simulation<'a, R, L, K, S> {
    /// Sample and hold, as a digital controller works. With the period p in s, the torque law is called at the times 0,
    /// p, 2 p, ... before the end of the run, once each and in order. Its torque is held until the next of them.
    ///
    /// Every time is k p, rounded once. All methods end a step at each of these times, so that they keep their order.
    /// The law sees the state at that time; to simulate the delay of a controller, let it return the torque of one
    /// period before. A force at the tool that was given as a function before stays a function of time and state.
    ///
    /// The torque law that is given after `control_period` may have a memory; without `control_period` the compiler refuses
    /// one that has:
    ///
    /// ```
    /// use robot_dynamics::nalgebra::{SVector, Vector1};
    /// use robot_dynamics::{Simulation, robot_dynamics};
    ///
    /// robot_dynamics! {
    ///     /// A cart of 2 kg on a rail that slopes.
    ///     struct Cart;
    ///     convention: modified,
    ///     gravity: [0, -9.7, -1.5],
    ///     joints: [rail: prismatic { mass: 2 }],
    /// }
    ///
    /// // PID control at 1 kHz. The integral learns what gravity takes.
    /// let mut integral = Vector1::zeros();
    /// let motion = Simulation::new(&Cart)
    ///     .control_period(1e-3)
    ///     .torque(|_t, q, qd| {
    ///         let error = Vector1::new(0.1) - q;
    ///         integral += error * 1e-3;
    ///         error * 200.0 + integral * 400.0 - qd * 40.0
    ///     })
    ///     .duration(4.0)
    ///     .run()?;
    /// assert!((motion.q[100][0] - 0.1).abs() < 1e-4);
    /// assert!((motion.tau[100][0] - 3.0).abs() < 0.05);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn control_period(self, period: f64) -> Simulation<'a, R, L, K, Sampled> {
        self.with_laws(|torque, _| (torque, Sampled { period }))
    }
}

impl<'a, R: 'a, L, S, const N: usize> Simulation<'a, R, L, Const<N>, S> {
    /// Positions and velocities at t = 0, rad or m, and per second.
    pub fn initial(self, q: SVector<f64, N>, qd: SVector<f64, N>) -> Self {
        self.starting(Place { base: None, q }, qd)
    }

    /// The force of the surroundings on the tool: a wrench w = (fx fy fz nx ny nz), N and N m, as a function of t in s,
    /// the tip's pose, and its twist (vx vy vz wx wy wz). The force acts at the tip's origin, the point of
    /// `forward_kinematics`; axes are those of `jacobian`. J^T w is added to the torques of the motors, for joints that
    /// stick too. The law is called wherever the integration evaluates the equations of motion, also with a
    /// [`control_period`](Simulation::control_period).
    ///
    /// ```
    /// use robot_dynamics::nalgebra::{SVector, Vector6};
    /// use robot_dynamics::{Simulation, robot_dynamics};
    ///
    /// robot_dynamics! {
    ///     /// A cart of 2 kg on a rail along z.
    ///     struct Cart;
    ///     convention: modified,
    ///     gravity: [0, -9.81, 0],
    ///     joints: [rail: prismatic { mass: 2 }],
    ///     functions: [default, forward_kinematics, jacobian],
    /// }
    ///
    /// // From 1 m on a wall pushes back, 800 N for each metre.
    /// let motion = Simulation::new(&Cart)
    ///     .initial(SVector::zeros(), SVector::repeat(1.0))
    ///     .tool_wrench(|_t, pose, _twist| {
    ///         let depth = f64::max(pose[(2, 3)] - 1.0, 0.0);
    ///         Vector6::new(0.0, 0.0, -800.0 * depth, 0.0, 0.0, 0.0)
    ///     })
    ///     .duration(2.0)
    ///     .samples(3)
    ///     .run()?;
    /// assert!((motion.qd[2][0] + 1.0).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// It takes the place of forces that were given before; [`wrench_at`](Simulation::wrench_at) adds others.
    pub fn tool_wrench<F>(mut self, law: F) -> Self
    where
        R: SizedKinematics<Const<N>>,
        F: Fn(f64, &Matrix4<f64>, &Vector6<f64>) -> Vector6<f64> + 'a,
    {
        self.wrenches = Wrenches::default();
        self.with_wrench(WrenchAt::new(Tip, law))
    }

    /// The force of the surroundings on the tool, sampled with the torques: a wrench (fx fy fz nx ny nz), N and N m, as
    /// a function of t in s, the tip's pose and its twist. It is held, in the axes of `jacobian`, for the period of
    /// [`control_period`](Simulation::control_period), which may be called before or after. The law may have a memory.
    ///
    /// It is for disturbances, such as random pushes. Contact is stiff, and a force that is held feeds energy into the
    /// motion: give it as a function of time and state, by [`tool_wrench`](Simulation::tool_wrench).
    pub fn held_tool_wrench<F>(mut self, law: F) -> Simulation<'a, R, L, Const<N>, S::Held>
    where
        S: Asked,
        R: SizedKinematics<Const<N>>,
        F: FnMut(f64, &Matrix4<f64>, &Vector6<f64>) -> Vector6<f64> + 'a,
    {
        self.wrenches = Wrenches::default();
        let simulation = self.with_wrench(HeldWrench::new(Tip, law));
        simulation.with_laws(|torque, asked| (torque, asked.held()))
    }
}

impl<'a, R: 'a, L, const N: usize> Simulation<'a, R, L, Const<N>, Sampled> {
    /// The joint torques, N m or N, as a function of t in s, q in rad or m, and qd. They are held for a period. The law
    /// may have a memory: it is called once each period, in order. A second run begins with the memory that the first
    /// one left.
    pub fn torque<F>(self, law: F) -> Simulation<'a, R, F, Const<N>, Sampled>
    where
        F: FnMut(f64, &SVector<f64, N>, &SVector<f64, N>) -> SVector<f64, N>,
    {
        self.with_laws(|_, asked| (law, asked))
    }
}

impl<'a, R: 'a, L, S, const N: usize> Simulation<'a, R, L, Const<N>, S> {
    /// A force of the surroundings at a frame, besides those that were given before, at the tool or at other frames.
    /// `place` returns the pose and the Jacobian of the frame. `law` returns the wrench (fx fy fz nx ny nz), N and N m,
    /// at the frame's origin in the axes of the world, as a function of t in s, that pose and the frame's twist.
    ///
    /// ```
    /// use robot_dynamics::nalgebra::{Vector2, Vector6};
    /// use robot_dynamics::{Simulation, robot_dynamics};
    ///
    /// robot_dynamics! {
    ///     /// Two fingers on one rail, with pads of rubber.
    ///     struct Fingers;
    ///     convention: modified,
    ///     gravity: [0, -9.81, 0],
    ///     joints: [left: prismatic { mass: 1 }, right: prismatic { on: base, mass: 1 }],
    ///     frames: { left_pad: { on: left, xyz: [0, 0, 0.1] }, right_pad: { on: right, xyz: [0, 0, -0.1] } },
    ///     functions: [
    ///         default,
    ///         left = (forward_kinematics(left_pad), jacobian(left_pad)),
    ///         right = (forward_kinematics(right_pad), jacobian(right_pad)),
    ///     ],
    /// }
    ///
    /// let along = |force| Vector6::new(0.0, 0.0, force, 0.0, 0.0, 0.0);
    /// let motion = Simulation::new(&Fingers)
    ///     .initial(Vector2::new(0.0, 0.5), Vector2::zeros())
    ///     .wrench_at(|fingers, q| fingers.left(q), |_t, _pose, _twist| along(2.0))
    ///     .wrench_at(|fingers, q| fingers.right(q), |_t, _pose, _twist| along(-1.0))
    ///     .run()?;
    /// let [left, right] = [motion.q[100][0], motion.q[100][1]];
    /// assert!((left - 1.0).abs() < 1e-9 && right.abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn wrench_at<P, F>(self, place: P, law: F) -> Self
    where
        P: Fn(&R, &SVector<f64, N>) -> (Matrix4<f64>, SMatrix<f64, 6, N>) + 'a,
        F: Fn(f64, &Matrix4<f64>, &Vector6<f64>) -> Vector6<f64> + 'a,
    {
        self.with_wrench(WrenchAt::new(place, law))
    }
}

impl<'a, R, L, S, K: Sizes> Simulation<'a, R, L, K, S> {
    /// The same with other laws.
    fn with_laws<L2, S2>(
        self,
        change: impl FnOnce(L, S) -> (L2, S2),
    ) -> Simulation<'a, R, L2, K, S2> {
        let (torque, asked) = change(self.torque, self.asked);
        Simulation {
            robot: self.robot,
            torque,
            wrenches: self.wrenches,
            asked,
            method: self.method,
            setting: self.setting,
            start: self.start,
            velocities: self.velocities,
        }
    }

    fn with_wrench(mut self, wrench: impl Wrench<R, K> + 'a) -> Self {
        self.wrenches = self.wrenches.and(wrench);
        self
    }

    fn starting(mut self, place: Place<K::Joints>, velocities: Velocities<K>) -> Self {
        (self.start, self.velocities) = (place, velocities);
        self
    }

    /// Forces of the surroundings besides those that were given before, as many as a program finds while it runs: each is a
    /// [`WrenchAt`], the place and the law of [`wrench_at`](Simulation::wrench_at).
    ///
    /// ```
    /// use robot_dynamics::nalgebra::{SVector, Vector6};
    /// use robot_dynamics::simulation::WrenchAt;
    /// use robot_dynamics::{Simulation, robot_dynamics};
    ///
    /// robot_dynamics! {
    ///     /// A cart of 2 kg on a rail along z.
    ///     struct Cart;
    ///     convention: modified,
    ///     gravity: [0, -9.81, 0],
    ///     joints: [rail: prismatic { mass: 2 }],
    ///     functions: [default, tip = (forward_kinematics, jacobian)],
    /// }
    ///
    /// let pushes = [1.0, 2.5, 0.5].map(|force| {
    ///     let along = Vector6::new(0.0, 0.0, force, 0.0, 0.0, 0.0);
    ///     WrenchAt::new(|cart: &Cart, q: &SVector<f64, 1>| cart.tip(q), move |_, _: &_, _: &_| along)
    /// });
    /// let motion = Simulation::new(&Cart).wrenches(pushes.into()).run()?;
    /// assert!((motion.q[100][0] - 1.0).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn wrenches<F: Wrench<R, K> + 'a>(self, forces: Vec<F>) -> Self {
        forces.into_iter().fold(self, Simulation::with_wrench)
    }

    /// The method of integration: a [`Method`], or the settings of [`DormandPrince`] alone. All methods are compiled for a robot
    /// for which one is given.
    pub fn method(mut self, method: impl Into<Method>) -> Self {
        self.method = Chosen::new(method.into());
        self
    }

    /// How the dry friction of the arm's table is treated; by default, [`Friction::Sign`].
    pub fn friction(mut self, kind: Friction) -> Self
    where
        R: SizedModel<K>,
    {
        let dry = self.robot.sized_table().arm().dry_friction::<K::Freedoms>();
        self.setting.friction = Law { kind, dry };
        self
    }

    /// Cuts the torques of the law to the `torque_limit` of each joint, as its motor does: a greater one is the limit, in
    /// the same direction. A joint without that limit has any torque. By default, the torques are those of the law.
    ///
    /// The samples have the torques that act. Friction, springs and the force at the tool are not cut.
    ///
    /// ```
    /// use robot_dynamics::nalgebra::Vector1;
    /// use robot_dynamics::{Simulation, robot_dynamics};
    ///
    /// robot_dynamics! {
    ///     /// A cart of 2 kg on a level rail, with a motor of 4 N.
    ///     struct Cart;
    ///     convention: modified,
    ///     gravity: [0, -9.81, 0],
    ///     joints: [rail: prismatic { mass: 2, torque_limit: 4 }],
    /// }
    ///
    /// let motion = Simulation::new(&Cart).torque(|_t, _q, _qd| Vector1::new(100.0)).saturate().run()?;
    /// assert_eq!(motion.tau[100][0], 4.0);
    /// assert!((motion.q[100][0] - 1.0).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn saturate(mut self) -> Self
    where
        R: SizedModel<K>,
    {
        let table = self.robot.sized_table();
        self.setting.greatest = Some(torque::greatest::<K::Freedoms>(table.arm()));
        self
    }

    /// Makes the `limits` of the table hard stops, which throw a joint back with `restitution` times its speed, from 0
    /// to 1. By default, joints pass their limits as if there were none.
    ///
    /// The times of impacts are found to rounding, on steps of the method itself. With the restitution e, an impact of
    /// joint i changes the velocities of the whole arm: `qd+ = qd- - (1 + e) M^-1 e_i qd_i- / (M^-1)_ii`. Several
    /// joints at once obey Newton's law of restitution, and no stop pulls. An impact overcomes friction that sticks.
    ///
    /// A joint at rest at a stop leans on it, with an acceleration of exactly zero, until the stop would have to pull
    /// it; dry friction holds it there besides. Bounces that die out end where they would rise by less than 1e-13 of
    /// the position (and of 1 rad or m), those of several joints together. With [`Method::ExplicitEuler`] they end at a
    /// rise of half the acceleration times its step squared. Elastic ones that friction damps shrink slowly: once their work is
    /// great, bounces that rise by less than the tolerance (1e-9 by fixed steps) are rest. Others without end are
    /// [`Cause::Impacts`].
    ///
    /// Cost: one more evaluation of the forward dynamics at the end of each step, and about ten steps for an impact.
    /// Where joints lean on stops, an evaluation becomes one over dual numbers for each of these joints. A joint that
    /// passes a limit and comes back within one step is noticed where a cubic through the ends of the step shows it.
    /// Structure-preserving methods preserve the structure between impacts.
    ///
    /// ```
    /// use robot_dynamics::nalgebra::SVector;
    /// use robot_dynamics::{Simulation, robot_dynamics};
    ///
    /// robot_dynamics! {
    ///     /// A ball that falls along z.
    ///     struct Ball;
    ///     convention: modified,
    ///     gravity: [0, 0, -10],
    ///     joints: [height: prismatic { mass: 1, limits: [0, 2] }],
    /// }
    ///
    /// // From 1.25 m it falls for 1/2 s, and rises again with half of 5 m/s.
    /// let motion = Simulation::new(&Ball)
    ///     .initial(SVector::repeat(1.25), SVector::zeros())
    ///     .stops(0.5)
    ///     .duration(0.75)
    ///     .run()?;
    /// assert!((motion.q[100][0] - 0.3125).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn stops(self, restitution: f64) -> Self
    where
        R: SizedModel<K>,
    {
        self.at_limits(AtLimit::Rebounds { restitution })
    }

    /// Ends the run in [`Cause::JointLimit`] where a joint passes one of the `limits` of the
    /// table. The error has the time and the state there, and all samples before.
    ///
    /// The time is found to rounding, on steps of the method itself. A joint may rest at a limit.
    pub fn limits_are_errors(self) -> Self
    where
        R: SizedModel<K>,
    {
        self.at_limits(AtLimit::Ends)
    }

    fn at_limits(mut self, kind: AtLimit) -> Self
    where
        R: SizedModel<K>,
    {
        let table = self.robot.sized_table();
        self.setting.friction.dry = table.arm().dry_friction::<K::Freedoms>();
        self.setting.limits = Limits::of(table.arm(), kind);
        self
    }

    plan_setters!();
}

impl<R: EquationsOfMotion<K>, L, K: Sizes, S: WithoutPeriod> Simulation<'_, R, L, K, S> {
    /// Runs the simulation. For an arm it allocates the samples at the start and nothing later.
    ///
    /// On a base that moves, methods are explicit ones; its rotation stays one within 1e-15, however many steps there are.
    ///
    /// # Errors
    ///
    /// [`SizedSimulationError`] with the time and the state reached and all samples up to there; its [`Cause`] says why.
    /// Implicit methods on a base that moves are an invalid setting. Never panics, unless a law does.
    pub fn run(&self) -> Result<SizedTrajectory<K>, Box<SizedSimulationError<K>>>
    where
        for<'l> &'l L: ForceLaw<K>,
        S: NothingHeld,
    {
        let (placed, q) = Placed::at(self.robot, &self.start);
        let laws = Laws {
            placed: &placed,
            torque: &self.torque,
            wrenches: &self.wrenches,
            greatest: self.setting.greatest.as_ref(),
        };
        let qd = self.velocities.clone();
        let end = self
            .setting
            .run(&self.method, &placed, &laws, Phase { q, qd });
        placed.motion(end)
    }
}

impl<R: EquationsOfMotion<K>, L, K: Sizes> Simulation<'_, R, L, K, Sampled> {
    /// Runs the simulation, as under laws that are functions of time and state.
    ///
    /// # Errors
    ///
    /// [`SimulationError`], as under these.
    pub fn run(&mut self) -> Result<SizedTrajectory<K>, Box<SizedSimulationError<K>>>
    where
        L: ForceLaw<K>,
    {
        let (placed, q) = Placed::at(self.robot, &self.start);
        let qd = self.velocities.clone();
        let laws = Laws {
            placed: &placed,
            torque: SampledLaw {
                period: Some(self.asked.period),
                law: RefCell::new(&mut self.torque),
                held: RefCell::new(self.robot.size().vector()),
            },
            wrenches: &self.wrenches,
            greatest: self.setting.greatest.as_ref(),
        };
        let end = self
            .setting
            .run(&self.method, &placed, &laws, Phase { q, qd });
        placed.motion(end)
    }
}

/// A run that is requested, whatever moves the robot by which method.
#[derive(Clone, Debug)]
struct Setting<D: Size> {
    friction: Law<D>,
    limits: Limits<D>,
    /// The greatest torques, where motors saturate.
    greatest: Option<D::Vector>,
    plan: Plan,
}

impl<D: Size> Setting<D> {
    fn new(size: D) -> Self {
        Setting {
            friction: Law::sign(size),
            limits: Limits::none(size),
            greatest: None,
            plan: Plan::default(),
        }
    }

    fn run(
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

#[cfg(test)]
mod friction_tests;
#[cfg(doctest)]
mod refused_tests;
#[cfg(test)]
mod tests;
