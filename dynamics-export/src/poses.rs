//! The poses that are shown of a robot.

use dynamics_symbolic::robot::{Frame, Robot};
use dynamics_symbolic::{Function, Request};

/// The poses of a robot: of the tip, if there is one, and of all frames. Where there is no tip, each link that
/// carries no other becomes a frame of the robot, unless one stands on it.
pub fn poses(robot: &mut Robot) -> Vec<Request> {
    let of_tip = robot.tip_row().map(|_| Function::ForwardKinematics.into());
    if of_tip.is_none() {
        let is_end = |row: &usize| {
            let carries = (0..robot.rows.len()).any(|other| robot.parent(other) == Some(*row));
            !carries && robot.frames.iter().all(|frame| frame.on != Some(*row))
        };
        let ends = (0..robot.rows.len()).filter(is_end);
        let ends = ends.map(|row| Frame {
            name: robot.rows[row].name.clone(),
            on: Some(row),
            places: Vec::new(),
            body: None,
        });
        let ends: Vec<_> = ends.collect();
        robot.frames.extend(ends);
    }
    let frames = robot.frames.iter().enumerate();
    let mut poses: Vec<Request> = of_tip.into_iter().collect();
    for (index, frame) in frames {
        let pose = Request::of_frame(Function::ForwardKinematics, index, &frame.name);
        // Frames whose names differ in signs alone would be one method.
        if poses.iter().all(|other| other.name() != pose.name()) {
            poses.push(pose);
        }
    }
    poses
}
