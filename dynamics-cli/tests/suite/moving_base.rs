//! Robots on a base that moves: checks, motions, and what is refused.

use super::calls::{data, errors, file, folder, output};

/// A brick with a wheel.
pub(super) const BRICK: &str = r#"
convention = "modified"
gravity = [0, 0, -10]
base = { floating = true, mass = 2, com = [0, 0, 0], inertia = { xx = 0.02, yy = 0.03, zz = 0.04 } }
[[joint]]
name = "wheel"
type = "revolute"
mass = 0.5
inertia = { xx = 0.001, yy = 0.001, zz = 0.002 }
"#;

const HYQ: &str = "urdf/trees/hyq_no_sensors.urdf";

#[test]
fn tables_and_files_are_checked() {
    let brick = file("brick.toml", BRICK);
    let text = output(&[
        "check",
        &brick,
        "--functions",
        "default,jacobian,centroidal_momentum_matrix",
    ]);
    for function in [
        "inverse_dynamics",
        "forward_dynamics",
        "centroidal_momentum_matrix",
    ] {
        assert!(text.contains(function), "{text}");
    }
    let hyq = data(HYQ);
    let functions = [
        "--functions",
        "mass_matrix,inverse_dynamics",
        "--samples",
        "3",
    ];
    let about = [
        "--base",
        "floating",
        "--gravity",
        "0,0,-9.81",
        "--allow",
        "unphysical_inertia",
    ];
    let call = [&["check", &hyq][..], &functions, &about].concat();
    assert!(output(&call).contains("inverse_dynamics"));
}

/// Formulas name what a base has by its axes, and count joints from 1: m (dv/dt + w x v) - m g of the whole, and Euler's
/// equations.
#[test]
fn formulas_of_a_base_are_newtons_and_eulers() {
    let brick = file("shown_brick.toml", BRICK);
    let text = output(&["show", &brick]);
    for expected in [
        "shown_brick: 1 joint that moves",
        "base   moves        mass 2  com [0, 0, 0]  inertia [0.02, 0.03, 0.04, 0, 0, 0]",
        "M67, M76, M77 are constant",
        "tau4 depends on wy, wz, qd1, wxd",
        "G1 depends on r31",
        "`qd`: velocities: of the base in its own axes, three linear (m/s) and three angular (rad/s), then joint velocities",
    ] {
        assert!(text.contains(expected), "{expected}: {text}");
    }
    let functions = ["--functions", "inverse_dynamics,jacobian"];
    let call = |format| output(&[&["show", &*brick, "--format", format][..], &functions].concat());
    for expected in [
        "tau1 = 25 r31 - 5/2 vy wz + 5/2 vz wy + 5/2 vxd\n",
        "tau4 = 0.011 wy wz + 0.002 wy qd1 + 0.021 wxd\n",
        "tau7 = 0.002 wzd + 0.002 qdd1\n",
        "J47 = r13\n",
    ] {
        let text = call("text");
        assert!(text.contains(expected), "{expected}: {text}");
    }
    let latex = call("latex");
    assert!(
        latex.contains("\\dot{w}_{z}") && latex.contains("\\ddot{q}_{1}"),
        "{latex}"
    );
}

/// Two files of a robot on a moving base agree, or the number of the base that differs is named.
#[test]
fn files_of_moving_bases_are_compared() {
    let brick = file("compared_brick.toml", BRICK);
    let same = file("same_brick.toml", BRICK);
    let text = output(&["check", &brick, "--against", &same]);
    assert!(text.contains("gravity_vector       0.0e0"), "{text}");
    let heavier = file(
        "heavier_brick.toml",
        BRICK.replace("zz = 0.04", "zz = 0.05"),
    );
    let told = errors(&["check", &brick, "--against", &heavier], 1);
    assert!(told.contains("the two files differ by more than"), "{told}");
    let standing = BRICK.lines().filter(|line| !line.starts_with("base"));
    let standing = file(
        "brick_that_stands.toml",
        standing.collect::<Vec<_>>().join("\n"),
    );
    let told = errors(&["check", &brick, "--against", &standing], 1);
    assert!(told.contains("the base stands, and moves in"), "{told}");
}

