//! Robots on a base that moves: checks, motions, and what is refused.

use dynamics_evaluation::{ReadOptions, RuntimeRobot};

use super::calls::{assert_has, data, errors, file, folder, output, refused, run};

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
    let text = output(format!(
        "check {brick} --functions default,jacobian,centroidal_momentum_matrix"
    ));
    for function in [
        "inverse_dynamics",
        "forward_dynamics",
        "centroidal_momentum_matrix",
    ] {
        assert!(text.contains(function), "{text}");
    }
    let hyq = data(HYQ);
    let functions = "--functions mass_matrix,inverse_dynamics --samples 3";
    let about = "--base floating --gravity 0,0,-9.81 --allow unphysical_inertia";
    let call = format!("check {hyq} {functions} {about}");
    assert!(output(&call).contains("inverse_dynamics"));
}

/// An angle of a pose that was perhaps meant in degrees is told as one of a joint is.
#[test]
fn poses_in_degrees_are_told() {
    let brick = file("turned_brick.toml", BRICK);
    let arm = data("robots/scara.json");
    for call in [
        format!("evaluate {brick} --pose 0,0,0,0,0,90"),
        format!("reach {arm} --pose 1.2,1.3,0,0,0,90"),
    ] {
        let told = run(&call).stderr;
        let told = String::from_utf8_lossy(&told);
        let expected = "`--pose`: 90 rad of `YAW` are 14.3 turns: angles are in radians, and 90 degrees are 1.5708";
        assert!(told.contains(expected), "{told}");
    }
}

/// Formulas name what a base has by its axes, and count joints from 1: m (dv/dt + w x v) - m g of the whole, and Euler's
/// equations.
#[test]
fn formulas_of_a_base_are_newtons_and_eulers() {
    let brick = file("shown_brick.toml", BRICK);
    let text = output(format!("show {brick}"));
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
    let functions = "--functions inverse_dynamics,jacobian";
    let call = |format| output(format!("show {brick} --format {format} {functions}"));
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
    assert_has(&latex, ["\\dot{w}_{z}", "\\ddot{q}_{1}"]);
}

/// Two files of a robot on a moving base agree, or the number of the base that differs is named.
#[test]
fn files_of_moving_bases_are_compared() {
    let brick = file("compared_brick.toml", BRICK);
    let same = file("same_brick.toml", BRICK);
    let text = output(format!("check {brick} --against {same}"));
    assert!(text.contains("gravity_vector       0.0e0"), "{text}");
    let heavier = file(
        "heavier_brick.toml",
        BRICK.replace("zz = 0.04", "zz = 0.05"),
    );
    refused(
        format!("check {brick} --against {heavier}"),
        1,
        ["the two files differ by more than"],
    );
    let differing = run(format!("check {brick} --against {heavier}")).stdout;
    let differing = String::from_utf8_lossy(&differing);
    assert!(differing.contains("most at `base wz`"), "{differing}");
    let standing = BRICK.lines().filter(|line| !line.starts_with("base"));
    let standing = file(
        "brick_that_stands.toml",
        standing.collect::<Vec<_>>().join("\n"),
    );
    refused(
        format!("check {brick} --against {standing}"),
        1,
        ["the base stands, and moves in"],
    );
}

/// A file of a robot on a moving base stays the same robot as a table of either convention and as a URDF file. A link
/// that is locked to the base is a part of it.
#[test]
fn moving_bases_are_converted() {
    let beside = "--base floating --gravity 0,0,-9.81 --allow unphysical_inertia";
    let lock = "--lock lf_haa_joint=0.4";
    let hyq = data(HYQ);
    let written = |name: &str| {
        folder("converted")
            .join(name)
            .to_string_lossy()
            .into_owned()
    };
    let names = ["hyq_modified.toml", "hyq_standard.json", "hyq_again.urdf"].map(written);
    let [modified, standard, urdf] = names.each_ref().map(String::as_str);
    output(format!("convert {hyq} --out {modified} {beside} {lock}"));
    output(format!(
        "convert {modified} --convention standard --out {standard}"
    ));
    output(format!("convert {standard} --out {urdf}"));
    for other in names.iter().map(String::as_str) {
        let call = format!("check {hyq} --against {other} --samples 8 --tolerance 1e-12");
        let text = output(format!("{call} {beside} {lock}"));
        assert!(text.contains("against the other file"), "{text}");
    }
    let table = std::fs::read_to_string(modified).expect("a table");
    assert_has(&table, ["[base]\nfloating = true\nmass = "]);
}

