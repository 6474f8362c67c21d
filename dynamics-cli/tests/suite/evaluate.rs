//! The values of all functions at one state.

use super::calls::{PENDULUM, assert_has, errors, file, output, refused};
use super::moving_base::BRICK;

/// The lines of a function's section.
#[track_caller]
fn section<'t>(text: &'t str, function: &str) -> Vec<&'t str> {
    let mut lines = text.lines().skip_while(|line| *line != function);
    assert_eq!(lines.next(), Some(function), "{text}");
    lines.take_while(|line| !line.is_empty()).collect()
}

/// The numbers at the end of the last lines of a section.
#[track_caller]
fn numbers<const ROWS: usize, const COLUMNS: usize>(
    text: &str,
    function: &str,
) -> [[f64; COLUMNS]; ROWS] {
    let lines = section(text, function);
    let lines: [&str; ROWS] = lines[lines.len() - ROWS..].try_into().expect("rows");
    lines.map(|line| {
        let words: Vec<&str> = line.split_whitespace().collect();
        let words: [&str; COLUMNS] = words[words.len() - COLUMNS..].try_into().expect("columns");
        words.map(|word| word.parse().unwrap_or_else(|_| panic!("{line}")))
    })
}

/// Two rods that hang at an angle and turn, against the textbook's formulas.
#[test]
fn all_functions_at_a_state() {
    let pendulum = file("evaluate.toml", PENDULUM);
    let at = "PI/6,deg(60),1,-2,0.5,0.25";
    let text = output(format!("evaluate {pendulum} --at {at} --digits 17"));
    let sections: Vec<&str> = text
        .lines()
        .filter(|line| line.starts_with(|c: char| c.is_lowercase()) && !line.contains(' '))
        .collect();
    assert_eq!(sections[0], "forward_kinematics", "{text}");
    for function in ["mass_matrix", "inverse_dynamics", "kinetic_energy"] {
        assert!(sections.contains(&function), "{text}");
    }
    for line in ["pivot", "knee"] {
        assert!(text.contains(&format!("\n{line}  ")), "{text}");
    }
    assert_has(&text, ["-2 rad/s", "0.25 rad/s^2"]);
    assert!(text.contains("Mass matrix M(q)"), "{text}");
    // m1 = 2 at 1/2 of a rod of 1, m2 = 1 at 1/4 of the second rod.
    let (c2, s2) = (0.5, 3f64.sqrt() / 2.0);
    let [[m11, m12], [m21, m22]] = numbers::<2, 2>(&text, "mass_matrix");
    let coupled = 0.0625 + 0.25 * c2;
    assert_eq!(m12, m21);
    assert!((m12 - coupled - (m22 - 0.0625)).abs() < 1e-15, "{text}");
    let [[v1], [v2]] = numbers::<2, 1>(&text, "coriolis_vector");
    assert!(
        (v1 - -0.25 * s2 * (2.0 * 1.0 * -2.0 + 4.0)).abs() < 1e-15,
        "{text}"
    );
    assert!((v2 - 0.25 * s2).abs() < 1e-15, "{text}");
    let [[g1], [g2]] = numbers::<2, 1>(&text, "gravity_vector");
    let [[tau1], [tau2]] = numbers::<2, 1>(&text, "inverse_dynamics");
    assert!(
        (tau1 - (m11 * 0.5 + m12 * 0.25 + v1 + g1)).abs() < 1e-13,
        "{text}"
    );
    assert!(
        (tau2 - (m21 * 0.5 + m22 * 0.25 + v2 + g2)).abs() < 1e-13,
        "{text}"
    );
    let [[t]] = numbers::<1, 1>(&text, "kinetic_energy");
    assert!(
        (t - (0.5 * m11 - 2.0 * m12 + 2.0 * m22)).abs() < 1e-14,
        "{text}"
    );
}

/// The torques under which forward dynamics is evaluated give the accelerations back; the list may be in three parts.
#[test]
fn forward_dynamics_undoes_inverse_dynamics() {
    let pendulum = file("evaluate_back.toml", PENDULUM);
    let call = |more: &str| {
        let parts = "--at 0.3,1 --at 0.5,-1 --at 2,3";
        let digits = "--digits 17";
        output(format!("evaluate {pendulum} {parts} {digits} {more}"))
    };
    let text = call("--functions inverse_dynamics");
    let [[tau1], [tau2]] = numbers::<2, 1>(&text, "inverse_dynamics");
    let torque = format!("{tau1},{tau2}");
    let text = call(&format!("--functions forward_dynamics --torque {torque}"));
    let [[a1], [a2]] = numbers::<2, 1>(&text, "forward_dynamics");
    assert!(
        (a1 - 2.0).abs() < 1e-12 && (a2 - 3.0).abs() < 1e-12,
        "{text}"
    );
}

