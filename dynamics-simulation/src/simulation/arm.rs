//! Simulations of arms: laws are functions of q and qd.

use dynamics_runtime::SizedKinematics;
use nalgebra::{Const, Matrix4, SMatrix, SVector, Vector6};

use super::wrench::{HeldWrench, Tip, WrenchAt, Wrenches};
use super::{Asked, Place, Sampled, Simulation, WithoutPeriod};

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
