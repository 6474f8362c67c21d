//! The table of a robot in numbers, as a generated struct hands it out.

use dynamics_runtime::{
    table::{
        self, Carrier, Convention, FixedFrame, FloatingBase, Frame, JointMotion, JointType, Row,
        RuntimeTable, Spring, Stribeck, Tool,
    },
    turned,
};
use dynamics_symbolic::program::rounded_angle;
use dynamics_symbolic::robot::{self, Angle, Placement, Quantity, Robot, Value};

/// The table for these values of the fields.
pub(crate) fn table(robot: &Robot, fields: &[f64]) -> RuntimeTable {
    let cells = Cells(fields);
    let convention = match robot.convention {
        robot::Convention::Standard => Convention::Standard,
        robot::Convention::Modified => Convention::Modified,
    };
    let gravity = robot.gravity.each_ref().map(|value| cells.number(value));
    let rows: Vec<Row> = (0..robot.rows.len()).map(|i| cells.row(robot, i)).collect();
    let motions: Vec<_> = robot.rows.iter().map(|row| cells.motion(row)).collect();
    let frames: Vec<_> = robot
        .frames
        .iter()
        .map(|frame| cells.fixed(frame))
        .collect();
    let mut arm = match robot.floating() {
        Some(body) => {
            let body = body.map(&mut cells.cell());
            let base = FloatingBase {
                mass: body.mass,
                com: body.com,
                inertia: body.inertia,
            };
            RuntimeTable::with_floating_base(&base, convention, gravity, &rows, &motions, &frames)
        }
        None => RuntimeTable::with_frames(convention, gravity, &rows, &motions, &frames),
    };
    arm.base = cells.frame(robot.placement());
    if let Some(tool) = &robot.tool {
        arm.tool = cells.tool(tool);
    }
    arm
}

/// Cells of a table, over values of the fields.
struct Cells<'a>(&'a [f64]);

impl Cells<'_> {
    fn number(&self, value: &Value) -> f64 {
        value.to_f64(self.0)
    }

    /// An angle, from the same parts as the engine's sine and cosine of it.
    fn angle(&self, value: &Value) -> f64 {
        if value.is_number() {
            return rounded_angle(value);
        }
        let parts = Angle::new(value);
        let rest = parts.rest.as_ref().map_or(0.0, |rest| self.number(rest));
        match parts.signed_quarter_turns() {
            0 => rest,
            quarter_turns => turned(rest, f64::from(quarter_turns)),
        }
    }

    /// The number of a cell.
    fn cell(&self) -> impl FnMut(&Value, Quantity) -> f64 {
        |value, quantity| match quantity {
            Quantity::Angle => self.angle(value),
            Quantity::Number => self.number(value),
        }
    }

    fn frame(&self, placement: Option<&Placement>) -> Frame {
        placement.map_or(Frame::IDENTITY, |placement| {
            frame(placement.map(&mut self.cell()))
        })
    }

    /// The last of some frames, each placed in the one before it.
    fn place(&self, placements: &[Placement]) -> table::Placement {
        let frames = placements.iter().map(|place| self.frame(Some(place)));
        table::Placement::of_frames(&frames.collect::<Vec<_>>())
    }

    /// A frame on a link or on the base, and its body.
    fn fixed(&self, frame: &robot::Frame) -> FixedFrame {
        let bare = FixedFrame::new(frame.on, self.place(&frame.places));
        frame.body.as_ref().map_or(bare, |body| {
            let robot::Body { mass, com, inertia } = body.map(&mut self.cell());
            FixedFrame {
                mass,
                com,
                inertia,
                ..bare
            }
        })
    }

    fn tool(&self, tool: &robot::Tool) -> Tool {
        let tool = tool.map(&mut self.cell());
        Tool {
            frame: frame(tool.placement),
            mass: tool.body.mass,
            com: tool.body.com,
            inertia: tool.body.inertia,
        }
    }

    /// How the joint of a row moves.
    fn motion(&self, row: &robot::Row) -> JointMotion {
        let row = row.map(&mut self.cell());
        match (row.follows, row.locked) {
            (None, None) => JointMotion::Free,
            (_, Some(position)) => JointMotion::Locked(position),
            (Some(coupling), None) => JointMotion::Follows {
                leader: coupling.leader,
                factor: coupling.factor,
                offset: coupling.offset,
            },
        }
    }

    /// The row of the runtime; how its joint moves is said apart from it.
    fn row(&self, robot: &Robot, i: usize) -> Row {
        let row = robot.rows[i].map(&mut self.cell());
        let [mount, link_frame] = robot.mounted(i).map(|placements| self.place(&placements));
        let tip = robot.rows[i].tip().map(|placements| self.place(placements));
        // All fields are written out, so that the compiler names a new one here.
        Row {
            joint_type: match row.joint_type {
                robot::JointType::Revolute => JointType::Revolute,
                robot::JointType::Prismatic => JointType::Prismatic,
            },
            on: match row.on {
                robot::Carrier::Above => Carrier::Above,
                robot::Carrier::Base => Carrier::Base,
                robot::Carrier::Row(carrier) => Carrier::Row(carrier),
            },
            a: row.a,
            alpha: row.alpha,
            d: row.d,
            theta: row.theta,
            mass: row.mass,
            com: row.com,
            inertia: row.inertia,
            motor_inertia: row.motor_inertia,
            gear_ratio: row.gear_ratio,
            viscous: row.viscous,
            coulomb: row.coulomb,
            stribeck: row.stribeck.map(|of| Stribeck {
                friction: of.friction,
                velocity: of.velocity,
            }),
            spring: row.spring.map_or(Spring::NONE, |of| Spring {
                stiffness: of.stiffness,
                rest: of.rest,
            }),
            limits: row.limits,
            torque_limit: row.torque_limit,
            velocity_limit: row.velocity_limit,
            mount,
            link_frame,
            tip,
            non_exhaustive: (),
        }
    }
}

fn frame(placement: Placement<f64>) -> Frame {
    Frame {
        xyz: placement.xyz,
        rpy: placement.rpy,
    }
}
