//! The proof refuses damaged programs: every single operation matters.

use arms::{Bodies, Tables};
use dynamics_symbolic::Function;
use dynamics_symbolic::derive::functions::Form;
use dynamics_symbolic::derive::{derive, derive_form};
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::function::Part;
use dynamics_symbolic::neglect::neglect;
use dynamics_symbolic::program::{Constant, Instruction, Operand, Program};
use dynamics_symbolic::prove::{Cause, Proof, prove};
use dynamics_symbolic::robot::{Coupling, Robot, Row, Spring, Stribeck, Value};

/// Ways in which a simplification may go wrong.
const DAMAGES: [fn(&mut Program, usize); 4] =
    [wrong_sign, dropped_term, dropped_factor, rounded_constant];

fn wrong_sign(program: &mut Program, index: usize) {
    let instruction = &mut program.instructions[index];
    *instruction = match *instruction {
        Instruction::Add(a, b) => Instruction::Sub(a, b),
        Instruction::Sub(a, b) => Instruction::Add(a, b),
        other => other,
    };
}

fn dropped_term(program: &mut Program, index: usize) {
    let zero = Operand::Constant(program.constants.push(Constant::Rational(Rational::ZERO)));
    let instruction = &mut program.instructions[index];
    *instruction = match *instruction {
        Instruction::Add(a, _) => Instruction::Add(a, zero),
        Instruction::Sub(_, b) => Instruction::Sub(zero, b),
        other => other,
    };
}

fn dropped_factor(program: &mut Program, index: usize) {
    let one = Operand::Constant(program.constants.push(Constant::Rational(Rational::ONE)));
    let instruction = &mut program.instructions[index];
    *instruction = match *instruction {
        Instruction::Mul(a, _) => Instruction::Mul(a, one),
        Instruction::Div(a, _) => Instruction::Div(a, one),
        other => other,
    };
}

/// One unit in the twentieth digit.
fn rounded_constant(program: &mut Program, index: usize) {
    let instruction = program.instructions[index];
    let [a, b] = instruction.operands();
    let Operand::Constant(id) = a else { return };
    let Constant::Rational(exact) = program.constants.get(id).clone() else {
        return;
    };
    let error = Rational::ONE / Rational::from(10).pow(20);
    let rounded = Constant::Rational(exact * (Rational::ONE + error));
    let a = Operand::Constant(program.constants.push(rounded));
    program.instructions[index] = match instruction {
        Instruction::Add(..) => Instruction::Add(a, b),
        Instruction::Sub(..) => Instruction::Sub(a, b),
        Instruction::Mul(..) => Instruction::Mul(a, b),
        Instruction::Div(..) => Instruction::Div(a, b),
    };
}

/// Every operation is damaged, but of the longest programs one in fifty, of long regressors and articulated bodies one in seven.
fn every(function: Function, dof: usize, length: usize) -> usize {
    match function {
        Function::Regressor
        | Function::ForwardDynamicsAba
        | Function::PassivityRegressor
        | Function::InverseDynamicsRates
            if length > 500 =>
        {
            7
        }
        Function::InverseDynamicsDerivatives
        | Function::ForwardDynamicsDerivatives
        | Function::InverseDynamicsSecondDerivatives
            if dof > 4 =>
        {
            50
        }
        _ => 1,
    }
}

/// Damages every operation of a proven program in every way; how many damages were refused.
pub(crate) fn refused(robot: &Robot, part: impl Into<Part>, sound: &Program) -> usize {
    let part = part.into();
    let function = part.function;
    let mut proof = Proof::new(robot, &[part], sound);
    assert_eq!(proof.holds(sound), Ok(()));
    let mut refused = 0;
    let length = sound.instructions.len();
    let every = every(function, robot.rows.len(), length);
    for index in (0..length).step_by(every) {
        for damage in DAMAGES {
            let mut program = sound.clone();
            damage(&mut program, index);
            if program.instructions[index] == sound.instructions[index] {
                continue;
            }
            let (name, function_name) = (&robot.name, function.name());
            let failure = proof
                .holds(&program)
                .expect_err(&format!("{name} {function_name}: operation {index}"));
            assert_eq!(failure.function, function);
            assert!(failure.to_string().contains(function_name));
            refused += 1;
        }
    }
    refused
}

/// How many damages of all functions of these arms were refused.
fn refused_of(names: &[&str]) -> usize {
    let of_arm = |name: &&str| {
        let robot = arms::robot(name);
        let of = |function| refused(&robot, function, &crate::derive(&robot, function));
        Function::ALL.into_iter().map(of).sum::<usize>()
    };
    names.iter().map(of_arm).sum()
}

