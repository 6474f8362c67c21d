//! A table in the words of the macro, a tree that TOML and JSON write: one that was found for an arm in space, or the one
//! that was read.

use std::collections::{BTreeMap, BTreeSet};

use dynamics_codegen::Model;
use dynamics_codegen::geometry::{Body, Transform, Vector};
use dynamics_symbolic::Request;
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::function::Part;
use dynamics_symbolic::robot::{
    Body as Fixed, Carrier, Convention, Coupling, Frame, JointType, Placement, Robot, Row as Joint,
    Stribeck, Value,
};

use super::angle::{Angle, roll_pitch_yaw};
use super::number::decimal;
use super::parameters::Parameters;
use super::string::quoted;
use super::table::{Row, Table};
use super::written::{Binding, expression, sum, written};

/// A value.
#[derive(Clone)]
pub(super) enum Node {
    Number(Rational),
    /// As it was written in the file that was read.
    Written(Value),
    Angle(Angle),
    Text(String),
    /// `true`
    Yes,
    List(Vec<Node>),
    Table(Entries),
}

macro_rules! impl_from {
    ($($variant:ident($given:ty))*) => {$(
        impl From<$given> for Node {
            fn from(given: $given) -> Node {
                Node::$variant(given.to_owned())
            }
        }
    )*};
}

impl_from!(Number(&Rational) Written(&Value) Angle(&Angle) Text(&str) Table(Entries));

impl Node {
    /// Whether all of its numbers are zero, so that a cell need not be written.
    fn is_zero(&self) -> bool {
        match self {
            Node::Number(x) => decimal(x) == "0",
            Node::Written(value) => value.is_zero(),
            Node::Angle(angle) => angle.is_zero(),
            Node::List(nodes) => nodes.iter().all(Node::is_zero),
            Node::Text(_) | Node::Yes | Node::Table(_) => false,
        }
    }
}

/// The words and signs of a language in which values stand on one line.
pub(super) struct Language {
    pub(super) number: fn(&Rational) -> String,
    pub(super) angle: fn(&Angle) -> String,
    pub(super) key: fn(&str) -> String,
    /// The sign between a key and its value.
    pub(super) is: &'static str,
}

impl Language {
    pub(super) fn value(&self, node: &Node) -> String {
        match node {
            Node::Number(x) => (self.number)(x),
            Node::Written(value) => written(value),
            Node::Angle(angle) => (self.angle)(angle),
            Node::Text(text) => quoted(text),
            Node::Yes => "true".to_owned(),
            Node::List(nodes) => {
                let values: Vec<_> = nodes.iter().map(|node| self.value(node)).collect();
                format!("[{}]", values.join(", "))
            }
            Node::Table(entries) => {
                let entries: Vec<_> = entries.iter().map(|entry| self.entry(entry)).collect();
                format!("{{ {} }}", entries.join(", "))
            }
        }
    }

    pub(super) fn entry(&self, (word, node): &(String, Node)) -> String {
        format!("{}{}{}", (self.key)(word), self.is, self.value(node))
    }
}

/// Words with their values, in their order.
pub(super) type Entries = Vec<(String, Node)>;

/// Words that accept what the reader refuses: of a joint or frame by its name, of the whole table without one.
pub(super) type Allowed = BTreeMap<Option<String>, BTreeSet<&'static str>>;

/// The entries of a table, without its frames and joints, and those of its frames and joints.
pub(super) struct Document {
    pub(super) entries: Entries,
    /// Each with its name.
    pub(super) frames: Entries,
    pub(super) joints: Vec<Entries>,
    /// The names of the joints.
    names: Vec<String>,
}

/// A row.
struct Line<'a> {
    name: String,
    /// The row of the joint; none where a row is only there to stand still.
    joint: Option<&'a Joint>,
    /// Where the joint stands still.
    locked: Option<Node>,
    /// The link that carries it.
    on: Carrier,
    /// Where it begins, the four parameters and the body, as far as they are not zero.
    cells: Entries,
}

