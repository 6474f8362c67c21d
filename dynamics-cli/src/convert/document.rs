//! What a table says, in the words of the macro: a tree that TOML and JSON write.

use std::collections::{BTreeMap, BTreeSet};

use dynamics_codegen::Model;
use dynamics_codegen::geometry::{Body, Transform, Vector, number};
use dynamics_symbolic::Request;
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{Convention, Coupling, JointType, Robot, Row as Joint, Value};

use super::angle::{Angle, roll_pitch_yaw};
use super::number::decimal;
use super::table::{Row, Table};

/// A value.
#[derive(Clone)]
pub(super) enum Node {
    Number(Rational),
    Angle(Angle),
    Text(String),
    List(Vec<Node>),
    Table(Entries),
}

/// Words and what they say, in their order.
pub(super) type Entries = Vec<(String, Node)>;

/// Words that accept what the reader refuses: of a joint by its name, of the whole table without one.
pub(super) type Allowed = BTreeMap<Option<String>, BTreeSet<&'static str>>;

/// The entries of a table, without its joints, and those of its joints.
pub(super) struct Document {
    pub(super) entries: Entries,
    pub(super) joints: Vec<Entries>,
}

impl Document {
    pub(super) fn new(
        table: &Table,
        gravity: &Vector,
        model: &Model,
        allowed: &Allowed,
    ) -> Document {
        let robot = &model.robot;
        let convention = match table.convention {
            Convention::Standard => "standard",
            Convention::Modified => "modified",
        };
        let mut entries = vec![
            entry("convention", Node::Text(convention.to_owned())),
            entry("gravity", numbers(gravity)),
        ];
        entries.extend(functions(model));
        let names = names(table);
        let locked = names.iter().zip(&table.rows);
        let locked = locked.filter(|(_, row)| row.joint.is_none());
        let locked: Entries = locked
            .map(|(name, _)| (name.clone(), Node::Number(Rational::ZERO)))
            .collect();
        entries.extend(unless_empty("lock", locked));
        entries.extend(unless_empty("couple", couplings(robot)));
        if let Some((share, _)) = &model.neglect {
            entries.push(entry("neglect", value(share)));
        }
        entries.extend(allow(allowed.get(&None)));
        if let Some(base) = &table.base {
            entries.push(entry("base", Node::Table(placement(base))));
        }
        entries.extend(tool(table, robot));
        let joints = table.rows.iter().zip(&names).map(|(row, name)| {
            let mut cells = cells(row, name);
            cells.extend(allow(allowed.get(&Some(name.clone()))));
            cells
        });
        Document {
            entries,
            joints: joints.collect(),
        }
    }
}

fn entry(word: &str, node: Node) -> (String, Node) {
    (word.to_owned(), node)
}

fn unless_empty(word: &str, entries: Entries) -> Option<(String, Node)> {
    (!entries.is_empty()).then(|| entry(word, Node::Table(entries)))
}

fn numbers(values: &[Rational]) -> Node {
    Node::List(values.iter().cloned().map(Node::Number).collect())
}

fn values(values: &[Value]) -> Node {
    Node::List(values.iter().map(value).collect())
}

/// A number of the file that was read.
fn value(value: &Value) -> Node {
    Node::Number(number(value).unwrap_or(Rational::ZERO))
}

/// Names of all rows: those of the joints, and others for rows that stand still.
pub(super) fn names(table: &Table) -> Vec<String> {
    let joints = table.rows.iter().filter_map(|row| row.joint);
    let taken: BTreeSet<&str> = joints.map(|joint| joint.row.name.as_str()).collect();
    let mut free = (1..)
        .map(|count| format!("fixed_{count}"))
        .filter(|name| !taken.contains(name.as_str()));
    let name = |row: &Row| match row.joint {
        Some(joint) => joint.row.name.clone(),
        None => free.next().unwrap_or_default(),
    };
    table.rows.iter().map(name).collect()
}

/// The functions that were asked for by name.
fn functions(model: &Model) -> Option<(String, Node)> {
    if model.requests.iter().all(|(_, place)| place.is_none()) {
        return None;
    }
    let name = |name: &str| Node::Text(name.to_owned());
    let request = |(request, _): &(Request, _)| match request {
        Request::One(function) => name(function.name()),
        Request::Fused(fused) => {
            let parts = fused.parts.iter().map(|part| name(part.name()));
            Node::Table(vec![entry(request.name(), Node::List(parts.collect()))])
        }
    };
    let requests = model.requests.iter().map(request).collect();
    Some(entry("functions", Node::List(requests)))
}

/// `finger_2 = "-1 * finger_1 + 0.02"`
fn couplings(robot: &Robot) -> Entries {
    let coupling = |(row, coupling): (&Joint, &Coupling)| {
        let [factor, offset] = [&coupling.factor, &coupling.offset]
            .map(|value| decimal(&number(value).unwrap_or(Rational::ZERO)));
        let leader = &robot.rows[coupling.leader].name;
        let text = match offset.as_str() {
            "0" => format!("{factor} * {leader}"),
            _ => format!("{factor} * {leader} + {offset}"),
        };
        (row.name.clone(), Node::Text(text))
    };
    robot.followers().map(coupling).collect()
}

