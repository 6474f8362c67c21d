//! Motion of a robot under a torque law.

mod arm;
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
mod of_table;
mod placed;
mod plan;
mod progress;
mod recorder;
mod run;
mod run_time;
mod sampling;
mod setting;
mod settings;
mod taylor;
mod torque;
mod trajectory;
mod wrench;

use dynamics_runtime::internal::Velocities;
use dynamics_runtime::{Pose, Size as _};
use nalgebra::Dim as _;

use method::Chosen;
use plan::plan_setters;
use setting::Setting;
use wrench::Wrenches;

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

    plan_setters!();
}

#[cfg(test)]
mod friction_tests;
#[cfg(doctest)]
mod refused_tests;
#[cfg(test)]
mod tests;
