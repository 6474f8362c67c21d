//! The positions of the joints at which the tip or a frame has a pose.

use dynamics_evaluation::RuntimePlace;
use dynamics_export::poses::poses;
use dynamics_numeric::inverse_kinematics::{InverseKinematics, Reached, Target};
use dynamics_runtime::nalgebra::{DVector, Dyn, Rotation3, Vector3};
use dynamics_runtime::{JointVector as _, SizedKinematics as _};
use dynamics_symbolic::robot::{JointType, Robot};
use dynamics_symbolic::{Function, Request};

use crate::arguments::Reach;
use crate::beside::has_links;
use crate::columns::{aligned, significant};
use crate::failure::Failure;
use crate::load::{arm, read_on_standing_base};
use crate::state::{note_degrees_of_pose, positions};

/// The most solutions that are printed, and the most of families without end.
const MOST: [usize; 2] = [64, 8];

/// The text of `reach`.
pub(crate) fn run(given: &Reach) -> Result<String, Failure> {
    let path = &given.file.path;
    let named = given.frame.as_deref();
    let mut robot = read_on_standing_base(&given.file, named)?.robot;
    let start = DVector::from_vec(positions(&given.from, "from", &robot)?);
    let (target, rows) = target(&given.pose)?;
    let frame = frame(named, has_links(path), &mut robot)?;
    let functions = [Function::ForwardKinematics, Function::Jacobian];
    let requests = functions.map(|function| match &frame {
        None => function.into(),
        Some((index, name)) => Request::of_frame(function, *index, name),
    });
    let arm = arm(path, &robot, &requests)?;
    let place = arm.place(frame.as_ref().map(|(_, name)| name.as_str()))?;
    let digits = given.digits;
    let solver = InverseKinematics::new(&place).attempts(given.starts);
    match solver.solutions(&[target], &start, MOST[0]) {
        Ok(found) => {
            let table = solutions(&robot, &place, rows, &found, digits);
            Ok(format!(
                "{table}\nfound from {} starts, which prove nothing about others\n",
                given.starts
            ))
        }
        Err(error) if error.attempts == 0 => Err(Failure::from(error)),
        Err(error) => {
            let table = table(&robot, [("nearest".to_owned(), &error.q)], digits);
            let text = format!("{}: no solution\n\n{table}", robot.name);
            let error = error.naming(robot.joints().map(|row| &row.name));
            Err(Failure::after(text, error.to_string()))
        }
    }
}

/// The target of `--pose`, and how many numbers it gives.
fn target(numbers: &[f64]) -> Result<(Target, usize), Failure> {
    match *numbers {
        [x, y, z] => Ok((Target::position(Vector3::new(x, y, z)), 3)),
        [x, y, z, roll, pitch, yaw] => {
            note_degrees_of_pose([roll, pitch, yaw]);
            let rotation = Rotation3::from_euler_angles(roll, pitch, yaw).into_inner();
            Ok((Target::rotation(rotation).at(Vector3::new(x, y, z)), 6))
        }
        _ => Err(Failure::of_the_command_line(format!(
            "`--pose` has {} numbers: expected six, X,Y,Z,ROLL,PITCH,YAW, or three, where the rotation is free",
            numbers.len()
        ))),
    }
}

/// The frame of `--frame`, by its index and its name; `None` of the tip.
fn frame(
    named: Option<&str>,
    has_links: bool,
    robot: &mut Robot,
) -> Result<Option<(usize, String)>, Failure> {
    // Ends of a tree become frames.
    poses(robot);
    let mut frames = robot.frames.iter().enumerate();
    let names = robot.frames.iter().map(|frame| format!("`{}`", frame.name));
    let names = names.collect::<Vec<_>>().join(", ");
    match named {
        Some(name) => match frames.find(|(_, frame)| frame.name == name) {
            Some((index, frame)) => Ok(Some((index, frame.name.clone()))),
            None => Err(Failure::of_the_command_line(match &names[..] {
                "" if has_links => format!("`--frame {name}`: the robot has no link of that name"),
                "" => format!("`--frame {name}`: the robot has no frames, only a tip"),
                _ if has_links => {
                    format!("`--frame {name}` is no frame: expected a link, or one of {names}")
                }
                _ => format!("`--frame {name}` is no frame: expected one of {names}"),
            })),
        },
        None if robot.tip_row().is_some() => Ok(None),
        None => Err(Failure::of_the_command_line(format!(
            "the robot has no tip, because several links carry no other: `--frame` names {}one of {names}",
            if has_links { "a link, or " } else { "" }
        ))),
    }
}

/// The solutions as a table, and what they are.
fn solutions(
    robot: &Robot,
    place: &RuntimePlace<'_>,
    rows: usize,
    found: &[Reached<Dyn>],
    digits: usize,
) -> String {
    let jacobian = place.tip_jacobian(&found[0].q);
    let rank = jacobian.rows(0, rows).into_owned().rank(1e-6);
    // Joints of other limbs move nothing.
    let moving = jacobian.column_iter().filter(|column| column.amax() > 0.0);
    let free = moving.count() - rank;
    let shown = &found[..found.len().min(MOST[usize::from(free > 0)])];
    let what = match (shown.len(), free) {
        (1, 0) => "1 solution".to_owned(),
        (count, 0) => format!("{count} solutions, the nearest to the start first"),
        (count, _) => format!(
            "{count} of infinitely many solutions, the nearest to the start first: directions in which the joints are free: {free}"
        ),
    };
    let rows = shown.iter().enumerate();
    let table = table(
        robot,
        rows.map(|(k, reached)| ((k + 1).to_string(), &reached.q)),
        digits,
    );
    format!("{}: {what}\n\n{table}", robot.name)
}

/// Joint positions with the names of the joints and their units.
fn table<'q>(
    robot: &Robot,
    found: impl IntoIterator<Item = (String, &'q DVector<f64>)>,
    digits: usize,
) -> String {
    let names = robot.joints().map(|row| match row.joint_type {
        JointType::Revolute => format!("{}, rad", row.name),
        JointType::Prismatic => format!("{}, m", row.name),
    });
    let mut rows = vec![[String::new()].into_iter().chain(names).collect::<Vec<_>>()];
    for (name, q) in found {
        // Smaller numbers are rounding errors.
        let cells = q
            .entries()
            .iter()
            .map(|x| if x.abs() < 1e-12 { 0.0 } else { *x });
        let cells = cells.map(|x| significant(x, digits));
        rows.push([name].into_iter().chain(cells).collect());
    }
    aligned(&rows, true).join("\n") + "\n"
}
