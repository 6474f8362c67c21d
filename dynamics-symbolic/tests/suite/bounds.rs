//! Bounds of rounding over the joint limits, in the documentation of generated methods. That the bounds hold is
//! measured in tests/files, on arms whose files have limits.

use dynamics_symbolic::robot::{Frame, JointType, Robot, Value};
use dynamics_symbolic::{Function, Request, expand};
use expect_test::expect_file;
use quote::quote;

/// The arm with a range of 4 rad or 0.4 m for each joint.
fn limited(mut robot: Robot) -> Robot {
    for row in &mut robot.rows {
        let end = match row.joint_type {
            JointType::Revolute => Value::integer(2),
            JointType::Prismatic => Value::from_f64(0.2).expect("a number"),
        };
        row.limits = Some([-end.clone(), end]);
    }
    robot
}

/// For each method the line about rounding, if there is one.
fn lines<R: Clone + Into<Request>>(robot: &Robot, requests: &[R]) -> Vec<(String, Option<String>)> {
    let methods = expand(robot, requests, &quote!(::robot_dynamics)).expect("proven");
    let line = |text: &str| {
        let start = text.find("\" Rounding: ")? + 1;
        let line = &text[start + 1..];
        Some(line[..line.find('"').unwrap_or(line.len())].to_owned())
    };
    let methods = methods.iter();
    let methods = methods.map(|method| {
        let name = method.request.name().to_owned();
        (name, line(&method.tokens.to_string()))
    });
    methods.collect()
}

fn listed(robot: &Robot, lines: Vec<(String, Option<String>)>) -> String {
    let mut text = format!("{}\n", robot.name);
    for (name, line) in lines {
        text += &format!("  {name}: {}\n", line.as_deref().unwrap_or("-"));
    }
    text
}

#[test]
fn documentation_says_how_large_rounding_errors_are_within_the_limits() {
    let mut text = String::new();
    for name in ["two_link_saha", "moving_mass", "puma560"] {
        let robot = limited(arms::robot(name));
        text += &listed(&robot, lines(&robot, &Function::ALL));
    }
    let robot = limited(arms::robot("ur5"));
    let parts = [
        Function::MassMatrix,
        Function::CoriolisVector,
        Function::ForwardDynamics,
    ];
    let fused = Request::fused("terms", parts);
    text += &listed(&robot, lines(&robot, &[fused]));
    for name in ["hyq", "panda_with_fingers"] {
        let mut robot = limited(arms::tree(name));
        robot.frames.push(Frame {
            name: "foot".to_owned(),
            on: Some(2),
            places: Vec::new(),
            body: None,
        });
        let at_foot = Request::of_frame(Function::Jacobian, robot.frames.len() - 1, "foot");
        let functions = Function::default_set(false).into_iter().map(Request::from);
        let requests: Vec<Request> = functions.chain([at_foot]).collect();
        text += &listed(&robot, lines(&robot, &requests));
    }
    expect_file!["../golden/bounds.txt"].assert_eq(&text);
}

#[test]
fn nothing_is_said_where_no_joint_has_limits() {
    for (name, line) in lines(&arms::robot("rrr_planar"), &Function::default_set(false)) {
        assert_eq!(line, None, "{name}");
    }
}

/// The values of fields are not known, nor the place of a joint that slides without limits.
#[test]
fn there_is_no_bound_of_what_is_not_known() {
    let functions = [Function::MassMatrix, Function::ForwardKinematics];
    let with_fields = limited(arms::with_inertial_fields("two_link_saha"));
    let mut slides = limited(arms::robot("scara"));
    let prismatic = slides.rows.iter_mut();
    let mut prismatic = prismatic.filter(|row| row.joint_type == JointType::Prismatic);
    prismatic.next().expect("a joint that slides").limits = None;
    for (robot, is_known) in [(with_fields, [false, true]), (slides, [true, false])] {
        for ((name, line), is_known) in lines(&robot, &functions).into_iter().zip(is_known) {
            let line = line.expect("a line");
            assert_eq!(line.contains("at most"), is_known, "{name}: {line}");
        }
    }
}
