use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub struct Arm { mass: f32, length: Vec<f64>, g: f64 }
    convention: standard,
    gravity: [0, 0, -g],
    joints: [joint: revolute { mass: mass, com: [length, 0, 0] }],
}

fn main() {
    let arm = Arm { mass: 1.0_f32, length: 1.0, g: 9.81 };
    let copy = arm;
    assert_eq!(arm, copy);
}
