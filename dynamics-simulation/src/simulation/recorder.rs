//! A run as it goes on.
//!
//! Accelerations and torques, which are recorded beside the phase, are evaluated once more at each sample. This
//! counts as no work: torques of a law with a memory could not be had afterwards.

use dynamics_runtime::{Pose, Size};

use super::error::{Cause, InvalidSetting, Outcome, SizedSimulationError};
use super::joint_set::JointSet;
use super::plan::Plan;
use super::trajectory::{SizedTrajectory, Work};
use crate::integrate::{Grid, Phase, sample_time};

/// A sample in the coordinates of an integration.
pub(super) struct Taken<D: Size> {
    pub(super) t: f64,
    /// The pose of a base that moves.
    pub(super) base: Option<Pose<f64>>,
    pub(super) q: D::Vector,
    pub(super) qd: D::Vector,
    pub(super) qdd: D::Vector,
    pub(super) tau: D::Vector,
}

/// A run as it is recorded: the plan of its samples, the samples taken, the phase reached.
pub(super) struct Recorder<D: Size> {
    pub(super) t: f64,
    pub(super) phase: Phase<D>,
    pub(super) work: Work,
    /// The joints that creep.
    pub(super) creeping: JointSet,
    trajectory: SizedTrajectory<D>,
    pub(super) duration: f64,
    samples: usize,
}

impl<D: Size> Recorder<D> {
    /// At the start, with nothing planned.
    pub(super) fn new(phase: Phase<D>) -> Self {
        Recorder {
            t: 0.0,
            phase,
            work: Work::default(),
            creeping: JointSet::default(),
            trajectory: SizedTrajectory::default(),
            duration: 0.0,
            samples: 0,
        }
    }

    /// The run as it ended, of which `evaluations` were a part of the work.
    pub(super) fn finished(self, end: Result<(), Cause>, evaluations: u64) -> Outcome<D> {
        let (time, Phase { q, qd }) = (self.t, self.phase);
        let mut trajectory = self.trajectory;
        trajectory.work = Work {
            evaluations,
            ..self.work
        };
        trajectory.creeping = self.creeping;
        match end {
            Ok(()) => Ok(trajectory),
            Err(cause) => Err(Box::new(SizedSimulationError {
                time,
                base: Pose::identity(),
                q,
                qd,
                cause,
                joint_names: Vec::new(),
                trajectory,
            })),
        }
    }

    /// Makes room for all samples of a valid plan.
    pub(super) fn plan(&mut self, plan: &Plan) -> Result<(), InvalidSetting> {
        let samples = plan.samples;
        self.duration = plan.duration;
        self.samples = samples;
        let SizedTrajectory {
            t, q, qd, qdd, tau, ..
        } = &mut self.trajectory;
        let mut vectors = [q, qd, qdd, tau].into_iter();
        t.try_reserve_exact(samples)
            .and_then(|()| vectors.try_for_each(|list| list.try_reserve_exact(samples)))
            .map_err(|_| InvalidSetting::Samples(samples))
    }

    /// The ends of steps no longer than `longest`.
    pub(super) fn grid(&self, longest: f64) -> Grid {
        Grid::new(self.duration, self.intervals(), longest)
    }

    /// The time between two samples.
    pub(super) fn interval(&self) -> f64 {
        self.duration / self.intervals() as f64
    }

    /// How much of the way from the last sample to the next one is made.
    pub(super) fn share_of_interval(&self) -> f64 {
        let taken = self.trajectory.len() as f64;
        self.t / self.interval() - (taken - 1.0)
    }

    fn intervals(&self) -> u64 {
        self.samples as u64 - 1
    }

    /// Time of the next sample; `None` when all have been taken.
    pub(super) fn next_sample(&self) -> Option<f64> {
        let next = self.trajectory.len() as u64;
        (next <= self.intervals()).then(|| sample_time(self.duration, self.intervals(), next))
    }

    /// Moves to the end of a step, if that is a finite place.
    pub(super) fn reach(&mut self, t: f64, phase: Phase<D>) -> Result<(), Cause> {
        if let Some(joint) = phase.first_non_finite() {
            return Err(Cause::NonFiniteState { joint });
        }
        self.t = t;
        self.phase = phase;
        self.work.steps += 1;
        Ok(())
    }

    /// Takes a sample.
    pub(super) fn push(&mut self, sample: Taken<D>) {
        self.trajectory.base.extend(sample.base);
        self.trajectory.t.push(sample.t);
        self.trajectory.q.push(sample.q);
        self.trajectory.qd.push(sample.qd);
        self.trajectory.qdd.push(sample.qdd);
        self.trajectory.tau.push(sample.tau);
    }
}
