//! The rows of a table: the geometry between axes, and the links' bodies.

use super::place;
use crate::exact::Rational;
use crate::linear::Vector3;
use crate::robot::{Convention, Interpretation, Robot, Row, Value};
use crate::spatial::{Body, Central, Turn, leave_x, tensor_leave_x};

/// The two cells of a row between one z axis and the next: a step along x and a turn about it.
pub(super) struct Screw<R> {
    pub(super) a: R,
    pub(super) turn: Turn<R>,
}

/// The screw before each joint, and the one after the last.
pub(super) fn screws<I: Interpretation>(cells: &mut I, robot: &Robot) -> Vec<Screw<I::Number>> {
    let none = Value::zero();
    let screws = robot.rows.iter().map(|row| (&row.a, &row.alpha));
    let screws: Vec<_> = match robot.convention {
        Convention::Standard => core::iter::once((&none, &none)).chain(screws).collect(),
        Convention::Modified => screws.chain(core::iter::once((&none, &none))).collect(),
    };
    let screw = |(a, alpha): (&Value, &Value)| {
        let turn = Turn::from(cells.sin_cos(alpha));
        Screw {
            a: cells.value(a),
            turn,
        }
    };
    screws.into_iter().map(screw).collect()
}

/// The parameters of link i and of what is fixed to it, in the frame on its joint's axis, after the
/// offset d.
pub(super) fn body<I: Interpretation>(
    cells: &mut I,
    robot: &Robot,
    i: usize,
    next: &Screw<I::Number>,
) -> Body<I::Number> {
    let row = &robot.rows[i];
    let own = place::central(cells, &row.mass, &row.com, &row.inertia);
    let own = behind_joint(cells, robot.convention, row, own, next);
    let is_last = i + 1 == robot.rows.len();
    match robot
        .tool
        .as_ref()
        .filter(|tool| is_last && tool.has_body())
    {
        Some(tool) => {
            let tool = place::body(cells, tool);
            own.joined(behind_joint(cells, robot.convention, row, tool, next))
        }
        None => own,
    }
}

/// A body of the link frame, in the frame on the joint's axis.
/// A standard link frame comes after the row's a and alpha, a modified one before the next row's; one of a
/// [`Mount`](crate::robot::Mount) where that says.
fn behind_joint<I: Interpretation>(
    cells: &mut I,
    convention: Convention,
    row: &Row,
    body: Central<I::Number>,
    next: &Screw<I::Number>,
) -> Body<I::Number> {
    match convention {
        Convention::Modified => Body::new(place::in_joint_frame(cells, row, body)),
        Convention::Standard => {
            let zero = cells.rational(&Rational::ZERO);
            let inertia = tensor_leave_x(next.turn, body.inertia);
            let com = leave_x(next.turn, body.com) + Vector3::new(next.a, zero, zero);
            Body::new(Central {
                mass: body.mass,
                com,
                inertia,
            })
        }
    }
}