impl Document {
    /// A table that was found for the arm.
    pub(super) fn of_table(
        table: &Table,
        gravity: &Vector,
        model: &Model,
        allowed: &Allowed,
    ) -> Document {
        let robot = &model.robot;
        let named = table.rows.iter().zip(names(table, robot));
        let rows = named.map(|(row, name)| found(table.convention, row, name));
        let place = |frame: &Option<Transform>| frame.as_ref().map(placement).unwrap_or_default();
        let base = match &table.floating {
            Some(Body { mass, com, inertia }) => floating(mass.into(), list(com), inertia),
            None => place(&table.base),
        };
        let ends = [base, place(&table.tool)];
        let frames = table.frames.iter();
        let frames = frames.map(|(row, frame)| (*row, placement(frame)));
        let head = (table.convention, list(gravity));
        let frames = frames.collect();
        Document::new(head, ends, rows.collect(), frames, (model, allowed))
    }

    /// The table that was read, with the cells as they were written. Its rows have no mounts.
    pub(super) fn as_written(model: &Model, allowed: &Allowed) -> Document {
        let robot = &model.robot;
        let tool = robot.tool.as_ref().map(|tool| &tool.placement);
        let place = |frame: Option<_>| frame.map(placement_as_written).unwrap_or_default();
        let base = match robot.floating() {
            Some(Fixed { mass, com, inertia }) => floating(mass.into(), list(com), inertia),
            None => place(robot.placement()),
        };
        let ends = [base, place(tool)];
        let line = |row| line_as_written(robot.convention, row);
        let frames = robot.frames.iter();
        // The frame of a table is at one place.
        let frames = frames.map(|frame| (frame.on, place(frame.places.first())));
        let head = (robot.convention, list(&robot.gravity));
        let rows = robot.rows.iter().map(line).collect();
        Document::new(head, ends, rows, frames.collect(), (model, allowed))
    }

    fn new(
        (convention, gravity): (Convention, Node),
        [base, tool_frame]: [Entries; 2],
        rows: Vec<Line<'_>>,
        frames: Vec<(Option<usize>, Entries)>,
        (model, allowed): (&Model, &Allowed),
    ) -> Document {
        let robot = &model.robot;
        let convention = match convention {
            Convention::Standard => "standard",
            Convention::Modified => "modified",
        };
        let mut entries = vec![entry("convention", convention), entry("gravity", gravity)];
        entries.extend(functions(model));
        let locked = |row: &Line<'_>| Some((row.name.clone(), row.locked.clone()?));
        entries.extend(unless_empty(
            "lock",
            rows.iter().filter_map(locked).collect(),
        ));
        entries.extend(unless_empty("couple", couplings(robot)));
        let neglect = model.neglect.as_ref();
        entries.extend(neglect.map(|(share, _)| entry("neglect", share)));
        entries.extend(allow(allowed.get(&None)));
        entries.extend(unless_empty("base", base));
        entries.extend(tool(tool_frame, robot));
        let names: Vec<String> = rows.iter().map(|row| row.name.clone()).collect();
        let link = |row: Option<usize>| row.map_or("base", |row| &*names[row]);
        let named = frame_names(robot).into_iter().zip(&robot.frames);
        let frame = |((row, place), (name, frame)): ((_, Entries), (String, &Frame))| {
            let mut cells = vec![entry("on", link(row))];
            cells.extend(place.into_iter().filter(|(_, list)| !list.is_zero()));
            cells.extend(frame.body.iter().flat_map(fixed));
            cells.extend(allow(allowed.get(&Some(name.clone()))));
            (name, Node::Table(cells))
        };
        let frames = frames.into_iter().zip(named).map(frame).collect();
        let joints = rows.into_iter().enumerate().map(|(i, row)| {
            let allowed = allow(allowed.get(&Some(row.name.clone())));
            let parent = row.on.parent(i);
            let on = (parent != i.checked_sub(1)).then(|| link(parent));
            let mut cells = cells(row, on);
            cells.extend(allowed);
            cells
        });
        Document {
            entries,
            frames,
            joints: joints.collect(),
            names,
        }
    }

