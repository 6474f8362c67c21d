//! Comparison of a generated model with the numeric recursive Newton-Euler algorithm.

mod accelerations;
mod at;
mod checked;
mod deviation;
mod functions;
mod identification;
mod report;
mod scale;
mod states;

use core::f64::consts::PI;
use core::ops::RangeInclusive;
use std::collections::BTreeMap;

use dynamics_runtime::table::AsArm as _;
use dynamics_runtime::{Certified, NAMES_OF_BASE, Pose, SizedState, certified::accelerations_near};
use nalgebra::{DMatrix, DVector, Dyn};

use crate::NumericArm;
use at::At;
use functions::for_deviations;
use report::Of;

pub use checked::{Checkable, Checked, FloatingRobot, StandingRobot};
pub use dynamics_runtime::internal::Numbers;
pub use dynamics_runtime::{Evaluate, Evaluation, FloatingEvaluate, FunctionValue};
pub use identification::{base_parameter_map, base_parameter_map_any};
pub use report::{FunctionReport, Report};

/// Compares every generated function of the robot with [`NewtonEuler`](crate::NewtonEuler) at the states of
/// [`Check::new`]. The report also has proven bounds of the rounding errors ([`Check::certify`]).
///
/// ```
/// use robot_dynamics::{check_against_rnea, robot_dynamics};
///
/// robot_dynamics! {
///     /// A mass that hangs from a horizontal axis.
///     struct Pendulum { mass: f64, length: f64 }
///     convention: modified,
///     gravity: [9.81, 0, 0],
///     joints: [pivot: revolute { mass: mass, com: [length, 0, 0] }],
/// }
///
/// let report = check_against_rnea(&Pendulum { mass: 2.0, length: 3.0 });
/// println!("{report}");
/// report.assert_ok();
/// ```
///
/// The base may move: the robot is compared with [`FloatingNewtonEuler`](crate::FloatingNewtonEuler) then.
pub fn check_against_rnea<R: Checkable<K>, K>(robot: &R) -> Report {
    Check::new().certify(robot)
}

/// Settings of a comparison with the numeric recursive Newton-Euler algorithm.
///
/// The states are special ones (all joints at zero, at multiples of a right angle, at about
/// 1000 rad, at rest) and then random ones, uniform in the ranges. For a joint with Stribeck friction there are more, at
/// velocities where that friction falls. Equal settings give equal states on every machine.
///
/// ```
/// # use robot_dynamics::{robot_dynamics, check::Check};
/// # robot_dynamics! {
/// #     struct Pendulum;
/// #     convention: modified,
/// #     gravity: [9.81, 0, 0],
/// #     joints: [pivot: revolute { mass: 2, com: [3, 0, 0] }],
/// # }
/// let check = Check::new().samples(1000).seed(7).velocities(-20.0..=20.0);
/// assert!(check.run(&Pendulum).is_ok());
/// ```
#[derive(Clone, Debug)]
pub struct Check {
    samples: usize,
    seed: u64,
    positions: RangeInclusive<f64>,
    velocities: RangeInclusive<f64>,
    accelerations: RangeInclusive<f64>,
    tolerance: f64,
}

/// Tolerance of a relative error, per joint, those that follow others included.
///
/// Each link that a result passes through adds a few roundings of 1.1e-16 on either side of the
/// comparison. Arms of up to 12 joints stay below 1e-15 per joint. A wrong term is wrong in its
/// first digits. In the wide gap between, this bound stands nearer to the roundings.
const TOLERANCE_PER_JOINT: f64 = 1e-13;

impl Check {
    /// 100 random states beside the special ones, seed 0, positions within pi, velocities within 3,
    /// accelerations within 10, a tolerance of 1e-13 per joint.
    pub fn new() -> Self {
        Check {
            samples: 100,
            seed: 0,
            positions: -PI..=PI,
            velocities: -3.0..=3.0,
            accelerations: -10.0..=10.0,
            tolerance: TOLERANCE_PER_JOINT,
        }
    }

    /// Number of random states.
    pub fn samples(self, samples: usize) -> Self {
        Check { samples, ..self }
    }

    /// Seed of the random states.
    pub fn seed(self, seed: u64) -> Self {
        Check { seed, ..self }
    }

    /// Range of the random joint positions, rad or m.
    pub fn positions(self, positions: RangeInclusive<f64>) -> Self {
        Check { positions, ..self }
    }

    /// Range of the random joint velocities, rad/s or m/s.
    pub fn velocities(self, velocities: RangeInclusive<f64>) -> Self {
        Check { velocities, ..self }
    }

    /// Range of the random joint accelerations, rad/s^2 or m/s^2.
    pub fn accelerations(self, accelerations: RangeInclusive<f64>) -> Self {
        Check {
            accelerations,
            ..self
        }
    }

    /// Tolerance of a relative error, per joint, those that follow others included.
    pub fn tolerance(self, tolerance: f64) -> Self {
        Check { tolerance, ..self }
    }

