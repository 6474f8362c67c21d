//! The messages that `tests/mistakes` does not show, and the rules on
//! which errors are reported together.

use super::*;

#[test]
fn nothing_at_all() {
    assert_eq!(
        message(""),
        "expected `struct Name;` or `struct Name { field: f64 }`, then the robot's table"
    );
}

#[test]
fn an_error_hides_no_other() {
    let rows = "one: revolute { mass: , a: 1/0, com: [1, x, ?], motor: { inertia: 1 } },
                two: { mass: -1 }, one: prismatic { d: d2 }";
    assert_eq!(messages(&with_rows(rows)).len(), 9);
}

#[test]
fn nothing_is_said_twice() {
    for call in [
        // The value in error is used, the wrong key was meant to be one that is needed.
        "struct Arm; let m = ; convention: standard, gravity: [0, 0, m], joints: [j: revolute { mass: m }]",
        "struct Arm { g: f64 } convention: standard, gravty: [0, 0, -g], joints: [j: revolute {}]",
        // The field is used in a value that cannot be read.
        "struct Arm { g: f64 } convention: standard, gravity: [0, -g], joints: [j: revolute {}]",
        "struct Arm { l: f64 } convention: standard, gravity: [0, 0, 0], joints: [j: revolute { b: l }]",
        // Nothing more is known of a solid without a readable mass.
        "struct Arm; convention: standard, gravity: [0, 0, 0], joints: [j: revolute { mass: ?, inertia: rod(1) }]",
        // A part that could not be read may be the one that is missed elsewhere.
        "struct Arm; convention, gravity: [0, 0, 0], joints: [j: revolute {}]",
        "struct Arm; convention: standard, gravity: [0, 0, 0], joints: [j: revolute { weight: 1, inertia: rod(1) }]",
        "struct Arm; convention: standard, gravity: [0, 0, 0], joints: [j: revolute { motor: { inertia: 1, ratio: 2 } }]",
        "struct Arm; convention: standard, gravity: [0, 0, 0], joints: [j: revolute { mass: 1, inertia: { Ixx: 1, yy: 1, zz: 2 } }]",
        "struct Arm; m = 1; convention: standard, gravity: [0, 0, 0], joints: [j: revolute { mass: m }]",
        // Rust in place of the table's own words.
        "struct Arm; let mut m = 3; convention: standard, gravity: [0, 0, 0], joints: [j: revolute { mass: m }]",
        "struct Arm; const M: f64 = 3.0; convention: standard, gravity: [0, 0, 0], joints: [j: revolute { mass: M }]",
        "struct Arm; const M: f64; convention: standard, gravity: [0, 0, 0], joints: [j: revolute { mass: M }]",
        "struct Arm { m, l: f64 } convention: standard, gravity: [0, 0, 0], joints: [j: revolute { mass: m, a: l }]",
        "struct Arm { m: f64 = 1.0 } convention: standard, gravity: [0, 0, 0], joints: [j: revolute { mass: m }]",
        "struct Arm { l: f64 } convention: standard, gravity: [0, 0, 0], joints: [revolute(j, a: l)]",
        "struct Arm { l: f64 } convention: standard, gravity: [0, 0, 0], joints: [j: revolute { a: l**2 }]",
        "struct Arm; convention: standard, gravity: [0, 0, 0], joints: [_: revolute {}]",
        // The slip was a key that stands there already.
        "struct Arm; convention: standard, gravity: [0, 0, 0], joints: [j: revolute { mass: 1, masss: 2 }]",
    ] {
        message(call);
    }
}

#[test]
fn without_a_struct_no_name_is_unknown() {
    let call = "convention: standard, gravity: [0, 0, g], joints: [j: revolute { mass: m / 0 }]";
    let messages = messages(call);
    assert_eq!(messages.len(), 2, "{messages:#?}");
    assert_eq!(messages[1], "division by zero");
}

#[test]
fn a_zero_that_only_algebra_sees() {
    for divisor in [
        "(m + l) * (m - l) - m * m + l * l",
        "PI / 2 - deg(90)",
        "m / l - m / l",
    ] {
        let call = format!(
            "struct Arm {{ m: f64, l: f64 }} convention: standard, gravity: [0, 0, 0],
             joints: [j: revolute {{ a: 1 / ({divisor}), mass: m, d: l }}]"
        );
        assert_eq!(message(&call), "division by zero", "{divisor}");
    }
}

