//! Arms of more joints than most have.

use super::calls::{assert_has, file, output};

/// Rods of which each hangs from the one before, about axes that alternate.
fn chain(joints: usize) -> String {
    let row = |index: usize| {
        let twist = if index.is_multiple_of(2) {
            "PI/2"
        } else {
            "-PI/2"
        };
        format!(
            "[[joint]]\nname = \"j{index}\"\ntype = \"revolute\"\na = 0.3\nalpha = \"{twist}\"\nmass = 1\n\
             com = [0.15, 0.02, 0]\ninertia = {{ xx = 0.01, yy = 0.011, zz = 0.012 }}\n"
        )
    };
    let rows: String = (0..joints).map(row).collect();
    format!("convention = \"modified\"\ngravity = [0, 0, -9.81]\n{rows}")
}

#[test]
fn long_arms_are_compared_with_newton_euler() {
    let arm = file("twenty.toml", chain(20));
    let functions = "--functions mass_matrix,gravity_vector --samples 2";
    let text = output(format!("check {arm} {functions}"));
    assert_has(&text, ["mass_matrix", "ok"]);
    let arm = file("forty.toml", chain(40));
    let functions = "--functions gravity_vector --samples 2";
    let text = output(format!("check {arm} {functions}"));
    assert!(text.contains("ok"), "{text}");
}

/// The default functions of more joints than most humanoids have, and of a hand in which 40 fingers follow one joint.
#[test]
fn robots_of_many_joints_are_checked_and_shown() {
    let long = file("seventy.toml", chain(70));
    let follow: Vec<String> = (1..=40)
        .map(|k| format!("j{k} = \"0.{k} * j0 + 0.1\""))
        .collect();
    let hand = format!("{}[couple]\n{}\n", chain(42), follow.join("\n"));
    for path in [long, file("forty_fingers.toml", hand)] {
        let text = output(format!("check {path} --samples 1"));
        assert_has(&text, ["forward_dynamics", "ok"]);
        let text = output(format!("show {path} --functions gravity_vector"));
        assert!(text.contains("j0"), "{text}");
    }
}

/// Twelve joints fall for a moment, and keep their energy.
#[test]
fn long_arms_fall() {
    let arm = file("twelve.toml", chain(12));
    let text = output(format!("simulate {arm} --duration 0.02 --samples 3"));
    let rows: Vec<Vec<f64>> = text
        .lines()
        .skip(1)
        .map(|line| {
            line.split(',')
                .map(|x| x.parse().expect("a number"))
                .collect()
        })
        .collect();
    // The last two columns are the kinetic and the potential energy.
    let energies: Vec<f64> = rows
        .iter()
        .map(|row| row.iter().rev().take(2).sum())
        .collect();
    assert_eq!(energies.len(), 3);
    let worst = energies.iter().map(|energy| (energy - energies[0]).abs());
    assert!(worst.fold(0.0, f64::max) < 1e-6, "{energies:?}");
    let positions = &rows[2][1..=12];
    assert!(positions.iter().all(|q| *q != 0.0), "{positions:?}");
}

/// Forty joints move from zero to one together: half way at half the time.
#[test]
fn the_torques_of_long_arms_are_found() {
    let arm = file("forty.toml", chain(40));
    let to = ["1"; 40].join(",");
    let text = output(format!("inverse {arm} --to {to} --samples 3"));
    let middle = text.lines().nth(2).expect("a row");
    let row: Vec<f64> = middle
        .split(',')
        .map(|x| x.parse().expect("a number"))
        .collect();
    assert_eq!(row.len(), 1 + 4 * 40);
    assert_eq!(row[0], 0.5);
    assert!(
        row[1..=40].iter().all(|q| (q - 0.5).abs() < 1e-15),
        "{middle}"
    );
    assert!(
        row[121..].iter().any(|torque| torque.abs() > 1.0),
        "{middle}"
    );
}
