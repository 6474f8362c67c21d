//! The lengths of programs: a snapshot, and the bounds that the project promises.
//!
//! Counted are multiplications, additions and divisions of the emitted code;
//! sines and cosines of the joint angles apart, friction left out.

use crate::derive;
use crate::without_friction;
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Function, Operations};
use expect_test::expect_file;

fn operations(robot: &Robot, function: Function) -> Operations {
    derive(robot, function).operations()
}

#[test]
fn snapshot_of_all_robots() {
    let mut table = String::from(
        "robot                       function                        mul    add   div  total  sin_cos\n",
    );
    for name in arms::NAMES {
        let robot = without_friction(name);
        for function in Function::default_set(false) {
            let count = operations(&robot, function);
            table += &format!(
                "{name:27} {:28} {:6} {:6} {:5} {:6} {:8}\n",
                function.name(),
                count.multiplications,
                count.additions,
                count.divisions,
                count.total(),
                count.sin_cos,
            );
        }
    }
    expect_file!["../golden/counts.txt"].assert_eq(&table);
}

/// Columns and lengths of the regressors.
#[test]
fn snapshot_of_the_regressors() {
    let mut table =
        String::from("robot                       parameters    mul    add  total  sin_cos\n");
    for name in arms::NAMES {
        let robot = arms::robot(name);
        let program = derive(&robot, Function::Regressor);
        let count = program.operations();
        table += &format!(
            "{name:27} {:10} {:6} {:6} {:6} {:8}\n",
            program.outputs.len() / robot.rows.len(),
            count.multiplications,
            count.additions,
            count.total(),
            count.sin_cos,
        );
    }
    expect_file!["../golden/regressors.txt"].assert_eq(&table);
}

/// Programs that are derived on request are long: some robots have to do.
#[test]
fn snapshot_of_derivatives() {
    let mut table = String::from(
        "robot              function                               mul    add   div  total  sin_cos\n",
    );
    let robots = BOUNDS.map(|(name, _)| name);
    for name in robots.into_iter().chain(["scara", "generic_chain_n7"]) {
        let robot = without_friction(name);
        for function in [
            Function::CoriolisMatrix,
            Function::InverseDynamicsDerivatives,
            Function::ForwardDynamicsDerivatives,
            Function::InverseDynamicsSecondDerivatives,
        ] {
            let count = operations(&robot, function);
            table += &format!(
                "{name:18} {:35} {:6} {:6} {:5} {:6} {:8}\n",
                function.name(),
                count.multiplications,
                count.additions,
                count.divisions,
                count.total(),
                count.sin_cos,
            );
        }
    }
    expect_file!["../golden/derivatives.txt"].assert_eq(&table);
}

/// N^3 values from the recursion of the N^2 first ones: what is added grows with the cube too.
#[test]
fn second_derivatives_beside_the_first_ones() {
    for (name, most) in [("two_link_saha", 1.1), ("puma560", 2.2), ("panda", 3.8)] {
        let robot = without_friction(name);
        let of = |function| f64::from(operations(&robot, function).total());
        let second = of(Function::InverseDynamicsSecondDerivatives);
        let ratio = second / of(Function::InverseDynamicsDerivatives);
        assert!(
            ratio <= most,
            "{name}: {ratio:.3} times the first derivatives"
        );
    }
}

/// The shortest programs known from other generators and trials: tau, V, M, G.
const BOUNDS: [(&str, [u32; 4]); 6] = [
    ("two_link_saha", [24, 6, 3, 7]),
    ("elbow_3r", [150, 105, 45, 14]),
    ("stanford", [250, 220, 125, 24]),
    ("puma560", [295, 250, 165, 24]),
    ("ur5", [250, 220, 100, 14]),
    ("panda", [580, 555, 425, 90]),
];

#[test]
fn programs_are_shorter_than_any_other_generator_s() {
    let functions = [
        Function::InverseDynamics,
        Function::CoriolisVector,
        Function::MassMatrix,
        Function::GravityVector,
    ];
    for (name, bounds) in BOUNDS {
        let robot = without_friction(name);
        for (function, bound) in functions.into_iter().zip(bounds) {
            let total = operations(&robot, function).total();
            assert!(
                total <= bound,
                "{name} {}: {total} > {bound}",
                function.name()
            );
        }
    }
}
