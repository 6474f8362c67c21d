//! Friction and limits of the table, as a simulation takes them.

use dynamics_runtime::table::AsArm as _;

use super::friction::Law;
use super::limits::{AtLimit, Limits};
use super::torque;
use super::{Friction, Simulation, SizedModel, Sizes};

impl<R, L, S, K: Sizes> Simulation<'_, R, L, K, S> {
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
    /// the position (and of 1 rad or m), those of several joints together. With [`Method::ExplicitEuler`](super::Method::ExplicitEuler) they end at a
    /// rise of half the acceleration times its step squared. Elastic ones that friction damps shrink slowly: once their work is
    /// great, bounces that rise by less than the tolerance (1e-9 by fixed steps) are rest. Others without end are
    /// [`Cause::Impacts`](super::Cause::Impacts).
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

    /// Ends the run in [`Cause::JointLimit`](super::Cause::JointLimit) where a joint passes one of the `limits` of the
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
}
