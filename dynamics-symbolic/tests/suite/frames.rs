//! Bases and tools beside arms that say the same without them.

use crate::derive;
use arms::{decimal, robot};
use dynamics_symbolic::Function;
use dynamics_symbolic::program::Program;
use dynamics_symbolic::prove::prove;
use dynamics_symbolic::robot::{Base, Body, Placement, Robot, Tool, Value};

/// Revolute and prismatic joints.
const ARMS: [&str; 3] = ["stanford", "scara", "two_link_craig"];

fn placement(xyz: [f64; 3], rpy: [f64; 3]) -> Placement {
    Placement {
        xyz: xyz.map(decimal),
        rpy: rpy.map(decimal),
    }
}

/// A tool of that mass, its tensor in proportion to it.
fn tool(mass: Value) -> Tool {
    let entries = [0.02, 0.03, 0.025, 0.001, -0.002, 0.003];
    Tool {
        placement: placement([0.1, -0.02, 0.3], [0.4, 0.0, -1.1]),
        body: Body {
            com: [0.01, 0.02, 0.05].map(decimal),
            inertia: entries.map(|entry| mass.clone() * decimal(entry)),
            mass,
        },
    }
}

/// The place of the base of an arm that has one.
fn base(arm: &mut Robot) -> &mut Placement {
    match &mut arm.base {
        Some(Base::Standing(base)) => base,
        _ => panic!("a base that stands"),
    }
}

fn is_about_the_tip(function: Function) -> bool {
    [
        Function::ForwardKinematics,
        Function::Jacobian,
        Function::WrenchTorques,
        Function::ToolVelocity,
        Function::ToolAcceleration,
        Function::JacobianRate,
        Function::OperationalInertiaInverse,
    ]
    .contains(&function)
}

/// As it is written, operation by operation.
fn text(program: &Program) -> String {
    format!("{program:?}")
}

/// A tool without a body is none to every function but those of the tip.
#[test]
fn a_massless_tool_leaves_every_program_as_it_is() {
    for name in ARMS {
        let plain = robot(name);
        let mut with_tool = plain.clone();
        with_tool.tool = Some(tool(Value::zero()));
        for function in Function::ALL {
            let (expected, found) = (derive(&plain, function), derive(&with_tool, function));
            let is_same = text(&expected) == text(&found);
            assert_eq!(is_same, !is_about_the_tip(function), "{name} {function:?}");
        }
    }
}

/// Where the world is that of the base frame, and the tip the last link frame, in other words.
#[test]
fn a_base_and_a_tool_at_no_distance_leave_every_program_as_it_is() {
    for name in ARMS {
        let plain = robot(name);
        let mut placed = plain.clone();
        placed.base = Some(Base::Standing(placement([0.0; 3], [0.0; 3])));
        placed.tool = Some(Tool {
            placement: placement([0.0; 3], [0.0; 3]),
            ..tool(Value::zero())
        });
        for function in Function::ALL {
            let (expected, found) = (derive(&plain, function), derive(&placed, function));
            assert_eq!(text(&expected), text(&found), "{name} {function:?}");
        }
    }
}

/// Functions that do not depend on the arm's place do not depend on its base's place.
#[test]
fn a_placed_base_leaves_inertia_and_coriolis_terms_as_they_are() {
    for name in ARMS {
        let plain = robot(name);
        let mut placed = plain.clone();
        placed.base = Some(Base::Standing(placement([1.0, 2.0, 3.0], [0.3, -0.4, 0.5])));
        for function in [
            Function::MassMatrix,
            Function::CoriolisVector,
            Function::CoriolisMatrix,
            Function::KineticEnergy,
        ] {
            let (expected, found) = (derive(&plain, function), derive(&placed, function));
            let counts = [expected.operations().total(), found.operations().total()];
            assert_eq!(counts[0], counts[1], "{name} {function:?}");
        }
    }
}

/// Turned by right angles, a base is no longer than gravity along another axis.
#[test]
fn a_wall_costs_no_operation() {
    for name in ARMS {
        let mut by_hand = robot(name);
        let mut on_wall = by_hand.clone();
        let strength = decimal(9.81);
        let zero = Value::zero;
        on_wall.gravity = [zero(), zero(), -strength.clone()];
        on_wall.base = Some(Base::Standing(Placement {
            xyz: [(); 3].map(|()| zero()),
            rpy: [zero(), Value::Pi * decimal(0.5), zero()],
        }));
        by_hand.gravity = [strength, zero(), zero()];
        for function in [Function::GravityVector, Function::InverseDynamics] {
            let (expected, found) = (derive(&by_hand, function), derive(&on_wall, function));
            assert_eq!(prove(&on_wall, function, &found), Ok(()));
            assert_eq!(
                prove(&by_hand, function, &found),
                Ok(()),
                "{name} {function:?}"
            );
            let counts = [expected.operations().total(), found.operations().total()];
            assert!(counts[1] <= counts[0], "{name} {function:?} {counts:?}");
        }
    }
}

/// The program of an arm is refused for one with another base or tool.
#[test]
fn a_program_of_another_base_or_tool_is_refused() {
    let mut arm = robot("elbow_3r");
    arm.base = Some(Base::Standing(placement([0.1, 0.0, 0.8], [0.3, -0.4, 0.5])));
    arm.tool = Some(tool(decimal(2.0)));
    type Change = fn(&mut Robot);
    let of_tool: [Change; 4] = [
        |arm| arm.tool.as_mut().expect("a tool").body.mass = decimal(2.001),
        |arm| arm.tool.as_mut().expect("a tool").body.com[1] = decimal(0.021),
        |arm| arm.tool.as_mut().expect("a tool").placement.xyz[0] = decimal(0.101),
        |arm| arm.tool.as_mut().expect("a tool").placement.rpy[2] = decimal(-1.2),
    ];
    let of_base: [Change; 2] = [
        |arm| base(arm).rpy[0] = decimal(0.31),
        |arm| base(arm).xyz[2] = decimal(0.81),
    ];
    let refused = |change: Change, functions: &[Function]| {
        let mut other = arm.clone();
        change(&mut other);
        for &function in functions {
            let program = derive(&arm, function);
            assert_eq!(prove(&arm, function, &program), Ok(()));
            assert!(prove(&other, function, &program).is_err(), "{function:?}");
        }
    };
    for change in of_tool {
        refused(
            change,
            &[Function::InverseDynamics, Function::PotentialEnergy],
        );
    }
    for change in of_base {
        let functions = [
            Function::PotentialEnergy,
            Function::ForwardKinematics,
            Function::LinkPoses,
        ];
        refused(change, &functions);
    }
}

/// A symbolic load: what it adds is linear in it, so that nothing is divided.
#[test]
fn a_load_is_a_parameter() {
    let plain = robot("puma560");
    let mut loaded = plain.clone();
    loaded.fields = vec!["load".to_owned()];
    loaded.tool = Some(tool(Value::field(0)));
    for function in [
        Function::MassMatrix,
        Function::InverseDynamics,
        Function::GravityVector,
    ] {
        let program = derive(&loaded, function);
        assert_eq!(prove(&loaded, function, &program), Ok(()));
        let (with, without) = (program.operations(), derive(&plain, function).operations());
        println!("{}: {without} without a load, {with} with", function.name());
        assert_eq!(with.divisions, 0);
    }
}
