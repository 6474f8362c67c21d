//! Motion of an arm under a torque law.

mod contacts;
mod drive;
mod error;
mod friction;
mod method;
mod motion;
mod plan;
mod recorder;
mod settings;
mod sticking;
mod taylor;
mod tool_force;
mod torque;
mod trajectory;

use nalgebra::{Matrix4, SVector, Vector6};

use crate::friction::DryFriction;
use crate::integrate::Phase;
use crate::{ForwardDynamics, Kinematics, Model};
use friction::Law;
use motion::Motion;
use plan::Plan;
use recorder::Recorder;
use torque::Laws;

pub use error::{Cause, InvalidSetting, SimulationError};
pub use friction::Friction;
pub use method::Method;
pub use settings::{Dop853, DormandPrince, Radau5};
pub use taylor::{Taylor, TaylorSimulation};
pub use tool_force::{NoToolForce, ToolForce};
pub use torque::NoTorque;
pub use trajectory::{Trajectory, Work};

/// A simulation of an arm: set it up, then [`run`](Simulation::run) it.
///
/// As it is made, the arm starts from rest at q = 0, moves freely for 1 s, is sampled 101 times
/// and is integrated by [`DormandPrince`] with its default tolerance.
///
/// ```
/// use dynamics_runtime::nalgebra::{SVector, Vector1};
/// use dynamics_runtime::{ForwardDynamics, Scalar, Simulation, SingularMassMatrix};
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
pub struct Simulation<'a, R, L, const N: usize, W = NoToolForce> {
    robot: &'a R,
    torque: L,
    tool_force: W,
    method: Method,
    friction: Law<N>,
    plan: Plan<N>,
}

impl<'a, R, const N: usize> Simulation<'a, R, NoTorque<N>, N>
where
    R: ForwardDynamics<N>,
{
    /// Free motion of the arm.
    pub fn new(robot: &'a R) -> Self {
        Simulation {
            robot,
            torque: |_, _, _| SVector::zeros(),
            tool_force: NoToolForce,
            method: Method::default(),
            friction: Law::sign(),
            plan: Plan::new(),
        }
    }
}

impl<'a, R, L, W, const N: usize> Simulation<'a, R, L, N, W> {
    /// The joint torques as a function of t in s, q in rad or m, and qd; in N m or N.
    pub fn torque<F>(self, law: F) -> Simulation<'a, R, F, N, W>
    where
        F: Fn(f64, &SVector<f64, N>, &SVector<f64, N>) -> SVector<f64, N>,
    {
        let Simulation {
            robot,
            tool_force,
            method,
            friction,
            plan,
            ..
        } = self;
        Simulation {
            robot,
            torque: law,
            tool_force,
            method,
            friction,
            plan,
        }
    }

    /// What the surroundings do to the tool: a wrench (fx fy fz nx ny nz) in N and N m as a function of t
    /// in s, the tip's pose, and its twist (vx vy vz wx wy wz). Forces act at the tip's origin, the
    /// point of `forward_kinematics`; axes are those of `jacobian`. J^T w is added to the torques of the
    /// motors, by any method of integration; joints that stick feel it.
    ///
    /// ```
    /// use dynamics_runtime::nalgebra::{SVector, Vector6};
    /// use dynamics_runtime::{Simulation, robot_dynamics};
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
    ///     .tool_force(|_t, pose, _twist| {
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
    /// An arm whose functions lack one of the two is refused:
    ///
    /// ```compile_fail,E0277
    /// # use dynamics_runtime::nalgebra::Vector6;
    /// # use dynamics_runtime::{Simulation, robot_dynamics};
    /// robot_dynamics! {
    ///     struct Cart;
    ///     convention: modified,
    ///     gravity: [0, -9.81, 0],
    ///     joints: [rail: prismatic { mass: 2 }],
    ///     functions: [default, jacobian],
    /// }
    ///
    /// Simulation::new(&Cart).tool_force(|_, _, _| Vector6::zeros()).run();
    /// ```
    pub fn tool_force<F>(self, law: F) -> Simulation<'a, R, L, N, F>
    where
        R: Kinematics<N>,
        F: Fn(f64, &Matrix4<f64>, &Vector6<f64>) -> Vector6<f64>,
    {
        let Simulation {
            robot,
            torque,
            method,
            friction,
            plan,
            ..
        } = self;
        Simulation {
            robot,
            torque,
            tool_force: law,
            method,
            friction,
            plan,
        }
    }

    /// The method of integration: a [`Method`], or the settings of [`DormandPrince`] alone.
    pub fn method(self, method: impl Into<Method>) -> Self {
        Simulation {
            method: method.into(),
            ..self
        }
    }

    /// What becomes of the dry friction in the arm's table; [`Friction::Sign`] as it is made.
    pub fn friction(self, kind: Friction) -> Self
    where
        R: Model<N>,
    {
        let rows = self.robot.table().rows;
        let dry = rows.each_ref().map(DryFriction::of);
        let friction = Law { kind, dry };
        Simulation { friction, ..self }
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

impl<R, L, W, const N: usize> Simulation<'_, R, L, N, W>
where
    R: ForwardDynamics<N>,
    L: Fn(f64, &SVector<f64, N>, &SVector<f64, N>) -> SVector<f64, N>,
    W: ToolForce<R, N>,
{
    /// Runs the simulation. It allocates the samples at the start and nothing later.
    ///
    /// # Errors
    ///
    /// [`SimulationError`], with the time and the state reached and all samples up to there, where
    /// a setting is invalid, where the motion reaches a singular mass matrix or a torque, a force, an
    /// acceleration or a state that is not finite, and where the error cannot be held
    /// ([`Cause`]). Never panics, unless a law does.
    pub fn run(&self) -> Result<Trajectory<N>, Box<SimulationError<N>>> {
        let mut recorder = Recorder::new(self.plan.initial);
        let laws = Laws {
            robot: self.robot,
            torque: &self.torque,
            tool_force: &self.tool_force,
        };
        let motion = Motion::new(self.robot, &laws, self.friction);
        let end = self.record(&motion, &mut recorder);
        recorder.finished(end, motion.evaluations())
    }

    fn record(
        &self,
        motion: &Motion<R, Laws<R, L, W>, N>,
        recorder: &mut Recorder<N>,
    ) -> Result<(), Cause> {
        self.plan.validate()?;
        self.friction.validate()?;
        self.method.validate(self.plan.duration)?;
        recorder.plan(&self.plan)?;
        self.method.integrate(motion, recorder)
    }
}

#[cfg(test)]
mod friction_tests;
#[cfg(test)]
mod tests;
