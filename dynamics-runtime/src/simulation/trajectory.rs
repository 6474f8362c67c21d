//! The motion that a run returns.

use nalgebra::Const;

use crate::Energy;
use crate::size::Size;

/// A sampled motion: sample k is `(t[k], q[k], qd[k])`, with the accelerations `qdd[k]` and the torques
/// `tau[k]` there.
///
/// Velocities, accelerations and torques that jump at the time of a sample, by an impact or a controller, are those
/// after it. The first sample is the initial state as it was given.
///
/// [`Trajectory`] is that of an arm whose number of joints the compiler knows.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(bound = "")
)]
#[non_exhaustive]
pub struct SizedTrajectory<D: Size> {
    /// Times, s.
    pub t: Vec<f64>,
    /// Joint positions, rad or m.
    #[cfg_attr(feature = "serde", serde(with = "crate::sequences::vectors"))]
    pub q: Vec<D::Vector>,
    /// Joint velocities, rad/s or m/s.
    #[cfg_attr(feature = "serde", serde(with = "crate::sequences::vectors"))]
    pub qd: Vec<D::Vector>,
    /// Joint accelerations under all forces that act on the arm, rad/s^2 or m/s^2; NaN where they could not be
    /// computed. Computing them does not count in [`work`](SizedTrajectory::work).
    #[cfg_attr(feature = "serde", serde(with = "crate::sequences::vectors"))]
    pub qdd: Vec<D::Vector>,
    /// Torques of the motors, as the torque law returns them, N m or N; those of a sampled law are held between its
    /// samples. They do not include the force at the tool.
    #[cfg_attr(feature = "serde", serde(with = "crate::sequences::vectors"))]
    pub tau: Vec<D::Vector>,
    /// The work of the run.
    pub work: Work,
}

/// The sampled motion of an arm of `N` joints.
pub type Trajectory<const N: usize> = SizedTrajectory<Const<N>>;

impl<D: Size> Default for SizedTrajectory<D> {
    fn default() -> Self {
        SizedTrajectory {
            t: Vec::new(),
            q: Vec::new(),
            qd: Vec::new(),
            qdd: Vec::new(),
            tau: Vec::new(),
            work: Work::default(),
        }
    }
}

/// A sample of a motion.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Sample<D: Size> {
    /// The time, s.
    pub t: f64,
    /// Joint positions, rad or m.
    pub q: D::Vector,
    /// Joint velocities, rad/s or m/s.
    pub qd: D::Vector,
    /// Joint accelerations, rad/s^2 or m/s^2; NaN where the trajectory has none.
    pub qdd: D::Vector,
    /// Torques of the motors, N m or N; NaN where the trajectory has none.
    pub tau: D::Vector,
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

impl<D: Size> SizedTrajectory<D> {
    /// The number of samples.
    pub fn len(&self) -> usize {
        self.t.len()
    }

    /// Whether there is no sample.
    pub fn is_empty(&self) -> bool {
        self.t.is_empty()
    }
}

impl<D: Size> SizedTrajectory<D> {
    /// The samples, one after the other. There are as many as the shortest of the lists `t`, `q` and `qd` has.
    ///
    /// ```
    /// # extern crate dynamics_runtime as robot_dynamics;
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
    pub fn samples(&self) -> impl DoubleEndedIterator<Item = Sample<D>> + ExactSizeIterator {
        let count = self.t.len().min(self.q.len()).min(self.qd.len());
        (0..count).map(|k| {
            let (q, qd) = (self.q[k].clone(), self.qd[k].clone());
            let unknown = || D::of(&q).vector_of(|_| f64::NAN);
            let [qdd, tau] =
                [&self.qdd, &self.tau].map(|list| list.get(k).cloned().unwrap_or_else(unknown));
            let t = self.t[k];
            Sample { t, q, qd, qdd, tau }
        })
    }

    /// The last sample; `None` where there is none.
    pub fn last(&self) -> Option<Sample<D>> {
        self.samples().next_back()
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

/// The largest distance from the first; 0 of none, NaN if one is no number.
pub(super) fn drift(energies: &[f64]) -> f64 {
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
