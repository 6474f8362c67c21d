//! Random tables: every function of every arm is derived and proven.

use arms::{Bodies, Tables};
use dynamics_symbolic::Function;
use dynamics_symbolic::derive::center_of_mass::is_massless;
use dynamics_symbolic::derive::functions::Form;
use dynamics_symbolic::derive::{derive, derive_form, derive_plain};
use dynamics_symbolic::function::Part;
use dynamics_symbolic::program::{Instruction, Program};
use dynamics_symbolic::prove::prove;
use dynamics_symbolic::robot::Robot;

use crate::trees::of_tip;

#[test]
fn every_function_of_random_arms_is_proven() {
    prove_tables(7, 15, false, &Function::ALL);
}

/// Joints anywhere locked at a number, an angle or a parameter.
#[test]
fn every_function_of_random_arms_with_locked_joints_is_proven() {
    prove_drawn(9, 8, &[Tables::locked_robot]);
}

/// Bases and tools of numbers, angles and parameters.
#[test]
fn every_function_of_random_arms_with_base_and_tool_is_proven() {
    prove_drawn(
        10,
        5,
        &[Tables::mounted_robot, Tables::mounted_and_locked_robot],
    );
}

/// Springs at some of the joints, friction by direction and friction that falls with the velocity, made of
/// numbers and parameters.
#[test]
fn every_function_of_random_arms_with_joint_forces_is_proven() {
    prove_drawn(10, 10, &[Tables::robot_with_joint_forces]);
}

/// Joints that follow others by factors and offsets of numbers and parameters, before and behind the joint
/// that leads, with springs and friction of every kind.
#[test]
fn every_function_of_random_arms_with_followers_is_proven() {
    prove_drawn(11, 6, &[Tables::coupled_robot]);
}

/// Joints on links above them or on the base, anywhere; frames with bodies; followers and locked joints on any branch.
#[test]
fn every_function_of_random_trees_is_proven() {
    prove_drawn(12, 4, &[Tables::tree, Tables::tree_with_all_cells]);
    prove_plain(13, 60);
}

#[test]
fn regressors_of_arms_whose_axes_meet_are_proven() {
    let functions = [Function::Regressor, Function::BaseParameters];
    prove_tables(8, 75, true, &functions);
}

/// Many more: `cargo test -p dynamics-symbolic --test suite random_tables:: -- --ignored`.
mod release {
    use super::*;

    #[test]
    #[ignore = "a minute: run before a release"]
    fn every_function_of_many_random_arms_is_proven() {
        let functions = [Function::Regressor, Function::BaseParameters];
        prove_tables(100, 300, true, &functions);
        prove_tables(100, 200, false, &Function::ALL);
        prove_tables(101, 50, true, &Function::ALL);
    }

    #[test]
    #[ignore = "a minute: run before a release"]
    fn every_function_of_many_random_arms_of_each_kind_is_proven() {
        let kinds = [
            Tables::locked_robot,
            Tables::mounted_robot,
            Tables::mounted_and_locked_robot,
            Tables::robot_with_joint_forces,
            Tables::coupled_robot,
            Tables::tree,
            Tables::tree_with_all_cells,
        ];
        prove_drawn(100, 40, &kinds);
    }
}

/// So many trees, every other one with all cells, as the recursions are written: without the search for short programs,
/// which takes most of the time elsewhere.
fn prove_plain(seed: u64, count: usize) {
    let mut tables = Tables::new(seed, Bodies::Any);
    for number in 0..count {
        let robot = if number % 2 == 0 {
            tables.tree()
        } else {
            tables.tree_with_all_cells()
        };
        prove_parts(&robot, number, &Function::ALL, derive_plain);
    }
}

/// As many arms of each kind.
fn prove_drawn(seed: u64, count: usize, kinds: &[fn(&mut Tables) -> Robot]) {
    let mut tables = Tables::new(seed, Bodies::Any);
    for number in 0..count {
        for draw in kinds {
            prove_table(&draw(&mut tables), number, &Function::ALL);
        }
    }
}

fn prove_tables(seed: u64, tables_in_all: usize, meeting: bool, functions: &[Function]) {
    let mut tables = Tables::new(seed, Bodies::Any);
    if meeting {
        tables = tables.with_meeting_axes();
    }
    for count in 0..tables_in_all {
        prove_table(&tables.robot(), count, functions);
    }
}

fn prove_table(robot: &Robot, count: usize, functions: &[Function]) {
    prove_parts(robot, count, functions, derive);
    // Articulated bodies are of joints that move by themselves.
    let function = Function::ForwardDynamics;
    if functions.contains(&function) && !robot.is_coupled() {
        let program = derive_form(robot, function, Form::Articulated);
        assert_proven(robot, count, function.into(), &program);
    }
}

/// Proves the functions of the list that the robot has, and the functions of its frames.
pub(crate) fn prove_parts(
    robot: &Robot,
    count: usize,
    functions: &[Function],
    derive: fn(&Robot, Part) -> Program,
) {
    let has_tip = robot.tip_row().is_some();
    let exists = |f: &&Function| {
        (has_tip || !f.row().of_tip) && !(f.divides_by_mass() && is_massless(robot))
    };
    let functions = functions.iter().filter(exists);
    let named = (0..robot.frames.len()).map(Some);
    let of_frames = of_tip().flat_map(|function| {
        let part = move |frame| Part { function, frame };
        named.clone().map(part)
    });
    let parts = functions.map(|&f| f.into()).chain(of_frames);
    for part in parts {
        assert_proven(robot, count, part, &derive(robot, part));
    }
}

pub(crate) fn assert_proven(robot: &Robot, count: usize, part: Part, program: &Program) {
    let proof = prove(robot, part, program);
    assert_eq!(proof, Ok(()), "table {count}: {robot:#?}");
    arms::assert_zeros_are_constants(robot, part, program);
    let function = part.function;
    let divides = program
        .instructions
        .iter()
        .any(|i| matches!(i, Instruction::Div(..)));
    let solves = [
        Function::ForwardDynamics,
        Function::ForwardDynamicsDerivatives,
        Function::ForwardDynamicsAba,
        Function::OperationalInertiaInverse,
    ];
    // 1/v^2 of a symbolic Stribeck velocity.
    let differentiated = [
        Function::InverseDynamicsDerivatives,
        Function::InverseDynamicsRates,
        Function::InverseDynamicsSecondDerivatives,
    ];
    let by_velocity =
        differentiated.contains(&function) && robot.rows.iter().any(|row| row.stribeck.is_some());
    // By factors that are parameters.
    let by_factor = function == Function::BaseParameters && robot.is_coupled();
    let may_divide = solves.contains(&function) || function.divides_by_mass();
    assert!(
        may_divide || by_velocity || by_factor || !divides,
        "table {count}: {robot:#?}"
    );
    let constants = program.rounded_constants();
    assert!(constants.iter().all(|x| !x.is_infinite()), "table {count}");
}
