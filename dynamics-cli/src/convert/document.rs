//! A table in the words of the macro, a tree that TOML and JSON write: one that was found for an arm in space, or the one
//! that was read.

use std::collections::{BTreeMap, BTreeSet};

use dynamics_codegen::Model;
use dynamics_codegen::geometry::{Body, Transform, Vector};
use dynamics_symbolic::Request;
use dynamics_symbolic::function::Part;
use dynamics_symbolic::robot::{
    Body as Fixed, Bounds, Convention, Coupling, Frame, Placement, Robot, Row as Joint,
};

use super::angle::roll_pitch_yaw;
use super::cells::{Line, fixed, floating};
use super::node::{Entries, Node, entry, list, unless_empty};
use super::table::{Row, Table};
use super::written::{Binding, expression, sum};

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
        let rows = named.map(|(row, name)| Line::found(table.convention, row, name));
        let found = |frame: &Transform| place(&frame.origin, &roll_pitch_yaw(&frame.rotation));
        let end = |frame: &Option<Transform>| frame.as_ref().map(found).unwrap_or_default();
        let base = match &table.floating {
            Some(Body { mass, com, inertia }) => floating(mass.into(), list(com), inertia),
            None => end(&table.base),
        };
        let ends = [base, end(&table.tool)];
        let frames = table.frames.iter();
        let frames = frames.map(|(row, frame)| (*row, found(frame)));
        let head = (table.convention, list(gravity));
        let frames = frames.collect();
        Document::new(head, ends, rows.collect(), frames, (model, allowed))
    }

    /// The table that was read, with the cells as they were written. Its rows have no mounts.
    pub(super) fn as_written(model: &Model, allowed: &Allowed) -> Document {
        let robot = &model.robot;
        let tool = robot.tool.as_ref().map(|tool| &tool.placement);
        let written = |place: &Placement| self::place(&place.xyz, &place.rpy);
        let place = |frame: Option<_>| frame.map(written).unwrap_or_default();
        let base = match robot.floating() {
            Some(Fixed { mass, com, inertia }) => floating(mass.into(), list(com), inertia),
            None => place(robot.placement()),
        };
        let ends = [base, place(tool)];
        let line = |row| Line::as_written(robot.convention, row);
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
        let is_tight = robot.bounds == Bounds::Tight;
        entries.extend(is_tight.then(|| entry("bounds", "tight")));
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
            let mut cells = row.into_cells(on);
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

/// The place of a frame.
fn place<'n, X, Y>(xyz: &'n [X; 3], rpy: &'n [Y; 3]) -> Entries
where
    Node: From<&'n X> + From<&'n Y>,
{
    vec![entry("xyz", list(xyz)), entry("rpy", list(rpy))]
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
