//! Closed forms of inverse kinematics: which arms have one, and that its proof refuses damage.

use std::fmt::Write;

use dynamics_symbolic::inverse::{Plan, plan};
use dynamics_symbolic::prove::prove_inverse;
use dynamics_symbolic::robot::Robot;

fn proven(robot: &Robot) -> Result<Plan, dynamics_symbolic::inverse::Unsolved> {
    plan(robot, None, &|plan| prove_inverse(robot, None, plan))
}

#[test]
fn plans_of_the_data_files() {
    let mut text = String::new();
    for name in arms::NAMES {
        let start = std::time::Instant::now();
        let robot = arms::robot(name);
        match proven(&robot) {
            Ok(plan) => {
                write!(
                    text,
                    "{name}: {} {:?}",
                    plan.branches(),
                    plan.program.operations()
                )
                .unwrap();
                for step in &plan.steps {
                    write!(text, " {:?} {:?}", step.solved, step.rule).unwrap();
                }
                writeln!(text).unwrap();
            }
            Err(why) => writeln!(text, "{name}: {why}").unwrap(),
        }
        writeln!(text, "   {:?}", start.elapsed()).unwrap();
    }
    println!("{text}");
}
