//! Tables that name the URDF file of their robot, with entries beside it.

use super::calls::{assert_has, errors, file, output, refused};

const PICKER: &str = r#"file = "picker.urdf"
chain = ["base_link", "tool0"]
lock = { finger = 0.02 }
gravity = [0, 0, -9.81]
functions = ["gravity_vector", "friction_vector"]

[joints.waist]
friction = { viscous = 0.75 }
"#;

const ROBOT: &str = include_str!("../../../examples/robots/picker.urdf");

/// A table with the name of a file, beside a robot of its own.
fn table(name: &str, text: &str) -> String {
    let robot = format!("of_{name}.urdf");
    file(&robot, ROBOT);
    file(name, text.replace("picker.urdf", &robot))
}

/// The lines of a text but for the first, which has the name of the robot.
fn behind_name(text: &str) -> &str {
    text.split_once('\n').expect("lines").1
}

#[test]
fn entries_stand_beside_the_file_that_is_named() {
    let toml = table("project.toml", PICKER);
    let shown = output(format!("show {toml}"));
    assert!(shown.starts_with("project: 4 joints that move, as the URDF file places them"));
    assert!(shown.contains("viscous [0.75]"), "{shown}");
    let json = r#"{"file": "picker.urdf", "chain": ["base_link", "tool0"], "lock": {"finger": 0.02},
        "gravity": [0, 0, -9.81], "functions": ["gravity_vector"], "round_angles": 1e-4}"#;
    let json = table("project.json", json);
    let urdf = file("beside_project.urdf", ROBOT);
    let options = "--chain base_link,tool0 --lock finger=0.02 --gravity 0,0,-9.81 --functions gravity_vector --round-angles 1e-4";
    let by_options = format!("show {urdf} {options}");
    assert_eq!(
        behind_name(&output(format!("show {json}"))),
        behind_name(&output(&by_options))
    );
}

/// Names in cells beside the file that is named are fields, as in any table. A word in an option is a slip.
#[test]
fn names_beside_the_file_that_is_named_are_fields() {
    let carrying = PICKER.replace("chain =", "tool = { mass = \"load\" }\nchain =");
    let toml = table("carrying.toml", &carrying);
    let shown = output(format!("show {toml}"));
    assert!(shown.contains("fields: load\n"), "{shown}");
    refused(format!("simulate {toml}"), 1, ["--field load=2"]);
    output(format!("check {toml} --field load=2 --samples 1"));
    let closed = table("closed.toml", &format!("fields = []\n{carrying}"));
    refused(format!("show {closed}"), 1, ["unknown name `load`"]);
    let urdf = file("slip.urdf", ROBOT);
    let slip = "--gravity 0,0,-9.81 --lock finger=open --functions gravity_vector";
    refused(format!("show {urdf} {slip}"), 2, ["open"]);
}

/// Options take the place of entries, or add to them, as beside a table.
#[test]
fn options_stand_beside_the_entries() {
    let toml = table("options.toml", PICKER);
    let shown = output(format!(
        "show {toml} --gravity 0,0,-1.62 --lock wrist=0.5 --functions gravity_vector"
    ));
    assert!(shown.starts_with("options: 3 joints that move"), "{shown}");
    assert!(shown.contains("gravity [0, 0, -1.62]"), "{shown}");
    let whole = output(format!(
        "show {toml} --chain base_link --functions gravity_vector"
    ));
    assert!(whole.contains("finger    prismatic"), "{whole}");
    let converted = output(format!("convert {toml}"));
    assert_has(&converted, ["[[joint]]", "viscous = 0.75"]);
}

#[test]
fn mistakes_have_their_places_in_three_sources() {
    let told = |name: &str, from: &str, to: &str| {
        let text = PICKER.replace(from, to);
        assert_ne!(text, PICKER);
        errors(&["show", &table(name, &text)], 1)
    };
    for (from, to, place, message) in [
        (
            "picker.urdf",
            "piker.urdf",
            ":1:8: ",
            "`piker.urdf` cannot be read",
        ),
        ("picker.urdf", "picker.toml", ":1:8: ", "is no URDF file"),
        ("file", "fiel", ":1:1: ", "did you mean `file`"),
        (
            "\"picker.urdf\"",
            "3",
            ":1:8: ",
            "from the folder of this one",
        ),
        ("gravity = [0, 0, -9.81]", "", ":1:8: ", "missing `gravity`"),
        ("tool0", "tool", ":2:", "did you mean `tool0`"),
        ("joints.waist", "joints.wais", ":7:", "did you mean `waist`"),
        ("viscous", "viscos", ":8:", "did you mean `viscous`"),
        (
            "gravity = [0, 0, -9.81]",
            "convention = 'modified'",
            ":4:1: ",
            "remove `convention`",
        ),
        (
            "functions",
            "function",
            ":5:1: ",
            "did you mean `functions`",
        ),
    ] {
        let found = told("mistaken.toml", from, to);
        assert_has(&found, [&format!("mistaken.toml{place}")]);
        assert!(found.contains(message), "{to}: {found}");
    }
    file(
        "broken.urdf",
        ROBOT.replace("mass value=\"2\"", "mass value=\"two\""),
    );
    let found = told("of_broken.toml", "picker.urdf", "broken.urdf");
    let line = ROBOT
        .lines()
        .position(|line| line.contains("mass value=\"2\""))
        .expect("a mass")
        + 1;
    assert!(found.contains(&format!("broken.urdf:{line}:")), "{found}");
    refused(
        &["show", &table("fine.toml", PICKER), "--lock", "wist=0"],
        2,
        ["--lock wist=0", "`waist`"],
    );
}
