//! Tables that are trees, with frames, in all languages.

use dynamics_symbolic::function::Part;
use dynamics_symbolic::robot::{Carrier, Placement, Value};
use dynamics_symbolic::{Function, function};

use super::*;
use crate::description::{Name, Place};
use crate::files::{Format, Request, model_beside, table};

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
let = { reach = 0.3 }
frame.left_hand = { on = "left_elbow", xyz = ["reach", 0, 0], mass = "load", com = [0, 0, 0.05], inertia = "sphere(0.04)" }
frame."the camera" = { on = "waist", xyz = [0.1, 0, "width"], rpy = [0, 0.3, 0], mass = 1 }
frame.corner = { on = "base", mass = 2 }
joint = [
    { name = "waist", type = "revolute", mass = 9 },
    { name = "left_shoulder", type = "revolute", on = "waist", gamma = "PI/2", b = "width", a = 0.2, alpha = "PI/2", mass = 2 },
    { name = "left_elbow", type = "revolute", a = "reach", mass = 1 },
    { name = "right_shoulder", type = "revolute", on = "waist", b = "width", mass = 2 },
    { name = "lift", type = "prismatic", on = "base", at = { xyz = ["width", 0, 0], rpy = [0, 0, "PI/2"] }, mass = 3 },
]
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

/// The fields of the torso.
fn fields() -> Vec<Name> {
    let place = Place::File { line: 1, column: 1 };
    ["load", "width"]
        .map(|field| Name::new(field, place))
        .to_vec()
}

/// The model of a file with these fields.
fn model_of_file(text: &str, format: Format) -> Model {
    let mut table = table("Torso", text, format, &Request::default())
        .unwrap_or_else(|errors| panic!("{errors:#?}"));
    table.fields = fields();
    crate::check(&table).unwrap_or_else(|errors| panic!("{errors:#?}"))
}

#[test]
fn a_tree_says_the_same_in_all_languages() {
    let robot = model(TORSO).robot;
    let zero = Value::zero;
    let half = Value::Pi.checked_div(Value::integer(2)).unwrap();
    let on: Vec<_> = robot.rows.iter().map(|row| row.on).collect();
    let (above, base) = (Carrier::Above, Carrier::Base);
    assert_eq!(on, [above, above, above, Carrier::Row(0), base]);
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

/// A call with those rows, of which the first is 0.5 m long, and those entries.
fn arm(rows: &str, entries: &str) -> String {
    format!(
        "struct Arm {{ x: f64 }} convention: modified, gravity: [0, 0, -9.81], joints: [
            first: revolute {{ spring: {{ stiffness: x }} }}, second: revolute {{ a: 0.5, mass: 2, com: [0.2, 0, 0] }},
            {rows}
        ], {entries}"
    )
}

/// Numbers that are hardly ever meant are reported in the new cells as in those of a serial arm.
#[test]
fn numbers_hardly_ever_meant_are_told_on_trees() {
    for (rows, frames, told) in [
        (
            "third: revolute { on: first, b: 300 }",
            "",
            "a length of 300 m",
        ),
        (
            "third: revolute { on: first, at: { xyz: [0, -400, 0] } }",
            "",
            "a length of -400 m",
        ),
        (
            "",
            "hand: { on: second, xyz: [0, 0, 120], mass: 1 }",
            "a length of 120 m",
        ),
        (
            "",
            "hand: { on: second, mass: 700 }",
            "a mass of 700 kg in an arm whose longest part is 0.5 m",
        ),
        (
            "",
            "hand: { on: second, mass: 1, com: [0, 0, 20] }",
            "a centre of mass 20 m from its frame",
        ),
        (
            "third: revolute { on: first, gamma: 90 }",
            "",
            "angles are in radians: write `deg(90)`",
        ),
        (
            "third: revolute { at: { rpy: [0, 1.57, 0] } }",
            "",
            "nearly a right angle: write `PI/2`",
        ),
    ] {
        let message = message(&arm(rows, &format!("frames: {{ {frames} }}")));
        assert!(message.starts_with(told), "{message}");
    }
    // Things on the base may be anywhere.
    model(&arm(
        "third: revolute { on: base, at: { xyz: [0, 50, 0] }, mass: 1 }",
        "frames: { corner: { on: base, xyz: [60, 0, 0], mass: 1 } }",
    ));
    model(&arm(
        "third: revolute { on: first, b: 300 }",
        "allow: [odd_length]",
    ));
}