    /// The names of the frames and joints, in the order in which they are written.
    pub(super) fn parts(&self) -> impl Iterator<Item = &String> {
        let frames = self.frames.iter().map(|(name, _)| name);
        frames.chain(&self.names)
    }
}

/// A row that was found.
fn found<'a>(convention: Convention, row: &Row<'a>, name: String) -> Line<'a> {
    let Parameters { a, alpha, d, theta } = &row.parameters;
    let parameters = [a.into(), alpha.into(), d.into(), theta.into()];
    let Body { mass, com, inertia } = &row.body;
    let joint = row.joint.map(|joint| joint.row);
    let at = row.at.as_ref();
    let mut cells = at.map_or(Entries::new(), |(xyz, rpy)| {
        beginning(convention, nodes(xyz), nodes(rpy))
    });
    cells.extend(geometry(parameters, mass.into(), list(com), inertia));
    Line {
        name,
        joint,
        locked: joint.is_none().then_some(Node::Number(Rational::ZERO)),
        on: row.on,
        cells,
    }
}

/// A row that was read.
fn line_as_written(convention: Convention, row: &Joint) -> Line<'_> {
    let parameters = [&row.a, &row.alpha, &row.d, &row.theta].map(Node::from);
    // The row of a table begins at one place.
    let at = row.at.first();
    let mut cells = at.map_or(Entries::new(), |at| {
        beginning(convention, nodes(&at.xyz), nodes(&at.rpy))
    });
    cells.extend(geometry(
        parameters,
        (&row.mass).into(),
        list(&row.com),
        &row.inertia,
    ));
    Line {
        name: row.name.clone(),
        joint: Some(row),
        locked: row.locked.as_ref().map(Node::from),
        on: row.on,
        cells,
    }
}

/// Where a row begins on the link that carries it. On a modified table a turn about z and a step along z have cells of
/// their own.
fn beginning(convention: Convention, xyz: [Node; 3], rpy: [Node; 3]) -> Entries {
    let others = [&xyz[0], &xyz[1], &rpy[0], &rpy[1]];
    if convention == Convention::Modified && others.into_iter().all(Node::is_zero) {
        let ([.., b], [.., gamma]) = (xyz, rpy);
        return without_zeros(["gamma", "b"], [gamma, b]);
    }
    let place = without_zeros(
        ["xyz", "rpy"],
        [xyz, rpy].map(|list| Node::List(list.into())),
    );
    unless_empty("at", place).into_iter().collect()
}

/// A base that moves, and its body.
fn floating<'n, X>(mass: Node, com: Node, inertia: &'n [X; 6]) -> Entries
where
    Node: From<&'n X>,
{
    let mut entries = vec![entry("floating", Node::Yes), entry("mass", mass)];
    entries.extend(unless_zero("com", com));
    entries.extend(tensor(inertia));
    entries
}

/// The body of a frame or of the tool.
fn fixed(body: &Fixed) -> Entries {
    let mut entries = vec![entry("mass", &body.mass), entry("com", list(&body.com))];
    entries.extend(tensor(&body.inertia));
    entries
}

/// The parameters and the body of a row, as far as they are not zero.
fn geometry<'n, X>(parameters: [Node; 4], mass: Node, com: Node, inertia: &'n [X; 6]) -> Entries
where
    Node: From<&'n X>,
{
    let mut cells = without_zeros(["a", "alpha", "d", "theta"], parameters);
    let inertia = tensor(inertia);
    // A mass of zero is written where a tensor might be taken for one without its mass.
    if !mass.is_zero() || inertia.is_some() {
        cells.push(entry("mass", mass));
    }
    cells.extend(unless_zero("com", com));
    cells.extend(inertia);
    cells
}

