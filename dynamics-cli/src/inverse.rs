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

fn torques(arm: &RuntimeRobot, motion: Motion) -> Result<Csv, Failure> {
    let Motion { t, q, qd, qdd } = motion;
    let mut tau = vec![0.0; q.len()];
    arm.inverse_dynamics_batch(&q, &qd, &qdd, &mut tau)?;
    let mut csv = Csv::new("t", &["q", "qd", "qdd", "tau"], arm.joint_names());
    let dof = arm.dof();
    for (sample, t) in t.iter().enumerate() {
        let entries = [&q, &qd, &qdd, &tau].into_iter();
        let entries = entries.flat_map(|vector| vector[sample * dof..(sample + 1) * dof].iter());
        csv.row([*t].into_iter().chain(entries.copied()))?;
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
    let mut joints: Vec<_> = paths.iter().map(|path| path.samples(samples)).collect();
    for _ in 0..samples {
        let mut t = 0.0;
        for joint in &mut joints {
            let Some((time, state)) = joint.next() else {
                return Ok(motion);
            };
            t = time;
            motion.q.push(state.q[0]);
            motion.qd.push(state.qd[0]);
            motion.qdd.push(state.qdd[0]);
        }
        motion.t.push(t);
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
    let splines = (1..=joints.len()).map(|joint| {
        let positions: Vec<f64> = rows.iter().map(|row| row[joint]).collect();
        Spline::new(&times_of_rows, positions)
    });
    let splines: Vec<_> = splines.collect();
    let mut motion = Motion::default();
    let is_finite = |spline: &Spline, t: f64| spline.at(t).iter().all(|x| x.is_finite());
    for t in times(times_of_rows[0], times_of_rows[rows.len() - 1], samples) {
        if !splines.iter().all(|spline| is_finite(spline, t)) {
            let message = format!(
                "rates or accelerations between the rows are not finite at t = {}: the times are too short for the \
                 positions, or the positions too large",
                shortest(t)
            );
            return Err(Failure::of_file(path, message));
        }
        motion.t.push(t);
        for spline in &splines {
            let [q, qd, qdd] = spline.at(t);
            motion.q.push(q);
            motion.qd.push(qd);
            motion.qdd.push(qdd);
        }
    }
    Ok(motion)
}
