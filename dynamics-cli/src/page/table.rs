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
        let entries = self.joint(index, row).into_iter();
        let entries = entries.chain(self.parameters(row)).chain(self.body(row));
        object(entries.chain(self.forces(row)))
    }

    /// What the row's joint is, how it moves and where it stands.
    fn joint(&self, index: usize, row: &Row) -> [(&'static str, String); 8] {
        let joint_type = match row.joint_type {
            JointType::Revolute => "revolute",
            JointType::Prismatic => "prismatic",
        };
        let joint = row.is_free().then(|| self.0.joint_of(index).to_string());
        let locked = row.locked.as_ref().map(|value| self.cell(value));
        let follows = row.follows.as_ref().map(|coupling| {
            object([
                ("joint", self.0.joint_of(coupling.leader).to_string()),
                ("factor", self.cell(&coupling.factor)),
                ("offset", self.cell(&coupling.offset)),
            ])
        });
        let limits = row.limits.as_ref().map(|limits| self.vector(limits));
        let placements = |places: &[Placement]| array(places.iter().map(|p| self.placement(p)));
        let mount = row.mount.as_ref().map(|mount| {
            object([
                ("places", placements(&mount.places)),
                ("axis", self.vector(&mount.axis)),
                ("frame", placements(&mount.frame)),
            ])
        });
        [
            ("name", string(&row.name)),
            ("type", string(joint_type)),
            ("joint", option(joint)),
            ("isPlace", row.is_place().to_string()),
            ("locked", option(locked)),
            ("follows", option(follows)),
            ("limits", option(limits)),
            ("mount", option(mount)),
        ]
    }

    /// The row's link.
    fn body(&self, row: &Row) -> [(&'static str, String); 3] {
        [
            ("mass", self.cell(&row.mass)),
            ("com", self.vector(&row.com)),
            ("inertia", self.vector(&row.inertia)),
        ]
    }

    /// What acts at the joint itself: motor, friction and spring.
    fn forces(&self, row: &Row) -> [(&'static str, String); 6] {
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
        [
            ("motorInertia", self.cell(&row.motor_inertia)),
            ("gearRatio", self.cell(&row.gear_ratio)),
            ("viscous", self.cell(&row.viscous)),
            ("coulomb", self.vector(&row.coulomb)),
            ("stribeck", option(stribeck)),
            ("spring", option(spring)),
        ]
    }

    /// The Denavit-Hartenberg parameters as numbers, and as text those cells, with the mass, that have fields in them.
    fn parameters(&self, row: &Row) -> [(&'static str, String); 5] {
        let cells = [
            ("a", &row.a),
            ("alpha", &row.alpha),
            ("d", &row.d),
            ("theta", &row.theta),
        ];
        let texts = cells.into_iter().chain([("mass", &row.mass)]);
        let texts =
            texts.filter_map(|(name, value)| text(self.0, value).map(|text| (name, string(&text))));
        let [a, alpha, d, theta] = cells.map(|(name, value)| (name, self.cell(value)));
        [a, alpha, d, theta, ("text", object(texts))]
    }
}
