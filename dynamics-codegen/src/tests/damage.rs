//! A derivation that goes wrong: the proof notices, and the user gets a compile error that names
//! the function.

use dynamics_symbolic::Function;
use dynamics_symbolic::derive::derive_together as derive;
use dynamics_symbolic::function::Part;
use dynamics_symbolic::program::{Instruction, Program};
use dynamics_symbolic::robot::Robot;

const ARM: &str = "struct Arm; convention: modified, gravity: [0, -9.81, 0], joints: [
    shoulder: revolute { mass: 2, com: [0.5, 0, 0] },
    elbow: revolute { a: 0.5, mass: 1, com: [0.3, 0, 0] },
],";

/// The right programs, except for one sign in the mass matrix.
fn wrong_sign(robot: &Robot, functions: &[Part]) -> Program {
    let mut program = derive(robot, functions);
    if functions[0] == Function::MassMatrix.into() {
        for instruction in &mut program.instructions {
            if let Instruction::Add(a, b) = *instruction {
                *instruction = Instruction::Sub(a, b);
            }
        }
    }
    program
}

/// The right programs, except for a dropped last operation in the gravity vector.
fn dropped_term(robot: &Robot, functions: &[Part]) -> Program {
    let mut program = derive(robot, functions);
    if functions == [Function::GravityVector.into()] {
        program.outputs[0] = program.outputs[1];
    }
    program
}

fn expansion(derivation: &crate::Derivation) -> String {
    crate::generate_by(ARM.parse().expect("the source lexes"), derivation).to_string()
}

#[test]
fn a_sound_derivation_gives_no_error() {
    assert!(!expansion(&derive).contains("compile_error"));
}

#[test]
fn a_wrong_sign_is_a_compile_error_that_names_the_function() {
    let text = expansion(&wrong_sign);
    assert_eq!(text.matches("compile_error").count(), 1, "{text}");
    assert!(
        text.contains(
            "the program derived for `mass_matrix` is not equal to the textbook Lagrangian"
        )
    );
}

#[test]
fn a_dropped_term_is_a_compile_error_that_names_the_function() {
    let text = expansion(&dropped_term);
    assert_eq!(text.matches("compile_error").count(), 1, "{text}");
    assert!(text.contains(
        "the program derived for `gravity_vector` is not equal to the textbook Lagrangian"
    ));
}

#[test]
fn the_methods_still_exist_after_a_failed_proof() {
    let text = expansion(&wrong_sign);
    for function in Function::default_set(false) {
        assert!(
            text.contains(&format!("pub fn {}", function.name())),
            "{}",
            function.name()
        );
    }
}

/// One part of two is wrong: the error stands for the method and names the part.
#[test]
fn a_wrong_part_is_a_compile_error_that_names_it() {
    let wrong = |robot: &Robot, functions: &[Part]| {
        let mut program = derive(robot, functions);
        if functions.len() == 2 {
            program.outputs[4].negative ^= true;
        }
        program
    };
    let call = format!("{ARM} functions: [both = (mass_matrix, gravity_vector)]");
    let text = crate::generate_by(call.parse().expect("the source lexes"), &wrong).to_string();
    assert_eq!(text.matches("compile_error").count(), 1, "{text}");
    assert!(text.contains(
        "`both`: the program derived for `gravity_vector` is not equal to the textbook Lagrangian (output 1)"
    ));
    assert!(text.contains("pub fn both"), "{text}");
}
