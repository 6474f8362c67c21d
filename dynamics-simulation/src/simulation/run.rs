//! Simulations are run.

use core::cell::RefCell;

use dynamics_runtime::{JointVector as _, Size as _};
use nalgebra::Dim as _;

use super::error::{InvalidSetting, SizedSimulationError};
use super::law::ForceLaw;
use super::placed::Placed;
use super::sampling::{NothingHeld, Sampled, WithoutPeriod};
use super::torque::{Laws, SampledLaw};
use super::trajectory::SizedTrajectory;
use super::{EquationsOfMotion, Simulation, Sizes};
use crate::integrate::Phase;

impl<R: EquationsOfMotion<K>, L, K: Sizes, S: WithoutPeriod> Simulation<'_, R, L, K, S> {
    /// Runs the simulation. For an arm it allocates the samples at the start and nothing later.
    ///
    /// On a base that moves, methods are explicit ones; its rotation stays one within 1e-15, however many steps there are.
    ///
    /// # Errors
    ///
    /// [`SizedSimulationError`] with the time and the state reached and all samples up to there; its [`Cause`](super::Cause) says why.
    /// Implicit methods on a base that moves are an invalid setting. Never panics, unless a law does.
    pub fn run(&self) -> Result<SizedTrajectory<K>, Box<SizedSimulationError<K>>>
    where
        for<'l> &'l L: ForceLaw<K>,
        S: NothingHeld,
    {
        self.validate_start()?;
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
    /// [`SimulationError`](super::SimulationError), as under these.
    pub fn run(&mut self) -> Result<SizedTrajectory<K>, Box<SizedSimulationError<K>>>
    where
        L: ForceLaw<K>,
    {
        self.validate_start()?;
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

impl<R: EquationsOfMotion<K>, L, K: Sizes, S> Simulation<'_, R, L, K, S> {
    /// Whether the start has as many numbers as the robot: no compiler knows, where the robot is known at run time.
    fn validate_start(&self) -> Result<(), Box<SizedSimulationError<K>>> {
        let positions = self.start.q.entries().len();
        let velocities = self.velocities.entries().len();
        let joints = self.robot.joints().value();
        let freedoms = self.robot.size().value();
        let setting = if positions != joints {
            InvalidSetting::Positions {
                expected: joints,
                found: positions,
            }
        } else if velocities != freedoms {
            InvalidSetting::Velocities {
                expected: freedoms,
                found: velocities,
            }
        } else {
            return Ok(());
        };
        Err(Box::new(SizedSimulationError {
            time: 0.0,
            base: self.start.pose(),
            q: self.start.q.clone(),
            qd: self.velocities.clone(),
            cause: setting.into(),
            joint_names: Vec::new(),
            trajectory: SizedTrajectory::default(),
        }))
    }
}
