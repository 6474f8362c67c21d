//! What the struct's documentation says of the base, of the tool, of joints that are locked or follow
//! others and of terms that are neglected.

use dynamics_symbolic::robot::{Coupling, Neglected, Placement, Robot, Row, Tool, Value};

use crate::validate::Model;

/// The lines; none where there is nothing to say.
pub(super) fn lines(model: &Model) -> Vec<String> {
    let robot = &model.robot;
    let base = robot.base.as_ref().map(|base| self::base(robot, base));
    let tool = robot.tool.as_ref().map(|tool| self::tool(robot, tool));
    let frames = base.into_iter().chain(tool);
    let mut lines: Vec<String> = frames.flat_map(|text| section(&text, Vec::new())).collect();
    lines.extend(locked(model));
    let notes = model.notes.iter();
    lines.extend(notes.flat_map(|note| section(note, Vec::new())));
    lines.extend(coupled(robot));
    if let Some(neglected) = &model.robot.neglected {
        lines.extend(self::neglected(neglected));
    }
    lines
}

fn base(robot: &Robot, base: &Placement) -> String {
    format!(
        " The base frame is placed in the world at {}: gravity, poses, Jacobians and the potential energy are \
         those in the world.",
        placed(robot, base)
    )
}

fn tool(robot: &Robot, tool: &Tool) -> String {
    let body = match tool.has_body() {
        true => format!(", with a body of {} kg", shown(robot, &tool.mass)),
        false => String::new(),
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

fn locked(model: &Model) -> Vec<String> {
    let locked = model.robot.rows.iter().filter_map(|row| {
        let position = row.locked.as_ref()?;
        let position = match position.is_number() {
            true => position.to_f64(&[]).to_string(),
            false => "a position made of fields".to_owned(),
        };
        Some(format!(" - `{}` at {position}", row.name))
    });
    let locked: Vec<String> = locked.collect();
    match locked.is_empty() {
        true => Vec::new(),
        false => section(
            " Joints that are locked, and are none of this arm's:",
            locked,
        ),
    }
}

fn coupled(robot: &Robot) -> Vec<String> {
    let line = |(row, coupling): (&Row, &Coupling)| {
        let leader = &robot.rows[coupling.leader].name;
        let factor = shown(robot, &coupling.factor);
        let offset = match coupling.offset.is_zero() {
            true => String::new(),
            false => format!(" + ({})", shown(robot, &coupling.offset)),
        };
        format!(" - `{}` = {factor} * `{leader}`{offset}", row.name)
    };
    let coupled: Vec<String> = robot.followers().map(line).collect();
    match coupled.is_empty() {
        true => Vec::new(),
        false => section(
            " Joints that follow others, and are none of this arm's; their links, motors, friction and springs \
             count through the joints that they follow:",
            coupled,
        ),
    }
}

fn neglected(neglected: &Neglected) -> Vec<String> {
    let percent = dynamics_symbolic::percent(neglected.share);
    let name = |&(row, parameter): &(usize, dynamics_symbolic::robot::Parameter)| {
        format!("`{}`", parameter.name(row + 1))
    };
    let names: Vec<String> = neglected.columns.iter().map(name).collect();
    let text = match names.is_empty() {
        true => format!(
            " Nothing is neglected: every base inertial parameter makes {percent} % or more of the largest value of a function."
        ),
        false => format!(
            " Abbreviated: of the Lagrangian, the base inertial parameters that make less than {percent} % of the \
             largest value of M, V and G each are neglected, and all functions are derived from what is left: {}. \
             `table()` is the complete table.",
            names.join(", ")
        ),
    };
    section(&text, Vec::new())
}

/// A paragraph and its list.
fn section(text: &str, list: Vec<String>) -> Vec<String> {
    let mut lines = vec![String::new(), text.to_owned()];
    if !list.is_empty() {
        lines.push(String::new());
    }
    lines.extend(list);
    lines
}
