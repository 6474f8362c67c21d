//! Notes on angles near a quarter turn.

use super::model;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/data/");

fn warnings(rest: &str) -> Vec<String> {
    let warnings = model(&format!("struct Arm; {rest}")).warnings;
    warnings
        .into_iter()
        .map(|warning| warning.message)
        .collect()
}

fn of_file(name: &str, rest: &str) -> Vec<String> {
    warnings(&format!(
        "file: \"{DATA}{name}\", gravity: [0, 0, -9.81], {rest}"
    ))
}

/// Two rows whose axes are at that angle, as it is written.
fn of_table(alpha: &str, rest: &str) -> Vec<String> {
    warnings(&format!(
        "convention: modified, gravity: [0, 0, -9.81], allow: [odd_angle], {rest} joints: [ \
         first: revolute {{ mass: 1, com: [0.1, 0.2, 0.3], inertia: sphere(0.1) }}, \
         second: revolute {{ a: 0.3, alpha: {alpha}, mass: 1, com: [0.1, 0.2, 0.3], inertia: sphere(0.1) }}]"
    ))
}

const MULTIPLE: &str = "of a quarter turn that the digits are";

/// Eleven digits of a quarter turn are taken for it, in each kind of description. All digits of a double, and what is asked
/// for, are no news.
#[test]
fn quarter_turns_of_some_digits_are_told_once() {
    for (found, expected) in [
        (
            of_file("urdf/ur5_robot.urdf", ""),
            "5 angles, such as 1.57079632679, are taken as the multiples",
        ),
        (
            of_file("urdf/anymal.urdf", "allow: [unphysical_inertia]"),
            "One angle, 3.14159265359, is taken as the multiple",
        ),
        (
            of_table("1.57079632679", ""),
            "One angle, 1.57079632679, is taken as the multiple",
        ),
        (
            of_table("-PI + 1e-10", "tool: { rpy: [0, 1.570796327, 0] },"),
            "2 angles, such as 1.570796327, are taken as the multiples",
        ),
    ] {
        assert_eq!(found.len(), 1, "{found:#?}");
        assert!(
            found[0].contains(expected) && found[0].contains(MULTIPLE),
            "{found:?}"
        );
    }
    let told = of_file("urdf/ur5_robot.urdf", "").concat();
    assert!(
        told.contains("5e-12 rad") && told.contains("`round_angles: 1e-9` says"),
        "{told}"
    );
    // `round_angles` is for the file.
    let beside = of_file("urdf/panda.urdf", "base: { rpy: [0, 1.570796327, 0] }");
    assert!(
        beside.concat().contains("A multiple of `PI/2` says"),
        "{beside:?}"
    );
    let none: [String; 0] = [];
    assert_eq!(of_file("urdf/panda.urdf", ""), none);
    assert_eq!(of_file("urdf/ur5_robot.urdf", "round_angles: 1e-9"), none);
    for alpha in ["1.5707963267948966", "PI/2", "deg(90)", "0.3", "0"] {
        assert_eq!(of_table(alpha, ""), none, "{alpha}");
    }
}

/// Torques tell base parameters apart by 4e-6 of their size only, if an axis is so far from a quarter turn. Only who asks for them
/// is told, and only of the angles that do it.
#[test]
fn angles_that_split_base_parameters_are_told_to_whom_asks_for_these() {
    let file = "files/nearly_right_angles.urdf";
    for functions in [
        "[regressor]",
        "[base_parameters]",
        "[mass_matrix, both = (inverse_dynamics, regressor)]",
    ] {
        let told = of_file(file, &format!("functions: {functions}"));
        assert_eq!(told.len(), 1, "{told:#?}");
        for expected in [
            "hardly tell 2 of the 24 base parameters apart",
            "quarter turns: 3.1416 at `a`.",
            "`round_angles: 1e-5` leaves 22 base parameters",
        ] {
            assert!(told[0].contains(expected), "{expected}: {told:?}");
        }
    }
    let none: [String; 0] = [];
    assert_eq!(of_file(file, "functions: [inverse_dynamics]"), none);
    assert_eq!(
        of_file(file, "functions: [regressor], round_angles: 1e-5"),
        none
    );
    let regressor = "functions: [regressor],";
    let told = of_table("3.1416", regressor);
    assert!(
        told.len() == 1 && told[0].contains("3.1416 at `second`. ") && told[0].contains("`PI/2`"),
        "{told:?}"
    );
    // A tilt of the world is no matter of torques, and 3 degrees are no quarter turn.
    for alpha in ["PI", "0.05"] {
        assert_eq!(of_table(alpha, regressor), none, "{alpha}");
    }
}

/// The struct's documentation has the notes.
#[test]
fn the_documentation_of_a_struct_has_them() {
    let call = |rest: &str| {
        let call = format!(
            "struct Arm; file: \"{DATA}{rest}, gravity: [0, 0, -9.81], functions: [regressor]"
        );
        crate::outline(call.parse().expect("the source lexes")).to_string()
    };
    let arm = call("files/nearly_right_angles.urdf\"");
    assert!(
        arm.contains("hardly tell 2 of the 24 base parameters"),
        "{arm}"
    );
    let ur5 = call("urdf/ur5_robot.urdf\"");
    assert!(ur5.contains(MULTIPLE), "{ur5}");
}
