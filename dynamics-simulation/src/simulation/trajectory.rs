//! The motion that a run returns.

use dynamics_runtime::internal::{Velocities, moves};
use dynamics_runtime::{Energy, OnBase, Place, Pose, Size, SizedModel, Sizes};
use nalgebra::{Const, Dyn};

use super::joint_set::JointSet;
#[cfg(feature = "serde")]
use dynamics_runtime::JointVector as _;

/// A sampled motion: sample k is `(t[k], q[k], qd[k])`, with the accelerations `qdd[k]` and the torques
/// `tau[k]` there, and with `base[k]` on a base that moves.
///
/// Velocities, accelerations and torques that jump at the time of a sample, by an impact or a controller, are those
/// after it. The first sample is the initial state as it was given. On a base that moves, velocities, accelerations and
/// torques have the six numbers of the base first, in its own axes.
///
/// [`Trajectory`] is that of an arm whose number of joints the compiler knows, [`FloatingTrajectory`] that on a base that moves.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(remote = "Self", bound = "")
)]
#[non_exhaustive]
pub struct SizedTrajectory<K: Sizes> {
    /// Times, s.
    pub t: Vec<f64>,
    /// The poses of a base that moves; none of one that stands. Rotations are within 1e-15 of orthogonal, however long the
    /// run.
    #[cfg_attr(
        feature = "serde",
        serde(default, skip_serializing_if = "Vec::is_empty")
    )]
    pub base: Vec<Pose<f64>>,
    /// Joint positions, rad or m.
    #[cfg_attr(feature = "serde", serde(with = "dynamics_runtime::internal::vectors"))]
    pub q: Vec<<K::Joints as Size>::Vector>,
    /// Velocities, rad/s or m/s.
    #[cfg_attr(feature = "serde", serde(with = "dynamics_runtime::internal::vectors"))]
    pub qd: Vec<Velocities<K>>,
    /// Accelerations under all forces that act on the robot, rad/s^2 or m/s^2; NaN where they could not be
    /// computed. Computing them does not count in [`work`](SizedTrajectory::work).
    #[cfg_attr(feature = "serde", serde(with = "dynamics_runtime::internal::vectors"))]
    pub qdd: Vec<Velocities<K>>,
    /// Torques of the motors, and what is applied to a base that moves, as the torque law returns them, N m or N; those of a
    /// sampled law are held between its samples. They do not include the forces at the tool and at frames.
    #[cfg_attr(feature = "serde", serde(with = "dynamics_runtime::internal::vectors"))]
    pub tau: Vec<Velocities<K>>,
    /// The work of the run.
    pub work: Work,
    /// The joints that crept, counted as the velocities: a force that jumps at rest, such as dry friction by its sign, held
    /// them at rest, and steps of fixed length left them a velocity of the order of the step.
    ///
    /// [`Friction::Sticking`](crate::Friction::Sticking) lets such a joint stand. Under error control a joint does not creep
    /// by more than the tolerance, and is not listed.
    #[cfg_attr(
        feature = "serde",
        serde(default, skip_serializing_if = "JointSet::is_empty")
    )]
    pub creeping: JointSet,
}

#[cfg(feature = "serde")]
impl<K: Sizes> serde::Serialize for SizedTrajectory<K> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        SizedTrajectory::serialize(self, serializer)
    }
}

/// Data that no run returns are refused.
#[cfg(feature = "serde")]
impl<'de, K: Sizes> serde::Deserialize<'de> for SizedTrajectory<K> {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let motion = SizedTrajectory::deserialize(deserializer)?;
        motion.validate().map_err(serde::de::Error::custom)?;
        Ok(motion)
    }
}

/// The sampled motion of an arm of `N` joints.
pub type Trajectory<const N: usize> = SizedTrajectory<Const<N>>;

/// The sampled motion of a robot of `N` joints on a base that moves; `V` is 6 + N.
pub type FloatingTrajectory<const N: usize, const V: usize> = SizedTrajectory<OnBase<N, V>>;