/// A leader may stand below its follower and on another branch; a joint that follows a locked one is locked.
#[test]
fn joints_are_locked_and_coupled_across_branches() {
    let rows = "third: revolute { on: first, a: 0.2, mass: 1 }, fourth: revolute { on: second, a: 0.1, mass: 1 },";
    let robot = model(&arm(rows, "couple: [second = 2 * third + 0.1]")).robot;
    let follower = robot.rows[1].follows.as_ref().expect("a follower");
    assert_eq!((follower.leader, &follower.factor), (2, &Value::integer(2)));
    let robot = model(&arm(
        rows,
        "couple: [second = 2 * third], lock: [third = 0.25]",
    ))
    .robot;
    assert_eq!(
        robot.rows[1].locked.as_ref().map(|at| at.to_f64(&[])),
        Some(0.5)
    );
    assert_eq!(robot.dof(), 2);
}

/// A joint moves no mass if nothing does that it carries: the row behind it may stand elsewhere.
#[test]
fn joints_that_move_no_mass_are_noted_on_trees() {
    let notes = |frame: &str| {
        let call = arm(
            "third: revolute { on: first }, fourth: revolute { on: second, mass: 1 },",
            &format!("frames: {{ {frame} }}, allow: [no_inertia]"),
        );
        model(&call).notes
    };
    let bare = notes("");
    assert!(
        bare.len() == 1 && bare[0].starts_with(" No mass moves with `third`: M"),
        "{bare:?}"
    );
    assert_eq!(notes("hand: { on: third, mass: 1 }"), [""; 0]);
    assert_eq!(notes("corner: { on: base, mass: 1 }").len(), 1);
}

#[test]
fn the_documentation_says_where_joints_and_frames_stand() {
    let call = TORSO.replace("gravity:", "functions: [potential_energy], gravity:");
    let items = crate::generate(call.parse().expect("tokens")).to_string();
    for line in [
        "`left_shoulder` on the link of `waist` at xyz (0, 0, `width`) m and rpy (0, 0, 1.5707963267948966) rad",
        "`lift` on the base at xyz (`width`, 0, 0) m and rpy (0, 0, 1.5707963267948966) rad",
        "`left_hand` on the link of `left_elbow` at xyz (0.3, 0, 0) m and rpy (0, 0, 0) rad, with a body of `load` kg",
    ] {
        assert!(items.contains(line), "{line}");
    }
    assert!(!items.contains("`left_elbow` on"));
}

/// A function of a frame is requested by the frame's name, with or without quotes, and stands in tuples, too.
#[test]
fn functions_of_frames_say_the_same_in_all_languages() {
    let asked = "functions: [jacobian(left_hand), jacobian(\"the camera\"), grasp = (mass_matrix, forward_kinematics(left_hand))],";
    let of_call = model(&TORSO.replace("gravity:", &format!("{asked} gravity:"))).requests;
    let of_frame = |function, frame| Part {
        function,
        frame: Some(frame),
    };
    let parts = [
        Function::MassMatrix.into(),
        of_frame(Function::ForwardKinematics, 0),
    ];
    let expected = [
        function::Request::of_frame(Function::Jacobian, 0, "left_hand"),
        function::Request::of_frame(Function::Jacobian, 1, "the camera"),
        function::Request::fused("grasp", parts),
    ];
    let names: Vec<&str> = expected.iter().map(function::Request::name).collect();
    assert_eq!(
        names,
        ["jacobian_left_hand", "jacobian_the_camera", "grasp"]
    );
    let in_file = r#"["jacobian(left_hand)", "jacobian('the camera')", { "grasp" = ["mass_matrix", "forward_kinematics( left_hand )"] }]"#;
    let in_toml = format!("functions = {in_file}\n{TORSO_IN_TOML}");
    let in_json = format!(
        "\"functions\": {},\n\"convention\"",
        in_file.replace(" = ", ": ")
    );
    let in_json = TORSO_IN_JSON.replacen("\"convention\"", &in_json, 1);
    let of_files = [(in_toml, Format::Toml), (in_json, Format::Json)]
        .map(|(text, format)| model_of_file(&text, format).requests);
    for requests in [of_call].into_iter().chain(of_files) {
        let requests: Vec<_> = requests.into_iter().map(|(request, _)| request).collect();
        assert_eq!(requests, expected);
    }
}

/// After an error the methods of frames exist, too: no other error follows from it.
#[test]
fn stubs_have_the_methods_of_frames() {
    let call = arm(
        "third: revolute { mass: -1 }",
        "frames: { hand: { on: third } }, functions: [jacobian(hand), pair = (mass_matrix, forward_kinematics(hand))],",
    );
    assert_eq!(message(&call), "a mass cannot be negative");
    let items = crate::generate(call.parse().expect("tokens")).to_string();
    for method in ["fn jacobian_hand <", "fn pair <"] {
        assert!(items.contains(method), "{method}");
    }
}

