//! The table of a robot in numbers, as a generated struct hands it out.

use dynamics_runtime::{
    Convention, Frame, JointMotion, JointType, Row, RuntimeTable, Spring, Stribeck, Tool, turned,
};
use dynamics_symbolic::program::rounded_angle;
use dynamics_symbolic::robot::{self, Angle, Placement, Robot, Value};

/// The table for these values of the fields.
pub(crate) fn table(robot: &Robot, fields: &[f64]) -> RuntimeTable {
    let cells = Cells(fields);
    let convention = match robot.convention {
        robot::Convention::Standard => Convention::Standard,
        robot::Convention::Modified => Convention::Modified,
    };
    let gravity = robot.gravity.each_ref().map(|value| cells.number(value));
    let rows: Vec<Row> = robot.rows.iter().map(|row| cells.row(row)).collect();
    let motions: Vec<_> = robot.rows.iter().map(|row| cells.motion(row)).collect();
    let mut arm = if motions.iter().all(|motion| *motion == JointMotion::Free) {
        RuntimeTable::new(convention, gravity, rows)
    } else {
        RuntimeTable::couple(convention, gravity, &rows, &motions)
    };
    arm.base = cells.frame(robot.base.as_ref());
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

    fn numbers<const K: usize>(&self, values: &[Value; K]) -> [f64; K] {
        values.each_ref().map(|value| self.number(value))
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

    fn frame(&self, placement: Option<&Placement>) -> Frame {
        placement.map_or(Frame::IDENTITY, |placement| Frame {
            xyz: self.numbers(&placement.xyz),
            rpy: placement.rpy.each_ref().map(|angle| self.angle(angle)),
        })
    }

    fn tool(&self, tool: &robot::Tool) -> Tool {
        Tool {
            frame: self.frame(Some(&tool.placement)),
            mass: self.number(&tool.mass),
            com: self.numbers(&tool.com),
            inertia: self.numbers(&tool.inertia),
        }
    }

    /// Where the joint of a row is locked.
    fn locked(&self, row: &robot::Row) -> Option<f64> {
        row.locked.as_ref().map(|position| match row.joint_type {
            robot::JointType::Revolute => self.angle(position),
            robot::JointType::Prismatic => self.number(position),
        })
    }

    /// Where the link frame is behind the joint.
    fn link_frame(&self, row: &robot::Row) -> dynamics_runtime::Placement {
        let places = row.mount.iter().flat_map(|mount| &mount.frame);
        let frames: Vec<Frame> = places.map(|place| self.frame(Some(place))).collect();
        dynamics_runtime::Placement::of_frames(&frames)
    }

    /// How the joint of a row moves.
    fn motion(&self, row: &robot::Row) -> JointMotion {
        match (&row.follows, self.locked(row)) {
            (None, None) => JointMotion::Free,
            (_, Some(position)) => JointMotion::Locked(position),
            (Some(coupling), None) => JointMotion::Follows {
                leader: coupling.leader,
                factor: self.number(&coupling.factor),
                offset: match row.joint_type {
                    robot::JointType::Revolute => self.angle(&coupling.offset),
                    robot::JointType::Prismatic => self.number(&coupling.offset),
                },
            },
        }
    }

    fn row(&self, row: &robot::Row) -> Row {
        let joint_type = match row.joint_type {
            robot::JointType::Revolute => JointType::Revolute,
            robot::JointType::Prismatic => JointType::Prismatic,
        };
        Row {
            a: self.number(&row.a),
            alpha: self.angle(&row.alpha),
            d: self.number(&row.d),
            theta: self.angle(&row.theta),
            mass: self.number(&row.mass),
            com: self.numbers(&row.com),
            inertia: self.numbers(&row.inertia),
            motor_inertia: self.number(&row.motor_inertia),
            gear_ratio: self.number(&row.gear_ratio),
            viscous: self.number(&row.viscous),
            coulomb: self.numbers(&row.coulomb),
            stribeck: row.stribeck.as_ref().map(|stribeck| Stribeck {
                friction: self.number(&stribeck.friction),
                velocity: self.number(&stribeck.velocity),
            }),
            spring: row.spring.as_ref().map_or(Spring::NONE, |spring| Spring {
                stiffness: self.number(&spring.stiffness),
                rest: self.number(&spring.rest),
            }),
            limits: row.limits.as_ref().map(|limits| self.numbers(limits)),
            link_frame: self.link_frame(row),
            ..Row::new(joint_type)
        }
    }
}
