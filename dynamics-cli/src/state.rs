//! States of the command line.

use std::io::Write as _;

use dynamics_codegen::{angle_in_degrees, positions_in_degrees};
use dynamics_runtime::Pose;
use dynamics_runtime::nalgebra::{Rotation3, Vector3};
use dynamics_symbolic::robot::Robot;

use crate::failure::Failure;

/// Positions of an option, zeros where it has none.
pub(crate) fn positions(given: &[f64], name: &str, robot: &Robot) -> Result<Vec<f64>, Failure> {
    let positions = vector(given, name, [0, robot.freedoms().joints])?;
    note_degrees(&format!("--{name}"), robot, &positions);
    Ok(positions)
}

/// The numbers of an option, so many of the base and of the joints; zeros where it has none.
pub(crate) fn vector(
    given: &[f64],
    name: &str,
    [base, joints]: [usize; 2],
) -> Result<Vec<f64>, Failure> {
    let (found, expected) = (given.len(), base + joints);
    if found == 0 {
        return Ok(vec![0.0; expected]);
    }
    if found != expected {
        let plural = if found == 1 { "" } else { "s" };
        let of_base = if base > 0 {
            "six of the base, then "
        } else {
            ""
        };
        let message = format!(
            "`--{name}` has {found} number{plural}: expected {expected}, {of_base}one for each joint that moves"
        );
        return Err(Failure::of_the_command_line(message));
    }
    Ok(given.to_vec())
}

/// The pose of `--pose`: roll, pitch and yaw are turns about the fixed axes x, y and z, one after the other.
fn pose(given: &[f64]) -> Result<Pose<f64>, Failure> {
    let [x, y, z, roll, pitch, yaw] = roll_pitch_yaw(given)?.unwrap_or_default();
    Ok(Pose {
        rotation: Rotation3::from_euler_angles(roll, pitch, yaw).into_inner(),
        position: Vector3::new(x, y, z),
    })
}

/// The six numbers of `--pose`.
pub(crate) fn roll_pitch_yaw(given: &[f64]) -> Result<Option<[f64; 6]>, Failure> {
    if given.is_empty() {
        return Ok(None);
    }
    let entries: [f64; 6] = given.try_into().map_err(|_| {
        let found = given.len();
        let message = format!("`--pose` has {found} numbers: expected six, X,Y,Z,ROLL,PITCH,YAW");
        Failure::of_the_command_line(message)
    })?;
    let [.., roll, pitch, yaw] = entries;
    note_degrees_of_pose([roll, pitch, yaw]);
    Ok(Some(entries))
}

/// Poses of a base, twelve numbers each, for as many rotation vectors: the position has the same numbers in another order.
pub(crate) fn poses_of(turns: &[f64]) -> Vec<f64> {
    let pose = |turn: &[f64]| {
        let (x, y, z) = (turn[0], turn[1], turn[2]);
        let position = Vector3::new(z, x, y);
        let rotation = Rotation3::new(Vector3::new(x, y, z)).into_inner();
        <[f64; 12]>::from(Pose { rotation, position }.entries())
    };
    turns.chunks_exact(3).flat_map(pose).collect()
}

/// The pose of a base that moves; one of a base that stands is refused.
pub(crate) fn base(robot: &Robot, given: &[f64]) -> Result<Option<Pose<f64>>, Failure> {
    if robot.freedoms().has_base() {
        return Ok(Some(pose(given)?));
    }
    if !given.is_empty() {
        let message = "`--pose` is of a robot whose base moves: this one stands";
        return Err(Failure::of_the_command_line(message));
    }
    Ok(None)
}

/// Where the robot is, how it moves and what drives it.
pub(crate) struct State {
    pub(crate) q: Vec<f64>,
    pub(crate) qd: Vec<f64>,
    pub(crate) qdd: Vec<f64>,
    pub(crate) tau: Vec<f64>,
    /// Where a base that moves is.
    pub(crate) base: Option<Pose<f64>>,
}

impl State {
    /// The state of `--at`, `--pose` and `--torque`.
    pub(crate) fn new(robot: &Robot, [at, pose, torque]: [&[f64]; 3]) -> Result<State, Failure> {
        let freedoms = robot.freedoms();
        let [q, qd, qdd] = states(at, [freedoms.joints, freedoms.all()])?;
        note_degrees("--at", robot, &q);
        let base = base(robot, pose)?;
        let tau = vector(torque, "torque", [freedoms.base, freedoms.joints])?;
        Ok(State {
            q,
            qd,
            qdd,
            tau,
            base,
        })
    }
}

/// The positions, velocities and accelerations of `--at`: zeros where the list ends, or is left out.
fn states(at: &[f64], [joints, freedoms]: [usize; 2]) -> Result<[Vec<f64>; 3], Failure> {
    let ends = [joints, joints + freedoms, joints + 2 * freedoms];
    let found = at.len();
    if !(found == 0 || ends.contains(&found)) {
        let plural = if found == 1 { "" } else { "s" };
        let of_base = if freedoms > joints {
            ", six of the base before those of the joints"
        } else {
            ""
        };
        let [positions, velocities, all] = ends;
        return Err(Failure::of_the_command_line(format!(
            "`--at` has {found} number{plural}: expected {positions}, one position for each joint that moves, \
             {velocities} with the {freedoms} velocities behind them, or {all} with the {freedoms} accelerations \
             too{of_base}"
        )));
    }
    let mut q = at.to_vec();
    q.resize(ends[2], 0.0);
    let qdd = q.split_off(ends[1]);
    let qd = q.split_off(ends[0]);
    Ok([q, qd, qdd])
}

/// Remarks on the first angle that was perhaps meant in degrees; whether there is one.
pub(crate) fn note_degrees(source: &str, robot: &Robot, positions: &[f64]) -> bool {
    let remark = positions_in_degrees(robot, positions);
    tell(source, remark.as_deref());
    remark.is_some()
}

/// Remarks on the first of roll, pitch and yaw of a pose that was perhaps meant in degrees.
pub(crate) fn note_degrees_of_pose(angles: [f64; 3]) {
    let mut named = ["ROLL", "PITCH", "YAW"].into_iter().zip(angles);
    let remark = named.find_map(|(name, angle)| angle_in_degrees(name, angle));
    tell("--pose", remark.as_deref());
}

fn tell(source: &str, remark: Option<&str>) {
    if let Some(remark) = remark {
        // A remark that cannot be written is no failure.
        let _ = writeln!(std::io::stderr(), "`{source}`: {remark}");
    }
}