/// A throw with a spin: the base falls by g t^2 / 2, and a torque at the wheel turns it against the body.
#[test]
fn a_throw_is_simulated() {
    let brick = file("thrown.toml", BRICK);
    let text = output(format!(
        "simulate {brick} --pose 1,2,3,0,0,1.5 --velocity 0,0,5,0,0,2,0 --torque 0,0,0,0,0,0,0.1 --duration 0.5 --samples 3"
    ));
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
    // The accelerations under 0.1 N m: 0.1 / 0.002 of the wheel, and 0.1 / 0.04 of the brick, the other way.
    let (of_wheel, of_brick) = (0.1 / 0.002, 0.1 / 0.04);
    assert!((q - 0.125 * (of_wheel + of_brick)).abs() < 1e-7, "{q}");
    let yaw = f64::atan2(numbers[4], numbers[1]);
    assert!((yaw - (1.5 + 1.0 - 0.125 * of_brick)).abs() < 1e-7, "{yaw}");
}

#[test]
fn times_and_errors_are_measured() {
    let brick = file("measured_brick.toml", BRICK);
    let text = output(format!(
        "measure {brick} --functions mass_matrix,inverse_dynamics,jacobian"
    ));
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
            format!("simulate {brick} --velocity 1"),
            "`--velocity` has 1 number: expected 7, six of the base, then one for each joint that moves",
        ),
        (
            format!("simulate {brick} --from 1,2"),
            "`--from` has 2 numbers: expected 1, one for each joint that moves",
        ),
        (
            format!("simulate {brick} --pose 1,2"),
            "`--pose` has 2 numbers: expected six, X,Y,Z,ROLL,PITCH,YAW",
        ),
        (
            format!("simulate {arm} --pose 0,0,0,0,0,0"),
            "`--pose` is of a robot whose base moves: this one stands",
        ),
        (
            format!("check {arm} --base floating"),
            "`--base` is about a URDF file, a tree of links",
        ),
        (
            format!("check {hyq} --base flaoting --gravity 0,0,-9.81"),
            "invalid value 'flaoting' for '--base <BASE>'",
        ),
    ] {
        refused(call, 2, [message]);
    }
    let told = errors(format!("reach {brick} --pose 1,0,0"), 1);
    let message = "the base moves, which `reach` does not know: all others do";
    assert!(told.contains(message), "{told}");
}

/// The header and the numbers of a table.
fn table(text: &str) -> (Vec<&str>, Vec<Vec<f64>>) {
    let mut lines = text.lines();
    let header = lines.next().expect("a header").split(',').collect();
    let numbers = |line: &str| {
        let cells = line.split(',').map(|cell| cell.parse().expect("a number"));
        cells.collect()
    };
    (header, lines.map(numbers).collect())
}

/// The numbers of one state, as the engine's inverse dynamics has them.
fn engine(path: &str, options: ReadOptions, arguments: &[&[f64]]) -> Vec<f64> {
    let options = options.functions(["inverse_dynamics"]);
    let robot = RuntimeRobot::from_file(path, &options).expect("a robot");
    let mut tau = vec![0.0; robot.dof()];
    robot
        .batch("inverse_dynamics", arguments, &mut tau)
        .expect("torques");
    tau
}

