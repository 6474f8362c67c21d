//! Inverse kinematics by the command.

use super::calls::{PENDULUM, errors, file, folder, output};
use super::moving_base::BRICK;

fn data(name: &str) -> String {
    format!("{}/../tests/data/{name}", env!("CARGO_MANIFEST_DIR"))
}

/// The numbers of the rows that begin with a number.
fn rows(text: &str) -> Vec<Vec<f64>> {
    let lines = text
        .lines()
        .filter(|line| line.starts_with(|c: char| c.is_ascii_digit()));
    let numbers = |line: &str| {
        line.split_whitespace()
            .skip(1)
            .map(|x| x.parse().unwrap())
            .collect()
    };
    lines.map(numbers).collect()
}

/// A maker's table of an arm, which is geometry alone.
const GEOMETRY: &str = r#"
convention = "standard"
gravity = [0, 0, -9.81]
[[joint]]
name = "pan"
type = "revolute"
d = 0.15185
alpha = "PI/2"
[[joint]]
name = "lift"
type = "revolute"
a = -0.24355
[[joint]]
name = "elbow"
type = "revolute"
a = -0.2132
[[joint]]
name = "w1"
type = "revolute"
d = 0.13105
alpha = "PI/2"
[[joint]]
name = "w2"
type = "revolute"
d = 0.08535
alpha = "-PI/2"
[[joint]]
name = "w3"
type = "revolute"
d = 0.0921
"#;

/// Commands that read no mass ask for none.
#[test]
fn tables_of_geometry_alone_are_served() {
    let table = file("geometry.toml", GEOMETRY);
    let text = output(&["reach", &table, "--pose", "-0.3,-0.2,0.3,3.14159,0,0"]);
    assert!(rows(&text).len() >= 4, "{text}");
    let modified = output(&[
        "convert",
        &table,
        "--to",
        "toml",
        "--convention",
        "modified",
    ]);
    assert!(!modified.contains("mass"), "{modified}");
    let modified = file("geometry_modified.toml", modified);
    let pose = [
        "--functions",
        "forward_kinematics",
        "--at",
        "0.1,-1,1,0.3,0.4,0.5",
    ];
    let of = |table: &str| output(&[&["evaluate", table][..], &pose].concat());
    assert_eq!(of(&modified).replace("_modified", ""), of(&table));
    let page = folder("geometry").join("page.html");
    output(&["page", &table, "--out", &page.to_string_lossy()]);
    // Functions that read masses ask for them.
    assert!(errors(&["evaluate", &table, "--at", "0,0,0,0,0,0"], 1).contains("no_inertia"));
}