#[test]
fn a_quotient_that_may_be_finite() {
    model(
        "struct Arm { m: f64, l: f64 } convention: standard, gravity: [0, 0, 0],
         joints: [j: revolute { a: 1 / (m - l), d: 1 / (PI - 3.14159), mass: 1 }],
         allow: [odd_length]",
    );
}

#[test]
fn tensors_that_no_body_has() {
    for (tensor, reason) in [
        ("xx: -1", "a moment of inertia is negative"),
        ("xx: m, yy: -0.1", "a moment of inertia is negative"),
        ("xy: 1", "one of its principal moments is negative"),
        (
            "xx: 1, yy: 1, zz: 1, xy: 2",
            "one of its principal moments is negative",
        ),
        (
            "xx: 1, yy: 1, zz: 2.1",
            "the largest principal moment exceeds the sum of the other two",
        ),
        (
            "xx: 1, zz: 5",
            "the largest principal moment exceeds the sum of the other two",
        ),
        // Each diagonal entry is at most the sum of the others here.
        (
            "xx: 2, yy: 2, zz: 1, xy: 0.9",
            "the largest principal moment exceeds the sum of the other two",
        ),
        (
            "xx: PI, yy: PI, zz: 7",
            "the largest principal moment exceeds the sum of the other two",
        ),
    ] {
        let call = format!(
            "struct Arm {{ m: f64 }} convention: standard, gravity: [0, 0, 0],
             joints: [j: revolute {{ mass: m, inertia: {{ {tensor} }} }}]"
        );
        let message = message(&call);
        assert!(message.contains(reason), "{tensor}: {message}");
        assert!(message.contains("allow: [unphysical_inertia]"));
    }
}

#[test]
fn the_joint_s_own_variable_is_not_written() {
    let variable = message(&with_rows("j: prismatic { d: q1 }"));
    assert!(variable.ends_with("(the joint's own variable is not written: it is added to `d`)"));
    let other = message(&with_rows("j: prismatic { theta: q1 }"));
    assert!(!other.contains("variable"));
}

#[test]
fn keywords_are_no_names() {
    let table = "convention: standard, gravity: [0, 0, 0], joints: [j: revolute {}]";
    let found = |head: &str| message(&format!("{head} {table}"));
    assert_eq!(
        found("struct match;"),
        "expected the struct's name, found the keyword `match`: write `r#match`, or another name"
    );
    assert_eq!(
        found("struct Self;"),
        "expected the struct's name, found the keyword `Self`"
    );
    assert_eq!(
        found("struct Arm { type: f64 }"),
        "expected a field: `name: f64`, found the keyword `type`: write `r#type`, or another name"
    );
}

#[test]
fn a_slip_in_front_of_struct() {
    let call = with_cells("mass: 1");
    let tokens = |start: &str| format!("{start} {call}").parse().expect("the source lexes");
    for start in ["pup", "public", "fn"] {
        let items = crate::generate_by(tokens(start), &dynamics_symbolic::derive::derive_together)
            .to_string();
        assert_eq!(items.matches("compile_error").count(), 1, "{items}");
        assert!(items.contains("struct Arm ;"), "{items}");
    }
}

/// The start of the message about a cell.
const DEGREES: &str = "angles are in radians: write `deg(";
const NEARLY: &str = "nearly a right angle: write `";
const LONG: &str = "an angle of more than a turn, ";
const OF_RADIANS: &str = "`deg` takes degrees, and ";

