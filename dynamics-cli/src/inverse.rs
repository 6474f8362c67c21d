//! The torques of a motion.

use std::path::{Path, PathBuf};

use clap::ArgMatches;
use dynamics_evaluation::RuntimeRobot;
use dynamics_runtime::Cycloidal;
use dynamics_runtime::nalgebra::Vector1;
use dynamics_symbolic::Function;
use dynamics_symbolic::robot::Robot;

use crate::csv::{Csv, read, shortest};
use crate::failure::Failure;
use crate::joints::note_degrees;
use crate::load::{arm_with, count};
use crate::simulate::positions;
use crate::spline::Spline;

/// The motion and its torques as CSV.
pub(crate) fn run(given: &ArgMatches) -> Result<String, Failure> {
    let arm = arm_with(given, [Function::InverseDynamics])?;
    let samples = count(given, "samples");
    let motion = match given.get_one::<PathBuf>("waypoints") {
        Some(path) => through_waypoints(path, arm.robot(), samples)?,
        None => cycloidal(given, arm.robot(), samples)?,
    };
    Ok(torques(&arm, motion)?.text())
}

/// Times, and positions, velocities and accelerations at each of them, one after the other.
#[derive(Default)]
struct Motion {
    t: Vec<f64>,
    q: Vec<f64>,
    qd: Vec<f64>,
    qdd: Vec<f64>,
}

impl Motion {
    /// Adds a time with position, velocity and acceleration of each joint.
    fn add(&mut self, t: f64, joints: impl Iterator<Item = [f64; 3]>) {
        self.t.push(t);
        for [q, qd, qdd] in joints {
            self.q.push(q);
            self.qd.push(qd);
            self.qdd.push(qdd);
        }
    }
}

fn torques(arm: &RuntimeRobot, motion: Motion) -> Result<Csv, Failure> {
    let Motion { t, q, qd, qdd } = motion;
    let mut tau = vec![0.0; q.len()];
    arm.inverse_dynamics_batch(&q, &qd, &qdd, &mut tau)?;
    let mut csv = Csv::new("t", &["q", "qd", "qdd", "tau"], arm.joint_names());
    let dof = arm.dof();
    for (sample, t) in t.iter().enumerate() {
        let of_sample = sample * dof..(sample + 1) * dof;
        let vectors = [&q, &qd, &qdd, &tau].map(|vector| &vector[of_sample.clone()]);
        csv.row([*t].into_iter().chain(vectors.concat()))?;
    }
    Ok(csv)
}

/// The times of equal steps from one to another.
fn times(first: f64, last: f64, samples: usize) -> impl Iterator<Item = f64> {
    let steps = (samples - 1) as f64;
    (0..samples).map(move |k| first + (last - first) * (k as f64 / steps))
}

/// Each joint by itself from one position to another, in the same time.
fn cycloidal(given: &ArgMatches, robot: &Robot, samples: usize) -> Result<Motion, Failure> {
    let from = positions(given, "from", robot)?;
    let to = positions(given, "to", robot)?;
    let duration = given.get_one::<f64>("duration").copied().unwrap_or(1.0);
    let path = |(from, to): (&f64, &f64)| {
        Cycloidal::new(Vector1::new(*from), Vector1::new(*to), duration)
            .map_err(Failure::of_the_command_line)
    };
    let paths: Vec<Cycloidal<1>> = from.iter().zip(&to).map(path).collect::<Result<_, _>>()?;
    let mut motion = Motion::default();
    for (t, _) in paths.iter().take(1).flat_map(|path| path.samples(samples)) {
        let states = paths.iter().map(|path| path.at(t));
        motion.add(
            t,
            states.map(|state| [state.q[0], state.qd[0], state.qdd[0]]),
        );
    }
    Ok(motion)
}

/// Cubic splines through the rows of a file, at rest at both ends.
fn through_waypoints(path: &Path, robot: &Robot, samples: usize) -> Result<Motion, Failure> {
    let joints: Vec<_> = robot.joints().map(|row| row.name.as_str()).collect();
    let rows = read(path, &joints)?;
    for row in &rows {
        if note_degrees(&path.display().to_string(), robot, &row[1..]) {
            break;
        }
    }
    let times_of_rows: Vec<f64> = rows.iter().map(|row| row[0]).collect();
    let through = |joint: usize| {
        let positions = rows.iter().map(|row| row[joint]).collect();
        Spline::new(&times_of_rows, positions)
    };
    let splines: Vec<_> = (1..=joints.len()).map(through).collect();
    let mut motion = Motion::default();
    for t in times(times_of_rows[0], times_of_rows[rows.len() - 1], samples) {
        let joints: Vec<_> = splines.iter().map(|spline| spline.at(t)).collect();
        if !joints.iter().flatten().all(|x| x.is_finite()) {
            let message = format!(
                "rates or accelerations between the rows are not finite at t = {}: the times are too short for the \
                 positions, or the positions too large",
                shortest(t)
            );
            return Err(Failure::of_file(path, message));
        }
        motion.add(t, joints.into_iter());
    }
    Ok(motion)
}
