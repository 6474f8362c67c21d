//! The table of an arm as text. A URDF file has no Denavit-Hartenberg table: its joints are shown as it places them.

use std::fmt::Write as _;

use dynamics_export::cell::text;
use dynamics_symbolic::function::plain;
use dynamics_symbolic::robot::{
    Body, Convention, Frame, JointType, Mount, Placement, Robot, Row, Value,
};

use crate::csv::shortest;

/// All that the file says of the arm, so that the same arm can be typed in again.
pub(super) fn table(robot: &Robot) -> String {
    let is_placed = robot.rows.iter().any(|row| row.mount.is_some());
    let how = match (is_placed, robot.convention) {
        (true, _) => "as the URDF file places them",
        (false, Convention::Standard) => "standard convention",
        (false, Convention::Modified) => "modified convention",
    };
    let joints = match robot.freedoms().joints {
        1 => "1 joint that moves".to_owned(),
        count => format!("{count} joints that move"),
    };
    let (name, gravity) = (&robot.name, numbers(robot, &robot.gravity));
    let mut text = format!("{name}: {joints}, {how}, gravity {gravity} m/s^2\n\n");
    text.push_str(&fields(robot));
    let joints = robot.rows.iter().map(|row| &row.name);
    let names = joints.chain(robot.frames.iter().map(|frame| &frame.name));
    let widest = names.map(|name| name.chars().count()).max();
    let width = widest.unwrap_or(0).max(5) + 2;
    text.push_str(&heading(robot, is_placed, width));
    if let Some(base) = robot.placement() {
        let _ = writeln!(text, "{:<width$}{}", "base", place(robot, base));
    }
    if let Some(floating) = robot.floating() {
        let body = body(robot, floating);
        let _ = writeln!(text, "{:<width$}{:<11}{body}", "base", "moves");
    }
    for (i, row) in robot.rows.iter().enumerate() {
        let on = carrier(robot, link(robot, robot.parent(i)), width);
        let (name, kind) = (&row.name, joint_type(row));
        let _ = write!(text, "{name:<width$}{kind:<11}{on}");
        text.push_str(&match &row.mount {
            Some(mount) => placed(robot, row, mount, width),
            None => cells(robot, row),
        });
    }
    text.push_str(&tip(robot, width).unwrap_or_default());
    if let Some(tool) = &robot.tool {
        let body = body(robot, &tool.body);
        let _ = writeln!(
            text,
            "{:<width$}{}{body}",
            "tool",
            place(robot, &tool.placement)
        );
    }
    if !robot.frames.is_empty() {
        text.push('\n');
    }
    for frame in &robot.frames {
        text.push_str(&frame_line(robot, frame, width));
    }
    text
}

/// The tip that a file has, unless it is the last link frame of an arm without branches.
fn tip(robot: &Robot, width: usize) -> Option<String> {
    let row = robot.tip_row()?;
    let tip = robot.rows[row].tip()?;
    let is_known = robot.is_serial() && tip.is_empty();
    let (on, tip) = (
        carrier(robot, link(robot, Some(row)), width),
        places(robot, tip),
    );
    (!is_known).then(|| format!("{:<width$}{:<11}{on}{tip}\n", "tip", "fixed"))
}

/// The line above the columns of a table, or what the numbers of a URDF file are.
fn heading(robot: &Robot, is_placed: bool, width: usize) -> String {
    if is_placed {
        return "xyz and rpy are in the frame of the link that carries the joint, com and inertia (xx, yy, zz, xy, yz, xz, \
                about the\ncentre of mass) in that of the link behind it. `robot-dynamics convert` writes a \
                Denavit-Hartenberg table.\n\n"
            .to_owned();
    }
    let on = carrier(robot, "on", width);
    format!(
        "{:<width$}{:<11}{on}{:>10}{:>10}{:>10}{:>10}{:>10}  com\n",
        "joint", "type", "a", "alpha", "d", "theta", "mass"
    )
}

/// The names in the cells that have no value.
fn fields(robot: &Robot) -> String {
    if robot.fields.is_empty() {
        return String::new();
    }
    let names: Vec<_> = robot.fields.iter().map(|field| plain(field)).collect();
    format!("fields: {}\n\n", names.join(", "))
}

/// The link behind a row, by the name of its joint.
fn link(robot: &Robot, row: Option<usize>) -> &str {
    row.map_or("base", |row| &robot.rows[row].name)
}

/// A cell of the column of a tree that says which link carries a joint. A serial arm has no such column.
fn carrier(robot: &Robot, on: &str, width: usize) -> String {
    if robot.is_serial() {
        String::new()
    } else {
        format!("{on:<width$}")
    }
}

/// A frame, and the body that is fixed there.
fn frame_line(robot: &Robot, frame: &Frame, width: usize) -> String {
    let (name, on) = (&frame.name, link(robot, frame.on));
    let places = places(robot, &frame.places);
    let fixed = frame.body.as_ref().map(|fixed| body(robot, fixed));
    let fixed = fixed.unwrap_or_default();
    format!("{name:<width$}{:<11}on {on}  {places}{fixed}\n", "frame")
}

/// A body at a place.
fn body(robot: &Robot, body: &Body) -> String {
    let (com, inertia) = (numbers(robot, &body.com), numbers(robot, &body.inertia));
    let mass = number(robot, &body.mass);
    format!("  mass {mass}  com {com}  inertia {inertia}")
}

