use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub struct Arm { g: f64 }
    Convention: standard,
    gravty: [0, 0, -g],
    joint: [joint: revolute { mass: 1 }],
    function: [mass_matrix],
}

fn main() {
    let arm = Arm { g: 9.81 };
    let _ = arm.mass_matrix(&robot_dynamics::nalgebra::SVector::<f64, 1>::zeros());
}