impl<K: Sizes> Default for SizedTrajectory<K> {
    fn default() -> Self {
        SizedTrajectory {
            t: Vec::new(),
            base: Vec::new(),
            q: Vec::new(),
            qd: Vec::new(),
            qdd: Vec::new(),
            tau: Vec::new(),
            work: Work::default(),
            creeping: JointSet::default(),
        }
    }
}

/// A sample of a motion.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Sample<K: Sizes> {
    /// The time, s.
    pub t: f64,
    /// The pose of a base that moves; the identity of one that stands.
    pub base: Pose<f64>,
    /// Joint positions, rad or m.
    pub q: <K::Joints as Size>::Vector,
    /// Velocities, rad/s or m/s.
    pub qd: Velocities<K>,
    /// Accelerations, rad/s^2 or m/s^2; NaN where the trajectory has none.
    pub qdd: Velocities<K>,
    /// Torques of the motors, and what is applied to a base that moves, N m or N; NaN where the trajectory has none.
    pub tau: Velocities<K>,
}

/// The work of a run, for comparing methods.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Work {
    /// How often the equations of motion were evaluated, including the steps that were thrown away.
    ///
    /// One evaluation is one call of the forward dynamics, of the derivatives of positions and momenta, or of a Taylor
    /// series.
    pub evaluations: u64,
    /// Steps made.
    pub steps: u64,
    /// Steps thrown away because their error was too large, or an evaluation was refused.
    pub rejected: u64,
}

#[cfg(feature = "serde")]
impl<K: Sizes> SizedTrajectory<K> {
    /// Whether these are samples of a motion: as many of each quantity, at times that grow, in finite states.
    fn validate(&self) -> Result<(), String> {
        let count = self.t.len();
        let mut lists = vec![
            ("q", self.q.len()),
            ("qd", self.qd.len()),
            ("qdd", self.qdd.len()),
            ("tau", self.tau.len()),
        ];
        if self.base_moves() {
            lists.push(("base", self.base.len()));
        }
        if let Some((list, found)) = lists.into_iter().find(|(_, found)| *found != count) {
            return Err(format!(
                "{count} times in `t`, and {found} entries in `{list}`"
            ));
        }
        let is_finite = |k: &usize| {
            let states = [self.q[*k].entries(), self.qd[*k].entries()];
            self.t[*k].is_finite() && states.concat().iter().all(|x| x.is_finite())
        };
        if let Some(k) = (0..count).find(|k| !is_finite(k)) {
            return Err(format!(
                "the time, a position or a velocity of sample {} is not finite",
                k + 1
            ));
        }
        match (1..count).find(|k| self.t[k - 1] >= self.t[*k]) {
            Some(k) => {
                let [before, after] = [self.t[k - 1], self.t[k]];
                Err(format!(
                    "times must grow from sample to sample: {after:?} s stands behind {before:?} s"
                ))
            }
            None => Ok(()),
        }
    }
}

impl<K: Sizes> SizedTrajectory<K> {
    /// Whether the base moves: the sizes say it, or poses do if these are known at run time alone.
    pub(crate) fn base_moves(&self) -> bool {
        moves::<K>() || !self.base.is_empty()
    }

    /// The number of samples.
    pub fn len(&self) -> usize {
        self.t.len()
    }

    /// Whether there is no sample.
    pub fn is_empty(&self) -> bool {
        self.t.is_empty()
    }

    /// Where the robot is at each sample.
    #[doc(hidden)]
    pub fn places(&self) -> impl DoubleEndedIterator<Item = Place<K::Joints>> + ExactSizeIterator {
        let moves = self.base_moves();
        let count = if moves { self.base.len() } else { self.q.len() };
        let place = move |(k, q): (usize, &<K::Joints as Size>::Vector)| Place {
            base: moves.then(|| self.base[k]),
            q: q.clone(),
        };
        self.q[..count.min(self.q.len())]
            .iter()
            .enumerate()
            .map(place)
    }

