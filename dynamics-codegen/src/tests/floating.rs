//! Robots on a base that moves, in all languages.

use std::path::Path;

use dynamics_symbolic::robot::{Body, Robot, Value};

use super::*;
use crate::description::Table;
use crate::files::{Format, Request, model_beside, table};
use crate::tree::Language;

const LEGS: &str = "
    [[joint]]
    name = 'left'
    type = 'revolute'
    mass = 2
    com = [0.1, 0, 0]
    inertia = 'sphere(0.1)'
    [[joint]]
    name = 'right'
    type = 'revolute'
    on = 'base'
    at = { xyz = [0.3, 0, 0] }
    mass = 2
    com = [0.1, 0, 0]
    inertia = 'sphere(0.1)'
";

const LEGS_IN_JSON: &str = r#"
    { "name": "left", "type": "revolute", "mass": 2, "com": [0.1, 0, 0], "inertia": "sphere(0.1)" },
    { "name": "right", "type": "revolute", "on": "base", "at": { "xyz": [0.3, 0, 0] }, "mass": 2, "com": [0.1, 0, 0],
      "inertia": "sphere(0.1)" }
"#;

/// A call with that base.
fn call(base: &str, rest: &str) -> String {
    format!(
        "struct Legs {{ load: f64 }} convention: modified, gravity: [0, 0, -9.81], base: {base}, joints: [
            left: revolute {{ mass: 2, com: [0.1, 0, 0], inertia: sphere(0.1) }},
            right: revolute {{ on: base, at: {{ xyz: [0.3, 0, 0] }}, mass: 2, com: [0.1, 0, 0], inertia: sphere(0.1) }},
        ], {rest}"
    )
}

fn in_toml(base: &str) -> String {
    format!("convention = 'modified'\ngravity = [0, 0, -9.81]\n{base}\n{LEGS}")
}

fn in_json(base: &str) -> String {
    format!(
        "{{ \"convention\": \"modified\", \"gravity\": [0, 0, -9.81], \"base\": {base}, \"joints\": [{LEGS_IN_JSON}] }}"
    )
}

/// The robot of a text with the entries of a call beside it.
pub(super) fn robot_of(text: &str, format: Format, beside: &str) -> Robot {
    let has_field = text.contains("load") || beside.contains("load");
    let table = entries(if has_field { "load: f64" } else { "" }, beside);
    let model = model_beside("Legs", text, format, table);
    model.unwrap_or_else(|errors| panic!("{errors:#?}")).robot
}

/// The entries of a call with these fields.
pub(super) fn entries(fields: &str, text: &str) -> Table {
    let diagnostics = Diagnostics::new();
    let tokens = format!("struct Legs {{ {fields} }} {text}").parse();
    let (mut call, root) = crate::parse::call(tokens.expect("tokens"), &diagnostics);
    let read = crate::read::table(&root.expect("a tree"), Language::Call, &diagnostics);
    assert!(diagnostics.is_empty());
    (call.table.entries, call.table.keys) = (read.entries, read.keys);
    call.table
}

fn assert_same(one: &Robot, other: &Robot) {
    let [one, other] = [one, other].map(|robot| (&robot.base, &robot.rows, &robot.gravity));
    assert_eq!(one, other);
}

/// A file with a tree, or the values of one.
pub(super) fn file(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data/urdf/trees");
    std::fs::read_to_string(folder.join(name)).expect("a file of the repository")
}

#[test]
fn a_base_that_moves_says_the_same_in_all_languages() {
    let cells = "mass: load, com: [0, 0, 0.1], inertia: cuboid(0.4, 0.2, 0.1)";
    let robot = model(&call(&format!("floating {{ {cells} }}"), "")).robot;
    let body = robot.floating().expect("a base that moves");
    assert_eq!(body.mass, Value::field(0));
    assert_eq!((robot.dof(), robot.joints().count()), (8, 2));
    let cells =
        "mass = 'load', com = [0, 0, 0.1], inertia = 'cuboid(0.4, 0.2, 0.1)', floating = true";
    for base in [format!("base = {{ {cells} }}"), cells_of_table(cells)] {
        assert_same(&robot_of(&in_toml(&base), Format::Toml, ""), &robot);
    }
    let cells = r#"{ "floating": true, "mass": "load", "com": [0, 0, 0.1], "inertia": "cuboid(0.4, 0.2, 0.1)" }"#;
    assert_same(&robot_of(&in_json(cells), Format::Json, ""), &robot);
    // In JSON a tensor may be a list.
    let robot = model(&call(
        "floating { mass: load, inertia: { xx: 1, yz: 0.1 } }",
        "allow: [unphysical_inertia]",
    ))
    .robot;
    let cells = r#"{ "floating": true, "mass": "load", "inertia": [1, 0, 0, 0, 0.1, 0], "allow": ["unphysical_inertia"] }"#;
    assert_same(&robot_of(&in_json(cells), Format::Json, ""), &robot);
}

