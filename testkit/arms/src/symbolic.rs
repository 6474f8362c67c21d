//! Robots with fields in their cells.

use crate::robot;
use dynamics_symbolic::robot::{
    Body, Carrier, Convention, Frame, JointType, Placement, Robot, Row, Value,
};

/// The arm of Craig's (6.60) to (6.62): two links with point masses at their ends.
pub fn two_link_craig() -> Robot {
    let mut robot = robot("two_link_craig");
    robot.fields = ["m1", "m2", "l1", "l2", "g"].map(str::to_owned).to_vec();
    for (row, (mass, length)) in robot.rows.iter_mut().zip([(0, 2), (1, 3)]) {
        row.mass = Value::field(mass);
        row.a = Value::field(length);
    }
    robot.gravity[1] = -Value::field(4);
    robot
}

/// Two fingers beside each other, each with a frame at its end, of which the right one has a body.
pub fn fingers() -> Robot {
    let [width, length] = [0, 1].map(Value::field);
    let zeros = || [(); 3].map(|()| Value::zero());
    let along = |x: &Value| {
        vec![Placement {
            xyz: [x.clone(), Value::zero(), Value::zero()],
            rpy: zeros(),
        }]
    };
    let row = |name: &str| Row {
        mass: Value::integer(2),
        ..Row::new(name, JointType::Revolute)
    };
    let right = Row {
        on: Carrier::Base,
        at: along(&width),
        ..row("right")
    };
    let body = Body {
        mass: Value::integer(1),
        com: zeros(),
        inertia: [(); 6].map(|()| Value::zero()),
    };
    let frame = |name: &str, on: usize, body: Option<Body>| Frame {
        name: name.to_owned(),
        on: Some(on),
        places: along(&length),
        body,
    };
    Robot {
        name: "Fingers".to_owned(),
        fields: ["width", "length"].map(str::to_owned).to_vec(),
        convention: Convention::Modified,
        gravity: [0, 0, -20].map(Value::integer),
        base: None,
        rows: vec![row("left"), right],
        tool: None,
        frames: vec![
            frame("Left tip", 0, None),
            frame("Right tip", 1, Some(body)),
        ],
        neglected: None,
        bounds: Default::default(),
    }
}
