//! The tests of the engine that need no insight into its modules: one program, so that the optimised engine
//! is linked once and both cores stay busy until the last test.

mod base_parameters;
mod bounds;
mod centroidal;
mod chains;
mod counts;
mod coupled_parameters;
mod damage;
mod definite;
mod degrees;
mod emission;
mod floating;
mod formulas;
mod forward_dynamics;
mod frame_functions;
mod frames;
mod functions;
mod fused;
mod invariances;
mod inverse;
mod mounts;
mod neglect;
mod proof;
mod random_tables;
mod residuals;
mod rounding;
mod second_set;
mod textbook;
mod trees;
mod units;

use std::collections::HashMap;
use std::sync::{Arc, LazyLock, Mutex, OnceLock};

use dynamics_symbolic::Function;
use dynamics_symbolic::program::Program;
use dynamics_symbolic::robot::{Robot, Value};

/// The program of a function, derived once in this process: many tests read those of the same arms.
fn derive(robot: &Robot, function: Function) -> Arc<Program> {
    type Programs = HashMap<String, Arc<OnceLock<Arc<Program>>>>;
    static PROGRAMS: LazyLock<Mutex<Programs>> = LazyLock::new(Mutex::default);
    let key = format!("{function:?} of {robot:?}");
    let program = {
        let mut programs = PROGRAMS.lock().expect("no test failed in here");
        programs.entry(key).or_default().clone()
    };
    let derived = || Arc::new(dynamics_symbolic::derive::derive(robot, function));
    program.get_or_init(derived).clone()
}

/// A robot of the data files whose joints have no friction.
fn without_friction(name: &str) -> Robot {
    let mut robot = arms::robot(name);
    for row in &mut robot.rows {
        row.viscous = Value::zero();
        row.coulomb = [(); 2].map(|()| Value::zero());
    }
    robot
}
