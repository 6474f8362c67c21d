//! The output of each subcommand.

use super::calls::{PENDULUM, assert_has, data, errors, file, folder, output, refused, run};

#[test]
fn show_prints_what_a_function_is() {
    let pendulum = file("show.toml", PENDULUM);
    let text = output(format!("show {pendulum} --functions mass_matrix"));
    for expected in [
        "show: 2 joints that move",
        "knee",
        "Mass matrix M(q)",
        "Operations: ",
        "M22 = ",
    ] {
        assert!(text.contains(expected), "{expected}: {text}");
    }
    assert!(!text.contains("coriolis_vector"), "{text}");
    let latex = output(format!(
        "show {pendulum} --functions gravity_vector --format latex"
    ));
    assert!(latex.contains("G_{"), "{latex}");
    let locked = output(format!(
        "show {pendulum} --lock knee=0.5 --functions mass_matrix"
    ));
    assert_has(&locked, ["locked at 0.5", "1 joint that moves"]);
}

/// Joints that the command line locks are locked beside those of the file, and what it allows is allowed beside what the
/// file does.
#[test]
fn locks_of_the_file_stay_locked() {
    let mut three = format!("lock = {{ knee = \"3/10\" }}\nallow = [\"odd_angle\"]\n{PENDULUM}");
    three += "alpha = 1.5708\n[[joint]]\nname = \"toe\"\ntype = \"revolute\"\na = 1\ncom = [0.25, 0, 0]\n";
    let three = file("three_locks.toml", three);
    let show = |lock: &str| {
        run(format!(
            "show {three} --functions mass_matrix --allow odd_mass --lock {lock}"
        ))
    };
    for (lock, locked) in [("toe=0.1", 2), ("knee=0.3", 1)] {
        let shown = show(lock);
        let text = String::from_utf8_lossy(&shown.stdout).into_owned();
        assert!(shown.status.success(), "{shown:?}");
        assert_eq!(text.matches("locked at").count(), locked, "{text}");
    }
    let refused = show("knee=0.5");
    assert_eq!(refused.status.code(), Some(2));
    let message = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert_has(
        &message,
        ["`knee` is locked at 0.3 in one place and at 0.5 in another"],
    );
}