/// The same cells in a table of their own.
fn cells_of_table(cells: &str) -> String {
    let cells = cells
        .replace(", com", "\ncom")
        .replace(", inertia", "\ninertia");
    format!("[base]\n{}", cells.replace(", floating", "\nfloating"))
}

/// Beside a file the base is said as in a call. A word alone leaves the body of the file as it is.
#[test]
fn a_base_that_moves_stands_beside_a_file() {
    let robot = model(&call("floating { mass: load, inertia: sphere(0.2) }", "")).robot;
    let beside = "base: floating { mass: load, inertia: sphere(0.2) },";
    assert_same(&robot_of(&in_toml(""), Format::Toml, beside), &robot);
    let base = "base = { floating = true, mass = 'load', inertia = 'sphere(0.2)' }";
    let alone = "base: floating,";
    assert_same(&robot_of(&in_toml(base), Format::Toml, alone), &robot);
    let other = "base = { xyz = [0, 0, 1] }";
    assert_same(&robot_of(&in_toml(other), Format::Toml, beside), &robot);
}

#[test]
fn a_tensor_about_the_origin_is_moved() {
    let tensor = "{ xx: 2, yy: 4, zz: 5 }";
    let base = format!("floating {{ mass: 3, com: [1, 0, 0], inertia_at_origin: {tensor} }}");
    let robot = model(&call(&base, "").replace("load: f64", "")).robot;
    let body = robot.floating().expect("a base that moves");
    let expected = [2, 1, 2, 0, 0, 0].map(Value::integer);
    assert_eq!(body.inertia, expected);
}

/// A rigid body that flies alone has no joints, and no convention either.
#[test]
fn a_body_may_fly_alone() {
    let body = |rest: &str| {
        let base = "floating { mass: 3, inertia: { xx: 1, yy: 2, zz: 2 } }";
        format!("struct Stone; gravity: [0, 0, -9.81], base: {base}, joints: [], {rest}")
    };
    let robot = model(&body("")).robot;
    assert_eq!((robot.dof(), robot.rows.len()), (6, 0));
    assert_eq!(model(&body("convention: standard,")).robot.rows.len(), 0);
    let text = "gravity = [0, 0, -9.81]\nbase = { floating = true, mass = 3, inertia = { xx = 1, yy = 2, zz = 2 } }";
    let of_file = model_beside("Stone", text, Format::Toml, Table::default());
    assert_same(&of_file.expect("a body").robot, &robot);
    let urdf = r#"<robot name="stone"><link name="stone"><inertial><mass value="3"/>
        <inertia ixx="1" iyy="2" izz="2" ixy="0" iyz="0" ixz="0"/></inertial></link></robot>"#;
    let beside = "base: floating, gravity: [0, 0, -9.81],";
    assert_same(&robot_of(urdf, Format::Urdf, beside), &robot);
    let at_frame =
        body("frames: { eye: { on: base, xyz: [0.1, 0, 0] } }, functions: [jacobian(eye)],");
    assert_eq!(model(&at_frame).robot.frames.len(), 1);
}

/// The names that others have stay free.
#[test]
fn fields_and_functions_may_be_named_base() {
    let source = call(
        "floating { mass: base, inertia: sphere(0.1) }",
        "functions: [base = (mass_matrix, jacobian(foot))], frames: { foot: { on: right, xyz: [0.2, 0, 0] } },",
    );
    let errors = messages(&source.replace("load: f64", "base: f64"));
    assert_eq!(errors, ["there is a field `base` already"]);
    let robot = model(
        &source
            .replace("load: f64", "floating: f64")
            .replace("mass: base", "mass: floating"),
    );
    assert_eq!(robot.requests.len(), 1);
}