/// The cells of a row of a Denavit-Hartenberg table.
fn cells(robot: &Robot, row: &Row) -> String {
    let of_number = |value: &Value| match value.to_f64(&[]) {
        x if x != 0.0 && !(1e-4..1e7).contains(&x.abs()) => format!("{x:.2e}"),
        x => format!("{x:.6}")
            .trim_end_matches('0')
            .trim_end_matches('.')
            .to_owned(),
    };
    let cell = |value: &Value| written(robot, value).unwrap_or_else(|| of_number(value));
    let columns = [&row.a, &row.alpha, &row.d, &row.theta, &row.mass];
    let columns = columns.map(|value| format!(" {:>9}", cell(value))).concat();
    let (com, further) = (numbers(robot, &row.com), further(robot, row));
    let at = if row.at.is_empty() {
        String::new()
    } else {
        format!("  at {}", places(robot, &row.at))
    };
    format!("{columns}  {com}{at}{further}\n")
}

/// Where a joint of a URDF file is, and its link.
fn placed(robot: &Robot, row: &Row, mount: &Mount, width: usize) -> String {
    let places = places(robot, &row.at);
    let [azimuth, polar] = mount.axis.each_ref().map(|angle| angle.to_f64(&[]));
    let axis = [
        polar.sin() * azimuth.cos(),
        polar.sin() * azimuth.sin(),
        polar.cos(),
    ];
    // The sine of pi is 1.2e-16 in doubles.
    let axis = axis.map(|x| shortest(if x.abs() < 1e-15 { 0.0 } else { x }));
    let axis = axis.join(", ");
    let (mass, com) = (number(robot, &row.mass), numbers(robot, &row.com));
    let further = further(robot, row);
    format!(
        "{places}  axis [{axis}]\n{:width$}mass {mass}  com {com}{further}\n",
        ""
    )
}

// Each cell is shown by `cells`, `placed` or `further`.
const _: () = assert!(Row::CELLS == 11);

/// The entries of a row besides its place, its mass and the centre of that. A motor has its inertia and its gear
/// ratio, dry friction one value for each direction, a spring its stiffness and its position at rest.
fn further(robot: &Robot, row: &Row) -> String {
    let stribeck = row.stribeck.iter();
    let stribeck = stribeck.flat_map(|stribeck| [&stribeck.friction, &stribeck.velocity]);
    let spring = row.spring.iter();
    let spring = spring.flat_map(|spring| [&spring.stiffness, &spring.rest]);
    let entries = [
        ("inertia", row.inertia.iter().collect::<Vec<_>>()),
        ("motor", vec![&row.motor_inertia, &row.gear_ratio]),
        ("viscous", vec![&row.viscous]),
        ("coulomb", row.coulomb.iter().collect()),
        ("static, velocity", stribeck.collect()),
        ("spring", spring.collect()),
        ("limits", row.limits.iter().flatten().collect()),
        ("torque limit", row.torque_limit.iter().collect()),
        ("velocity limit", row.velocity_limit.iter().collect()),
    ];
    let mut text = String::new();
    for (word, values) in entries {
        if values.iter().any(|value| !value.is_zero()) {
            let _ = write!(text, "  {word} {}", numbers(robot, values));
        }
    }
    if let Some(coupling) = &row.follows {
        let leader = &robot.rows[coupling.leader].name;
        let [factor, offset] =
            [&coupling.factor, &coupling.offset].map(|value| number(robot, value));
        let _ = write!(text, "  follows {factor} {leader} + {offset}");
    }
    if let Some(position) = &row.locked {
        let _ = write!(text, "  locked at {}", number(robot, position));
    }
    text
}

fn joint_type(row: &Row) -> &'static str {
    match row.joint_type {
        JointType::Revolute => "revolute",
        JointType::Prismatic => "prismatic",
    }
}

/// Places one after the other, except for those that change nothing.
fn places(robot: &Robot, places: &[Placement]) -> String {
    let is_still = |x: &Placement| x.xyz.iter().chain(&x.rpy).all(Value::is_zero);
    let (still, moving): (Vec<_>, Vec<_>) = places.iter().partition(|place| is_still(place));
    let first = still.into_iter().take(usize::from(moving.is_empty()));
    let shown = moving.iter().copied().chain(first);
    let shown: Vec<_> = shown.map(|one| place(robot, one)).collect();
    shown.join(", then ")
}

fn place(robot: &Robot, place: &Placement) -> String {
    format!(
        "xyz {}  rpy {}",
        numbers(robot, &place.xyz),
        numbers(robot, &place.rpy)
    )
}

/// A cell with the names of fields, in the letters of a file.
fn written(robot: &Robot, value: &Value) -> Option<String> {
    text(robot, value).map(|text| text.replace('\u{3c0}', "PI"))
}

/// A number, or a cell with the names of fields.
fn number(robot: &Robot, value: &Value) -> String {
    written(robot, value).unwrap_or_else(|| shortest(value.to_f64(&[])))
}

fn numbers<'v>(robot: &Robot, values: impl IntoIterator<Item = &'v Value>) -> String {
    let numbers: Vec<_> = values
        .into_iter()
        .map(|value| number(robot, value))
        .collect();
    format!("[{}]", numbers.join(", "))
}
