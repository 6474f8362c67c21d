use robot_dynamics::nalgebra::Vector6;
use robot_dynamics::{Simulation, robot_dynamics};

robot_dynamics! {
    struct Cart;
    convention: modified,
    gravity: [0, -9.81, 0],
    joints: [rail: prismatic { mass: 2 }],
}

fn main() {
    let _ = Simulation::new(&Cart).tool_force(|_, _, _| Vector6::zeros());
}