#[test]
fn every_damage_to_every_operation_is_found() {
    let count = refused_of(&["cylindrical_rpp", "two_link_saha"]);
    assert!(count > 1_000, "only {count} damages were made");
}

/// `cargo test -p dynamics-symbolic --test suite damage:: -- --ignored`
#[test]
#[ignore = "takes a quarter of a minute: .ci/run runs it"]
fn every_damage_to_every_operation_of_longer_arms_is_found() {
    let count = refused_of(&["generic_chain_n3", "scara", "puma560", "stanford"]);
    assert!(count > 5_000, "only {count} damages were made");
}

/// A branch knows of the others by what they have in common alone.
#[test]
fn every_damage_to_a_tree_is_found() {
    let robot = crate::trees::tree_of_five();
    let functions = [
        Function::MassMatrix,
        Function::CoriolisVector,
        Function::InverseDynamics,
        Function::ForwardDynamics,
    ];
    for function in functions {
        let program = derive(&robot, function);
        let count = refused(&robot, function, &program);
        assert!(count >= program.instructions.len(), "{function:?}: {count}");
    }
}

#[test]
fn every_damage_to_articulated_bodies_is_found() {
    let function = Function::ForwardDynamics;
    for name in ["puma560", "stanford", "scara"] {
        let robot = arms::robot(name);
        let program = derive_form(&robot, function, Form::Articulated);
        assert!(refused(&robot, function, &program) >= program.instructions.len());
    }
}

/// Locked joints and neglected parameters are part of what is proven.
#[test]
fn every_damage_to_a_scene_is_found() {
    let mut locked = arms::robot("puma560");
    locked.rows[2].locked = Some(arms::decimal(0.3));
    locked.rows[5].locked = Some(arms::decimal(-1.5));
    let abbreviated = neglect(&locked, 0.02).expect("regular");
    for robot in [&locked, &abbreviated] {
        for function in [Function::InverseDynamics, Function::ForwardDynamics] {
            let program = derive(robot, function);
            assert!(refused(robot, function, &program) > 100);
        }
    }
}

/// Springs of numbers, a locked joint among them.
#[test]
fn every_damage_to_the_forces_of_springs_is_found() {
    let mut robot = arms::robot("cylindrical_rpp");
    let spring = |stiffness, rest| {
        Some(Spring {
            stiffness: arms::decimal(stiffness),
            rest: arms::decimal(rest),
        })
    };
    robot.rows[0].spring = spring(5.5, -0.2);
    robot.rows[1].spring = spring(200.0, 0.1);
    robot.rows[2].spring = spring(70.0, 0.3);
    robot.rows[1].locked = Some(arms::decimal(0.25));
    for function in [
        Function::SpringVector,
        Function::PotentialEnergy,
        Function::BiasForce,
        Function::InverseDynamics,
        Function::ForwardDynamics,
        Function::ForwardDynamicsAba,
        Function::InverseDynamicsDerivatives,
        Function::ForwardDynamicsDerivatives,
    ] {
        let refused = refused(&robot, function, &derive(&robot, function));
        assert!(refused > 0, "{}", function.name());
    }
}

/// Two joints with friction that falls with the velocity and differs by direction.
fn sticky_robot() -> Robot {
    let mut robot = arms::robot("two_link_saha");
    for (row, more) in robot.rows.iter_mut().zip([0.0, 0.1]) {
        row.viscous = arms::decimal(0.3);
        row.coulomb = [0.5 + more, 0.4].map(arms::decimal);
        row.stribeck = Some(Stribeck {
            friction: arms::decimal(0.8),
            velocity: arms::decimal(0.01 + more),
        });
    }
    robot
}

#[test]
fn every_damage_to_friction_is_found() {
    let robot = sticky_robot();
    for function in [
        Function::FrictionVector,
        Function::BiasForce,
        Function::InverseDynamics,
        Function::ForwardDynamics,
        Function::ForwardDynamicsAba,
        Function::InverseDynamicsDerivatives,
        Function::ForwardDynamicsDerivatives,
        Function::InverseDynamicsSecondDerivatives,
    ] {
        let refused = refused(&robot, function, &derive(&robot, function));
        assert!(refused > 0, "{}", function.name());
    }
}