/// A quadruped at one state on a turned base, and the row that holds it while its legs move.
#[test]
fn a_quadruped_has_torques() {
    let hyq = data(HYQ);
    let beside = "--base floating --gravity 0,0,-9.81 --allow unphysical_inertia";
    let numbers: Vec<f64> = (0..48).map(|k| f64::from(k * 7 % 11) / 8.0 - 0.5).collect();
    let at: Vec<String> = numbers.iter().map(f64::to_string).collect();
    let (at, pose) = (at.join(","), "0.5,-1,2,0,0,PI/2");
    let call = format!("inverse-dynamics {hyq} --at {at} --pose {pose}");
    let text = output(format!("{call} {beside}"));
    let (header, rows) = table(&text);
    assert_eq!((header.len(), rows.len()), (1 + 12 + 12 + 3 * 18, 1));
    let first = header.len() - 18;
    let of_base = [
        "fx [N]", "fy [N]", "fz [N]", "nx [N m]", "ny [N m]", "nz [N m]",
    ];
    for (name, cell) in of_base.iter().zip(&header[first..]) {
        assert_eq!(*cell, format!("base.{name}"));
    }
    assert_eq!(header[first + 6], "tau.lf_haa_joint [N m]");
    let base = &rows[0][1..13];
    assert!((base[1] + 1.0).abs() < 1e-15 && (base[3] - 1.0).abs() < 1e-15);
    let options = || {
        ReadOptions::new().entries(
            "gravity = [0, 0, -9.81]\nbase = { floating = true }\nallow = [\"unphysical_inertia\"]",
        )
    };
    let (q, rates) = numbers.split_at(12);
    let (v, a) = rates.split_at(18);
    assert_eq!(rows[0][first..], engine(&hyq, options(), &[base, q, v, a]));
    // Held at rest, the base bears the weight.
    let zeros = ["0"; 11].join(",");
    let to = format!("1,{zeros}");
    let call = format!("inverse-dynamics {hyq} --to {to} --samples 3");
    let text = output(format!("{call} {beside}"));
    for row in &table(&text).1 {
        let (base, q, v, a) = (&row[1..13], &row[13..25], &row[25..43], &row[43..61]);
        assert_eq!(
            (v[..6].to_vec(), a[..6].to_vec()),
            (vec![0.0; 6], vec![0.0; 6])
        );
        assert_eq!(row[61..], engine(&hyq, options(), &[base, q, v, a]));
    }
}

/// The motion of a free-flying arm is followed: on its rows the torques are those that moved it. Between rows their
/// error is of the fourth power of the distance, as that of second derivatives of polynomials of fifth degree is.
#[test]
fn a_simulated_motion_gives_its_torques_back() {
    let second = "[[joint]]\nname = \"arm\"\ntype = \"revolute\"\na = 0.4\nalpha = 1\nmass = 0.3\ncom = [0.2, 0, 0]\n\
        inertia = { xx = 0.001, yy = 0.002, zz = 0.002 }\n";
    let arm = file("free_flying_arm.toml", format!("{BRICK}{second}"));
    let written = |name: &str| folder("followed").join(name).to_string_lossy().into_owned();
    let plot = written("motion.svg");
    let applied = [0.5, -0.25, 20.0, 0.01, 0.02, -0.03, 0.1, -0.05];
    let torque = applied.map(|x| x.to_string()).join(",");
    let error = |rows: &str, samples: &str| {
        let motion = written(&format!("motion_of_{rows}.csv"));
        let start = "--pose 1,2,3,0.4,-0.3,1.5 --velocity 0,1,5,2,-1,3,0.5,0.2";
        let call = format!("simulate {arm} --torque {torque} --samples {rows}");
        let to = format!("--tolerance 1e-13 --out {motion}");
        output(format!("{call} {start} {to}"));
        let call = format!("inverse {arm} --waypoints {motion} --samples {samples}");
        let text = output(format!("{call} --plot {plot}"));
        let (header, found) = table(&text);
        assert_eq!(header[header.len() - 1], "tau.arm [N m]");
        assert_eq!(found.len().to_string(), samples);
        let errors = found.iter().flat_map(|row| {
            let tau = row[row.len() - 8..].iter().zip(applied);
            tau.map(|(found, expected)| (found - expected).abs())
        });
        let errors: Vec<f64> = errors.collect();
        assert!(errors.iter().all(|error| error.is_finite()));
        errors.into_iter().fold(0.0, f64::max)
    };
    let on_rows = error("201", "201");
    assert!(on_rows < 1e-11, "{on_rows:e}");
    // Two of three samples are a third of the distance from a row. Half the distance divides the error by 16.
    let [coarse, fine] = [error("101", "301"), error("201", "601")];
    let quotient = coarse / fine;
    assert!((14.0..18.0).contains(&quotient), "{coarse:e} {fine:e}");
    let figure = std::fs::read_to_string(&plot).expect("a figure");
    for text in ["base, N m", "base, rad", "torque, N m", "wheel"] {
        assert!(figure.contains(text), "{text}");
    }
}

