//! Inverse kinematics by the command.

use super::calls::{PENDULUM, assert_has, errors, file, folder, output, refused};
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
joint = [
    { name = "pan", type = "revolute", d = 0.15185, alpha = "PI/2" },
    { name = "lift", type = "revolute", a = -0.24355 },
    { name = "elbow", type = "revolute", a = -0.2132 },
    { name = "w1", type = "revolute", d = 0.13105, alpha = "PI/2" },
    { name = "w2", type = "revolute", d = 0.08535, alpha = "-PI/2" },
    { name = "w3", type = "revolute", d = 0.0921 },
]
"#;

/// Commands that read no mass ask for none.
#[test]
fn tables_of_geometry_alone_are_served() {
    let table = file("geometry.toml", GEOMETRY);
    let text = output(format!("reach {table} --pose -0.3,-0.2,0.3,3.14159,0,0"));
    assert!(rows(&text).len() >= 4, "{text}");
    let modified = output(format!("convert {table} --to toml --convention modified"));
    assert!(!modified.contains("mass"), "{modified}");
    let modified = file("geometry_modified.toml", modified);
    let pose = "--functions forward_kinematics --at 0.1,-1,1,0.3,0.4,0.5";
    let of = |table: &str| output(format!("evaluate {table} {pose}"));
    assert_eq!(of(&modified).replace("_modified", ""), of(&table));
    let page = folder("geometry").join("page.html");
    output(&["page", &table, "--out", &page.to_string_lossy()]);
    // Functions that read masses ask for them.
    assert!(errors(format!("evaluate {table} --at 0,0,0,0,0,0"), 1).contains("no_inertia"));
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
    let evaluate = |file: &str, rest: &str| format!("evaluate {file} --at 0.3 --functions {rest}");
    for (file, gravity) in [(&urdf, "--gravity 0,0,0"), (&table, "")] {
        let command = format!("reach {file} {gravity} --pose 0.4,0.3,0");
        output(&command);
        let tip = output(evaluate(file, &format!("forward_kinematics {gravity}")));
        assert!(tip.contains("xyz [0.477"), "{tip}");
        refused(
            evaluate(file, &format!("mass_matrix {gravity}")),
            1,
            ["unphysical_inertia"],
        );
    }
}

/// Numbers as the command reads them.
fn list(numbers: &[f64]) -> String {
    let numbers: Vec<String> = numbers.iter().map(f64::to_string).collect();
    numbers.join(",")
}

/// `evaluate` has the tip of each solution at the pose.
#[test]
fn all_solutions_are_listed() {
    let puma = data("robots/puma560.json");
    let text = output(format!(
        "reach {puma} --pose 0.4,0.1,0.2,0,PI/2,deg(10) --digits 17"
    ));
    assert_has(&text, ["8 solutions, the nearest to the start first"]);
    assert!(text.contains("joint1, rad"), "{text}");
    let found = rows(&text);
    assert_eq!(found.len(), 8);
    for q in &found {
        let at = list(q);
        let tip = output(format!(
            "evaluate {puma} --at {at} --functions forward_kinematics"
        ));
        assert!(tip.contains("xyz [0.4, 0.1, 0.2] m"), "{tip}");
    }
    // From one of them, this one is the first.
    let from = list(&found[5]);
    let again = output(format!(
        "reach {puma} --pose 0.4,0.1,0.2,0,PI/2,deg(10) --from {from} --digits 17"
    ));
    let first = &rows(&again)[0];
    assert!(
        first
            .iter()
            .zip(&found[5])
            .all(|(a, b)| (a - b).abs() < 1e-8),
        "{again}"
    );
    // The word that other programs have does the same.
    let named = output(format!("inverse-kinematics {puma} --pose 0.4,0.1,0.2"));
    assert_has(&named, ["8 of infinitely many solutions", "are free: 3"]);
}

#[test]
fn frames_of_trees_are_reached() {
    let torso: &str = &data("files/torso.toml");
    let at = format!("reach {torso} --field load=1 --pose 0.1,0.5,0.3");
    let call = |more: &str| format!("{at} {more}");
    refused(call(""), 2, ["the robot has no tip", "`left_hand`"]);
    let message = errors(call("--frame foot"), 2);
    assert_has(
        &message,
        ["`--frame foot` is no frame: expected one of `left_hand`"],
    );
    let text = output(call("--frame left_hand"));
    assert!(text.contains("1, ") || text.contains("\n1  "), "{text}");
}

/// Every link of a URDF file is a frame.
#[test]
fn links_of_files_are_reached() {
    let hyq = data("urdf/trees/hyq_no_sensors.urdf");
    let call = |frame: &str| {
        let pose = format!("reach {hyq} --pose 0.4,0.2,-0.7 --frame {frame}");
        let about = "--gravity 0,0,-9.81 --allow unphysical_inertia";
        format!("{pose} {about}")
    };
    let text = output(call("lf_foot"));
    assert!(text.contains("hyq_no_sensors: 1 solution\n"), "{text}");
    // The three other legs stay in the middle of their limits.
    let stay = [0.0, 0.0, -0.349066, 0.0, 0.0, 0.349066, 0.0, 0.0, 0.349066];
    assert_eq!(rows(&text)[0][3..], stay, "{text}");
    let message = errors(call("lf_fot"), 2);
    assert_has(
        &message,
        ["`--frame lf_fot` is no frame: expected a link, or one of `lf_kfe_joint`"],
    );
}

#[test]
fn why_there_is_no_solution_is_told() {
    let pendulum = file("reach.toml", PENDULUM);
    let message = errors(format!("reach {pendulum} --pose 3,0,0"), 1);
    assert_has(
        &message,
        ["is 3.000000 m from the base, and the arm reaches"],
    );
    let message = errors(format!("reach {pendulum} --pose 0.9,0,0.2"), 1);
    assert_has(
        &message,
        ["no motion of the joints comes nearer; 2.236e-1 m"],
    );
    refused(
        format!("reach {pendulum} --pose 1,2"),
        2,
        ["`--pose` has 2 numbers: expected six"],
    );
    refused(
        format!("reach {pendulum} --pose 1,0,0 --from 1"),
        2,
        ["`--from` has 1 number: expected 2"],
    );
    let brick = file("reach_brick.toml", BRICK);
    refused(
        format!("reach {brick} --pose 1,0,0"),
        1,
        ["which `reach` does not know"],
    );
}
