//! The two forms of forward dynamics: the mass matrix factored, and articulated bodies.

use crate::derive;
use crate::without_friction;
use arms::generic_chain;
use dynamics_symbolic::Function;
use dynamics_symbolic::derive::derive_form;
use dynamics_symbolic::derive::functions::Form;
use dynamics_symbolic::program::Program;
use dynamics_symbolic::prove::prove;
use dynamics_symbolic::robot::Robot;
use expect_test::expect_file;

const ARMS: [&str; 6] = [
    "two_link_saha",
    "elbow_3r",
    "stanford",
    "puma560",
    "ur5",
    "panda",
];

/// From so many joints on, articulated bodies take fewer operations for a generic chain.
const CROSSOVER: usize = 12;

fn program(robot: &Robot, form: Form) -> Program {
    derive_form(robot, Function::ForwardDynamics, form)
}

/// Prismatic joints, reflected inertias, friction and mass matrices that are identically singular
/// are among the robots.
#[test]
fn articulated_bodies_are_proven_for_every_robot() {
    for name in arms::NAMES {
        let robot = arms::robot(name);
        let program = program(&robot, Form::Articulated);
        let proof = prove(&robot, Function::ForwardDynamics, &program);
        assert_eq!(proof, Ok(()), "{name}");
    }
}

#[test]
fn articulated_bodies_with_reflected_inertias_are_proven() {
    let mut robot = generic_chain(9);
    for row in &mut robot.rows {
        row.motor_inertia = row.mass.clone();
    }
    let program = program(&robot, Form::Articulated);
    assert_eq!(prove(&robot, Function::ForwardDynamics, &program), Ok(()));
}

/// Operations without sines and cosines, friction left out, M's diagonal included in both; and
/// the one that is chosen.
#[test]
fn the_shorter_form_is_chosen() {
    let arms = ARMS.map(without_friction).into_iter();
    let table = compared(arms.chain((1..=14).map(generic_chain)));
    expect_file!["../golden/forward_dynamics.txt"].assert_eq(&table);
}

/// `cargo test -p dynamics-symbolic --test suite forward_dynamics:: -- --ignored`
#[test]
#[ignore = "takes ten seconds: .ci/run runs it"]
fn the_shorter_form_is_chosen_for_long_chains() {
    let table = compared((15..=30).map(generic_chain));
    expect_file!["../golden/forward_dynamics_of_long_chains.txt"].assert_eq(&table);
}

fn compared(robots: impl Iterator<Item = Robot>) -> String {
    let mut table = String::from(
        "                          factored M           articulated bodies\n\
         robot                mul    add  total     mul    add  total\n",
    );
    for robot in robots {
        let counts =
            [Form::Recursive, Form::Articulated].map(|form| program(&robot, form).operations());
        let chosen = derive(&robot, Function::ForwardDynamics).operations();
        let least = counts[0].total().min(counts[1].total());
        assert_eq!(chosen.total(), least, "{}", robot.name);
        table += &format!("{:18}", robot.name);
        for count in counts {
            let (mul, add) = (count.multiplications + count.divisions, count.additions);
            table += &format!("{mul:6} {add:6} {:6}  ", count.total());
        }
        table = table.trim_end().to_owned() + "\n";
        let is_chain = robot.name.starts_with("generic_chain");
        if is_chain && robot.rows.len() >= 4 {
            let articulated = counts[1].total() < counts[0].total();
            assert_eq!(articulated, robot.rows.len() >= CROSSOVER, "{}", robot.name);
        }
    }
    table
}