/// The entries of a tensor that are not zero.
fn tensor<'n, X>(inertia: &'n [X; 6]) -> Option<(String, Node)>
where
    Node: From<&'n X>,
{
    let entries = inertia.each_ref().map(Node::from);
    unless_empty("inertia", without_zeros(TENSOR, entries))
}

pub(super) const TENSOR: [&str; 6] = ["xx", "yy", "zz", "xy", "yz", "xz"];

/// A frame that was found.
fn placement(frame: &Transform) -> Entries {
    let rpy = roll_pitch_yaw(&frame.rotation);
    vec![entry("xyz", list(&frame.origin)), entry("rpy", list(&rpy))]
}

/// A frame that was read.
fn placement_as_written(frame: &Placement) -> Entries {
    vec![
        entry("xyz", list(&frame.xyz)),
        entry("rpy", list(&frame.rpy)),
    ]
}

fn entry(word: &str, node: impl Into<Node>) -> (String, Node) {
    (word.to_owned(), node.into())
}

fn unless_zero(word: &str, node: Node) -> Option<(String, Node)> {
    (!node.is_zero()).then(|| entry(word, node))
}

fn without_zeros<const K: usize>(words: [&str; K], nodes: [Node; K]) -> Entries {
    let entries = words.into_iter().zip(nodes);
    entries
        .filter_map(|(word, x)| unless_zero(word, x))
        .collect()
}

fn unless_empty(word: &str, entries: Entries) -> Option<(String, Node)> {
    (!entries.is_empty()).then(|| entry(word, entries))
}

fn nodes<'n, X>(values: &'n [X; 3]) -> [Node; 3]
where
    Node: From<&'n X>,
{
    values.each_ref().map(Node::from)
}

fn list<'n, X>(values: &'n [X]) -> Node
where
    Node: From<&'n X>,
{
    Node::List(values.iter().map(Node::from).collect())
}

/// Names of all rows: those of the joints, and others for rows that stand still.
fn names(table: &Table, robot: &Robot) -> Vec<String> {
    let joints = table.rows.iter().filter_map(|row| row.joint);
    let joints = joints.map(|joint| joint.row.name.clone());
    let taken: BTreeSet<String> = joints.chain(frame_names(robot)).collect();
    let mut free = (1..)
        .map(|count| format!("fixed_{count}"))
        .filter(|name| !taken.contains(name));
    let name = |row: &Row| match row.joint {
        Some(joint) => joint.row.name.clone(),
        None => free.next().unwrap_or_default(),
    };
    table.rows.iter().map(name).collect()
}

/// The names of all frames. A file may name its links like its joints or `base`: on a table these names are not free.
pub(super) fn frame_names(robot: &Robot) -> Vec<String> {
    let joints = robot.rows.iter().map(|row| &*row.name);
    let joints: BTreeSet<&str> = joints.chain(["base"]).collect();
    let frames: BTreeSet<&str> = robot.frames.iter().map(|frame| &*frame.name).collect();
    let name = |frame: &Frame| {
        let mut name = frame.name.clone();
        while joints.contains(&*name) || (name != frame.name && frames.contains(&*name)) {
            name.push_str("_link");
        }
        name
    };
    robot.frames.iter().map(name).collect()
}

/// The functions that were requested by name.
fn functions(model: &Model) -> Option<(String, Node)> {
    if model.requests.iter().all(|(_, place)| place.is_none()) {
        return None;
    }
    let frames = frame_names(&model.robot);
    let part = |part: &Part| match part.frame.and_then(|frame| frames.get(frame)) {
        Some(frame) => Node::Text(format!("{}({frame})", part.function.name())),
        None => part.function.name().into(),
    };
    let request = |(request, _): &(Request, _)| {
        let mut parts = request.parts().iter().map(part);
        if request.is_tuple() {
            return vec![entry(request.name(), Node::List(parts.collect()))].into();
        }
        parts.next().expect("a request has a part")
    };
    let requests = model.requests.iter().map(request).collect();
    Some(entry("functions", Node::List(requests)))
}