/// Each angle is reported where it stands, and accepted where the row or the table allows it.
#[test]
fn odd_angles_are_allowed_by_name() {
    for (angle, start) in [
        ("90", DEGREES),
        ("-180.0", DEGREES),
        ("- 45", DEGREES),
        ("57", DEGREES),
        ("85.5", DEGREES),
        ("3.6e2", DEGREES),
        ("6.3", DEGREES),
        ("4", DEGREES),
        ("5.0", DEGREES),
        ("-6", DEGREES),
        ("1.5708", NEARLY),
        ("-1.57", NEARLY),
        ("1.570796", NEARLY),
        ("3.14159", NEARLY),
        ("4.712", NEARLY),
        ("-6.2832", NEARLY),
        ("3.1416 / 2", NEARLY),
        ("deg(89.99)", NEARLY),
        ("deg(400)", LONG),
        ("deg(1.5708)", OF_RADIANS),
        ("deg(-3.14)", OF_RADIANS),
        ("deg(PI/2)", OF_RADIANS),
        ("twist", NEARLY),
    ] {
        for cell in ["alpha", "theta"] {
            let cells = |more: &str| {
                let call = with_cells(&format!("{cell}: {angle}, {more}"));
                call.replace("Arm;", "Arm; let twist = 1.5708;")
            };
            let message = message(&cells(""));
            assert!(message.starts_with(start), "{angle}: {message}");
            assert!(message.contains("(`allow: [odd_angle]` on the row accepts"));
            model(&cells("allow: [odd_angle]"));
            model(&cells("").replace("odd_mass]", "odd_mass, odd_angle]"));
        }
    }
}

/// Small angles are what a calibration finds; what is computed, or depends on a field, was thought about.
#[test]
fn angles_that_are_not_odd() {
    for cell in [
        "alpha: deg(90)",
        "alpha: PI/2",
        "alpha: 1.5707963268",
        "theta: -3*PI/2",
        "theta: 6.28318530718",
        "theta: deg(360)",
        "alpha: 0.001",
        "alpha: -1e-6",
        "alpha: PI/2 + 0.003",
        "alpha: PI/2 - deg(0.1)",
        "theta: 1.5",
        "theta: 3",
        "theta: 3.5",
        "alpha: -5.25",
        "theta: 1 * 5",
        "theta: 1 * 90",
        "theta: 5*PI/2",
        "theta: deg(11)",
        "theta: x",
        "theta: deg(x)",
        "alpha: x + 1.5708",
        "a: 90",
        "limits: [-1.57, 1.57]",
        "d: 1.5708",
    ] {
        model(&with_cells(&format!("{cell}, mass: x")).replace("Arm;", "Arm { x: f64 }"));
    }
}

/// Angles that stand in no row are allowed at the end of the table.
#[test]
fn odd_angles_elsewhere() {
    let call = |entry: &str, allow: &str| {
        with_cells("mass: 1")
            .replace(
                "allow: [no_inertia, odd_length, odd_mass],",
                &format!("{entry} {allow}"),
            )
            .replace(
                "joint:",
                "slide: prismatic { mass: 1 }, turn: revolute {}, joint:",
            )
    };
    for (entry, start) in [
        ("base: { rpy: [1.5708, 0, 0] },", NEARLY),
        ("lock: [turn = 90],", DEGREES),
        ("lock: [turn = -1.5708],", NEARLY),
        ("lock: [turn = deg(PI/2)],", OF_RADIANS),
        ("let twist = deg(PI);", OF_RADIANS),
    ] {
        let message = message(&call(entry, ""));
        assert!(message.starts_with(start), "{entry}: {message}");
        assert!(
            message.contains("at the end of the table accepts"),
            "{message}"
        );
        model(&call(entry, "allow: [odd_angle]"));
    }
    let tool = message(&call("tool: { rpy: [0, 0, 45] },", ""));
    assert!(tool.contains("on the tool accepts 45 rad"), "{tool}");
    model(&call("tool: { rpy: [0, 0, 45], allow: [odd_angle] },", ""));
    // A joint that slides has no angle, one that turns often has limits that say so.
    model(&call("lock: [slide = 1.5708],", ""));
    let turns = |position: &str| {
        let call = call(&format!("lock: [turn = {position}],"), "");
        call.replace("turn: revolute {}", "turn: revolute { limits: [-30, 30] }")
    };
    model(&turns("20"));
    assert!(message(&turns("40")).contains("outside of the limits"));
}

