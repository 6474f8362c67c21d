//! Whether a description can be evaluated.

use dynamics_symbolic::robot::{Placement, Robot, Row, Value};

use crate::error::BuildError;

/// Refuses an arm without joints that move, and cells with fields that the robot does not have.
pub(crate) fn validate(robot: &Robot) -> Result<(), BuildError> {
    match unknown_field(robot) {
        Some(index) => Err(BuildError::NoSuchField(index)),
        None if robot.dof() == 0 => Err(BuildError::NoJoints),
        None => Ok(()),
    }
}

/// A field in a cell of the description that the robot does not have.
fn unknown_field(robot: &Robot) -> Option<usize> {
    let mut unknown = None;
    let mut visit = |value: &Value| {
        value.visit_fields(&mut |index| {
            if index >= robot.fields.len() {
                unknown = Some(index);
            }
        });
    };
    robot.gravity.iter().for_each(&mut visit);
    robot
        .base
        .iter()
        .flat_map(cells_of_placement)
        .for_each(&mut visit);
    robot
        .rows
        .iter()
        .flat_map(cells_of_row)
        .for_each(&mut visit);
    if let Some(tool) = &robot.tool {
        let body = tool.com.iter().chain(&tool.inertia).chain([&tool.mass]);
        let placement = cells_of_placement(&tool.placement);
        body.chain(placement).for_each(&mut visit);
    }
    unknown
}

fn cells_of_row(row: &Row) -> impl Iterator<Item = &Value> {
    let parameters = [&row.a, &row.alpha, &row.d, &row.theta];
    let body = row.com.iter().chain(&row.inertia).chain([&row.mass]);
    let motor = [&row.motor_inertia, &row.gear_ratio];
    let stribeck = row.stribeck.iter().flat_map(|s| [&s.friction, &s.velocity]);
    let friction = row.coulomb.iter().chain([&row.viscous]).chain(stribeck);
    let spring = row.spring.iter().flat_map(|s| [&s.stiffness, &s.rest]);
    let follows = row.follows.iter().flat_map(|c| [&c.factor, &c.offset]);
    let moves = row
        .limits
        .iter()
        .flatten()
        .chain(&row.locked)
        .chain(follows);
    let mount = row.mount.iter().flat_map(|mount| {
        let placements = mount.places.iter().chain(&mount.frame);
        placements.flat_map(cells_of_placement).chain(&mount.axis)
    });
    let cells = parameters.into_iter().chain(body).chain(motor);
    cells
        .chain(friction)
        .chain(spring)
        .chain(moves)
        .chain(mount)
}

fn cells_of_placement(placement: &Placement) -> impl Iterator<Item = &Value> {
    placement.xyz.iter().chain(&placement.rpy)
}