/// The generated methods have the frame's name, in constants as in code.
#[test]
fn methods_of_frames_are_generated() {
    let call = arm(
        "",
        "frames: { \"Hand 1\": { on: second, xyz: [0.1, 0, 0] } }, functions: [jacobian(\"Hand 1\"), wrench_torques(\"Hand 1\")],",
    );
    let items = crate::generate(call.parse().expect("tokens")).to_string();
    for text in [
        "fn jacobian_hand_1 <",
        "(\"jacobian_hand_1\" ,",
        "fn wrench_torques_hand_1 <",
    ] {
        assert!(items.contains(text), "{text}");
    }
}

/// Frames beside a file add to its own, and functions beside it may be about either.
#[test]
fn frames_beside_a_file_add_to_its_own() {
    let request = Request::default();
    let beside =
        "functions = [\"jacobian(tail)\", \"jacobian(left_hand)\"]\n[frame.tail]\non = \"lift\"";
    let mut beside = table("beside", beside, Format::Toml, &request).expect("entries");
    beside.fields = fields();
    let model = model_beside("Torso", TORSO_IN_TOML, Format::Toml, beside).expect("a robot");
    let frames: Vec<_> = model
        .robot
        .frames
        .iter()
        .map(|frame| (frame.name.as_str(), frame.on))
        .collect();
    assert_eq!(frames[2..], [("corner", None), ("tail", Some(4))]);
    let asked = |function, frame, name| function::Request::of_frame(function, frame, name);
    let requests: Vec<_> = model
        .requests
        .into_iter()
        .map(|(request, _)| request)
        .collect();
    assert_eq!(
        requests,
        [
            asked(Function::Jacobian, 3, "tail"),
            asked(Function::Jacobian, 0, "left_hand")
        ]
    );
}

/// Terms to neglect are found on trees as on arms.
#[test]
fn terms_are_neglected_on_trees() {
    let call = arm(
        "third: revolute { on: first, a: 0.2, mass: 1, com: [0.1, 0, 0] }, fourth: revolute { on: second, a: 0.1, mass: 0.001, com: [0.01, 0, 0], motor: { inertia: 1e-4, gear_ratio: 100 } }",
        "neglect: 1%, functions: [mass_matrix, inverse_dynamics]",
    );
    let call = call
        .replace("{ x: f64 }", ";")
        .replace("spring: { stiffness: x }", "mass: 1");
    let items = crate::generate(call.parse().expect("tokens")).to_string();
    assert!(!items.contains("compile_error"), "{items}");
    assert!(
        items.contains("are neglected, and all functions are derived from what is left"),
        "{items}"
    );
}

/// A loop that a URDF file tells in words of other programs is told with its line, and no joint of a simulated world is one.
#[test]
fn loops_of_a_file_are_told() {
    let link = |name| {
        format!(
            "<link name=\"{name}\"><inertial><mass value=\"1\"/>\
             <inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" iyz=\"0\" ixz=\"0\"/></inertial></link>\n"
        )
    };
    let joint = |name, child| {
        format!(
            "<joint name=\"{name}\" type=\"continuous\"><parent link=\"base\"/><child link=\"{child}\"/></joint>\n"
        )
    };
    let of_gazebo = |name, parent, child| {
        format!(
            "<gazebo><joint name=\"{name}\" type=\"revolute\"><parent>{parent}</parent><child>{child}</child></joint></gazebo>\n"
        )
    };
    let text = [
        "<robot name=\"bars\">\n".to_owned(),
        link("base"),
        link("left"),
        link("right"),
        joint("a", "left"),
        joint("b", "right"),
        "<drake:loop_joint name=\"four\" type=\"continuous\"><link1 link=\"left\"/></drake:loop_joint>\n".to_owned(),
        of_gazebo("closed", "bars::left", "right"),
        of_gazebo("held", "world", "base"),
        "</robot>".to_owned(),
    ]
    .concat();
    let table = super::floating::entries("", "gravity: [0, 0, -9.81]");
    let model = crate::files::model_beside("Bars", &text, Format::Urdf, table);
    let warnings = model.unwrap_or_else(|errors| panic!("{errors:?}")).warnings;
    assert_eq!(warnings.len(), 2, "{warnings:#?}");
    for (warning, (line, start)) in warnings.iter().zip([
        (
            7,
            " Line 7 of the file closes a loop by `<loop_joint name=\"four\">`, which is left out",
        ),
        (
            8,
            " Line 8 of the file closes a loop by `<joint name=\"closed\">`, which is left out",
        ),
    ]) {
        assert!(warning.message.starts_with(start), "{warning}");
        assert_eq!((warning.rule, warning.line), ("open_loop", line));
    }
}
