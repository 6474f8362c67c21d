//! The table of an arm as text. A URDF file has no Denavit-Hartenberg table: its joints are shown as it places them.

use std::fmt::Write as _;

use dynamics_symbolic::robot::{Convention, JointType, Mount, Placement, Robot, Row, Value};

use crate::csv::shortest;

/// All that the file says of the arm, so that the same arm can be typed in again.
pub(super) fn table(robot: &Robot) -> String {
    let is_placed = robot.rows.iter().any(|row| row.mount.is_some());
    let how = match (is_placed, robot.convention) {
        (true, _) => "as the URDF file places them",
        (false, Convention::Standard) => "standard convention",
        (false, Convention::Modified) => "modified convention",
    };
    let joints = match robot.dof() {
        1 => "1 joint that moves".to_owned(),
        dof => format!("{dof} joints that move"),
    };
    let gravity = numbers(&robot.gravity);
    let mut text = format!(
        "{}: {joints}, {how}, gravity {gravity} m/s^2\n\n",
        robot.name
    );
    let widest = robot.rows.iter().map(|row| row.name.chars().count()).max();
    let width = widest.unwrap_or(0).max(5) + 2;
    if is_placed {
        text.push_str(
            "Each joint stands at xyz, rpy in the link frame before, by T(xyz) Rz(yaw) Ry(pitch) Rx(roll); com and \
             inertia\n(xx, yy, zz, xy, yz, xz, about the centre of mass) are in its link frame. \
             `robot-dynamics convert` writes a\nDenavit-Hartenberg table.\n\n",
        );
    } else {
        let _ = writeln!(
            text,
            "{:<width$}{:<11}{:>10}{:>10}{:>10}{:>10}{:>10}  com",
            "joint", "type", "a", "alpha", "d", "theta", "mass"
        );
    }
    if let Some(base) = &robot.base {
        let _ = writeln!(text, "{:<width$}{}", "base", place(base));
    }
    for row in &robot.rows {
        match (&row.mount, is_placed) {
            (Some(mount), _) => text.push_str(&placed(robot, row, mount, width)),
            // Rows of the equations, which the file does not have.
            (None, true) => {}
            (None, false) => text.push_str(&cells(robot, row, width)),
        }
    }
    if let Some(tool) = &robot.tool {
        let [com, inertia] = [numbers(&tool.com), numbers(&tool.inertia)];
        let (place, mass) = (place(&tool.placement), number(&tool.mass));
        let _ = writeln!(
            text,
            "{:<width$}{place}  mass {mass}  com {com}  inertia {inertia}",
            "tool"
        );
    }
    text
}

/// A row of a Denavit-Hartenberg table.
fn cells(robot: &Robot, row: &Row, width: usize) -> String {
    let cell = |value: &Value| match value.to_f64(&[]) {
        x if x != 0.0 && !(1e-4..1e7).contains(&x.abs()) => format!("{x:.2e}"),
        x => format!("{x:.6}")
            .trim_end_matches('0')
            .trim_end_matches('.')
            .to_owned(),
    };
    let numbers_of_row = [&row.a, &row.alpha, &row.d, &row.theta, &row.mass].map(cell);
    let columns = numbers_of_row
        .map(|number| format!("{number:>10}"))
        .concat();
    let further = further(robot, row).into_iter();
    let further: String = further.map(|entry| format!(", {entry}")).collect();
    format!(
        "{:<width$}{:<11}{columns}  {}{further}\n",
        row.name,
        joint_type(row),
        numbers(&row.com)
    )
}

/// A joint of a URDF file with its link, or the tip.
fn placed(robot: &Robot, row: &Row, mount: &Mount, width: usize) -> String {
    let places: Vec<_> = mount.places.iter().map(place).collect();
    let places = match places.is_empty() {
        true => "xyz [0, 0, 0]  rpy [0, 0, 0]".to_owned(),
        false => places.join(", then "),
    };
    if row.is_place() {
        return format!("{:<width$}{:<11}{places}\n", "tip", "fixed");
    }
    let [azimuth, polar] = mount.axis.each_ref().map(|angle| angle.to_f64(&[]));
    let axis = [
        polar.sin() * azimuth.cos(),
        polar.sin() * azimuth.sin(),
        polar.cos(),
    ];
    // The sine of pi is 1.2e-16 in doubles.
    let axis = axis.map(|x| shortest(if x.abs() < 1e-15 { 0.0 } else { x }));
    let mut text = format!(
        "{:<width$}{:<11}{places}  axis [{}]\n{:width$}mass {}  com {}",
        row.name,
        joint_type(row),
        axis.join(", "),
        "",
        number(&row.mass),
        numbers(&row.com)
    );
    for entry in further(robot, row) {
        text.push_str("  ");
        text.push_str(&entry);
    }
    text + "\n"
}

/// What a row says besides its place, its mass and the centre of that. A motor has its inertia and its gear ratio, dry
/// friction one value for each direction, a spring its stiffness and its position at rest.
fn further(robot: &Robot, row: &Row) -> Vec<String> {
    let pair = |a: &Value, b: &Value| vec![a.clone(), b.clone()];
    let stribeck = row.stribeck.as_ref();
    let spring = row.spring.as_ref();
    let entries = [
        ("inertia", Some(row.inertia.to_vec())),
        ("motor", Some(pair(&row.motor_inertia, &row.gear_ratio))),
        ("viscous", Some(vec![row.viscous.clone()])),
        ("coulomb", Some(row.coulomb.to_vec())),
        (
            "static, velocity",
            stribeck.map(|s| pair(&s.friction, &s.velocity)),
        ),
        (
            "spring",
            spring.map(|spring| pair(&spring.stiffness, &spring.rest)),
        ),
        ("limits", row.limits.as_ref().map(|limits| limits.to_vec())),
    ];
    let given = entries.into_iter().filter_map(|(word, values)| {
        let values = values.filter(|values| values.iter().any(|value| !value.is_zero()))?;
        Some(format!("{word} {}", numbers(&values)))
    });
    let follows = row.follows.iter().map(|coupling| {
        let leader = &robot.rows[coupling.leader].name;
        let [factor, offset] = [&coupling.factor, &coupling.offset].map(number);
        format!("follows {factor} {leader} + {offset}")
    });
    let locked = row.locked.iter();
    let locked = locked.map(|position| format!("locked at {}", number(position)));
    given.chain(follows).chain(locked).collect()
}

fn joint_type(row: &Row) -> &'static str {
    match row.joint_type {
        JointType::Revolute => "revolute",
        JointType::Prismatic => "prismatic",
    }
}

fn place(place: &Placement) -> String {
    format!("xyz {}  rpy {}", numbers(&place.xyz), numbers(&place.rpy))
}

fn number(value: &Value) -> String {
    shortest(value.to_f64(&[]))
}

fn numbers(values: &[Value]) -> String {
    let numbers: Vec<_> = values.iter().map(number).collect();
    format!("[{}]", numbers.join(", "))
}
