//! The torques of a motion.

mod moving_base;

use std::path::Path;

use dynamics_evaluation::RuntimeRobot;
use dynamics_numeric::check::Checked;
use dynamics_runtime::nalgebra::{DVector, Dyn, Vector1};
use dynamics_runtime::table::RuntimeTable;
use dynamics_runtime::{Cycloidal, Pose};
use dynamics_simulation::simulation::{Place, SizedModel, SizedTrajectory};
use dynamics_symbolic::Function;
use dynamics_symbolic::robot::Robot;

use crate::arguments::InverseDynamics;
use crate::csv::{put, read, shortest};
use crate::failure::Failure;
use crate::load::robot_with;
use crate::spline::Spline;
use crate::state::{State, base, positions};

type Motion = SizedTrajectory<Dyn>;

/// The motion and its torques as CSV.
pub(crate) fn run(given: &InverseDynamics) -> Result<String, Failure> {
    let robot = robot_with(&given.robot, [Function::InverseDynamics])?;
    let mut motion = motion(given, robot.robot())?;
    motion.tau = torques(&robot, &motion)?;
    let columns = Columns(&robot);
    put(&motion, &columns, robot.robot(), given.output.plot.as_ref())
}

/// The motion without its torques.
fn motion(given: &InverseDynamics, robot: &Robot) -> Result<Motion, Failure> {
    match &given.waypoints {
        Some(path) if robot.freedoms().has_base() => {
            moving_base::through_waypoints(path, robot, given.samples)
        }
        Some(path) => {
            base(robot, &given.pose)?;
            through_waypoints(path, robot, given.samples)
        }
        None if given.at.is_empty() => {
            let base = base(robot, &given.pose)?;
            Ok(held(base, cycloidal(given, robot)?))
        }
        None => {
            let state = State::new(robot, [&given.at, &given.pose, &[]])?;
            Ok(one_state(state))
        }
    }
}

/// The motion of joints on a base that is held, if it moves.
fn held(base: Option<Pose<f64>>, mut motion: Motion) -> Motion {
    if let Some(base) = base {
        motion.base = vec![base; motion.len()];
        for rates in motion.qd.iter_mut().chain(&mut motion.qdd) {
            *rates = [&[0.0; 6], rates.as_slice()].concat().into();
        }
    }
    motion
}

/// A single sample.
fn one_state(state: State) -> Motion {
    let mut motion = Motion::default();
    motion.t.push(0.0);
    motion.base.extend(state.base);
    motion.q.push(state.q.into());
    motion.qd.push(state.qd.into());
    motion.qdd.push(state.qdd.into());
    motion
}

/// The columns of a robot of which there are no energies.
struct Columns<'a>(&'a RuntimeRobot);

impl SizedModel<Dyn> for Columns<'_> {
    fn sized_table(&self) -> RuntimeTable {
        self.0.runtime_table()
    }

    fn names(&self) -> Vec<String> {
        Checked::names(self.0)
    }

    fn sized_energies(&self, _: &Place<Dyn>, _: &DVector<f64>) -> Option<[f64; 2]> {
        None
    }
}

/// The torques of a motion.
fn torques(robot: &RuntimeRobot, motion: &Motion) -> Result<Vec<DVector<f64>>, Failure> {
    let poses = motion.base.iter().map(Pose::entries);
    let poses: Vec<f64> = poses.flat_map(<[f64; 12]>::from).collect();
    let flat = |list: &Vec<DVector<f64>>| list.iter().flatten().copied().collect::<Vec<f64>>();
    let states = [&motion.q, &motion.qd, &motion.qdd].map(flat);
    let base = robot.robot().floating().map(|_| &poses);
    let arguments = base.into_iter().chain(&states).map(Vec::as_slice);
    let arguments: Vec<_> = arguments.collect();
    let mut tau = vec![0.0; states[2].len()];
    robot.batch(Function::InverseDynamics.name(), &arguments, &mut tau)?;
    let samples = tau.chunks_exact(robot.dof().max(1));
    Ok(samples.map(DVector::from_column_slice).collect())
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
fn refuse_pose_of_tip(to: &[f64], robot: &Robot) -> Result<(), Failure> {
    let joints = robot.freedoms().joints;
    let found = to.len();
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
fn cycloidal(given: &InverseDynamics, robot: &Robot) -> Result<Motion, Failure> {
    refuse_pose_of_tip(&given.to, robot)?;
    let from = positions(&given.from, "from", robot)?;
    let to = positions(&given.to, "to", robot)?;
    let path = |(from, to): (&f64, &f64)| {
        Cycloidal::new(Vector1::new(*from), Vector1::new(*to), given.duration)
            .map_err(Failure::of_the_command_line)
    };
    let paths: Vec<Cycloidal<1>> = from.iter().zip(&to).map(path).collect::<Result<_, _>>()?;
    let mut motion = Motion::default();
    // The samples of one path have the times of all.
    for (t, _) in paths
        .iter()
        .take(1)
        .flat_map(|path| path.samples(given.samples))
    {
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
    let points: Motion = read(path, robot)?;
    let lists = [&points.q, &points.qd, &points.qdd];
    let splines = splines(&points.t, lists, robot.freedoms().joints);
    let mut motion = Motion::default();
    for t in times(points.t[0], points.t[points.len() - 1], samples) {
        let states: Vec<_> = splines.iter().map(|spline| spline.at(t)).collect();
        if !states.iter().flatten().all(|x| x.is_finite()) {
            return Err(not_finite(path, t));
        }
        add(&mut motion, t, &states);
    }
    Ok(motion)
}

/// Curves through points: positions, velocities and accelerations, where these are there, of so many numbers.
fn splines<'t>(times: &'t [f64], lists: [&Vec<DVector<f64>>; 3], count: usize) -> Vec<Spline<'t>> {
    let spline = |number: usize| {
        let column = |list: &Vec<DVector<f64>>| list.iter().map(|vector| vector[number]).collect();
        let [positions, slopes, second_derivatives]: [Vec<f64>; 3] = lists.map(column);
        if second_derivatives.is_empty() {
            let ends = [slopes.first(), slopes.last()].map(|end| end.copied().unwrap_or(0.0));
            return Spline::cubic(times, positions, ends);
        }
        Spline {
            times,
            positions,
            slopes,
            second_derivatives: Some(second_derivatives),
        }
    };
    (0..count).map(spline).collect()
}

/// The failure of a motion between rows.
fn not_finite(path: &Path, t: f64) -> Failure {
    let message = format!(
        "rates or accelerations between the rows are not finite at t = {}: the times are too short for the \
         positions, or the positions too large",
        shortest(t)
    );
    Failure::of_file(path, message)
}
