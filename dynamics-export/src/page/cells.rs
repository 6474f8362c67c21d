//! Cells of the table as JavaScript, as text, and with the units of their fields.

use dynamics_symbolic::function::plain;
use dynamics_symbolic::robot::{Robot, Row, Value};

use super::literal::number;
pub(super) use crate::cell::text;

/// A cell over the fields, which are properties of `arm`.
pub(super) fn code(robot: &Robot, value: &Value) -> String {
    let of = |value: &Value| code(robot, value);
    match value {
        Value::Field(i) => format!("arm.{}", plain(&robot.fields[*i])),
        value if value.is_number() => match value.to_f64(&[]) {
            x if x < 0.0 => format!("({})", number(x)),
            x => number(x),
        },
        Value::Rational(_) | Value::Pi => number(value.to_f64(&[])),
        Value::Neg(a) => format!("(-{})", of(a)),
        Value::Add(a, b) => format!("({} + {})", of(a), of(b)),
        Value::Mul(a, b) => format!("({} * {})", of(a), of(b)),
        Value::Div(a, b) => format!("({} / {})", of(a), of(b)),
    }
}

/// The unit of a field: that of the cells which are the field times a number, where they are all of one.
pub(super) fn unit(robot: &Robot, field: usize) -> &'static str {
    let known = cells(robot).filter_map(|(name, values)| Some((unit_of(name)?, values)));
    let is_meant = |value: &Value| is_multiple_of(value, field);
    let mut units = known.filter(|(_, values)| values.iter().any(is_meant));
    let first = units.next().map_or("", |(unit, _)| unit);
    if units.all(|(unit, _)| unit == first) {
        first
    } else {
        ""
    }
}

fn is_multiple_of(value: &Value, field: usize) -> bool {
    match value {
        Value::Field(i) => *i == field,
        Value::Neg(a) => is_multiple_of(a, field),
        Value::Mul(a, b) => {
            (a.is_number() && is_multiple_of(b, field))
                || (b.is_number() && is_multiple_of(a, field))
        }
        Value::Div(a, b) => b.is_number() && is_multiple_of(a, field),
        _ => false,
    }
}

/// The unit of a cell, if it does not depend on what else stands in the table.
fn unit_of(cell: &str) -> Option<&'static str> {
    Some(match cell {
        "gravity" => "m/s\u{b2}",
        "a" | "d" | "com" | "xyz" => "m",
        "alpha" | "theta" | "rpy" => "rad",
        "mass" => "kg",
        "inertia" | "motor_inertia" => "kg m\u{b2}",
        _ => return None,
    })
}

/// The cells of the table with their names.
fn cells(robot: &Robot) -> impl Iterator<Item = (&'static str, &[Value])> {
    let tool = robot.tool.as_ref();
    let bodies = tool.map(|tool| &tool.body).into_iter();
    let bodies = bodies.chain(robot.floating()).flat_map(|body| {
        let mass = ("mass", core::slice::from_ref(&body.mass));
        [mass, ("com", &body.com), ("inertia", &body.inertia)]
    });
    let places = robot
        .placement()
        .into_iter()
        .chain(tool.map(|tool| &tool.placement));
    let places = places.flat_map(|place| [("xyz", &place.xyz[..]), ("rpy", &place.rpy)]);
    let gravity = ("gravity", &robot.gravity[..]);
    let rows = robot.rows.iter().flat_map(Row::cells);
    rows.chain([gravity]).chain(places).chain(bodies)
}

#[cfg(test)]
mod tests {
    use super::*;
    use dynamics_symbolic::robot::Convention;

    fn robot() -> Robot {
        Robot {
            name: "arm".to_owned(),
            fields: ["l", "m", "r#type"].map(str::to_owned).to_vec(),
            convention: Convention::Modified,
            gravity: [Value::zero(), -Value::field(2), Value::zero()],
            base: None,
            rows: Vec::new(),
            tool: None,
            frames: Vec::new(),
            neglected: None,
            bounds: Default::default(),
        }
    }

    #[test]
    fn cells_are_written_for_machines_and_for_people() {
        let (l, m) = (Value::field(0), Value::field(1));
        let two = || Value::integer(2);
        let half = |value: Value| value.checked_div(two()).unwrap();
        let cases = [
            (half(l.clone()), "(arm.l / 2.0)", "l / 2"),
            (-(m.clone() * l.clone()), "(-(arm.m * arm.l))", "-m l"),
            (
                m.clone() * (l.clone() - two()),
                "(arm.m * (arm.l + (-2.0)))",
                "m (l - 2)",
            ),
            (
                l - half(Value::Pi) * m,
                "(arm.l + (-(1.5707963267948966 * arm.m)))",
                "l - \u{3c0} / 2 m",
            ),
        ];
        for (value, of_machine, of_person) in cases {
            assert_eq!(code(&robot(), &value), of_machine);
            assert_eq!(text(&robot(), &value).as_deref(), Some(of_person));
        }
        assert_eq!(text(&robot(), &Value::Pi), None);
        assert_eq!(code(&robot(), &Value::field(2)), "arm.type");
    }

    #[test]
    fn a_field_has_the_unit_of_the_cells_that_it_is() {
        assert_eq!(unit(&robot(), 2), "m/s\u{b2}");
        assert_eq!(unit(&robot(), 0), "");
    }
}