/// Every cell of friction is part of what is proven.
#[test]
fn a_program_of_other_friction_is_refused() {
    let robot = sticky_robot();
    let changes: [fn(&mut Row); 5] = [
        |row| row.viscous = arms::decimal(0.31),
        |row| row.coulomb[0] = arms::decimal(0.51),
        |row| row.coulomb[1] = arms::decimal(0.41),
        |row| row.stribeck.as_mut().expect("sticky").friction = arms::decimal(0.81),
        |row| row.stribeck = None,
    ];
    let program = derive(&robot, Function::FrictionVector);
    let differentiated = [
        Function::InverseDynamicsDerivatives,
        Function::InverseDynamicsSecondDerivatives,
    ];
    for change in changes {
        let mut other = robot.clone();
        change(&mut other.rows[1]);
        assert!(prove(&other, Function::FrictionVector, &program).is_err());
    }
    // The exponential is a symbol: its velocity shows in the derivative.
    let mut other = robot.clone();
    let stribeck = other.rows[1].stribeck.as_mut().expect("sticky");
    stribeck.velocity = arms::decimal(0.02);
    for function in differentiated {
        assert!(prove(&other, function, &derive(&robot, function)).is_err());
    }
}

/// The spring of a joint is part of the proof; the spring of a locked joint is not.
#[test]
fn a_program_of_another_spring_is_refused() {
    let robot = arms::robot("two_link_saha");
    for row in 0..2 {
        let mut sprung = robot.clone();
        sprung.rows[row].spring = Some(Spring {
            stiffness: arms::decimal(3.0),
            rest: arms::decimal(0.5),
        });
        for function in [Function::PotentialEnergy, Function::InverseDynamics] {
            let program = derive(&sprung, function);
            assert_eq!(prove(&sprung, function, &program), Ok(()));
            assert!(prove(&robot, function, &program).is_err());
            let mut other = sprung.clone();
            other.rows[row].spring.as_mut().expect("a spring").rest = arms::decimal(0.6);
            assert!(prove(&other, function, &program).is_err());
        }
        let gravity = derive(&robot, Function::GravityVector);
        assert_eq!(prove(&sprung, Function::GravityVector, &gravity), Ok(()));
        if row == 1 {
            let [mut robot, mut sprung] = [robot.clone(), sprung];
            robot.rows[1].locked = Some(arms::decimal(0.25));
            sprung.rows[1].locked = Some(arms::decimal(0.25));
            let program = derive(&robot, Function::PotentialEnergy);
            let proof = prove(&sprung, Function::PotentialEnergy, &program);
            assert_eq!(proof, Ok(()));
        }
    }
}

/// Base and tool are part of what is proven: every operation that they make.
#[test]
fn every_damage_to_an_arm_with_base_and_tool_is_found() {
    let mut mounted = Tables::new(11, Bodies::Any);
    let mut count = 0;
    for _ in 0..12 {
        let robot = mounted.mounted_robot();
        for function in [
            Function::GravityVector,
            Function::PotentialEnergy,
            Function::ForwardKinematics,
            Function::Jacobian,
            Function::InverseDynamics,
        ] {
            let program = derive(&robot, function);
            let refused = refused(&robot, function, &program);
            assert!(refused >= program.instructions.len());
            count += refused;
        }
    }
    assert!(count > 3_000, "only {count} damages were made");
}

/// Operations that couplings make, and the couplings themselves: a wrong factor, a wrong offset, a follower
/// without its friction, its motor or its spring.
#[test]
fn every_damage_to_an_arm_with_followers_is_found() {
    let mut count = 0;
    for factor in [[-1, 1], [2, 1], [7, 3]] {
        let robot = coupled(Rational::from_parts(
            factor[0].into(),
            (factor[1] as u32).into(),
        ));
        for function in [
            Function::MassMatrix,
            Function::CoriolisVector,
            Function::InverseDynamics,
            Function::InverseDynamicsDerivatives,
            Function::Jacobian,
        ] {
            let program = derive(&robot, function);
            count += refused(&robot, function, &program);
        }
        let change = |change: fn(&mut Row)| {
            let mut other = robot.clone();
            change(&mut other.rows[2]);
            other
        };
        let other_factor = change(|row| {
            let coupling = row.follows.as_mut().expect("a follower");
            coupling.factor = coupling.factor.clone() + arms::decimal(0.001);
        });
        let other_offset = change(|row| {
            let coupling = row.follows.as_mut().expect("a follower");
            coupling.offset = coupling.offset.clone() + arms::decimal(0.001);
        });
        for (other, functions) in [
            (&other_factor, &Function::ALL[..]),
            (&other_offset, &[Function::SpringVector]),
        ] {
            for &function in functions {
                // These read the sine of the follower's own angle, which is a symbol whatever its factor is.
                let reads_angle = [Function::ForwardKinematics, Function::CenterOfMass];
                if reads_angle.contains(&function) {
                    continue;
                }
                // The links up to the follower do not depend on it.
                let of_links = [Function::LinkPoses, Function::LinkJacobians];
                let is_told = !of_links.contains(&function);
                let program = derive(other, function);
                assert_eq!(
                    prove(&robot, function, &program).is_err(),
                    is_told,
                    "{}",
                    function.name()
                );
            }
        }
        let without = [
            change(|row| row.viscous = Value::zero()),
            change(|row| row.coulomb = [(); 2].map(|()| Value::zero())),
            change(|row| row.motor_inertia = Value::zero()),
            change(|row| row.spring = None),
            change(|row| row.follows = None),
        ];
        for other in without {
            let program = derive(&other, Function::InverseDynamics);
            assert!(prove(&robot, Function::InverseDynamics, &program).is_err());
        }
    }
    assert!(count > 1_000, "only {count} damages were made");
}