    /// Compares every generated function of the robot at all states.
    pub fn run<R: Checkable<K>, K>(&self, robot: &R) -> Report {
        self.run_any(&*robot.checked())
    }

    /// The same, and beside the largest error of each function the largest proven bound of its rounding errors. For the
    /// bounds, the functions are evaluated in [`Certified`] numbers too; accelerations are also bounded by their
    /// residual if `mass_matrix` and `inverse_dynamics` were generated. An error well above its bound is more than
    /// rounding, unless it comes from the numeric algorithm.
    ///
    /// There are no bounds for arms that were not generated, nor for the parts of a method that returns several
    /// functions.
    pub fn certify<R: Checkable<K>, K>(&self, robot: &R) -> Report {
        self.certify_any(&*robot.checked())
    }

    /// [`run`](Check::run) of a robot whose number of joints is known at run time alone.
    pub fn run_any(&self, robot: &dyn Checked) -> Report {
        self.report(robot, false)
    }

    /// [`certify`](Check::certify) of a robot whose number of joints is known at run time alone.
    pub fn certify_any(&self, robot: &dyn Checked) -> Report {
        self.report(robot, true)
    }

    /// The report, with the roundings if they are requested. It is compiled once for all robots.
    fn report(&self, robot: &dyn Checked, is_certified: bool) -> Report {
        let table = robot.runtime_table();
        let arm = table.arm();
        let numeric = NumericArm::on_any_base(&table);
        let mut farthest = vec![1.0_f64; arm.rows.len()];
        for follower in table.followers() {
            let farthest = &mut farthest[follower.leader];
            *farthest = farthest.max(follower.factor.abs());
        }
        let joints: Vec<_> = arm.rows.iter().map(|row| row.joint_type).collect();
        let mut states = self.states(&joints, &farthest);
        states.extend(self.slow_states(arm));
        let (mut names, mut bases) = (robot.names(), Vec::new());
        let mut bodies = arm.chain().count();
        if arm.floating.is_some() {
            bases = self.on_moving_base(&mut states);
            names.splice(..0, NAMES_OF_BASE.map(String::from));
            bodies += 1;
        }
        let tolerance = self.tolerance * bodies as f64;
        let mut report = Report::new(names, states.len(), self.seed);
        // The regressor of the potential energy leaves a constant open: that of the first state.
        let mut data = BTreeMap::new();
        for (k, (label, state)) in states.iter().enumerate() {
            let moving = bases.get(k);
            let base = &moving.copied().unwrap_or_else(Pose::identity);
            let footing = numeric.footing(base);
            let there = numeric.placed(&footing);
            report.note_conditioning(label, there.conditioning(&state.q));
            let tau = there.inverse_dynamics(&state.q, &state.qd, &state.qdd);
            let mut at = At::new(there, &table, (base, state), &tau);
            let mut compare = |method: Option<&str>, evaluation: Evaluation| {
                let open = || {
                    let energies: Option<(f64, f64)> = evaluation.get("energies_form");
                    energies.unwrap_or_default().1 - at.gravity_energy()
                };
                at.datum = *data.entry(method.map(String::from)).or_insert_with(open);
                for_deviations(&evaluation, &mut at, |frame, deviation| {
                    let of = Of { method, frame };
                    report.record(of, &deviation, tolerance, label, (moving, state));
                });
            };
            compare(None, robot.values(base, state, &tau));
            robot.values_of_parts(base, state, &tau, &mut |method, parts| {
                compare(Some(method), parts)
            });
            if is_certified {
                let certified = robot.certified_values(base, state, &tau);
                let certified = by_residuals(certified, state, &tau);
                for_deviations(&certified, &mut at, |frame, deviation| {
                    report.note_rounding(frame, &deviation);
                });
            }
        }
        report
    }
}

/// Bounds of accelerations by their residuals in the equations of motion.
fn by_residuals(
    mut found: Evaluation<Certified>,
    state: &SizedState<Dyn>,
    tau: &DVector<f64>,
) -> Evaluation<Certified> {
    let of = |name: &str| found.entries(name)?.as_ref().ok();
    let (Some(mass_matrix), Some(torques)) = (of("mass_matrix"), of("inverse_dynamics")) else {
        return found;
    };
    let mass_matrix = DMatrix::from_column_slice(tau.len(), tau.len(), mass_matrix);
    let left = tau.map(Certified::exact) - DVector::from_column_slice(torques);
    for name in ["forward_dynamics", "forward_dynamics_aba"] {
        if let Some(Ok(qdd)) = found.entries(name) {
            let qdd = DVector::from_column_slice(qdd);
            let bounded = accelerations_near((&state.qdd, &left), &mass_matrix, qdd);
            found.set(name, bounded.as_slice().to_vec());
        }
    }
    found
}

impl Default for Check {
    fn default() -> Self {
        Check::new()
    }
}

#[cfg(test)]
mod floating_tests;
#[cfg(test)]
mod tests;
