//! The table as JavaScript: everything that the page shows of the robot besides its functions.

use dynamics_symbolic::robot::{Convention, JointType, Placement, Robot, Row, Tool, Value};

use super::Start;
use super::cells::{code, text, unit};
use super::literal::{array, number, object, option, string};

/// The script that puts the table into a global variable: a function of the fields' values.
pub(super) fn script(robot: &Robot, fields: &[(String, f64)], start: &Start) -> String {
    let writer = Writer(robot);
    let fields = fields.iter().enumerate().map(|(i, (name, value))| {
        object([
            ("name", string(name)),
            ("value", number(*value)),
            ("unit", string(unit(robot, i))),
        ])
    });
    let numbers = |values: &Vec<f64>| array(values.iter().copied().map(number));
    let rows = robot.rows.iter().enumerate();
    let entries = [
        ("name", string(&robot.name)),
        ("version", string(env!("CARGO_PKG_VERSION"))),
        ("dof", robot.dof().to_string()),
        (
            "convention",
            string(match robot.convention {
                Convention::Standard => "standard",
                Convention::Modified => "modified",
            }),
        ),
        (
            "isMounted",
            robot.rows.iter().any(|row| row.mount.is_some()).to_string(),
        ),
        ("gravity", writer.vector(&robot.gravity)),
        (
            "base",
            option(robot.base.as_ref().map(|base| writer.placement(base))),
        ),
        (
            "tool",
            option(robot.tool.as_ref().map(|tool| writer.tool(tool))),
        ),
        (
            "rows",
            array(rows.map(|(i, row)| format!("\n  {}", writer.row(i, row)))),
        ),
    ];
    let first = [
        ("fields", array(fields)),
        ("from", option(start.from.as_ref().map(numbers))),
        ("to", option(start.to.as_ref().map(numbers))),
        ("duration", number(start.duration)),
    ];
    format!(
        "globalThis.robotStart = {};\nglobalThis.robotTable = (arm) => ({});\n",
        object(first),
        object(entries)
    )
}

struct Writer<'r>(&'r Robot);

impl Writer<'_> {
    fn cell(&self, value: &Value) -> String {
        code(self.0, value)
    }

    fn vector(&self, values: &[Value]) -> String {
        array(values.iter().map(|value| self.cell(value)))
    }

    fn placement(&self, placement: &Placement) -> String {
        object(self.place(placement))
    }

    fn place(&self, placement: &Placement) -> [(&'static str, String); 2] {
        [
            ("xyz", self.vector(&placement.xyz)),
            ("rpy", self.vector(&placement.rpy)),
        ]
    }

    fn tool(&self, tool: &Tool) -> String {
        let body = [
            ("mass", self.cell(&tool.mass)),
            ("com", self.vector(&tool.com)),
            ("inertia", self.vector(&tool.inertia)),
        ];
        object(self.place(&tool.placement).into_iter().chain(body))
    }

    fn row(&self, index: usize, row: &Row) -> String {
        let placements = |places: &[Placement]| array(places.iter().map(|p| self.placement(p)));
        let mount = row.mount.as_ref().map(|mount| {
            object([
                ("places", placements(&mount.places)),
                ("axis", self.vector(&mount.axis)),
                ("frame", placements(&mount.frame)),
            ])
        });
        let stribeck = row.stribeck.as_ref().map(|stribeck| {
            object([
                ("friction", self.cell(&stribeck.friction)),
                ("velocity", self.cell(&stribeck.velocity)),
            ])
        });
        let spring = row.spring.as_ref().map(|spring| {
            object([
                ("stiffness", self.cell(&spring.stiffness)),
                ("rest", self.cell(&spring.rest)),
            ])
        });
        let follows = row.follows.as_ref().map(|coupling| {
            object([
                ("joint", self.0.joint_of(coupling.leader).to_string()),
                ("factor", self.cell(&coupling.factor)),
                ("offset", self.cell(&coupling.offset)),
            ])
        });
        let cells = [
            ("a", &row.a),
            ("alpha", &row.alpha),
            ("d", &row.d),
            ("theta", &row.theta),
            ("mass", &row.mass),
            ("motorInertia", &row.motor_inertia),
            ("gearRatio", &row.gear_ratio),
            ("viscous", &row.viscous),
        ];
        let texts = cells[..5]
            .iter()
            .filter_map(|(name, value)| text(self.0, value).map(|text| (*name, string(&text))));
        let joint_type = match row.joint_type {
            JointType::Revolute => "revolute",
            JointType::Prismatic => "prismatic",
        };
        let joint = row.is_free().then(|| self.0.joint_of(index).to_string());
        let others = [
            ("name", string(&row.name)),
            ("type", string(joint_type)),
            ("joint", option(joint)),
            ("isPlace", row.is_place().to_string()),
            (
                "locked",
                option(row.locked.as_ref().map(|value| self.cell(value))),
            ),
            ("follows", option(follows)),
            ("com", self.vector(&row.com)),
            ("inertia", self.vector(&row.inertia)),
            ("coulomb", self.vector(&row.coulomb)),
            ("stribeck", option(stribeck)),
            ("spring", option(spring)),
            (
                "limits",
                option(row.limits.as_ref().map(|limits| self.vector(limits))),
            ),
            ("mount", option(mount)),
            ("text", object(texts)),
        ];
        let cells = cells.map(|(name, value)| (name, self.cell(value)));
        object(others.into_iter().chain(cells))
    }
}