/// Three joints, the last of which follows the second.
fn coupled(factor: Rational) -> Robot {
    let mut robot = arms::robot("elbow_3r");
    let row = &mut robot.rows[2];
    row.follows = Some(Coupling {
        leader: 1,
        factor: Value::Rational(factor),
        offset: arms::decimal(0.3),
    });
    row.viscous = arms::decimal(0.7);
    row.coulomb = [0.4, 0.5].map(arms::decimal);
    row.motor_inertia = arms::decimal(0.01);
    row.gear_ratio = Value::integer(3);
    row.spring = Some(Spring {
        stiffness: Value::integer(5),
        rest: arms::decimal(0.2),
    });
    robot
}

/// Every operation of base parameters that are formulas over masses and inertias.
#[test]
fn every_damage_to_symbolic_base_parameters_is_found() {
    let function = Function::BaseParameters;
    for name in ["elbow_3r", "generic_chain_n3"] {
        let robot = arms::with_inertial_fields(name);
        let sound = derive(&robot, function);
        let mut proof = Proof::new(&robot, &[function.into()], &sound);
        assert_eq!(proof.holds(&sound), Ok(()));
        assert!(sound.instructions.len() > 50, "{name}");
        for index in 0..sound.instructions.len() {
            for damage in DAMAGES {
                let mut program = sound.clone();
                damage(&mut program, index);
                if program.instructions[index] != sound.instructions[index] {
                    let refused = proof.holds(&program);
                    assert!(refused.is_err(), "{name}: operation {index}");
                }
            }
        }
    }
}

/// Base parameters of a table of numbers are constants without a single operation.
#[test]
fn every_damage_to_a_base_parameter_is_found() {
    for name in ["puma560", "panda", "scara"] {
        let robot = arms::robot(name);
        let sound = derive(&robot, Function::BaseParameters);
        let mut proof = Proof::new(&robot, &[Function::BaseParameters.into()], &sound);
        for index in 0..sound.outputs.len() {
            let mut program = sound.clone();
            let Operand::Constant(id) = program.outputs[index].operand else {
                panic!("a number")
            };
            let exact = program.constants.get(id).clone();
            let damaged = match exact {
                Constant::Rational(x) if x.is_zero() => {
                    Constant::Rational(Rational::ONE / Rational::from(10).pow(20))
                }
                _ => Constant::Neg(id),
            };
            program.outputs[index].operand = Operand::Constant(program.constants.push(damaged));
            let failure = proof.holds(&program);
            let cause = failure.expect_err("damaged").cause;
            assert_eq!(cause, Cause::Output(index), "{name}");
        }
    }
}

#[test]
fn a_program_of_another_function_is_refused() {
    let robot = arms::robot("elbow_3r");
    let gravity = derive(&robot, Function::GravityVector);
    assert!(prove(&robot, Function::CoriolisVector, &gravity).is_err());
    assert!(prove(&robot, Function::MassMatrix, &gravity).is_err());
}

#[test]
fn a_program_of_another_robot_is_refused() {
    let robot = arms::robot("elbow_3r");
    let mut other = robot.clone();
    other.rows[2].com[0] = arms::decimal(0.123);
    for function in [
        Function::MassMatrix,
        Function::GravityVector,
        Function::InverseDynamics,
    ] {
        assert!(prove(&other, function, &derive(&robot, function)).is_err());
    }
}
