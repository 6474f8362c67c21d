//! The torques of a motion.

use std::path::{Path, PathBuf};

use clap::ArgMatches;
use dynamics_evaluation::RuntimeRobot;
use dynamics_runtime::Cycloidal;
use dynamics_symbolic::{Function, Request};

use crate::csv::{Csv, read};
use crate::failure::Failure;
use crate::joints::with_joints;
use crate::load::{arm, model};
use crate::simulate::vector;

/// The motion and its torques as CSV.
pub(crate) fn run(given: &ArgMatches) -> Result<String, Failure> {
    let (robot, _) = model(given)?;
    let arm = arm(robot, vec![Request::One(Function::InverseDynamics)])?;
    let samples = given
        .get_one::<u32>("samples")
        .map_or(101, |samples| *samples as usize);
    let motion = match given.get_one::<PathBuf>("waypoints") {
        Some(path) => through_waypoints(path, arm.dof(), samples)?,
        None => with_joints!(arm.dof(), N => cycloidal::<N>(given, samples))?,
    };
    torques(&arm, motion)?.put_out(given)
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
    let names: Vec<_> = arm.joint_names().collect();
    let mut csv = Csv::new("t", &["q", "qd", "qdd", "tau"], names.into_iter());
    let dof = arm.dof();
    for (sample, t) in t.iter().enumerate() {
        let entries = [&q, &qd, &qdd, &tau].into_iter();
        let entries = entries.flat_map(|vector| vector[sample * dof..(sample + 1) * dof].iter());
        csv.row([*t].into_iter().chain(entries.copied()));
    }
    Ok(csv)
}

/// The times of equal steps from one to another.
fn times(first: f64, last: f64, samples: usize) -> impl Iterator<Item = f64> {
    let steps = (samples - 1) as f64;
    (0..samples).map(move |k| first + (last - first) * (k as f64 / steps))
}

fn cycloidal<const N: usize>(given: &ArgMatches, samples: usize) -> Result<Motion, Failure> {
    let (from, to) = (vector::<N>(given, "from")?, vector::<N>(given, "to")?);
    let duration = given.get_one::<f64>("duration").copied().unwrap_or(1.0);
    let path = Cycloidal::new(from, to, duration)?;
    let mut motion = Motion::default();
    for (t, state) in path.samples(samples) {
        motion.t.push(t);
        motion.q.extend(state.q.iter());
        motion.qd.extend(state.qd.iter());
        motion.qdd.extend(state.qdd.iter());
    }
    Ok(motion)
}

/// Cubic splines through the rows of a file, at rest at both ends.
fn through_waypoints(path: &Path, dof: usize, samples: usize) -> Result<Motion, Failure> {
    let rows = read(path, dof + 1)?;
    let times_of_rows: Vec<f64> = rows.iter().map(|row| row[0]).collect();
    let splines = (1..=dof).map(|joint| {
        let positions: Vec<f64> = rows.iter().map(|row| row[joint]).collect();
        Spline::new(&times_of_rows, positions)
    });
    let splines: Vec<_> = splines.collect();
    let mut motion = Motion::default();
    for t in times(times_of_rows[0], times_of_rows[rows.len() - 1], samples) {
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

/// A cubic spline with slopes of zero at both ends (de Boor, A Practical Guide to Splines, 1978,
/// chapter IV): on each piece a cubic that has the given positions and slopes at its ends, slopes such
/// that the second derivative is continuous.
struct Spline<'t> {
    times: &'t [f64],
    positions: Vec<f64>,
    slopes: Vec<f64>,
}

impl<'t> Spline<'t> {
    fn new(times: &'t [f64], positions: Vec<f64>) -> Self {
        let n = times.len();
        let (mut upper, mut slopes) = (vec![0.0; n], vec![0.0; n]);
        // s[i-1] / h + 2 s[i] (1/h + 1/k) + s[i+1] / k = 3 (dp/h^2 + dp'/k^2), solved from the left.
        for i in 1..n - 1 {
            let (h, k) = (times[i] - times[i - 1], times[i + 1] - times[i]);
            let (before, after) = (
                positions[i] - positions[i - 1],
                positions[i + 1] - positions[i],
            );
            let right = 3.0 * (before / (h * h) + after / (k * k));
            let pivot = 2.0 * (1.0 / h + 1.0 / k) - upper[i - 1] / h;
            upper[i] = 1.0 / (k * pivot);
            slopes[i] = (right - slopes[i - 1] / h) / pivot;
        }
        for i in (1..n - 1).rev() {
            slopes[i] -= upper[i] * slopes[i + 1];
        }
        Spline {
            times,
            positions,
            slopes,
        }
    }

    /// Position, velocity and acceleration.
    fn at(&self, t: f64) -> [f64; 3] {
        let last = self.times.len() - 2;
        let after = self.times.partition_point(|time| *time <= t);
        let i = after.saturating_sub(1).min(last);
        let h = self.times[i + 1] - self.times[i];
        let (x, p, s) = (t - self.times[i], &self.positions, &self.slopes);
        let chord = (p[i + 1] - p[i]) / h;
        // p + s x + b x^2 + c x^3
        let b = (3.0 * chord - 2.0 * s[i] - s[i + 1]) / h;
        let c = (s[i] + s[i + 1] - 2.0 * chord) / (h * h);
        [
            p[i] + x * (s[i] + x * (b + x * c)),
            s[i] + x * (2.0 * b + x * 3.0 * c),
            2.0 * b + x * 6.0 * c,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::Spline;

    /// Positions are met, ends are at rest, and no derivative up to the second jumps.
    #[test]
    fn splines_are_smooth() {
        let times = [0.0, 0.5, 1.5, 2.0, 4.0];
        let positions = [0.0, 1.0, -0.5, 0.25, 2.0];
        let spline = Spline::new(&times, positions.to_vec());
        for (t, q) in times.iter().zip(positions) {
            let (before, here, after) = (spline.at(t - 1e-9), spline.at(*t), spline.at(t + 1e-9));
            assert!((here[0] - q).abs() < 1e-12);
            if *t > 0.0 && *t < 4.0 {
                let jump = |k: usize| (before[k] - after[k]).abs();
                assert!(jump(0) < 1e-7 && jump(1) < 1e-6 && jump(2) < 1e-6, "{t}");
            }
        }
        assert!(spline.at(0.0)[1].abs() < 1e-12 && spline.at(4.0)[1].abs() < 1e-12);
    }
}