/// Lengths that are left out are zeros; others are told with what each of them means.
#[test]
fn counts_are_those_of_the_joints() {
    let pendulum = file("evaluate_counts.toml", PENDULUM);
    let all = output(format!("evaluate {pendulum}"));
    assert_eq!(all, output(format!("evaluate {pendulum} --at 0,0,0,0,0,0")));
    assert_eq!(all, output(format!("evaluate {pendulum} --at 0,0")));
    for (at, expected) in [
        (
            "1",
            "`--at` has 1 number: expected 2, one position for each joint that moves, 4 with the 2 velocities behind \
             them, or 6 with the 2 accelerations too",
        ),
        ("1,2,3", "`--at` has 3 numbers"),
        ("1,2,3,4,5,6,7", "`--at` has 7 numbers"),
        ("1,x", "invalid value 'x' for '--at"),
    ] {
        refused(format!("evaluate {pendulum} --at {at}"), 2, [expected]);
    }
    refused(
        format!("evaluate {pendulum} --pose 0,0,0,0,0,0"),
        2,
        ["this one stands"],
    );
}

/// A tree has the pose of each frame and of each end; functions without their arguments are named.
#[test]
fn frames_and_functions_without_arguments() {
    let frames = format!("{PENDULUM}[frame.camera]\non = \"pivot\"\nxyz = [0.25, 0, 0]\n");
    let pendulum = file("evaluate_frames.toml", frames);
    let asked = "--functions jacobian(camera),wrench_torques";
    let at = "--at PI/2,0";
    let text = output(format!("evaluate {pendulum} {asked} {at}"));
    let poses: Vec<&str> = ["forward_kinematics", "forward_kinematics_camera"]
        .map(|name| section(&text, name).pop().expect("a place"))
        .to_vec();
    assert!(
        poses[0].ends_with("1, 0] m  rpy [0, 0, 1.5708] rad"),
        "{text}"
    );
    assert!(
        poses[1].ends_with("0.25, 0] m  rpy [0, 0, 1.5708] rad"),
        "{text}"
    );
    let [turning] = numbers::<1, 2>(&text, "jacobian_camera");
    assert_eq!(turning, [1.0, 0.0], "the row of wz: {text}");
    assert!(text.contains("wrench_torques(q, wrench)"), "{text}");
}

/// A tree without a tip has the pose of each end.
#[test]
fn ends_of_a_tree() {
    let branch = "[[joint]]\nname = \"ankle\"\ntype = \"revolute\"\non = \"pivot\"\na = 0.5\nmass = 1\ncom = [0.25, 0, 0]\n";
    let tree = file("evaluate_tree.toml", format!("{PENDULUM}{branch}"));
    let asked = "--functions mass_matrix";
    let text = output(format!("evaluate {tree} --at PI,0,PI/2 {asked}"));
    for (function, place) in [
        ("forward_kinematics_knee", "xyz [-1, "),
        ("forward_kinematics_ankle", "xyz [-0.5, "),
    ] {
        let line = section(&text, function).pop().expect("a place");
        assert!(line.trim_start().starts_with(place), "{text}");
    }
    let mass_matrix = numbers::<3, 3>(&text, "mass_matrix");
    assert_eq!((mass_matrix[1][2], mass_matrix[2][1]), (0.0, 0.0));
}

/// On a base that moves positions are those of the joints, and velocities begin with six of the base.
#[test]
fn a_base_that_moves() {
    let brick = file("evaluate_brick.toml", BRICK);
    let text = output(format!(
        "evaluate {brick} --at 0.5,1,0,0,0,0,0,2 --pose 1,2,3,0,0,PI/2"
    ));
    assert_has(&text, ["base at xyz [1, 2, 3] m  rpy [0, 0, 1.5708] rad"]);
    let [[energy]] = numbers::<1, 1>(&text, "kinetic_energy");
    // Two kilograms and half of one at 1 m/s, and the wheel at 2 rad/s.
    assert!(
        (energy - (0.5 * 2.5 + 0.5 * 0.002 * 4.0)).abs() < 1e-6,
        "{text}"
    );
    let message = errors(format!("evaluate {brick} --at 1,2"), 2);
    assert_has(
        &message,
        [
            "expected 1, one position for each joint that moves, 8 with the 7 velocities behind them, or 15",
            "six of the base before those of the joints",
        ],
    );
}

/// Where M is singular the other values are printed, and the status is 1.
#[test]
fn singular_matrices_are_told() {
    let massless = "convention = 'modified'\ngravity = [0, -9.81, 0]\nallow = ['no_inertia']\nfunctions = \
                    ['forward_dynamics', 'mass_matrix']\n[[joint]]\nname = 'pivot'\ntype = 'revolute'\n";
    let massless = file("evaluate_massless.toml", massless);
    refused(
        format!("evaluate {massless}"),
        1,
        ["`forward_dynamics`: ", "positive definite"],
    );
}
