//! Several functions as one program: what it computes, and what it saves.

use dynamics_symbolic::derive;
use dynamics_symbolic::function::{Part, Request, spans};
use dynamics_symbolic::neglect::neglect;
use dynamics_symbolic::program::{Instruction, Program};
use dynamics_symbolic::prove::{self, Cause, ProofFailure};
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Function, expand};
use expect_test::{expect, expect_file};
use quote::quote;
use std::ops::RangeInclusive;

/// The functions of a loop of computed torque.
const CONTROL: [Function; 3] = [
    Function::MassMatrix,
    Function::CoriolisVector,
    Function::GravityVector,
];

/// The functions of an optimisation of a motion.
const LINEARISED: [Function; 2] = [
    Function::InverseDynamics,
    Function::InverseDynamicsDerivatives,
];

const SETS: [&[Function]; 5] = [
    &CONTROL,
    &LINEARISED,
    &[
        Function::ForwardDynamics,
        Function::ForwardDynamicsDerivatives,
    ],
    &[
        Function::KineticEnergy,
        Function::PotentialEnergy,
        Function::Jacobian,
        Function::FrictionVector,
    ],
    &[Function::Regressor, Function::BaseParameters],
];

fn parts(functions: &[Function]) -> Vec<Part> {
    functions.iter().copied().map(Part::from).collect()
}

fn derive_together(robot: &Robot, functions: &[Function]) -> Program {
    derive::derive_together(robot, &parts(functions))
}

fn prove_together(
    robot: &Robot,
    functions: &[Function],
    program: &Program,
) -> Result<(), ProofFailure> {
    prove::prove_together(robot, &parts(functions), program)
}

/// Every set on every arm with so many joints.
fn prove_sets(joints: RangeInclusive<usize>) {
    let robots = arms::NAMES.map(arms::robot).into_iter();
    for robot in robots.filter(|robot| joints.contains(&robot.dof())) {
        for set in SETS {
            let program = derive_together(&robot, set);
            let proof = prove_together(&robot, set, &program);
            assert_eq!(proof, Ok(()), "{} {set:?}", robot.name);
        }
    }
}

#[test]
fn each_part_is_proven_by_its_own_definition() {
    prove_sets(1..=4);
}

/// `cargo test -p dynamics-symbolic --test suite fused:: -- --ignored`
#[test]
#[ignore = "takes a quarter of a minute: .ci/run runs it"]
fn each_part_of_longer_arms_is_proven_by_its_own_definition() {
    prove_sets(5..=6);
}

/// Functions that controllers need together: of the tip, of the centre of mass, of passivity and identification, and
/// functions that solve with M beside others.
const OF_CONTROLLERS: [&[Function]; 4] = [
    &[
        Function::WrenchTorques,
        Function::ToolVelocity,
        Function::ToolAcceleration,
        Function::JacobianRate,
        Function::LinkJacobians,
    ],
    &[
        Function::CenterOfMass,
        Function::CenterOfMassJacobian,
        Function::GeneralizedMomentum,
        Function::MomentumBias,
    ],
    &[
        Function::PassivityTorque,
        Function::PassivityRegressor,
        Function::EnergyRegressors,
    ],
    &[
        Function::OperationalInertiaInverse,
        Function::ForwardDynamics,
        Function::InverseDynamicsRates,
        Function::SpringVector,
    ],
];

/// Joints of both kinds, a base and a tool, two conventions.
#[test]
fn functions_of_controllers_are_parts_too() {
    for name in ["scara", "cylindrical_rpp", "elbow_3r", arms::MOUNTED] {
        let robot = arms::robot(name);
        for set in OF_CONTROLLERS {
            let program = derive_together(&robot, set);
            let proof = prove_together(&robot, set, &program);
            assert_eq!(proof, Ok(()), "{name} {set:?}");
        }
    }
}

/// A tuple of an abbreviated model is proven by that model's definition, and by no other.
#[test]
fn abbreviated_models_have_tuples() {
    for name in ["scara", "stanford"] {
        let complete = arms::robot(name);
        let robot = neglect(&complete, 0.03).expect("regular");
        let sets = [&CONTROL[..], &LINEARISED, OF_CONTROLLERS[1]];
        for set in sets {
            let program = derive_together(&robot, set);
            assert_eq!(prove_together(&robot, set, &program), Ok(()), "{name}");
            assert!(prove_together(&complete, set, &program).is_err(), "{name}");
        }
    }
}

