//! The table as JavaScript: everything that the page shows of the robot besides its functions.

use dynamics_symbolic::function::Part;
use dynamics_symbolic::robot::{
    Body, Convention, JointType, Mount, Placement, Robot, Row, Tool, Value,
};

use super::Start;
use super::cells::{code, text, unit};
use super::literal::{array, number, object, option, string};

/// The script that puts the table into a global variable: a function of the fields' values. `tips` are the functions that
/// place the tip and the frames.
pub(super) fn script(
    robot: &Robot,
    tips: &[Part],
    fields: &[(String, f64)],
    start: &Start,
) -> String {
    let writer = Writer(robot);
    let fields = fields.iter().enumerate().map(|(i, (name, value))| {
        object([
            ("name", string(name)),
            ("value", number(*value)),
            ("unit", string(unit(robot, i))),
        ])
    });
    let rows =
        (0..robot.rows.len()).map(|i| writer.row(Some(i), &robot.rows[i], &robot.mounted(i)));
    let rows = rows.chain(writer.place_of_tip());
    let entries = [
        ("name", string(&robot.name)),
        ("version", string(env!("CARGO_PKG_VERSION"))),
        ("dof", robot.freedoms().all().to_string()),
        ("joints", robot.freedoms().joints.to_string()),
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
            option(robot.placement().map(|base| writer.placement(base))),
        ),
        (
            "floating",
            option(robot.floating().map(|body| writer.body(body))),
        ),
        (
            "tool",
            option(robot.tool.as_ref().map(|tool| writer.tool(tool))),
        ),
        ("rows", array(rows.map(|row| format!("\n  {row}")))),
        ("tips", array(tips.iter().map(|tip| writer.tip(*tip)))),
    ];
    let first = [("fields", array(fields))].into_iter();
    let first = first.chain(start.entries());
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
        let place = self.place(&tool.placement).into_iter();
        object(place.chain(self.cells_of(&tool.body)))
    }

    /// The tip or a frame that a function places: the row whose link carries it, where it is in that link frame, and its
    /// body.
    fn tip(&self, part: Part) -> String {
        let robot = self.0;
        let frame = part.frame.map(|frame| &robot.frames[frame]);
        let (name, on, places, body) = match frame {
            Some(frame) => {
                let places = frame.places.iter().map(|place| self.placement(place));
                let body = frame.body.as_ref().map(|body| self.body(body));
                (frame.name.as_str(), frame.on, places.collect(), body)
            }
            None => {
                let tool = robot.tool.as_ref();
                let places: Vec<_> = tool.iter().map(|t| self.placement(&t.placement)).collect();
                let apart = self.place_of_tip().map(|_| robot.rows.len());
                let body = tool
                    .filter(|tool| tool.has_body())
                    .map(|tool| self.tool(tool));
                ("tip", apart.or(robot.tip_row()), places, body)
            }
        };
        object([
            ("name", string(name)),
            ("key", string(&robot.name_of(part))),
            ("isFrame", frame.is_some().to_string()),
            ("on", option(on.map(|row| row.to_string()))),
            ("places", array(places)),
            ("body", option(body)),
        ])
    }

    fn body(&self, body: &Body) -> String {
        object(self.cells_of(body))
    }

    fn cells_of(&self, body: &Body) -> [(&'static str, String); 3] {
        [
            ("mass", self.cell(&body.mass)),
            ("com", self.vector(&body.com)),
            ("inertia", self.vector(&body.inertia)),
        ]
    }

    /// The tip of a file, where it is not a link frame, as a place in the list of joints.
    fn place_of_tip(&self) -> Option<String> {
        let last = self.0.tip_row()?;
        let tip = self.0.rows[last].tip()?.to_vec();
        let [_, link_frame] = self.0.mounted(last);
        let row = Row {
            locked: Some(Value::zero()),
            at: tip.clone(),
            mount: Some(Mount {
                axis: [Value::zero(), Value::zero()],
                tip: None,
            }),
            ..Row::new("", JointType::Revolute)
        };
        let step = [link_frame, tip].concat();
        let is_apart = !row.at.is_empty();
        is_apart.then(|| self.row(None, &row, &[step, Vec::new()]))
    }

    /// A row of that index, none of the tip. `mounted` are the placements that its cells do not say.
    fn row(&self, index: Option<usize>, row: &Row, mounted: &[Vec<Placement>; 2]) -> String {
        let cells = row.cells().map(|(name, values)| {
            let value = match values {
                [value] => self.cell(value),
                values => self.vector(values),
            };
            let name = match name {
                "motor_inertia" => "motorInertia",
                "gear_ratio" => "gearRatio",
                name => name,
            };
            (name, value)
        });
        let entries = self.joint(index, row, mounted).into_iter().chain(cells);
        object(entries.chain(self.curves(row)))
    }

    /// The joint of a row, as positions count them.
    fn position_of(&self, row: usize) -> usize {
        self.0.joint_of(row) - self.0.freedoms().base
    }

    /// The cells of the row's joint: what it is, how it moves and where it stands.
    fn joint(
        &self,
        index: Option<usize>,
        row: &Row,
        [step, link_frame]: &[Vec<Placement>; 2],
    ) -> [(&'static str, String); 10] {
        let joint_type = match row.joint_type {
            JointType::Revolute => "revolute",
            JointType::Prismatic => "prismatic",
        };
        let on = match index {
            Some(index) => self.0.parent(index),
            None => self.0.tip_row(),
        };
        let joint = index.filter(|_| row.is_free());
        let joint = joint.map(|index| self.position_of(index).to_string());
        let locked = row.locked.as_ref().map(|value| self.cell(value));
        let follows = row.follows.as_ref().map(|coupling| {
            object([
                ("joint", self.position_of(coupling.leader).to_string()),
                ("factor", self.cell(&coupling.factor)),
                ("offset", self.cell(&coupling.offset)),
            ])
        });
        let limits = row.limits.as_ref().map(|limits| self.vector(limits));
        let placements = |places: &[Placement]| array(places.iter().map(|p| self.placement(p)));
        let mount = row.mount.as_ref().map(|mount| {
            object([
                ("places", placements(&row.at)),
                ("axis", self.vector(&mount.axis)),
                ("frame", placements(link_frame)),
            ])
        });
        [
            ("name", string(&row.name)),
            ("type", string(joint_type)),
            ("joint", option(joint)),
            ("isPlace", index.is_none().to_string()),
            ("on", option(on.map(|row| row.to_string()))),
            ("step", placements(step)),
            ("locked", option(locked)),
            ("follows", option(follows)),
            ("limits", option(limits)),
            ("mount", option(mount)),
        ]
    }

    /// Static friction that falls, the spring, and as text those of the first cells that have fields in them.
    fn curves(&self, row: &Row) -> [(&'static str, String); 3] {
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
        let shown = ["a", "alpha", "d", "theta", "mass"];
        let texts = row.cells().filter(|(name, _)| shown.contains(name));
        let texts =
            texts.filter_map(|(name, values)| Some((name, string(&text(self.0, &values[0])?))));
        [
            ("stribeck", option(stribeck)),
            ("spring", option(spring)),
            ("text", object(texts)),
        ]
    }
}