/// M is singular at every position exactly if some motion of the base costs nothing.
#[test]
fn singular_bases_are_found() {
    let alone = |base: &str, rest: &str| {
        format!(
            "struct Legs; convention: modified, gravity: [0, 0, -9.81], base: floating {base}, {rest}"
        )
    };
    let link = "mass: 1, com: [0.1, 0, 0], inertia: sphere(0.1)";
    let one = format!("joints: [one: revolute {{ {link} }}],");
    let two = format!(
        "joints: [one: revolute {{ {link} }}, two: revolute {{ on: base, at: {{ rpy: [1, 0, 0] }}, {link} }}],"
    );
    let driven = format!(
        "joints: [one: revolute {{ {link}, motor: {{ inertia: 1e-4, gear_ratio: 100 }} }}],"
    );
    for (base, rest, is_singular) in [
        ("", "joints: [],", true),
        ("{ mass: 3 }", "joints: [],", true),
        ("{ mass: 3, inertia: rod(0.2) }", "joints: [],", true),
        ("{ mass: 3, inertia: sphere(0.2) }", "joints: [],", false),
        // The base turns with the joint, and the link stands still.
        ("", &one, true),
        ("{ mass: 3 }", &one, true),
        ("{ mass: 3, com: [0.1, 0, 0] }", &one, false),
        ("{ mass: 3, inertia: rod(0.2) }", &one, false),
        ("", &driven, false),
        ("", &two, false),
        // Bodies that are fixed to the base are a part of it.
        (
            "{ mass: 3 }",
            "joints: [], frames: { part: { on: base, mass: 1, com: [1, 0, 0], inertia: sphere(0.1) } },",
            false,
        ),
        (
            "{ mass: 3 }",
            "joints: [], frames: { part: { on: base, mass: 1, com: [1, 0, 0] } },",
            true,
        ),
        // Nobody requests M.
        (
            "",
            "joints: [], frames: { eye: { on: base } }, functions: [jacobian(eye)],",
            false,
        ),
        ("{ allow: [odd_mass] }", "joints: [],", false),
    ] {
        let found = messages_of(&alone(base, rest));
        let is_found = found
            .iter()
            .any(|message| message.contains("M is singular at every position"));
        assert_eq!(
            (is_found, found.len()),
            (is_singular, usize::from(is_singular)),
            "{base} {rest} {found:?}"
        );
    }
}

fn messages_of(source: &str) -> Vec<String> {
    read(source.parse().expect("tokens")).1
}

#[test]
fn the_root_of_a_file_is_the_body_of_the_base() {
    let beside = "base: floating, gravity: [0, 0, -9.81], allow: [unphysical_inertia],";
    let robot = robot_of(&file("hyq_no_sensors.urdf"), Format::Urdf, beside);
    assert_eq!((robot.dof(), robot.rows.len()), (18, 12));
    let number = |value: &Value| value.to_f64(&[]);
    let Body { mass, com, .. } = robot.floating().expect("a base that moves");
    // The trunk and what is fixed to it.
    assert_eq!(number(mass), 60.978_001);
    assert!(com.iter().map(number).all(|x| x.abs() < 0.1));
    let of_rows = robot.rows.iter().map(|row| number(&row.mass));
    let of_all: f64 = of_rows.sum::<f64>() + number(mass);
    assert!((of_all - 86.774_005).abs() < 1e-12, "{of_all}");
}

#[test]
fn a_body_beside_a_urdf_file_is_refused() {
    let text = file("hyq_no_sensors.urdf");
    for cell in [
        "mass: 3",
        "com: [0, 0, 0]",
        "inertia: sphere(0.1)",
        "inertia_at_origin: { xx: 1 }",
    ] {
        let beside = format!("base: floating {{ {cell} }}, gravity: [0, 0, -9.81],");
        let errors =
            model_beside("Legs", &text, Format::Urdf, entries("", &beside)).expect_err(cell);
        assert!(
            errors[0].message.starts_with("the first link of the file"),
            "{errors:?}"
        );
    }
    // Oddities of the first link are accepted as those of other bodies, and of no other link.
    let beside = "base: floating { allow: [unphysical_inertia] }, gravity: [0, 0, -9.81],";
    let refused = |beside: &str| {
        let model = model_beside("Legs", &text, Format::Urdf, entries("", beside));
        model.map_or_else(|errors| errors.len(), |_| 0)
    };
    assert_eq!(refused(beside), 4);
    assert_eq!(refused("base: floating, gravity: [0, 0, -9.81],"), 5);
}

