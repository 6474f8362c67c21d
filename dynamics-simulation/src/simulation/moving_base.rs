//! Simulations of robots on a base that moves.

use dynamics_runtime::{OnBase, Place, Pose};
use nalgebra::{Matrix4, SMatrix, SVector, Vector6};

use super::{Sampled, Simulation, WithoutPeriod, WrenchAt};

/// On a base that moves, laws are given its pose too, and the six numbers of the base come first among velocities,
/// accelerations and forces.
impl<'a, R: 'a, L, S, const N: usize, const V: usize> Simulation<'a, R, L, OnBase<N, V>, S> {
    /// Where the base stands at t = 0, the positions of the joints, rad or m, and the velocities v: linear and angular
    /// velocity of the base in its own axes, m/s and rad/s, then those of the joints.
    ///
    /// ```
    /// use robot_dynamics::nalgebra::{SVector, Vector3};
    /// use robot_dynamics::{Pose, Simulation, robot_dynamics};
    ///
    /// robot_dynamics! {
    ///     /// A brick of 2 kg.
    ///     struct Brick;
    ///     convention: modified,
    ///     gravity: [0, 0, -10],
    ///     base: floating { mass: 2, inertia: cuboid(0.1, 0.2, 0.3) },
    ///     joints: [],
    /// }
    ///
    /// // It is thrown up at 5 m/s, and turns about its x axis twice a second.
    /// let turns = 4.0 * core::f64::consts::PI;
    /// let v = SVector::from([0.0, 0.0, 5.0, turns, 0.0, 0.0]);
    /// let throw = Simulation::new(&Brick).initial(Pose::identity(), SVector::zeros(), v).run()?;
    /// let end = throw.last().ok_or("no sample")?;
    /// assert!(end.base.position.norm() < 1e-8);
    /// assert!((end.base.rotation.column(1) - Vector3::y()).norm() < 1e-7);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn initial(self, base: Pose<f64>, q: SVector<f64, N>, v: SVector<f64, V>) -> Self {
        let base = Some(base);
        self.starting(Place { base, q }, v)
    }

    /// A force of the surroundings at a frame, besides those that were given before. `place` returns the pose and the
    /// Jacobian of the frame. `law` returns the wrench (fx fy fz nx ny nz), N and N m, at the frame's origin in the
    /// axes of the world, as a function of t in s, that pose and the frame's twist.
    ///
    /// ```
    /// use robot_dynamics::nalgebra::{SVector, Vector6};
    /// use robot_dynamics::{Pose, Simulation, robot_dynamics};
    ///
    /// robot_dynamics! {
    ///     /// A ball of 1 kg on a rope that is tied to it at one side.
    ///     struct Ball;
    ///     convention: modified,
    ///     gravity: [0, 0, -10],
    ///     base: floating { mass: 1, inertia: sphere(0.1) },
    ///     joints: [],
    ///     frames: { knot: { on: base, xyz: [0, 0, 0.1] } },
    ///     functions: [default, at_knot = (forward_kinematics(knot), jacobian(knot))],
    /// }
    ///
    /// // The rope carries the ball.
    /// let motion = Simulation::new(&Ball)
    ///     .wrench_at(
    ///         |ball, base, q| ball.at_knot(base, q),
    ///         |_t, _pose, _twist| Vector6::new(0.0, 0.0, 10.0, 0.0, 0.0, 0.0),
    ///     )
    ///     .run()?;
    /// assert!(motion.base[100].position.norm() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn wrench_at<P, F>(self, place: P, law: F) -> Self
    where
        P: Fn(&R, &Pose<f64>, &SVector<f64, N>) -> (Matrix4<f64>, SMatrix<f64, 6, V>) + 'a,
        F: Fn(f64, &Matrix4<f64>, &Vector6<f64>) -> Vector6<f64> + 'a,
    {
        self.with_wrench(WrenchAt::new(place, law))
    }
}

impl<'a, R, L, const N: usize, const V: usize, S: WithoutPeriod>
    Simulation<'a, R, L, OnBase<N, V>, S>
{
    /// The forces on the base and at the joints as a function of t in s, the pose of the base, q in rad or m, and the
    /// velocities v. The first six are the force at the origin of the base's frame, N, and the moment about it, N m, in the
    /// axes of the base; then the torques or forces of the joints.
    ///
    /// As for a base that stands, the law must be a function of its arguments alone, unless it is given after
    /// [`control_period`](Simulation::control_period).
    pub fn torque<F>(self, law: F) -> Simulation<'a, R, F, OnBase<N, V>, S>
    where
        F: Fn(f64, &Pose<f64>, &SVector<f64, N>, &SVector<f64, V>) -> SVector<f64, V>, // with a memory: `.control_period(1e-3).torque(law)`
    {
        self.with_laws(|_, asked| (law, asked))
    }
}

impl<'a, R, L, const N: usize, const V: usize> Simulation<'a, R, L, OnBase<N, V>, Sampled> {
    /// The forces on the base and at the joints, which are held for a period. The law may have a memory: it is called once
    /// each period, in order.
    pub fn torque<F>(self, law: F) -> Simulation<'a, R, F, OnBase<N, V>, Sampled>
    where
        F: FnMut(f64, &Pose<f64>, &SVector<f64, N>, &SVector<f64, V>) -> SVector<f64, V>,
    {
        self.with_laws(|_, asked| (law, asked))
    }
}