/// `finger_2 = "-1 * finger_1 + 0.02"`
fn couplings(robot: &Robot) -> Entries {
    let coupling = |(row, coupling): (&Joint, &Coupling)| {
        let leader = &robot.rows[coupling.leader].name;
        let factor = expression(&coupling.factor, Binding::Product);
        let multiple = format!("{factor} * {leader}");
        let text = if coupling.offset.is_zero() {
            multiple
        } else {
            sum(multiple, &coupling.offset)
        };
        (row.name.clone(), Node::Text(text))
    };
    robot.followers().map(coupling).collect()
}

fn allow(words: Option<&BTreeSet<&'static str>>) -> Option<(String, Node)> {
    let words = words?.iter().map(|word| Node::from(*word));
    Some(entry("allow", Node::List(words.collect())))
}

/// The tool's frame, and its body as the file that was read has it.
fn tool(mut entries: Entries, robot: &Robot) -> Option<(String, Node)> {
    if let Some(tool) = robot.tool.as_ref().filter(|tool| tool.has_body()) {
        entries.extend(fixed(&tool.body));
    }
    unless_empty("tool", entries)
}

/// All cells of a row. `on` is the link that carries it, where that is not the one above.
fn cells(row: Line, on: Option<&str>) -> Entries {
    let joint_type = match row.joint.map(|joint| joint.joint_type) {
        Some(JointType::Prismatic) => "prismatic",
        _ => "revolute",
    };
    let mut cells = vec![entry("name", &*row.name), entry("type", joint_type)];
    cells.extend(on.map(|on| entry("on", on)));
    cells.extend(row.cells);
    cells.extend(row.joint.into_iter().flat_map(of_joint));
    cells
}

// Each cell is written by `line_as_written` or by `of_joint`.
const _: () = assert!(Joint::CELLS == 11);

/// The motor, friction, spring and limits of a joint.
fn of_joint(joint: &Joint) -> Entries {
    let named = |word, x: &Value| unless_zero(word, x.into());
    let pair =
        |word, [(a, x), (b, y)]: [(&str, &Value); 2]| entry(word, vec![entry(a, x), entry(b, y)]);
    let mut cells = Vec::new();
    if joint.has_motor() {
        let (inertia, ratio) = (&joint.motor_inertia, &joint.gear_ratio);
        cells.push(pair("motor", [("inertia", inertia), ("gear_ratio", ratio)]));
    }
    let mut friction: Entries = named("viscous", &joint.viscous).into_iter().collect();
    let [positive, negative] = &joint.coulomb;
    if positive == negative {
        friction.extend(named("coulomb", positive));
    } else {
        let directions = [("positive", positive), ("negative", negative)];
        friction.push(pair("coulomb", directions));
    }
    if let Some(Stribeck {
        friction: highest,
        velocity,
    }) = &joint.stribeck
    {
        friction.push(pair(
            "stribeck",
            [("static", highest), ("velocity", velocity)],
        ));
    }
    cells.extend(unless_empty("friction", friction));
    if let Some(spring) = &joint.spring {
        let mut entries = vec![entry("stiffness", &spring.stiffness)];
        entries.extend(named("rest", &spring.rest));
        cells.push(entry("spring", entries));
    }
    if let Some(limits) = &joint.limits {
        cells.push(entry("limits", list(limits)));
    }
    let greatest = [
        ("torque_limit", &joint.torque_limit),
        ("velocity_limit", &joint.velocity_limit),
    ];
    for (word, limit) in greatest {
        cells.extend(limit.as_ref().map(|limit| entry(word, limit)));
    }
    cells
}