/// A root without inertia is one of the links that move.
#[test]
fn a_root_without_inertia_is_reported() {
    let text = r#"<robot name="two"><link name="root"/><link name="leg"><inertial><mass value="3"/>
        <inertia ixx="1" iyy="1" izz="1" ixy="0" iyz="0" ixz="0"/></inertial></link>
        <joint name="hip" type="continuous"><parent link="root"/><child link="leg"/></joint></robot>"#;
    let beside = |rest: &str| {
        entries(
            "",
            &format!("base: floating, gravity: [0, 0, -9.81], {rest}"),
        )
    };
    let errors = model_beside("Two", text, Format::Urdf, beside("")).expect_err("no inertia");
    assert_eq!(errors.len(), 1);
    assert!(
        errors[0]
            .message
            .starts_with("the link `root` moves and has no `<inertial>`"),
        "{errors:?}"
    );
    for rest in ["allow: [no_inertia],", "functions: [jacobian],"] {
        let model = model_beside("Two", text, Format::Urdf, beside(rest));
        assert!(model.is_ok(), "{rest}");
    }
}

/// A base that moves counts as six joints; functions of three indices have room for a quadruped.
#[test]
fn the_base_counts_where_robots_are_long() {
    let legs = |count: usize, functions: &str| {
        let rows = (0..count).map(|i| format!("j{i}: revolute {{ a: 0.1, mass: 1 }}"));
        let rows = rows.collect::<Vec<_>>().join(", ");
        let base = "base: floating { mass: 3, inertia: sphere(0.1) }";
        messages_of(&format!(
            "struct Legs; convention: modified, gravity: [0, 0, -9.81], {base}, joints: [{rows}], functions: [{functions}],"
        ))
    };
    assert_eq!(legs(100, "mass_matrix"), [""; 0]);
    let cubic = "inverse_dynamics_second_derivatives";
    assert_eq!(legs(16, cubic), [""; 0]);
    let start = format!("`{cubic}` of 23 degrees of freedom has about 401,000 operations");
    assert!(legs(17, cubic)[0].starts_with(&start));
}

/// A file in the words of TOML may say it beside another one.
#[test]
fn entries_in_toml_stand_beside_a_urdf_file() {
    let text = file("anymal_erd.urdf");
    let beside = "base: floating, gravity: [0, 0, -9.81], allow: [unphysical_inertia],";
    let robot = robot_of(&text, Format::Urdf, beside);
    for base in ["'floating'", "{ floating = true }"] {
        let allow = "allow = ['unphysical_inertia']";
        let entries = format!("base = {base}\ngravity = [0, 0, -9.81]\n{allow}");
        let beside = table("Legs", &entries, Format::Toml, &Request::default());
        let model = model_beside("Legs", &text, Format::Urdf, beside.expect("entries"));
        assert_same(&model.expect("a model").robot, &robot);
    }
    let of_all = robot.rows.iter().map(|row| &row.mass);
    let of_all = of_all.chain(robot.floating().map(|body| &body.mass));
    let mass: f64 = of_all.map(|mass| mass.to_f64(&[])).sum();
    assert!((mass - 30.475_397_462).abs() < 1e-12, "{mass}");
}

/// The part of a tree that a link carries moves with this link.
#[test]
fn a_chain_begins_at_the_body_of_the_base() {
    let text = file("anymal_erd.urdf");
    let beside = "base: floating, chain: [LF_HIP, LF_FOOT], gravity: [0, 0, -9.81],";
    let robot = robot_of(&text, Format::Urdf, beside);
    assert_eq!((robot.dof(), robot.rows.len()), (8, 2));
    assert!(robot.floating().is_some_and(|body| !body.mass.is_zero()));
}

/// The struct's documentation and its table say that the base moves.
#[test]
fn the_items_say_that_the_base_moves() {
    let call = call(
        "floating { mass: load, com: [0, 0, 0.5], inertia: sphere(0.1) }",
        "",
    );
    let items = crate::outline(call.parse().expect("tokens")).to_string();
    for part in [
        "The base moves, with a body of `load` kg. Its pose in the world is the argument `base`.",
        "Table :: with_floating_base (:: dynamics_runtime :: FloatingBase { mass : self . load , com : [0f64 , 0f64 , 0.5f64]",
    ] {
        assert!(items.contains(part), "{part} {items}");
    }
}

/// All moments of a base matter: one that is left out is zero.
#[test]
fn one_moment_alone_is_no_body() {
    let one = call("floating { mass: load, inertia: { zz: 1 } }", "");
    assert!(message(&one).starts_with("no body has this inertia tensor"));
}

/// Joints of a robot whose base moves may all be locked.
#[test]
fn all_joints_may_be_locked_on_a_base_that_moves() {
    let locked = call(
        "floating { mass: load, inertia: sphere(0.1) }",
        "lock: [left = 0, right = 1],",
    );
    assert_eq!(model(&locked).robot.dof(), 6);
}
