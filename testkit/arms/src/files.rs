//! Robots from data files.

use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{
    Base, Body, Convention, JointType, Placement, Robot, Row, Tool, Value,
};
use serde_json::Value as Json;

/// The robots that have a data file and reference values.
pub const NAMES: [&str; 26] = [
    "aristo",
    "cylindrical_rpp",
    "elbow_3r",
    "gantry_ppp",
    "geared_link",
    "generic_chain_n1",
    "generic_chain_n10",
    "generic_chain_n12",
    "generic_chain_n2",
    "generic_chain_n3",
    "generic_chain_n4",
    "generic_chain_n6",
    "generic_chain_n7",
    "generic_mixed_n6_standard",
    "moving_mass",
    "one_link",
    "panda",
    "puma560",
    "rrr_planar",
    "scara",
    "spherical_wrist",
    "stanford",
    "two_link_craig",
    "two_link_saha",
    "ur5",
    "vertical_mass",
];

/// A robot on a base that is placed in the world, with a tool: a data file without reference values.
pub const MOUNTED: &str = "tilting_cell";

/// The exact decimal that the shortest representation of a double spells.
///
/// # Panics
///
/// Where the double is not finite.
pub fn decimal(x: f64) -> Value {
    let text = format!("{x:e}");
    let (digits, exponent) = text.split_once('e').unwrap();
    let point = digits.find('.').map_or(0, |at| digits.len() - at - 1) as i32;
    let integer: i64 = digits.replace('.', "").parse().unwrap();
    let power = exponent.parse::<i32>().unwrap() - point;
    let ten = Rational::from(10).pow(power as isize);
    Value::Rational(Rational::from(integer) * ten)
}

/// Reads a robot.
///
/// # Panics
///
/// Where there is no file of that name, or something else in it.
pub fn robot(name: &str) -> Robot {
    let path = format!(
        "{}/../../tests/data/robots/{name}.json",
        env!("CARGO_MANIFEST_DIR")
    );
    let json: Json = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let cell = |row: &Json, key: &str| decimal(row[key].as_f64().unwrap());
    let placement = |frame: &Json| Placement {
        xyz: cells(&frame["xyz"]),
        rpy: cells(&frame["rpy"]),
    };
    let rows = json["joints"]
        .as_array()
        .unwrap()
        .iter()
        .enumerate()
        .map(|(i, row)| Row {
            a: cell(row, "a"),
            alpha: cell(row, "alpha"),
            d: cell(row, "d"),
            theta: cell(row, "theta"),
            mass: cell(row, "mass"),
            com: cells(&row["com"]),
            inertia: cells(&row["inertia"]),
            motor_inertia: cell(row, "motor_inertia"),
            // A motor without inertia is none.
            gear_ratio: match row["motor_inertia"].as_f64() {
                Some(0.0) => Value::zero(),
                _ => cell(row, "gear_ratio"),
            },
            viscous: cell(row, "viscous"),
            coulomb: [(); 2].map(|()| cell(row, "coulomb")),
            ..Row::new(format!("joint{}", i + 1), joint_type(row))
        });
    Robot {
        name: name.to_owned(),
        fields: Vec::new(),
        convention: match json["convention"].as_str().unwrap() {
            "standard" => Convention::Standard,
            _ => Convention::Modified,
        },
        gravity: cells(&json["gravity"]),
        rows: rows.collect(),
        frames: Vec::new(),
        neglected: None,
        bounds: Default::default(),
        base: json.get("base").map(placement).map(Base::Standing),
        tool: json.get("tool").map(|tool| Tool {
            placement: placement(tool),
            body: Body {
                mass: cell(tool, "mass"),
                com: cells(&tool["com"]),
                inertia: cells(&tool["inertia"]),
            },
        }),
    }
}

fn joint_type(row: &Json) -> JointType {
    match row["type"].as_str().unwrap() {
        "revolute" => JointType::Revolute,
        _ => JointType::Prismatic,
    }
}

/// A list of numbers.
fn cells<const N: usize>(list: &Json) -> [Value; N] {
    std::array::from_fn(|k| decimal(list[k].as_f64().unwrap()))
}

/// The arm with a field in each cell that says something about inertia.
pub fn with_inertial_fields(name: &str) -> Robot {
    let mut robot = robot(name);
    let mut fields = 0;
    let mut field = || {
        fields += 1;
        Value::field(fields - 1)
    };
    for row in &mut robot.rows {
        row.mass = field();
        row.com = [(); 3].map(|()| field());
        row.inertia = [(); 6].map(|()| field());
        if row.has_motor() {
            row.motor_inertia = field();
        }
    }
    robot.fields = (0..fields).map(|i| format!("p{i}")).collect();
    robot
}
