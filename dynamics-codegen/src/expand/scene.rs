//! The lines of the struct's documentation about the base, the tree of its joints, the tool, frames, joints that are locked
//! or follow others, and terms that are neglected.

use dynamics_symbolic::robot::{
    Base, Body, Coupling, Frame, Neglected, Parameter, Placement, Robot, Row, Tool, Value,
};

use crate::validate::Model;

/// The lines; none where there is nothing to say.
pub(super) fn lines(model: &Model) -> Vec<String> {
    let robot = &model.robot;
    let base = robot.base.as_ref().map(|base| match base {
        Base::Standing(placement) => standing(robot, placement),
        Base::Floating(body) => floating(robot, body),
    });
    let tool = robot.tool.as_ref().map(|tool| self::tool(robot, tool));
    let mut lines: Vec<String> = base.into_iter().chain(tool).flat_map(paragraph).collect();
    lines.extend(carried(robot));
    lines.extend(frames(model));
    lines.extend(locked(robot));
    lines.extend(model.remarks().cloned().flat_map(paragraph));
    lines.extend(coupled(robot));
    lines.extend(
        robot
            .neglected
            .as_ref()
            .map(neglected)
            .into_iter()
            .flat_map(paragraph),
    );
    lines
}

fn standing(robot: &Robot, base: &Placement) -> String {
    format!(
        " The base frame is placed in the world at {}: gravity, poses, Jacobians and the potential energy are \
         those in the world.",
        placed(robot, base)
    )
}

fn floating(robot: &Robot, body: &Body) -> String {
    format!(
        " The base moves, with a body of {} kg. Its pose in the world is the argument `base`. Velocities, accelerations and \
         forces begin with its six: of the origin of its frame, then about that, both in the axes of the base. Gravity, \
         poses, Jacobians and the potential energy are those in the world.",
        shown(robot, &body.mass)
    )
}

/// The joints that do not stand at the end of the link of the row above. A file places all of them.
fn carried(robot: &Robot) -> Vec<String> {
    let line = |(i, row): (usize, &Row)| {
        let on = robot.parent(i);
        let at: &[Placement] = if row.mount.is_some() { &[] } else { &row.at };
        let is_elsewhere = on != i.checked_sub(1) || !at.is_empty();
        is_elsewhere.then(|| format!(" - `{}` {}", row.name, stands(robot, on, at)))
    };
    let rows = robot.rows.iter().enumerate();
    let text = " Joints that do not stand at the end of the link of the row above:";
    list(text, rows.filter_map(line).collect())
}

/// The frames that a method is about, or that have a body.
fn frames(model: &Model) -> Vec<String> {
    let robot = &model.robot;
    let methods = model.requests.iter();
    let parts: Vec<_> = methods.flat_map(|(request, _)| request.parts()).collect();
    let line = |(i, frame): (usize, &Frame)| {
        let body = frame.body.as_ref();
        let is_asked = parts.iter().any(|part| part.frame == Some(i));
        let mass = |body: &Body| format!(", with a body of {} kg", shown(robot, &body.mass));
        let (place, body) = (stands(robot, frame.on, &frame.places), body.map(mass));
        let is_shown = is_asked || body.is_some();
        is_shown.then(|| format!(" - `{}` {place}{}", frame.name, body.unwrap_or_default()))
    };
    let frames = robot.frames.iter().enumerate();
    list(" Frames:", frames.filter_map(line).collect())
}

/// The link that carries a thing, and where on it this stands, if that is one placement.
fn stands(robot: &Robot, on: Option<usize>, places: &[Placement]) -> String {
    let link = on.map(|row| format!("the link of `{}`", robot.rows[row].name));
    let link = link.unwrap_or("the base".to_owned());
    match places {
        [place] => format!("on {link} at {}", placed(robot, place)),
        _ => format!("on {link}"),
    }
}

fn tool(robot: &Robot, tool: &Tool) -> String {
    let body = if tool.has_body() {
        format!(", with a body of {} kg", shown(robot, &tool.body.mass))
    } else {
        String::new()
    };
    format!(
        " The tool frame is placed in the last link frame at {}{body}: it is the tip, of which \
         `forward_kinematics` and `jacobian` are.",
        placed(robot, &tool.placement)
    )
}

fn placed(robot: &Robot, placement: &Placement) -> String {
    let all = |values: &[Value; 3]| {
        let values = values.each_ref().map(|value| shown(robot, value));
        values.join(", ")
    };
    let (xyz, rpy) = (all(&placement.xyz), all(&placement.rpy));
    format!("xyz ({xyz}) m and rpy ({rpy}) rad")
}

/// A number, or the name of a field.
fn shown(robot: &Robot, value: &Value) -> String {
    match value {
        Value::Field(index) => format!("`{}`", robot.fields[*index]),
        value if value.is_number() => value.to_f64(&[]).to_string(),
        _ => "a value made of fields".to_owned(),
    }
}

fn locked(robot: &Robot) -> Vec<String> {
    let locked = robot.rows.iter().filter_map(|row| {
        let position = row.locked.as_ref()?;
        let position = if position.is_number() {
            position.to_f64(&[]).to_string()
        } else {
            "a position made of fields".to_owned()
        };
        Some(format!(" - `{}` at {position}", row.name))
    });
    list(
        " Joints that are locked, and are none of this arm's:",
        locked.collect(),
    )
}

fn coupled(robot: &Robot) -> Vec<String> {
    let line = |(row, coupling): (&Row, &Coupling)| {
        let leader = &robot.rows[coupling.leader].name;
        let factor = shown(robot, &coupling.factor);
        let offset = if coupling.offset.is_zero() {
            String::new()
        } else {
            format!(" + ({})", shown(robot, &coupling.offset))
        };
        format!(" - `{}` = {factor} * `{leader}`{offset}", row.name)
    };
    list(
        " Joints that follow others, and are none of this arm's; their links, motors, friction and springs count through \
         the joints that they follow:",
        robot.followers().map(line).collect(),
    )
}

fn neglected(neglected: &Neglected) -> String {
    let percent = dynamics_symbolic::percent(neglected.share);
    let name = |&(row, parameter): &(usize, Parameter)| format!("`{}`", parameter.name(row + 1));
    let names: Vec<String> = neglected.columns.iter().map(name).collect();
    if names.is_empty() {
        return format!(
            " Nothing is neglected: every base inertial parameter makes {percent} % or more of the largest value of a function."
        );
    }
    format!(
        " Abbreviated: of the Lagrangian, the base inertial parameters that make less than {percent} % of the largest \
         value of M, V and G each are neglected, and all functions are derived from what is left: {}. `table()` is the \
         complete table.",
        names.join(", ")
    )
}

/// A paragraph.
fn paragraph(text: String) -> [String; 2] {
    [String::new(), text]
}

/// A list, unless it is empty, behind a paragraph.
fn list(text: &str, list: Vec<String>) -> Vec<String> {
    if list.is_empty() {
        return list;
    }
    let mut lines = [paragraph(text.to_owned()).as_slice(), &[String::new()]].concat();
    lines.extend(list);
    lines
}