/// A file of a robot on a moving base stays the same robot as a table of either convention and as a URDF file. A link
/// that is locked to the base is a part of it.
#[test]
fn moving_bases_are_converted() {
    let beside = [
        "--base",
        "floating",
        "--gravity",
        "0,0,-9.81",
        "--allow",
        "unphysical_inertia",
    ];
    let lock = ["--lock", "lf_haa_joint=0.4"];
    let hyq = data(HYQ);
    let written = |name: &str| {
        folder("converted")
            .join(name)
            .to_string_lossy()
            .into_owned()
    };
    let names = ["hyq_modified.toml", "hyq_standard.json", "hyq_again.urdf"].map(written);
    let [modified, standard, urdf] = names.each_ref().map(String::as_str);
    output(&[&["convert", &*hyq, "--out", modified][..], &beside, &lock].concat());
    output(&[
        "convert",
        modified,
        "--convention",
        "standard",
        "--out",
        standard,
    ]);
    output(&["convert", standard, "--out", urdf]);
    for other in names.iter().map(String::as_str) {
        let call = [
            "check",
            &hyq,
            "--against",
            other,
            "--samples",
            "8",
            "--tolerance",
            "1e-12",
        ];
        let text = output(&[&call[..], &beside, &lock].concat());
        assert!(text.contains("against the other file"), "{text}");
    }
    let table = std::fs::read_to_string(modified).expect("a table");
    assert!(
        table.contains("[base]\nfloating = true\nmass = "),
        "{table}"
    );
}

/// A throw with a spin: the base falls by g t^2 / 2, and a torque at the wheel turns it against the body.
#[test]
fn a_throw_is_simulated() {
    let brick = file("thrown.toml", BRICK);
    let text = output(&[
        "simulate",
        &brick,
        "--pose",
        "1,2,3,0,0,1.5",
        "--velocity",
        "0,0,5,0,0,2,0",
        "--torque",
        "0,0,0,0,0,0,0.1",
        "--duration",
        "0.5",
        "--samples",
        "3",
    ]);
    let lines: Vec<&str> = text.lines().collect();
    assert!(
        lines[0].starts_with("t [s],base.r11,")
            && lines[0].contains(",q.wheel [rad],base.vx [m/s],")
    );
    let numbers: Vec<f64> = lines[3]
        .split(',')
        .map(|cell| cell.parse().expect("a number"))
        .collect();
    let (x, y, z, q) = (numbers[10], numbers[11], numbers[12], numbers[13]);
    let height = 3.0 + 5.0 * 0.5 - 0.5 * 10.0 * 0.25;
    assert!(
        (x - 1.0).abs() < 1e-8 && (y - 2.0).abs() < 1e-8 && (z - height).abs() < 1e-8,
        "{text}"
    );
    // Of 0.1 N m the wheel has 1 / 0.002, and the brick the other way 1 / 0.04.
    let (of_wheel, of_brick) = (0.1 / 0.002, 0.1 / 0.04);
    assert!((q - 0.125 * (of_wheel + of_brick)).abs() < 1e-7, "{q}");
    let yaw = f64::atan2(numbers[4], numbers[1]);
    assert!((yaw - (1.5 + 1.0 - 0.125 * of_brick)).abs() < 1e-7, "{yaw}");
}

#[test]
fn times_and_errors_are_measured() {
    let brick = file("measured_brick.toml", BRICK);
    let text = output(&[
        "measure",
        &brick,
        "--functions",
        "mass_matrix,inverse_dynamics,jacobian",
    ]);
    for line in text.lines().skip(1) {
        let cells: Vec<&str> = line.split_whitespace().collect();
        let error: f64 = cells[4].parse().expect("an error");
        assert!(error < 1e-14, "{line}");
    }
    assert_eq!(text.lines().count(), 4, "{text}");
}

#[test]
fn what_makes_no_sense_is_told() {
    let brick = file("refused_brick.toml", BRICK);
    let lines = BRICK.lines().filter(|line| !line.starts_with("base"));
    let arm = file("standing_brick.toml", lines.collect::<Vec<_>>().join("\n"));
    let hyq = data(HYQ);
    for (call, message) in [
        (
            &["simulate", &brick, "--velocity", "1"][..],
            "`--velocity` has 1 number: expected 7, six of the base, then one for each joint that moves",
        ),
        (
            &["simulate", &brick, "--from", "1,2"],
            "`--from` has 2 numbers: expected 1, one for each joint that moves",
        ),
        (
            &["simulate", &brick, "--pose", "1,2"],
            "`--pose` has 2 numbers: expected six, X,Y,Z,ROLL,PITCH,YAW",
        ),
        (
            &["simulate", &arm, "--pose", "0,0,0,0,0,0"],
            "`--pose` is of a robot whose base moves: this one stands",
        ),
        (
            &["check", &arm, "--base", "floating"],
            "`--base` is about a URDF file, a tree of links",
        ),
        (
            &[
                "check",
                &hyq,
                "--base",
                "flaoting",
                "--gravity",
                "0,0,-9.81",
            ],
            "invalid value 'flaoting' for '--base <BASE>'",
        ),
    ] {
        let told = errors(call, 2);
        assert!(told.contains(message), "{told}");
    }
    let told = errors(&["inverse-dynamics", &brick, "--to", "1"], 1);
    assert!(
        told.contains("the base moves, which neither `inverse-dynamics` nor `reach` knows"),
        "{told}"
    );
}