/// Mistakes in a motion of the base, each at its place.
#[test]
fn mistakes_in_motions_of_a_base_are_told() {
    let brick = file("followed_brick.toml", BRICK);
    let text = output(format!(
        "simulate {brick} --samples 3 --velocity 0,0,0,0,0,4,0"
    ));
    let lines: Vec<&str> = text.lines().collect();
    let changed = |name: &str, old: &str, new: &str| {
        assert!(text.contains(old), "{text}");
        file(name, text.replacen(old, new, 1))
    };
    let told = |path: &str, message: &str| {
        refused(
            format!("inverse-dynamics {brick} --waypoints {path}"),
            1,
            [message],
        );
    };
    let without = "t,q.wheel\n0,0\n1,1\n";
    let path = file("without_base.csv", without);
    told(
        &path,
        ":1:3: a column `base.r11` was expected: the base moves, and the columns are those that `simulate` writes",
    );
    told(
        &changed("no_rates.csv", "base.vxd", "x"),
        "a column `base.vxd` was expected",
    );
    told(
        &changed(
            "shear.csv",
            "0,1,0,0,0,1,0,0,0,1,",
            "0,1,0.1,0,0,1,0,0,0,1,",
        ),
        ":2:3: `base.r11` to `base.r33` are no rotation",
    );
    told(
        &changed(
            "cell.csv",
            "0,1,0,0,0,1,0,0,0,1,",
            "0,1,0,0,0,fast,0,0,0,1,",
        ),
        ":2:11: `fast`: expected a number",
    );
    let rows = [lines[0], lines[2], lines[1]].join("\n");
    told(
        &file("order.csv", rows),
        ":3:1: times must grow from row to row",
    );
    let rows = [lines[0], lines[1]].join("\n");
    told(
        &file("one_row.csv", rows),
        "expected two rows of numbers or more",
    );
    let rows = [lines[0], lines[1], lines[3]].join("\n");
    told(
        &file("far.csv", rows),
        "the base turns by more than half a turn between t = 0 and t = 1: more rows are needed there",
    );
    let lines = BRICK.lines().filter(|line| !line.starts_with("base"));
    let arm = file(
        "followed_standing_brick.toml",
        lines.collect::<Vec<_>>().join("\n"),
    );
    for (call, message) in [
        (
            format!("inverse-dynamics {arm} --to 1 --pose 0,0,0,0,0,0"),
            "`--pose` is of a robot whose base moves: this one stands",
        ),
        (
            format!("inverse-dynamics {brick} --at 1,2"),
            "`--at` has 2 numbers: expected 1, one position for each joint that moves, 8 with the 7 velocities behind them, or 15",
        ),
        (
            format!("inverse-dynamics {brick} --to 1 --pose 1,2,3"),
            "`--pose` has 3 numbers: expected six",
        ),
        (
            format!("inverse-dynamics {brick} --at 1 --duration 2"),
            "cannot be used with",
        ),
        (
            format!("inverse-dynamics {brick} --waypoints {path} --pose 0,0,0,0,0,0"),
            "cannot be used with",
        ),
    ] {
        refused(call, 2, [message]);
    }
}