/// A name in the cells has the value that is given, in place of the file's own.
#[test]
fn fields_have_values() {
    let carrying = PENDULUM.replace("mass = 1", r#"mass = "1 + load""#);
    let carrying = file("carrying.toml", carrying);
    let halves = PENDULUM.replace("mass = 1", r#"mass = "1 + load / 2""#);
    let of_its_own = file("of_its_own.toml", format!("{halves}\n[let]\nload = 7\n"));
    let heavier = file(
        "two_and_a_half.toml",
        PENDULUM.replace("mass = 1", "mass = 2.5"),
    );
    for (of, value) in [(&carrying, "load=1.5"), (&of_its_own, "load = 3")] {
        output(&["check", of, "--field", value, "--against", &heavier]);
    }
    let generated = folder("carrying");
    let to = generated.to_string_lossy();
    output(format!(
        "generate {carrying} --field load=3/2 --lang c --out {to}"
    ));
    output(format!("simulate {carrying} --field load=1.5 --samples 3"));

    refused(
        format!("simulate {carrying}"),
        1,
        ["unknown name `load`: `--field load=2`"],
    );
    refused(
        format!("show {carrying} --field laod=1"),
        2,
        ["has the name `laod`"],
    );
    for (value, expected) in [
        ("load", "expected NAME=NUMBER"),
        ("load=light", "unknown name `light`"),
    ] {
        refused(format!("show {carrying} --field {value}"), 2, [expected]);
    }
}

#[test]
fn a_check_of_a_negative_inertia_fails() {
    let table = "convention = 'modified'\ngravity = [0, -9.81, 0]\n[[joint]]\nname = 'pivot'\ntype = 'revolute'\n\
                 mass = 1\ncom = [0.1, 0, 0]\ninertia = { zz = -0.5 }\nallow = ['unphysical_inertia']\n";
    let call = ["check", &file("negative.toml", table)];
    refused(&call, 1, ["not positive definite"]);
    let report = String::from_utf8_lossy(&run(&call).stdout).into_owned();
    assert_has(
        &report,
        ["NOT positive definite, relative pivot -1.0e0, of joint pivot"],
    );
}

#[test]
fn check_compares_with_newton_euler_and_with_another_file() {
    let (one, same) = (file("check.toml", PENDULUM), file("same.toml", PENDULUM));
    let text = output(format!("check {one} --against {same}"));
    assert_has(&text, ["inverse_dynamics", "against the other file"]);
    let heavier = file("heavier.toml", PENDULUM.replace("mass = 1", "mass = 1.001"));
    refused(
        format!("check {one} --against {heavier}"),
        1,
        ["the two files differ by more than 1e-9"],
    );
    output(format!("check {one} --against {heavier} --tolerance 0.01"));
    // Functions that cannot be compared are no difference.
    for alone in ["regressor", "energy_regressors"] {
        let call = format!("check {one} --functions {alone}");
        refused(&call, 1, ["can be compared"]);
        let report = String::from_utf8_lossy(&run(&call).stdout).into_owned();
        assert_has(&report, ["(that takes `base_parameters` too)"]);
    }
    for call in ["check", "show", "generate --lang c"] {
        let series = "--functions taylor_series";
        refused(
            format!("{call} {one} {series}"),
            1,
            ["nothing else is requested"],
        );
    }
    output(format!("show {one} --functions mass_matrix,taylor_series"));
    // Functions of a tuple are compared as its one program has them.
    let tuple = r#"functions = ["mass_matrix", { terms = ["mass_matrix", "jacobian"] }]"#;
    let tuples = file("tuples.toml", format!("{tuple}{PENDULUM}"));
    let text = output(format!("check {tuples}"));
    for row in ["mass_matrix  ", "mass_matrix of terms", "jacobian of terms"] {
        assert!(text.lines().any(|line| line.starts_with(row)), "{text}");
    }
    assert!(!text.contains("jacobian  "), "{text}");
    // The PUMA of the data files, which has a published tensor that no body can have.
    output(&["check", &data("robots/puma560.json"), "--samples", "10"]);
}

#[test]
fn generate_writes_files() {
    let out = folder("generated");
    let out = out.to_string_lossy();
    let pendulum = file("two_rods.toml", PENDULUM);
    let text = output(format!("generate {pendulum} --lang c --out {out}"));
    assert_eq!(text.lines().count(), 2, "{text}");
    let source = std::fs::read_to_string(folder("generated").join("two_rods.c")).expect("a source");
    assert!(source.contains("two_rods_forward_dynamics"), "{source}");
    output(format!(
        "generate {pendulum} --lang js --out {out} --functions default,jacobian"
    ));
    let module =
        std::fs::read_to_string(folder("generated").join("two_rods.mjs")).expect("a module");
    assert!(module.contains("export function jacobian(q)"), "{module}");
}

/// A robot has the name that is given in place of its file's: in titles, files, functions and the struct.
#[test]
fn robots_have_names() {
    let pendulum = file("arm-42.toml", PENDULUM);
    let out = folder("named");
    let to = out.to_string_lossy();
    let functions = "--functions gravity_vector";
    let called = |words: &str, name: &str| output(format!("{words} {functions} --name {name}"));
    let shown = called(&format!("show {pendulum}"), "UR5e");
    assert!(shown.starts_with("UR5e: 2 joints"), "{shown}");
    for (language, file, text) in [
        ("rust", "ur5e.rs", "pub struct UR5e;"),
        ("c", "ur5e.h", "void ur5e_gravity_vector("),
        ("js", "ur5e.mjs", "Equations of motion of `UR5e`"),
        ("python", "ur5e.py", "Equations of motion of `UR5e`"),
        ("matlab", "gravity_vector.m", "A function of `UR5e`"),
        ("casadi", "ur5e_casadi.c", "Equations of motion of `UR5e`"),
    ] {
        called(
            &format!("generate {pendulum} --lang {language} --out {to}"),
            "UR5e",
        );
        let written = std::fs::read_to_string(out.join(file)).expect(file);
        assert!(written.contains(text), "{written}");
    }
    for name in ["", "7bot", "a/b", "x\ny", "r\"s"] {
        let message = errors(&["show", &pendulum, "--name", name], 2);
        assert!(
            message.contains("a letter first") || message.contains("a value is required"),
            "{message}"
        );
    }
}

/// The rows of a CSV of so many columns.
#[track_caller]
fn rows(text: &str, columns: usize) -> Vec<Vec<f64>> {
    let rows = text.lines().skip(1).map(|line| {
        let row: Vec<f64> = line
            .split(',')
            .map(|x| x.parse().expect("a number"))
            .collect();
        assert_eq!(row.len(), columns, "{line}");
        row
    });
    rows.collect()
}

#[test]
fn a_free_fall_keeps_its_energy() {
    let pendulum = file("fall.toml", PENDULUM);
    let text = output(format!(
        "simulate {pendulum} --from -1,0.5 --duration 2 --samples 11"
    ));
    assert!(
        text.starts_with("t [s],q.pivot [rad],q.knee [rad],qd.pivot [rad/s],"),
        "{text}"
    );
    let rows = rows(&text, 11);
    assert_eq!((rows.len(), rows[10][0]), (11, 2.0));
    let energy = |row: &Vec<f64>| row[9] + row[10];
    assert!(
        rows.iter()
            .all(|row| (energy(row) - energy(&rows[0])).abs() < 1e-6),
        "{text}"
    );
    assert!(
        rows.iter().any(|row| (row[1] - rows[0][1]).abs() > 0.5),
        "{text}"
    );
}

/// The torques of a motion that `simulate` wrote are those that it was made by.
#[test]
fn inverse_reads_what_simulate_writes() {
    let pendulum = file("both_ways.toml", PENDULUM);
    let options = "--from -1,0.5 --velocity 0.5,1 --torque 3,-1";
    let motion = output(format!("simulate {pendulum} --samples 21 {options}"));
    let way = file("both_ways.csv", &*motion);
    let found = output(format!("inverse {pendulum} --waypoints {way} --samples 21"));
    assert!(
        motion.starts_with(found.lines().next().expect("a header")),
        "{found}"
    );
    for (row, expected) in rows(&found, 9).iter().zip(rows(&motion, 11)) {
        assert_eq!(row[0], expected[0]);
        for column in 1..9 {
            let error = (row[column] - expected[column]).abs();
            assert!(error < 1e-10, "{column}: {error:e} at {}", row[0]);
        }
    }
    // One of its states.
    let row = &rows(&found, 9)[10];
    let state: Vec<String> = row[1..7].iter().map(f64::to_string).collect();
    let at = format!("--at={}", state.join(","));
    let alone = output(format!("inverse {pendulum} {at}"));
    assert_eq!(rows(&alone, 9)[0][1..], row[1..]);
}

#[test]
fn torques_of_motions() {
    let pendulum = file("inverse.toml", PENDULUM);
    let text = output(format!(
        "inverse {pendulum} --to 1,-0.5 --samples 5 --functions default,jacobian"
    ));
    let cycloidal = rows(&text, 9);
    assert_eq!(cycloidal[4][1..3], [1.0, -0.5]);
    // At rest at the end of the motion: gravity alone, m g l sin q at both joints.
    let gravity = |q1: f64, q2: f64| {
        let second = 9.81 * 0.25 * (q1 + q2).sin();
        [9.81 * (2.0 * 0.5 + 1.0) * q1.sin() + second, second]
    };
    for (found, expected) in cycloidal[4][7..].iter().zip(gravity(1.0, -0.5)) {
        assert!((found - expected).abs() < 1e-12, "{text}");
    }
    let waypoints = file("way.csv", "t,pivot,knee\n0,0,0\n1,0.5,0.2\n2,1,-0.5\n");
    let text = output(format!(
        "inverse {pendulum} --waypoints {waypoints} --samples 3"
    ));
    assert_eq!(rows(&text, 9)[1][1..3], [0.5, 0.2]);
    let wrong = file("wrong.csv", "t,pivot,knee\n0,0,0\n1,0.5,fast\n");
    refused(
        format!("inverse {pendulum} --waypoints {wrong}"),
        1,
        ["wrong.csv:3:7: `fast`: expected a number"],
    );
    for (name, end, expected) in [
        (
            "one.csv",
            "1",
            "one.csv:2:1: found 1 number, expected 3 separated by commas",
        ),
        ("short.csv", "1e-300,1,1", "not finite at t = 0"),
        (
            "latin.csv",
            "1,1,1 \u{fffd}",
            "latin.csv:2:7: not UTF-8 text",
        ),
    ] {
        let text = format!("0,0,0\n{end}\n").replace('\u{fffd}', "?");
        let mut bytes = text.into_bytes();
        bytes
            .iter_mut()
            .filter(|byte| **byte == b'?')
            .for_each(|byte| *byte = 0xe4);
        let way = file(name, bytes);
        refused(
            format!("inverse {pendulum} --waypoints {way}"),
            1,
            [expected],
        );
    }
    // Names of columns are those of the joints, in their order, in quotes or not, behind the mark of a text.
    let named = "\u{feff}\"t\",\"q_pivot\",\"q_knee\"\n\"0\",\"0\",\"0\"\n1,1,1\n";
    let way = file("named.csv", named);
    output(format!("inverse {pendulum} --waypoints {way}"));
    let way = file("swapped.csv", "t,q_knee,q_pivot\n0,0,0\n1,1,1\n");
    let message = errors(format!("inverse {pendulum} --waypoints {way}"), 1);
    assert_has(
        &message,
        ["swapped.csv:1:3: a column of `knee`, expected one of `pivot`"],
    );
    // Angles that were perhaps meant in degrees are remarked on.
    let way = file("degrees.csv", "0,0,0\n1,90,45\n");
    for degrees in [&format!("--waypoints {way}"), "--to 90,45"] {
        let call = run(format!("inverse {pendulum} {degrees}"));
        let remarks = String::from_utf8_lossy(&call.stderr).into_owned();
        assert_eq!(call.status.code(), Some(0), "{remarks}");
        let expected =
            "90 rad of `pivot` are 14.3 turns: angles are in radians, and 90 degrees are 1.5708";
        assert!(remarks.contains(expected), "{remarks}");
    }
    let way = file("long.csv", "0,0,0\n1e200,0.5,0.2\n1e300,1,-0.5\n");
    let text = output(format!("inverse {pendulum} --waypoints {way} --samples 2"));
    let end = &rows(&text, 9)[1];
    assert!(
        end[0] == 1e300 && (end[1] - 1.0).abs() < 1e-12 && (end[2] + 0.5).abs() < 1e-12,
        "{text}"
    );
    assert!(errors(format!("inverse {pendulum}"), 2).contains("--to <X,Y,...>|--waypoints <PATH>"));
    let out = folder("files").join("torques.csv");
    let path = out.to_string_lossy();
    assert!(output(format!("inverse {pendulum} --to 1,1 --out {path}")).is_empty());
    assert_eq!(
        std::fs::read_to_string(&out)
            .expect("a file")
            .lines()
            .count(),
        102
    );
}

/// The subcommand is named after what it finds; the shorter word of before does the same, and what it is not is told.
#[test]
fn inverse_dynamics_is_no_inverse_kinematics() {
    let pendulum = file("named_inverse.toml", PENDULUM);
    let [long, short] = ["inverse-dynamics", "inverse"].map(|word| {
        let path = output(format!("{word} {pendulum} --to 1,0.5 --samples 3"));
        assert_eq!(rows(&path, 9).len(), 3);
        path
    });
    assert_eq!(long, short);
    let help = output("inverse-dynamics --help");
    assert!(help.contains("This is no inverse kinematics"), "{help}");
    for pose in ["0.5,0,0.2", "0.5,0,0.2,0,0,0"] {
        let message = errors(format!("inverse {pendulum} --to {pose}"), 2);
        assert_has(
            &message,
            [
                "expected 2, the positions of the joints that move",
                "`reach` finds the joint positions of a pose of the tip",
            ],
        );
    }
}

/// A motion is drawn besides, with a panel for each quantity and a curve for each joint.
#[test]
fn motions_are_drawn() {
    let pendulum = file("drawn.toml", PENDULUM);
    let brick = file("drawn_brick.toml", super::moving_base::BRICK);
    let path = folder("files").join("drawn.svg");
    let svg = path.to_string_lossy();
    for (call, labels) in [
        (
            format!("simulate {pendulum} --from 1,0"),
            vec!["position, rad", "torque, N m", "pivot", "knee", "energy, J"],
        ),
        (
            format!("inverse-dynamics {pendulum} --to 1,0"),
            vec!["velocity, rad/s", "torque, N m", "pivot", "knee"],
        ),
        (
            format!("simulate {brick} --velocity 1,0,0,0,0,0,1"),
            vec!["base, m", "yaw", "wheel", "energy, J"],
        ),
    ] {
        let _ = std::fs::remove_file(&path);
        let call = format!("{call} --samples 5");
        let drawn = output(format!("{call} --plot {svg}"));
        assert_eq!(drawn, output(&call));
        let figure = std::fs::read_to_string(&path).expect("a figure");
        assert!(figure.starts_with("<svg"), "{figure}");
        for label in labels {
            assert!(figure.contains(label), "{label}: {figure}");
        }
    }
    let lost = format!("simulate {pendulum} --plot {pendulum}");
    assert!(errors(&lost, 2).contains("expected a file that ends in `.svg`"));
    let raster = format!("simulate {pendulum} --plot fall.png");
    assert!(errors(&raster, 2).contains("the figure is in SVG"));
    let one = format!("simulate {pendulum} --plot {svg} --out {svg}");
    assert!(errors(&one, 2).contains("are one file"));
}

#[test]
fn measure_prints_times_and_errors() {
    let pendulum = file("measure.toml", PENDULUM);
    let text = output(format!(
        "measure {pendulum} --functions mass_matrix,forward_dynamics"
    ));
    // The times are not those of generated code.
    assert!(
        text.starts_with("function") && text.contains("interpreted, ns"),
        "{text}"
    );
    let errors: Vec<f64> = text
        .lines()
        .skip(1)
        .map(|line| {
            line.split_whitespace()
                .last()
                .and_then(|x| x.parse().ok())
                .expect("an error")
        })
        .collect();
    assert_eq!(errors.len(), 2, "{text}");
    assert!(
        errors.iter().all(|error| (0.0..1e-12).contains(error)),
        "{text}"
    );
}

/// Wherever an option takes a number it takes a value of the macro's words.
#[test]
fn options_take_values() {
    let pendulum = file("option_values.toml", PENDULUM);
    for [value, number] in [
        [
            "simulate --samples 3 --from PI/2,-deg(90) --velocity sqrt(4),1/4 --duration 1/2",
            "simulate --samples 3 --from 1.5707963267948966,-1.5707963267948966 --velocity 2,0.25 --duration 0.5",
        ],
        [
            "inverse --samples 3 --to deg(180),PI",
            "inverse --samples 3 --to 3.141592653589793,3.141592653589793",
        ],
        [
            "check --samples 3 --tolerance 1/1000 --gravity 0,-2*5,0",
            "check --samples 3 --tolerance 0.001 --gravity 0,-10,0",
        ],
        ["show --lock knee=PI/6", "show --lock knee=deg(30)"],
    ] {
        let [of_value, of_number] = [value, number].map(|line| {
            let mut words: Vec<&str> = line.split(' ').collect();
            words.insert(1, &pendulum);
            output(&words)
        });
        assert_eq!(of_value, of_number, "{value}");
    }
}
