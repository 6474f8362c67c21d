//! A table that was read from a file: the same rules, at lines and columns.

use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{Convention, JointType, Value};

use crate::description::{
    Body, Entry, Expr, ExprKind, Given, Joints, Name, Operator, Place, Row, Table,
};
use crate::{Error, check};

fn at(line: usize, column: usize) -> Place {
    Place::File { line, column }
}

fn number(value: i64, place: Place) -> Expr {
    Expr {
        kind: ExprKind::Value(Value::Rational(Rational::from(value))),
        place,
    }
}

/// A pendulum of that mass, the product of two numbers, with a field that nothing uses.
fn pendulum(factors: [i64; 2]) -> Table {
    let [a, b] = factors.map(|factor| Box::new(number(factor, at(7, 8))));
    let row = Row {
        name: Some(Name::new("pivot", at(5, 8))),
        joint_type: Some(JointType::Revolute),
        a: Given::As(number(1, at(6, 5))),
        body: Body {
            mass: Given::As(Expr {
                kind: ExprKind::Binary(Operator::Mul, a, b),
                place: at(7, 8),
            }),
            ..Body::default()
        },
        ..Row::default()
    };
    let joints = Joints {
        rows: vec![row],
        complete: true,
    };
    let gravity = [0, -9, 0].map(|g| Some(number(g, at(2, 12))));
    Table {
        name: Some(Name::new("Pendulum", at(1, 1))),
        has_all_fields: true,
        entries: vec![
            Entry::Convention(Some(Convention::Standard)),
            Entry::Gravity(Some(gravity)),
            Entry::Joints(at(4, 1), Some(joints)),
        ],
        ..Table::default()
    }
}

#[test]
fn a_table_from_a_file_is_a_model() {
    let model = check(&pendulum([2, 3])).expect("a model");
    assert_eq!(model.robot.name, "Pendulum");
    assert_eq!(model.robot.rows[0].mass, Value::integer(6));
}

#[test]
fn its_errors_stand_at_lines_and_columns() {
    let mut table = pendulum([2, -3]);
    table.fields.push(Name::new("length", at(3, 9)));
    table.entries.push(Entry::Tests(at(9, 1), None));
    let errors = check(&table).expect_err("two mistakes");
    let shown = |error: &Error| match error.place {
        Place::File { line, column } => format!("{line}:{column}: {}", error.message),
        Place::Tokens { .. } => error.message.clone(),
    };
    assert_eq!(
        errors.iter().map(shown).collect::<Vec<_>>(),
        [
            "3:9: the field `length` is never used",
            "7:8: a mass cannot be negative"
        ]
    );
}