/// A tensor that no body can have is a mistake where masses are read.
#[test]
fn impossible_tensors_matter_where_masses_are_read() {
    let link = |tensor: &str| {
        format!(
            r#"<robot name="r"><link name="base"/><link name="arm"><inertial><mass value="1"/>{tensor}</inertial></link>
            <link name="tip"/><joint name="j" type="revolute"><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>
            <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
            <joint name="f" type="fixed"><parent link="arm"/><child link="tip"/><origin xyz="0.5 0 0"/></joint></robot>"#
        )
    };
    let urdf = link(r#"<inertia ixx="1" iyy="1" izz="9" ixy="0" ixz="0" iyz="0"/>"#);
    let urdf = file("impossible.urdf", urdf);
    let table = "convention = 'modified'\ngravity = [0, 0, 0]\n[[joint]]\nname = 'j'\ntype = 'revolute'\nmass = 1\n\
        inertia = { xx = 1, yy = 1, zz = 9 }\n[tool]\nxyz = [0.5, 0, 0]\n";
    let table = file("impossible.toml", table);
    let tip = [
        "evaluate",
        "--at",
        "0.3",
        "--functions",
        "forward_kinematics",
    ];
    let mass = ["evaluate", "--at", "0.3", "--functions", "mass_matrix"];
    for (file, gravity) in [(&urdf, &["--gravity", "0,0,0"][..]), (&table, &[])] {
        let command = [&["reach", file], gravity, &["--pose", "0.4,0.3,0"]].concat();
        output(&command);
        let tip = output(&[&tip[..1], &[file], &tip[1..], gravity].concat());
        assert!(tip.contains("xyz [0.477"), "{tip}");
        let message = errors(&[&mass[..1], &[file], &mass[1..], gravity].concat(), 1);
        assert!(message.contains("unphysical_inertia"), "{message}");
    }
}

/// `evaluate` has the tip of each solution at the pose.
#[test]
fn all_solutions_are_listed() {
    let puma = data("robots/puma560.json");
    let text = output(&[
        "reach",
        &puma,
        "--pose",
        "0.4,0.1,0.2,0,PI/2,deg(10)",
        "--digits",
        "17",
    ]);
    assert!(
        text.contains("8 solutions, the nearest to the start first"),
        "{text}"
    );
    assert!(text.contains("joint1, rad"), "{text}");
    let found = rows(&text);
    assert_eq!(found.len(), 8);
    for q in &found {
        let q: Vec<String> = q.iter().map(f64::to_string).collect();
        let tip = output(&[
            "evaluate",
            &puma,
            "--at",
            &q.join(","),
            "--functions",
            "forward_kinematics",
        ]);
        assert!(tip.contains("xyz [0.4, 0.1, 0.2] m"), "{tip}");
    }
    // From one of them, this one is the first.
    let from: Vec<String> = found[5].iter().map(f64::to_string).collect();
    let again = output(&[
        "reach",
        &puma,
        "--pose",
        "0.4,0.1,0.2,0,PI/2,deg(10)",
        "--from",
        &from.join(","),
        "--digits",
        "17",
    ]);
    let first = &rows(&again)[0];
    assert!(
        first
            .iter()
            .zip(&found[5])
            .all(|(a, b)| (a - b).abs() < 1e-8),
        "{again}"
    );
    // The word that other programs have does the same.
    let named = output(&["inverse-kinematics", &puma, "--pose", "0.4,0.1,0.2"]);
    assert!(
        named.contains("8 of infinitely many solutions") && named.contains("are free: 3"),
        "{named}"
    );
}

#[test]
fn frames_of_trees_are_reached() {
    let torso: &str = &data("files/torso.toml");
    let at = ["reach", torso, "--field", "load=1", "--pose", "0.1,0.5,0.3"];
    let call = |more: &[&'static str]| [&at, more].concat();
    let message = errors(&call(&[]), 2);
    assert!(
        message.contains("the robot has no tip") && message.contains("`left_hand`"),
        "{message}"
    );
    let message = errors(&call(&["--frame", "foot"]), 2);
    assert!(
        message.contains("`--frame foot` is no frame: expected one of `left_hand`"),
        "{message}"
    );
    let text = output(&call(&["--frame", "left_hand"]));
    assert!(text.contains("1, ") || text.contains("\n1  "), "{text}");
}

/// Every link of a URDF file is a frame.
#[test]
fn links_of_files_are_reached() {
    let hyq = data("urdf/trees/hyq_no_sensors.urdf");
    let call = |frame: &'static str| {
        let pose = ["reach", &hyq, "--pose", "0.4,0.2,-0.7", "--frame", frame];
        let about = ["--gravity", "0,0,-9.81", "--allow", "unphysical_inertia"];
        pose.iter()
            .chain(&about)
            .map(|word| (*word).to_owned())
            .collect::<Vec<_>>()
    };
    let words = call("lf_foot");
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let text = output(&words);
    assert!(text.contains("hyq_no_sensors: 1 solution\n"), "{text}");
    // The three other legs stay in the middle of their limits.
    let stay = [0.0, 0.0, -0.349066, 0.0, 0.0, 0.349066, 0.0, 0.0, 0.349066];
    assert_eq!(rows(&text)[0][3..], stay, "{text}");
    let words = call("lf_fot");
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let message = errors(&words, 2);
    assert!(
        message.contains("`--frame lf_fot` is no frame: expected a link, or one of `lf_kfe_joint`"),
        "{message}"
    );
}

#[test]
fn why_there_is_no_solution_is_told() {
    let pendulum = file("reach.toml", PENDULUM);
    let message = errors(&["reach", &pendulum, "--pose", "3,0,0"], 1);
    assert!(
        message.contains("is 3.000000 m from the base, and the arm reaches"),
        "{message}"
    );
    let message = errors(&["reach", &pendulum, "--pose", "0.9,0,0.2"], 1);
    assert!(
        message.contains("no motion of the joints comes nearer; 2.236e-1 m"),
        "{message}"
    );
    let message = errors(&["reach", &pendulum, "--pose", "1,2"], 2);
    assert!(
        message.contains("`--pose` has 2 numbers: expected six"),
        "{message}"
    );
    let message = errors(&["reach", &pendulum, "--pose", "1,0,0", "--from", "1"], 2);
    assert!(
        message.contains("`--from` has 1 number: expected 2"),
        "{message}"
    );
    let brick = file("reach_brick.toml", BRICK);
    let message = errors(&["reach", &brick, "--pose", "1,0,0"], 1);
    assert!(message.contains("which `reach` does not know"), "{message}");
}
