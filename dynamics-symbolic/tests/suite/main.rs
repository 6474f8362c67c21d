//! The tests of the engine that need no insight into its modules: one program, so that the optimised engine
//! is linked once and both cores stay busy until the last test.

mod base_parameters;
mod chains;
mod counts;
mod damage;
mod definite;
mod emission;
mod forward_dynamics;
mod frames;
mod functions;
mod fused;
mod invariances;
mod neglect;
mod proof;
mod random_tables;
mod residuals;
mod rounding;
mod second_set;
mod textbook;
mod textbook_programs;
mod units;

use dynamics_symbolic::robot::{Robot, Value};

/// A robot of the data files whose joints have no friction.
fn without_friction(name: &str) -> Robot {
    let mut robot = arms::robot(name);
    for row in &mut robot.rows {
        row.viscous = Value::zero();
        row.coulomb = [(); 2].map(|()| Value::zero());
    }
    robot
}