/// Masses, centres of mass and gravity that were hardly meant.
#[test]
fn odd_bodies_are_allowed_by_name() {
    let call = |cells: &str, entry: &str| {
        format!(
            "struct Arm; convention: standard, gravity: [0, 0, -9.81],
             joints: [first: revolute {{ a: 0.4, {cells} }}, second: revolute {{}}], {entry}"
        )
    };
    for (cells, what, word) in [
        (
            "com: [0.1, 0, 0]",
            "a centre of mass without a mass",
            "odd_mass",
        ),
        (
            "inertia: { xx: 1, yy: 1, zz: 1 }",
            "a tensor without a mass",
            "odd_mass",
        ),
        (
            "mass: 1, com: [-200, 0, 0]",
            "a centre of mass 200 m from",
            "odd_com",
        ),
        (
            "mass: 1, com: [0, 0, 4.1]",
            "a centre of mass 4.1 m from",
            "odd_com",
        ),
    ] {
        let message = message(&call(cells, ""));
        assert!(message.starts_with(what), "{message}");
        assert!(
            message.contains(&format!("allow: [{word}]` on the row")),
            "{message}"
        );
        let elsewhere = "tool: { mass: 1 },";
        model(&call(&format!("{cells}, allow: [{word}]"), elsewhere));
        model(&call(cells, &format!("allow: [{word}], {elsewhere}")));
    }
    for good in [
        "mass: 1, com: [3.9, 0, 0]",
        // As the PUMA's first link was published, and a mass that is said to be none.
        "inertia: { yy: 0.35 }",
        "mass: 0, com: [0.1, 0, 0], inertia: { xx: 1, yy: 1, zz: 1 }",
        "com: [0, 0, 0], inertia: { yy: 1 }",
        "motor: { inertia: 1, gear_ratio: 2 }",
    ] {
        model(&call(good, ""));
    }
    let massless = message(&call("a: 0, mass: 0", "").replace("a: 0.4, ", ""));
    assert!(
        massless.starts_with("no link of this arm has a mass"),
        "{massless}"
    );
    model(&call("", "functions: [forward_kinematics, jacobian],"));
    model(&call("", "tool: { mass: 1 },"));
    model(&call("", "allow: [no_inertia],"));
    // An arm without a length has nothing to compare with.
    model(&call("mass: 1, com: [1, 0, 0]", "").replace("a: 0.4, ", ""));
    // A joint that slides is as long as its limits say.
    let slide = |limits: &str| {
        call("mass: 1, com: [6, 0, 0]", "").replace(
            "second: revolute {}",
            &format!("second: prismatic {{ {limits} }}"),
        )
    };
    model(&slide(""));
    model(&slide("limits: [0, 0.6]"));
    assert!(message(&slide("limits: [0, 0.5]")).contains("longest part is 0.5 m"));
    let of_tool = message(&call("mass: 1", "tool: { mass: 1, com: [0, 0, 50] },"));
    assert!(
        of_tool.contains("`allow: [odd_com]` on the tool"),
        "{of_tool}"
    );
}

#[test]
fn gravity_as_it_is_nowhere() {
    let call = |gravity: &str| with_cells("mass: 1").replace("[0, 0, -9.81]", gravity);
    for odd in [
        "[0, 0, -9810]",
        "[0, 0, -981]",
        "[0, 0.5, 0]",
        "[0, 0, 30.1]",
        "[9.81, 9.81, 9.81]",
        "[-9.81, -9.81, -9.81]",
        "[9.8, -9.8, 9.8]",
        "[981, 981, 981]",
    ] {
        let message = message(&call(odd));
        assert!(message.starts_with("gravity of "), "{message}");
        model(&call(odd).replace("odd_mass]", "odd_gravity]"));
    }
    for usual in [
        "[0, 0, 0]",
        "[0, 0, -1]",
        "[6, 0, 8]",
        "[0, -g, 0]",
        "[-g, -g, -g]",
        // An arm that hangs along the diagonal of its axes.
        "[-5.664, -5.664, -5.664]",
        "[0, 0, 24.79]",
    ] {
        model(
            &call(usual)
                .replace("Arm;", "Arm { g: f64 }")
                .replace("mass: 1", "mass: g"),
        );
    }
    let word = message(&with_cells("allow: [odd_gravity]"));
    assert!(
        word.ends_with("write `allow: [odd_gravity]` at the end of the table"),
        "{word}"
    );
}

#[test]
fn a_table_is_finite() {
    for value in ["NAN", "inf", "INFINITY", "NaN"] {
        let message = message(&with_cells(&format!("a: -{value}")));
        assert_eq!(
            message,
            format!("unknown name `{value}`: every number of a table is finite")
        );
    }
}
