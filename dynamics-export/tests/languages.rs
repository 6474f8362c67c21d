//! The text of functions in other languages: readable, and the same each time. That their values are
//! those of Rust is a test of `dynamics-evaluation`.

use dynamics_export::{
    CNumbers, c_project, c_source, casadi_requests, casadi_source, javascript_module, matlab_files,
    python_module,
};
use dynamics_symbolic::bounds::rounding;
use dynamics_symbolic::function::Part;
use dynamics_symbolic::robot::{Frame, Value};
use dynamics_symbolic::{Function, Request, expand, proven_program};
use expect_test::expect_file;

#[test]
fn two_link_arm_in_other_languages() {
    let robot = arms::two_link_craig();
    let functions = Function::default_set(false).into_iter().map(Request::from);
    let program = |request: Request| {
        let program = proven_program(&robot, &request).expect("proven");
        (request, program)
    };
    let programs: Vec<_> = functions.map(program).collect();
    let files = c_source(&robot, &programs);
    expect_file!["golden/two_link_craig.h"].assert_eq(&files.header);
    expect_file!["golden/two_link_craig.c"].assert_eq(&files.source);
    expect_file!["golden/two_link_craig.mjs"].assert_eq(&javascript_module(&robot, &programs));
    expect_file!["golden/two_link_craig.py"].assert_eq(&python_module(&robot, &programs));
    let files = matlab_files(&robot, &programs).into_iter();
    let texts: Vec<_> = files
        .map(|(name, text)| format!("% {name}\n{text}"))
        .collect();
    expect_file!["golden/two_link_craig.m"].assert_eq(&texts.join("\n"));
}

/// Characters that nobody sees, or that turn the direction of writing, stand in no comment: compilers refuse them there.
#[test]
fn names_cannot_hide_code_in_comments() {
    let hidden = ['\u{202e}', '\u{200b}', '\u{feff}', '\u{7}'];
    let name = format!("a*/b{} ??/ \\", String::from_iter(hidden));
    let mut robot = arms::two_link_craig();
    robot.name.clone_from(&name);
    robot.frames.push(Frame {
        name: name.clone(),
        on: Some(1),
        places: Vec::new(),
        body: None,
    });
    let request = Request::of_frame(Function::Jacobian, 0, &name);
    let program = proven_program(&robot, &request).expect("proven");
    let methods = expand(
        &robot,
        std::slice::from_ref(&request),
        &quote::quote!(runtime),
    );
    let method = methods.expect("proven").remove(0).tokens.to_string();
    assert!(
        method.contains("a*/b") && !method.contains("202e"),
        "{method}"
    );
    let programs = [(request, program)];
    let c = c_source(&robot, &programs);
    let mut texts = vec![
        c.header,
        c.source,
        javascript_module(&robot, &programs),
        python_module(&robot, &programs),
    ];
    texts.extend(
        matlab_files(&robot, &programs)
            .into_iter()
            .map(|(_, text)| text),
    );
    for text in texts {
        assert!(!text.contains(hidden), "{text}");
    }
}

/// A pivot of M that failed is counted among all, those of a base that moves first, and has a name.
#[test]
fn pivots_of_a_base_that_moves_have_names() {
    let robot = arms::floating("free_body");
    let request = robot.request(Request::from(Function::ForwardDynamics));
    let program = proven_program(&robot, &request).expect("proven");
    let programs = [(request, program)];
    let names = "\"base vx\", \"base vy\", \"base vz\", \"base wx\", \"base wy\", \"base wz\"";
    let python = python_module(&robot, &programs);
    let quoted = names.replace('"', "'");
    assert!(
        python.contains(&format!("([{quoted}] + JOINT_NAMES)[joint]")),
        "{python}"
    );
    let javascript = javascript_module(&robot, &programs);
    assert!(
        javascript.contains(&format!("[{names}, ...JOINT_NAMES][joint]")),
        "{javascript}"
    );
    assert!(javascript.contains("/** Degrees of freedom: six of the base, then"));
}

/// Entries that are zero always are no part of an output, derivatives stand behind their function.
#[test]
fn two_link_arm_for_casadi() {
    let robot = arms::two_link_craig();
    let requests = [Function::GravityVector, Function::InverseDynamics].map(Request::from);
    let needed = casadi_requests(&robot, &requests).into_iter();
    let programs = needed.map(|request| {
        let program = proven_program(&robot, &request).expect("proven");
        (request, program)
    });
    let programs: Vec<_> = programs.collect();
    let source = casadi_source(&robot, &requests, &programs);
    assert_eq!(source.name, "two_link_craig_casadi.c");
    expect_file!["golden/two_link_craig_casadi.c"].assert_eq(&source.text);
}

#[test]
fn functions_of_frames_have_text() {
    let robot = arms::fingers();
    let of_jacobian = |frame| Part {
        function: Function::Jacobian,
        frame: Some(frame),
    };
    let parts = [Function::MassMatrix.into(), of_jacobian(0), of_jacobian(1)];
    let requests = [
        Request::of_frame(Function::ForwardKinematics, 1, "Right tip"),
        Request::of_frame(Function::Jacobian, 0, "Left tip"),
        Request::of_frame(Function::WrenchTorques, 1, "Right tip"),
        Request::fused("pinch", parts),
    ];
    let programs = requests.map(|request| {
        let program = proven_program(&robot, &request).expect("proven");
        (request, program)
    });
    let files = c_source(&robot, &programs);
    expect_file!["golden/fingers.h"].assert_eq(&files.header);
    expect_file!["golden/fingers.c"].assert_eq(&files.source);
    expect_file!["golden/fingers.mjs"].assert_eq(&javascript_module(&robot, &programs));
}

/// The line about rounding is that of Rust, wherever a function is.
#[test]
fn all_languages_have_the_bounds_of_rounding() {
    let mut robot = arms::robot("two_link_saha");
    for row in &mut robot.rows {
        row.limits = Some([Value::integer(-2), Value::integer(2)]);
    }
    let requests = Function::default_set(false).into_iter().map(Request::from);
    let program = |request: Request| {
        let program = proven_program(&robot, &request).expect("proven");
        (request, program)
    };
    let programs: Vec<_> = requests.map(program).collect();
    let requests: Vec<_> = programs
        .iter()
        .map(|(request, _)| request.clone())
        .collect();
    let c = c_source(&robot, &programs);
    let project = c_project(&robot, &programs, CNumbers::Double);
    let matlab = matlab_files(&robot, &programs)
        .into_iter()
        .map(|(_, text)| text);
    let texts = [
        c.header,
        project[0].1.clone(),
        javascript_module(&robot, &programs),
        python_module(&robot, &programs),
        matlab.collect(),
        casadi_source(&robot, &requests, &programs).text,
    ];
    for (request, proven) in &programs {
        let line = rounding(&robot, request, proven).expect("limits").line();
        assert!(line.starts_with("Rounding: at most "), "{line}");
        for (k, text) in texts.iter().enumerate() {
            assert!(text.contains(&line), "{k} {}: {line}", request.name());
        }
    }
}
