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
        // Of a solid without a readable mass nothing more is known.
        "struct Arm; convention: standard, gravity: [0, 0, 0], joints: [j: revolute { mass: ?, inertia: rod(1) }]",
        // What could not be read may be what is missed elsewhere.
        "struct Arm; convention, gravity: [0, 0, 0], joints: [j: revolute {}]",
        "struct Arm; convention: standard, gravity: [0, 0, 0], joints: [j: revolute { weight: 1, inertia: rod(1) }]",
        "struct Arm; convention: standard, gravity: [0, 0, 0], joints: [j: revolute { motor: { inertia: 1, ratio: 2 } }]",
        "struct Arm; convention: standard, gravity: [0, 0, 0], joints: [j: revolute { inertia: { Ixx: 1, yy: 1, zz: 2 } }]",
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
         joints: [j: revolute { a: 1 / (m - l), d: 1 / (PI - 3.14159) }]",
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

#[test]
fn degrees_are_not_taken_for_radians() {
    for cell in ["alpha: 90", "theta: -180.0", "alpha: - 45", "theta: 3.6e2"] {
        let message = message(&with_cells(cell));
        assert!(
            message.starts_with("angles are in radians: write `deg("),
            "{message}"
        );
    }
    let negative = message(&with_cells("alpha: -90"));
    assert!(negative.contains("`deg(90)`"), "{negative}");
    for cell in [
        "alpha: deg(90)",
        "alpha: 1 * 90",
        "theta: 15",
        "theta: 91",
        "alpha: 1e6",
        "a: 90",
    ] {
        model(&with_cells(cell));
    }
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
