//! What a run returns.

use nalgebra::Const;

use crate::Energy;
use crate::size::Size;

/// A sampled motion: sample k is `(t[k], q[k], qd[k])`, with the accelerations `qdd[k]` and the torques
/// `tau[k]` there.
///
/// Where velocities, accelerations or torques jump at the time of a sample, at an impact or where a
/// controller begins a period, they are those after it; the first sample is the initial state as it was
/// given.
///
/// [`Trajectory`] is that of an arm whose number of joints the compiler knows.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(bound = "")
)]
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
    /// What the run took.
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

/// What is recorded of a motion beside its phase.
#[derive(Clone, Debug)]
pub(super) struct Forces<D: Size> {
    /// Accelerations.
    pub(super) qdd: D::Vector,
    /// Torques of the motors.
    pub(super) tau: D::Vector,
}

/// The work of a run, for comparing methods.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Work {
    /// How often the equations of motion were evaluated, including the steps that were thrown away.
    ///
    /// One evaluation is one call of the forward dynamics; for methods that work in positions and
    /// momenta, one of their derivatives; for the Taylor method, one series of the motion.
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

impl<const N: usize> Trajectory<N> {
    /// Kinetic plus potential energy at every sample, J.
    pub fn energies<R: Energy<N>>(&self, robot: &R) -> Vec<f64> {
        let states = self.q.iter().zip(&self.qd);
        let energy =
            |(q, qd)| robot.kinetic_energy::<f64>(q, qd) + robot.potential_energy::<f64>(q);
        states.map(energy).collect()
    }

    /// The largest distance of the energy from that of the first sample, J; 0 without samples, NaN
    /// where an energy is not a number.
    ///
    /// In free motion without friction the energy is constant, and this is an error of the
    /// integration. The samples of [`DormandPrince`](crate::simulation::DormandPrince) lie between its steps:
    /// the drift then includes the interpolation error of the dense output, which is of lower order
    /// than the steps and grows with their length.
    pub fn energy_drift<R: Energy<N>>(&self, robot: &R) -> f64 {
        let energies = self.energies(robot);
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
}
