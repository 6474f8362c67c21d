//! The lengths of the functions that controllers ask for, beside what a user would write without them.
//!
//! Counted are multiplications, additions and divisions of the emitted code, the tables as they are,
//! friction included.

use std::fmt::Write;

use crate::derive;
use dynamics_symbolic::Function;
use expect_test::expect_file;

const ROBOTS: [&str; 6] = [
    "puma560",
    "panda",
    "stanford",
    "ur5",
    "scara",
    "generic_chain_n3",
];

fn length(robot: &str, function: Function) -> f64 {
    let program = derive(&arms::robot(robot), function);
    f64::from(program.operations().total())
}

/// A product of a matrix and a vector takes so many operations.
fn product(rows: usize, columns: usize) -> f64 {
    (rows * (2 * columns - 1)) as f64
}

/// Operations of the same function, written by a user with the other functions.
fn without(robot: &str, function: Function) -> Option<f64> {
    let n = arms::robot(robot).dof();
    let of = |function| length(robot, function);
    Some(match function {
        Function::WrenchTorques => of(Function::Jacobian) + product(n, 6),
        Function::ToolVelocity => of(Function::Jacobian) + product(6, n),
        Function::ToolAcceleration => {
            of(Function::Jacobian) + of(Function::JacobianRate) + 2.0 * product(6, n) + 6.0
        }
        Function::GeneralizedMomentum => of(Function::MassMatrix) + product(n, n),
        // C' qd - G - F.
        Function::MomentumBias => {
            of(Function::CoriolisMatrix)
                + product(n, n)
                + of(Function::GravityVector)
                + of(Function::FrictionVector)
                + 2.0 * n as f64
        }
        // M qdd_r + C qd_r + G + F.
        Function::PassivityTorque => {
            of(Function::MassMatrix)
                + of(Function::CoriolisMatrix)
                + 2.0 * product(n, n)
                + of(Function::GravityVector)
                + of(Function::FrictionVector)
                + 3.0 * n as f64
        }
        _ => return None,
    })
}

/// `UPDATE_EXPECT=1` writes the table anew.
#[test]
fn snapshot_and_shorter_than_what_a_user_would_write() {
    let first = Function::WrenchTorques as usize;
    let mut table = String::from(
        "robot              function                        mul    add   div  total  without  ratio\n",
    );
    for robot in ROBOTS {
        let functions = Function::ALL.into_iter().filter(|f| *f as usize >= first);
        // Second derivatives stand beside the first ones, in `derivatives.txt`.
        let functions = functions.filter(|f| *f != Function::InverseDynamicsSecondDerivatives);
        for function in functions {
            let count = derive(&arms::robot(robot), function).operations();
            let other = without(robot, function);
            let ratio = other.map(|other| f64::from(count.total()) / other);
            let shown = |x: Option<f64>, digits: usize| {
                x.map_or(String::new(), |x| format!("{x:.digits$}"))
            };
            writeln!(
                table,
                "{robot:18} {:28} {:6} {:6} {:5} {:6} {:>8} {:>6}",
                function.name(),
                count.multiplications,
                count.additions,
                count.divisions,
                count.total(),
                shown(other, 0),
                shown(ratio, 2),
            )
            .expect("a string takes it");
            assert!(
                ratio.is_none_or(|ratio| ratio < 1.0),
                "{robot} {}: {ratio:?} of what a user would write",
                function.name()
            );
        }
    }
    println!("{table}");
    expect_file!["../golden/second_set.txt"].assert_eq(&table);
}

/// Beside the recursion that each is a variation of: the passivity torque is Newton-Euler with a second
/// velocity, the momentum bias takes no accelerations.
#[test]
fn lengths_beside_the_recursions() {
    // The PUMA's Jacobian takes 61 operations, for its wrist moves no point of its tip.
    for (robot, of_jacobian) in [("puma560", 0.91), ("panda", 0.7)] {
        let ratio = |a, b| length(robot, a) / length(robot, b);
        let torque = ratio(Function::PassivityTorque, Function::InverseDynamics);
        let bias = ratio(Function::MomentumBias, Function::CoriolisVector);
        let wrench = ratio(Function::WrenchTorques, Function::Jacobian);
        println!(
            "{robot}: passivity {torque:.3} of tau, bias {bias:.3} of V, J' w {wrench:.3} of J"
        );
        assert!(
            torque <= 1.15 && bias <= 1.15 && wrench <= of_jacobian,
            "{robot}"
        );
    }
}
