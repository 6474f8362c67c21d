//! Abbreviated models: what they save, what they cost, and that they are proven.

use crate::derive;
use crate::without_friction;
use dynamics_symbolic::Function;
use dynamics_symbolic::neglect::{largest_error, neglect};
use dynamics_symbolic::prove::prove;
use dynamics_symbolic::robot::{Coupling, Robot};
use expect_test::expect_file;

const FUNCTIONS: [Function; 5] = [
    Function::InverseDynamics,
    Function::MassMatrix,
    Function::CoriolisVector,
    Function::GravityVector,
    Function::ForwardDynamics,
];

/// Operations saved, and the largest errors.
#[test]
fn abbreviated_models_are_proven_and_measured() {
    let mut table =
        String::from("robot     share  neglected  function            operations         error\n");
    for name in ["puma560", "ur5", "panda", "hyq"] {
        let robot = match name {
            "hyq" => arms::tree(name),
            _ => without_friction(name),
        };
        let complete = FUNCTIONS.map(|function| derive(&robot, function));
        for share in [0.001, 0.01, 0.05] {
            let abbreviated = match neglect(&robot, share) {
                Ok(abbreviated) => abbreviated,
                Err(refused) => {
                    table += &format!("{name:9} {share:5}  refused: {refused}\n");
                    continue;
                }
            };
            let programs = FUNCTIONS.map(|function| derive(&abbreviated, function));
            for (function, program) in FUNCTIONS.iter().zip(&programs) {
                let proof = prove(&abbreviated, *function, program);
                assert_eq!(proof, Ok(()), "{name} {share}");
            }
            let neglected = abbreviated.neglected.expect("neglected");
            let count = neglected.columns.len();
            for (i, function) in FUNCTIONS.into_iter().enumerate() {
                let error = largest_error(&robot, &[function.into()], &complete[i], &programs[i]);
                let name_of = function.name();
                table += &format!(
                    "{name:9} {share:5}  {count:9}  {name_of:18} {:4} of {:4}    {:9.1e}\n",
                    error.complete - error.saved,
                    error.complete,
                    error.relative,
                );
            }
        }
    }
    expect_file!["../golden/neglect.txt"].assert_eq(&table);
}

/// Joints of both kinds, axes that are written in those of another joint.
#[test]
fn every_function_of_abbreviated_models_is_proven() {
    prove_abbreviated(["scara", "cylindrical_rpp", "generic_chain_n3"].map(arms::robot));
    prove_abbreviated(["forked_chain"].map(arms::tree));
}

/// Both conventions: `cargo test -p dynamics-symbolic --test suite neglect:: -- --ignored`.
#[test]
#[ignore = "takes a quarter of a minute: .ci/run runs it"]
fn every_function_of_longer_abbreviated_models_is_proven() {
    prove_abbreviated(["stanford", "generic_mixed_n6_standard"].map(arms::robot));
}

fn prove_abbreviated<const N: usize>(robots: [Robot; N]) {
    for complete in robots {
        let name = &complete.name;
        let robot = neglect(&complete, 0.03).expect("regular");
        let count = robot.neglected.as_ref().expect("neglected").columns.len();
        assert!(count > 0, "{name}");
        let has_tip = robot.tip_row().is_some();
        let functions = Function::ALL
            .into_iter()
            .filter(|f| has_tip || !f.row().of_tip);
        for function in functions.filter(|f| !f.is_about_base_parameters()) {
            let program = derive(&robot, function);
            assert_eq!(prove(&robot, function, &program), Ok(()), "{name}");
        }
        // The complete program is another one.
        let complete = derive(&complete, Function::InverseDynamics);
        assert!(prove(&robot, Function::InverseDynamics, &complete).is_err());
    }
}

/// Locked joints first: what is neglected are parameters of the links that are left.
#[test]
fn locked_arms_can_be_abbreviated() {
    let mut robot = arms::robot("puma560");
    for joint in [0, 4] {
        robot.rows[joint].locked = Some(arms::decimal(0.3));
    }
    let robot = neglect(&robot, 0.02).expect("regular");
    let neglected = robot.neglected.as_ref().expect("neglected");
    assert!(
        neglected
            .columns
            .iter()
            .all(|(row, _)| ![0, 4].contains(row))
    );
    assert!(!neglected.columns.is_empty());
    for function in FUNCTIONS {
        let program = derive(&robot, function);
        assert_eq!(prove(&robot, function, &program), Ok(()));
    }
}

/// That M of a coupled arm is positive definite follows from that of the arm in which nothing is coupled.
#[test]
fn coupled_arms_can_be_abbreviated() {
    for (name, leader, follower, [factor, offset]) in [
        ("puma560", 3, 4, [0.5, 0.3]),
        ("stanford", 1, 2, [-0.1, 0.4]),
    ] {
        let mut robot = arms::robot(name);
        robot.rows[follower].follows = Some(Coupling {
            leader,
            factor: arms::decimal(factor),
            offset: arms::decimal(offset),
        });
        let robot = neglect(&robot, 0.02).expect("regular");
        let neglected = robot.neglected.as_ref().expect("neglected");
        assert!(
            neglected.is_definite && !neglected.columns.is_empty(),
            "{name}"
        );
        for function in FUNCTIONS {
            let program = derive(&robot, function);
            assert_eq!(prove(&robot, function, &program), Ok(()), "{name}");
        }
    }
}
