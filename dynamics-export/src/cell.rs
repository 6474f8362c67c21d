//! Cells of a table as a person writes them.

use dynamics_symbolic::function::plain;
use dynamics_symbolic::robot::{Robot, Value};

/// How tightly an operation binds.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Binding {
    Sum,
    Product,
    Factor,
}

/// A cell as a person writes it, where fields are in it: `l / 2`, `-m g`.
pub fn text(robot: &Robot, value: &Value) -> Option<String> {
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
    if binding < around {
        format!("({text})")
    } else {
        text
    }
}