/// Every operation of a program belongs to some part: a change of it is found, and the part is named.
#[test]
fn a_damaged_part_is_refused() {
    let robot = arms::robot("elbow_3r");
    let sound = derive_together(&robot, &CONTROL);
    let [_, motion, gravity] = &spans(&parts(&CONTROL), 3, sound.outputs.len())[..] else {
        panic!("three parts");
    };
    for index in 0..sound.instructions.len() {
        let mut program = sound.clone();
        let changed = match program.instructions[index] {
            Instruction::Add(a, b) => Instruction::Sub(a, b),
            Instruction::Sub(a, b) => Instruction::Add(a, b),
            Instruction::Mul(a, b) => Instruction::Add(a, b),
            Instruction::Div(a, b) => Instruction::Mul(a, b),
        };
        program.instructions[index] = changed;
        assert!(
            prove_together(&robot, &CONTROL, &program).is_err(),
            "{index}"
        );
    }
    for (span, function) in [
        (motion, Function::CoriolisVector),
        (gravity, Function::GravityVector),
    ] {
        let mut program = sound.clone();
        program.outputs[span.end - 1].negative ^= true;
        let failure = prove_together(&robot, &CONTROL, &program).unwrap_err();
        assert_eq!(
            (failure.function, failure.cause),
            (function, Cause::Output(2))
        );
    }
    // A part too many, one too few, and one in the place of another.
    let fails = |functions: &[Function]| prove_together(&robot, functions, &sound).is_err();
    assert!(fails(&CONTROL[..2]));
    assert!(fails(&[&CONTROL[..], &[Function::KineticEnergy]].concat()));
    assert!(fails(&[CONTROL[0], CONTROL[2], CONTROL[1]]));
}

fn request(name: &str, parts: &[Function]) -> Request {
    Request::fused(name, parts.iter().copied())
}

fn text(robot: &Robot, requests: &[Request]) -> String {
    let methods = expand(robot, requests, &quote!(::robot_dynamics)).expect("proven");
    let items = methods.iter().map(|method| &method.function);
    let methods = methods.iter().map(|method| &method.tokens);
    let file = quote!(impl Arm { #(#methods)* } #(impl Function for Arm { #items })*);
    prettyplease::unparse(&syn::parse2(file).expect("Rust"))
}

/// The methods as they are emitted: of a tuple, of one that may fail, and of what shares nothing.
#[test]
fn the_text_of_fused_methods() {
    let robot = arms::robot("two_link_saha");
    let requests = [
        request("control_terms", &CONTROL),
        request(
            "motion",
            &[Function::ForwardDynamics, Function::KineticEnergy],
        ),
        request(
            "apart",
            &[Function::FrictionVector, Function::PotentialEnergy],
        ),
    ];
    let first = text(&robot, &requests);
    expect_file!["../golden/fused.rs"].assert_eq(&first);
    assert_eq!(first, text(&robot, &requests));
}

/// Pivots of two parts that solve with M are tested once.
#[test]
fn equal_pivots_are_tested_once() {
    let robot = arms::robot("elbow_3r");
    let functions = [
        Function::ForwardDynamics,
        Function::ForwardDynamicsDerivatives,
    ];
    let text = text(&robot, &[request("both", &functions)]);
    assert_eq!(text.matches("test_joint").count(), 3);
}

/// Operations of one program beside those of one for each function, and the share that is saved.
#[test]
fn what_is_saved() {
    let mut table =
        "robot     functions                                     apart          fused   saved\n"
            .to_owned();
    for name in ["puma560", "panda", "ur5", "stanford", "elbow_3r", "scara"] {
        let robot = arms::robot(name);
        for set in [&CONTROL[..], &LINEARISED] {
            let apart: Vec<_> = set
                .iter()
                .map(|f| crate::derive(&robot, *f).operations())
                .collect();
            let program = derive_together(&robot, set);
            assert_eq!(prove_together(&robot, set, &program), Ok(()), "{name}");
            let fused = program.operations();
            let total: u32 = apart.iter().map(|o| o.total()).sum();
            let angles: u32 = apart.iter().map(|o| o.sin_cos).sum();
            let saved = 100.0 * (1.0 - f64::from(fused.total()) / f64::from(total));
            let names: Vec<_> = set.iter().map(|f| f.name()).collect();
            table += &format!(
                "{name:9} {:44} {total:4} + {angles:2}  {:4} + {}  {saved:4.1} %\n",
                names.join(" "),
                fused.total(),
                fused.sin_cos,
            );
            assert!(
                fused.total() + fused.sin_cos < total + angles,
                "{name} {table}"
            );
        }
    }
    expect![[r#"
        robot     functions                                     apart          fused   saved
        puma560   mass_matrix coriolis_vector gravity_vector    372 + 12   342 + 4   8.1 %
        puma560   inverse_dynamics inverse_dynamics_derivatives 1339 +  8  1114 + 4  16.8 %
        panda     mass_matrix coriolis_vector gravity_vector    871 + 18   775 + 6  11.0 %
        panda     inverse_dynamics inverse_dynamics_derivatives 2995 + 12  2487 + 6  17.0 %
        ur5       mass_matrix coriolis_vector gravity_vector    261 + 13   231 + 5  11.5 %
        ur5       inverse_dynamics inverse_dynamics_derivatives  907 + 10   740 + 5  18.4 %
        stanford  mass_matrix coriolis_vector gravity_vector    313 +  9   314 + 3  -0.3 %
        stanford  inverse_dynamics inverse_dynamics_derivatives 1140 +  6   923 + 3  19.0 %
        elbow_3r  mass_matrix coriolis_vector gravity_vector    110 +  6    87 + 2  20.9 %
        elbow_3r  inverse_dynamics inverse_dynamics_derivatives  287 +  4   223 + 2  22.3 %
        scara     mass_matrix coriolis_vector gravity_vector     70 +  4    57 + 2  18.6 %
        scara     inverse_dynamics inverse_dynamics_derivatives  198 +  4   162 + 2  18.2 %
    "#]]
    .assert_eq(&table);
}