fn allow(words: Option<&BTreeSet<&'static str>>) -> Option<(String, Node)> {
    let words = words?.iter().map(|word| Node::Text((*word).to_owned()));
    Some(entry("allow", Node::List(words.collect())))
}

/// `xyz` and `rpy` of a frame.
fn placement(frame: &Transform) -> Entries {
    let rpy = roll_pitch_yaw(&frame.rotation);
    vec![
        entry("xyz", numbers(&frame.origin)),
        entry("rpy", Node::List(rpy.map(Node::Angle).to_vec())),
    ]
}

/// The tool's frame, and its body as the file that was read has it.
fn tool(table: &Table, robot: &Robot) -> Option<(String, Node)> {
    let mut entries = table.tool.as_ref().map(placement).unwrap_or_default();
    if let Some(tool) = robot.tool.as_ref().filter(|tool| tool.has_body()) {
        entries.push(entry("mass", value(&tool.mass)));
        entries.push(entry("com", values(&tool.com)));
        let inertia = tool
            .inertia
            .each_ref()
            .map(|x| number(x).unwrap_or(Rational::ZERO));
        entries.extend(tensor(&inertia));
    }
    unless_empty("tool", entries)
}

/// The entries of a tensor that are not zero.
fn tensor(inertia: &[Rational; 6]) -> Option<(String, Node)> {
    let words = ["xx", "yy", "zz", "xy", "yz", "xz"]
        .into_iter()
        .zip(inertia);
    let entries = words.filter(|(_, x)| decimal(x) != "0");
    let entries = entries.map(|(word, x)| entry(word, Node::Number(x.clone())));
    unless_empty("inertia", entries.collect())
}

fn cells(row: &Row, name: &str) -> Entries {
    let is_slide = row
        .joint
        .is_some_and(|joint| joint.row.joint_type == JointType::Prismatic);
    let joint_type = if is_slide { "prismatic" } else { "revolute" };
    let mut cells = vec![
        entry("name", Node::Text(name.to_owned())),
        entry("type", Node::Text(joint_type.to_owned())),
    ];
    let length =
        |word, x: &Rational| (decimal(x) != "0").then(|| entry(word, Node::Number(x.clone())));
    let angle = |word, x: &Angle| (!x.is_zero()).then(|| entry(word, Node::Angle(x.clone())));
    let parameters = &row.parameters;
    cells.extend(length("a", &parameters.a));
    cells.extend(angle("alpha", &parameters.alpha));
    cells.extend(length("d", &parameters.d));
    cells.extend(angle("theta", &parameters.theta));
    cells.extend(body(&row.body));
    cells.extend(row.joint.iter().flat_map(|joint| of_joint(joint.row)));
    cells
}

fn body(body: &Body) -> Entries {
    let inertia = tensor(&body.inertia);
    let mut cells = Vec::new();
    // A mass of zero is written where a tensor might be taken for one without its mass.
    if !body.mass.is_zero() || inertia.is_some() {
        cells.push(entry("mass", Node::Number(body.mass.clone())));
    }
    if body.com.iter().any(|x| decimal(x) != "0") {
        cells.push(entry("com", numbers(&body.com)));
    }
    cells.extend(inertia);
    cells
}

/// What a row says of the joint itself: motor, friction, spring, limits.
fn of_joint(joint: &Joint) -> Entries {
    let named = |word, x: &Value| (!x.is_zero()).then(|| entry(word, value(x)));
    let mut cells = Vec::new();
    if joint.has_motor() {
        let motor = vec![
            entry("inertia", value(&joint.motor_inertia)),
            entry("gear_ratio", value(&joint.gear_ratio)),
        ];
        cells.push(entry("motor", Node::Table(motor)));
    }
    let mut friction: Entries = named("viscous", &joint.viscous).into_iter().collect();
    let [positive, negative] = &joint.coulomb;
    if positive == negative {
        friction.extend(named("coulomb", positive));
    } else {
        let directions = vec![
            entry("positive", value(positive)),
            entry("negative", value(negative)),
        ];
        friction.push(entry("coulomb", Node::Table(directions)));
    }
    if let Some(stribeck) = &joint.stribeck {
        let stribeck = vec![
            entry("static", value(&stribeck.friction)),
            entry("velocity", value(&stribeck.velocity)),
        ];
        friction.push(entry("stribeck", Node::Table(stribeck)));
    }
    cells.extend(unless_empty("friction", friction));
    if let Some(spring) = &joint.spring {
        let mut entries = vec![entry("stiffness", value(&spring.stiffness))];
        entries.extend(named("rest", &spring.rest));
        cells.push(entry("spring", Node::Table(entries)));
    }
    if let Some(limits) = &joint.limits {
        cells.push(entry("limits", values(limits)));
    }
    cells
}
