//! The torques of a motion.

use std::path::{Path, PathBuf};

use clap::ArgMatches;
use dynamics_evaluation::RuntimeRobot;
use dynamics_runtime::Cycloidal;
use dynamics_runtime::check::Checked;
use dynamics_runtime::nalgebra::{DVector, Dyn, Vector1};
use dynamics_runtime::simulation::{SizedModel, SizedTrajectory};
use dynamics_runtime::table::RuntimeTable;
use dynamics_symbolic::Function;
use dynamics_symbolic::robot::Robot;

use crate::csv::{read, shortest, written};
use crate::failure::Failure;
use crate::joints::note_degrees;
use crate::load::{arm_with, count};
use crate::plot;
use crate::spline::Spline;
use crate::state::positions;

type Motion = SizedTrajectory<Dyn>;

/// The motion and its torques as CSV.
pub(crate) fn run(given: &ArgMatches) -> Result<String, Failure> {
    let arm = arm_with(given, [Function::InverseDynamics])?;
    let samples = count(given, "samples");
    let motion = match given.get_one::<PathBuf>("waypoints") {
        Some(path) => through_waypoints(path, arm.robot(), samples)?,
        None => cycloidal(given, arm.robot(), samples)?,
    };
    let motion = with_torques(&arm, motion)?;
    let text = written(&motion, &Columns(&arm))?;
    plot::put(given, || plot::of_motion(arm.robot(), &motion, None))?;
    Ok(text)
}

/// The columns of an arm of which there are no energies.
struct Columns<'a>(&'a RuntimeRobot);

impl SizedModel<Dyn> for Columns<'_> {
    fn sized_table(&self) -> RuntimeTable {
        self.0.runtime_table()
    }

    fn names(&self) -> Vec<String> {
        Checked::names(self.0)
    }

    fn sized_energies(&self, _: &DVector<f64>, _: &DVector<f64>) -> Option<[f64; 2]> {
        None
    }
}

/// The motion with the torques that it takes.
fn with_torques(arm: &RuntimeRobot, mut motion: Motion) -> Result<Motion, Failure> {
    let flat = |list: &Vec<DVector<f64>>| list.iter().flatten().copied().collect::<Vec<f64>>();
    let [q, qd, qdd] = [&motion.q, &motion.qd, &motion.qdd].map(flat);
    let mut tau = vec![0.0; q.len()];
    arm.inverse_dynamics_batch(&q, &qd, &qdd, &mut tau)?;
    let dof = arm.dof();
    let sample = |k: usize| DVector::from_column_slice(&tau[k * dof..(k + 1) * dof]);
    motion.tau = (0..motion.len()).map(sample).collect();
    Ok(motion)
}

/// Adds a sample: position, velocity and acceleration of each joint.
fn add(motion: &mut Motion, t: f64, states: &[[f64; 3]]) {
    let vector = |k: usize| DVector::from_iterator(states.len(), states.iter().map(|x| x[k]));
    motion.t.push(t);
    motion.q.push(vector(0));
    motion.qd.push(vector(1));
    motion.qdd.push(vector(2));
}

/// The times of equal steps from one to another.
fn times(first: f64, last: f64, samples: usize) -> impl Iterator<Item = f64> {
    let steps = (samples - 1) as f64;
    (0..samples).map(move |k| first + (last - first) * (k as f64 / steps))
}

/// Refuses as many numbers as the position or the pose of a tip has, where the joints are not as many.
fn refuse_pose_of_tip(given: &ArgMatches, robot: &Robot) -> Result<(), Failure> {
    let joints = robot.freedoms().joints;
    let found = given.get_many::<f64>("to").map_or(joints, Iterator::count);
    if found == joints || ![3, 6].contains(&found) {
        return Ok(());
    }
    let plural = if joints == 1 { "" } else { "s" };
    Err(Failure::of_the_command_line(format!(
        "`--to` has {found} numbers: expected {joints}, the position{plural} of the joint{plural} that move{}. \
         `inverse-dynamics` finds torques; `reach` finds the joint positions of a pose of the tip",
        if joints == 1 { "s" } else { "" }
    )))
}

/// Each joint by itself from one position to another, in the same time.
fn cycloidal(given: &ArgMatches, robot: &Robot, samples: usize) -> Result<Motion, Failure> {
    refuse_pose_of_tip(given, robot)?;
    let from = positions(given, "from", robot)?;
    let to = positions(given, "to", robot)?;
    let duration = given.get_one::<f64>("duration").copied().unwrap_or(1.0);
    let path = |(from, to): (&f64, &f64)| {
        Cycloidal::new(Vector1::new(*from), Vector1::new(*to), duration)
            .map_err(Failure::of_the_command_line)
    };
    let paths: Vec<Cycloidal<1>> = from.iter().zip(&to).map(path).collect::<Result<_, _>>()?;
    let mut motion = Motion::default();
    // The samples of one path have the times of all.
    for (t, _) in paths.iter().take(1).flat_map(|path| path.samples(samples)) {
        let states = paths.iter().map(|path| path.at(t));
        let states: Vec<_> = states
            .map(|state| [state.q[0], state.qd[0], state.qdd[0]])
            .collect();
        add(&mut motion, t, &states);
    }
    Ok(motion)
}

/// Through the points of a file: with its velocities and accelerations if it has both, else by cubic splines with its
/// velocities at both ends, or at rest there.
fn through_waypoints(path: &Path, robot: &Robot, samples: usize) -> Result<Motion, Failure> {
    let joints: Vec<_> = robot.joints().map(|row| row.name.as_str()).collect();
    let points = read(path, &joints)?;
    for q in &points.q {
        if note_degrees(&path.display().to_string(), robot, q.as_slice()) {
            break;
        }
    }
    let splines = (0..joints.len()).map(|joint| {
        let lists = [&points.q, &points.qd, &points.qdd];
        let [positions, slopes, second_derivatives] = lists.map(|list| {
            list.iter()
                .map(|vector| vector[joint])
                .collect::<Vec<f64>>()
        });
        if points.qdd.is_empty() {
            let ends = [slopes.first(), slopes.last()].map(|end| end.copied().unwrap_or(0.0));
            return Spline::cubic(&points.t, positions, ends);
        }
        Spline {
            times: &points.t,
            positions,
            slopes,
            second_derivatives: Some(second_derivatives),
        }
    });
    let splines: Vec<_> = splines.collect();
    let mut motion = Motion::default();
    for t in times(points.t[0], points.t[points.len() - 1], samples) {
        let states: Vec<_> = splines.iter().map(|spline| spline.at(t)).collect();
        if !states.iter().flatten().all(|x| x.is_finite()) {
            let message = format!(
                "rates or accelerations between the rows are not finite at t = {}: the times are too short for the \
                 positions, or the positions too large",
                shortest(t)
            );
            return Err(Failure::of_file(path, message));
        }
        add(&mut motion, t, &states);
    }
    Ok(motion)
}
