//! Cells of the table as JavaScript, as text, and with the units of their fields.

use dynamics_symbolic::robot::{Robot, Value};

use super::literal::number;

/// A field's name without the `r#` of a raw identifier.
fn plain(field: &str) -> &str {
    field.strip_prefix("r#").unwrap_or(field)
}

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

/// How tightly an operation binds.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Binding {
    Sum,
    Product,
    Factor,
}

/// A cell as a person writes it, where fields are in it: `l / 2`, `-m g`.
pub(super) fn text(robot: &Robot, value: &Value) -> Option<String> {
    (!value.is_number()).then(|| written(robot, value, Binding::Sum))
}

fn written(robot: &Robot, value: &Value, around: Binding) -> String {
    let of = |value: &Value, around| written(robot, value, around);
    let (binding, text) = match value {
        Value::Field(i) => (Binding::Factor, plain(&robot.fields[*i]).to_owned()),
        Value::Pi => (Binding::Factor, "\u{3c0}".to_owned()),
        Value::Rational(_) => {
            let x = value.to_f64(&[]);
            let binding = if x < 0.0 {
                Binding::Sum
            } else {
                Binding::Factor
            };
            (binding, x.to_string())
        }
        Value::Neg(a) => (Binding::Sum, format!("-{}", of(a, Binding::Product))),
        Value::Add(a, b) => {
            let (a, b) = (of(a, Binding::Sum), of(b, Binding::Sum));
            let text = match b.strip_prefix('-') {
                Some(opposite) => format!("{a} - {opposite}"),
                None => format!("{a} + {b}"),
            };
            (Binding::Sum, text)
        }
        Value::Mul(a, b) => {
            let text = format!("{} {}", of(a, Binding::Product), of(b, Binding::Product));
            (Binding::Product, text)
        }
        Value::Div(a, b) => {
            let text = format!("{} / {}", of(a, Binding::Product), of(b, Binding::Factor));
            (Binding::Product, text)
        }
    };
    match binding < around {
        true => format!("({text})"),
        false => text,
    }
}

/// The unit of a field: that of the cells which are the field times a number, where they are all of one.
pub(super) fn unit(robot: &Robot, field: usize) -> &'static str {
    let mut units = Vec::new();
    visit(robot, &mut |value, unit| {
        if is_multiple_of(value, field) && !units.contains(&unit) {
            units.push(unit);
        }
    });
    match units.as_slice() {
        [unit] => unit,
        _ => "",
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

/// The cells of the table whose unit does not depend on what else stands there, with it.
fn visit(robot: &Robot, visit: &mut impl FnMut(&Value, &'static str)) {
    robot
        .gravity
        .iter()
        .for_each(|value| visit(value, "m/s\u{b2}"));
    for row in &robot.rows {
        [&row.a, &row.d]
            .into_iter()
            .chain(&row.com)
            .for_each(|value| visit(value, "m"));
        [&row.alpha, &row.theta]
            .into_iter()
            .for_each(|value| visit(value, "rad"));
        row.inertia
            .iter()
            .chain([&row.motor_inertia])
            .for_each(|value| visit(value, "kg m\u{b2}"));
        visit(&row.mass, "kg");
    }
    let tool = robot.tool.as_ref();
    for placement in robot.base.iter().chain(tool.map(|tool| &tool.placement)) {
        placement.xyz.iter().for_each(|value| visit(value, "m"));
        placement.rpy.iter().for_each(|value| visit(value, "rad"));
    }
    if let Some(tool) = tool {
        visit(&tool.mass, "kg");
        tool.com.iter().for_each(|value| visit(value, "m"));
        tool.inertia
            .iter()
            .for_each(|value| visit(value, "kg m\u{b2}"));
    }
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
            neglected: None,
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