    /// The samples, one after the other. There are as many as the shortest of the lists `t`, `base`, `q` and `qd` has.
    ///
    /// ```
    /// # use robot_dynamics::{Simulation, robot_dynamics};
    /// # robot_dynamics! {
    /// #     /// A stone that falls along z.
    /// #     struct Stone;
    /// #     convention: modified,
    /// #     gravity: [0, 0, -8],
    /// #     joints: [height: prismatic { mass: 2 }],
    /// # }
    /// let fall = Simulation::new(&Stone).samples(3).run()?;
    /// for sample in fall.samples() {
    ///     assert!((sample.q[0] + 4.0 * sample.t * sample.t).abs() < 1e-12);
    /// }
    /// // The motion goes on from its last sample.
    /// let end = fall.last().ok_or("no sample")?;
    /// let later = Simulation::new(&Stone).initial(end.q, end.qd).run()?;
    /// assert!((later.q[100][0] + 16.0).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn samples(&self) -> impl DoubleEndedIterator<Item = Sample<K>> + ExactSizeIterator {
        let states = self.places().zip(&self.qd).zip(&self.t).enumerate();
        states.map(|(k, ((place, qd), t))| {
            let unknown = || K::Freedoms::of(qd).vector_of(|_| f64::NAN);
            let [qdd, tau] =
                [&self.qdd, &self.tau].map(|list| list.get(k).cloned().unwrap_or_else(unknown));
            Sample {
                t: *t,
                base: place.pose(),
                q: place.q,
                qd: qd.clone(),
                qdd,
                tau,
            }
        })
    }

    /// The last sample; `None` where there is none.
    pub fn last(&self) -> Option<Sample<K>> {
        self.samples().next_back()
    }

    /// Kinetic and potential energy at each sample, J, where the robot knows them.
    #[doc(hidden)]
    pub fn both_energies<R: SizedModel<K>>(
        &self,
        robot: &R,
    ) -> impl Iterator<Item = Option<[f64; 2]>> {
        let states = self.places().zip(&self.qd);
        states.map(|(place, qd)| robot.sized_energies(&place, qd))
    }
}

impl<const N: usize> Trajectory<N> {
    /// Kinetic plus potential energy at every sample, J.
    pub fn energies<R: Energy<N>>(&self, robot: &R) -> Vec<f64> {
        let energy =
            |(q, qd)| robot.kinetic_energy::<f64>(q, qd) + robot.potential_energy::<f64>(q);
        self.q.iter().zip(&self.qd).map(energy).collect()
    }

    /// The largest distance of the energy from that of the first sample, J; 0 without samples, NaN
    /// where an energy is not a number.
    ///
    /// In free motion without friction the energy is constant, and this is an error of the integration. It includes the
    /// interpolation error of samples between steps, which is of lower order than that of the steps and grows with
    /// their length.
    pub fn energy_drift<R: Energy<N>>(&self, robot: &R) -> f64 {
        drift(&self.energies(robot))
    }
}

macro_rules! energies {
    ($($k:ty $(, $n:ident)*;)*) => {$(
        impl<$(const $n: usize),*> SizedTrajectory<$k> {
            /// Kinetic plus potential energy at every sample, J; NaN for a robot without both functions.
            pub fn energies<R: SizedModel<$k>>(&self, robot: &R) -> Vec<f64> {
                let sum = |[kinetic, potential]: [f64; 2]| kinetic + potential;
                let energies = self.both_energies(robot);
                energies.map(|both| both.map_or(f64::NAN, sum)).collect()
            }

            /// As [`Trajectory::energy_drift`].
            pub fn energy_drift<R: SizedModel<$k>>(&self, robot: &R) -> f64 {
                drift(&self.energies(robot))
            }
        }
    )*};
}

energies! {
    OnBase<N, V>, N, V;
    Dyn;
}

/// The largest distance from the first; 0 of none, NaN if one is no number.
fn drift(energies: &[f64]) -> f64 {
    let distances = energies.iter().map(|energy| (energy - energies[0]).abs());
    // Not `f64::max`, which drops a NaN.
    distances.fold(0.0, |worst: f64, next| {
        if worst.is_nan() || next <= worst {
            worst
        } else {
            next
        }
    })
}
