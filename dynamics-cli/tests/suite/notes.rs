//! Notes on a file beside the output.

use super::calls::{Arguments, data, file, folder, output, run};

/// Lines that a call writes beside its output, if it succeeds.
fn told(call: impl Arguments) -> Vec<String> {
    let arguments = call.arguments();
    let output = run(&arguments);
    let errors = String::from_utf8(output.stderr).expect("text");
    assert!(output.status.success(), "{arguments:?}: {errors}");
    errors.lines().map(str::to_owned).collect()
}

const GRAVITY: &str = "--gravity 0,0,-9.81";

/// One line for each file, whatever reads it and however often.
#[test]
fn quarter_turns_of_some_digits_are_told() {
    let ur5 = data("urdf/ur5_robot.urdf");
    let to = folder("notes").join("ur5.c").to_string_lossy().into_owned();
    let rest = "5 angles, such as 1.57079632679, are taken as the multiples of a quarter turn";
    let zero = "0,0,0,0,0,0";
    for call in [
        format!("show {ur5} --functions gravity_vector"),
        format!("check {ur5} --functions gravity_vector"),
        format!("generate {ur5} --out {to} --lang c --functions gravity_vector"),
        format!("evaluate {ur5} --at {zero} --functions gravity_vector"),
        format!("convert {ur5}"),
    ] {
        let lines = told(format!("{call} {GRAVITY}"));
        let expected = format!("{ur5}: {rest}");
        assert!(
            lines.len() == 1
                && lines[0].starts_with(&expected)
                && lines[0].contains("`--round-angles 1e-9` says"),
            "{call:?}: {lines:?}"
        );
        let lines = told(format!("{call} {GRAVITY} --round-angles 1e-9"));
        assert_eq!(lines, [""; 0], "{call:?}");
    }
    let both = format!("check {ur5} --against {ur5} --functions mass_matrix");
    assert_eq!(told(format!("{both} {GRAVITY}")).len(), 1);
    let table = file(
        "few_digits.toml",
        "convention = \"modified\"\ngravity = [0, 0, -9.81]\n[[joint]]\nname = \"one\"\ntype = \"revolute\"\n\
         alpha = 1.570796327\nmass = 1\ncom = [0.1, 0, 0]\n",
    );
    let lines = told(format!("show {table}"));
    assert!(
        lines.len() == 1
            && lines[0].contains("One angle, 1.570796327, is taken")
            && lines[0].contains("`PI/2`"),
        "{lines:?}"
    );
}

#[test]
fn whoever_asks_for_base_parameters_is_told_of_angles_that_split_them() {
    let arm = data("files/nearly_right_angles.urdf");
    for function in ["regressor", "base_parameters"] {
        let call = format!("show {arm} --functions {function} {GRAVITY}");
        let lines = told(&call);
        assert!(
            lines.len() == 1
                && lines[0].contains("hardly tell 2 of the 24 base parameters apart")
                && lines[0].contains("3.1416 at `a`. ")
                && lines[0].contains("`--round-angles 1e-5` leaves 22"),
            "{lines:?}"
        );
        let rounded = told(format!("{call} --round-angles 1e-5"));
        assert_eq!(rounded, [""; 0]);
        let counted = output(format!("{call} --round-angles 1e-5"));
        assert!(
            counted.contains("\n     22  ") && !counted.contains("\n     23  "),
            "{counted}"
        );
    }
    let call = format!("show {arm} --functions inverse_dynamics");
    assert_eq!(told(format!("{call} {GRAVITY}")), [""; 0]);
}
