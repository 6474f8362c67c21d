//! Tables that are trees, with frames, in all languages.

use dynamics_symbolic::robot::{Carrier, Placement, Value};

use super::*;
use crate::files::{Format, Request, table};

/// The torso of a call, in which every new cell holds a field or a `let`.
const TORSO: &str = "
    struct Torso { load: f64, width: f64 }
    convention: modified, gravity: [0, 0, -9.81],
    let reach = 0.3;
    frames: {
        left_hand: { on: left_elbow, xyz: [reach, 0, 0], mass: load, com: [0, 0, 0.05], inertia: sphere(0.04) },
        \"the camera\": { on: waist, xyz: [0.1, 0, width], rpy: [0, 0.3, 0], mass: 1 },
        corner: { on: base, mass: 2 },
    },
    joints: [
        waist: revolute { mass: 9 },
        left_shoulder: revolute { on: waist, gamma: PI/2, b: width, a: 0.2, alpha: PI/2, mass: 2 },
        left_elbow: revolute { a: reach, mass: 1 },
        right_shoulder: revolute { on: waist, b: width, mass: 2 },
        lift: prismatic { on: base, at: { xyz: [width, 0, 0], rpy: [0, 0, PI/2] }, mass: 3 },
    ],
";

const TORSO_IN_TOML: &str = r#"
convention = "modified"
gravity = [0, 0, -9.81]
[let]
reach = 0.3
[frame.left_hand]
on = "left_elbow"
xyz = ["reach", 0, 0]
mass = "load"
com = [0, 0, 0.05]
inertia = "sphere(0.04)"
[frame."the camera"]
on = "waist"
xyz = [0.1, 0, "width"]
rpy = [0, 0.3, 0]
mass = 1
[frame.corner]
on = "base"
mass = 2
[[joint]]
name = "waist"
type = "revolute"
mass = 9
[[joint]]
name = "left_shoulder"
type = "revolute"
on = "waist"
gamma = "PI/2"
b = "width"
a = 0.2
alpha = "PI/2"
mass = 2
[[joint]]
name = "left_elbow"
type = "revolute"
a = "reach"
mass = 1
[[joint]]
name = "right_shoulder"
type = "revolute"
on = "waist"
b = "width"
mass = 2
[[joint]]
name = "lift"
type = "prismatic"
on = "base"
at = { xyz = ["width", 0, 0], rpy = [0, 0, "PI/2"] }
mass = 3
"#;

const TORSO_IN_JSON: &str = r#"{
"convention": "modified", "gravity": [0, 0, -9.81], "let": { "reach": 0.3 },
"frames": {
  "left_hand": { "on": "left_elbow", "xyz": ["reach", 0, 0], "mass": "load", "com": [0, 0, 0.05], "inertia": "sphere(0.04)" },
  "the camera": { "on": "waist", "xyz": [0.1, 0, "width"], "rpy": [0, 0.3, 0], "mass": 1 },
  "corner": { "on": "base", "mass": 2, "inertia": [0, 0, 0, 0, 0, 0] }
},
"joints": [
  { "name": "waist", "type": "revolute", "mass": 9 },
  { "name": "left_shoulder", "type": "revolute", "on": "waist", "gamma": "PI/2", "b": "width", "a": 0.2, "alpha": "PI/2", "mass": 2 },
  { "name": "left_elbow", "type": "revolute", "a": "reach", "mass": 1 },
  { "name": "right_shoulder", "type": "revolute", "on": "waist", "b": "width", "mass": 2 },
  { "name": "lift", "type": "prismatic", "on": "base", "at": { "xyz": ["width", 0, 0], "rpy": [0, 0, "PI/2"] }, "mass": 3 }
]}"#;

/// The model of a file with the fields of the torso.
fn model_of_file(text: &str, format: Format) -> Model {
    let mut table = table("Torso", text, format, &Request::default())
        .unwrap_or_else(|errors| panic!("{errors:#?}"));
    let place = crate::description::Place::File { line: 1, column: 1 };
    table.fields = ["load", "width"]
        .map(|field| crate::description::Name::new(field, place))
        .to_vec();
    crate::check(&table).unwrap_or_else(|errors| panic!("{errors:#?}"))
}

#[test]
fn a_tree_says_the_same_in_all_languages() {
    let robot = model(TORSO).robot;
    let zero = Value::zero;
    let half = Value::Pi.checked_div(Value::integer(2)).unwrap();
    let on: Vec<_> = robot.rows.iter().map(|row| row.on).collect();
    let (row, base) = (Carrier::Row, Carrier::Base);
    assert_eq!(on, [Carrier::Above, row(0), Carrier::Above, row(0), base]);
    let width = || Value::field(1);
    let at = |x, z, yaw| Placement {
        xyz: [x, zero(), z],
        rpy: [zero(), zero(), yaw],
    };
    assert_eq!(robot.rows[1].at, [at(zero(), width(), half.clone())]);
    assert_eq!(robot.rows[3].at, [at(zero(), width(), zero())]);
    assert_eq!(robot.rows[4].at, [at(width(), zero(), half)]);
    assert!(robot.rows[0].at.is_empty() && robot.rows[2].at.is_empty());
    let frames: Vec<_> = robot
        .frames
        .iter()
        .map(|frame| (frame.name.as_str(), frame.on))
        .collect();
    assert_eq!(
        frames,
        [
            ("left_hand", Some(2)),
            ("the camera", Some(0)),
            ("corner", None)
        ]
    );
    let hand = robot.frames[0].body.as_ref().expect("a body");
    assert_eq!(hand.mass, Value::field(0));
    assert_eq!(robot.parent(3), Some(0));

    for other in [
        model_of_file(TORSO_IN_TOML, Format::Toml),
        model_of_file(TORSO_IN_JSON, Format::Json),
    ] {
        assert_eq!(other.robot.rows, robot.rows);
        assert_eq!(other.robot.frames, robot.frames);
    }
}
