//! Robots and reference values from the JSON files of `tests/data` of the workspace.

use dynamics_runtime::table::{Convention, JointType, Row, Table};
use nalgebra::{SMatrix, SVector};
use serde_json::Value;

/// The file's content.
pub fn load(path: &str) -> Value {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/data/");
    let text = std::fs::read_to_string(format!("{folder}{path}.json")).expect(path);
    serde_json::from_str(&text).expect(path)
}

/// A number, written as such or as a string of more digits than a number keeps.
pub fn number(value: &Value) -> f64 {
    match value {
        Value::String(digits) => digits.parse().expect(digits),
        value => value.as_f64().expect("a number"),
    }
}

/// The numbers of an array of known length.
pub fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    std::array::from_fn(|i| number(&value[i]))
}

/// A column vector.
pub fn vector<const N: usize>(value: &Value) -> SVector<f64, N> {
    SVector::from(numbers(value))
}

/// A matrix stored row by row.
pub fn matrix<const R: usize, const C: usize>(value: &Value) -> SMatrix<f64, R, C> {
    SMatrix::from_fn(|i, j| number(&value[i][j]))
}

/// The table of `robots/NAME.json`.
pub fn table<const N: usize>(name: &str) -> Table<N> {
    let robot = load(&format!("robots/{name}"));
    Table::new(
        match robot["convention"].as_str() {
            Some("standard") => Convention::Standard,
            Some("modified") => Convention::Modified,
            other => panic!("convention {other:?}"),
        },
        numbers(&robot["gravity"]),
        std::array::from_fn(|i| row(&robot["joints"][i])),
    )
}

fn row(joint: &Value) -> Row {
    let cell = |name: &str| number(&joint[name]);
    Row {
        joint_type: match joint["type"].as_str() {
            Some("revolute") => JointType::Revolute,
            Some("prismatic") => JointType::Prismatic,
            other => panic!("joint type {other:?}"),
        },
        a: cell("a"),
        alpha: cell("alpha"),
        d: cell("d"),
        theta: cell("theta"),
        mass: cell("mass"),
        com: numbers(&joint["com"]),
        inertia: numbers(&joint["inertia"]),
        motor_inertia: cell("motor_inertia"),
        gear_ratio: cell("gear_ratio"),
        viscous: cell("viscous"),
        coulomb: [cell("coulomb"); 2],
        ..Row::new(JointType::Revolute)
    }
}
